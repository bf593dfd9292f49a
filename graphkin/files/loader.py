"""From a mechanism file to a `Mechanism`: read, check the tables, draw up the links, then the pairs between them.

And back: a `Mechanism` that is read has its file, which can be given other values, or written out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import IO, TYPE_CHECKING

from graphkin.errors import Lang, NotAMechanism, Where, WrongType
from graphkin.files.draft import Draft, check_joints, check_questions, check_sizes
from graphkin.files.source import Deferred, decoded_text, mechanism_name, read_bytes, read_text, read_toml
from graphkin.files.toml import Document
from graphkin.model import mechanism
from graphkin.model.quantities.reading import spelled_out

if TYPE_CHECKING:
    from graphkin.files.builder import Builder
    from graphkin.files.schema import Titles
    from graphkin.files.variants import Variants


class MechanismFile(mechanism.Mechanism):
    """A planar mechanism as its file describes it: links, pairs, drivers, in SI units and without a position.

    `graphkin.load`, `loads` and `from_dict` give one, and `Mechanism.new()` builds one. It never changes: `with_` gives
    another. `links`, `pairs`, `drivers`, `points`, `ask`, `title` tell what it is, `text` is its file.

    >>> import graphkin
    >>> graphkin.load("ex3-1")
    <Mechanism ex3-1: links 4 1 2 3, points A D B C, driver AB>
    """

    def with_(self, values: Mapping[str, object] | None = None, /, **more: object) -> MechanismFile:
        """The mechanism with other numbers in its file, in mm, deg, rad/s as there, or texts with a unit.

        AB            length AB of the link that has it; `BDE` an angle of a link
        A, C          coordinates (x, y): of a point of the frame or of a `shape`, else where it is sketched
        "omega AB"    a driver's `angle`, `omega`, `alpha`, `at`, `velocity`, `acceleration`; of the only one `omega`
        "angle ram"   of a slide that has a name; `tilt`, `radius` likewise
        links.2.AB, slide.0.angle, gear.1.radii, frame.A, sketch.C, scales.length     any value, by its place

        The text stays in step, with comments and layout, so that a sheet drawn of it passes `check`. The sketch still
        picks the assembly: after a large change give the sketched points new places. Raises NoSuchValue for a name that
        means nothing or two things, and what reading a file raises for values that do not fit.

        >>> import graphkin
        >>> longer = graphkin.load("ex3-1").with_(AB=30, omega=20)
        >>> abs(longer.links["1"].arm("A", "B")), longer.drivers[0].rate
        (0.03, 20.0)
        >>> graphkin.load("ex3-1").with_({"omega AB": "95 rpm", "slide.0.angle": 95}, D=(80, 0)).links["frame"].points
        {'A': 0j, 'D': (0.08+0j)}
        """
        from graphkin.files.builder import changed_text

        return loads(changed_text(self, _named(values, more)), name=self.name, file=self.file)

    def variants(self, values: Mapping[str, object] | None = None, /, **more: object) -> Variants[MechanismFile]:
        """Many mechanisms with other numbers in their file, named as in `with_`: arrays (n,), of coordinates
        (x, y) with arrays in them, or arrays (n, 2); one value is for all of them.

        `variants[k]` is what `with_` gives of the k-th values. `replay`, `motion`, `sweep`, `sweep_many` and
        `solve_many` take them all at once. Raises UnevenArrays, and NoSuchValue as `with_` does.

        >>> import graphkin
        >>> import numpy as np
        >>> inexact = graphkin.load("ex3-1").variants(AB=np.linspace(23.9, 24.1, 1000), omega=10)
        >>> found = graphkin.replay(inexact)
        >>> round(float(found.omega["3"].std()), 4), found["a_k B3B2"][:2].magnitude.round(3), len(found.refused)
        (0.009, array([2.493, 2.493]), 0)
        """
        from graphkin.files.builder import places_of
        from graphkin.files.variants import Variants

        return Variants.of(self, places_of(self, _named(values, more)), loads)

    def to_toml(self) -> str:
        """The mechanism's file: what `graphkin.loads` reads, and `graphkin draw` draws.

        >>> import graphkin
        >>> mechanism = graphkin.load("ex3-1")
        >>> graphkin.loads(mechanism.to_toml(), name="ex3-1").links == mechanism.links
        True
        """
        return self.text

    @staticmethod
    def new(name: str = "mechanism", **title: str) -> Builder[MechanismFile]:
        """A mechanism to be built step by step; `en="..", zh=".."` are its titles. See `Builder`."""
        from graphkin.files.builder import Builder

        return Builder(name, {"title": title} if title else {}, from_dict)

    def __repr__(self) -> str:
        links = " ".join(map(self.called, self.links))
        drivers = ", ".join(driver.name for driver in self.drivers) or "none"
        return f"<Mechanism {self.name}: links {links}, points {' '.join(self.points)}, driver {drivers}>"


def load(source: str | Path) -> MechanismFile:
    """The mechanism a file describes.

    Raises a `GraphkinError`: the one thing that is wrong, or `Several` with all of them in the order of the lines.
    """
    path = Path(source)
    return loads(read_text(path), name=mechanism_name(path), file=str(path))


def loads(text: str, *, name: str = "mechanism", file: str = "<text>") -> MechanismFile:
    """The mechanism a text describes; `name` and `file` are what messages and drawings call it."""
    if not isinstance(text, str):
        raise NotAMechanism(Where("text"), type(text).__name__)
    document, lines = read_toml(text, file)
    draft = Draft(file, lines)
    return _drawn_up(draft, document, name, text)


def from_dict(document: Mapping[str, object], *, name: str = "mechanism") -> MechanismFile:
    """The mechanism that data describe: tables and keys as in the file, numbers in its units.

    Numpy's numbers and arrays do, too. Messages give lines of the text that `to_toml` then gives.

    >>> crank = {"frame": {"A": [0, 0]}, "links": {"1": {"AB": 24}}}
    >>> from_dict(crank | {"driver": [{"vector": "AB", "angle": 60, "omega": 10}]}).points
    ('A', 'B')
    """
    from graphkin.files.toml import toml

    if not isinstance(document, Mapping):
        raise NotAMechanism(Where("document"), type(document).__name__)
    return loads(toml(document), name=name, file=f"<{name}>")


def load_stream(stream: IO[bytes], *, name: str, file: str) -> MechanismFile:
    """The mechanism that comes in through a pipe."""
    return loads(decoded_text(read_bytes(stream, file), file), name=name, file=file)


def _drawn_up(draft: Draft, document: Document, name: str, text: str) -> MechanismFile:
    """The tables by themselves, then against each other."""
    from pydantic_core import ValidationError

    from graphkin.files.lines import as_sketched
    from graphkin.files.links import frame_problems, read_links, read_measures
    from graphkin.files.pairs import read_drivers, read_pairs, read_poses
    from graphkin.files.schema import CREDIT, complaints, read_tables, stated_values

    measures, problems = read_measures(document.get("links"), draft.where)
    draft.problems += [*frame_problems(document.get("frame"), draft.where), *problems]
    try:
        file = read_tables(document)
    except ValidationError as error:
        draft.problems.extend(complaints(error, draft.where, draft.lines))
    draft.stop_if_wrong()
    read_links(draft, file, document, measures)
    pairs = read_pairs(draft, file)
    drivers, poses = read_drivers(draft, file.driver, len(file.pose)), read_poses(draft, file.pose)
    check_joints(draft, pairs, len(file.driver))
    check_sizes(draft)
    for point in file.sketch:
        with draft.noting():
            draft.known(point, "sketch", point)
    draft.stop_if_wrong()
    scales = {key: scale for key, scale in vars(file.scales).items() if scale is not None}
    sketch = {point: complex(*place) for point, place in file.sketch.items()}
    pairs = as_sketched(file, draft.links, pairs, (*drivers, *poses), sketch)
    slides = zip((pair.name for pair in pairs if pair.table == "slide"), file.slide, strict=True)
    slide_titles = {name: title for name, table in slides if (title := _titles(table.title))}
    machine = MechanismFile(
        name, draft.frame, draft.links, pairs, drivers, poses, sketch, scales,
        _titles(file.title), _titles(file.source), tuple(file.ask), text, draft.file, draft.lines,
        slide_titles=slide_titles, stories=_titles(file.text), given=Deferred(partial(stated_values, document)),
        worth={**dict.fromkeys(file.ask, 1.0), **file.points.worth}, follows=CREDIT[file.points.follows],
    )  # fmt: skip
    machine = _spelled_out(machine)
    check_questions(draft, machine)
    draft.stop_if_wrong()
    return machine


def _spelled_out(machine: MechanismFile) -> MechanismFile:
    """The mechanism with its questions as quantities are written everywhere."""
    ask = tuple(spelled_out(machine, question) for question in machine.ask)
    worth = {spelled_out(machine, question): points for question, points in machine.worth.items()}
    return machine if ask == machine.ask and worth == machine.worth else replace(machine, ask=ask, worth=worth)


def _named(values: Mapping[str, object] | None, more: Mapping[str, object]) -> dict[str, object]:
    if not isinstance(values or {}, Mapping):
        raise WrongType(Where("values"), "table", type(values).__name__)
    return {**(values or {}), **more}


def _titles(table: Titles) -> dict[Lang, str]:
    titles: dict[Lang, str | None] = {"en": table.en, "zh": table.zh}
    return {lang: title for lang, title in titles.items() if title}
