"""The linkages of four links: what their lengths are, and where they are drawn.

    FourBar       frame AD, crank AB, coupler BC, rocker DC: four revolute pairs
    SliderCrank   crank AB, rod BC, slider C on a fixed guide that passes A at a distance e
    GuideBar      crank AB, frame AC, a bar hinged at C on which a block at B slides; the bar's line passes C at e

A crank of length r, a rod l and an offset e are one chain: fix its crank or its rod, and it is a guide bar.
Every linkage knows a position of its own, `places`: it tells the two mirrored assemblies apart, which way the
frame lies, and to which side a slider is. Lengths [m], angles [rad], places complex [m].
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence

from graphkin.errors import NOWHERE, CannotClose, CannotDriveBy, NotALength, OnlyStretched
from graphkin.value import frozen

__all__ = ["EVEN", "FourBar", "GuideBar", "Linkage", "Scale", "SliderCrank", "even"]

EVEN = 1e-9
"""Sums of lengths that differ by less than this part of all lengths together are equal: a change point."""


def even(difference: float, size: float) -> float:
    """A difference of sums of lengths, 0 where it is 0 but for rounding."""
    return 0.0 if abs(difference) <= EVEN * size else difference


@frozen
class Scale:
    """How a file counts a driver: value = zero + sense * ours [rad or m]."""

    name: str
    zero: float = 0.0
    sense: float = 1.0

    def __call__(self, ours: float) -> float:
        return self.zero + self.sense * ours


@frozen
class FourBar:
    """Four links and four hinges.

    crank, coupler, rocker, frame   AB, BC, CD, AD [m]; "crank" is only the first link on the frame
    names     what A, B, C, D are called
    driver    "crank", "coupler", "rocker": which link is driven
    places    A, B, C, D at the drawn position; left out: A at the origin, D on +x, C to the left of BD
    scale     how the driver's angle is counted; left out: the angle of AB (or DC) to +x
    """

    crank: float
    coupler: float
    rocker: float
    frame: float
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C", "D")
    places: tuple[complex, ...] = ()
    scale: Scale | None = None

    def __post_init__(self) -> None:
        a, b, c, d = self.names
        self._named(a + b, b + c, c + d, a + d)
        object.__setattr__(self, "places", self.places or _four_bar_places(self))

    def _named(self, *links: str) -> None:
        _positive(zip(links, self.lengths))
        _known_driver(self.driver, ("crank", "coupler", "rocker"))
        sizes = dict(zip(links, self.lengths))
        long = max(links, key=lambda link: sizes[link])
        _closes(long, sizes[long], [link for link in links if link != long], sum(self.lengths) - sizes[long])

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        return self.crank, self.coupler, self.rocker, self.frame


@frozen
class SliderCrank:
    """Crank AB, rod BC, slider C on a fixed guide.

    offset   the guide lies so far to the left of A, looking along `way` [m]
    driver   "crank", "coupler" (the rod), "slider"
    way      direction of the guide [rad]
    block    the fixed link is the block and the sliding link carries the guide (a hand pump)
    places   A, B, C at the drawn position; left out: A at the origin, the guide along +x, C to the right
    scale    how the driver is counted; left out: the angle of AB to +x, or C's way along the guide from the foot of A
    """

    crank: float
    coupler: float
    offset: float = 0.0
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C")
    places: tuple[complex, ...] = ()
    way: float = 0.0
    block: bool = False
    scale: Scale | None = None

    def __post_init__(self) -> None:
        a, b, c = self.names
        _positive(((a + b, self.crank), (b + c, self.coupler)))
        _offset(self.offset)
        _known_driver(self.driver, ("crank", "coupler", "slider"))
        _closes("e", abs(self.offset), [a + b, b + c], self.crank + self.coupler)
        object.__setattr__(self, "places", self.places or _slider_places(self))


@frozen
class GuideBar:
    """Crank AB and a bar hinged at C, on whose line a block hinged at B slides.

    offset   B's line lies so far to the left of C, looking along the bar [m]
    driver   "crank", "bar", "slide" (the block along the bar: a cylinder)
    block    the frame carries the block at C and the bar slides through it (an oscillating block)
    turn     direction of the bar at the drawn position [rad]
    places   A, B, C at the drawn position; left out: A at the origin, C on +x, B ahead of C on the bar
    scale    how the driver is counted; left out: the angle of AB, or of the bar, to +x; B's way along the bar from C
    """

    crank: float
    frame: float
    offset: float = 0.0
    driver: str = "crank"
    names: tuple[str, ...] = ("A", "B", "C")
    places: tuple[complex, ...] = ()
    turn: float = 0.0
    block: bool = False
    scale: Scale | None = None

    def __post_init__(self) -> None:
        a, b, c = self.names
        _positive(((a + b, self.crank), (a + c, self.frame)))
        _offset(self.offset)
        _known_driver(self.driver, ("crank", "bar", "slide"))
        _closes("e", abs(self.offset), [a + b, a + c], self.crank + self.frame)
        if not self.places:
            places, turn = _guide_places(self)
            object.__setattr__(self, "places", places)
            object.__setattr__(self, "turn", turn)


Linkage = FourBar | SliderCrank | GuideBar


# --- what is refused ----------------------------------------------------------------------------


def _positive(lengths: object) -> None:
    for name, length in lengths:  # type: ignore[attr-defined]
        if not (math.isfinite(length) and length > 0):
            raise NotALength(NOWHERE, name, f"{length * 1e3:g}")


def _offset(offset: float) -> None:
    if not math.isfinite(offset):
        raise NotALength(NOWHERE, "e", f"{offset:g}")


def _known_driver(driver: str, known: tuple[str, ...]) -> None:
    if driver not in known:
        raise CannotDriveBy(NOWHERE, driver, known)


def _closes(long: str, length: float, others: list[str], rest: float) -> None:
    gap = even(length - rest, length + rest)
    if gap == 0:
        raise OnlyStretched(NOWHERE, long, " + ".join(others), length * 1e3)
    if gap > 0:
        raise CannotClose(NOWHERE, long, length * 1e3, " + ".join(others), rest * 1e3)


# --- a position to start from -------------------------------------------------------------------


_TURNS = tuple(math.radians(turn) for turn in (60, 100, 35, 140, 80, 15, 165))
"""Where the crank is drawn if nothing else is said: the first at which the driver is well off a dead point."""
_WELL = math.sin(math.radians(25))


def _well_drawn(drawn: Sequence[tuple[complex, ...]], sine: Callable[..., float]) -> tuple[complex, ...]:
    good = (places for places in drawn if sine(*places) > _WELL)
    return next(good, max(drawn, key=lambda places: sine(*places)))


def _sine(one: complex, other: complex) -> float:
    """Sine of the angle between two lines."""
    size = abs(one) * abs(other)
    return abs((one.conjugate() * other).imag) / size if size else 0.0


def _four_bar_places(bar: FourBar) -> tuple[complex, ...]:
    """The crank at 60 deg or near, as far as it gets, C on the left of BD."""
    low, high = angles(bar.crank, bar.frame, bar.coupler, bar.rocker)
    drawn = []
    for turn in (*(turn for turn in _TURNS if low + 0.02 < turn < high - 0.02), (low + high) / 2):
        b, d = cmath.rect(bar.crank, turn), complex(bar.frame)
        drawn.append((0j, b, apex(b, d, bar.coupler, bar.rocker, 1.0), d))
    if bar.driver == "rocker":
        return _well_drawn(drawn, lambda a, b, c, d: _sine(b - a, c - b))
    return _well_drawn(drawn, lambda a, b, c, d: _sine(b - c, d - c))


def _slider_places(slider: SliderCrank) -> tuple[complex, ...]:
    """The crank at 60 deg or near, as far as it gets, the slider on the right."""
    r, rod, e = slider.crank, slider.coupler, slider.offset
    low, high = max(-1.0, (e - rod) / r), min(1.0, (e + rod) / r)
    drawn = []
    for turn in (*(turn for turn in _TURNS if low < math.sin(turn) < high), (math.asin(low) + math.asin(high)) / 2):
        b = cmath.rect(r, turn)
        drawn.append((0j, b, complex(b.real + math.sqrt(max(0.0, rod * rod - (e - b.imag) ** 2)), e)))
    drawn = [places for places in drawn if places[2].real > 0] or drawn
    if slider.driver == "slider":
        return _well_drawn(drawn, lambda a, b, c: _sine(b - a, c - b))
    return _well_drawn(drawn, lambda a, b, c: _sine(c - b, 1j))


def _guide_places(bar: GuideBar) -> tuple[tuple[complex, ...], float]:
    """The crank at 60 deg or near, farther out where B would come too near to C."""
    r, d, e = bar.crank, bar.frame, bar.offset
    low = math.acos(max(-1.0, min(1.0, (r * r + d * d - e * e) / (2 * r * d))))
    low = low if abs(d - r) < abs(e) else 0.0
    turns = (*(turn for turn in _TURNS if turn > low + 0.02), (low + math.pi) / 2)
    drawn = [(0j, cmath.rect(r, turn), complex(d)) for turn in turns]

    def line(b: complex, c: complex) -> complex:
        return (b - c) / complex(math.sqrt(max(0.0, abs(b - c) ** 2 - e * e)), e)

    sines: dict[str, Callable[..., float]] = {
        "crank": lambda a, b, c: _sine(b - c, 1j * line(b, c)), "bar": lambda a, b, c: _sine(b - a, 1j * line(b, c)),
        "slide": lambda a, b, c: _sine(b - a, b - c),
    }  # fmt: skip
    places = _well_drawn(drawn, sines[bar.driver])
    return places, cmath.phase(line(places[1], places[2]))


def apex(first: complex, second: complex, near: float, far: float, side: float) -> complex:
    """The third corner of a triangle: `near` from the first, `far` from the second, to the left (side 1) of the two.

    On their line where it is nearly there: a link at its end, or a change point.
    """
    base = abs(second - first)
    along = (near * near - far * far + base * base) / (2 * base)
    gap = even(near - abs(along), near)
    height = math.sqrt(max(0.0, gap * (near + abs(along))))
    return first + complex(along, side * height) * (second - first) / base


def angles(one: float, other: float, far: float, farther: float) -> tuple[float, float]:
    """Least and greatest angle between two links that meet at a hinge of a four-bar; 0 and pi where nothing stops them.

    one, other    the two links; far, farther: the two opposite [m]
    """
    size = one + other + far + farther
    first = even(one + far - farther - other, size)
    second = even(one + farther - far - other, size)
    least = (far - farther) ** 2 if first * second < 0 else (one - other) ** 2
    stretched = even(one + other - far - farther, size) > 0
    return (
        _angle(one, other, least) if first * second < 0 else 0.0,
        _angle(one, other, (far + farther) ** 2) if stretched else math.pi,
    )


def _angle(one: float, other: float, square: float) -> float:
    """The angle between two sides of a triangle, the square of the third given."""
    return math.acos(max(-1.0, min(1.0, (one * one + other * other - square) / (2 * one * other))))
