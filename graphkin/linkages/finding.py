"""The linkages that a mechanism holds: found, measured at the drawn position, and told what drives them."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace

from graphkin.analytic import Motion, motion
from graphkin.errors import NoLinkage
from graphkin.linkages.equal import even
from graphkin.linkages.four import FourBar
from graphkin.linkages.guide import GuideBar
from graphkin.linkages.linkage import Linkage, Scale
from graphkin.linkages.loops import Loop, loops, pin_block
from graphkin.linkages.slider import SliderCrank
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.value import frozen


@frozen
class Found:
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
    before: Found | None = None

    @property
    def output(self) -> str:
        """The link on the frame that it turns; none where the output slides, or two links could be meant."""
        if self.linkage.driver not in ("crank", "bar", "slider"):
            return ""
        return {"crank": self.links[0], "rocker": self.links[2], "bar": self.links[2]}.get(self.linkage.output, "")


def found_in(mechanism: Mechanism) -> list[Found]:
    """Every four-bar, slider-crank and guide bar that stands on the frame, in the order in which motion reaches them.

    Empty where there is none. Raises what the analysis raises for a mechanism that has no drawn position.
    """
    rings = list(loops(mechanism))
    if not rings:
        return []
    now = motion(mechanism)
    moved = {driver.link for driver in mechanism.drivers if driver.from_link == FRAME and driver.kind != "slide"}
    moved |= {_slid(mechanism, driver) for driver in mechanism.drivers if driver.kind == "slide"} - {""}
    found: list[Found] = []
    while rings:
        loop = next((ring for ring in rings if _entry(ring, moved) or _inner(mechanism, ring)), rings[0])
        rings.remove(loop)
        if (one := _found(mechanism, now, loop, moved)) is not None:
            found.append(_behind(one, found, _entry(loop, moved)))
        moved |= set(loop.links[1:])
    return found


def _behind(one: Found, found: list[Found], entry: str) -> Found:
    """With the linkage that turns its driven link, where there is one."""
    before = next((other for other in found if entry and other.output == entry), None)
    if before is None or one.driven != "link" or one.linkage.driver not in ("crank", "bar"):
        return one
    return replace(one, before=before)


def some_found_in(mechanism: Mechanism) -> list[Found]:
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


def _entry(loop: Loop, moved: set[str]) -> str:
    """The link of the loop beside the frame that is moved from elsewhere; none where both or neither are."""
    beside = [link for link in (loop.links[1], loop.links[3]) if link in moved]
    return beside[0] if len(beside) == 1 else ""


def _inner(mechanism: Mechanism, loop: Loop) -> bool:
    """Whether a driver acts inside the loop: on its coupler, or between two of its links."""
    return any(
        driver.link in loop.links[1:] or (loop.slide is not None and driver.link == loop.slide.name)
        for driver in mechanism.drivers
    )


def _found(mechanism: Mechanism, now: Motion, loop: Loop, moved: set[str]) -> Found | None:
    """The linkage of a loop, lettered from the link that drives it."""
    entry = _entry(loop, moved)
    if loop.slide is None:
        return _four_bar(mechanism, now, loop, entry)
    at = next(k for k, pair in enumerate(loop.pairs) if pair.slide is not None)
    if at in (0, 3):
        return _slider(mechanism, now, loop if at == 3 else _turned(loop), entry)
    return _guide(mechanism, now, loop if at == 2 else _turned(loop), entry)


def _turned(loop: Loop) -> Loop:
    """The same loop the other way round."""
    frame, first, middle, last = loop.links
    return Loop((frame, last, middle, first), loop.pairs[::-1])


def _places(now: Motion, loop: Loop) -> list[complex]:
    return [complex(now.position[pair.point]) for pair in loop.pairs if pair.slide is None]


def _names(loop: Loop) -> tuple[str, ...]:
    return tuple(pair.point for pair in loop.pairs if pair.slide is None)


def _four_bar(mechanism: Mechanism, now: Motion, loop: Loop, entry: str) -> Found | None:
    if entry == loop.links[3] or (not entry and _longer_last(mechanism, now, loop)):
        loop = _turned(loop)
    places = _places(now, loop)
    crank, coupler, rocker = (_length(mechanism, now, loop, k) for k in (1, 2, 3))
    frame = abs(places[3] - places[0])
    if min(crank, coupler, rocker, frame) <= 1e-9 * max(crank, coupler, rocker, frame):
        return None
    inner = not entry and _drives(mechanism, loop.links[2])
    driver = "coupler" if inner else "crank"
    bar = FourBar(crank, coupler, rocker, frame, driver, _names(loop), tuple(places))
    bar = bar if inner else replace(bar, scale=_turn_scale(mechanism, now, loop.links[1], places[1] - places[0]))
    return Found(bar, _called(mechanism, loop), _how(mechanism, loop, entry, inner))


def _length(mechanism: Mechanism, now: Motion, loop: Loop, k: int) -> float:
    """A link's length from its own shape, which is exact where the file is."""
    one, other = loop.pairs[k - 1].point, loop.pairs[k].point
    points: Mapping[str, complex] = mechanism.links[loop.links[k]].points if loop.links[k] in mechanism.links else {}
    if one in points and other in points:
        return abs(points[other] - points[one])
    return abs(complex(now.position[other]) - complex(now.position[one]))


