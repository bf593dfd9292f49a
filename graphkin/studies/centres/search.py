"""Instant centres in the order a student finds them: by definition first, the rest by Kennedy's lines.

Source: Sun Huan, 机械原理, section 3-2.2: K = N(N-1)/2 centres (3-5), those of links that are joined directly, and
Kennedy-Aronhold's theorem. Each round of the search is a round of the circle diagram (消元法): a missing chord is found
when two triangles over it are complete but for it. Where two lines coincide another pair is taken; where no pair is
left (several freedoms, lines that coincide) one centre is taken from the velocities, and the lines go on from there.

Under the board lies the mechanism at its position, or at many at once. Its points are pricked through: hinges,
contacts, poles of links whose velocities are known; its lines traced: guides, common normals of profiles that touch.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from itertools import combinations

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Value
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.construction import AcrossGuide, Along, Plot, Ray, Touch, replay
from graphkin.construction.drafting import Board, Drafting, DraftMeet, Underlay, draw, ruled
from graphkin.construction.drafting.board import Homogeneous, balanced, product, reach
from graphkin.construction.drafting.steps import Far, LineStep, Pricked, Stage, Through, Traced, drawn_through
from graphkin.construction.pencil import touch
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Pair, Rod, Slot
from graphkin.planning import Method
from graphkin.planning.equivalent import Contact
from graphkin.proof.readings import readings


def contact_name(contact: Contact) -> str:
    """The board's name of the point in which wheels touch; no point of a mechanism has a name of two words."""
    return f"contact {contact.name}"


def pole_name(first: str, second: str) -> str:
    """The board's name of the pole of two links that is taken from velocities."""
    return f"pole {first} {second}"


Links = frozenset[str]


@frozen
class CommonNormal:
    """The common normal of two links that touch and slide in a pair, by its name on the board."""

    name: str
    pair: Pair
    links: frozenset[str]
    line: Ray


def board_over(method: Method, plot: Plot) -> Board:
    """An empty board over a plot; its coordinates are counted from a fixed point, in the mechanism's longest reach."""
    shapes, frame = plot.facts.shapes, plot.facts.frame
    fixed = next(iter(shapes[frame].values()), 0j)
    reaches = [abs(place - fixed) for place in shapes[frame].values()]
    reaches += [abs(place) for link, shape in shapes.items() if link != frame for place in shape.values()]
    board = Board(fixed, max(reaches) or 1.0)
    points = {name: board.seen(place) for name, place in plot.position.items()}
    for contact in method.structure.contacts:
        first, second = contact.centres
        if contact.slide:
            touching = Touch("", second, slide=contact.slide, offset=-contact.radii[1])
        else:
            touching = Touch("", first, second, contact.radii[0] / sum(contact.radii))
        points[contact_name(contact)] = board.seen(touch(touching, plot))
    lines = {name: board.sloping(board.origin, plot.guide_direction(name)) for name in plot.facts.lines}
    for one in normals(method.mechanism):
        lines[one.name] = board.sloping(plot.position[one.line.through], plot.direction(one.line.direction))
    board.underlay = Underlay(points, lines)
    return board


@kept(4)
def normals(mechanism: Mechanism) -> tuple[CommonNormal, ...]:
    """The common normals of profiles that touch and slide: of cams, and of pins in slots."""
    lines: list[tuple[Pair, Links, Ray]] = []
    for pair in mechanism.pairs:
        match pair.slipping:
            case None:
                pass
            case Rod(_, (first, second)):
                owners = itertools.product(mechanism.owners[first], mechanism.owners[second])
                ray = Ray(first, Along(first, second))
                lines += [(pair, frozenset(two), ray) for two in owners if two[0] != two[1]]
            case Slot(guide, point):
                across = Ray(point, AcrossGuide(pair.name))
                lines += [(pair, frozenset((guide.link, link)), across) for link in mechanism.owners[point]]
    return tuple(CommonNormal(f"normal {k}", *line) for k, line in enumerate(lines))


