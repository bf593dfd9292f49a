"""What reads a construction: the method, its plot and its scales, with the names of all they hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING

from graphkin.base.geometry import Value, cross, dot
from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot, Step
from graphkin.errors import Lang, listed
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Cam, CircularSlot, Pair
from graphkin.model.usual import Usual
from graphkin.planning import Method
from graphkin.planning.at_rest import at_rest
from graphkin.planning.labels import Labels
from graphkin.planning.method import Act, made
from graphkin.planning.needed import Fact, turnings
from graphkin.say import names
from graphkin.say.catalogue import say_close
from graphkin.say.numbers import degrees, direction, number

if TYPE_CHECKING:
    from graphkin.marking.ruler import Ruler


TOO_SHORT_MM = 0.5
"""Shorter lines are not drawn on paper."""


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

    def say(self, key: str, /, **words: object) -> str:
        return say_close(key, self.lang, **words)

    def too_short(self, length_mm: float) -> str:
        """A note on a length that no pencil draws."""
        return self.say("derivation.too short") if 0 < length_mm < TOO_SHORT_MM else ""

    def listed(self, parts: list[str]) -> str:
        return listed(parts, self.lang)

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
        """What drivers at rest hold still in both polygons."""
        return frozenset() if self.apart else at_rest(self.method, self.plot.facts)

    # --- links --------------------------------------------------------------------------------

    def body(self, link: str) -> str:
        """The link that turns as this body does: a pin turns with its slot."""
        structure = self.method.structure
        if not structure.is_pin(link):
            return link
        return structure.pins[link].guide

    def link(self, link: str) -> str:
        """What people call a link."""
        return names.point(self.mechanism.called(self.body(link)))

    def rate(self, symbol: str, link: str) -> str:
        """`ω3` of a link, from the symbol and the link."""
        return names.of_link(symbol, self.mechanism.called(self.body(link)))

    def signed(self, value: float) -> str:
        """What the sign of a sum means, in which counter-clockwise is positive; nothing has no sense."""
        return self.say("derivation.positive" if value > 0 else "derivation.negative") if value else ""

    def group(self, link: str) -> list[str]:
        """The other links that hold their angles to this one; the frame and pins are none."""
        turns, links = self.plot.facts.turns, self.mechanism.moving
        base = turns[link].base
        return [other for other in links if turns[other].base == base and other != self.body(link)]

    def stands(self, link: str) -> bool:
        """Whether a driver at rest holds a link still."""
        owners, nodes = self.mechanism.owners, self.method.velocity.nodes
        sites = {name: node.site for name, node in nodes.items() if node.site is not None and node.site.link != FRAME}
        own = (name for name, site in sites.items() if link in (site.link, *owners.get(site.point, ())))
        still = all(("velocity", name) in self.rested for name in own)
        return still and self.rested.issuperset(turnings(self.method, "omega", link))

    def translates(self, link: str) -> bool:
        """Whether a link cannot turn at all."""
        turn = self.plot.facts.turns[link]
        return turn.base == FRAME and not turn.drivers

    def against(self, driver: Driver, symbol: str) -> str:
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
        sizes: dict[float, None] = {}
        for contact in self.method.structure.contacts:
            pairs = zip(contact.wheels, contact.radii, strict=True)
            sizes |= {round(abs(radius), 12): None for wheel, radius in pairs if wheel == link and radius}
        primes = "′" * [*sizes, round(size, 12)].index(round(size, 12)) if size else ""
        return names.of_link("r", self.mechanism.called(link)) + primes

    @property
    def circles(self) -> tuple[tuple[str, float], ...]:
        """The centre and the radius of each round profile, and of each circular slot."""
        return tuple(_circles(self.mechanism))

    def rim(self, pair: Pair) -> str:
        """The radius of the circle that touches a line: of a wheel, or of a profile."""
        link, centre, size = pair.circles[-1]
        return self.circle(centre, size) if pair.rolling is None else self.radius(link, size)

    def circle(self, centre: str, size: float) -> str:
        """`r_P` of a profile or a circular slot about a point; `r_P′` of the next size there."""
        sizes = dict.fromkeys(round(radius, 12) for about, radius in self.circles if about == centre)
        return f"r_{names.point(centre)}" + "′" * [*sizes].index(round(size, 12))

    def way_round(self, points: tuple[str, ...], ccw: bool) -> str:
        """`B→C→E counter-clockwise`: the sense in which corners follow one another."""
        way = "→".join(names.point(point) for point in points)
        return self.say("common.way round", way=way, sense=self.say("common.ccw" if ccw else "common.cw"))

    def slide_name(self, slide: str) -> str:
        """What people call a named slide or roll."""
        return self.mechanism.slide_title(slide, self.lang)

    def numbered(self, point: str, link: str) -> str:
        """The point of a link as written where several links have one there: `B3`."""
        return Labels(self.method.structure, {}).numbered(point, self.body(link))

    # --- lengths of the mechanism --------------------------------------------------------------

    @property
    def usual(self) -> Usual:
        """What is usual here; what is far below is nothing."""
        return self.mechanism.usual

    @property
    def noise(self) -> float:
        """Lengths up to this are none [m]."""
        return self.usual.least("m")

    def distance(self, first: str, second: str) -> float:
        """Between two points of the mechanism [m]."""
        ruler = self.ruler
        length = float(ruler.distance(self.plot, first, second) if ruler else abs(self.plot.arm(first, second)))
        return length if length > self.noise else 0.0

    def measured(self, length: float) -> float:
        """A length of the mechanism, or a coordinate, that is read [m]."""
        return float(self.ruler.read(length, "position")) if self.ruler else length

    def angle(self, vector: Value) -> str:
        """A measured direction."""
        return degrees(vector, self.ruler.angle) if self.ruler else degrees(vector)

    def direction(self, vector: Value) -> float:
        """The same as a number [deg]."""
        return direction(vector, self.ruler.angle) if self.ruler else direction(vector)

    def on_paper(self, length: float) -> str:
        """A length of the mechanism in mm on paper, as a figure."""
        return number(length / self.scales["length"], self.noise / self.scales["length"])

    # --- slides ---------------------------------------------------------------------------------

    def line(self, slide: str) -> str:
        """The line of a slide: two points on it (`BC`), or `guide ram`."""
        pair = self.method.structure.slides[slide]
        if pair.named and pair.guide == FRAME and slide not in self.contact_slides:
            return self.say("derivation.guide of", name=self.slide_name(slide))
        on_it = self.points_on(slide) or (None if pair.guide == FRAME else self.points_along(slide))
        if on_it is None and slide in self.contact_slides:
            rolling = pair.stands_for.rolling if pair.stands_for is not None else None
            if len(self.contact_slides) == 1:
                return self.say("contacts.track" if rolling else "contacts.face")
            link = rolling.wheels[1] if rolling else pair.guide
            return self.say("contacts.track of" if rolling else "contacts.face of", link=self.link(link))
        if on_it:
            return names.pair(*on_it)
        return self.say("derivation.guide of", name=self.slide_name(slide) if pair.named else pair.point)

    @cached_property
    def contact_slides(self) -> frozenset[str]:
        """Slides that stand for a cam's slot or for the path of a rolling wheel's centre."""
        slides = self.method.structure.slides
        return frozenset(name for name, slide in slides.items() if slide.stands_for is not None)

    def path(self, slide: str) -> str:
        """What the line of a slide is called in the drawing."""
        pair = self.method.structure.slides[slide]
        if slide in self.contact_slides:
            return self.say("contacts.path of", name=names.point(pair.point))
        if pair.guide != FRAME and not pair.named:
            return self.say("derivation.guide of link", link=self.link(pair.guide))
        return self.say("derivation.guide of", name=self.slide_name(slide) if pair.named else names.point(pair.point))

    def points_along(self, slide: str) -> tuple[str, str] | None:
        """Two points of the guide whose line is parallel to the slide's."""
        return self.points_parallel(self.method.structure.slides[slide].guide, self.plot.guide_direction(slide))

    def points_parallel(self, link: str, along: Value) -> tuple[str, str] | None:
        """Two points of a link whose line is parallel to a direction."""
        points = self.method.structure.named(link)
        for first, second in combinations(points, 2):
            arm = self.plot.arm(first, second)
            if abs(cross(along, arm)) <= self.noise < abs(arm):
                return first, second
        return None

    def points_on(self, slide: str) -> tuple[str, str] | None:
        """Two points that lie apart on the line, of those that the guide or the pair itself names."""
        pair, along = self.method.structure.slides[slide], self.plot.guide_direction(slide)
        named = dict.fromkeys((pair.line.origin, pair.point, *self.method.structure.bodies[pair.guide]))
        on_it = [
            point
            for point in named
            if self.named(point) and abs(cross(along, self.plot.arm(pair.point, point))) <= self.noise
        ]
        for first in on_it:
            for second in on_it:
                if abs(dot(along, self.plot.arm(first, second))) > self.noise:
                    return first, second
        return None

    def place(self, point: str) -> str:
        """A point of the drawing; the start of a line that has no name of its own is told by its guide."""
        if self.named(point):
            return names.point(point)
        slides = self.method.structure.slides
        slide = next(s for s in slides.values() if s.line.origin == point)
        if slide.name in self.contact_slides:
            if slide.guide != FRAME:
                return names.point(point)
            return self.say("contacts.path start", path=self.path(slide.name))
        return self.say("derivation.origin of", name=self.slide_name(slide.name) if slide.named else slide.point)

    def named(self, point: str) -> bool:
        """Whether a point has a letter: it is not merely where a line begins."""
        return point not in self.mechanism.unnamed


def _circles(mechanism: Mechanism) -> Iterator[tuple[str, float]]:
    for cam in mechanism.of(Cam):
        yield from ((p.centre, p.radius) for p in cam.profiles if p.centre is not None and p.radius)
    for slot in mechanism.of(CircularSlot):
        yield slot.centre, slot.radius