def _longer_last(mechanism: Mechanism, now: Motion, loop: Loop) -> bool:
    """Whether the last link is the shorter of the two on the frame: it would be called the crank."""
    return _length(mechanism, now, loop, 3) < _length(mechanism, now, loop, 1)


def _slider(mechanism: Mechanism, now: Motion, loop: Loop, entry: str) -> Found | None:
    """Pairs 0, 1, 2 are hinges, pair 3 is the slide between the last link and the frame."""
    slide = loop.slide
    assert slide is not None
    a, b, c = _places(now, loop)
    along = _along(mechanism, now, loop)
    sizes = _length(mechanism, now, loop, 1), _length(mechanism, now, loop, 2)
    if min(sizes) <= 1e-9 * max(sizes):
        return None
    inner = not entry and _drives(mechanism, loop.links[2])
    driver = "slider" if entry == loop.links[3] else "coupler" if inner else "crank"
    own = ((c - a) * along.conjugate()).real
    scale = None
    if driver == "slider":
        sense = 1.0 if slide.guide == FRAME else -1.0
        scale = Scale(slide.name, float(now.s[slide.name]) - sense * own, sense)
    elif driver == "crank":
        scale = _turn_scale(mechanism, now, loop.links[1], b - a)
    offset = even(((c - a) * along.conjugate()).imag, sum(sizes))
    linkage = SliderCrank(
        *sizes, offset, driver, _names(loop), (a, b, c), cmath.phase(along), slide.guide != FRAME, scale,
    )  # fmt: skip
    return Found(linkage, _called(mechanism, loop), _how(mechanism, loop, entry, inner))


def _guide(mechanism: Mechanism, now: Motion, loop: Loop, entry: str) -> Found | None:
    """Pairs 0, 1, 3 are hinges: the crank is link 1, pair 2 the slide, link 3 stands on the frame."""
    slide = loop.slide
    assert slide is not None
    a, b, c = _places(now, loop)
    along = _along(mechanism, now, loop)
    sizes = _length(mechanism, now, loop, 1), abs(c - a)
    if min(sizes) <= 1e-9 * max(sizes):
        return None
    block, inner = slide.guide != loop.links[3], not entry and any(d.link == slide.name for d in mechanism.drivers)
    driver = "slide" if inner else "bar" if entry == loop.links[3] else "crank"
    if driver == "crank":
        scale = _turn_scale(mechanism, now, loop.links[1], b - a)
    elif driver == "bar":
        scale = _turn_scale(mechanism, now, loop.links[3], along)
    else:
        own, sense = ((b - c) * along.conjugate()).real, -1.0 if block else 1.0
        scale = Scale(slide.name, float(now.s[slide.name]) - sense * own, sense)
    linkage = GuideBar(
        *sizes, even(((b - c) * along.conjugate()).imag, sum(sizes)), driver, _names(loop), (a, b, c),
        cmath.phase(along), block, scale,
    )  # fmt: skip
    return Found(linkage, _called(mechanism, loop), _how(mechanism, loop, entry, inner))


def _along(mechanism: Mechanism, now: Motion, loop: Loop) -> complex:
    """Direction of the slide's line at the drawn position."""
    slide = loop.slide
    assert slide is not None
    return slide.line.direction * cmath.rect(1, float(now.theta[slide.guide]))


def _drives(mechanism: Mechanism, link: str) -> bool:
    """Whether a driver turns a link against the frame."""
    return any(driver.link == link and driver.from_link == FRAME for driver in mechanism.drivers)


def _turn_scale(mechanism: Mechanism, now: Motion, link: str, ours: complex) -> Scale | None:
    """How the file counts the angle of a driven link; None where it does as we do, or no driver turns it."""
    for driver in mechanism.drivers:
        if driver.link == link and driver.vector is not None and driver.from_link == FRAME:
            tail, head = driver.vector
            theirs = complex(now.position[head]) - complex(now.position[tail])
            return Scale(driver.name, cmath.phase(theirs / ours))
    return None


def _how(mechanism: Mechanism, loop: Loop, entry: str, inner: bool) -> str:
    if not entry and any(d.from_link != FRAME and {d.link, d.from_link} < {*loop.links} for d in mechanism.drivers):
        return "pair"
    if inner or (entry and (_drives(mechanism, entry) or any(_slid(mechanism, d) == entry for d in mechanism.drivers))):
        return "driver"
    return "link" if entry else "assumed"


def _called(mechanism: Mechanism, loop: Loop) -> tuple[str, ...]:
    pins = {pin_block(slide): slide.point for slide in mechanism.slides}
    return (*(pins.get(link, link) for link in loop.links[1:]), mechanism.frame)
