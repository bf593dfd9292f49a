"""The number of a step stands at what the step draws."""

from __future__ import annotations

from collections import defaultdict

import pytest
from library_sheets import drawing

from graphkin.construction import Image, LayOff, Meet
from graphkin.planning.drawn_position import shown
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import Label, point_label, vector_label
from graphkin.sheet.marks import Disc, PointMark, Text, VectorMark
from graphkin.sheet.mechanism_sheet import mechanism_sheet

FAR = 22.0  # no number beside a name is farther off that: long ones of several points stand between [mm]


def read(label: Label) -> str:
    return "".join(run.text for run in label)


def rings(page: Sheet) -> dict[int, complex]:
    """The numbers of a figure without equations, and where they stand."""
    texts = [(read(mark.label), mark.at) for mark in page.marks if isinstance(mark, Text)]
    discs = [mark for mark in page.marks if isinstance(mark, Disc) and mark.pen == "construction"]
    return {int(text): disc.centre for text, at in texts if text.isdigit() for disc in discs
            if abs(disc.centre - at) < disc.radius}  # fmt: skip


def polygon(name: str, plane: str) -> Sheet:
    """As in a handout, whose equations stand in the text."""
    own = drawing(name)
    return mechanism_sheet(own.method, own.plot, only=plane, tight=True, told=True)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["scotch-yoke", "ex3-1", "p3-16", "p3-22", "s3-four", "s4-ex6", "p3-17"])
@pytest.mark.parametrize("plane", ["velocity", "acceleration"])
def test_a_number_stands_at_its_own_arrow_or_point(name: str, plane: str) -> None:
    page = polygon(name, plane)
    places = defaultdict[str, list[complex]](list)
    for mark in page.marks:
        if isinstance(mark, PointMark):
            places[mark.name].append(mark.at)
        elif isinstance(mark, VectorMark):
            for arrow in (mark.name, *mark.also):
                places[arrow] += [mark.start + (mark.end - mark.start) * k / 10 for k in range(11)]
    names = {read(label(each)): each for each in places for label in (point_label, vector_label)}
    for mark in page.marks:
        if isinstance(mark, Text) and (named := names.get(read(mark.label).removeprefix(", "))):
            places[named].append(mark.at)
    found = rings(page)
    assert found
    for act in shown(drawing(name).method, drawing(name).plot)[0].acts:
        if act.plane != plane or act.number not in found:
            continue
        match act.done:
            case LayOff(term=term, tip=tip):
                own = [*places[term.name(act.plane)], *places[tip]]
            case Meet(point=point) | Image(point=point):
                own = places[point] + [at for mark in page.marks if isinstance(mark, VectorMark) and mark.step == act.page
                                       for at in places[mark.name]]  # fmt: skip
            case _:
                raise AssertionError(act)
        assert min(abs(found[act.number] - at) for at in own) < FAR, act.number


@pytest.mark.parametrize("name", ["scotch-yoke", "p3-16", "p3-22", "s4-ex6", "s4-ex1", "s4-ex4", "p3-14"])
@pytest.mark.parametrize("plane", ["velocity", "acceleration"])
def test_numbers_side_by_side_rise_as_one_reads(name: str, plane: str) -> None:
    at = rings(polygon(name, plane))
    rows = [(one, other) for one in at for other in at if 0 < (at[other] - at[one]).real < 4.5
            and abs((at[other] - at[one]).imag) < 0.1]  # fmt: skip
    assert all(one < other for one, other in rows)


@pytest.mark.parametrize("name", ["p3-17", "ex3-1", "p3-22"])
@pytest.mark.parametrize("plane", ["velocity", "acceleration"])
def test_a_number_stands_once(name: str, plane: str) -> None:
    """Also where its vector is drawn twice, and on a number's ring lies one number only."""
    marks = polygon(name, plane).marks
    discs = [mark.centre for mark in marks if isinstance(mark, Disc) and mark.pen == "construction"]
    found = [read(mark.label) for mark in marks if isinstance(mark, Text) and read(mark.label).isdigit()
             and any(abs(mark.at - centre) < 3 for centre in discs)]  # fmt: skip
    assert found
    assert len({*found}) == len(found)
