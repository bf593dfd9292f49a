"""The linkages that a mechanism holds: its loops of four links, measured at the drawn position.

A loop is the frame and three other links, joined by four lower pairs. A pin in a slot counts as a block of its own
between the pin and the slot's link.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import combinations, product

from graphkin.analytic import Motion, motion
from graphkin.base.geometry import number, place
from graphkin.base.value import frozen
from graphkin.errors import CannotClose, NoLinkage, OnlyStretched
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.family import Linkage
from graphkin.studies.linkages.four import FourBar
from graphkin.studies.linkages.guide import GuideBar
from graphkin.studies.linkages.linkage import DriverScale
from graphkin.studies.linkages.slider import SliderCrank
from graphkin.studies.linkages.triangles import even


@frozen
class FoundLinkage:
    """A linkage of a mechanism.

    links    names of its links in the order of its lengths, the frame (by the name people call it) last:
             crank, coupler, rocker; crank, rod, slider; crank, block (or bar), bar (or block)
    driven   by which motion comes in: "driver" (a driver of the file), "link" (a link that other links move),
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


@frozen
class LoopPair:
    """A pair of two links: at a point (a hinge), or a slide."""

    point: str = ""
    slide: Slide | None = None


@frozen
class LinkLoop:
    """Four links round about, the frame first; pair k joins link k and link k + 1."""

    links: tuple[str, str, str, str]
    pairs: tuple[LoopPair, ...]

    @property
    def slide(self) -> Slide | None:
        return next((pair.slide for pair in self.pairs if pair.slide is not None), None)


def pin_block(slide: Slide) -> str:
    """The name of the block between a pin and its slot; no link of a file can have it."""
    return f"{slide.name}:pin"


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
    linkages: list[FoundLinkage] = []
    while waiting:
        loop = next((loop for loop in waiting if _entry(loop, moved) or _driven_inside(mechanism, loop)), waiting[0])
        waiting.remove(loop)
        ring = _Ring(mechanism, now, loop, _entry(loop, moved))
        try:
            one = _measured(ring)
        except (CannotClose, OnlyStretched) as error:  # lengths that reach each other only just
            raise error.at(mechanism.where("links", loop.links[1])) from None
        if one is not None:
            before = next((other for other in linkages if ring.entry and other.output == ring.entry), None)
            turned = one.driven == "link" and one.linkage.driver in ("crank", "bar")
            linkages.append(replace(one, before=before) if before is not None and turned else one)
        moved |= set(loop.links[1:])
    return linkages


def some_found_in(mechanism: Mechanism) -> list[FoundLinkage]:
    """The same; raises NoLinkage where there is none."""
    if linkages := found_in(mechanism):
        return linkages
    raise NoLinkage(mechanism.where())


def loops(mechanism: Mechanism) -> Iterator[LinkLoop]:
    """Every loop of the frame and three other links with four hinges, or with three and a slide."""
    table = _pairs_between(mechanism)
    numbers = {link: k for k, link in enumerate(mechanism.links)}
    numbers |= {pin_block(slide): len(numbers) + k for k, slide in enumerate(mechanism.slides)}
    others = sorted({link for links in table for link in links if link != FRAME}, key=numbers.__getitem__)
    beside = [link for link in others if frozenset((FRAME, link)) in table]
    for first, last in combinations(beside, 2):
        for middle in others:
            links = (FRAME, first, middle, last)
            keys = [frozenset((links[k], links[(k + 1) % 4])) for k in range(4)]
            if middle in (first, last) or not all(key in table for key in keys):
                continue
            for pairs in product(*(table[key] for key in keys)):
                slides, points = [p for p in pairs if p.slide is not None], [p.point for p in pairs if p.slide is None]
                if len(slides) <= 1 and len(set(points)) == len(points):
                    yield LinkLoop(links, pairs)


