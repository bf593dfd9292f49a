"""Which operations of a tape are carried out: what nobody reads is left out, and quotients are divided."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from graphkin.running.compiled.operations import GIVEN, NUMBER, RISKY, SIDE, Operation
from graphkin.running.compiled.tape import Tape

WHOLE = "whole"
"""A vector made of others as wholes; `number` is its own. No tape has this, either."""
DIVIDE = "divide"
"""A product with what is the reciprocal of something for it alone; no tape has this."""


class Whole(NamedTuple):
    """Where the parts of a vector are made at once, and how."""

    at: int
    operation: Operation


def works(tape: Tape, place: int) -> bool:
    """Whether something is to be done for it."""
    return tape.operations[place].does not in (NUMBER, GIVEN, SIDE)


def needed(tape: Tape, results: Iterable[int], wholes: Mapping[int, Whole] = {}) -> dict[int, Operation]:
    """Operations to be done for some results, or that may fail, by place, in their order; signs are no work of their
    own. What is made of vectors as `wholes`, by the places of their parts, stands where the last part stood."""
    results = {*results}
    done = _reached(tape, results, wholes)
    uses = Counter(tape.unsigned(of)[0] for operation in done.values() for of in operation.of)
    for place, operation in [*done.items()]:
        if operation.does == "multiply" and (by := _divisor(tape, operation, uses, results)) is not None:
            reciprocal = operation.of[by]
            done[place] = _quotient(tape, operation.of[1 - by], tape.operations[reciprocal].of[0], done, place)
            del done[reciprocal]
    return done


def _quotient(tape: Tape, a: int, b: int, done: Mapping[int, Operation], place: int) -> Operation:
    """a / b; a side divided by b is 1 by their product, if that is there: it comes out with either sign."""
    whole = tape.known(Operation("multiply", (min(a, b), max(a, b))))
    if whole is not None and tape.operations[a].does == SIDE and whole in done and whole < place:
        return Operation("reciprocal", (whole,))
    return Operation(DIVIDE, (a, b))


def _divisor(tape: Tape, product: Operation, uses: Counter[int], results: set[int]) -> int | None:
    """Which factor is a reciprocal that nothing else needs."""
    for which, factor in enumerate(product.of):
        if tape.operations[factor].does == "reciprocal" and uses[factor] == 1 and factor not in results:
            return which
    return None


def _reached(tape: Tape, results: set[int], wholes: Mapping[int, Whole]) -> dict[int, Operation]:
    waiting = [*results, *(place for place, operation in enumerate(tape.operations) if operation.does in RISKY)]
    found: set[int] = set()
    while waiting:
        place = waiting.pop()
        if place in wholes:
            place = wholes[place].at
        if place not in found and works(tape, place):
            found.add(place)
            operation = wholes[place].operation if place in wholes else tape.operations[place]
            waiting += (tape.unsigned(of)[0] for of in operation.of)
    return {place: wholes[place].operation if place in wholes else tape.operations[place] for place in sorted(found)}
