"""What each part of a construction needs and what it gives: how far one has to go for what is asked, and what rests.

A `Fact` is a point of a plane, ("velocity", "b3"), the turning of a group of links by its base, ("omega", "3"), the
turning of one driven against the frame, ("driven omega", "1"), or that of a slide, ("s_rate", "ram").
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Arc,
    Arm,
    Construction,
    Coriolis,
    Direction,
    Drawn,
    Driven,
    Equation,
    Facts,
    Fit,
    Given,
    Image,
    InStep,
    LayOff,
    Measure,
    Meet,
    Normal,
    Plane,
    Quarter,
    Ray,
    Relative,
    Roll,
    Simultaneous,
    Size,
    Slid,
    Span,
    Step,
    Swing,
    Tangential,
    Term,
    Touch,
    Turning,
)
from graphkin.model.mechanism import FRAME
from graphkin.planning.method import Method

Fact = tuple[str, str]
Part = Step | Equation

_TURNING: dict[Plane, str] = {"position": "theta", "velocity": "omega", "acceleration": "alpha"}
_SLIDING: dict[Plane, str] = {"position": "s", "velocity": "s_rate", "acceleration": "s_acceleration"}


def turning(method: Method, quantity: str, link: str) -> Fact:
    """The fact of a link's `theta`, `omega` or `alpha`."""
    turn = method.structure.turns[link]
    return (f"driven {quantity}", link) if turn.base == FRAME else (quantity, turn.base)


def turnings(method: Method, quantity: str, link: str) -> tuple[Fact, ...]:
    """The turning of a link's base, and that which drivers give the link against it."""
    turn = method.structure.turns[link]
    against = ((f"driven {quantity}", f"{link}/{turn.base}"),) if turn.drivers and turn.base != FRAME else ()
    return turning(method, quantity, link), *against


def needed(method: Method, wanted: set[Fact]) -> dict[Plane, tuple[Part, ...]]:
    """The parts of both polygons that lead to what is wanted, in their order."""
    found: dict[Plane, tuple[Part, ...]] = {}
    for construction in (method.acceleration, method.velocity):
        reader, kept = _PartsReader(method, construction), list[Part]()
        for part in reversed(construction.parts):
            if isinstance(part, Given) or set(reader.gives(part)) & wanted:
                kept.append(_without_unwanted(part, construction.plane, wanted))
                wanted |= set(reader.needs(kept[-1]))
        found[construction.plane] = tuple(reversed(kept))
    return found


def _without_unwanted(part: Part, plane: Plane, wanted: set[Fact]) -> Part:
    """An equation without the points behind its unknown arrow that nobody wants."""
    if not isinstance(part, Equation):
        return part
    carried = {step: (plane, step.tip) for step in part.steps if isinstance(step, LayOff) and _carried(step)}
    return replace(part, steps=tuple(step for step in part.steps if step not in carried or carried[step] in wanted))


def _carried(step: LayOff) -> bool:
    """Whether an arrow is drawn that is there already, for the point at its end."""
    return isinstance(step.term.size, Drawn)


def arms(part: Part) -> Iterator[tuple[str, str]]:
    """The pairs of points whose distance a part of a polygon multiplies or divides by, the smaller name first."""
    if isinstance(part, Equation):
        for step in part.steps:
            yield from arms(step)
    elif isinstance(part, Measure) and part.lever[0]:
        yield min(part.lever), max(part.lever)
    elif isinstance(part, LayOff) and isinstance(part.term.size, Turning | Normal | Tangential | Relative):
        size = part.term.size
        yield min(size.tail, size.head), max(size.tail, size.head)


def at_rest(method: Method, facts: Facts) -> frozenset[Fact]:
    """What stands still in both polygons because the drivers on which it hangs do (rate and acceleration 0)."""
    rested = _still(facts)
    found = [_resting(method, method.velocity, rested)]
    found.append(_resting(method, method.acceleration, rested | found[0]))
    links = [link for link in method.structure.bodies if link != FRAME]
    turns = [(turnings(method, "omega", link), turnings(method, "alpha", link)) for link in links]
    both = {fact for omega, alpha in turns if {*omega} <= found[0] and {*alpha} <= found[1] for fact in omega + alpha}
    sites = [{c.nodes[name].site: (c.plane, name) for plane, name in one if plane == c.plane}
             for c, one in zip((method.velocity, method.acceleration), found, strict=True)]  # fmt: skip
    return frozenset(both | {one[site] for site in {*sites[0]} & {*sites[1]} if site is not None for one in sites})


