"""Keys: read from a file, or made of a mechanism at the scales of its sheet; with one for each further position that
the problem asks for, of a mechanism that is drawn there."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from graphkin import api
from graphkin.base.geometry import number
from graphkin.base.scales import finest
from graphkin.base.value import frozen
from graphkin.construction import SCALES, Plot
from graphkin.errors import BadKey, BadPencil, GraphkinError, NoFile, NoKeyAtPosition, NothingToMark, OutOfRange, Where
from graphkin.files import loads
from graphkin.homework import opening
from graphkin.marking import power as powers
from graphkin.marking.answers import asked_of, readable
from graphkin.marking.key import Key, Marking
from graphkin.marking.key_making import allowed_anew, make_key
from graphkin.marking.marker import Marker
from graphkin.marking.tolerances import Tolerances, tolerances
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity
from graphkin.planning import Method
from graphkin.proof.readings import mechanism_at, readings
from graphkin.proof.roads import proved
from graphkin.running import driver_values, replay_all

_LARGEST = 64 << 20
_PAGE = complex(130.0, 97.0)  # of any figure that is drawn as large as a page allows, of every polygon [mm]
_SAME = 1e-6  # values of both mechanisms that differ by a smaller part, of the largest of their kind, are the same


@frozen
class Pencils:
    """The errors of a pencil on paper, and the part of them that is allowed.

    length_mm, angle_deg   standard deviations of a length laid off or read, and of a direction
    sigmas     how many standard deviations are right; relative: a part of the right value instead, where it is not 0
    said       which of these hold for a key that is stored, too, in place of its own
    """

    length_mm: float = 0.25
    angle_deg: float = 0.25
    sigmas: float = 3.0
    relative: float = 0.0
    said: tuple[str, ...] = ()


USUAL = Pencils()


def pencils_of(
    pencil: str | Sequence[float] | None = None, sigmas: float | None = None, relative: float | None = None
) -> Pencils:
    """The errors of a pencil, "MM,DEG" or two numbers, and what is allowed, as far as it is said. Raises BadPencil,
    OutOfRange."""
    said = {name: value for name, value in (("sigmas", sigmas), ("relative", relative)) if value is not None}
    for name, least, most in (("sigmas", 0.1, 100), ("relative", 0, 1)):
        if not least <= said.get(name, least) <= most:
            raise OutOfRange(Where(f"--{name}"), f"{said[name]:g}")
    if pencil is not None:
        try:
            length, angle = map(float, pencil.split(",") if isinstance(pencil, str) else pencil)
        except ValueError:
            raise BadPencil(Where("--pencil"), f"{pencil}") from None
        if not (0 <= length <= 10 and 0 <= angle <= 30 and length + angle > 0):  # one that errs in nothing has no bands
            raise BadPencil(Where("--pencil"), f"{pencil}")
        said |= {"length_mm": length, "angle_deg": angle}
    return Pencils(**said, said=tuple(said))


def tolerance(
    mechanism: api.drawing.Source | Method, pencil: str | Sequence[float] | None = None, sigmas: float | None = None,
    relative: float | None = None, marks: bool = False, *, values: api.drawing.Values = None,
) -> Tolerances:  # fmt: skip
    """The accuracy that paper allows: the construction, drawn many times with a pencil that errs by (mm, deg).

    pencil   0.25 mm and 0.25 deg; sigmas: 3 standard deviations are right; relative: this part of the value instead
    marks    with a key that can mark by it, too; values: of the drivers there [deg, mm]

    >>> [(entry.text, round(entry.tolerance, 2)) for entry in tolerance("ex3-1").entries[:1]]
    [('omega 2', 0.19)]
    """
    method = api.drawing.placed(mechanism, values)
    return tolerances(key_drawn(method, pencils_of(pencil, sigmas, relative), marks=marks), method)


def power(
    mechanism: api.drawing.Source | Method, pencil: str | Sequence[float] | None = None, sigmas: float | None = None,
    relative: float | None = None, *, asked: bool = False, trials: int = 200, values: api.drawing.Values = None,
    key: Key | None = None,
) -> powers.Power:  # fmt: skip
    """Rates at which each mistake is told by the numbers that are handed in: so many students of each are drawn up.

    asked   they hand in what is asked, and nothing on the way; the rest is as `tolerance` has it
    key     where there is one, for marks

    >>> power("ex3-1", trials=20).trials
    20
    """
    if trials < 1:
        raise OutOfRange(Where("--trials"), str(trials))
    method = api.drawing.placed(mechanism, values)
    key = key or key_drawn(method, pencils_of(pencil, sigmas, relative))
    texts = [entry.text for entry in key.entries if entry.points] if asked else None
    return powers.power(Marker(key, method), trials, texts)


def key_from(source: str, pencils: Pencils = USUAL) -> Key:
    """A key.json, or a key made of a mechanism file or a library mechanism. Raises what loading and planning raise,
    BadKey, NothingToMark."""
    path = Path(source)
    return remade(key_file(path), pencils) if path.suffix.lower() == ".json" else key_for(api.load(source), pencils)


def remade(key: Key, pencils: Pencils) -> Key:
    """A stored key by what was said of the pencil and of what is allowed. With another pencil it is drawn up anew from
    its own file, at its own scales; else each tolerance is made anew of the scatter that it has."""
    own = key.marking
    if not pencils.said:
        return key
    sigmas = pencils.sigmas if "sigmas" in pencils.said else own.sigmas
    relative = pencils.relative if {"sigmas", "relative"} & {*pencils.said} else own.relative
    marking = replace(own, sigmas=sigmas, relative=relative)
    mechanism = loads(key.text, name=key.name)
    if "length_mm" in pencils.said:
        lengths: dict[str, float] = {plane: pencils.length_mm * own.scales[scale] for plane, scale in SCALES.items()}
        marking = replace(marking, lengths=lengths, angle=math.radians(pencils.angle_deg))
        method, points = api.plan(mechanism, key.coincident), {entry.text: entry.points for entry in key.entries}
        quantities = [q for text in points if (q := readable(mechanism, text)) is not None]
        made = make_key(method, marking, quantities)
        entries = [replace(entry, points=points.get(entry.text, 0.0)) for entry in made.entries]
        made = replace(made, entries=tuple(entries), text=key.text, title=key.title)
    else:
        made = replace(key, marking=marking, entries=allowed_anew(key.entries, marking, mechanism.usual))
    return replace(made, further=tuple(remade(further, pencils) for further in key.further))


def key_for(mechanism: Mechanism, pencils: Pencils = USUAL, quantities: Sequence[Quantity] = ()) -> Key:
    """The key of a mechanism, which both roads must give, with one for each further position that it asks for, at the
    same scales. Raises NothingToMark, NoKeyAtPosition."""
    method = api.plan(mechanism)
    key = key_drawn(method, pencils, quantities)
    further = (make_key(there, key.marking, quantities) for there in further_methods(method))
    return replace(key, further=tuple(further))


def key_drawn(
    method: Method, pencils: Pencils = USUAL, quantities: Sequence[Quantity] = (), marks: bool = True
) -> Key:
    """The key of the drawn position alone; `marks` as `make_key` has it. Raises NothingToMark."""
    key = make_key(method, marking_of(method, pencils), quantities, marks)
    if not any(entry.points for entry in key.entries):
        raise NothingToMark(method.mechanism.where("ask"))
    return key


def marking_of(method: Method, pencils: Pencils = USUAL, scales: Mapping[str, float] | None = None) -> Marking:
    """A pencil's errors at the scales of the mechanism's sheet, or at others."""
    scales = scales or paper_scales(method, proved(method).plot)
    lengths: dict[str, float] = {plane: pencils.length_mm * scales[key] for plane, key in SCALES.items()}
    angle, follows = math.radians(pencils.angle_deg), method.mechanism.follows
    return Marking(lengths, angle, dict(scales), pencils.sigmas, pencils.relative, follows)


def paper_scales(method: Method, plot: Plot) -> dict[str, float]:
    """The file's own scales; others are those of the mechanism's sheet. They are its handout's, too: of one without
    room on a page they are coarser."""
    written = method.mechanism.scales
    if all(key in written for key in SCALES.values()):
        return {key: written[key] for key in SCALES.values()}
    from graphkin.sheet import scales_of

    of_sheet = scales_of(method, plot, breaks=False, paged=True)
    return {key: float(of_sheet[plane]) for plane, key in SCALES.items()}


def page_scales(method: Method, plot: Plot) -> dict[str, float]:
    """The file's own scales; others are the finest at which a page has room for the mechanism, lying or standing, and
    for each polygon, lying: the paper that students draw on is as large for all."""
    from graphkin.base.rooms import corners
    from graphkin.sheet.composition import Planes
    from graphkin.sheet.window import PLANES

    planes, scales = Planes(method, plot, PLANES, "construction", "en"), dict[str, float]()
    for plane, key in SCALES.items():
        low, high = corners(planes.values(plane))
        fits = (_PAGE, complex(_PAGE.imag, _PAGE.real))[: 1 + (plane == "position")]
        scales[key] = method.mechanism.scales.get(key) or min(finest(high - low, room) for room in fits)
    return scales


def key_file(path: Path) -> Key:
    """The key that a file holds. Raises BadKey, NoFile, Unreadable."""
    from graphkin.outputs.key_json import key_of

    return key_of(text_of(path), Where(str(path)))


def text_of(path: Path) -> str:
    """The text of a key's file."""
    where = Where(str(path))
    if not path.is_file():
        raise NoFile(where, path.name, ())
    with opening(path):
        if path.stat().st_size > _LARGEST:
            raise BadKey(where, f"> {_LARGEST >> 20} MB")
        try:
            return path.read_text("utf-8-sig")
        except UnicodeDecodeError as problem:
            raise BadKey(where, problem.reason) from None