def _pairs_between(mechanism: Mechanism) -> dict[frozenset[str], list[LoopPair]]:
    """The pairs between each two links."""
    pairs: dict[frozenset[str], list[LoopPair]] = {}

    def join(one: str, other: str, point: str = "", slide: Slide | None = None) -> None:
        if one != other:
            pairs.setdefault(frozenset((one, other)), []).append(LoopPair(point, slide))

    for hinge in mechanism.hinges:
        for one, other in combinations(hinge.links, 2):
            join(one, other, hinge.point)
    for slide in mechanism.slides:
        block = slide.block or pin_block(slide)
        join(slide.guide, block, slide=slide)
        for link in mechanism.owners[slide.point] if slide.block is None else ():
            join(link, block, slide.point)
    return pairs


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


def _driven_inside(mechanism: Mechanism, loop: LinkLoop) -> bool:
    """True if a driver acts inside the loop: on its coupler, or between two of its links."""
    return any(
        driver.link in loop.links[1:] or (loop.slide is not None and driver.link == loop.slide.name)
        for driver in mechanism.drivers
    )


def _drives(mechanism: Mechanism, link: str) -> bool:
    """True if a driver turns a link against the frame."""
    return any(driver.link == link and driver.from_link == FRAME for driver in mechanism.drivers)


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
        return tuple(place(self.now.position[name]) for name in self.names)

    def length(self, k: int) -> float:
        """A link's length from its own shape, which is exact where the file is."""
        one, other, link = self.loop.pairs[k - 1].point, self.loop.pairs[k].point, self.loop.links[k]
        points: Mapping[str, complex] = self.machine.links[link].points if link in self.machine.links else {}
        if one in points and other in points:
            return abs(points[other] - points[one])
        return abs(place(self.now.position[other]) - place(self.now.position[one]))

    @property
    def drives_middle(self) -> bool:
        """True if a driver turns the coupler, and nothing else drives."""
        return not self.entry and _drives(self.machine, self.loop.links[2])

    def turn_scale(self, k: int, ours: complex) -> DriverScale | None:
        """The count of a driven link's angle in the file; None where it does as we do, or no driver turns it."""
        for driver in self.machine.drivers:
            if driver.link == self.loop.links[k] and driver.vector is not None and driver.from_link == FRAME:
                tail, head = driver.vector
                counted = place(self.now.position[head]) - place(self.now.position[tail])
                return DriverScale(driver.name, cmath.phase(counted / ours))
        return None

    def slide_scale(self, slide: Slide, ours: float, sense: float) -> DriverScale:
        """The count of a slide in the file where its displacement is `ours` [m]."""
        return DriverScale(slide.name, number(self.now.s[slide.name]) - sense * ours, sense)


def _measured(ring: _Ring) -> FoundLinkage | None:
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
    return FoundLinkage(linkage, links, _driven_by(ring, linkage.driver in ("coupler", "slide")))


def _lengths_exist(*sizes: float) -> bool:
    return min(sizes) > 1e-9 * max(sizes)


def _four_bar(ring: _Ring) -> FourBar | None:
    places = ring.places
    sizes = ring.length(1), ring.length(2), ring.length(3), abs(places[3] - places[0])
    if not _lengths_exist(*sizes):
        return None
    if ring.drives_middle:
        return FourBar(*sizes, "coupler", ring.names, places)
    return FourBar(*sizes, "crank", ring.names, places, ring.turn_scale(1, places[1] - places[0]))


def _slider(ring: _Ring, slide: Slide) -> SliderCrank | None:
    """Pairs 0, 1, 2 are hinges, pair 3 is the slide between the last link and the frame."""
    a, b, c = ring.places
    along, sizes = ring.now.along(slide.line), (ring.length(1), ring.length(2))
    if not _lengths_exist(*sizes):
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
    along, sizes = ring.now.along(slide.line), (ring.length(1), abs(c - a))
    if not _lengths_exist(*sizes):
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


def _driven_by(ring: _Ring, inner: bool) -> str:
    """`FoundLinkage.driven`; inner: the driving part lies between moving links."""
    drivers, links, entry = ring.machine.drivers, {*ring.loop.links}, ring.entry
    if not entry and any(driver.from_link != FRAME and {driver.link, driver.from_link} < links for driver in drivers):
        return "pair"
    if inner or (entry and (_drives(ring.machine, entry) or any(_slid(ring.machine, d) == entry for d in drivers))):
        return "driver"
    return "link" if entry else "assumed"
