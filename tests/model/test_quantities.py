"""Quantities: read from text in one place, asked of any motions, with units at the edge from one table."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

import graphkin
from graphkin.analytic import motion
from graphkin.errors import NOWHERE, GraphkinError, UnknownPoint, Where
from graphkin.files import library, loads, starters
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, Centre, Quantity, Rotation, meant, named, parts, read
from graphkin.model.quantities.kinds import QuantityBase
from graphkin.model.quantities.reading import WORDS
from graphkin.planning import plan
from graphkin.proof.readings import readings
from graphkin.running import replay_all
from graphkin.studies import sweeps
from graphkin.studies.centres import centres
from graphkin.studies.sweeps.roads import mended

PACKAGE = Path(graphkin.__file__).parent
FILES = sorted(PACKAGE.rglob("*.py"))
EDGES = ("studies/sweeps/", "studies/finding/", "results/", "outputs/", "equations/")
"""Parts that show results of quantities in units of the edge."""


def place(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


def asked(mechanism: Mechanism) -> list[Quantity]:
    return [found for text in mechanism.ask if (found := read(mechanism, text)) is not None]


# --- one reader, one table, one class ---------------------------------------------------------


def test_one_class_answers_velocities_and_accelerations():
    for name in ("velocity_at", "acceleration_at"):
        found = [place(path) for path in FILES if f"def {name}(" in path.read_text("utf-8")]
        assert found == ["model/kinematic_state.py"], name


KINDS = {kind.__name__ for kind in get_args(Quantity)}


def test_every_kind_is_in_the_union():
    assert {kind.__name__ for kind in QuantityBase.__subclasses__()} == KINDS


def test_readers_of_all_kinds_leave_none_to_chance():
    """A match over kinds of quantities ends in `assert_never`, so that the type checker names it for a new kind."""
    texts = {path: text for path in FILES if "quantit" in (text := path.read_text("utf-8")) and "match " in text}
    matches = [(place(path), node) for path, text in texts.items() for node in ast.walk(ast.parse(text))
               if isinstance(node, ast.Match)]  # fmt: skip
    readers = [(where, node) for where, node in matches if KINDS & {
        ast.unparse(part.cls).rpartition(".")[2] for case in node.cases for part in ast.walk(case.pattern)
        if isinstance(part, ast.MatchClass)
    }]  # fmt: skip
    assert len(readers) > 12
    for where, node in readers:
        last = node.cases[-1]
        assert ast.unparse(last.pattern) == "_", (where, node.lineno)
        assert "assert_never" in ast.unparse(last.body[0]), (where, node.lineno)


def patterns(tree: ast.AST) -> Iterator[str]:
    """Texts that something is matched against: by `re`, by `startswith`, by `match`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            whose = node.func.value.id if isinstance(node.func.value, ast.Name) else ""
            if whose == "re" or node.func.attr in ("startswith", "partition", "fullmatch"):
                yield from (part.value for part in ast.walk(node) if isinstance(part, ast.Constant)
                            and isinstance(part.value, str))  # fmt: skip


def test_quantities_are_read_in_one_place():
    words = re.compile(r"theta|omega|alpha|\b[va]_|^[va] |\(\\w\+\) \+\(\\S\+\)")
    for path in FILES:
        if not place(path).startswith("model/quantities/"):
            found = [text for text in patterns(ast.parse(path.read_text("utf-8"))) if words.search(text)]
            assert not found, (place(path), found)


@pytest.mark.parametrize("path", [path for path in FILES if place(path).startswith(EDGES)],
                         ids=place)  # fmt: skip
def test_units_at_the_edge_are_one_table(path: Path):
    text = path.read_text("utf-8")
    assert not re.search(r"180(\.0)? / (math|np)\.pi|9\.80665|\"(deg|°| ?mm)\", 1", text)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Dict):
            keys = {key.value for key in node.keys if isinstance(key, ast.Constant)}
            factors = [part for value in node.values for part in ast.walk(value) if isinstance(part, ast.Constant)
                       and isinstance(part.value, float) and part.value not in (0.0, 1.0)]  # fmt: skip
            assert not (keys & {*EDGE, "mm", "deg"} and factors), ast.unparse(node)


# --- read and written -------------------------------------------------------------------------


@pytest.mark.parametrize("name", library.names())
def test_every_question_reads_back(name: str):
    mechanism = library.load(name)
    for question in mechanism.ask:
        quantity = named(mechanism, question, NOWHERE)
        assert read(mechanism, quantity.text) == quantity
        assert quantity.text.replace(" ", "") == question.replace(" ", "")
        assert quantity.unit in EDGE