def further_methods(method: Method) -> Iterator[Method]:
    """One for each further position, in order: the same mechanism, drawn there, in the assembly it is moved into.
    Raises NoKeyAtPosition for one that is not reached, or whose assembly no file can state."""
    for count, values in enumerate(list(driver_values(method))[1:], 2):
        where = method.mechanism.where("driver", 0, "also")
        try:
            plot = replay_all(method, values)
            there = api.plan(mechanism_at(method, values), method.structure.coincident)
            same = _same(method, plot, there)
        except GraphkinError as problem:
            raise NoKeyAtPosition(where, count, problem) from None
        if not same:
            raise NoKeyAtPosition(where, count)
        yield there


def _same(method: Method, plot: Plot, there: Method) -> bool:
    """True where what is asked for is the same by both."""
    asked = list(asked_of(method.mechanism).values())
    one, other = (
        [number(quantity.answer(motions).value) for quantity in asked]
        for motions in (readings(method, plot), readings(there, replay_all(there)))
    )
    sizes = {q.unit: max(abs(v) for v, r in zip(one, asked, strict=True) if r.unit == q.unit) for q in asked}
    for q, a, b in zip(asked, one, other, strict=True):  # angles are the same but for whole turns
        off = abs(math.remainder(a - b, math.tau) if q.unit == "rad" else a - b)
        if off / (sizes[q.unit] or 1.0) >= _SAME:
            return False
    return True
