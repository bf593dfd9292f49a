"""Lengths of the mechanism on paper, and guide lines turned about their pivots until they pass where they must."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from math import copysign, degrees

from graphkin.base.geometry import cross, dot
from graphkin.construction import Arm, LayOff, Slid, Span, Swing
from graphkin.model.pairs import Slide, Slot
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.dimensions import guide_angle, link_sizes
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Formula, Operand, TrigFormula
from graphkin.say.numbers import degrees as degrees_of
from graphkin.say.numbers import heading, number
from graphkin.say.reading import Reading, aside
from graphkin.say.sizes import DrawnAngle


@dataclass
class Tangents:
    """Words of lengths on paper, of swings, and of what is laid off beside the line a swing has found.

    moving   the reading by which the mechanism moves: with its drivers, where poses give the drawn position
    used     pairs of points whose distance the polygons need; those that nothing gives are measured at the end
    measured pairs of points whose distance has been told
    swung    the last swing of each link; marked: points on its line that were told with another
    """

    reading: Reading
    moving: Reading
    used: tuple[tuple[str, str], ...] = ()
    measured: set[frozenset[str]] = field(default_factory=set)
    swung: dict[str, Swing] = field(default_factory=dict)
    marked: set[str] = field(default_factory=set)

    def _length(self, name: str, symbol: str, metres: float) -> str:
        """`AB = l_AB/μ_l = 0.024/0.001 = 24 mm`."""
        scale = self.reading.scales["length"]
        numbers = Operand(metres) / Operand(scale)
        chain = (name, f"{symbol}/μ_l") if name else (f"{symbol}/μ_l",)
        return Calculation(chain[0], chain[1:], numbers, metres / scale, "mm").text

    def _arm(self, tail: str, head: str) -> str:
        pair = names.pair(tail, head)
        return self._length(pair, f"l_{pair}", self.reading.distance(tail, head))

    def _circle(self, about: str, length: str) -> str:
        return self.reading.say("derivation.circle", about=self.reading.place(about), length=length)

    def _reach(self, span: Span, name: str = "") -> str:
        """A radius or a stretch: an arm, a displacement, or several of them end to end."""
        reading, first, last = self.reading, span.parts[0], span.parts[-1]
        metres = abs(complex(reading.plot.span(span)))
        if len(span.parts) == 1 and not isinstance(first, Arm):
            pair, symbol = reading.method.structure.slides[first.slide], reading.displacement("s", first.slide)
            if not pair.named and pair.line.named:
                ends = names.pair(pair.line.origin, pair.point)
                return self._length(name or ends, f"l_{ends}", metres)
            return self._length(name, f"|{symbol}|" if reading.plot.s[first.slide] < 0 else symbol, metres)
        tail, head = self._ends(first)[0], self._ends(last)[1]
        text = self._length(name or names.pair(tail, head), f"l_{names.pair(tail, head)}", metres)
        if len(span.parts) > 1:
            self.measured.add(frozenset((tail, head)))
            parts = [
                f"l_{names.pair(part.tail, part.head)}" if isinstance(part, Arm)
                else reading.displacement("s", part.slide) for part in span.parts
            ]  # fmt: skip
            text += reading.note(reading.say("derivation.composed", parts=reading.listed(parts)))
        return text

    def _ends(self, part: Arm | Slid) -> tuple[str, str]:
        """The points between which a part of a reach lies, in its direction."""
        if isinstance(part, Arm):
            return part.tail, part.head
        pair = self.reading.method.structure.slides[part.slide]
        return (pair.line.origin, pair.point) if part.sign > 0 else (pair.point, pair.line.origin)

    def _ruler(self, name: str, line: str, metres: float) -> str:
        """`BC = 58.87 mm, so l_BC = μ_l·BC = 0.001 × 58.87 = 0.05887 m`."""
        reading, scale = self.reading, self.reading.scales["length"]
        metres = metres if abs(metres) > reading.noise else 0.0
        paper = Calculation(line or f"{name}/μ_l", (), "", metres / scale, "mm").text
        formula = (f"μ_l·{line}",) if line else ()
        figures = Operand(scale) * Operand(metres / scale)
        return reading.say("derivation.ruled", paper=paper, real=Calculation(name, formula, figures, metres, "m").text)

    def _used(self) -> Iterator[Entry]:
        """The distances that the polygons divide by and that no link gives."""
        reading, lengths = self.reading, list[str]()
        structure = reading.method.structure
        given = [{letter, c} for letter, wheels in touching(structure) for c in wheels.centres]
        given += [{*link.points} for link in reading.mechanism.links.values()]
        given += [{*points} for points in structure.bodies.values()]
        for first, second in self.used:
            pair = frozenset((first, second))
            if pair not in self.measured and not any(pair <= points for points in given):
                self.measured.add(pair)
                line = names.pair(first, second)
                lengths.append(self._ruler(f"l_{line}", line, reading.distance(first, second)))
        if lengths:
            said = reading.say("common.semicolon").join(lengths)
            yield Sentence(reading.say("derivation.measured used", lengths=said))

    def _swing(self, step: Swing) -> str:
        reading, along = self.reading, self.reading.guide(step.slide)
        arm, offset, foot = reading.arm(step.pivot, step.through), self._offset(step), self._feet.get(step.slide, "")
        words = {"pivot": reading.place(step.pivot), "through": reading.place(step.through)}
        words["link"] = reading.link(step.link)
        if offset <= reading.noise:
            return reading.say("derivation.swing join", **words)
        formula, figures = self._sum(step, reading.method.structure.slides[step.slide], offset)
        chain = Calculation("h", (formula,) if formula else (), figures, offset, "m").text
        on_paper = reading.say("derivation.on paper", length=self._length("", "h", offset))
        words |= {"length": f"{chain}{on_paper}", "foot": foot}
        if abs(float(dot(along, arm))) <= reading.noise:
            return reading.say("derivation.swing foot", **words)
        path = "→".join((names.point(step.pivot), foot, names.point(step.through)))
        ccw = float(cross(arm - float(dot(along, arm)) * along, arm)) > 0  # from the foot to what it passes through
        words["way"] = reading.say("common.way round", way=path, sense=reading.sense(1 if ccw else -1))
        pair = reading.method.structure.slides[step.slide]
        # the point may lie beside the guide line, on a block that turns with it: then a parallel line is drawn
        parallel = aside(along, reading.arm(pair.line.origin, step.through)) > reading.noise
        return reading.say("derivation.swing beside" if parallel else "derivation.swing tangent", **words)

    def _offset(self, step: Swing) -> float:
        """The distance at which the guide line passes the pivot [m]."""
        return aside(self.reading.guide(step.slide), self.reading.arm(step.pivot, step.through))

    def _sum(self, step: Swing, pair: Slide, offset: float) -> tuple[str, Formula | str]:
        """`l_CD sin γ`; `l_DM sin 20° + r_C` or `r1` where a face passes the pivot at a distance; "" of others."""
        reading, slot = self.reading, pair.path if pair.stands_for is None else pair.stands_for.equivalent
        assert isinstance(slot, Slot), pair
        radius, link = abs(slot.offset), reading.mechanism.links[slot.line.link]
        symbol = reading.rim(pair.stands_for) if pair.stands_for is not None and radius else ""
        if radius and abs(offset - radius) <= reading.noise:
            return symbol, ""
        if not slot.line.named or step.pivot not in link.points or step.pivot == slot.line.origin:
            return "", ""
        arm = link.arm(step.pivot, slot.line.origin)
        turned, away = abs(degrees(phase(slot.line.direction / arm))), aside(slot.line.direction, arm)
        angle = guide_angle(reading, pair)
        gamma = angle.symbol if angle is not None and angle.corner == step.pivot else ""
        sine = TrigFormula("sin", turned if gamma else min(turned, 180 - turned))
        length, rim = Operand(abs(arm)), Operand(radius)
        name = f"l_{names.pair(step.pivot, slot.line.origin)} {f'sin {gamma}' if gamma else sine.text()}"
        sums: dict[float, tuple[str, Formula | str]] = {
            away - radius: (f"{name} − {symbol}", length * sine - rim),
            radius - away: (f"{symbol} − {name}", rim - length * sine),
            away + radius: (f"{name} + {symbol}", length * sine + rim) if radius else (name, length * sine),
        }
        return next((each for size, each in sums.items() if abs(size - offset) <= reading.noise), ("", ""))

    def _beside_guide(self, step: LayOff) -> str:
        """A further point of a link whose guide line has just been drawn, by how it lies to that line; "" of others."""
        reading, part = self.reading, step.term.size.parts[0] if isinstance(step.term.size, Span) else None
        if not isinstance(part, Arm) or part.link not in self.swung:
            return ""
        swing = self.swung[part.link]
        along, arm = reading.guide(swing.slide), reading.arm(step.start, step.tip)
        if aside(along, reading.arm(swing.through, step.tip)) <= reading.noise:
            return self._on_tangent(step, swing)
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip)}
        words["length"] = self._arm(step.start, step.tip)
        if aside(along, arm) <= reading.noise:
            return reading.say("derivation.lay off parallel", heading=heading(degrees_of(arm), reading.lang), **words)
        ahead = along * copysign(1.0, float(dot(along, arm)) or 1.0)
        turned = degrees(phase(arm / ahead))
        points = [swing.through, *reading.mechanism.named(part.link)]
        arms = ((p, reading.arm(step.start, p)) for p in points)
        on_line = {p: arm for p, arm in arms if aside(ahead, arm) <= reading.noise < abs(float(dot(ahead, arm)))}
        on_it = next((p for p in points[1:] if p in on_line), "")
        if on_it and not self._angled(part.link, step.start):  # its triangle is given by its sides
            words |= {"first": self._circle(step.start, words["length"]), "along": self._arm(step.start, on_it)}
            words["heading"] = heading(degrees_of(reading.arm(step.start, on_it)), reading.lang)
            self.marked.add(on_it)
            words |= {"second": self._circle(on_it, self._arm(step.tip, on_it)), "mark": names.point(on_it)}
            ccw = float(cross(arm, reading.arm(step.start, on_it))) > 0
            order = reading.way_round((step.start, step.tip, on_it), ccw)
            return reading.say("derivation.on line, by sides", way=order, **words)
        ray = corner = ""
        if mark := next((p for p in (swing.through, on_it) if p and reading.named(p) and p in on_line), ""):
            turned = degrees(phase(arm / on_line[mark]))
            ray, corner = names.pair(step.start, mark), f"∠{''.join(map(names.point, (step.tip, step.start, mark)))} = "
        words |= {"sense": reading.sense(turned), "line": ray, "turned": f"{corner}{number(abs(turned))}°"}
        return reading.say("derivation.lay off turned", which=not ray, **words)

    def _angled(self, link: str, corner: str) -> bool:
        """True of a corner of a link whose angle the file gives."""
        shapes = (size.shape for size in link_sizes(self.reading, link))
        return any(isinstance(shape, DrawnAngle) and shape.points[1] == corner for shape in shapes)

    def _on_tangent(self, step: LayOff, swing: Swing) -> str:
        """A point of the guide line itself: how far from the foot, and which way."""
        reading, along = self.reading, self.reading.guide(swing.slide)
        through, tip = reading.at(swing.through), reading.at(step.tip)
        foot = through - float(dot(along, reading.arm(swing.pivot, swing.through))) * along
        words = {"start": reading.place(step.start), "tip": reading.place(step.tip)}
        words["length"] = self._arm(step.start, step.tip)
        if abs(tip - foot) <= reading.noise or not reading.distance(step.start, step.tip):
            return reading.say("derivation.at the foot", **words)
        ahead = float(dot(through - foot, tip - foot))
        at_pivot = self._offset(swing) <= reading.noise
        name = reading.place(swing.pivot) if at_pivot else self._feet[swing.slide]
        words |= {"foot": name, "through": reading.place(swing.through)}
        return reading.say("derivation.on tangent", which=ahead <= 0, **words)

    @cached_property
    def _feet(self) -> dict[str, str]:
        return feet(self.reading)


def feet(reading: Reading) -> dict[str, str]:
    """Letters that no point of the mechanism takes, by slide: where guide lines touch the circles about pivots."""
    letters = (mark for k in count() for letter in "TUVZ" if (mark := letter + "′" * k) not in reading.mechanism.owners)
    swings = [step for step in reading.method.position.steps if isinstance(step, Swing)]
    offsets = {step.slide: aside(reading.guide(step.slide), reading.arm(step.pivot, step.through)) for step in swings}
    return {slide: next(letters) for slide, offset in offsets.items() if offset > reading.noise}
