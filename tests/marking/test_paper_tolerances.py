"""Tolerances tell the truth: they are in proportion to the pencil's errors, or it is said that they are not."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from every_family import FAMILIES
from large_mechanisms import triads
from paper_scales import at_paper_scales

from graphkin.analytic import motion
from graphkin.base.scales import SERIES
from graphkin.construction import Plot, replay
from graphkin.errors import GraphkinError
from graphkin.files import library, loads
from graphkin.homework.grading import key_for, marking_of
from graphkin.homework.grading.keys import page_scales
from graphkin.marking.answers import readable
from graphkin.marking.key import TELLS, Key, KeyEntry, part_off
from graphkin.marking.key_making import asked_alone, half_digit
from graphkin.marking.marker import Marker
from graphkin.marking.pencil import Slips, _on_paper, drawn_positions, seed_of
from graphkin.marking.records import HandedNumber, StudentWork
from graphkin.marking.tolerances import Drawings, parts_off, pencil_of, spread, tolerances
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Slide
from graphkin.outputs.study_json import tolerance_data
from graphkin.planning import Method, plan
from graphkin.running import replay_all
from graphkin.running.path import turned
from graphkin.say.tolerances import tolerance_lines

STEP = 1e-3
"""Of the pencil's errors."""
WITHIN = 1.3
ALL = "GRAPHKIN_RANDOM" in os.environ
PLACES = [*library.names()[:: 1 if ALL else 4], *(f"{family} {seed}" for family in [*FAMILIES][:: 1 if ALL else 2] for seed in range(1 + ALL))]


def mechanism(place: str) -> Mechanism:
    family, _, seed = place.partition(" ")
    return FAMILIES[family](int(seed)) if seed else library.load(place)


def on_a_page(machine: Mechanism) -> Mechanism:
    """At the scales of a student's page, for which no sheet has to be arranged."""
    method = plan(machine)
    return replace(machine, scales=page_scales(method, replay_all(method)))


@cache
def marker(place: str) -> Marker:
    try:
        machine = on_a_page(at_paper_scales(mechanism(place), place))
        return Marker(key_for(replace(machine, ask=machine.ask or ("x",))), plan(machine))
    except GraphkinError as problem:  # a dead point, or nothing that a pencil gives
        pytest.skip(str(problem))


def to_first_order(method: Method, key: Key) -> np.ndarray:
    """Standard deviations of a key's quantities, from errors so small that all is in proportion to them."""
    quantities = [q for entry in key.entries if (q := readable(method.mechanism, entry.text)) is not None]
    slips = Slips(seed_of(method.mechanism) ^ 0x51A11, 1000)
    drawn = Drawings.of(method, pencil_of(key.marking).times(STEP), slips).values(quantities)[0]
    off = np.where([entry.sort == "size" for entry in key.entries], np.abs(drawn), drawn) - [e.right for e in key.entries]
    angles = np.array([entry.sort == "angle" for entry in key.entries], dtype=bool)
    off = np.where(angles, off - 2 * np.pi * np.round(off / (2 * np.pi)), off)
    found: np.ndarray = np.sqrt(np.nanmean(off**2, axis=0)) / STEP
    return found


@pytest.mark.many
@pytest.mark.parametrize("place", PLACES)
def test_scatter_is_in_proportion_or_it_is_said(place: str) -> None:
    key, method = marker(place).key, marker(place).method
    for entry, first in zip(key.entries, to_first_order(method, key), strict=True):
        half = half_digit(entry.right, entry.unit, method.mechanism.usual.size(entry.unit))
        folded = entry.sort == "size" and abs(entry.right) < 3 * max(first, entry.scatter)  # not linear beside 0
        if not entry.doubt and not folded and max(first, entry.scatter) > 3 * half:
            assert first / WITHIN < entry.scatter < WITHIN * first, entry


@pytest.mark.parametrize("place", ["PRR 0", "relative_angle 1", pytest.param("p3-15", marks=pytest.mark.further)])
def test_a_dead_point_is_said_in_both_languages(place: str) -> None:
    found = tolerances(marker(place).key, marker(place).method)
    rows = {lang: "\n".join(tolerance_lines(found, lang)) for lang in ("en", "zh")}
    assert found.failed > 0.05
    assert "near a dead point: paper cannot tell this value" in rows["en"]
    assert "接近死点，图上无法确定该值" in rows["zh"]


def test_values_beyond_all_size_scatter_without_a_warning() -> None:
    drawn = np.array([[np.inf, 1.0], [np.inf, 1.1], [np.inf, 0.9]])
    assert np.isfinite(spread(drawn, np.array([np.inf, 1.0]), ("sense", "size"))).tolist() == [False, True]


