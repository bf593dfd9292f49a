"""A drawing handed in alone: what it determines beside its vectors, and which way its known arrows point."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from graphkin import api
from graphkin import files as loading
from graphkin.construction import Plot
from graphkin.errors import Where
from graphkin.files import library
from graphkin.homework.grading import grade
from graphkin.homework.grading.batch import earlier_reading
from graphkin.homework.grading.keys import key_drawn
from graphkin.marking.consequences import rewrites, rewritten
from graphkin.marking.marker import Marker
from graphkin.marking.records import Drawn, HandedNumber, StudentWork
from graphkin.marking.rewrite import Rewrite
from graphkin.model.quantities import Moving
from graphkin.outputs.marks_json import record
from graphkin.submissions import Limits

NAMES = ("ex3-5", "clockwise")
NOT_DRAWN = ("omega-sense", "wrong-length", "sliding-as-turning", "absolute-for-relative", "centre-ratio",
             "centre-acceleration-zero", "block-omega", "conversion", "other-assembly", "diameter-for-radius",
             "degrees-for-radians", "decimal-slip", "answers-swapped", "sense-not-given")  # fmt: skip
"""Mistakes of reading and of reckoning, which a polygon does not show, and the link in another place."""


@cache
def marker(name: str) -> Marker:
    if name != "clockwise":
        return Marker(key_drawn(api.plan(api.load(name))))
    document = tomllib.loads(library.load("ex3-1").text)
    document["driver"][0] |= {"omega": -10}
    return Marker(key_drawn(api.plan(loading.from_dict(document, name="clockwise"))))


def drawn(plot: Plot) -> Drawn:
    planes = ("velocity", "acceleration")
    return {p: {n: complex(at) for n, at in plot.points(p).items() if np.isfinite(at)} for p in planes}


def vectors(one: Marker, points: Drawn) -> dict[str, complex]:
    """Of every arrow the key names."""
    found = {}
    for entry, quantity in zip(one.key.entries, one.quantities, strict=True):
        at = one.problem.arrows.of(quantity) if isinstance(quantity, Moving) else None
        if at is not None and at[0][1] in points[at[0][0]] and at[0][2] in points[at[0][0]]:
            found[entry.text] = at[1] * (points[at[0][0]][at[0][2]] - points[at[0][0]][at[0][1]])
    return found


@cache
def made(name: str) -> list[tuple[Rewrite, Drawn]]:
    one = marker(name)
    every = rewrites(one.method, one.plot, one.quantities, one.key.marking.scales)
    return [(each, drawn(rewritten(one.method, one.plot, (each,)))) for each in every if each.name[0] != "conversion"]


@pytest.mark.parametrize("name", NAMES)
def test_rotations_are_read_as_the_mistake_has_them(name: str):
    """By the drawing alone, what is replayed by arrays for the key."""
    one, seen = marker(name), 0
    rows = {names[0]: row for row, names in enumerate(one.key.singles.names)}
    for rewrite, points in made(name):
        if rewrite.name[0] in NOT_DRAWN or rewrite.name[1] in ("segment", "length", "cw", "ccw") or rewrite.name not in rows:
            continue
        found, _ = one.off_drawing(points, {}, {})
        for entry, value in zip(one.key.entries, one.key.singles.values[rows[rewrite.name]], strict=True):
            if entry.text.startswith(("omega", "alpha")) and entry.points and np.isfinite(value):
                assert found.values[entry.text] == pytest.approx(value, rel=1e-6, abs=1e-9), rewrite.name
                seen += 1
    assert seen > 20


@pytest.mark.parametrize("name", NAMES)
def test_known_arrows_point_right_but_where_a_mistake_turns_them(name: str):
    one = marker(name)
    right = drawn(one.plot)
    assert set(one.off_drawing(right, vectors(one, right), {})[1].values()) == {True}
    for rewrite, points in made(name):
        wrong = {text for text, good in one.off_drawing(points, vectors(one, points), {})[1].items() if not good}
        if rewrite.name[0] in ("coriolis-reversed", "coriolis-not-turned"):
            assert any(text.startswith("a_k") for text in wrong)
        if rewrite.name[0] in ("wrong-radius", "sliding-across", "normal-omitted", "coriolis-half", "normal-size"):
            assert not wrong, rewrite.name
        if rewrite.name[0] == "normal-outward":
            assert wrong


def test_an_arrow_along_its_link_has_no_sense():
    one = marker("ex3-5")
    points = next(points for rewrite, points in made("ex3-5") if rewrite.name[:1] == ("velocity-along-link",))
    found, _ = one.off_drawing(points, {}, {})
    assert len(found.no_sense) == 1
    assert found.no_sense[0] not in found.values


def test_a_coriolis_term_by_a_written_rotation_counts():
    """The student reads omega with the other sense, says so, and lays off the term by it."""
    one = marker("ex3-1")
    points = next(points for rewrite, points in made("ex3-1") if rewrite.name[0] == "coriolis-reversed")
    told = [one.off_drawing(points, vectors(one, points), own)[1]["a_k B3B2"] for own in ({}, {"omega 3": 3.919})]
    assert told == [False, True]


def svg(points: Drawn, scales: dict[str, float]) -> str:
    """Both polygons as people draw them: lines from the pole and between neighbours, a letter beside each point."""
    parts, shift = [], {"velocity": 40 + 150j, "acceleration": 200 + 150j}
    for plane, letters in points.items():
        page = {n: shift[plane] + (at / scales[plane]).conjugate() for n, at in letters.items()}
        pole = next(iter(page))
        for name, at in page.items():
            parts.append(f'<path d="M{page[pole].real},{page[pole].imag}L{at.real},{at.imag}" stroke="#000"/>')
            parts.append(f'<circle cx="{at.real}" cy="{at.imag}" r="0.4"/>')
            parts.append(f'<text x="{at.real + 0.6}" y="{at.imag}" font-size="2">{name}</text>')
    scale = f"mu_v = {scales['velocity']} m/s/mm", f"mu_a = {scales['acceleration']} m/s²/mm"
    parts += [f'<text x="10" y="{10 * k}" font-size="4">{text}</text>' for k, text in enumerate(scale, 1)]
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210">{"".join(parts)}</svg>'


def test_a_drawing_alone_is_marked_whole(tmp_path: Path):
    one = marker("ex3-1")
    scales = {"velocity": 0.005, "acceleration": 0.05}
    for id, best, last in (("coriolis-reversed", "wrong", "carried"), ("normal-omitted", "right", "wrong")):
        points = next(points for rewrite, points in made("ex3-1") if rewrite.name[0] == id)
        (tmp_path / "s1.svg").write_text(svg(points, scales), encoding="utf-8")
        (found,) = grade(one.key, [tmp_path / "s1.svg"], Limits())
        assert found.marked is not None, found.reason
        judged = {each.text: each for each in found.marked.judged}
        assert all(each.given is not None for each in found.marked.judged)
        assert any("omega 3" in note.message("en") and "omega 3" in note.message("zh") for note in found.notes)
        assert judged["omega 3"].verdict == "right"
        assert judged["alpha 3"].verdict == last  # one mistake costs one item
        assert (judged["a_k B3B2"].verdict, judged["a_k B3B2"].sense) == (best, best)
        assert any(id in each.ids for each in found.marked.diagnosis.explanations)


def test_an_arrow_astray_tells_mistakes_apart():
    """By sizes and rotations alone the driver reversed goes with omega misread, which turns no arrow."""
    one = marker("ex3-1")
    points = next(points for rewrite, points in made("ex3-1") if rewrite.name[0] == "driver-reversed")
    arrows = {text: vector for text, vector in vectors(one, points).items() if text.startswith("v")}
    found, told = one.off_drawing({"velocity": points["velocity"]}, arrows, {})
    assert told == {"v B2": False}
    for pointing, expected in ((told, {"driver-reversed"}), ({}, {"driver-reversed", "omega-sense", "sense-not-given", "slip"})):
        numbers = {text: HandedNumber(abs(vector), points=pointing.get(text)) for text, vector in arrows.items()}
        numbers |= {text: HandedNumber(value) for text, value in found.values.items()}
        (marked,) = one.mark([StudentWork("s", numbers)])
        assert {id for each in marked.diagnosis.explanations for id in each.ids} == expected


def test_a_drawing_with_the_driver_reversed_is_marked(tmp_path: Path):
    """Its crank's arrow points the other way, which is not asked for: no mistake of writing asked answers down says
    anything of that."""
    document = tomllib.loads(library.load("ex3-1").text)
    document["ask"] = ["omega 3", "alpha 3"]
    key = key_drawn(api.plan(loading.from_dict(document, name="asked")))
    points = drawn(marker("clockwise").plot)
    (tmp_path / "s1.svg").write_text(svg(points, {"velocity": 0.005, "acceleration": 0.05}), encoding="utf-8")
    (found,) = grade(key, [tmp_path / "s1.svg"], Limits())
    assert found.marked is not None, found.reason
    assert {each.text: each.verdict for each in found.marked.judged if each.points} == {"omega 3": "wrong", "alpha 3": "right"}
    assert any("driver-reversed" in each.ids for each in found.marked.diagnosis.explanations)


def test_a_page_may_be_turned_and_the_driver_not(tmp_path: Path):
    """Half a turn of the velocities alone is the driver's sense."""
    points = next(points for rewrite, points in made("ex3-1") if rewrite.name[0] == "driver-reversed")
    (tmp_path / "s1.svg").write_text(svg(points, {"velocity": 0.005, "acceleration": 0.05}), encoding="utf-8")
    (found,) = grade(marker("ex3-1").key, [tmp_path / "s1.svg"], Limits(turned=True))
    assert found.marked is not None, found.reason
    assert {each.text: each.verdict for each in found.marked.judged}["omega 3"] == "wrong"


