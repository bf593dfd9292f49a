"""Where the results of a tape are to lie: numbers in rows, vectors with their parts side by side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from graphkin.geometry import Value
from graphkin.running.compiled.calls import Calls
from graphkin.running.compiled.columns import Column, Columns, Judged, Pair, Place, Vector, told_apart
from graphkin.running.compiled.operations import NUMBER
from graphkin.running.compiled.recorder import Recording, Written
from graphkin.running.compiled.tape import Tape
from graphkin.running.compiled.writer import Signed, works, written_out

PLANES = ("position", "velocity", "acceleration")
"""Tables of vectors; the others are of numbers."""

Tables = Mapping[str, Mapping[Any, Value]]


def laid_out(recording: Recording, tables: Tables, given: int) -> tuple[Calls, Mapping[str, Columns]]:
    """The calls that a recording comes to, and where each quantity of its plot is found after them."""
    layout = _Layout(recording.tape)
    for value in (*tables["sines"].values(), *recording.sound):
        layout.show(value)
    sines = len(layout.rows)
    places = {
        name: {key: layout.vector(value) if name in PLANES else layout.show(value) for key, value in table.items()}
        for name, table in tables.items()
    }
    parts = [part for pair in layout.pairs for part in pair]
    return written_out(layout.tape, given, sines, [*layout.rows.items()], parts), told_apart(places)


class _Layout:
    """What of a tape is shown so far: rows by place, with their signs, and pairs, each once.

    parts  which part of a vector a place is, and with which sign: it need not be a row, too
    """

    def __init__(self, tape: Tape) -> None:
        self.tape = tape
        self.rows: dict[int, int] = {}
        self.numbers: dict[int, int] = {}
        self.pairs: dict[tuple[Signed, Signed], int] = {}
        self.parts: dict[int, tuple[int, int]] = {}

    def show(self, value: Value) -> Place:
        """A number, and where it is found."""
        if isinstance(value, Judged):
            return value
        if not isinstance(value, Written):
            return Column(number=float(value))
        place, sign = self.tape.unsigned(value.real_at)
        if not works(self.tape, place):
            return self._at_hand(place, sign)
        if place in self.parts and place not in self.rows:
            part, found = self.parts[place]
            return Column(part=part, sign=sign * found)
        self.numbers.setdefault(place, len(self.numbers))
        return Column(row=self.numbers[place], sign=sign * self.rows.setdefault(place, sign))

    def vector(self, value: Value) -> Place:
        """A vector, and where it is found."""
        if not isinstance(value, Written):
            return Vector(*(Column(number=float(part)) for part in (np.real(value), np.imag(value))))
        x, y = self.tape.unsigned(value.real_at), self.tape.unsigned(value.imag_at)
        if not works(self.tape, x[0]) and not works(self.tape, y[0]):
            return Vector(self._at_hand(*x), self._at_hand(*y))
        number = self.pairs.setdefault((x, y), len(self.pairs))
        for side, (place, sign) in enumerate((x, y)):
            self.parts.setdefault(place, (2 * number + side, sign))
        return Pair(number)

    def _at_hand(self, place: int, sign: int) -> Column:
        """What takes no work."""
        does, _, number = self.tape.operations[place]
        return Column(number=sign * number) if does == NUMBER else Column(given=int(number), sign=sign)
