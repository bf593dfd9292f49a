"""The angle of every link as the book writes it: one θ for links that keep their angle, θ2 = θ3 + γ for a block.

Links that a slide or a driver holds at an angle to one another have one unknown between them, named after the link
whose own points give it a direction: the guide. A driven link has the driver's θ; a link driven from a moving one
stands at an angle θ21 to it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import count

from graphkin.analytic import Motion
from graphkin.equations.legend import Legend
from graphkin.equations.readers import angle_readers, difference
from graphkin.equations.symbols import NO_ANGLE, AngleSum, Symbol
from graphkin.model.mechanism import FRAME, Driver
from graphkin.model.pairs import Slide
from graphkin.planning.structure import Topology
from graphkin.say.catalogue import Meaning, meaning

_PLACES = 12
"""Decimals of a metre to which points of a link at one place agree."""
_STRAIGHT = 1e-9
"""An angle this near to a multiple of 90 deg is one [rad]."""


def quarters(angle: float) -> int | None:
    """How many quarter turns an angle is; None where it is none."""
    count = round(angle / (math.pi / 2))
    return count % 4 if abs(angle - count * math.pi / 2) < _STRAIGHT else None


@dataclass
class Bodies:
    """Angles of bodies, found group by group.

    angles  of each body
    base    the unknown θ of each body's group; None in the frame's
    drivers the symbol each driver of an angle turns
    spots   points without a name that have been given a letter: the letter, the point, and the body
    """

    structure: Topology
    ledger: Legend
    drawn: Motion
    angles: dict[str, AngleSum] = field(default_factory=dict)
    base: dict[str, Symbol | None] = field(default_factory=dict)
    drivers: dict[int, Symbol] = field(default_factory=dict)
    spots: dict[str, tuple[str, str]] = field(default_factory=dict)
    _lines: dict[str, AngleSum] = field(default_factory=dict)
    _named: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self._spread(FRAME, NO_ANGLE, None)
        for body in sorted(self.structure.bodies, key=self._rank):
            if body not in self.angles:
                theta = self._theta(body, steady=False)
                self._spread(body, AngleSum.of(theta), theta)

    def called(self, body: str) -> str:
        """What people call a body; links of the lower-pair equivalent are e, e2, .. as in the drawings."""
        if self.structure.is_pin(body):
            return self.called(self.structure.pins[body].guide)
        extra = [name for name, link in self.structure.mechanism.links.items() if link.stands_for is not None]
        if body in extra:
            return f"e{extra.index(body) + 1}" if extra.index(body) else "e"
        return self.structure.mechanism.called(body)

    def spot(self, point: str) -> str:
        """A point's name. The start of a line given by coordinates is the named point there, else O, O', .."""
        unnamed = self.structure.mechanism.unnamed
        if point not in unnamed:
            return point
        found: dict[tuple[str, complex], str] = {}
        free = (name for k in count() if (name := "O" + "'" * k) not in self.structure.mechanism.points)
        for body, shape in self.structure.shapes.items():
            for other in sorted(shape, key=lambda name: name in unnamed):
                at = body, complex(round(shape[other].real, _PLACES), round(shape[other].imag, _PLACES))
                if at not in found:
                    found[at] = other if other not in unnamed else next(free)
                if other == point:
                    if found[at] not in shape:
                        self.spots.setdefault(found[at], (point, body))
                    return found[at]
        return point

    def _rank(self, body: str) -> tuple[bool, bool, int]:
        """Guides with a direction of their own first, then links with one, in the order of the file."""
        straight = len(self.structure.bodies[body]) > 1
        guides = {slide.guide for slide in self.structure.slides.values()}
        return not straight, body not in guides, self.structure.order[body]

    def _spread(self, start: str, angle: AngleSum, base: Symbol | None) -> None:
        """From one body to all that keep their angle to it, or are driven against it."""
        self.angles[start], self.base[start], queue = angle, base, [start]
        for body in queue:
            for other, found in self._held(body).items():
                if other not in self.angles:
                    self.angles[other] = found()
                    self.base[other] = base
                    queue.append(other)
                    self._name(other)

    def _held(self, body: str) -> Mapping[str, _Maker]:
        makers: dict[str, _Maker] = {}
        for slide in self.structure.slides.values():
            block = self.structure.block(slide)
            if body == slide.guide:
                makers.setdefault(block, _Maker(self, body, block, slide, 1))
            elif body == block:
                makers.setdefault(slide.guide, _Maker(self, body, slide.guide, slide, -1))
        for number, driver in enumerate(self.structure.mechanism.drivers):
            if driver.kind != "slide" and body in (driver.link, driver.from_link):
                sign = 1 if body == driver.from_link else -1
                other = driver.link if sign == 1 else driver.from_link
                makers.setdefault(other, _Maker(self, body, other, (number, driver), sign))
        return makers

    # --- symbols -------------------------------------------------------------------------------

    def _theta(self, body: str, steady: bool) -> Symbol:
        symbol = self.ledger.fresh("θ", self.called(body), "angle", steady)
        texts = tuple(meaning(f"equations.turning {rate}", link=self.called(body)) for rate in _TURNING)
        readers = angle_readers(self.structure, body, self.drawn)
        return self.ledger.variable(symbol, texts, ("deg", "rad/s", "rad/s^2"), readers)

    def _phi(self, driver: Driver) -> Symbol:
        names = self.called(driver.link), self.called(driver.from_link)
        low = "".join(names) if all(len(name) == 1 for name in names) else "/".join(names)
        symbol = self.ledger.fresh("θ", low, "angle", driver.acceleration == 0)
        words = {"link": names[0], "other": names[1]}
        place, *rates = (meaning(f"equations.relative {rate}", **words) for rate in _TURNING)
        if driver.vector is not None and driver.from_vector is not None and driver.value is not None:
            more = {"vector": "".join(driver.vector), "seen": "".join(driver.from_vector)}
            angle = f"{math.degrees(driver.value):.6g}"
            place = meaning("equations.relative direction given", **words, **more, angle=angle)
        texts = (place, *rates)
        both = (angle_readers(self.structure, body, self.drawn) for body in (driver.link, driver.from_link))
        return self.ledger.variable(symbol, texts, ("deg", "rad/s", "rad/s^2"), difference(*both))

    def driven(self, body: str, other: str, number: int, driver: Driver, sign: int) -> AngleSum:
        """The angle of `other` that a driver gives: its own θ where `body` stands still, else θ21."""
        if not self.angles[body].moving:
            self.drivers[number] = self._theta(other, driver.acceleration == 0)
            self._named.add(other)
            return AngleSum.of(self.drivers[number])
        self.drivers[number] = self._phi(driver)
        phi = AngleSum.of(self.drivers[number])
        return self.angles[body] + (phi if sign == 1 else -phi)

    def line(self, slide: Slide) -> AngleSum:
        """The angle from the guide's axis to the slide's line."""
        if slide.name not in self._lines:
            low = "" if self._oblique() == 1 else self.called(slide.guide)
            what = meaning("equations.guide line", link=self.called(slide.guide))
            if slide.guide == FRAME:
                what = meaning("equations.fixed guide", point=slide.point)
            self._lines[slide.name] = self._constant(cmath.phase(slide.line.direction), "γ", low, what)
        return self._lines[slide.name]

    def _oblique(self) -> int:
        """How many lines want an angle of their own."""
        return sum(quarters(cmath.phase(s.line.direction)) is None for s in self.structure.slides.values())

    def turn(self, slide: Slide) -> AngleSum:
        """The angle from the guide's axis to the block's."""
        if (count := quarters(slide.tilt)) is not None or slide.block is None:
            return self.line(slide).turned(count or 0)
        names = self.called(slide.block), self.called(slide.guide)
        what = meaning("equations.block line", guide=names[1], block=names[0])
        key = f"{slide.name} block"
        if key not in self._lines:
            self._lines[key] = self._constant(slide.turn, "δ", names[0], what)
        return self._lines[key]

    def _constant(self, value: float, letter: str, low: str, what: Meaning) -> AngleSum:
        if (count := quarters(value)) is not None:
            return AngleSum((), count)
        return AngleSum.of(self.ledger.constant(letter, low, what, "deg", math.remainder(value, math.tau)))

    def _name(self, body: str) -> None:
        """A link whose angle follows from others has a θ of its own: a name for that sum."""
        angle = self.angles[body]
        if not self.structure.is_pin(body) and angle.moving and body not in self._named:
            self.ledger.alias[self._theta(body, steady=False)] = angle


_TURNING = ("direction", "angular velocity", "angular acceleration")


@dataclass(frozen=True)
class _Maker:
    """Gives the angle of `other` by that of `body`, when it is first needed."""

    bodies: Bodies
    body: str
    other: str
    by: Slide | tuple[int, Driver]
    sign: int

    def __call__(self) -> AngleSum:
        if isinstance(self.by, Slide):
            turn = self.bodies.turn(self.by)
            return self.bodies.angles[self.body] + (turn if self.sign == 1 else -turn)
        return self.bodies.driven(self.body, self.other, *self.by, self.sign)
