"""Higher pairs replaced by lower ones (高副低代), and the angle relations that gears and rolling add.

Profiles are circles and straight lines, so the equivalent holds for the whole motion: two circles that touch
keep the distance of their centres (a link `e` joins them), a circle that touches a line keeps its centre on a
parallel line (a pin in a slot). A wheel that rolls on a line is such a pin, one that rolls on a circle hangs on
such a link; the rolling itself, like a gear pair, ties angles together.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass, replace

from graphkin.mechanism import FRAME, Link, Mechanism
from graphkin.pairs import Cam, Gear, Line, Profile, Roll, Slide
from graphkin.value import frozen

__all__ = ["Contact", "contacts", "lower_pairs"]


def lower_pairs(mechanism: Mechanism) -> Mechanism:
    """The mechanism with hinges and slides alone. Points and slides that stand for contacts have small letters."""
    build = _Build(dict(mechanism.links), list(mechanism.slides))
    for k, cam in enumerate(mechanism.cams):
        build.cam(f"c{k}", cam)
    for roll in mechanism.rolls:
        build.roll(roll)
    for k, gear in enumerate(mechanism.gears):
        build.gear(f"g{k}", gear)
    return replace(mechanism, links=build.links, slides=tuple(build.slides), cams=(), rolls=(), gears=())


@dataclass
class _Build:
    links: dict[str, Link]
    slides: list[Slide]

    def cam(self, name: str, cam: Cam) -> None:
        first, second = cam.profiles
        if first.line is None and second.line is None:
            radii = first.radius, second.radius
            length = abs(radii[0] - radii[1]) if cam.internal else sum(radii)
            assert first.centre is not None
            assert second.centre is not None
            self.join(name, first.centre, second.centre, length)
        else:
            flat, disc = (first, second) if first.line is not None else (second, first)
            self.slot(name, flat, disc)

    def slot(self, name: str, flat: Profile, disc: Profile) -> None:
        assert flat.line is not None
        assert disc.centre is not None
        self.parallel(name, flat.line, disc.radius if flat.left else -disc.radius, disc.centre, False)

    def roll(self, roll: Roll) -> None:
        if roll.line is not None and _guided(self.links, self.slides, roll) is not None:
            return  # a sliding pair holds the centre on its way already
        if roll.line is not None:
            offset = roll.radius if roll.left else -roll.radius
            self.parallel(roll.name, roll.line, offset, roll.centre, roll.named)
            return
        assert roll.track_centre is not None
        if arm_of(self.links, roll.track_centre, roll.centre) is None:
            length = abs(roll.track_radius - roll.radius) if roll.internal else roll.track_radius + roll.radius
            self.join(roll.name, roll.track_centre, roll.centre, length)

    def gear(self, name: str, gear: Gear) -> None:
        """The line of centres, where several links together keep its length."""
        if arm_of(self.links, *gear.centres) is None:
            self.join(name, *gear.centres, abs(gear.radii[0] - gear.radii[1]) if gear.internal else sum(gear.radii))

    def join(self, name: str, first: str, second: str, length: float) -> None:
        """A link of the equivalent, between two centres."""
        self.links[f"e {name}"] = Link(f"e {name}", {first: 0j, second: complex(length)})

    def parallel(self, name: str, line: Line, offset: float, centre: str, named: bool) -> None:
        """A slot of the equivalent: the line moved sideways by the radius."""
        link = self.links[line.link]
        origin = link.points[line.origin] + 1j * offset * line.direction
        self.links[line.link] = Link(link.name, {**link.points, f"{name} origin": origin})
        path = Line(line.link, f"{name} origin", line.direction)
        self.slides.append(Slide(name, named, path, centre, None, 0.0))


def arm_of(links: dict[str, Link], first: str, second: str) -> str | None:
    """The link that carries both centres, the frame last."""
    both = [name for name, link in links.items() if first in link.points and second in link.points]
    return next((name for name in both if name != FRAME), both[0] if both else None)


@frozen
class Contact:
    """Rolling of two wheels, or of a wheel on a line: an angle relation between the drawn position and now.

    sum of coefficient * (angle - drawn angle) + on_slide * (s - drawn s) = 0

    wheels   the two links that roll on each other; for a line, the track and the wheel
    centres  their centres; for a line, only the wheel's
    radii    signed: the contact lies at centre + radius * direction to the other centre [m]
    arm      the link whose angle is that of the line of centres; "" on a line
    slide    the slide of the equivalent whose displacement counts, for a line
    """

    name: str
    wheels: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    arm: str
    angles: tuple[tuple[str, float], ...]
    slide: str = ""
    on_slide: float = 0.0
    way: tuple[tuple[str, float], ...] = ()


def contacts(mechanism: Mechanism, lower: Mechanism) -> Iterator[Contact]:
    """Every gear pair and every rolling wheel."""
    for k, gear in enumerate(mechanism.gears):
        yield _circles(f"g{k}", lower, gear.links, gear.centres, gear.radii, gear.internal)
    for roll in mechanism.rolls:
        if roll.line is None:
            assert roll.track_centre is not None
            yield _circles(
                roll.name, lower, (roll.track, roll.wheel), (roll.track_centre, roll.centre),
                (roll.track_radius, roll.radius), roll.internal,
            )  # fmt: skip
        else:
            side = 1.0 if roll.left else -1.0
            angles = ((roll.wheel, roll.radius), (roll.track, -roll.radius))
            slide, way, along = _guided(dict(mechanism.links), list(mechanism.slides), roll) or (roll.name, 1.0, 1.0)
            yield Contact(
                roll.name, (roll.track, roll.wheel), ("", roll.centre), (0.0, along * side * roll.radius), "", angles,
                slide, way * side,
            )  # fmt: skip


def _guided(links: dict[str, Link], slides: list[Slide], roll: Roll) -> tuple[str, float, float] | None:
    """A sliding pair that moves the wheel's centre along its track already: a rack in a guide, a wheel on a crosshead.

    Its name, what its displacement counts along the track (+1 or -1), and whether its line runs as the track's does.
    """
    if roll.named or roll.line is None:
        return None
    carriers = {name for name, link in links.items() if roll.centre in link.points}
    for slide in slides:
        on_track, on_centre = slide.guide == roll.track, slide.block == roll.track
        other = slide.block if on_track else slide.guide
        if slide.block is None or not (on_track or on_centre) or other not in carriers:
            continue
        turn = cmath.rect(1.0, 0.0 if on_track else slide.turn)
        relation = roll.line.direction * turn * slide.line.direction.conjugate()
        if abs(relation.imag) < 1e-9 * abs(relation):
            along = 1.0 if relation.real > 0 else -1.0
            return slide.name, along if on_track else -along, along
    return None


def _circles(
    name: str, lower: Mechanism, wheels: tuple[str, str], centres: tuple[str, str],
    radii: tuple[float, float], internal: bool,
) -> Contact:  # fmt: skip
    """Two pitch circles; of an internal pair the larger is the ring, whose radius counts against the other's."""
    first, second = radii
    if internal:
        first, second = (first, -second) if first > second else (-first, second)
    arm = arm_of(dict(lower.links), *centres) or f"e {name}"
    angles = ((wheels[0], first), (wheels[1], second), (arm, -(first + second)))
    return Contact(name, wheels, centres, (first, second), arm, angles)
