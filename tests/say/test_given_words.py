"""What a solution says is given fixes the mechanism: two mechanisms that differ are told in different words."""

from __future__ import annotations

import cmath
import math
import random
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from every_family import FAMILIES as EVERY
from every_family import OTHERS
from library_sheets import TEXTBOOK
from random_mechanisms import (
    DYADS,
    cam,
    chain,
    circular_slot,
    cylinder,
    dyad,
    epicyclic,
    geared_five_bar,
    rolling,
    triad,
)

import graphkin
from graphkin.errors import Lang
from graphkin.files import library
from graphkin.files.values import split_points
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, RollingContact, Slide
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say import names
from graphkin.say.entry import Sentence
from graphkin.say.problem_data import problem_data
from graphkin.say.reading import Reading

WRITTEN = sorted((Path(__file__).parents[1] / "cases" / "written").glob("*.toml"))
FAMILIES: tuple[Callable[[int], Mechanism], ...] = (
    cam, chain, circular_slot, cylinder, epicyclic, geared_five_bar, rolling, triad
)  # fmt: skip
TURN = cmath.rect(1.0, 0.2)


def said(reading: Reading, mechanism: Mechanism) -> str:
    """What is given of a mechanism, in the words for one that is drawn."""
    other = replace(reading, method=replace(reading.method, mechanism=mechanism))
    return "\n".join(entry.text for entry in problem_data(other) if isinstance(entry, Sentence))


def assert_fixed(mechanism: Mechanism) -> None:
    method = plan(mechanism)
    plot = replay_all(method)
    changes = list(changed(mechanism))
    for lang in ("en", "zh"):
        reading = Reading(method, plot, {}, lang)
        text = said(reading, mechanism)
        same = [what for what, other in changes if said(reading, other) == text]
        assert not same, (lang, same, text)


# --- mechanisms that differ in one thing -------------------------------------------------------------


def changed(mechanism: Mechanism) -> Iterator[tuple[str, Mechanism]]:
    for name, link in mechanism.links.items():
        first, *others = mechanism.named(name) or ("",)
        fixed = name == FRAME
        for point in (first, *others) if fixed and first else others:
            for more in (0.007, 0.007j) if fixed or len(others) > 1 else (0.007,):
                moved = replace(link, points={**link.points, point: link.points[point] + more})
                yield f"{name}.{point}", replace(mechanism, links={**mechanism.links, name: moved})
    for k, pair in enumerate(mechanism.pairs):
        for what, other in variants(mechanism, pair):
            pairs = (*mechanism.pairs[:k], other, *mechanism.pairs[k + 1 :])
            yield f"{pair.name}.{what}", replace(mechanism, pairs=pairs)


def variants(mechanism: Mechanism, pair: Pair) -> Iterator[tuple[str, Pair]]:
    match pair:
        case Slide(line=line):
            yield from (("line", replace(pair, line=other)) for other in lines(mechanism, line))
            if pair.block is not None and len(mechanism.named(pair.block)) > 1:
                yield "tilt", replace(pair, tilt=pair.tilt + 0.2)
                yield "sense", replace(pair, line=replace(line, direction=-line.direction, base=None))
        case CircularSlot():
            yield "radius", replace(pair, radius=pair.radius * 1.1)
        case Gear(radii=(one, other)):
            yield "radii", replace(pair, radii=(other, one * 1.1))
            yield "internal", replace(pair, internal=not pair.internal)
            yield "centres", replace(pair, centres=(pair.centres[1], pair.centres[0]))
        case RollingContact(line=None):
            yield "radius", replace(pair, radius=pair.radius * 1.1)
            yield "track", replace(pair, track_radius=pair.track_radius * 1.1)
            yield "internal", replace(pair, internal=not pair.internal)
        case RollingContact(line=Line() as line):
            yield "side", replace(pair, left=not pair.left)
            yield from (("line", replace(pair, line=other)) for other in lines(mechanism, line))
        case Cam(profiles=(one, other)):
            if one.radius and other.radius:
                yield "internal", replace(pair, internal=not pair.internal)
            for k, each in enumerate(pair.profiles):
                others = [replace(each, radius=each.radius * 1.1 + 0.001)] if each.line is None else [
                    replace(each, left=not each.left),
                    *(replace(each, line=line) for line in lines(mechanism, each.line)),
                ]  # fmt: skip
                for new in others:
                    yield f"profile {k}", replace(pair, profiles=(new, other) if k == 0 else (one, new))


