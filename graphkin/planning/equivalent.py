"""Higher pairs replaced by lower ones (高副低代), and the angle relations that gears and rolling add.

A pair says itself what does the same: a rod between two points becomes a link `e` with a hinge at each, a slot beside
a line a pin in a slot. The rolling itself, like a gear pair, ties angles together.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Link, Mechanism
from graphkin.model.pairs import Line, Pair, Rod, Slide, Slot, rod_name, start_name


def lower_pairs(mechanism: Mechanism) -> Mechanism:
    """The mechanism with hinges and slides alone. Points and slides that stand for contacts have small letters. Rods
    that a link with both points makes needless come after those that may be that link, at last what follows."""
    links, slides = dict(mechanism.links), [*mechanism.slides]
    rods = {pair: rod.carried + rod.follows for pair in mechanism.pairs if isinstance(rod := pair.equivalent, Rod)}
    for pair in sorted(mechanism.pairs, key=lambda pair: rods.get(pair, 0)):
        match pair.equivalent:
            case Rod() as rod if not (rod.carried and arm_of(links, *rod.points)):
                name, (first, second) = rod_name(pair), rod.points
                links[name] = Link(name, {first: 0j, second: complex(rod.length)}, pair)
            case Slot() as slot if _guided(links, mechanism.slides, pair) is None:
                # a slot of the equivalent: the line moved sideways by the radius, from a point of its own; of an edge
                # the line
                path = slot.line
                if slot.offset:
                    link, start = links[path.link], start_name(pair)
                    origin = link.points[path.origin] + 1j * slot.offset * path.direction
                    links[link.name] = replace(link, points={**link.points, start: origin})
                    path = Line(link.name, start, path.direction, named=False)
                slides.append(Slide(pair.name, bool(pair.given), path, slot.point, None, 0.0, pair))
    higher = tuple(pair for pair in mechanism.pairs if pair.equivalent is not None)
    return replace(mechanism, links=links, pairs=tuple(slides), replaced=higher)


def arm_of(links: Mapping[str, Link], first: str, second: str) -> str:
    """The link that carries both centres, the frame last; "" where none does."""
    both = [name for name, link in links.items() if first in link.points and second in link.points]
    return next((name for name in both if name != FRAME), both[0] if both else "")


@frozen
class Contact:
    """Rolling of two wheels, or of a wheel on a line: an angle relation between the drawn position and now.

    sum of coefficient * (angle - drawn angle) + on_slide * (s - drawn s) = 0

    pair     the pair in which they roll
    wheels   the two links that roll on each other; for a line, the track and the wheel
    centres  their centres; for a line, only the wheel's
    radii    signed: the contact lies at centre + radius * direction to the other centre [m]
    arm      the link whose angle is that of the line of centres; "" on a line
    slide    the slide of the equivalent whose displacement counts, for a line
    """

    pair: Pair
    wheels: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    arm: str
    angles: tuple[tuple[str, float], ...]
    slide: str = ""
    on_slide: float = 0.0
    way: tuple[tuple[str, float], ...] = ()

    @property
    def name(self) -> str:
        return self.pair.name


def contacts(mechanism: Mechanism, lower: Mechanism) -> Iterator[Contact]:
    """Every gear pair and every rolling wheel.

    On a line s + r (wheel - track) counts where the centre lies left of it, s - r (..) where right; of an internal pair
    of pitch circles the larger is the ring, whose radius counts against the other's.
    """
    for pair in mechanism.pairs:
        if (rolling := pair.rolling) is None:
            continue
        first, second = rolling.radii
        if rolling.line is not None:
            (track, wheel), side = rolling.wheels, 1.0 if rolling.left else -1.0
            slide, share, along = _guided(mechanism.links, mechanism.slides, pair) or (pair.name, 1.0, 1.0)
            angles: tuple[tuple[str, float], ...] = ((wheel, second), (track, -second))
            radii = (0.0, along * side * second)
            yield Contact(pair, rolling.wheels, rolling.centres, radii, "", angles, slide, share * side)
            continue
        if rolling.internal:
            first, second = (first, -second) if first > second else (-first, second)
        arm = arm_of(lower.links, *rolling.centres) or rod_name(pair)
        angles = ((rolling.wheels[0], first), (rolling.wheels[1], second), (arm, -(first + second)))
        yield Contact(pair, rolling.wheels, rolling.centres, (first, second), arm, angles)


def _guided(links: Mapping[str, Link], slides: Iterable[Slide], pair: Pair) -> tuple[str, float, float] | None:
    """A sliding pair that moves the wheel's centre along its track already: a rack in a guide, a wheel on a crosshead.
    Its name, what its displacement counts along the track (+1 or -1), and whether its line runs as the track's does."""
    rolling = pair.rolling
    if pair.given or rolling is None or rolling.line is None:
        return None
    track, centre = rolling.wheels[0], rolling.centres[1]
    carriers = {name for name, link in links.items() if centre in link.points}
    for slide in slides:
        on_track = slide.guide == track
        other = slide.block if on_track else slide.guide
        if slide.block is None or track not in (slide.guide, slide.block) or other not in carriers:
            continue
        turn = cmath.rect(1.0, 0.0 if on_track else slide.turn)
        relation = rolling.line.direction * turn * slide.line.direction.conjugate()
        if abs(relation.imag) < 1e-9 * abs(relation):
            along = 1.0 if relation.real > 0 else -1.0
            return slide.name, along if on_track else -along, along
    return None
