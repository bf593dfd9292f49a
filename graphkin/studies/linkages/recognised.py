"""The linkages that a mechanism holds: found, measured at the drawn position, and told what drives them."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace

from graphkin.analytic import Motion, motion
from graphkin.base.value import frozen
from graphkin.errors import CannotClose, NoLinkage, OnlyStretched
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.equal import even
from graphkin.studies.linkages.four import FourBar
from graphkin.studies.linkages.guide import GuideBar
from graphkin.studies.linkages.linkage import DriverScale, Linkage
from graphkin.studies.linkages.loops import LinkLoop, loops, pin_block
from graphkin.studies.linkages.slider import SliderCrank


@frozen
class FoundLinkage:
    """A linkage of a mechanism.

    links    names of its links in the order of its lengths, the frame (by the name people call it) last:
             crank, coupler, rocker; crank, rod, slider; crank, block (or bar), bar (or block)
    driven   how motion comes in: "driver" (a driver of the file), "link" (a link that other links move),
             "pair" (a driver turns two moving links of the loop against each other), "assumed" (neither); in both
             these the shorter link on the frame, or the crank, is taken
    before   the linkage whose output is this one's driven link
    """

    linkage: Linkage
    links: tuple[str, ...]
    driven: str
    before: FoundLinkage | None = None

    @property
    def output(self) -> str:
        """The link on the frame that it turns; none where the output slides, or two links could be meant."""
        if self.linkage.driver not in ("crank", "bar", "slider"):
            return ""
        return {"crank": self.links[0], "rocker": self.links[2], "bar": self.links[2]}.get(self.linkage.output, "")


def found_in(mechanism: Mechanism) -> list[FoundLinkage]:
    """Every four-bar, slider-crank and guide bar that stands on the frame, in the order in which motion reaches them.

    Empty where there is none. Raises what the analysis raises for a mechanism that has no drawn position.
    """
    waiting = list(loops(mechanism))
    if not waiting:
        return []
    now = motion(mechanism)
    moved = {driver.link for driver in mechanism.drivers if driver.from_link == FRAME and driver.kind != "slide"}
    moved |= {_slid(mechanism, driver) for driver in mechanism.drivers if driver.kind == "slide"} - {""}
    found: list[FoundLinkage] = []
    while waiting:
        loop = next((loop for loop in waiting if _entry(loop, moved) or _inner(mechanism, loop)), waiting[0])
        waiting.remove(loop)
        ring = _Ring(mechanism, now, loop, _entry(loop, moved))
        if (one := _measured(ring)) is not None:
            found.append(_behind(one, found, ring.entry))
        moved |= set(loop.links[1:])
    return found


def _measured(ring: _Ring) -> FoundLinkage | None:
    """Lengths that reach each other only just are said at the first of their links."""
    try:
        return _found(ring)
    except (CannotClose, OnlyStretched) as error:
        raise error.at(ring.machine.where("links", ring.loop.links[1])) from None


def _behind(one: FoundLinkage, found: list[FoundLinkage], entry: str) -> FoundLinkage:
    """With the linkage that turns its driven link, where there is one."""
    before = next((other for other in found if entry and other.output == entry), None)
    if before is None or one.driven != "link" or one.linkage.driver not in ("crank", "bar"):
        return one
    return replace(one, before=before)


def some_found_in(mechanism: Mechanism) -> list[FoundLinkage]:
    """The same; raises NoLinkage where there is none."""
    if found := found_in(mechanism):
        return found
    raise NoLinkage(mechanism.where())


def _slid(mechanism: Mechanism, driver: Driver) -> str:
    """The link that a driven slide on the frame moves, or none."""
    slide = next((slide for slide in mechanism.slides if slide.name == driver.link), None)
    if slide is None:
        return ""
    block = slide.block or pin_block(slide)
    return block if slide.guide == FRAME else slide.guide if block == FRAME else ""


def _entry(loop: LinkLoop, moved: set[str]) -> str:
    """The link of the loop beside the frame that is moved from elsewhere; none where both or neither are."""
    beside = [link for link in (loop.links[1], loop.links[3]) if link in moved]
    return beside[0] if len(beside) == 1 else ""


def _inner(mechanism: Mechanism, loop: LinkLoop) -> bool:
    """Whether a driver acts inside the loop: on its coupler, or between two of its links."""
    return any(
        driver.link in loop.links[1:] or (loop.slide is not None and driver.link == loop.slide.name)
        for driver in mechanism.drivers
    )


@frozen
class _Ring:
    """A loop at the drawn position; `entry`: the link beside the frame that drives it, or none."""

    machine: Mechanism
    now: Motion
    loop: LinkLoop
    entry: str

    def turned(self) -> _Ring:
        """The same the other way round."""
        frame, first, middle, last = self.loop.links
        return replace(self, loop=LinkLoop((frame, last, middle, first), self.loop.pairs[::-1]))

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(pair.point for pair in self.loop.pairs if pair.slide is None)

    @property
    def places(self) -> tuple[complex, ...]:
        return tuple(complex(self.now.position[name]) for name in self.names)

    def length(self, k: int) -> float:
        """A link's length from its own shape, which is exact where the file is."""
        one, other, link = self.loop.pairs[k - 1].point, self.loop.pairs[k].point, self.loop.links[k]
        points: Mapping[str, complex] = self.machine.links[link].points if link in self.machine.links else {}
        if one in points and other in points:
            return abs(points[other] - points[one])
        return abs(complex(self.now.position[other]) - complex(self.now.position[one]))

    def along(self, slide: Slide) -> complex:
        """Direction of a slide's line."""
        return slide.line.direction * cmath.rect(1, float(self.now.theta[slide.guide]))

    @property
    def drives_middle(self) -> bool:
        """Whether a driver turns the coupler, and nothing else drives."""
        return not self.entry and _drives(self.machine, self.loop.links[2])

    def turn_scale(self, k: int, ours: complex) -> DriverScale | None:
        """How the file counts the angle of a driven link; None where it does as we do, or no driver turns it."""
        for driver in self.machine.drivers:
            if driver.link == self.loop.links[k] and driver.vector is not None and driver.from_link == FRAME:
                tail, head = driver.vector
                theirs = complex(self.now.position[head]) - complex(self.now.position[tail])
                return DriverScale(driver.name, cmath.phase(theirs / ours))
        return None

    def slide_scale(self, slide: Slide, ours: float, sense: float) -> DriverScale:
        """How the file counts a slide whose displacement is `ours` [m]."""
        return DriverScale(slide.name, float(self.now.s[slide.name]) - sense * ours, sense)