def rests(method: Method, plane: Plane, part: Part, rested: frozenset[Fact]) -> bool:
    """Whether a part finds nothing but what stands still; corners between arrows do not count."""
    construction = method.velocity if plane == "velocity" else method.acceleration
    facts = [] if isinstance(part, Given) else [*_PartsReader(method, construction).gives(part)]
    found = [fact for fact in facts if not _corner(construction, fact)]
    return bool(found) and all(fact in rested for fact in found)


def _corner(construction: Construction, fact: Fact) -> bool:
    node = construction.nodes.get(fact[1])
    return fact[0] == construction.plane and (node is None or node.site is None)


def _still(facts: Facts) -> frozenset[Fact]:
    """What drivers at rest, and the frame, hold."""
    rates = zip(facts.rates, facts.accelerations, strict=True)
    still = {k for k, (rate, more) in enumerate(rates) if rate == more == 0}
    turns = facts.turns.items()
    held = [link if turn.base == FRAME else f"{link}/{turn.base}"
            for link, turn in turns if all(k in still for k, _ in turn.drivers)]  # fmt: skip
    slides = [slide for slide, k in facts.slides_driven.items() if k in still]
    return frozenset(
        {(f"driven {quantity}", link) for quantity in ("omega", "alpha") for link in held}
        | {(quantity, slide) for quantity in ("s_rate", "s_acceleration") for slide in slides}
    )


def _resting(method: Method, construction: Construction, rested: frozenset[Fact]) -> frozenset[Fact]:
    """The same with all that is found from nothing else by the parts of a polygon, its pole among them."""
    reader, found = _PartsReader(method, construction), set(rested)
    for step in construction.steps:
        if isinstance(step, Given) and step.also:
            found |= set(reader.gives(step))
    found.add((construction.plane, construction.pole))
    for part in construction.parts:
        needs = {fact for fact in reader.needs(part) if fact[0] not in ("position", "theta", "driven theta", "s")}
        if not isinstance(part, Given) and needs <= found:
            found |= set(reader.gives(part))
    return frozenset(found)


