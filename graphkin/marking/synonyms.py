"""The same answer under another name: it is handed in for what is asked, and judged as that."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import Plot
from graphkin.marking.handed import readable
from graphkin.marking.key import KeyEntry
from graphkin.marking.marked import StudentWork
from graphkin.marking.right_ways import OtherWay, other_ways
from graphkin.model.quantities import Moving, Quantity, Rotation
from graphkin.planning import Method
from graphkin.proof.readings import readings

_SAME = 1e-9


def same_answers(method: Method, plot: Plot, quantity: Quantity) -> tuple[str, ...]:
    """Other names under which the answer is this one: B2B3 for B3B2, another coincident point of a block and its guide,
    a link that turns with this one. An order or a point that gives another size, as for a pin's Coriolis acceleration,
    is none."""
    if isinstance(quantity, Rotation):
        return tuple(_turning_alike(method, plot, quantity))
    if not isinstance(quantity, Moving) or quantity.seen_from is None:
        return ()
    right = np.abs(quantity.answer(readings(method, plot)).value)
    ways = [*_ways(method, plot, quantity)]
    ways += [other for way in ways if way.kind == "coincident" for other in _ways(method, plot, way.quantity)]
    same = (way for way in ways if np.allclose(np.abs(way.answer.value), right, _SAME, _SAME * right))
    return tuple(way.quantity.text for way in same)


def called_as_asked(work: StudentWork, asked: Sequence[KeyEntry], same: Mapping[str, Sequence[str]]) -> StudentWork:
    """With numbers under the key's names, where what is asked was handed in under another; `same` by asked text."""
    numbers, texts = dict(work.numbers), {entry.text for entry in asked}
    for entry in asked:
        given = (text for text in same[entry.text] if text in numbers and text not in texts)
        if entry.text not in numbers and (text := next(given, None)) is not None:
            numbers[entry.text] = numbers.pop(text)
    return replace(work, numbers=numbers)


def _ways(method: Method, plot: Plot, quantity: Quantity) -> Iterator[OtherWay]:
    return (way for way in other_ways(method, plot, quantity) if way.kind in ("reversed", "coincident"))


def _turning_alike(method: Method, plot: Plot, quantity: Rotation) -> Iterator[str]:
    """The same word of the links that a sliding pair holds at an angle to this one."""
    turns, motions = plot.facts.turns, readings(method, plot)
    right = quantity.answer(motions).value
    for link in method.mechanism.moving if quantity.word != "theta" and quantity.link in turns else ():
        if link != quantity.link and link in turns and turns[link].base == turns[quantity.link].base:
            other = readable(method.mechanism, f"{quantity.word} {method.mechanism.called(link)}")
            if other is not None and np.allclose(other.answer(motions).value, right, _SAME, 0.0):
                yield other.text
