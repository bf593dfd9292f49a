"""Right answers under other names and by other methods: none of them is called wrong."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import assert_never

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.errors import GraphkinError
from graphkin.marking.answers import arrows_of, drawn_answer, readable
from graphkin.marking.hand import redraw
from graphkin.marking.key import KeyEntry
from graphkin.marking.records import StudentWork
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import Seen
from graphkin.model.quantities import Quantity, kinds
from graphkin.model.quantities.kinds import Answer
from graphkin.model.quantities.reading import read
from graphkin.planning import Method, plan
from graphkin.proof.readings import readings

_SAME = 1e-9  # answers that differ by a smaller part are the same


@frozen
class OtherWay:
    """A right answer of another name, or the same one given otherwise.

    kind      "reversed": the motion seen the other way round (B2B3 for B3B2, -k for k); "coincident": at another
              coincident point of the same two links; "size": a rotation without its sign, its sense said in words;
              "centre": the instant centre about which a point moves
    """

    kind: str
    quantity: Quantity
    answer: Answer


def other_ways(method: Method, plot: Plot, quantity: Quantity) -> tuple[OtherWay, ...]:
    """Every other way to give a quantity, with its answer at the positions of a right plot."""
    right, arrows = redraw(method, plot), arrows_of(method)

    def answered(kind: str, other: Quantity) -> OtherWay:
        return OtherWay(kind, other, drawn_answer(method, right, other, arrows))

    match quantity:
        case kinds.Rotation(word="omega" | "alpha"):
            value = drawn_answer(method, right, quantity, arrows).value
            return (OtherWay("size", quantity, Answer(np.abs(value), quantity.unit)),)
        case kinds.Moving(seen_from=seen_from):
            mechanism, of = method.mechanism, quantity.site
            if seen_from is None:
                links = (of.link,) if of.explicit else mechanism.owners.get(of.point, ())
                moving = [link for link in links if link != FRAME and quantity.letter == "v"]
                names = {link: f"{mechanism.called(link)},{mechanism.frame}" for link in moving}
                return tuple(answered("centre", kinds.Centre("P", names[link], (link, FRAME))) for link in moving)
            answers = [answered("reversed", other) for other in _read_as(mechanism, quantity, seen_from, of)]
            # coincident points at every other named point of either link
            named = dict.fromkeys((*mechanism.named(of.link), *mechanism.named(seen_from.link)))
            for point in named if of.point == seen_from.point else ():
                if point != of.point:
                    sites = Seen(point, of.link, True), Seen(point, seen_from.link, True)
                    answers += [answered("coincident", other) for other in _read_as(mechanism, quantity, *sites)]
            return tuple(answers)
        case kinds.Rotation() | kinds.Displacement() | kinds.Place() | kinds.Track():
            return ()
        case kinds.Component() | kinds.Centre() | kinds.Quotient():
            return ()
        case _:
            assert_never(quantity)


def other_methods(method: Method) -> Iterator[Method]:
    """The mechanism planned with each other coincident point that its sliding pairs allow."""
    plans = [method]
    for point in method.mechanism.points:
        try:
            other = plan(method.mechanism, point)
        except GraphkinError:
            continue
        if all(other.velocity != known.velocity for known in plans):
            plans.append(other)
            yield other


def _read_as(mechanism: Mechanism, quantity: Quantity, of: Seen, seen_from: Seen) -> Iterator[Quantity]:
    """The quantity of two sites as it is read from text; nothing where no text says it."""
    sites = (of, seen_from)
    short = "".join(site.point + (mechanism.called(site.link) if site.explicit else "") for site in sites)
    for text in (short, ",".join(f"{site.point}@{mechanism.called(site.link)}" for site in sites)):
        try:
            other = read(mechanism, f"{quantity.word} {text}")
        except GraphkinError:
            continue
        if not isinstance(other, kinds.Moving) or other.seen_from is None:
            continue
        if [(site.point, site.link) for site in (other.site, other.seen_from)] == [(s.point, s.link) for s in sites]:
            yield other
            return


def same_answers(method: Method, plot: Plot, quantity: Quantity) -> tuple[str, ...]:
    """Other names under which the answer is this one: B2B3 for B3B2, another coincident point of a block and its guide,
    a link that turns with this one. An order or a point that gives another size, as for a pin's Coriolis acceleration,
    is none."""
    if isinstance(quantity, kinds.Rotation):
        # the same word of the links that a sliding pair holds at an angle to this one
        turns, motions = plot.facts.turns, readings(method, plot)
        own, word = turns.get(quantity.link), quantity.word
        alike = [link for link in method.mechanism.moving if own is not None and word != "theta"
                 and link != quantity.link and link in turns and turns[link].base == own.base]  # fmt: skip
        rotations = (readable(method.mechanism, f"{word} {method.mechanism.called(link)}") for link in alike)
        value = quantity.answer(motions).value
        named = [rotation for rotation in rotations if rotation is not None]
        return tuple(o.text for o in named if np.allclose(o.answer(motions).value, value, _SAME, 0.0))
    if not isinstance(quantity, kinds.Moving) or quantity.seen_from is None:
        return ()
    right = np.abs(quantity.answer(readings(method, plot)).value)
    others = _other_names(method, plot, quantity)
    others += [more for one in others if one.kind == "coincident" for more in _other_names(method, plot, one.quantity)]
    same = (one for one in others if np.allclose(np.abs(one.answer.value), right, _SAME, _SAME * right))
    return tuple(one.quantity.text for one in same)


def called_as_asked(work: StudentWork, asked: Sequence[KeyEntry], same: Mapping[str, Sequence[str]]) -> StudentWork:
    """With numbers under the key's names, where what is asked was handed in under another; `same` by asked text."""
    numbers, unread, texts = dict(work.numbers), dict(work.unread), {entry.text for entry in asked}
    for entry in asked:
        given = (text for text in same[entry.text] if text in unread and text not in texts)
        if entry.text not in unread and (text := next(given, None)) is not None:
            unread[entry.text] = unread.pop(text)
        given = (text for text in same[entry.text] if text in numbers and text not in texts)
        if entry.text not in numbers and (text := next(given, None)) is not None:
            numbers[entry.text] = replace(numbers.pop(text), vector=None)  # it may be seen the other way round
    return replace(work, numbers=numbers, unread=unread)


def _other_names(method: Method, plot: Plot, quantity: Quantity) -> list[OtherWay]:
    return [one for one in other_ways(method, plot, quantity) if one.kind in ("reversed", "coincident")]
