"""A method, its plot and its scales at one position, with the names and the plain numbers of all they hold."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cached_property, partial
from itertools import combinations
from math import remainder, tau
from typing import TYPE_CHECKING

from graphkin.base.geometry import cross, dot
from graphkin.base.value import frozen
from graphkin.construction import Driven, LayOff, Plane, Plot, Step
from graphkin.errors import GraphkinError, Lang, listed
from graphkin.model.mechanism import FRAME, Driver, Mechanism, Pose, Usual
from graphkin.model.pairs import Cam, CircularSlot, Pair
from graphkin.model.quantities import Rotation, read
from graphkin.planning import Method, plan
from graphkin.planning.asked import plane_of
from graphkin.planning.at_rest import at_rest, steady_turnings
from graphkin.planning.images import radius_number
from graphkin.planning.labels import Labels
from graphkin.planning.method import Act, made
from graphkin.planning.needed import Fact, turnings
from graphkin.running import replay_all
from graphkin.say import names
from graphkin.say.catalogue import say_close
from graphkin.say.numbers import coordinates, degrees, direction, heading, number

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler


TOO_SHORT_MM = 0.5  # shorter lines are hardly seen on paper
_AXES = {"0°": "x", "180°": "x", "90°": "y", "270°": "y"}


def aside(along: complex, arm: complex) -> float:
    """The distance of the head of an arm from the line through its tail along a unit vector."""
    return abs(float(cross(along, arm)))


def capitalized(text: str) -> str:
    """A text as the start of a sentence."""
    return text[0].upper() + text[1:]


def driven_slides(method: Method) -> dict[tuple[str, str], str]:
    """The arrows that are laid off for driven slides: `v_B3B4` by `ṡ` or `s̈` and the slide."""
    arrows = dict[tuple[str, str], str]()
    for polygon in (method.velocity, method.acceleration):
        for term in (step.term for step in polygon.steps if isinstance(step, LayOff)):
            if isinstance(term.size, Driven) and term.size.slide in method.structure.slides_driven:
                arrows.setdefault((names.SLIDING[polygon.plane], term.size.slide), term.name(polygon.plane))
    return arrows


def driven_motions(method: Method, driver: Driver, point: str) -> Iterator[tuple[str, Plane, float]]:
    """The motions of a driven slide but for 0: its arrow, or that of the point that slides; plane and value [SI]."""
    arrows = driven_slides(method)
    rates: tuple[tuple[Plane, float], ...] = ("velocity", driver.rate), ("acceleration", driver.acceleration)
    for plane, value in rates:
        if value:
            yield arrows.get((names.SLIDING[plane], driver.link), f"{names.LETTER[plane]}_{point}"), plane, value


_ON, _NO_TURN = 0.05, 1e-9  # so far drivers are moved on [rad, or part of the size]; a link that turns less does not


def only_translates(method: Method, plot: Plot, link: str) -> bool:
    """True of a link that keeps its angle where the drivers are moved on: of a block, in a parallelogram."""
    moving = plan(method.mechanism)  # one that is shown may be drawn from poses
    reach = [method.size if driver.kind == "slide" else 1.0 for driver in method.drivers]
    for step in (_ON, -_ON):
        places = ([float(value + n * step * far) for value, far in zip(plot.facts.values, reach, strict=True)]
                  for n in (1, 2))  # fmt: skip
        try:
            turns = [float(replay_all(moving, values).theta[link] - plot.theta[link]) for values in places]
        except GraphkinError:  # a dead point is in between
            continue
        return all(abs(remainder(turn, tau)) <= _NO_TURN for turn in turns)
    return False


@frozen
class Reading:
    """A method and the plot of one position of it, about to be worded in one language.

    scales  "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s²)/mm]
    ruler   reads what is measured; exactly where there is none
    apart   every act is told by itself, though a driver at rest holds its points still
    """

    method: Method
    plot: Plot
    scales: Mapping[str, float]
    lang: Lang
    ruler: Ruler | None = None
    apart: bool = False

    @property
    def mechanism(self) -> Mechanism:
        return self.method.mechanism

    @cached_property
    def _acts(self) -> Mapping[tuple[Plane, tuple[str, ...] | Step], Act]:
        return {(act.plane, made(act.done) or act.done): act for act in self.method.acts}

    def act(self, plane: Plane, step: Step) -> Act | None:
        """The act of the pencil that a step finishes: by the point it finds, wherever it is told to start from."""
        return self._acts.get((plane, made(step) or step))

    @cached_property
    def rested(self) -> frozenset[Fact]:
        """Facts of both polygons that drivers at rest hold still."""
        return frozenset() if self.apart else at_rest(self.method, self.plot.facts)

    @cached_property
    def steady(self) -> frozenset[Fact]:
        """Angular accelerations that are nothing, as all turns and slides at steady rates."""
        return frozenset() if self.apart else steady_turnings(self.method, self.plot.facts)

    def say(self, key: str, /, **words: object) -> str:
        return say_close(key, self.lang, **words)

    def listed(self, parts: list[str]) -> str:
        """`A, B and C`."""
        return listed(parts, self.lang)

    def joined(self, parts: Iterable[str]) -> str:
        """`A, B, C`."""
        return self.say("common.and").join(parts)

    def note(self, text: str) -> str:
        """A text in brackets; nothing of none."""
        return self.say("common.note", note=text) if text else ""

    def too_short(self, length_mm: float) -> str:
        """A note on a length that is hardly seen; whether a detail shows it, only the sheet knows."""
        return self.say("derivation.too short") if 0 < length_mm < TOO_SHORT_MM else ""

    def sense(self, value: float) -> str:
        """The sense of a rotation in a word; nothing has no sense."""
        return self.say("common.ccw" if value > 0 else "common.cw") if value else ""

    def signed(self, value: float) -> str:
        """The meaning of the sign of a sum, in which counter-clockwise is positive; nothing has no sense."""
        return self.say("derivation.positive" if value > 0 else "derivation.negative") if value else ""

    def way_round(self, points: Iterable[str], ccw: bool) -> str:
        """`B→C→E counter-clockwise`: the sense in which corners follow one another."""
        return self.say("common.way round", way="→".join(map(names.point, points)), sense=self.sense(1 if ccw else -1))

    def body(self, link: str) -> str:
        """The link that turns as this body does: a pin turns with its slot."""
        structure = self.method.structure
        return structure.pins[link].guide if structure.is_pin(link) else link

    def link(self, link: str) -> str:
        """The name by which people call a link."""
        return names.point(self.mechanism.called(self.body(link)))

    def links(self, links: Iterable[str]) -> str:
        """`2, 3 and 4`."""
        return self.listed([self.link(link) for link in links])

    def rate(self, symbol: str, link: str) -> str:
        """`ω3` of a link, from the symbol and the link."""
        return names.of_link(symbol, self.mechanism.called(self.body(link)))

    def group(self, link: str) -> list[str]:
        """The other links that hold their angles to this one; the frame and pins are none."""
        turns, links = self.plot.facts.turns, self.mechanism.moving
        base = turns[link].base
        return [other for other in links if turns[other].base == base and other != self.body(link)]

    def stands(self, link: str) -> bool:
        """True where a driver at rest holds a link still."""
        owners, nodes = self.mechanism.owners, self.method.velocity.nodes
        sites = {name: node.site for name, node in nodes.items() if node.site is not None and node.site.link != FRAME}
        own = (name for name, site in sites.items() if link in (site.link, *owners.get(site.point, ())))
        still = all(("velocity", name) in self.rested for name in own)
        return still and self.rested.issuperset(turnings(self.method, "omega", link))

    def translates(self, link: str) -> bool:
        """True of a link that cannot turn at all; one that is idle turns as it likes."""
        turn = self.plot.facts.turns[link]
        return turn.base == FRAME and not turn.drivers and link not in self.mechanism.idle

    def against(self, driver: Driver | Pose, symbol: str) -> str:
        """The driven rotation: `ω1`, or `ω21` of a motor on a moving link."""
        called = self.mechanism.called
        if driver.from_link == FRAME:
            return names.of_link(symbol, called(driver.link))
        return names.relative(symbol, called(driver.link), called(driver.from_link))

    def relative_drivers(self, links: Iterable[str]) -> list[int]:
        """The numbers of the drivers that turn some of these links against others that move."""
        turns, drivers = self.plot.facts.turns, self.method.drivers
        return sorted({k for link in links for k, _ in turns[link].drivers if drivers[k].from_link != FRAME})

    def rotations(self, links: Iterable[str], symbol: str, relative: str = "") -> list[str]:
        """`ω1 = ω3 + ω13` of each driver between these links, from `ω`, and the symbol of ω13 if it is another."""
        drivers = [self.method.drivers[k] for k in self.relative_drivers(links)]
        sides = ((self.rate(symbol, d.link), self.rate(symbol, d.from_link), d) for d in drivers)
        return [f"{one} = {other} + {self.against(driver, relative or symbol)}" for one, other, driver in sides]

    def radius(self, link: str, size: float) -> str:
        """`r2` of a wheel, and `r2′` of the second gear of a compound one."""
        primes = "′" * radius_number(self.method, link, size) if size else ""
        return names.of_link("r", self.mechanism.called(link)) + primes

    @cached_property
    def circles(self) -> tuple[tuple[str, float], ...]:
        """The centre and the radius of each round profile, and of each circular slot."""
        profiles = [profile for cam in self.mechanism.of(Cam) for profile in cam.profiles]
        rounds = [(one.centre, one.radius) for one in profiles if one.centre is not None and one.radius]
        return (*rounds, *((slot.centre, slot.radius) for slot in self.mechanism.of(CircularSlot)))

    def rim(self, pair: Pair) -> str:
        """The radius of the circle that touches a line: of a wheel, or of a profile."""
        link, centre, size = pair.circles[-1]
        return self.circle(centre, size) if pair.rolling is None else self.radius(link, size)

    def circle(self, centre: str, size: float) -> str:
        """`r_P` of a profile or a circular slot about a point; `r_P′` of the next size there."""
        sizes = dict.fromkeys(round(radius, 12) for about, radius in self.circles if about == centre)
        return f"r_{names.point(centre)}" + "′" * [*sizes].index(round(size, 12))

    def numbered(self, point: str, link: str) -> str:
        """The point of a link as written where several links have one there: `B3`."""
        return Labels(self.method.structure, {}).numbered(point, self.body(link))

    @property
    def usual(self) -> Usual:
        """Usual sizes of this mechanism; what is far below is nothing."""
        return self.mechanism.usual

    @property
    def noise(self) -> float:
        """Lengths up to this are none [m]."""
        return self.usual.least("m")

    def at(self, point: str) -> complex:
        """The place of a point of the mechanism [m]."""
        return complex(self.plot.position[point])

    def arm(self, tail: str, head: str) -> complex:
        """The vector between two points of the mechanism [m]."""
        return complex(self.plot.arm(tail, head))

    def guide(self, slide: str) -> complex:
        """The unit vector of a slide's line."""
        return complex(self.plot.guide_direction(slide))

    def turning(self, link: str, plane: Plane) -> float:
        """omega or alpha of a link, as the plane has it, without noise."""
        table = self.plot.omega if plane == "velocity" else self.plot.alpha
        return float(self.usual.rate(float(table[link]), plane).real)

    def asked_turns(self, planes: Collection[Plane]) -> dict[Rotation, float]:
        """The asked rotations of links that turn, found in some polygons [rad/s, rad/s²]; of driven links none."""
        asked, driven = map(partial(read, self.mechanism), self.mechanism.ask), {d.link for d in self.mechanism.drivers}
        halves = (half for quantity in asked if quantity is not None for half in quantity.halves)
        turns = [half for half in halves if isinstance(half, Rotation) and half.link not in driven]
        moving = [(turn, plane) for turn in turns if (plane := plane_of(turn)) in planes and plane != "position"]
        return {turn: rate for turn, plane in moving if (rate := self.turning(turn.link, plane))}

    def sliding(self, slide: str, plane: Plane) -> float:
        """The rate of a displacement, or its rate again, as the plane has it, without noise."""
        table = self.plot.s_rate if plane == "velocity" else self.plot.s_acceleration
        return float(self.usual.motion(float(table[slide]), plane).real)

    def distance(self, first: str, second: str) -> float:
        """Between two points of the mechanism [m]; as the ruler reads it."""
        ruler = self.ruler
        length = float(ruler.distance(self.plot, first, second).real) if ruler else abs(self.arm(first, second))
        return length if length > self.noise else 0.0

    def measured(self, length: float) -> float:
        """A length of the mechanism, or a coordinate, that is read [m]."""
        return float(self.ruler.read(length, "position").real) if self.ruler else length

    def angle(self, vector: complex) -> str:
        """A measured direction."""
        return degrees(vector, self.ruler.angle) if self.ruler else degrees(vector)

    def heading(self, vector: complex) -> str:
        """The same from +x in words."""
        return heading(self.angle(vector), self.lang)

    def direction(self, vector: complex) -> float:
        """The same as a number [deg]."""
        return direction(vector, self.ruler.angle) if self.ruler else direction(vector)

    def on_paper(self, length: float) -> str:
        """A length of the mechanism in mm on paper, as a figure."""
        return number(length / self.scales["length"], self.noise / self.scales["length"])

    def place_on_paper(self, place: complex) -> str:
        """Coordinates on paper, in mm."""
        return coordinates(place / self.scales["length"], self.lang, self.noise / self.scales["length"])

    def slide_name(self, slide: str) -> str:
        """The name by which people call a named slide or roll."""
        return self.mechanism.slide_title(slide, self.lang)

    def displacement(self, symbol: str, slide: str) -> str:
        """The displacement of a slide, or of a wheel's centre, with its sign: `s_ram`, `ṡ_ram`, `Δs_C`."""
        pair = self.method.structure.slides[slide]
        return names.of_slide(symbol, pair.name if pair.named else names.point(pair.point))

    def slid(self, symbol: str, slide: str) -> str:
        """The size of a driven rate by its arrow: `v_B3B4`; else the displacement."""
        arrow = self._driven_slides.get((symbol, slide))
        return names.vector(arrow) if arrow else self.displacement(symbol, slide)

    @cached_property
    def _driven_slides(self) -> dict[tuple[str, str], str]:
        return driven_slides(self.method)

    @cached_property
    def contact_slides(self) -> frozenset[str]:
        """Slides that stand for a cam's slot or for the path of a rolling wheel's centre."""
        slides = self.method.structure.slides
        return frozenset(name for name, slide in slides.items() if slide.stands_for is not None)

    def line(self, slide: str) -> str:
        """The line of a slide: two points on it (`BC`), else the axis along which it runs, or `guide of C`."""
        pair = self.method.structure.slides[slide]
        along = self.guide(slide)  # two points that lie apart on it, of those that the guide or the pair itself names
        points = dict.fromkeys((pair.line.origin, pair.point, *self.method.structure.bodies[pair.guide]))
        there = [p for p in points if self.named(p) and aside(along, self.arm(pair.point, p)) <= self.noise]
        pairs = ((first, second) for first in there for second in there)
        apart = (ends for ends in pairs if abs(float(dot(along, self.arm(*ends)))) > self.noise)
        on_it = next(apart, None) or (None if pair.guide == FRAME else self.points_along(slide))
        if on_it is None and pair.guide == FRAME and (axis := _AXES.get(degrees(along))):
            return self.say("derivation.axis", axis=axis)
        if on_it is None and slide in self.contact_slides:
            rolling = pair.stands_for.rolling if pair.stands_for is not None else None
            if len(self.contact_slides) == 1:
                return self.say("contacts.track" if rolling else "contacts.face")
            link = rolling.wheels[1] if rolling else pair.guide
            return self.say("contacts.track of" if rolling else "contacts.face of", link=self.link(link))
        if on_it:
            return names.pair(*on_it)
        return self.say("derivation.guide of", point=names.point(pair.point))

    def path(self, slide: str) -> str:
        """The name that the line of a slide has in the drawing."""
        pair = self.method.structure.slides[slide]
        if slide in self.contact_slides:
            return self.say("contacts.path of", name=names.point(pair.point))
        if pair.guide != FRAME and not pair.named:
            return self.say("derivation.guide of link", link=self.link(pair.guide))
        return self.say("derivation.the guide of", point=names.point(pair.point))

    def points_along(self, slide: str) -> tuple[str, str] | None:
        """Two points of the guide whose line is parallel to the slide's."""
        structure, along = self.method.structure, self.guide(slide)
        for first, second in combinations(structure.named(structure.slides[slide].guide), 2):
            arm = self.arm(first, second)
            if aside(along, arm) <= self.noise < abs(arm):
                return first, second
        return None

    def place(self, point: str) -> str:
        """A point of the drawing; the start of a line that has no name of its own is told by its guide."""
        if self.named(point):
            return names.point(point)
        slide = next(each for each in self.method.structure.slides.values() if each.line.origin == point)
        if slide.name not in self.contact_slides:
            return self.say("derivation.origin of", point=names.point(slide.point))
        if slide.guide != FRAME:
            return names.point(point)
        return self.say("contacts.path start", path=self.path(slide.name))

    def named(self, point: str) -> bool:
        """True of a point that has a letter: it is not merely where a line begins."""
        return point not in self.mechanism.unnamed
