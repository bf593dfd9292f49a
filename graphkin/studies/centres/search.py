"""Instant centres in the order a student finds them: by definition first, the rest by Kennedy's lines.

Source: Sun Huan, 机械原理, section 3-2.2: K = N(N-1)/2 centres (3-5), those of links that are joined directly, and
Kennedy-Aronhold's theorem. Each round of the search is a round of the circle diagram (消元法): a missing chord is found
when two triangles over it are complete but for it. Where two lines coincide another pair is taken; where no pair is
left (several freedoms, lines that coincide) one centre is taken from the velocities, and the lines go on from there.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from itertools import combinations

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot, replay
from graphkin.construction.drafting import (
    Board,
    Drafting,
    DraftMeet,
    Far,
    LineStep,
    Pricked,
    Stage,
    Through,
    Traced,
    draw,
    ruled,
)
from graphkin.construction.drafting.board import Homogeneous, product
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.studies.centres.underlay import (
    CommonNormal,
    board_over,
    contact_name,
    from_velocities,
    normals,
    pole_name,
)

CLEAR = 1e-3
"""Two lines that are less than this far from being one give no centre."""
WELL_APART = 0.05
"""Lines that are less than this far from being one are left for a later round."""

Pair = frozenset[str]


@frozen
class Centring:
    """How the centres of a mechanism are found, one stage each, in an order in which every line is known in time.

    A stage says "hinge", "contact" (wheels that roll on each other), "slide", "two lines" or "velocities".

    links       the two links of each centre, by its name
    normals     the lines that are common normals of two profiles, by name; every other line joins two centres
    together    pairs of links that do not move against each other: they have no centre
    """

    construction: Drafting
    links: Mapping[str, tuple[str, str]]
    normals: Mapping[str, CommonNormal]
    together: tuple[tuple[str, str], ...] = ()

    @property
    def stages(self) -> tuple[Stage, ...]:
        return self.construction.stages


def centre_name(mechanism: Mechanism, first: str, second: str) -> str:
    """`P13`; `P1,3'` where names are longer than one letter. The smaller number first."""
    names = sorted((mechanism.called(first), mechanism.called(second)), key=_by_number)
    comma = "" if all(len(name) == 1 for name in names) else ","
    return f"P{names[0]}{comma}{names[1]}"


@cache
def _by_number(name: str) -> tuple[float, str]:
    number = re.match(r"\d+", name)
    return (float(number[0]) if number else np.inf, name)


def in_order(mechanism: Mechanism, links: Iterable[str]) -> list[str]:
    """Links by their numbers."""
    return sorted(links, key=lambda link: _by_number(mechanism.called(link)))


def lines_to(mechanism: Mechanism, known: Mapping[Pair, str], pair: Iterable[str]) -> Iterator[LineStep]:
    """Every line on which the centre of two links lies, through the centres that are known by their links."""
    first, second = in_order(mechanism, pair)
    yield from (Traced(one.name, one.name) for one in normals(mechanism) if one.links == {first, second})
    for third in in_order(mechanism, mechanism.links):
        one, other = known.get(frozenset((first, third))), known.get(frozenset((third, second)))
        if one is not None and other is not None:
            yield Through(f"{one} {other}", one, other)


def search(method: Method, plot: Plot) -> tuple[Centring, Plot, Board]:
    """How all instant centres are found at the position of a plot, that plot in motion, and a board that holds them.

    Two lines that give a centre are chosen well apart for this position.
    """
    plot = _moving(method, plot)
    found = _CentreSearch(method, plot, board_over(method, plot))
    found.run()
    lines = {normal.name: normal for normal in normals(method.mechanism)}
    centring = Centring(Drafting({}, tuple(found.stages)), found.links, lines, tuple(found.missing))
    return centring, plot, found.board


def _moving(method: Method, plot: Plot) -> Plot:
    """The plot, with all drivers at 1 where none of them moves: centres do not need a speed."""
    if any(driver.rate for driver in method.drivers):
        return plot
    facts = replace(plot.facts, rates=tuple(1.0 for _ in method.drivers))
    return replay(method.velocity, replace(plot, facts=facts, velocity={}, omega={}, s_rate={}))


@dataclass
class _CentreSearch:
    """Centres found so far, by their pair of links.

    count   of centres that are known, by link
    tried   how many of its two links were known when a pair was last tried, and how clear its lines had to be
    lines   on which a missing one lies, by name
    """

    method: Method
    plot: Plot
    board: Board
    stages: list[Stage] = field(default_factory=list)
    links: dict[str, tuple[str, str]] = field(default_factory=dict)
    known: dict[Pair, str] = field(default_factory=dict)
    count: Counter[str] = field(default_factory=Counter)
    tried: dict[tuple[Pair, float], int] = field(default_factory=dict)
    lines: dict[Pair, dict[str, Homogeneous]] = field(default_factory=dict)

    @property
    def mechanism(self) -> Mechanism:
        return self.method.mechanism

    @cached_property
    def names(self) -> list[str]:
        return in_order(self.mechanism, self.mechanism.links)

    @property
    def missing(self) -> list[tuple[str, str]]:
        return [pair for pair in combinations(self.names, 2) if frozenset(pair) not in self.known]

    def run(self) -> None:
        for pair, stage in self._by_definition():
            if pair not in self.known:
                self.take(pair, stage)
        left: set[tuple[str, str]] = set()
        while any(pair not in left for pair in self.missing):
            if not any(self._round(clear) for clear in (WELL_APART, CLEAR)) and not self._pole(left):
                return

    def take(self, pair: Pair, stage: Stage) -> None:
        draw(stage, self.board)
        self.stages.append(stage)
        self.known[pair] = stage.last.name
        self.count.update(pair)
        self.lines.pop(pair, None)
        first, second = in_order(self.mechanism, pair)
        self.links[stage.last.name] = first, second

    def named(self, pair: Pair) -> str:
        first, second = pair
        return centre_name(self.mechanism, first, second)

    # --- by definition ------------------------------------------------------------------------

    def _by_definition(self) -> Iterator[tuple[Pair, Stage]]:
        """Hinges, sliding pairs, and contacts without sliding."""
        for hinge in self.mechanism.hinges:
            for two in map(frozenset, combinations(hinge.links, 2)):
                yield two, Stage("hinge", (Pricked(self.named(two), hinge.point),))
        for slide in self.mechanism.slides:
            if slide.block is not None:
                two = frozenset((slide.guide, slide.block))
                yield two, Stage("slide", (Traced(slide.name, slide.name), Far(self.named(two), slide.name)))
        for contact in self.method.structure.contacts:
            two = frozenset(contact.wheels)
            yield two, Stage("contact", (Pricked(self.named(two), contact_name(contact)),))

    # --- Kennedy's lines ----------------------------------------------------------------------

    def _round(self, clear: float) -> bool:
        """One round over the missing centres; whether any was found."""
        found = False
        for two in self.missing:
            pair = frozenset(two)
            if self._has_new_lines(pair, clear) and (stage := self._on_two_lines(pair, clear)) is not None:
                self.take(pair, stage)
                found = True
        return found

    def _has_new_lines(self, pair: Pair, clear: float) -> bool:
        """Whether it may be found now, though it was not before: there are more centres of its links."""
        before, now = self.tried.get((pair, clear)), self._joined(pair)
        self.tried[pair, clear] = now
        return before != now

    def _on_two_lines(self, pair: Pair, clear: float) -> Stage | None:
        """The two lines that are farthest from being one; the first two, where several are clear."""
        lines = [(line, self._ruled(pair, line)) for line in lines_to(self.mechanism, self.known, pair)]
        lines = [(line, place) for line, place in lines if np.isfinite(place).all()]
        if len(lines) < 2:
            return None
        first, second = np.triu_indices(len(lines), 1)
        places = np.array([place for _, place in lines]).T
        apart = np.linalg.norm(product(places[:, first], places[:, second]), axis=0)
        best = int(np.argmax(np.where(apart > clear, np.minimum(apart, 0.3), 0.0)))
        if not apart[best] > clear:
            return None
        one, other = lines[first[best]][0], lines[second[best]][0]
        return Stage("two lines", (one, other, DraftMeet(self.named(pair), one.name, other.name)))

    def _ruled(self, pair: Pair, line: LineStep) -> Homogeneous:
        drawn = self.lines.setdefault(pair, {})
        if line.name not in drawn:
            drawn[line.name] = ruled(line, self.board)
        return drawn[line.name]

    # --- from velocities ----------------------------------------------------------------------

    def _pole(self, left: set[tuple[str, str]]) -> bool:
        """One centre from velocities, of the pair that most lines wait for; pairs without relative motion are left."""
        waiting = [pair for pair in self.missing if pair not in left]
        waiting.sort(key=lambda pair: (FRAME not in pair, -self._joined(pair)))
        motions = readings(self.method, self.plot)
        for pair in waiting:
            place = from_velocities(self.board, motions, *pair)
            if np.isfinite(place).all():
                self.board.underlay.points[pole_name(*pair)] = place
                centre = self.named(frozenset(pair))
                self.take(frozenset(pair), Stage("velocities", (Pricked(centre, pole_name(*pair)),)))
                return True
            left.add(pair)
        return False

    def _joined(self, pair: Iterable[str]) -> int:
        """How many centres of either of two links are known."""
        return sum(self.count[link] for link in pair)