def from_velocities(board: Board, motions: Motions, first: str, second: str) -> Homogeneous:
    """The place where two links have one velocity, homogeneous; NaN where they do not move against each other.

    Each position is judged by its own pace: one that is broken does not spoil the others.
    Source: theoretical mechanics, x_P = x_O - v_y / omega, y_P = y_O + v_x / omega of the relative motion.
    """
    (one, turn), (other, other_turn) = (_motion(board, motions, link) for link in (first, second))
    moving, turning = one - other, turn - other_turn
    rates = [np.abs(value) for value in motions.omega.values()]
    pace = np.max(np.broadcast_arrays(*rates), axis=0) + np.abs(moving)
    turning = np.where(np.abs(turning) <= STILL * pace, 0.0, turning)
    across = 1j * np.where((np.abs(moving) <= STILL * pace) & (turning == 0), 0.0, moving)
    return balanced(np.array(np.broadcast_arrays(np.real(across), np.imag(across), turning)))


def _motion(board: Board, motions: Motions, link: str) -> tuple[Value, Value]:
    """Velocity of the link's place at the origin of coordinates, in units of size, and its rotation."""
    if link == FRAME:
        return 0j, 0.0
    point = next(name for name in motions.mechanism.links[link].points if name in motions.position)
    omega = motions.omega[link]
    velocity = motions.velocity_at(point, link) + 1j * omega * (board.origin - motions.position[point])
    return velocity / board.size, omega


CLEAR = 1e-3  # two lines that are less than this far from being one give no centre
PLAINLY_APART = 0.3  # of lines that are so far from being one the first are taken
WELL_APART = 0.05  # lines that are less than this far from being one are left for a later round


@frozen
class Centring:
    """The stages by which the centres of a mechanism are found, in an order in which every line is known in time.

    A stage says "hinge", "contact" (wheels that roll on each other), "slide", "two lines" or "velocities".

    links       the two links of each centre, by its name
    normals     the lines that are common normals of two profiles, by name; every other line joins two centres
    together    pairs of links that do not move against each other: they have no centre
    undetermined  pairs with an idle roller but for its hinge: how it turns, nothing says
    """

    construction: Drafting
    links: Mapping[str, tuple[str, str]]
    normals: Mapping[str, CommonNormal]
    together: tuple[tuple[str, str], ...] = ()
    undetermined: tuple[tuple[str, str], ...] = ()

    @property
    def stages(self) -> tuple[Stage, ...]:
        return self.construction.stages

    def found_by(self, stage: Stage) -> str | list[list[str]]:
        """A rule's name, or the two lines on which a centre lies: the centres that each joins, or ["normal"]."""
        if stage.say != "two lines":
            return stage.say
        return [["normal"] if line.name in self.normals else [*drawn_through(line)] for line in stage.lines]


def centre_name(mechanism: Mechanism, first: str, second: str) -> str:
    """`P13`; `P1,3'` where names are longer than one letter. The smaller number first, unless it is asked for by the
    other name."""
    names = sorted((mechanism.called(first), mechanism.called(second)), key=_by_number)
    comma = "" if all(len(name) == 1 for name in names) else ","
    usual, other = (f"P{one}{comma}{two}" for one, two in (names, names[::-1]))
    return other if other in mechanism.ask and usual not in mechanism.ask else usual


@cache
def _by_number(name: str) -> tuple[float, str]:
    number = re.match(r"\d+", name)
    return (float(number[0]) if number else np.inf, name)


def in_order(mechanism: Mechanism, links: Iterable[str]) -> list[str]:
    """Links by their numbers."""
    return sorted(links, key=lambda link: _by_number(mechanism.called(link)))


