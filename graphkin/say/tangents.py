"""A guide line turned about its pivot until it passes where it must: a tangent, and what lies along it."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import degrees as in_degrees

import numpy as np

from graphkin.base.geometry import cross, dot
from graphkin.construction import Arm, LayOff, Span, Swing
from graphkin.model.pairs import Slide, Slot
from graphkin.say import names
from graphkin.say.entry import Calculation
from graphkin.say.figures import Formula, Operand, TrigFormula
from graphkin.say.guide_angle import guide_angle
from graphkin.say.numbers import degrees, number
from graphkin.say.paper_lengths import PaperLengths


@dataclass
class Tangents(PaperLengths):
    """Words of swings, and of what is laid off beside the line a swing has found.

    swung  the last swing of each link
    """

    swung: dict[str, Swing] = field(default_factory=dict)

    def _swing(self, step: Swing) -> str:
        reading = self.reading
        along = reading.plot.guide_direction(step.slide)
        arm = reading.plot.arm(step.pivot, step.through)
        offset = self._distance_of(step)
        words = {"pivot": reading.place(step.pivot), "through": reading.place(step.through),
                 "link": reading.link(step.link)}  # fmt: skip
        if offset <= reading.noise:
            return reading.say("derivation.swing join", **words)
        foot = self._foot_name
        way = names.point(step.pivot), foot, names.point(step.through)
        sense = reading.say("common.ccw" if float(cross(along, arm)) * float(dot(along, arm)) > 0 else "common.cw")
        which = reading.say("common.way round", way="→".join(way), sense=sense)
        length = self._distance(step, offset)
        if abs(dot(along, arm)) <= reading.noise:
            return reading.say("derivation.swing foot", length=length, foot=foot, **words)
        key = "derivation.swing beside" if self._beside(step) else "derivation.swing tangent"
        return reading.say(key, length=length, foot=foot, which=which, **words)

    def _beside(self, step: Swing) -> bool:
        """Whether the point lies beside the guide line, on a block that turns with it: a parallel line is drawn."""
        plot, pair = self.reading.plot, self.reading.method.structure.slides[step.slide]
        off = cross(plot.guide_direction(step.slide), plot.arm(pair.line.origin, step.through))
        return float(abs(off)) > self.reading.noise

    def _distance_of(self, step: Swing) -> float:
        """How far the guide line passes from the pivot [m]."""
        plot = self.reading.plot
        return float(abs(cross(plot.guide_direction(step.slide), plot.arm(step.pivot, step.through))))

    def _distance(self, step: Swing, offset: float) -> str:
        """`h = l_CD sin γ = 0.048 × sin 100° = 0.04727 m`, and on paper; `h = r1 = 0.02 m` beside a face."""
        formula, figures = self._sum(step, self.reading.method.structure.slides[step.slide], offset)
        chain = Calculation("h", (formula,) if formula else (), figures, offset, "m").text
        return f"{chain}{self.reading.say('derivation.on paper', length=self._length('', 'h', offset))}"

    def _sum(self, step: Swing, pair: Slide, offset: float) -> tuple[str, Formula | str]:
        """`l_CD sin γ`; `l_DM sin 20° + r_C` where a face passes the pivot at a distance; "" of what is neither."""
        reading, slot = self.reading, pair.path if pair.stands_for is None else pair.stands_for.equivalent
        assert isinstance(slot, Slot), pair
        radius, link = abs(slot.offset), reading.mechanism.links[slot.line.link]
        symbol = reading.rim(pair.stands_for) if pair.stands_for is not None and radius else ""
        if radius and abs(offset - radius) <= reading.noise:
            return symbol, ""
        if not slot.line.named or step.pivot not in link.points or step.pivot == slot.line.origin:
            return "", ""
        arm = link.arm(step.pivot, slot.line.origin)
        turned, aside = abs(in_degrees(np.angle(slot.line.direction / arm))), abs(cross(slot.line.direction, arm))
        angle = guide_angle(reading, pair)
        known = angle is not None and angle.corner == step.pivot and bool(angle.symbol)
        sine = TrigFormula("sin", turned if known else min(turned, 180 - turned))
        length, rim = Operand(abs(arm)), Operand(radius)
        turn = f"sin {angle.symbol}" if angle is not None and known else sine.text()
        name = f"l_{names.pair(step.pivot, slot.line.origin)} {turn}"
        ways: dict[float, tuple[str, Formula | str]] = {
            aside - radius: (f"{name} − {symbol}", length * sine - rim),
            radius - aside: (f"{symbol} − {name}", rim - length * sine),
            aside + radius: (f"{name} + {symbol}", length * sine + rim) if radius else (name, length * sine),
        }
        return next((way for size, way in ways.items() if abs(size - offset) <= reading.noise), ("", ""))

    def _beside_guide(self, step: LayOff) -> str:
        """A further point of a link whose guide line has just been drawn, by how it lies to that line; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        if not isinstance(part, Arm) or part.link not in self.swung:
            return ""
        swing = self.swung[part.link]
        along, arm = reading.plot.guide_direction(swing.slide), reading.plot.arm(step.start, step.tip)
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip),
                 "length": self._arm(step.start, step.tip)}  # fmt: skip
        if abs(cross(along, reading.plot.arm(swing.through, step.tip))) <= reading.noise:
            return self._on_tangent(step, swing)
        turned = float(np.angle(arm / along * np.sign(dot(along, arm) or 1.0)))
        if abs(cross(along, arm)) <= reading.noise:
            return reading.say("derivation.lay off parallel", angle=degrees(arm), **words)
        sense = reading.say("common.ccw" if turned > 0 else "common.cw")
        words["turned"] = f"{self._corner_of_link(part.link, step)}{number(abs(in_degrees(turned)))}°"
        return reading.say("derivation.lay off turned", sense=sense, **words)

    def _corner_of_link(self, link: str, step: LayOff) -> str:
        """`∠CDE = ` where another point of the link lies on the guide line from D, at less than 90 deg to DC."""
        plot, along = self.reading.plot, self.reading.plot.guide_direction(self.swung[link].slide)
        ahead = along * np.sign(dot(along, plot.arm(step.start, step.tip)) or 1.0)
        arms = ((p, plot.arm(step.start, p)) for p in self.reading.mechanism.named(link))
        on_it = (p for p, arm in arms if abs(cross(ahead, arm)) <= self.reading.noise < dot(ahead, arm))
        return next((f"∠{''.join(map(names.point, (step.tip, step.start, p)))} = " for p in on_it), "")

    def _on_tangent(self, step: LayOff, swing: Swing) -> str:
        """A point of the guide line itself: how far from the foot, and which way."""
        reading = self.reading
        foot, at_pivot = self._foot(swing), self._distance_of(swing) <= reading.noise
        length = reading.distance(step.start, step.tip)
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip),
                 "length": self._arm(step.start, step.tip)}  # fmt: skip
        if abs(reading.plot.position[step.tip] - foot) <= reading.noise or not length:
            return reading.say("derivation.at the foot", **words)
        ahead = float(dot(reading.plot.position[swing.through] - foot, reading.plot.position[step.tip] - foot))
        key = "derivation.on tangent" if ahead > 0 else "derivation.on tangent beyond"
        named = reading.place(swing.pivot) if at_pivot else self._foot_name
        return reading.say(key, foot=named, through=reading.place(swing.through), **words)

    def _foot(self, swing: Swing) -> complex:
        """Where the guide line is nearest to the pivot."""
        plot = self.reading.plot
        along, arm = complex(plot.guide_direction(swing.slide)), complex(plot.arm(swing.pivot, swing.through))
        return complex(plot.position[swing.through] - dot(along, arm) * along)

    @property
    def _foot_name(self) -> str:
        """T, or the next letter that no point of the mechanism takes."""
        return next(letter for letter in ("T", "U", "V", "Z", "T′") if letter not in self.reading.mechanism.owners)
