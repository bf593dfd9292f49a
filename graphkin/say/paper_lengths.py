"""Lengths of the mechanism on paper: laid off from what is given, measured where nothing gives them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from graphkin.construction import Arm, Span
from graphkin.planning.position import touching
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Operand
from graphkin.say.reading import Reading


@dataclass
class PaperLengths:
    """Turns lengths into millimetres on paper, and back.

    moving   the reading by which the mechanism moves: with its drivers, where poses give the drawn position
    used     pairs of points whose distance the polygons need; those that nothing gives are measured at the end
    measured pairs of points whose distance has been told
    """

    reading: Reading
    moving: Reading
    used: tuple[tuple[str, str], ...] = ()
    measured: set[frozenset[str]] = field(default_factory=set)

    def _length(self, name: str, symbol: str, metres: float) -> str:
        """`AB = l_AB/μ_l = 0.024/0.001 = 24 mm`."""
        scale = self.reading.scales["length"]
        numbers = Operand(metres) / Operand(scale)
        chain = (name, f"{symbol}/μ_l") if name else (f"{symbol}/μ_l",)
        return Calculation(chain[0], chain[1:], numbers, metres / scale, "mm").text

    def _reach(self, span: Span, name: str = "") -> str:
        """A radius or a stretch: an arm, a displacement, or several of them end to end."""
        first, last = span.parts[0], span.parts[-1]
        metres = float(abs(self.reading.plot.span(span)))
        if len(span.parts) == 1 and not isinstance(first, Arm):
            pair = self.reading.method.structure.slides[first.slide]
            symbol = self._displacement(first.slide)
            if not pair.named and pair.line.named:
                ends = names.pair(pair.line.origin, pair.point)
                return self._length(name or ends, f"l_{ends}", metres)
            return self._length(name, f"|{symbol}|" if self.reading.plot.s[first.slide] < 0 else symbol, metres)
        tail = first.tail if isinstance(first, Arm) else self._ends(first.slide, first.sign)[0]
        head = last.head if isinstance(last, Arm) else self._ends(last.slide, last.sign)[1]
        text = self._length(name or names.pair(tail, head), f"l_{names.pair(tail, head)}", metres)
        if len(span.parts) > 1:
            self.measured.add(frozenset((tail, head)))
            text += self.reading.say("common.note", note=self._composed(span))
        return text

    def _composed(self, span: Span) -> str:
        """What a reach is made of: arms and displacements at known angles."""
        found = []
        for part in span.parts:
            if isinstance(part, Arm):
                found.append(f"l_{names.pair(part.tail, part.head)}")
            else:
                found.append(self._displacement(part.slide))
        return self.reading.say("derivation.composed", parts=self.reading.listed(found))

    def _displacement(self, slide: str) -> str:
        pair = self.reading.method.structure.slides[slide]
        return names.of_slide("s", slide if pair.named else names.point(pair.point))

    def _ends(self, slide: str, sign: int) -> tuple[str, str]:
        pair = self.reading.method.structure.slides[slide]
        ends = (pair.line.origin, pair.point)
        return ends if sign > 0 else ends[::-1]

    def _arm(self, tail: str, head: str) -> str:
        pair = names.pair(tail, head)
        return self._length(pair, f"l_{pair}", self.reading.distance(tail, head))

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
        reading, found = self.reading, list[str]()
        for first, second in self.used:
            pair = frozenset((first, second))
            if pair in self.measured or self._given(first, second):
                continue
            self.measured.add(pair)
            line = names.pair(first, second)
            found.append(self._ruler(f"l_{line}", line, reading.distance(first, second)))
        if found:
            yield Sentence(reading.say("derivation.measured used", lengths=reading.say("common.semicolon").join(found)))

    def _given(self, first: str, second: str) -> bool:
        """Whether one link, or a contact, holds two points apart."""
        links = self.reading.mechanism.links.values()
        contact = {(letter, c) for letter, found in touching(self.reading.method.structure) for c in found.centres}
        apart = any(first in link.points and second in link.points for link in links)
        rods = self.reading.method.structure.bodies.values()
        beside = (first, second) in contact or (second, first) in contact
        return apart or beside or any(first in rod and second in rod for rod in rods)
