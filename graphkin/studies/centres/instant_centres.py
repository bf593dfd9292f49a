"""The instant centres of a mechanism at one position or at many, as plain data, and by the fewest lines."""

from __future__ import annotations

import cmath
from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import combinations
from typing import TypedDict

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Array, Value, number, weights_of
from graphkin.base.value import bulky
from graphkin.construction import Plot, replay
from graphkin.construction.drafting import Board, Drafting, DraftMeet, Stage, draw, drawn_through, ruled
from graphkin.construction.drafting.board import product
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.running.path import DriverPath, along, stride
from graphkin.studies.centres.search import (
    WELL_APART,
    Centring,
    board_over,
    centre_name,
    from_velocities,
    lines_to,
    pole_name,
    search,
)

LEAN = 0.02  # two lines that are less than this far from being one do not tell where they meet
BESIDE = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
ASIDE_DEG, ASIDE_PART = 0.05, 0.001
"""Neighbours of a change point, and how far apart they stand [deg, of the mechanism's size]."""
_MET, _FROM_VELOCITIES = 10, 1000
"""The price of a centre that is found by two lines, and of one that waits for the velocities; of others it is 1."""


@bulky
class Centres:
    """Instant centres: how they are found, the plot they are found over, and the board that holds them."""

    method: Method
    centring: Centring
    plot: Plot
    board: Board

    @property
    def names(self) -> list[str]:
        """Of all centres that there are, by the numbers of their links."""
        return [name for name in (self.name(*pair) for pair in self.pairs) if name in self.centring.links]

    @cached_property
    def pairs(self) -> tuple[tuple[str, str], ...]:
        """Every two links, N(N-1)/2 of them (3-5)."""
        called = self.method.mechanism.called

        def numbers(pair: tuple[str, str]) -> tuple[object, ...]:
            names = [called(link) for link in pair]
            return tuple((0, int(name), "") if name.isdecimal() else (1, 0, name) for name in names)

        return tuple(sorted((*self.centring.links.values(), *self.without), key=numbers))

    @property
    def without(self) -> dict[tuple[str, str], str]:
        """Every two links that have no centre, or none that is determined, and why: "together", "undetermined"."""
        centring = self.centring
        return dict.fromkeys(centring.together, "together") | dict.fromkeys(centring.undetermined, "undetermined")

    def name(self, first: str, second: str) -> str:
        return centre_name(self.method.mechanism, first, second)

    def place(self, first: str, second: str) -> Value:
        """Place of the centre of two links [m]; infinite at infinity, NaN where they do not move against each other."""
        return self.board.at(self.name(first, second)) if self.exists(first, second) else complex(np.nan, np.nan)

    def finite(self, first: str, second: str) -> complex | None:
        """The same; None at infinity, and where there is none."""
        place = complex(self.place(first, second))
        return place if cmath.isfinite(place) else None

    def exists(self, first: str, second: str) -> bool:
        """Two links have a centre that is determined."""
        return self.name(first, second) in self.board.points

    def together(self, first: str, second: str) -> bool:
        """True for two links that do not move against each other, and so have no centre."""
        return not self.exists(first, second) and not self.undetermined(first, second)

    def undetermined(self, first: str, second: str) -> bool:
        """True for two links of which an idle one turns against the other in a way that nothing says."""
        return not {(first, second), (second, first)}.isdisjoint(self.centring.undetermined)

    def direction(self, first: str, second: str) -> Value:
        """Direction in which a centre at infinity lies [rad]."""
        return self.board.direction(self.name(first, second))


@kept(2, objects=2)
def centres(method: Method, plot: Plot) -> Centres:
    """The instant centres at the position of a plot in which all three planes are drawn."""
    centring, plot, board = search(method, plot)
    return Centres(method, centring, plot, board)


# --- at many positions ------------------------------------------------------------------------