def lines_to(
    mechanism: Mechanism, centres: Mapping[Links, str], pair: Iterable[str], thirds: Iterable[str] = ()
) -> Iterator[LineStep]:
    """Every line on which the centre of two links lies, through the centres that are known by their links; `thirds`:
    the links by whose centres one may go, in order, if not by all."""
    first, second = in_order(mechanism, pair)
    yield from (Traced(one.name, one.name) for one in normals(mechanism) if one.links == {first, second})
    for third in thirds or in_order(mechanism, mechanism.links):
        one, other = centres.get(frozenset((first, third))), centres.get(frozenset((third, second)))
        if one is not None and other is not None:
            yield Through(f"{one} {other}", one, other)


def search(method: Method, plot: Plot) -> tuple[Centring, Plot, Board]:
    """The stages to all instant centres at the position of a plot, that plot in motion, and a board that holds them.

    Two lines that give a centre are chosen well apart for this position. All drivers move at 1 where none of them
    moves: centres do not need a speed.
    """
    if not any(driver.rate for driver in method.drivers):
        facts = replace(plot.facts, rates=tuple(1.0 for _ in method.drivers))
        plot = replay(method.velocity, replace(plot, facts=facts, velocity={}, omega={}, s_rate={}))
    state = _CentreSearch(method, plot, board_over(method, plot))
    state.run()
    lines = {normal.name: normal for normal in normals(method.mechanism)}
    without = tuple(state.missing), tuple(state.undetermined)
    centring = Centring(Drafting({}, tuple(state.stages)), state.links, lines, *without)
    return centring, plot, state.board