@frozen
class _PartsReader:
    """Reads the parts of one construction."""

    method: Method
    construction: Construction

    @property
    def plane(self) -> Plane:
        return self.construction.plane

    def _turning(self, quantity: str, link: str) -> Fact:
        return turning(self.method, quantity, link)

    # --- what a part gives ------------------------------------------------------------------------

    def gives(self, part: Part) -> Iterator[Fact]:
        if isinstance(part, Equation):
            for step in part.steps:
                yield from self.gives(step)
            return
        match part:
            case Given(point, also):
                yield from ((self.plane, name) for name in (point, *also))
            case LayOff(tip=point) | Meet(point=point) | Image(point=point) | Touch(point=point):
                yield self.plane, point
            case Measure(quantity, of):
                yield self._turning(quantity, of) if quantity in _TURNING.values() else (quantity, of)
            case Swing(link=link, slide=slide):
                yield self._turning("theta", link)
                yield "s", slide
            case Roll(_, angle, slide):
                yield from self._found((angle,) if angle else (), (slide,) if slide else ())
            case Fit(_, angles, slides) | Simultaneous(angles, slides):
                yield from self._found(angles, slides)
            case Ray() | Arc():
                pass
            case _:
                assert_never(part)

    def _found(self, angles: tuple[str, ...], slides: tuple[str, ...]) -> Iterator[Fact]:
        yield from (self._turning(_TURNING[self.plane], link) for link in angles)
        yield from ((_SLIDING[self.plane], slide) for slide in slides)

    # --- what it needs ----------------------------------------------------------------------------

    def _equation(self, equation: Equation) -> Iterator[Fact]:
        """What its steps and its terms need, and it does not give itself."""
        given = set(self.gives(equation))
        needs = [fact for step in equation.steps for fact in self.needs(step)]
        needs += [fact for term in (*equation.left, *equation.right) for fact in self._term(term)]
        yield from (fact for fact in needs if fact not in given)

    def needs(self, part: Part) -> Iterator[Fact]:
        match part:
            case Equation():
                yield from self._equation(part)
            case Given():
                pass
            case LayOff(term, start):
                yield self.plane, start
                yield from self._term(term)
            case Ray(through, direction):
                yield self.plane, through
                yield from self._direction(direction)
            case Arc(about, reach):
                yield self.plane, about
                yield from self._size(reach)
            case Meet(first, second):
                yield from self.needs(first)
                yield from self.needs(second)
            case Swing(pivot=pivot, through=through, span=span):
                yield from (("position", pivot), ("position", through))
                yield from self._size(span)
            case Image(link, corners, base):
                yield from ((self.plane, node) for node in base)
                if any(corner not in self.method.mechanism.owners for corner in corners):
                    yield from self._turnings(link)  # a contact is told with the turning it gives
                yield from (("position", corner) for corner in corners if self.plane != "position")
            case Measure(tail=tail, head=head, lever=lever):
                yield from ((self.plane, node) for node in (tail, head))
                yield from (("position", point) for point in lever if point)
            case Roll(contact):
                yield from self._contact(contact, {*self.gives(part)})
            case Fit(closures=closures, contacts=contacts):
                hung = (closure for closure in closures if not closure.floats)
                yield from (("position", point) for closure in hung for point in (closure.start, closure.end))
                yield from (fact for contact in contacts for fact in self._contact(contact, {*self.gives(part)}))
            case Touch(_, centre, other):
                yield from (("position", point) for point in (centre, other) if point)
            case Simultaneous():
                found = {*self.gives(part)}
                yield from (fact for fact in self._together(part, found) if fact not in found)
            case _:
                assert_never(part)

    def _together(self, part: Simultaneous, given: set[Fact]) -> Iterator[Fact]:
        for chain in part.chains:
            yield from (fact for size, _ in chain.known for fact in self._size(size))
            yield from (("position", p) for one in chain.unknown for p in (one.tail, one.head) if p)
            yield from (fact for one in chain.unknown if one.link for fact in self._turnings(one.link))
        yield from (fact for contact in part.contacts for fact in self._contact(contact, given))

    def _turnings(self, link: str, quantity: str = "") -> tuple[Fact, ...]:
        return turnings(self.method, quantity or _TURNING[self.plane], link)

    def _contact(self, contact: InStep, given: set[Fact]) -> Iterator[Fact]:
        slides = [slide for slide, _ in contact.way] or ([contact.slide] if contact.slide else [])
        found = [fact for link, _ in contact.angles if link != FRAME for fact in self._turnings(link)]
        found += [(_SLIDING[self.plane], slide) for slide in slides]
        yield from (fact for fact in found if fact not in given)

    def _term(self, term: Term) -> Iterator[Fact]:
        if term.size is not None:
            yield from self._size(term.size)
        if term.direction is not None:
            yield from self._direction(term.direction)

    def _size(self, size: Size) -> Iterator[Fact]:
        match size:
            case Drawn(tail, head):
                yield from ((self.plane, node) for node in (tail, head) if node)
            case Turning(link, tail, head) | Normal(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("position", tail), ("position", head))
            case Tangential(link, tail, head):
                yield from self._turnings(link, "alpha")
                yield from (("position", tail), ("position", head))
            case Coriolis(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("velocity", tail), ("velocity", head))
            case Driven(slide):
                yield _SLIDING[self.plane], slide
            case Relative(link, seen_from, tail, head):
                yield from (self._driven(quantity, link, seen_from) for quantity in ("omega", "alpha"))
                yield from (("position", tail), ("position", head))
            case Span(parts):
                yield from self._span(parts)
            case _:
                assert_never(size)

    def _driven(self, quantity: str, link: str, seen_from: str) -> Fact:
        """A driven rotation of one link against another is known, and moves."""
        return f"driven {quantity}", f"{link}/{seen_from}"

    def _span(self, parts: tuple[Arm | Slid, ...]) -> Iterator[Fact]:
        yield from (("s", part.slide) for part in parts if isinstance(part, Slid))

    def _direction(self, direction: Direction) -> Iterator[Fact]:
        match direction:
            case Along(tail, head) | Across(tail, head):
                yield from (("position", tail), ("position", head))
            case AlongGuide(slide) | AcrossGuide(slide):
                yield from self._turnings(self.method.structure.slides[slide].guide, "theta")
            case Quarter(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("velocity", tail), ("velocity", head))
            case _:
                assert_never(direction)