@pytest.mark.parametrize(
    ("text", "unit", "letter", "part", "along"),
    [
        ("theta  4", "rad", "θ", "", None), ("alpha 4", "rad/s^2", "α", "", None), ("s ram", "m", "s", "", None),
        ("x E", "m", "x", "", None), ("v E", "m/s", "v", "", 1), ("v B", "m/s", "v", "", None),
        ("v_y E", "m/s", "v", "y", None), ("a DE", "m/s^2", "a", "", None), ("a_n DE", "m/s^2", "a", "n", None),
        ("a_k B3B4", "m/s^2", "a", "k", None), ("P13", "m", "P", "", None), ("omega 4/ omega 2", "1", "omega 4/", "", None),
    ],
)  # fmt: skip
def test_kinds(text: str, unit: str, letter: str, part: str, along: complex | None):
    """Of the shaper, whose ram is led to the right."""
    quantity = named(library.load("ex3-7"), text, NOWHERE)
    assert (quantity.unit, quantity.part) == (unit, part)
    assert quantity.letter == letter or (letter.endswith("/") and len(quantity.halves) == 2)
    assert quantity.along == along or abs(quantity.along or 0) == pytest.approx(1)
    assert (quantity.along is None) == (along is None)


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("omega 9", "UnknownLink"), ("v Q", "UnknownPoint"), ("s none", "UnknownSlide"), ("a_n B", "NeedsTwo"),
        ("omga 4", "NotOneOf"), ("x BC", "UnknownPoint"), ("omega 4 / omega 9", "UnknownLink"),
        ("ratio of strokes", "UnknownQuantity"), ("v E / omega 4", "UnknownQuantity"), ("omega 1", "UnknownQuantity"),
        ("a_k DE", "UnknownQuantity"), ("P13 / P14", "UnknownQuantity"), ("v E / v E / v E", "UnknownQuantity"),
    ],
)  # fmt: skip
def test_what_is_not_there(text: str, error: str):
    mechanism = library.load("ex3-7")
    text = text.replace("omega 1", f"omega {mechanism.frame}")
    with pytest.raises(GraphkinError) as raised:
        named(mechanism, text, Where("--of"))
    assert type(raised.value).__name__ == error
    assert "--of" in str(raised.value)


@pytest.mark.parametrize("text", ["a_k C2C3", "v C2C3", "v_x C2C3"])
def test_coincident_points_that_are_there_are_told(text: str):
    """Links of a cylinder have words for names; what is told is read again."""
    mechanism = loads(starters.text("cylinder", "en"))
    with pytest.raises(GraphkinError) as raised:
        named(mechanism, text, Where("ask"))
    assert raised.value.possible
    for pair in raised.value.possible:
        assert named(mechanism, f"a_k {pair}", NOWHERE).part == "k"
    with pytest.raises(GraphkinError, match=r"Possible: A, B, C, T\."):
        named(mechanism, "a_n C2C3", Where("ask"))


@pytest.mark.parametrize(("name", "text", "points"), [
    ("ex3-7", "v ram", ("E",)), ("ex3-7", "v_x 5", ("E",)), ("ex3-7", "x 1", ("A", "B")), ("ex3-1", "a s0", ("B2B3",)),
])  # fmt: skip
def test_links_and_sliding_pairs_say_which_points_move(name: str, text: str, points: tuple[str, ...]):
    with pytest.raises(UnknownPoint) as refused:
        read(library.load(name), text)
    assert refused.value.possible == points


def test_only_what_is_answered_is_suggested():
    mechanism = library.load("ex3-7")
    assert meant(mechanism, "ω4") == "omega 4"
    assert meant(mechanism, "v_E") == "v E"
    assert meant(mechanism, f"omega{mechanism.frame}") is None
    assert [half.text for half in parts(mechanism, "v E / omega 4 / Q")] == ["v E", "omega 4"]


# --- asked of any motions ---------------------------------------------------------------------


def every_kind(mechanism: Mechanism) -> Iterator[Quantity]:
    """Quantities of every word that the mechanism has."""
    of = [*mechanism.moving, *mechanism.points, *(slide.name for slide in mechanism.slides)]
    of += [one + other for one in mechanism.points for other in mechanism.points if one != other][:12]
    of += [f"{p}@{a},{p}@{b}" for p, links in mechanism.owners.items() for a in links for b in links
           if a != b and p in mechanism.points][:6]  # fmt: skip
    for text in [f"{word} {name}" for word in WORDS for name in of] + [*mechanism.ask]:
        try:
            found = read(mechanism, text)
        except GraphkinError:
            continue
        if found is not None and not isinstance(found, Centre):
            yield found


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_both_roads_answer_alike(name: str):
    mechanism = library.load(name)
    method = plan(mechanism)
    plot = replay_all(method)
    exact, drawn = motion(mechanism), readings(method, plot)
    patched = mended(drawn, 1, ())
    sizes: dict[str, float] = {}
    answers = []
    with np.errstate(invalid="ignore", divide="ignore"):
        for quantity in every_kind(mechanism):
            three = [quantity.answer(road) for road in (drawn, exact, patched)]
            answers.append((quantity, *(answer.value if answer.vector is None else answer.vector for answer in three)))
            sizes[quantity.unit] = max(sizes.get(quantity.unit, 0.0), np.nan_to_num(abs(three[1].value)))
    assert answers
    for quantity, one, other, third in answers:
        if isinstance(quantity, Rotation) and quantity.word == "theta":
            one, other, third = (np.exp(1j * np.asarray(angle)) for angle in (one, other, third))
        least = 1e-9 * max(sizes[quantity.unit], 1.0)
        assert np.isnan(other) or abs(one - other) <= least, quantity
        assert np.isnan(one) or abs(one - third) <= least, quantity


@pytest.mark.parametrize("name", ["fig3-4", "ex3-1", "p3-12", "s3-cam"])
def test_centres_are_where_velocities_are_alike(name: str):
    mechanism = library.load(name)
    method = plan(mechanism)
    found, exact = centres(method, replay_all(method)), motion(mechanism)
    for first, second in found.pairs:
        here, there = Centre("P", "", (first, second)).place(exact), found.place(first, second)
        if np.isfinite(there):
            assert abs(here - there) <= 1e-9 * max(1.0, abs(there)), (first, second)


def test_a_sweep_reads_only_what_is_asked():
    """Tables of motions are made when they are read."""
    method = plan(library.load("ex3-7"))
    course = sweeps.course(method, ["0:360:10"])
    motions = sweeps.roads.moving(method, course.path, course.t, "construction")
    assert isinstance(motions, Motions)
    made = motions.velocities["5"]
    assert not any(made._made.values())
    motions.velocity_at("E", "5")
    assert [point for point, value in made._made.items() if value is not None] == ["E"]