@dataclass
class _CentreSearch:
    """The centres of a search so far, by their pair of links.

    near    with which links the centres are known, by link: a bit for each of `names`
    tried   how many lines joined known centres when a pair was last tried, and how clear they had to be
    lines   on which a missing one lies, by name
    """

    method: Method
    plot: Plot
    board: Board
    stages: list[Stage] = field(default_factory=list)
    links: dict[str, tuple[str, str]] = field(default_factory=dict)
    centres: dict[Links, str] = field(default_factory=dict)
    near: Counter[str] = field(default_factory=Counter)
    tried: dict[tuple[Links, float], int] = field(default_factory=dict)
    lines: dict[Links, dict[str, Homogeneous]] = field(default_factory=dict)

    @property
    def mechanism(self) -> Mechanism:
        return self.method.mechanism

    @cached_property
    def names(self) -> list[str]:
        return in_order(self.mechanism, self.mechanism.links)

    @cached_property
    def _bits(self) -> dict[str, int]:
        return {name: 1 << k for k, name in enumerate(self.names)}

    @property
    def missing(self) -> list[tuple[str, str]]:
        return [pair for pair in self._without if not self._is_idle(pair)]

    @property
    def undetermined(self) -> list[tuple[str, str]]:
        return [pair for pair in self._without if self._is_idle(pair)]

    @property
    def _without(self) -> list[tuple[str, str]]:
        return [pair for pair in combinations(self.names, 2) if frozenset(pair) not in self.centres]

    def _is_idle(self, pair: tuple[str, str]) -> bool:
        return any(link in self.method.mechanism.idle for link in pair)

    def run(self) -> None:
        """All centres: by definition, then rounds of lines, and one from velocities where a round brings nothing."""
        for pair, stage in self._by_definition():
            if pair not in self.centres:
                self.take(pair, stage)
        left: set[tuple[str, str]] = set()
        while any(pair not in left for pair in self.missing):
            if not any(self._round(clear) for clear in (WELL_APART, CLEAR)) and not self._pole(left):
                return

    def take(self, pair: Links, stage: Stage) -> None:
        """Draw a stage; the centre that it gives is known from now on."""
        draw(stage, self.board)
        self.stages.append(stage)
        self.centres[pair] = stage.last.name
        self.lines.pop(pair, None)
        first, second = in_order(self.mechanism, pair)
        self.near[first] |= self._bits[second]
        self.near[second] |= self._bits[first]
        self.links[stage.last.name] = first, second

    def _by_definition(self) -> Iterator[tuple[Links, Stage]]:
        """Hinges, sliding pairs, and contacts without sliding."""
        machine = self.mechanism
        for hinge in machine.hinges:
            for two in combinations(hinge.links, 2):
                yield frozenset(two), Stage("hinge", (Pricked(centre_name(machine, *two), hinge.point),))
        for slide in machine.slides:
            if slide.block is not None:
                name = centre_name(machine, slide.guide, slide.block)
                stage = Stage("slide", (Traced(slide.name, slide.name), Far(name, slide.name)))
                yield frozenset((slide.guide, slide.block)), stage
        for contact in self.method.structure.contacts:
            first, second = contact.wheels
            name = centre_name(machine, first, second)
            yield frozenset((first, second)), Stage("contact", (Pricked(name, contact_name(contact)),))

    def _joined(self, pair: Iterable[str]) -> int:
        """The number of known centres of either of two links."""
        return sum(self.near[link].bit_count() for link in pair)

    def _round(self, clear: float) -> bool:
        """One round of Kennedy's lines over the missing centres; true if it gave any.

        A pair is tried again only where there are more lines to its centre than before.
        """
        any_new = False
        for two in self.missing:
            pair = frozenset(two)
            before, now = self.tried.get((pair, clear)), (self.near[two[0]] & self.near[two[1]]).bit_count()
            self.tried[pair, clear] = now
            if before != now and (stage := self._on_two_lines(pair, clear)) is not None:
                self.take(pair, stage)
                any_new = True
        return any_new

    def _on_two_lines(self, pair: Links, clear: float) -> Stage | None:
        """The two lines that are farthest from being one; the first two that are clear, as one would rule them."""
        ruled_lines = self.lines.setdefault(pair, {})
        lines: list[LineStep] = []
        for line in lines_to(self.mechanism, self.centres, pair, self._between(*pair)):
            if line.name not in ruled_lines:
                ruled_lines[line.name] = ruled(line, self.board)
            if np.isfinite(ruled_lines[line.name]).all():
                lines.append(line)
                crossing = product(ruled_lines[lines[0].name], ruled_lines[line.name])
                if reach(crossing) >= PLAINLY_APART:
                    return self._crossing(pair, lines[0], line)
        if len(lines) < 2:
            return None
        first, second = np.triu_indices(len(lines), 1)
        places = np.array([ruled_lines[line.name] for line in lines]).T
        apart = reach(product(places[:, first], places[:, second]))
        best = int(np.argmax(np.where(apart > clear, np.minimum(apart, PLAINLY_APART), 0.0)))
        return self._crossing(pair, lines[first[best]], lines[second[best]]) if apart[best] > clear else None

    def _between(self, first: str, second: str) -> Iterator[str]:
        """The links with which the centres of both are known, in order."""
        bits = self.near[first] & self.near[second]
        while bits:
            yield self.names[(bits & -bits).bit_length() - 1]
            bits &= bits - 1

    def _crossing(self, pair: Links, one: LineStep, other: LineStep) -> Stage:
        return Stage("two lines", (one, other, DraftMeet(centre_name(self.mechanism, *pair), one.name, other.name)))

    def _pole(self, left: set[tuple[str, str]]) -> bool:
        """One centre from velocities, of the pair that most lines wait for; pairs without relative motion are left."""
        waiting = [pair for pair in self.missing if pair not in left]
        waiting.sort(key=lambda pair: (FRAME not in pair, -self._joined(pair)))
        motions = readings(self.method, self.plot)
        for pair in waiting:
            place = from_velocities(self.board, motions, *pair)
            if np.isfinite(place).all():
                pole = pole_name(*pair)
                self.board.underlay.points[pole] = place
                self.take(frozenset(pair), Stage("velocities", (Pricked(centre_name(self.mechanism, *pair), pole),)))
                return True
            left.add(pair)
        return False
