"""The goal of a solution: what is asked, in the symbols of the field, and how far one has to go for it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING, assert_never

from graphkin.base.cache import kept
from graphkin.base.value import frozen
from graphkin.construction import Equation, Image, LayOff, Normal, Plane, Tangential, Turning
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import Quantity
from graphkin.model.quantities.kinds import Centre, Component, Displacement, Moving, Place, Quotient, Rotation, Track
from graphkin.model.quantities.reading import read
from graphkin.planning.asked import PLANES, all_motions, asked_parts, facts_of, plane_of
from graphkin.planning.at_rest import moving_parts
from graphkin.planning.needed import Part, arms, needed
from graphkin.say import names
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.reading import Reading, aside, capitalized

if TYPE_CHECKING:
    from graphkin.say.centre_steps import CentrePart


@frozen
class SolutionGoal:
    """The quantities that a solution is to find, and how far it goes.

    wanted   what it answers; None for a text that is only shown
    texts    as the file asks
    parts    of both polygons what leads there; a polygon that leads to nothing is not among them
    chosen   the file's questions decide how far it goes
    """

    reading: Reading
    wanted: tuple[Quantity | None, ...]
    texts: tuple[str, ...]
    parts: dict[Plane, tuple[Part, ...]]
    chosen: bool

    @cached_property
    def centred(self) -> CentrePart | None:
        """The part of the solution that finds the instant centres asked for, and that of a pushed link."""
        centres = _centres(self.reading.mechanism, self.wanted, self.pushed)
        if not centres:
            return None
        from graphkin.say.centre_steps import centre_part

        return centre_part(self.reading, centres)

    @cached_property
    def pushed(self) -> Mapping[tuple[str, str], list[Quantity]]:
        """The velocities asked of a link that the driven one pushes in sliding contact, both joined to the frame."""
        return _pushed(self.reading.mechanism, self.wanted) if self.reading.ruler is None else {}

    @property
    def levers(self) -> tuple[tuple[str, str], ...]:
        """The pairs of points by whose distance the polygons multiply or divide."""
        method, rested = self.reading.method, self.reading.rested
        shown = (part for plane, parts in self.parts.items() for part in moving_parts(method, plane, parts, rested))
        return tuple(dict.fromkeys(pair for part in shown for pair in self._arms(part)))

    def _arms(self, part: Part) -> Iterator[tuple[str, str]]:
        """The arms of one part by which something is multiplied, or divided in an image on a line."""
        if isinstance(part, Equation):
            for step in part.steps:
                yield from self._arms(step)
            return
        if isinstance(part, Image):
            first, *others = part.corners
            arms_of = [self.reading.arm(first, each) for each in others]
            if aside(*arms_of) <= self.reading.noise * max(map(abs, arms_of)):
                yield from ((min(first, each), max(first, each)) for each in others)
            return
        size = part.term.size if isinstance(part, LayOff) else None
        if not isinstance(size, Turning | Normal | Tangential) or not self.reading.translates(size.link):
            yield from arms(part)

    @property
    def angles(self) -> frozenset[str]:
        """The links whose angles are asked for."""
        halves = [half for one in self.wanted if one is not None for half in one.halves]
        rotations = [half for half in halves if isinstance(half, Rotation)]
        return frozenset(half.link for half in rotations if half.word == "theta")

    def question(self) -> Iterator[Entry]:
        """The part of a solution that says what is to be found."""
        say = self.reading.say
        if not self.wanted:
            return
        yield Heading(say("solution.find"))
        asked = zip(self.wanted, self.texts, strict=True)  # a file that asks for no motion has its own questions first
        own = [(one, text) for one, text in asked if one is not None and (self.chosen or _placed(one))]
        if own:
            wanted = self.reading.listed([*self._listed(own)])
            begins = isinstance(own[0][0], Centre | Track)  # with a word, not with a symbol
            yield Sentence(say("solution.find these", wanted=capitalized(wanted) if begins else wanted))
        if not self.chosen:
            yield Sentence(say("solution.find all" if "acceleration" in self.parts else "solution.find velocities"))
        yield from map(Sentence, self.in_words)

    @property
    def in_words(self) -> list[str]:
        """The questions that are no quantities, each a sentence of its own."""
        texts = (text for one, text in zip(self.wanted, self.texts, strict=True) if one is None)
        stop = self.reading.say("solution.find these", wanted="")
        return [text if text[-1] in ".?!。？！" else text + stop for text in texts]

    def _listed(self, asked: Sequence[tuple[Quantity, str]]) -> Iterator[str]:
        """The questions, symbol by symbol; of centres in a row the word once."""
        for centres, some in groupby(asked, key=lambda each: isinstance(each[0], Centre)):
            if centres:
                first, *others = (names.point(text) for _, text in some)
                yield self.reading.say("solution.centre", name=first, which=int(bool(others)))
                yield from others
            else:
                yield from (self.symbol(one) for one, _ in some)

    def symbol(self, quantity: Quantity) -> str:
        """`ω3`, `aᵏ_B3B2`, `v_Cx`, `ω1/ω3`."""
        match quantity:
            case Rotation(_, _, link):
                return self.reading.rate(quantity.letter, link)
            case Displacement(_, _, slide):
                return names.of_slide("s", slide)
            case Track():
                return self.reading.say("solution.place", point=names.point(quantity.of))
            case Place():
                return f"{quantity.word}_{names.point(quantity.of)}"
            case Moving():
                part = f"^{quantity.part}" if quantity.part else ""
                return names.vector(f"{quantity.letter}{part}_{quantity.of}")
            case Component(whole=whole):
                return f"{self.symbol(whole)},{quantity.axis}"
            case Quotient(top=top, bottom=bottom):
                return f"{self.symbol(top)}/{self.symbol(bottom)}"
            case Centre():
                return self.reading.say("solution.centre", name=names.point(quantity.text))
            case _:
                assert_never(quantity)


def solution_goal(reading: Reading, everything: bool = False, only: Plane = "acceleration") -> SolutionGoal:
    """As far as the file asks, to the plane `only`; all there is with `everything`, or where it asks for no motion."""
    mechanism, planes = reading.mechanism, PLANES[1 : PLANES.index(only) + 1]
    questions = {text: read(mechanism, text) for text in mechanism.ask}
    questions = {text: one for text, one in questions.items() if one is None or plane_of(one) in ("position", *planes)}
    answerable = [one for one in questions.values() if one is not None]
    shown = {} if everything else asked_parts(reading.method, answerable, reading.steady, planes)
    if not shown:
        wanted = (*filter(_placed, answerable), *all_motions(mechanism, planes))
        parts = {plane: reading.method.construction(plane).parts for plane in planes}
        if reading.steady:
            facts = {fact for one in wanted for fact in facts_of(reading.method, one)}
            led = needed(reading.method, facts, reading.steady)
            parts = {plane: led[plane] for plane in planes}
        return SolutionGoal(reading, wanted, tuple(one.text for one in wanted), parts, False)
    return SolutionGoal(reading, (*questions.values(),), (*questions,), shown, True)


@kept(4)  # each trial of a figure asks for them
def solution_centres(mechanism: Mechanism) -> list[Centre]:
    """The instant centres that a solution finds: those asked for, and those by which a contact gives a velocity."""
    asked = [one for text in mechanism.ask if (one := read(mechanism, text)) is not None]
    every = asked if not all(map(_placed, asked)) else [*asked, *all_motions(mechanism, PLANES[1:2])]
    return _centres(mechanism, every, _pushed(mechanism, every))


def _centres(
    mechanism: Mechanism, wanted: Iterable[Quantity | None], pushed: Collection[tuple[str, str]]
) -> list[Centre]:
    """The centres that are wanted, and those of pushed links."""
    asked = [one for one in wanted if isinstance(one, Centre)]
    if not pushed:
        return asked
    from graphkin.studies.centres.search import centre_name

    return asked + [Centre("P", centre_name(mechanism, *links)[1:], links) for links in pushed]


def _pushed(mechanism: Mechanism, wanted: Sequence[Quantity | None]) -> dict[tuple[str, str], list[Quantity]]:
    """The velocities wanted of a link that the driven one pushes in sliding contact, both joined to the frame."""
    links = mechanism.pushed if len(mechanism.drivers) == 1 else ()
    speeds = {pair: [one for one in wanted if one is not None and pair[1] in _moved(one, mechanism)] for pair in links}
    return {pair: asked for pair, asked in speeds.items() if asked}


def _placed(quantity: Quantity) -> bool:
    """True for what a position says."""
    return isinstance(quantity, Centre) or plane_of(quantity) == "position"


def _moved(speed: Quantity, mechanism: Mechanism) -> tuple[str, ...]:
    """The links of which a quantity is the angular velocity, or the velocity of a point."""
    if isinstance(speed, Moving) and speed.word == "v" and speed.seen_from is None:
        return mechanism.owners.get(speed.site.point, ())
    return (speed.link,) if isinstance(speed, Rotation) and speed.word == "omega" else ()