@pytest.mark.parametrize(("place", "larger"), [("ex3-7", True), ("s3-shaper", False)])
def test_an_answer_that_no_problem_asks_is_named(place: str, larger: bool) -> None:
    """With the scales at which it might be asked, where there are any; no other asked answer is."""
    key, method = marker(place).key, marker(place).method
    found, usual = tolerances(key, method), method.mechanism.usual
    wide = [e.text for e in key.entries if e.points and part_off(e, usual.size(e.unit)) > TELLS]
    assert [*found.untold] == wide == ["alpha 4"]
    part, told = found.untold["alpha 4"]
    assert all(float(f"{scale:e}".partition("e")[0]) in SERIES for scale in (told or {}).values())  # as rulers have
    for lang, words in (("en", "`graphkin problems` asks no such value"), ("zh", "graphkin problems 不考查这样的量")):
        (line,) = (line for line in tolerance_lines(found, lang) if words in line)
        assert f"{part:.1%}" in line
        assert ("μ_v" in line) is larger
    data = tolerance_data(found)["quantities"]
    assert isinstance(data, dict)
    assert data["alpha 4"] == data["alpha 4"] | {"part": part, "told at scales": told}
    for scales in ({name: scale / 5 for name, scale in key.marking.scales.items()}, told):
        if scales is not None:
            entries = asked_alone(method, replay_all(method), marking_of(method, scales=scales))[1]
            assert (parts_off(method, entries)["alpha 4"] <= TELLS) is larger


def handed(one: Marker, factor: float) -> Iterator[tuple[KeyEntry, str, float]]:
    """What becomes of so many times each right value, handed in alone."""
    for entry in one.key.entries:
        if entry.right and ("/s" in entry.unit):
            (marked,) = one.mark([StudentWork("s", {entry.text: HandedNumber(factor * entry.right)})])
            verdict = next(judged for judged in marked.judged if judged.text == entry.text)
            yield entry, verdict.verdict, verdict.points * verdict.credit


@pytest.mark.many
@pytest.mark.parametrize("place", ["p3-15", "p3-3a", "p3-7", "ex3-2", "s2-2", "PRR 0", "cylinder 0", "relative_angle 1"])
@pytest.mark.parametrize("factor", [-1.9, 0.01, 1.9, 30.0, -600.0])
def test_nothing_is_right_for_a_tolerance_beyond_its_size(place: str, factor: float) -> None:
    untold = 0
    for entry, verdict, earned in handed(marker(place), factor):
        unsigned = entry.sort == "size" and abs(abs(factor) - 1) * abs(entry.right) <= entry.allowed
        assert unsigned or verdict != "right", entry
        assert verdict == "right" or earned <= 0.5, entry
        assert verdict != "dead point" or entry.doubt == "dead point"
        untold += verdict == entry.doubt != ""
    assert untold or abs(factor) > 2


@pytest.mark.parametrize("place", ["p3-15", "p3-3a", "PRR 0"])
def test_a_right_value_is_right_wherever_it_lies(place: str) -> None:
    assert all(verdict == "right" for _, verdict, _ in handed(marker(place), 1.001))


def test_where_paper_tells_nothing_there_is_no_score() -> None:
    (marked,) = marker("p3-15").mark([StudentWork("s", {"v C": HandedNumber(-1.6), "a C": HandedNumber(-250.0)})])
    assert [one.verdict for one in marked.judged] == ["dead point"] * 2
    assert marked.score is None


# --- the drawn mechanism ----------------------------------------------------------------------


@pytest.mark.parametrize("place", ["on_the_rim 10", "triad 0", "triad 5", "p3-15", "ex3-2", "s3-sieve", "p3-17"])
def test_a_drawing_stays_on_its_assembly(place: str) -> None:
    """As where the errors grow by so little at a time that nothing jumps."""
    method = plan(on_a_page(mechanism(place)))
    pencil, slips = pencil_of(marking_of(method)), Slips(seed_of(method.mechanism), 2000 if ALL else 500)
    near = method.near
    with np.errstate(all="ignore"):
        drawn = drawn_positions(method, pencil, slips)
        for part in np.linspace(0, 1, 41)[1:]:
            plot = replay(method.position, Plot(_on_paper(method, pencil.times(float(part)), slips), near))
            near = turned(method, plot)
    for point, place_ in drawn.position.items():
        there = np.isfinite(place_)
        assert np.abs(place_ - plot.position[point])[there] == pytest.approx(0, abs=1e-8 * method.size)


