"""With which sign each result had better lie where it is worked out, so that no call only turns one.

A difference, a multiple, and a quotient of a number come out either way at no cost, a product as its factors lie. So
what wants a sign passes that wish on, from the last operation to the first.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping

from graphkin.running.compiled.operations import NUMBER, Operation
from graphkin.running.compiled.tape import Tape

AS_THEY_ARE = ("sqrt", "maximum", "arctan2")
"""What takes no operands with another sign; `arctan2` its first one only together with its own."""
ROUNDS = 2
"""What is wished last may turn what was settled before: it is gone through again."""
AS_FACTORS = ("multiply", "divide")
"""What comes out as its factors lie."""
TURN = ("add", "subtract", "multiply", "divide", "reciprocal")
"""What can be had with either sign, or may be made of what can."""


def wished(tape: Tape, operations: Mapping[int, Operation], laid: Mapping[int, int]) -> dict[int, int]:
    """The sign of each place; `laid`: of those that are laid down with a sign at once."""
    found: dict[int, int] = {}
    for _ in range(ROUNDS):
        found = _Wishes(tape, operations, laid, _as_it_comes(tape, operations, laid, found)).found
    return found


def _as_it_comes(
    tape: Tape, operations: Mapping[int, Operation], laid: Mapping[int, int], wishes: Mapping[int, int]
) -> dict[int, int]:
    """Each sign, if only sums and multiples are turned as is wished."""
    found: dict[int, int] = {}
    for place, (does, of, _) in operations.items():
        operands = [tape.unsigned(each) for each in of]
        if does in AS_FACTORS and all(tape.operations[each].does != NUMBER for each, _ in operands):
            sign = math.prod(found.get(each, 1) * turned for each, turned in operands)
        else:
            sign = wishes.get(place, 1)
        found[place] = laid.get(place, sign)
    return found


class _Wishes:
    """before: as they come without; found: of what was looked at; votes: of those that need it, for (above 0) and
    against a place as it is."""

    def __init__(
        self, tape: Tape, operations: Mapping[int, Operation], laid: Mapping[int, int], before: Mapping[int, int]
    ) -> None:
        self.tape, self.operations, self.laid, self.before = tape, operations, laid, before
        self.votes: Counter[int] = Counter()
        self.found: dict[int, int] = {}
        for place in [*operations][::-1]:
            self.found[place] = self._sign(place)
            self._pass_on(operations[place], self.found[place], place in laid or self.votes[place] != 0)

    def _sign(self, place: int) -> int:
        """As far as is known by now."""
        votes = self.votes[place]
        return self.laid.get(place, self.before.get(place, 1) if votes == 0 else 1 if votes > 0 else -1)

    def _pass_on(self, operation: Operation, sign: int, matters: bool) -> None:
        does, of, _ = operation
        operands = [self.tape.unsigned(each) for each in of]
        if does in AS_THEY_ARE:
            for which, (place, turned) in enumerate(operands):
                self.votes[place] += sign * turned if does == "arctan2" and which == 0 else turned
        elif matters and len(of) == 2 and all(self.tape.operations[place].does != NUMBER for place, _ in operands):
            signs = [self._sign(place) * turned for place, turned in operands]
            if does == "subtract":
                signs[1] = -signs[1]
            wrong = signs[0] * signs[1] != sign if does in ("multiply", "divide") else signs[0] == signs[1] == -sign
            if wrong:
                self._turn([place for place, _ in operands])

    def _turn(self, places: list[int]) -> None:
        """Wish one of them otherwise, that about which least is wished."""
        free = [place for place in places if place not in self.laid and place in self.operations]
        free = [place for place in free if self.operations[place].does in TURN]
        if free and places[0] != places[-1]:
            place = min(free, key=lambda place: (abs(self.votes[place]), self.operations[place].does in AS_FACTORS))
            self.votes[place] -= self._sign(place)
