"""The angle of every link as the book writes it: one θ for links that keep their angle, θ2 = θ3 + γ for a block.

Links that a slide or a driver holds at an angle to one another have one unknown between them, named after the link
whose own points give it a direction: the guide. A driven link has the driver's θ; a link driven from a moving one
stands at an angle θ21 to it.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from itertools import count

from graphkin.analytic import Motion
from graphkin.equations.expressions import NO_ANGLE, AngleSum, Symbol
from graphkin.equations.legend import Legend, angle_readers, difference
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Slide
from graphkin.planning.structure import Topology
from graphkin.say.catalogue import Meaning, meaning

_PLACES = 12  # decimals of a metre to which points of a link at one place agree
_STRAIGHT = 1e-9  # an angle this near to a multiple of 90 deg is one [rad]
_RATES = ("direction", "angular velocity", "angular acceleration")


def quarters(angle: float) -> int | None:
    """An angle as a number of quarter turns; None where it is no whole number of them."""
    count = round(angle / (math.pi / 2))
    return count % 4 if abs(angle - count * math.pi / 2) < _STRAIGHT else None


@dataclass
class Bodies:
    """Angles of bodies, worked out group by group.

    motion  the analytic solution at the drawn position
    angles  of each body
    base    the unknown θ of each body's group; None in the frame's
    drivers the symbol each driver of an angle turns
    spots   points without a name that have been given a letter: the letter, the point, and the body
    """

    structure: Topology
    legend: Legend
    motion: Motion
    angles: dict[str, AngleSum] = field(default_factory=dict)
    base: dict[str, Symbol | None] = field(default_factory=dict)
    drivers: dict[int, Symbol] = field(default_factory=dict)
    spots: dict[str, tuple[str, str]] = field(default_factory=dict)
    _lines: dict[str, AngleSum] = field(default_factory=dict)
    _with_symbol: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self._spread(FRAME, NO_ANGLE, None)
        guides = {slide.guide for slide in self.structure.slides.values()}

        def rank(body: str) -> tuple[bool, bool, int]:
            """Guides with a direction of their own first, then links with one, in the order of the file."""
            return len(self.structure.bodies[body]) <= 1, body not in guides, self.structure.order[body]

        for body in sorted(self.structure.bodies, key=rank):
            if body not in self.angles:
                theta = self._theta(body, steady=False)
                self._spread(body, AngleSum.of(theta), theta)

    def called(self, body: str) -> str:
        """The name that people give a body; links of the lower-pair equivalent are e, e2, .. as in the drawings."""
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
        names: dict[tuple[str, complex], str] = {}
        free = (name for k in count() if (name := "O" + "'" * k) not in self.structure.mechanism.points)
        for body, shape in self.structure.shapes.items():
            for other in sorted(shape, key=lambda name: name in unnamed):
                at = body, complex(round(shape[other].real, _PLACES), round(shape[other].imag, _PLACES))
                if at not in names:
                    names[at] = other if other not in unnamed else next(free)
                if other == point:
                    if names[at] not in shape:
                        self.spots.setdefault(names[at], (point, body))
                    return names[at]
        return point

    def _spread(self, start: str, angle: AngleSum, base: Symbol | None) -> None:
        """From one body to all that keep their angle to it, or are driven against it."""
        self.angles[start], self.base[start], queue = angle, base, [start]
        for body in queue:
            held: list[tuple[str, Callable[[], AngleSum]]] = []  # all that a slide or a driver holds against it
            for slide in self.structure.slides.values():
                block = self.structure.block(slide)
                if body in (slide.guide, block):
                    other, sign = (block, 1) if body == slide.guide else (slide.guide, -1)
                    held.append((other, partial(self._slid, body, slide, sign)))
            for number, driver in enumerate(self.structure.mechanism.drivers):
                if driver.kind != "slide" and body in (driver.link, driver.from_link):
                    other, sign = (driver.link, 1) if body == driver.from_link else (driver.from_link, -1)
                    held.append((other, partial(self._driven, body, other, number, sign)))
            for other, angle_of_other in held:
                if other not in self.angles:
                    self.angles[other] = angle_of_other()
                    self.base[other] = base
                    queue.append(other)
                    moving = self.angles[other].moving and not self.structure.is_pin(other)
                    if moving and other not in self._with_symbol:  # its own θ is a name for that sum
                        self.legend.alias[self._theta(other, steady=False)] = self.angles[other]

    def _theta(self, body: str, steady: bool) -> Symbol:
        symbol = self.legend.fresh("θ", self.called(body), "angle", steady)
        texts = tuple(meaning(f"equations.turning {rate}", link=self.called(body)) for rate in _RATES)
        readers = angle_readers(self.structure, body, self.motion)
        return self.legend.variable(symbol, texts, ("deg", "rad/s", "rad/s^2"), readers)

    def _driven(self, body: str, other: str, number: int, sign: int) -> AngleSum:
        """The angle of `other` that a driver gives: its own θ where `body` stands still, else θ21."""
        driver = self.structure.mechanism.drivers[number]
        if not self.angles[body].moving:
            self.drivers[number] = self._theta(other, driver.acceleration == 0)
            self._with_symbol.add(other)
            return AngleSum.of(self.drivers[number])
        names = self.called(driver.link), self.called(driver.from_link)
        low = "".join(names) if all(len(name) == 1 for name in names) else "/".join(names)
        symbol = self.legend.fresh("θ", low, "angle", driver.acceleration == 0)
        words = {"link": names[0], "other": names[1]}
        angle, *rates = (meaning(f"equations.relative {rate}", **words) for rate in _RATES)
        if driver.vector is not None and driver.from_vector is not None and driver.value is not None:
            words |= {"vector": "".join(driver.vector), "seen": "".join(driver.from_vector)}
            angle = meaning("equations.relative direction given", **words, angle=f"{math.degrees(driver.value):.6g}")
        both = (angle_readers(self.structure, link, self.motion) for link in (driver.link, driver.from_link))
        readers = difference(*both)
        self.drivers[number] = self.legend.variable(symbol, (angle, *rates), ("deg", "rad/s", "rad/s^2"), readers)
        turn = AngleSum.of(self.drivers[number])
        return self.angles[body] + (turn if sign == 1 else -turn)

    def _slid(self, body: str, slide: Slide, sign: int) -> AngleSum:
        """The angle of the block on a guide (sign 1), or of the guide under a block (-1)."""
        names = self.called(self.structure.block(slide)), self.called(slide.guide)
        if (count := quarters(slide.tilt)) is not None or slide.block is None:
            turn = self.line(slide).turned(count or 0)
        else:
            text = meaning("equations.block line", guide=names[1], block=names[0])
            turn = self._constant(slide.turn, "δ", names[0], text)
        return self.angles[body] + (turn if sign == 1 else -turn)

    def line(self, slide: Slide) -> AngleSum:
        """The angle from the guide's axis to the slide's line."""
        if slide.name not in self._lines:
            oblique = [s for s in self.structure.slides.values() if quarters(cmath.phase(s.line.direction)) is None]
            low = "" if len(oblique) == 1 else self.called(slide.guide)
            text = meaning("equations.guide line", link=self.called(slide.guide))
            if slide.guide == FRAME:
                text = meaning("equations.fixed guide", point=slide.point)
            self._lines[slide.name] = self._constant(cmath.phase(slide.line.direction), "γ", low, text)
        return self._lines[slide.name]

    def _constant(self, value: float, letter: str, low: str, text: Meaning) -> AngleSum:
        if (count := quarters(value)) is not None:
            return AngleSum((), count)
        return AngleSum.of(self.legend.constant(letter, low, text, "deg", math.remainder(value, math.tau)))