def over(centres: Centres, path: DriverPath, t: np.ndarray) -> Centres:
    """The same centres at other positions t (n,) on a path.

    Drivers move as the path goes, whatever their speeds are: with several of them the centres hang on that. At a change
    point velocities are 0/0 on paper: there the centres are what those beside it lead to.
    """
    there = _at_positions(centres, path, t)
    for change in path.changes:
        others = [abs(event.at - change.at) for event in (*path.changes, *path.stops) if event.at != change.at]
        aside = min(stride(centres.method, path.pace, ASIDE_DEG, ASIDE_PART), min(others, default=np.inf) / 10)
        rows = np.flatnonzero(np.abs(t - change.at) < aside * (1 - 1e-9))
        if rows.size:
            beside = _at_positions(centres, path, change.at + aside * BESIDE).board
            for name in (centres.name(*links) for links in centres.pairs):
                if name in beside.points:
                    _interpolate(there.board, beside, name, rows, (t[rows] - change.at) / aside, t.size)
    return there


def _interpolate(board: Board, beside: Board, name: str, rows: np.ndarray, x: np.ndarray, count: int) -> None:
    """Put one centre in at rows x asides from a change point (m,), from its neighbours (Lagrange)."""
    near = np.broadcast_to(beside.points[name].reshape(3, -1), (3, BESIDE.size))
    with np.errstate(divide="ignore", invalid="ignore"):
        near = near / np.linalg.norm(near, axis=0)
        near = near * np.where(np.sum(near * near[:, :1], axis=0) < 0, -1.0, 1.0)
    seen = np.array(np.broadcast_to(board.points[name].reshape(3, -1), (3, count)))
    seen[:, rows] = near @ weights_of(x, BESIDE).T
    board.points[name] = seen


def _at_positions(centres: Centres, path: DriverPath, t: np.ndarray) -> Centres:
    """The stages of the centres drawn at other positions.

    Lines that are chosen well apart for one position may run together elsewhere; there the centre is taken from
    velocities instead, and later centres go on from it.
    """
    method, centring = centres.method, centres.centring
    plot = along(method, path, t)
    plot = replace(plot, facts=replace(plot.facts, rates=path.pace))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        replay(method.velocity, plot)
        board, motions = board_over(method, plot), readings(method, plot)
        for stage in centring.stages:
            links = centring.links[stage.last.name]
            if stage.say == "velocities":
                board.underlay.points[pole_name(*links)] = from_velocities(board, motions, *links)
            draw(stage, board)
            centre = stage.last.name
            doubtful = ~(np.asarray(board.lean[centre]).real > LEAN) if centre in board.lean else False
            if np.any(doubtful):
                places: tuple[Array, Array] = from_velocities(board, motions, *links), board.points[centre]
                other, met = (place.reshape(3, -1) for place in places)
                better = doubtful & np.isfinite(other).all(axis=0)
                board.points[centre] = np.where(better, other, met)
        for links in centring.together:
            board.points[centres.name(*links)] = from_velocities(board, motions, *links)
    return Centres(method, centring, plot, board)


def carried_to(plot: Plot, link: str) -> tuple[Value, Value]:
    """The axes of a link: (origin [m], unit vector of its x axis)."""
    if link == FRAME:
        return 0j, 1.0
    turn = np.exp(1j * plot.theta[link])
    shape = plot.facts.shapes[link]
    point = next(name for name in shape if name in plot.position)
    return plot.position[point] - shape[point] * turn, turn


class CentreEntry(TypedDict, total=False):
    """A centre as data: its links, its place [m] or, at infinity, its direction [rad], and how it is found."""

    links: list[str]
    at: list[float]
    direction: float
    by: str | list[list[str]]


class CentresData(TypedDict):
    """All centres as data, by name."""

    format: int
    name: str
    centres: dict[str, CentreEntry]


