"""The mechanism with its instant centres: signs, Kennedy's lines, marks, names."""

from __future__ import annotations

from graphkin.sheet.centre_arrows import centre_arrows
from graphkin.sheet.centre_lines import centre_lines
from graphkin.sheet.centre_places import SAME, OnPaper, Spot, centre_label
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, joined
from graphkin.sheet.marks import Disc, Mark, PointMark
from graphkin.sheet.mechanism_figure import bare_figure, mechanism_places
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import HINGE
from graphkin.sheet.window import Figure, Window
from graphkin.studies.centres import Centres

_CIRCLE, _DOT = 1.0, 0.5
"""Radius of the circle and of the dot that mark a centre [mm]."""
_BETWEEN = ", "


def bare_mechanism(found: Centres, window: Window) -> Figure:
    """The mechanism as it stands there before the first centre."""
    skeleton = Skeleton(found.method.mechanism, found.plot, window, {})
    return bare_figure(found.method, skeleton).numbered(None)


def centre_figure(paper: OnPaper) -> Figure:
    """Lines first, the mechanism over them, then the marks of the centres and the arrows to those that have none."""
    lines, machine = centre_lines(paper), bare_mechanism(paper.found, paper.window)
    marks = [mark for spot in paper.spots if paper.shown(spot) for mark in _marked(paper, spot)]
    drawn = [*lines.marks, *machine.marks, *marks]
    arrows = centre_arrows(paper, drawn)
    wanted = [*machine.wanted, *_names(paper), *arrows.wanted, *lines.wanted]
    return Figure([*drawn, *arrows.marks], wanted)


def _marked(paper: OnPaper, spot: Spot) -> list[Mark]:
    """A small circle with a dot; over a hinge the dot alone shows."""
    at, step = paper.at(spot), spot.number
    dot = PointMark("centres", spot.name, spot.name, at, _DOT, step=step)
    hinges = (paper.window(place) for place in mechanism_places(paper.found.method, paper.found.plot))
    if any(abs(hinge - at) < _CIRCLE for hinge in hinges):
        return [dot]
    return [Disc(at, _CIRCLE, "thin", "paper", step=step), dot]


# --- names ------------------------------------------------------------------------------------


def _groups(paper: OnPaper) -> list[list[Spot]]:
    """Centres on the paper; those at one place together."""
    groups: list[list[Spot]] = []
    for spot in filter(paper.shown, paper.spots):
        for group in groups:
            if abs(paper.at(group[0]) - paper.at(spot)) < SAME:
                group.append(spot)
                break
        else:
            groups.append([spot])
    return groups


def _names(paper: OnPaper) -> list[LabelRequest]:
    """A label for each place, in which each name comes with its own step."""
    wanted: list[LabelRequest] = []
    for group in _groups(paper):
        label = joined([centre_label(spot.name) for spot in group], _BETWEEN)
        parts = tuple((_part(spot, k), spot.number) for k, spot in enumerate(group))
        wanted.append(LabelRequest(label, paper.at(group[0]), gap=HINGE, step=group[0].number, parts=parts))
    return wanted


def _part(spot: Spot, k: int) -> Label:
    return ((Run(_BETWEEN),) if k else ()) + centre_label(spot.name)
