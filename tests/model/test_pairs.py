"""One registry of pair kinds: every table that depends on kinds has exactly these, and names are told by nobody but it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import graphkin
from graphkin.analytic import mobility, motion
from graphkin.analytic.rules import RULES
from graphkin.errors import CannotAssemble
from graphkin.errors.motion import PAIRS as CALLED
from graphkin.files import builder, library, loads, schema
from graphkin.files.builder import Builder
from graphkin.files.pairs import READERS
from graphkin.files.schema import File
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import named
from graphkin.model.pairs import PAIRS, Pair, Revolute
from graphkin.model.wheels import UNDER_LINKS
from graphkin.planning import plan
from graphkin.say.centre_steps import NORMALS
from graphkin.say.equivalents import EQUIVALENTS
from graphkin.say.structure import KINDS, structure_lines
from graphkin.say.sweeps import remarks
from graphkin.sheet.mechanism_figure import BEFORE_LINKS, OVER_LINKS
from graphkin.studies.assur import structure
from graphkin.studies.sweeps import course

EVERY = set(PAIRS)
REPLACED = {kind for kind in PAIRS if kind.equivalent is not Pair.equivalent}
SLIPPING = {kind for kind in PAIRS if kind.rolling is Pair.rolling and kind.slipping is not Pair.slipping} | {
    kind for kind in REPLACED if kind.rolling is Pair.rolling
}


@pytest.mark.parametrize(("table", "kinds"), [
    (RULES, EVERY),
    (KINDS, EVERY),
    ({Revolute: None, **UNDER_LINKS, **BEFORE_LINKS, **OVER_LINKS}, EVERY),
    (EQUIVALENTS, REPLACED),
    (NORMALS, SLIPPING),
], ids=("loop rules", "structure", "signs", "equivalents", "normals"))  # fmt: skip
def test_each_table_has_exactly_the_kinds(table: dict[type[Pair], object], kinds: set[type[Pair]]) -> None:
    assert set(table) == kinds


def test_no_kind_has_two_signs() -> None:
    assert len({*UNDER_LINKS, *BEFORE_LINKS, *OVER_LINKS}) == len(UNDER_LINKS) + len(BEFORE_LINKS) + len(OVER_LINKS)


def test_tables_of_the_file_are_those_of_the_kinds() -> None:
    assert set(READERS) == {kind.table for kind in PAIRS} - {""}
    assert set(READERS) <= set(File.__dataclass_fields__)
    assert set(READERS) <= set(CALLED)


def test_what_is_said_of_tables_of_the_file_is_said_of_each_kind() -> None:
    for table in {kind.table for kind in PAIRS} - {""}:
        assert table in builder._TABLES_OF_MANY, f"`with_` does not know `{table}.0.key`"
        assert table in schema.TABLES, f"a key of [[{table}]] typed wrong has no hint"
        assert table in library.KINDS, f"`library --with {table}`"
        assert callable(getattr(Builder, table, None)), f"Mechanism.new(..).{table}(..)"


def kinds_of(mechanism: Mechanism) -> set[type[Pair]]:
    return {type(pair) for pair in (*mechanism.hinges, *mechanism.pairs)}


def test_the_library_has_every_kind() -> None:
    assert set.union(*(kinds_of(library.load(name)) for name in library.names())) == EVERY


@pytest.mark.parametrize("name", library.names())
def test_pairs_have_names_and_places_of_their_own(name: str) -> None:
    mechanism = library.load(name)
    names = [pair.name for pair in mechanism.pairs]
    assert len(set(names)) == len(names)
    for pair in mechanism.pairs:
        assert mechanism.pair(pair.name) is pair
        assert mechanism.where(*mechanism.path(pair)).line
        assert named(mechanism, mechanism.path(pair))[0] in CALLED
        assert not pair.pin or pair.pin in mechanism.points
        for link in pair.joins:
            assert link in mechanism.links


CAM_OUT_OF_REACH = """
[frame]
A = [0, 0]
D = [80, 0]
[links.1]
AC = 40
[links.2]
DB = 40
[[cam]]
links = ["1", "2"]
profiles = [{ centre = "C", radius = 20 }, { centre = "B", radius = 10 }]
[[driver]]
vector = "AC"
angle = 50
omega = 3
[sketch]
B = [50, 20]
"""


def test_messages_call_a_rod_as_the_drawings_do() -> None:
    """`links 2 and e`, at a link that the file has."""
    with pytest.raises(CannotAssemble, match=r":7, links\.2: .* between links 2 and e\.") as caught:
        plan(loads(CAM_OUT_OF_REACH.replace("angle = 50", "angle = 150")))
    assert "e c0" not in caught.value.message("zh")
    stops = list(remarks(course(plan(loads(CAM_OUT_OF_REACH)), ["0:360:60"]), "en"))
    assert any("links 2 and e lie in line" in line for line in stops)


COUPLED = """
[frame]
name = "4"
A = [0, 0]
D = [80, 0]
[links.1]
AB = 30
[links.2]
BC = 70
[links.3]
shape = { D = [0, 0], C = [60, 0], E = [20, 30] }
[[driver]]
vector = "AB"
angle = 60
omega = 10
alpha = 5
[sketch]
C = [75, 60]
"""


def test_a_contact_between_points_of_one_link_repeats_what_the_link_holds() -> None:
    """Two discs on crank and rocker whose centres the coupler joins: both roads count one equation, and it is named."""
    discs = '[[cam]]\nlinks = ["1", "3"]\nprofiles = [{ centre = "B", radius = 50 }, { centre = "C", radius = 20 }]\n'
    mechanism = loads(COUPLED.replace("[[driver]]", discs + "[[driver]]"))
    assert mobility(mechanism).repeated == 1
    method = plan(mechanism)
    assert [(each.pair, each.part) for each in method.aside] == [(("cam", 0), "link")]
    assert any("cam pair 1–3" in line for line in structure_lines(structure(method), "en"))


@pytest.mark.parametrize("slot", [
    'pin = "B"\nguide = "3"\ncentre = "C"', 'pin = "C"\nguide = "1"\ncentre = "B"',
], ids=("slot on the rocker", "slot on the crank"))  # fmt: skip
def test_a_pin_in_a_circular_slot_moves_as_a_four_bar(slot: str) -> None:
    """With the coupler's length as its radius, over the whole turn."""
    turn = np.radians(np.arange(60, 420, 5.0))
    bar = motion(loads(COUPLED), [turn])
    cut = motion(loads(COUPLED.replace("[links.2]\nBC = 70", f"[[slide]]\n{slot}\nradius = 70")), [turn])
    for point in "BCE":
        for one, other in zip(
            (bar.position, bar.velocity, bar.acceleration), (cut.position, cut.velocity, cut.acceleration), strict=True
        ):
            assert other[point] == pytest.approx(one[point], rel=1e-9, abs=1e-12)
    assert cut.alpha["3"] == pytest.approx(bar.alpha["3"], rel=1e-9)


PARSED = re.compile(r"""\[0\]\.is(upper|lower)\(|(startswith|removeprefix|endswith)\(["'](c|e|e g|pin|\*| origin)? ?["']\)""")


def test_no_name_is_taken_apart() -> None:
    """What a name stands for is a field: of a `Link`, a `Line`, a `Slide` of an equivalent, a `Node`; `say.names` alone
    spells names as people read them.
    """
    files = (path for path in Path(graphkin.__file__).parent.rglob("*.py") if path.parts[-2:] != ("say", "names.py"))
    lines = ((path.name, line) for path in files for line in path.read_text("utf-8").splitlines())
    assert [(name, line.strip()) for name, line in lines if PARSED.search(line)] == []