def as_json(centres: Centres) -> CentresData:
    """One object: of each centre its links, its place [m] or direction [rad], and how it is found.

    `by` is "hinge", "contact" (wheels that roll on each other), "slide", "velocities", or the two lines: each two
    centres that it joins, or ["normal"]. Links that do not move against each other have "by": "together" and no place,
    those of which one is an idle roller "undetermined".
    """
    mechanism = centres.method.mechanism
    stages = {stage.last.name: stage for stage in centres.centring.stages}
    entries: dict[str, CentreEntry] = {}
    for first, second in centres.pairs:
        name, links = centres.name(first, second), [mechanism.called(first), mechanism.called(second)]
        if name in stages:
            by = centres.centring.found_by(stages[name])
            entries[name] = {"links": links, **place(centres, first, second), "by": by}
        else:
            entries[name] = {"links": links, "by": centres.without[first, second]}
    return {"format": 1, "name": mechanism.name, "centres": entries}


def place(centres: Centres, first: str, second: str) -> CentreEntry:
    """`at` [m], `direction` [rad] for a centre at infinity, nothing where there is none."""
    if not centres.exists(first, second):
        return {}
    cut = centres.method.mechanism.usual.cut
    at = complex(cut(centres.place(first, second), "m"))
    if np.isfinite(at):
        return {"at": [at.real + 0.0, at.imag + 0.0]}
    return {"direction": number(cut(centres.direction(first, second), "rad")) + 0.0}


# --- some of them, by the fewest lines --------------------------------------------------------


def shortest(centres: Centres, names: Collection[str]) -> Centring:
    """The centring with no more stages than lead to some centres, in their order.

    `search` finds all centres in the order of the circle diagram; for a few of them fewer lines do.
    """
    stages = _cheapest_stages(centres)
    needs = _all_needs(stages)
    needed = {name for one in names if one in stages for name in (one, *needs[one])}
    first_order = [*centres.centring.links]
    order = sorted(needed, key=lambda name: (len(needs[name]), first_order.index(name)))
    return replace(centres.centring, construction=Drafting({}, tuple(stages[name] for name in order)))


@kept(2)
def _cheapest_stages(centres: Centres) -> dict[str, Stage]:
    """By centre the stage that gives it: those by definition, then better and better ones until there are none."""
    stages = {stage.last.name: stage for stage in centres.centring.stages}
    direct = {name for name, stage in stages.items() if not isinstance(stage.last, DraftMeet)}
    prices = {name: _FROM_VELOCITIES if stages[name].say == "velocities" else 1 for name in direct}
    crossings = {name: _crossings(centres, name) for name in stages if name not in direct}

    def price(names: Collection[str]) -> int:
        return sum(prices.get(name, _MET) for name in names)

    needs = _all_needs(stages)
    for _ in stages:
        before = dict(stages)
        for name, others in crossings.items():
            for stage in others:
                needed = _needs(stage, needs)
                if name not in needed and price(needed) < price(needs[name]):
                    stages[name] = stage
                    needs = _all_needs(stages)
        if stages == before:
            break
    return stages


def _all_needs(stages: Mapping[str, Stage]) -> dict[str, frozenset[str]]:
    """By centre all those without which it is not found."""
    needs: dict[str, frozenset[str]] = {}
    waiting = dict(stages)
    while waiting:
        for name, stage in [*waiting.items()]:
            if _ends(stage) <= needs.keys():
                needs[name] = _needs(waiting.pop(name), needs)
    return needs


def _ends(stage: Stage) -> set[str]:
    """The centres that the lines of a stage join."""
    lines = stage.lines if isinstance(stage.last, DraftMeet) else ()
    return {end for line in lines for end in drawn_through(line)}


def _needs(stage: Stage, needs: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """All centres on which a stage hangs."""
    ends = _ends(stage)
    return frozenset(ends).union(*(needs[end] for end in ends))


def _crossings(centres: Centres, name: str) -> list[Stage]:
    """Every two lines that give a centre and lie well apart."""
    by_links = {frozenset(pair): each for each, pair in centres.centring.links.items()}
    lines = lines_to(centres.method.mechanism, by_links, centres.centring.links[name])
    rulings = [(line, ruling) for line in lines if np.isfinite(ruling := np.asarray(ruled(line, centres.board))).all()]
    return [
        Stage("two lines", (one, other, DraftMeet(name, one.name, other.name)))
        for (one, first), (other, second) in combinations(rulings, 2)
        if float(np.linalg.norm(product(first, second))) > WELL_APART
    ]
