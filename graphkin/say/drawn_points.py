"""How a point of the mechanism is found on paper, in words: laid off, where lines cross, at the corner of a link."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import assert_never

from graphkin.base.geometry import cross
from graphkin.construction import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Arc,
    Arm,
    Direction,
    LayOff,
    Meet,
    Quarter,
    Ray,
    Span,
)
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.crossings import crossing
from graphkin.say.numbers import degrees
from graphkin.say.tangents import Tangents


@dataclass
class DrawnPoints(Tangents):
    """Words of the steps that give a point.

    drawn    points that are there by now
    reached  corners of reaches of two arms, with their ends
    ends     by link, the two points between which its angle has been found
    """

    drawn: set[str] = field(default_factory=set)
    reached: dict[str, tuple[str, str]] = field(default_factory=dict)
    ends: dict[str, tuple[str, str]] = field(default_factory=dict)

    def _lay_off(self, step: LayOff) -> str:
        reading, points = self.reading, self.reading.plot.position
        assert isinstance(step.term.size, Span)
        if (text := self._beside_guide(step)) or (text := self._over_reach(step)):
            return text
        arrow = points[step.tip] - points[step.start]
        if isinstance(step.term.direction, AlongGuide) and abs(arrow) <= reading.noise:
            arrow = reading.plot.guide_direction(step.term.direction.slide)
        angle = degrees(arrow)
        aside = "*" in step.start + step.tip
        length = self._reach(step.term.size, names.stretch(step.start, step.tip) if aside else "")
        length = length if reading.named(step.start) or not aside else length.partition(" = ")[2]
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip), "length": length, "angle": angle}
        if isinstance(step.term.direction, AlongGuide):
            guide = self.reading.path(step.term.direction.slide)
            return reading.say("derivation.lay off slide", guide=guide, **words)
        if line := self._drawn_line(step):
            return reading.say("derivation.lay off on line", line=line, **words)
        return reading.say("derivation.lay off link", **words)

    def _drawn_line(self, step: LayOff) -> str:
        """Two points that are drawn, on whose line an arm of their link lies; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        tail, head = self.ends.get(part.link, ("", "")) if isinstance(part, Arm) else ("", "")
        if not tail or not reading.named(tail) or not reading.named(head) or not {tail, head} <= self.drawn:
            return ""
        line, arm = reading.plot.arm(tail, head), reading.plot.arm(step.start, step.tip)
        return names.pair(tail, head) if abs(cross(line, arm)) <= reading.noise * abs(arm) else ""

    def _over_reach(self, step: LayOff) -> str:
        """A point between the ends of a reach made of several arms: by arcs about both ends; "" of others."""
        reading, ends = self.reading, self.reached.get(step.tip, ("", ""))
        if step.start not in ends:
            return ""
        end = ends[1] if step.start == ends[0] else ends[0]
        points = (step.start, step.tip, end)
        side = float(cross(reading.plot.arm(step.start, step.tip), reading.plot.arm(step.start, end)))
        return reading.say(
            "derivation.over reach", point=names.point(step.tip), way=reading.way_round(points, side > 0),
            first=_sentence_start(self._circle(step.start, self._arm(step.start, step.tip))),
            second=self._circle(end, self._arm(step.tip, end)),
        )  # fmt: skip

    def _circle(self, about: str, length: str) -> str:
        return self.reading.say("derivation.circle", about=self.reading.place(about), length=length)

    def _meet(self, step: Meet) -> str:
        reading, circles = self.reading, isinstance(step.second, Arc)
        words = {"first": _sentence_start(self._locus(step.first)), "second": self._locus(step.second)}
        point = names.point(step.point)
        if not circles:
            return reading.say("derivation.meet lines", point=point, **words)
        where = crossing(reading, step)
        note = reading.say("common.note", note=where) if where else ""
        return reading.say("derivation.meet circles", point=point, where=note, **words)

    def _locus(self, locus: Ray | Arc) -> str:
        reading = self.reading
        if isinstance(locus, Arc):
            return reading.say("derivation.circle", about=reading.place(locus.about), length=self._reach(locus.reach))
        match locus.direction:
            case AlongGuide(slide):
                pair = reading.method.structure.slides[slide]
                if pair.guide == FRAME and pair.line.origin == locus.through:
                    return reading.say("derivation.take guide", guide=self.reading.path(slide))
                return self._parallel(locus.through, locus.direction)
            case Along() | Across() | AcrossGuide() | Quarter():
                return self._parallel(locus.through, locus.direction)
            case _:
                assert_never(locus.direction)

    def _parallel(self, through: str, direction: Direction) -> str:
        angle = degrees(self.reading.plot.direction(direction))
        at = self.reading.say("derivation.at direction", angle=angle)
        return self.reading.say("derivation.line parallel", through=self.reading.place(through), direction=at)

    def _corner(self, link: str, corners: tuple[str, str, str]) -> str:
        """A third point of a link whose two points are drawn."""
        reading = self.reading
        first, second, third = corners
        one, other = (reading.plot.arm(p, third) for p in (first, second))
        lengths = [self._arm(first, third), self._arm(second, third)]
        point, called = names.point(third), reading.link(link)
        if abs(cross(one, other)) <= reading.noise * abs(one):
            line = names.pair(first, second)
            both = reading.say("common.and").join(lengths)
            return reading.say("derivation.shape line", point=point, link=called, line=line, length=both)
        ccw = float(cross(reading.plot.arm(first, second), reading.plot.arm(first, third))) > 0
        words = {"first": lengths[0], "second": lengths[1], "way": reading.way_round(corners, ccw)}
        return reading.say("derivation.shape corner", point=point, link=called, **words)


def _sentence_start(text: str) -> str:
    return text[0].upper() + text[1:]
