"""Polygons drawn on a sheet are measured where they truly are, and named by what was drawn; pages without any camera."""

from __future__ import annotations

import pytest
from assess_photos import Case, assessed, verdicts, work_of
from pencil import HAND, NEAT, FlatPage, Work, paper_of

from graphkin.construction import Plane
from graphkin.files import library
from graphkin.photo.measuring import PageReading, measured
from graphkin.photo.predicted import PredictedCorner, own_velocities, predicted
from graphkin.photo.readings import RoomReading


def readings_of(work: Work) -> dict[Plane, PageReading]:
    """Both polygons, the second one by the own velocities."""
    page, drawing, velocity, found = FlatPage(work.page()), work.paper.problem.drawing, dict[str, PredictedCorner](), {}
    for plane, room in work.paper.rooms.items():
        found[plane] = one = measured(page, room, predicted(drawing.method, drawing.plot, room, velocity))
        velocity = own_velocities(RoomReading(room, one.vertices, error=one.error, unsure=one.unsure))
    return found


def worst(work: Work, found: dict[Plane, PageReading]) -> float:
    """By how much a corner is off that is not told as unsure [mm]."""
    off = [0.0]
    for plane, reading in found.items():
        left = {letter for one in reading.unsure for letter in one.letters or reading.vertices}
        off += [abs(at - work.corners[plane][letter]) for letter, at in reading.vertices.items() if letter not in left]
    return max(off)


@pytest.mark.parametrize(("name", "seed"), [pytest.param("ex3-1", 3, marks=pytest.mark.further), pytest.param("fig3-1", 4, marks=pytest.mark.further), ("ex3-4", 1029)])
def test_right_work_is_called_right(name, seed):
    """In ex3-4 the pole is found last."""
    work = Work(paper_of(name), seed, habits=NEAT)
    found = readings_of(work)
    assert worst(work, found) < 0.35
    assert verdicts(work, found) == (False, set())
    sure = [letter for reading in found.values() for letter in reading.vertices]
    unsure = [letter for reading in found.values() for one in reading.unsure for letter in one.letters]
    assert len(unsure) < len(sure) / 3


@pytest.mark.parametrize(("name", "seed"), [
    ("ex3-1", 1024), pytest.param("ex3-7", 1003, marks=pytest.mark.further), ("p3-3a", 1030),
    *(pytest.param("p3-3a", seed, marks=pytest.mark.further) for seed in (1020, 1284, 1032)),
])  # fmt: skip
def test_a_mistake_is_named(name, seed):
    work = work_of(name, "mistake", seed, wobble=True)
    assert work.habits is HAND
    found = readings_of(work)
    assert work.mistakes[0].name[0] in verdicts(work, found)[1]
    assert worst(work, found) < 0.5


@pytest.mark.parametrize(("name", "seed", "wobble"), [("s4-ex2", 1077, False), pytest.param("ex3-5", 1049, False, marks=pytest.mark.further), ("ex3-1", 1228, True)])
def test_a_slip_is_seen(name, seed, wobble):
    """An arrow of half its length, where a mistake has more of the ink; slips after velocities that are not quite sure."""
    work = work_of(name, "slip", seed, wobble)
    found = readings_of(work)
    assert verdicts(work, found)[0]
    assert worst(work, found) < 0.5


@pytest.mark.parametrize(("scale", "most"), [(0.015, 0.25), pytest.param(0.02, 0.3, marks=pytest.mark.further)])
def test_an_arrow_along_the_printed_line_is_drawn(scale, most, tmp_path):
    """The line through the pole hides it, all of it or all but some."""
    path = tmp_path / "s4-ex2.toml"
    path.write_text(f"{library.load('s4-ex2').text}\n[scales]\nvelocity = {scale}\n", encoding="utf-8")
    work = work_of(str(path), "mistake", Case("s4-ex2", "mistake", 1015, False).seed, wobble=False)
    found = readings_of(work)
    assert all(0 < one.off < most for one in found["velocity"].unsure)
    assert worst(work, found) < 0.35


@pytest.mark.parametrize(("name", "kind", "seed", "wobble"), [
    ("ex3-5", "right", 1205, True), ("p3-15", "mistake", 1220, False), ("s4-ex2", "mistake", 1063, False),
])  # fmt: skip
def test_what_is_misread_is_said(name, kind, seed, wobble):
    """Strokes that run side by side, of which one has no line of its own; an arrow cut off by the rim of its room; one
    along a line that goes on."""
    work = work_of(name, kind, seed, wobble=wobble)
    assert worst(work, readings_of(work)) < 0.5


@pytest.mark.parametrize("case", [
    Case("s4-ex2", "slip", 1007, True), pytest.param(Case("s4-ex2", "slip", 1009, True, "fine"), marks=pytest.mark.further),
])  # fmt: skip
def test_points_that_may_be_exchanged_are_not_sure(case):
    """An arrow or a line drawn otherwise, so that a and b may each be the other, one of them beside its lines."""
    found = assessed(case)
    assert found.silent < 0.5
    assert {"v:alikea", "v:alikeb"} <= {*found.reasons} or case.camera == "fine"


def test_paper_without_a_drawing_is_blank():
    paper = paper_of("ex3-1")
    drawing, (room, *_) = paper.problem.drawing, paper.rooms.values()
    found = measured(FlatPage(paper.light), room, predicted(drawing.method, drawing.plot, room))
    assert [one.reason for one in found.unsure] == ["blank"]
    assert not found.vertices