def test_directions_stay_when_marks_are_made_anew(tmp_path: Path):
    one = marker("ex3-1")
    points = next(points for rewrite, points in made("ex3-1") if rewrite.name[0] == "coriolis-reversed")
    (tmp_path / "s1.svg").write_text(svg(points, {"velocity": 0.005, "acceleration": 0.05}), encoding="utf-8")
    (found,) = grade(one.key, [tmp_path / "s1.svg"])
    numbers = earlier_reading(record(found), Where("")).work
    assert (numbers.numbers["a_k B3B2"].points, numbers.numbers["alpha 3"].measured) == (False, True)
    assert one.mark([numbers]) == [found.marked]


def test_letters_with_words_in_them(tmp_path: Path):
    """A link called by a word: `n_rod'`, with or without its mark for lowering, or n' alone."""
    document = tomllib.loads(library.load("ex3-5").text)
    document["links"]["rod"] = document["links"].pop("2")
    document["ask"] = ["omega rod", "alpha rod", "a_n CB"]
    one = Marker(key_drawn(api.plan(loading.from_dict(document, name="words"))))
    page = svg(drawn(one.plot), {"velocity": 0.005, "acceleration": 0.05})
    assert ">n_rod'<" in page
    for spelt in ("n_rod'", "nrod'", "n'_rod"):
        (tmp_path / "s1.svg").write_text(page.replace(">n_rod'<", f">{spelt}<"), encoding="utf-8")
        (found,) = grade(one.key, [tmp_path / "s1.svg"])
        assert found.marked is not None
        assert found.marked.score == pytest.approx(1.0), spelt