@pytest.mark.parametrize("place", ["ex3-1", "ex3-5", "s2-1b", "p3-3a", "ex3-2", "RRR 0", "RPR 1", "chain 1"])
def test_the_drawn_mechanism_scatters_as_one_whose_data_err(place: str) -> None:
    """Places of points: by the analysis of mechanisms with one datum each that is off, and by the pencil."""
    method = plan(on_a_page(mechanism(place)))
    pencil = pencil_of(marking_of(method)).times(1e-3)
    with np.errstate(all="ignore"):
        drawn = drawn_positions(method, pencil, Slips(seed_of(method.mechanism), 2000))
    machine = method.mechanism
    right = motion(machine).position
    off = [motion(other).position for other in erring(machine, pencil.lengths["position"], pencil.angle)]
    for point in machine.points:
        for part in (np.real, np.imag):
            first = np.sqrt(sum(float(part(places[point] - right[point])) ** 2 for places in off))
            values = part(np.broadcast_to(drawn.position[point], 2000))[:, None]
            (found,) = spread(values, np.array([float(part(right[point]))]), ["sense"])
            assert found == pytest.approx(first, rel=0.15, abs=1e-12), point


def erring(machine: Mechanism, length: float, angle: float) -> Iterator[Mechanism]:
    """Mechanisms with one datum off by what a pencil errs by: a point of a link, a guide's direction, a driver."""
    for name, link in machine.links.items():
        for k, point in enumerate([*link.points][1:]):
            for error in (length,) if name != "frame" and not k else (length, 1j * length):
                points = {**link.points, point: link.points[point] + error}
                yield replace(machine, links={**machine.links, name: replace(link, points=points)})
    for k, pair in enumerate(machine.pairs):
        if isinstance(pair, Slide):
            line = replace(pair.line, direction=pair.line.direction * np.exp(1j * angle))
            slide = replace(pair, line=line, tilt=pair.tilt - angle)  # the block is drawn along the guide's own axis
            yield replace(machine, pairs=(*machine.pairs[:k], slide, *machine.pairs[k + 1 :]))
    for k, driver in enumerate(machine.drivers):
        value = (driver.value or 0.0) + (length if driver.kind == "slide" else angle)
        yield replace(machine, drivers=(*machine.drivers[:k], replace(driver, value=value), *machine.drivers[k + 1 :]))


@pytest.mark.many
@pytest.mark.parametrize("place", PLACES)
def test_a_step_is_called_by_its_arrow(place: str) -> None:
    """Arrows of equations that are solved together have names, too, and none is that of a class."""
    held = marker(place)
    told = "\n".join(tolerance_lines(tolerances(held.key, held.method), "en"))
    assert not re.search(r"laying off (Normal|Tangential|Coriolis|Turning|Driven|Drawn|Relative)\b", told), told


def test_an_error_of_one_fitted_group_leaves_the_one_before_as_it_is() -> None:
    """Where one mark alone errs, a group that does not hang on it is drawn once for all drawings."""
    method = plan(on_a_page(triads(2)))
    pencil, every = pencil_of(marking_of(method)), Slips(1, 3)
    drawn_positions(method, pencil, every)
    for mark in every.seen:
        drawn = drawn_positions(method, pencil, Slips(1, 3, mark.__eq__))
        assert all(np.isfinite(place).any() for place in drawn.position.values()), mark


GEARS = """
ask = ["omega 3", "alpha 3", "omega 3/omega 1", "v C"]
frame = { A = [0, 0], D = [62.35, 0], E = [62.35, 60] }
links = { 1.AC = 15, 2.points = ["D"], 3.points = ["E"] }
gear = [{ links = ["1", "2"], centres = ["A", "D"], radii = [22.35, 40] }, { links = ["2", "3"], centres = ["D", "E"], radii = [40, 20] }]
driver = [{ vector = "AC", angle = 60, omega = 10, alpha = 3 }]
"""  # fmt: skip


@pytest.mark.parametrize(("of", "calculated"), [("train", {"alpha 2", "alpha 3"}), ("p3-12", set()), ("s4-ex5", set())])
def test_what_ratios_of_wheels_give_is_as_exact_as_its_figures(of: str, calculated: set[str]) -> None:
    """An angular acceleration where the arm stands still or is given; the polygon of velocities is drawn and measured, so
    whoever reads an angular velocity off it is right."""
    machine = loads(GEARS) if of == "train" else library.load(of)
    exact = set()
    for entry in key_for(on_a_page(machine)).entries:
        if entry.text.startswith(("omega", "alpha")) and entry.tolerance < 2 * half_digit(entry.right, entry.unit):
            exact.add(entry.text)
    assert exact == calculated