def _found(ring: _Ring) -> FoundLinkage | None:
    """The linkage of a loop, lettered from the link that drives it; None where a link of it has no length."""
    slide = ring.loop.slide
    if slide is None:
        shorter_last = ring.length(3) < ring.length(1)
        ring = ring.turned() if ring.entry == ring.loop.links[3] or (not ring.entry and shorter_last) else ring
        linkage: Linkage | None = _four_bar(ring)
    else:
        at = next(k for k, pair in enumerate(ring.loop.pairs) if pair.slide is not None)
        ring = ring.turned() if at in (0, 1) else ring
        linkage = _slider(ring, slide) if at in (0, 3) else _guide(ring, slide)
    if linkage is None:
        return None
    pins = {pin_block(slide): slide.point for slide in ring.machine.slides}
    links = (*(pins.get(link, link) for link in ring.loop.links[1:]), ring.machine.frame)
    return FoundLinkage(linkage, links, _how(ring, linkage.driver in ("coupler", "slide")))


def _real(*sizes: float) -> bool:
    return min(sizes) > 1e-9 * max(sizes)


def _four_bar(ring: _Ring) -> FourBar | None:
    places = ring.places
    sizes = ring.length(1), ring.length(2), ring.length(3), abs(places[3] - places[0])
    if not _real(*sizes):
        return None
    if ring.drives_middle:
        return FourBar(*sizes, "coupler", ring.names, places)
    return FourBar(*sizes, "crank", ring.names, places, ring.turn_scale(1, places[1] - places[0]))


def _slider(ring: _Ring, slide: Slide) -> SliderCrank | None:
    """Pairs 0, 1, 2 are hinges, pair 3 is the slide between the last link and the frame."""
    a, b, c = ring.places
    along, sizes = ring.along(slide), (ring.length(1), ring.length(2))
    if not _real(*sizes):
        return None
    driver = "slider" if ring.entry == ring.loop.links[3] else "coupler" if ring.drives_middle else "crank"
    own = (c - a) * along.conjugate()
    scale = None
    if driver == "slider":
        scale = ring.slide_scale(slide, own.real, 1.0 if slide.guide == FRAME else -1.0)
    elif driver == "crank":
        scale = ring.turn_scale(1, b - a)
    offset, block = even(own.imag, sum(sizes)), slide.guide != FRAME
    return SliderCrank(*sizes, offset, driver, ring.names, (a, b, c), cmath.phase(along), block, scale)


def _guide(ring: _Ring, slide: Slide) -> GuideBar | None:
    """Pairs 0, 1, 3 are hinges: the crank is link 1, pair 2 the slide, link 3 stands on the frame."""
    a, b, c = ring.places
    along, sizes = ring.along(slide), (ring.length(1), abs(c - a))
    if not _real(*sizes):
        return None
    block = slide.guide != ring.loop.links[3]
    own = (b - c) * along.conjugate()
    scale: DriverScale | None
    if not ring.entry and any(driver.link == slide.name for driver in ring.machine.drivers):
        driver, scale = "slide", ring.slide_scale(slide, own.real, -1.0 if block else 1.0)
    elif ring.entry == ring.loop.links[3]:
        driver, scale = "bar", ring.turn_scale(3, along)
    else:
        driver, scale = "crank", ring.turn_scale(1, b - a)
    offset = even(own.imag, sum(sizes))
    return GuideBar(*sizes, offset, driver, ring.names, (a, b, c), cmath.phase(along), block, scale)


def _drives(mechanism: Mechanism, link: str) -> bool:
    """Whether a driver turns a link against the frame."""
    return any(driver.link == link and driver.from_link == FRAME for driver in mechanism.drivers)


def _how(ring: _Ring, inner: bool) -> str:
    """inner: whether what drives lies between moving links."""
    drivers, links, entry = ring.machine.drivers, {*ring.loop.links}, ring.entry
    if not entry and any(driver.from_link != FRAME and {driver.link, driver.from_link} < links for driver in drivers):
        return "pair"
    if inner or (entry and (_drives(ring.machine, entry) or any(_slid(ring.machine, d) == entry for d in drivers))):
        return "driver"
    return "link" if entry else "assumed"