def lines(mechanism: Mechanism, line: Line) -> Iterator[Line]:
    """The line turned, and by other points of its link; that of a link of one point is the link's own."""
    slid = any(slide.block == line.link for slide in mechanism.slides)
    if line.link == FRAME or len(mechanism.named(line.link)) > 1 or slid:
        yield replace(line, direction=line.direction * TURN)
    link = mechanism.links[line.link]
    for point in mechanism.named(line.link):
        if abs((line.direction.conjugate() * link.arm(line.origin, point)).imag) > 1e-6:
            yield replace(line, origin=point, named=True)
            yield replace(line, direction=link.arm(line.origin, point) / abs(link.arm(line.origin, point)), base=None)


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_the_library_is_fixed_by_what_is_given(name: str) -> None:
    assert_fixed(library.load(name))


@pytest.mark.parametrize("path", WRITTEN, ids=lambda path: path.stem)
def test_written_files_are_fixed(path: Path) -> None:
    assert_fixed(graphkin.load(path))


@pytest.mark.many
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kind", FAMILIES, ids=lambda kind: kind.__name__)
def test_any_mechanism_is_fixed(kind: Callable[[int], Mechanism], seed: int) -> None:
    assert_fixed(kind(seed))


@pytest.mark.parametrize("kind", DYADS)
def test_any_dyad_is_fixed(kind: str) -> None:
    for seed in range(4):
        assert_fixed(dyad(kind, seed))


# --- the figures of the file ---------------------------------------------------------------------------

GEOMETRY = ("frame", "links", "slide", "gear", "roll", "cam", "driver", "pose")  # tables of the file
COMPUTED = 7  # a figure of more digits is no one's who types


def figures(table: object, key: str = "") -> Iterator[tuple[str, str | float]]:
    """The numbers of a table of the file, texts with a unit among them, each with its key."""
    match table:
        case dict():
            for inner, value in table.items():
                yield from figures(value, inner)
        case list():
            for value in table:
                yield from figures(value, key)
        case str() if key not in ("name", "link", "links", "also") and table[:1] in "-+.0123456789" and " " in table:
            yield key, table
        case int() | float() if not isinstance(table, bool) and key != "also":
            yield key, table


def told(key: str, stated: str | float, text: str) -> bool:
    """A number of the file, with its unit if it states one, stands in what is given; or an axis, a sense is said."""
    figure, unit = stated.split(maxsplit=1) if isinstance(stated, str) else (str(stated), "")
    value, close = float(figure), 1e-9 if sum(map(str.isdigit, figure)) <= COMPUTED else 1e-5
    if key in ("angle", "tilt") and unit in ("", "deg") and not value % 90:
        along = ("along", "parallel to", "the link's own axis", "stays on a line of link") if value == 0 else ()
        along += ("points the other way along the guide",) if key == "tilt" and abs(value) == 180 else ()
        if any(said in text for said in (("horizontally", "vertically")[round(value / 90) % 2], *along)):
            return True
    if unit in ("", "deg") and value in (0, 180) and len(corners := split_points(key)) == 3:  # it is on the line of two
        return any(f"{names.point(corner)} lies on " in text for corner in corners)
    unit = {"rpm": "r/min", "deg": "°"}.get(unit, unit)
    for printed in re.finditer(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text):
        same = math.isclose(abs(float(printed[0])), abs(value), rel_tol=close, abs_tol=1e-9)
        if same and (not unit or re.match(r"[^:;=]*" + re.escape(unit), text[printed.end() :]) or f"({unit}):" in text):
            return True
    return False


