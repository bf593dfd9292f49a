"""Where the results of a tape are to lie: numbers in rows, vectors with their parts side by side."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Set
from functools import cached_property
from typing import Any

import numpy as np

from graphkin.geometry import Value
from graphkin.running.compiled.calls import Calls
from graphkin.running.compiled.columns import (
    Column,
    Columns,
    Entry,
    Judged,
    Late,
    LateVector,
    Pair,
    Place,
    Vector,
    told_apart,
)
from graphkin.running.compiled.needed import works
from graphkin.running.compiled.operations import NUMBER
from graphkin.running.compiled.recorder import Recording, Written
from graphkin.running.compiled.tape import Signed, Tape
from graphkin.running.compiled.writer import written_out
from graphkin.value import frozen

PLANES = ("position", "velocity", "acceleration")
"""Tables of vectors; the others are of numbers."""
Tables = Mapping[str, Mapping[Any, Value]]


@frozen
class Layout:
    """What a recording comes to.

    calls    by which everything is worked out but what is asked for late
    late     what that is, on the tape
    columns  where each quantity of the plot is found, by table and name
    spare    registers that no run has in hand: a run takes a set from here, or new ones, so runs never share any
    """

    tape: Tape
    calls: Calls
    late: tuple[Signed, ...]
    columns: Mapping[str, Columns]
    spare: list[np.ndarray]

    @cached_property
    def late_calls(self) -> Calls:
        return written_out(self.tape, self.calls.given, 0, self.late)


def laid_out(
    recording: Recording, tables: Tables, given: int, at_once: Set[Entry], arrays: Collection[int] = ()
) -> Layout:
    """Where everything is to lie; what is not wanted `at_once` is worked out late, if ever.

    arrays  which of what is given has an entry a position
    """
    tape, layout = recording.tape, _Layout(recording.tape, arrays)
    sines = [value.real_at for value in (*tables["sines"].values(), *recording.sound) if isinstance(value, Written)]
    doubts = [place for place in dict.fromkeys(tape.unsigned(place) for place in sines) if works(tape, place[0])]
    found: dict[Entry, Place] = {}
    entries = [(name, key, value) for name, table in tables.items() for key, value in table.items()]
    for name, key, value in entries:
        if (name, key) in at_once:
            found[name, key] = layout.vector(value) if name in PLANES else layout.show(value)
    for name, key, value in entries:
        if (name, key) not in at_once:
            found[name, key] = layout.vector_late(value) if name in PLANES else layout.tell_late(value)
    places = {name: {key: found[name, key] for key in table} for name, table in tables.items()}
    parts = [part for pair in layout.pairs for part in pair]
    calls = written_out(tape, given, len(doubts), [*doubts, *layout.rows.items()], parts)
    return Layout(tape, calls, (*layout.late,), told_apart(places), [])


class _Layout:
    """What of a tape is shown so far: rows by place, with their signs, and pairs, each once.

    copied places of what is given at each position: with the rest, while it is in the cache
    parts  which part of a vector a place is, and with which sign: it need not be a row, too
    """

    def __init__(self, tape: Tape, arrays: Collection[int]) -> None:
        self.tape = tape
        self.copied = {tape.given(k) for k in arrays}
        self.rows: dict[int, int] = {}
        self.numbers: dict[int, int] = {}
        self.pairs: dict[tuple[Signed, Signed], int] = {}
        self.parts: dict[int, tuple[int, int]] = {}
        self.late: dict[Signed, int] = {}

    def show(self, value: Value) -> Place:
        """A number, and where it is found."""
        if isinstance(value, Judged):
            return value
        place, sign = self._unsigned(value)
        if (known := self._known(place, sign)) is not None:
            return known
        self.numbers[place] = len(self.numbers)
        self.rows[place] = sign
        return Column(row=self.numbers[place])

    def _known(self, place: int, sign: int) -> Column | None:
        """Where it is found that takes no more work."""
        if not works(self.tape, place) and place not in self.copied:
            return self._at_hand(place, sign)
        if place in self.rows:
            return Column(row=self.numbers[place], sign=sign * self.rows[place])
        if place in self.parts:
            part, found = self.parts[place]
            return Column(part=part, sign=sign * found)
        return None

    def tell_late(self, value: Value) -> Place:
        """A number that is worked out when it is asked for, if it is not at hand."""
        return value if isinstance(value, Judged) else self._late(*self._unsigned(value))

    def vector_late(self, value: Value) -> Place:
        """The same of a vector."""
        if not isinstance(value, Written):
            return self.vector(value)
        x, y = (self._late(*self.tape.unsigned(part)) for part in (value.real_at, value.imag_at))
        return Vector(x, y) if isinstance(x, Column) and isinstance(y, Column) else LateVector(x, y)

    def _late(self, place: int, sign: int) -> Late | Column:
        """What lies in a row or a part is worked out again, too: those are in others' hands."""
        if not works(self.tape, place):
            return self._at_hand(place, sign)
        return Late(self.late.setdefault((place, 1), len(self.late)), sign)

    def _unsigned(self, value: Value) -> Signed:
        return self.tape.unsigned(value.real_at if isinstance(value, Written) else self.tape.number(float(value)))

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
