"""Vectors that are made of others as wholes: one call of complex numbers stands for several of real ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphkin.running.compiled.needed import works
from graphkin.running.compiled.products import ROUNDING
from graphkin.running.compiled.tape import Parts, Signed, Tape
from graphkin.value import frozen


@frozen
class Made:
    """A vector by its number: `ratio` times another, or what a triangle's third corner is to the two before it.

    places, twins  of its parts, x and y; and those in the order of the tape: where the second stands, both are made
    of     places of the parts of those it is made of
    """

    number: int
    ratio: complex
    first: int
    second: int | None
    places: tuple[int, int]
    twins: tuple[int, int]
    of: tuple[int, ...]


def made_of_others(tape: Tape, pairs: Sequence[Parts]) -> Iterator[Made]:
    """Those of some vectors that can be made of others among them."""
    numbers = {pair: number for number, pair in enumerate(pairs)}
    whole = [number for number, pair in enumerate(pairs) if all(works(tape, place) for place, _ in pair)]
    for number in whole:
        found = _image(tape, pairs[number], numbers) or _multiple(tape, pairs, number, whole)
        if found is None:
            continue
        first, second, ratio = found
        sources = [first] if second is None else [first, second]
        of = tuple(place for source in sources for place, _ in pairs[source])
        (x, _), (y, _) = pairs[number]
        begin, end = sorted((x, y))
        if begin < end and max(of) < end and {*sources} <= {*whole}:
            yield Made(number, ratio, first, second, (x, y), (begin, end), of)


def _image(tape: Tape, pair: Parts, numbers: Mapping[Parts, int]) -> tuple[int, int, complex] | None:
    known = tape.images.get(pair)
    if known is None:
        return None
    first, second, ratio = known
    if first not in numbers or second not in numbers:
        return None
    return numbers[first], numbers[second], ratio


def _multiple(
    tape: Tape, pairs: Sequence[Parts], number: int, whole: Sequence[int]
) -> tuple[int, None, complex] | None:
    """The first vector, entered before, of which it is a multiple, perhaps turned by a right angle."""
    (k, x), (m, y) = (_scaled(tape, part) for part in pairs[number])
    last = max(place for place, _ in pairs[number])
    for other in whole:
        if max(place for place, _ in pairs[other]) >= last:
            continue
        (by, a), (with_, b) = (_scaled(tape, part) for part in pairs[other])
        if (x, y) == (a, b) and abs(k / by - m / with_) <= ROUNDING * abs(k / by):
            return other, None, complex(k / by, 0.0)
        if (x, y) == (b, a) and abs(k / with_ + m / by) <= ROUNDING * abs(m / by):
            return other, None, complex(0.0, m / by)
    return None


def _scaled(tape: Tape, part: Signed) -> tuple[float, int]:
    number, rest = tape.scaled(part[0])
    return number * part[1], rest