def assert_told(mechanism: Mechanism) -> None:
    """Every number of the geometry of its file stands in what is given, as the file states it."""
    method = plan(mechanism)
    text = said(Reading(method, replay_all(method), {}, "en"), mechanism).replace("−", "-")
    document = tomllib.loads(mechanism.text)
    every = [(table, *figure) for table in GEOMETRY for figure in figures(document.get(table, {}))]
    assert every
    assert not [(table, key, value) for table, key, value in every if not told(key, value, text)], text


@pytest.mark.parametrize("name", library.names())
def test_every_figure_of_the_file_is_given(name: str) -> None:
    assert_told(library.load(name))


@pytest.mark.parametrize("family", [name for name in EVERY if name not in (*DYADS, *OTHERS)])  # these have no file
def test_every_figure_of_any_file_is_given(family: str) -> None:
    for seed in range(3):
        assert_told(EVERY[family](seed))



@pytest.mark.parametrize("path", [*WRITTEN, *sorted(TEXTBOOK.glob("*.toml"))], ids=lambda path: path.stem)
def test_every_figure_of_a_written_file_is_given(path: Path) -> None:
    assert_told(graphkin.load(path))


NAMING = ("through", "toward", "from", "centre", "centres", "on_centre", "point", "pin")


def letters(table: object) -> Iterator[str]:
    """The points that a table of a pair names."""
    match table:
        case dict():
            for key, value in table.items():
                yield from letters(value if key in NAMING or isinstance(value, list) else None)
        case list():
            for value in table:
                yield from letters(value if isinstance(value, dict | str) else None)
        case str():
            yield from split_points(table)


@pytest.mark.many
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("name", library.names())
def test_every_point_of_a_pair_is_named_in_its_sentence(name: str, lang: Lang) -> None:
    mechanism = library.load(name)
    method = plan(mechanism)
    document = tomllib.loads(mechanism.text)
    sentences = said(Reading(method, replay_all(method), {}, lang), mechanism).split("\n")
    for table in ("slide", "gear", "roll", "cam"):
        for row in document.get(table, []):
            named = {names.point(point) for point in letters({k: v for k, v in row.items() if k not in ("links", "radii")})}
            assert any(all(point in sentence for point in named) for sentence in sentences), (row, sentences)


@pytest.mark.parametrize("seed", range(12))
def test_no_angle_of_the_drawing_is_from_nowhere(seed: int) -> None:
    """A corner of a link whose sides are given is drawn by them, not at an angle that nobody gave."""
    rng = random.Random(seed)
    place, beside = rng.uniform(20, 40), complex(rng.uniform(10, 50), rng.choice((-1, 1)) * rng.uniform(20, 50))
    text = (
        f'[frame]\nA = [0, 0]\nD = [0, -60]\n[links.1]\nAB = 20\n[links.2]\npoints = ["B"]\n[links.3]\n'
        f"shape = {{ D = [0, 0], C = [{beside.real}, {beside.imag}], E = [{place}, 0] }}\n"
        '[[slide]]\nblock = "2"\npoint = "B"\nguide = "3"\nthrough = "D"\ntoward = "E"\n'
        f'[[driver]]\nvector = "AB"\nangle = {rng.uniform(0, 360)}\nomega = 10\n'
    )
    drawing = graphkin.Drawing.of(graphkin.loads(text))
    lines = list(drawing.explain("en", everything=True))
    corner = next(line for line in lines if "They cross at C" in line)
    sense = "clockwise" if beside.imag > 0 else "counter-clockwise"
    assert "On this line lay off DE = l_DE/μ_l = " in corner
    assert f"(D→C→E {sense})" in corner
    assert not [line for line in lines if "∠" in line]
