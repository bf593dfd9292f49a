"""Straight lines and arcs of a plane, and the lines by which a link is drawn through its points."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

_SLANT = math.sin(math.radians(1.0))  # a line lies on another under less


def off_stretch(at: complex, start: complex, end: complex) -> float:
    """Distance of a place from a stretch of a line [mm]."""
    along = end - start
    t = ((along.conjugate() * (at - start)).real / abs(along) ** 2) if along else 0.0
    return abs(at - start - along * max(0.0, min(1.0, t)))


def crossing(start: complex, end: complex, one: complex, other: complex) -> complex | None:
    """The place where two stretches of lines cross inside; None where they do not."""
    along, off, way = end - start, one - start, other - one
    turn = (along.conjugate() * way).imag
    if abs(turn) < 1e-9:
        return None
    t, u = (off.conjugate() * way).imag / turn, (off.conjugate() * along).imag / turn
    return start + t * along if 0 < t < 1 and 0 < u < 1 else None


def no_crumbs(
    start: complex, pieces: list[tuple[complex, complex]], late: float, least: float
) -> list[tuple[complex, complex]]:
    """The pieces of a broken line without small ones, which seem to be of others, but for its last; nothing of one that
    begins too late after its start."""
    if not pieces or abs(pieces[0][0] - start) >= late:
        return []
    return [*(piece for piece in pieces[:-1] if abs(piece[1] - piece[0]) > least), pieces[-1]]


def in_line(places: list[complex]) -> tuple[int, int] | None:
    """The two ends of points that lie on one line (within 0.05 mm), else None."""
    first, last = max(
        ((i, j) for i in range(len(places)) for j in range(i)), key=lambda ij: abs(places[ij[0]] - places[ij[1]])
    )
    along = places[last] - places[first]
    on_it = all(abs((along.conjugate() * (p - places[first])).imag) < 0.05 * abs(along) for p in places)
    return (last, first) if on_it or abs(along) < 1e-9 else None


def lines_through(places: list[complex]) -> Iterator[tuple[tuple[int, ...], bool]]:
    """The lines that join points of a link, by their numbers, True where closed: a bar, or the outline of three and
    more; points inside it hang on two corners."""
    if (ends := in_line(places)) is not None:
        yield ends, False
        return
    around = hull(places)
    yield tuple(around), True
    for k in (k for k in range(len(places)) if k not in around):
        one, other, *_ = sorted(around, key=lambda corner: abs(places[corner] - places[k]))
        yield (one, k, other), False


def hull(places: list[complex]) -> list[int]:
    """Numbers of the points on the convex hull, round about: all others lie within less than half a turn from each."""

    def outer(k: int) -> bool:
        ways = sorted(cmath.phase(place - places[k]) for place in places if abs(place - places[k]) > 1e-9)
        again = (way + math.tau for way in ways[:1])
        first = all(abs(place - places[k]) > 1e-9 for place in places[:k])  # of points at one place
        return first and any(after - way > math.pi + 1e-6 for way, after in pairwise((*ways, *again)))

    middle = sum(places) / len(places)
    return sorted(filter(outer, range(len(places))), key=lambda k: cmath.phase(places[k] - middle))


def arc_places(centre: complex, arm: complex, start: float, end: float) -> list[complex]:
    """Places along an arc about a centre, from an arm turned by `start` to the arm turned by `end` [rad]."""
    steps = max(8, math.ceil(abs(end - start) / math.radians(3)))
    return [centre + arm * cmath.rect(1, start + (end - start) * k / steps) for k in range(steps + 1)]


def circle_places(centre: complex, radius: float, middle: complex, far: float, fine: float) -> list[complex]:
    """A circle as a polyline that stands off from it by less than `fine`; of a very large one the part that comes as
    near as `far` to a place [mm]."""
    half = min(math.pi, 2 * far / radius) if radius > 0 else math.pi
    start = cmath.phase(middle - centre)
    count = max(120, math.ceil(half * math.sqrt(radius / fine)))
    return [centre + cmath.rect(radius, start + half * (2 * k / count - 1)) for k in range(count + 1)]


def leaves(at: complex, arm: complex, stretch: tuple[complex, complex]) -> bool:
    """True where a stretch of a line leaves a place in a direction, within a degree [mm]."""
    offs = [(end - at) / arm for end in stretch]
    level = all(abs(off.imag) < max(0.05, _SLANT * abs(off)) for off in offs)
    return level and min(off.real for off in offs) < 0.1 and max(off.real for off in offs) > 1


def free_pieces(length: float, taken: Iterable[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """The pieces of a line that others, from where to where they lie on it, leave free, from its start."""
    at = 0.0
    for begin, stop in (*sorted(taken), (length, length)):
        if (end := min(begin, length)) > at:
            yield at, end
        at = max(at, stop)


def away_from(at: complex, along: complex, places: list[complex]) -> complex:
    """The side of a line away from points [mm, y downwards]; below where that does not decide."""
    normal = along * 1j
    weight = sum((normal.conjugate() * (place - at)).real for place in places)
    below = normal if (normal.imag, normal.real) > (0, 0) else -normal
    if abs(weight) < 5:
        return below
    return -normal if weight > 0 else normal


def levels(outline: Sequence[complex], apart: float) -> Iterator[tuple[complex, complex]]:
    """Level lines through an area, from rim to rim, no farther apart than that."""
    low, high = min(place.imag for place in outline), max(place.imag for place in outline)
    count = int((high - low) / apart)
    for level in (low + (high - low) * k / (count + 1) for k in range(1, count + 1)):
        sides = [(a, b) for a, b in pairwise(outline) if (a.imag <= level) != (b.imag <= level)]
        cuts = sorted(a.real + (b - a).real * (level - a.imag) / (b - a).imag for a, b in sides)
        yield from ((complex(x, level), complex(other, level)) for x, other in zip(cuts[::2], cuts[1::2], strict=True))
