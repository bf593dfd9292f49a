"""Parts of a method that are needed for what is asked.

A `Fact` is a point of a plane, ("velocity", "b3"), the turning of a group of links by its base, ("omega", "3"), the
turning of one driven against the frame, ("driven omega", "1"), or that of a slide, ("s_rate", "ram").
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import Construction, Direction, Equation, Plane, Size, Step, kinds, terms
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning.method import Act, Method

Fact = tuple[str, str]
Part = Step | Equation
QUANTITIES: dict[Plane, tuple[str, str]] = {
    "position": ("theta", "s"), "velocity": ("omega", "s_rate"), "acceleration": ("alpha", "s_acceleration"),
}  # fmt: skip
"""The turning of a link and the displacement of a slide, or its rate, that each plane gives."""


def turning(method: Method, quantity: str, link: str) -> Fact:
    """The fact of a link's `theta`, `omega` or `alpha`."""
    turn = method.structure.turns[link]
    return (f"driven {quantity}", link) if turn.base == FRAME else (quantity, turn.base)


def turnings(method: Method, quantity: str, link: str) -> tuple[Fact, ...]:
    """The turning of a link's base, and that which drivers give the link against it."""
    turn = method.structure.turns[link]
    against = ((f"driven {quantity}", f"{link}/{turn.base}"),) if turn.drivers and turn.base != FRAME else ()
    return turning(method, quantity, link), *against


def needed(method: Method, facts: set[Fact], known: frozenset[Fact] = frozenset()) -> dict[Plane, tuple[Part, ...]]:
    """The parts of both polygons that lead to these facts, in their order; what they need besides is added to them.

    known   facts that no part has to give
    """
    parts: dict[Plane, tuple[Part, ...]] = {}
    for construction in (method.acceleration, method.velocity):
        reader, kept = PartsReader(method, construction), list[Part]()
        for part in reversed(construction.parts):
            if isinstance(part, kinds.Given) or set(reader.gives(part)) & facts - known:
                if isinstance(part, Equation):  # without arrows that are there already, for points nobody asks for
                    again = {step for step in part.steps
                             if isinstance(step, kinds.LayOff) and isinstance(step.term.size, terms.Drawn)
                             and (construction.plane, step.tip) not in facts}  # fmt: skip
                    part = replace(part, steps=tuple(step for step in part.steps if step not in again))
                kept.append(part)
                facts |= set(reader.needs(part))
        parts[construction.plane] = tuple(reversed(kept))
    return parts


def acts_of_equations(method: Method, plane: Plane, drawn: Iterable[Act]) -> Iterator[list[Act]]:
    """The acts that each equation of a polygon needs and none before it did, by one act that draws it; none for the
    same equation once more."""
    construction = method.construction(plane)
    reader, left = PartsReader(method, construction), [act for act in method.acts if act.plane == plane]
    for act in drawn:
        part = next((each for each in construction.equations if act.done in each.steps), None)
        own = [each for each in left if each == act or (part is not None and each.done in part.steps)]
        facts = {*reader.needs(act.done if part is None else part)}
        for before in reversed([each for each in left if own and each.number < own[0].number]):
            steps = [step for step in before.steps if not isinstance(step, kinds.Given)]
            if facts.intersection(fact for step in steps for fact in reader.gives(step)):
                facts.update(fact for step in steps for fact in reader.needs(step))
                own.insert(0, before)
        yield own
        left = [each for each in left if each not in own]


def aids(mechanism: Mechanism) -> frozenset[str]:
    """The points that only show in which direction a line of their link runs, and for which nobody asks."""
    joining = {pair.path.point for pair in mechanism.pairs if pair.path is not None}
    joining |= {centre for pair in mechanism.pairs for _, centre, _ in pair.circles}
    lines = [line for pair in mechanism.pairs for line in pair.lines]
    shows = {point for line in lines for point in line.base or ()} - joining - {line.origin for line in lines}
    owners, asked = mechanism.owners, mechanism.ask
    return frozenset(p for p in shows if len(owners[p]) == 1 and not any(p in question for question in asked))


def without_aids(method: Method) -> Method:
    """The polygons without `aids`, without points on a link that has none there, and without sliding that has no name,
    if nobody asks for them; but for those that another step needs."""
    mechanism, facts, left = method.mechanism, set[Fact](), False
    points, asked = aids(mechanism), " ".join(mechanism.ask)
    nameless = [pair.name for pair in mechanism.pairs if not pair.given]
    for construction in (method.velocity, method.acceleration):
        reader, own, corners = PartsReader(method, construction), set[Fact](), set[Fact]()
        own |= {(f"s_{rate}", name) for rate in ("rate", "acceleration") for name in nameless}
        for name, node in construction.nodes.items():
            if (at := node.site) is None:
                corners.add((reader.plane, name))
            elif at.point in points or not (at.link in mechanism.owners.get(at.point, (at.link,))
                                            or node.of in asked or f"{at.point}@" in asked):  # fmt: skip
                own.add((reader.plane, name))
        for part in construction.parts:
            gives = {*reader.gives(part)}
            left |= bool(gives & own)
            facts |= gives if isinstance(part, kinds.Given) else gives - own - corners
    if not left:
        return method
    needed(method, facts)  # which adds what they need: sliding between points that are there all the same is told
    for construction in (method.velocity, method.acceleration):
        reader = PartsReader(method, construction)
        measures = (part for part in construction.parts if isinstance(part, kinds.Measure))
        facts |= {fact for part in measures if facts >= {*reader.needs(part)} for fact in reader.gives(part)}
    return cut_to(method, needed(method, facts))


def cut_to(method: Method, parts: Mapping[Plane, tuple[Part, ...]]) -> Method:
    """The polygons of these parts, without the points of others; a polygon that is not named stays whole."""

    def cut(polygon: Construction) -> Construction:
        reader, own = PartsReader(method, polygon), parts.get(polygon.plane, polygon.parts)
        every, kept = ({name for part in some for _, name in reader.gives(part)} for some in (polygon.parts, own))
        nodes = {name: node for name, node in polygon.nodes.items() if name not in every - kept}
        return replace(polygon, parts=own, nodes=nodes)

    return replace(method, velocity=cut(method.velocity), acceleration=cut(method.acceleration))


def arms(part: Part) -> Iterator[tuple[str, str]]:
    """The pairs of points whose distance a part of a polygon multiplies or divides by, the smaller name first."""
    if isinstance(part, Equation):
        for step in part.steps:
            yield from arms(step)
    elif isinstance(part, kinds.Measure) and part.lever[0]:
        yield min(part.lever), max(part.lever)
    elif isinstance(part, kinds.LayOff):
        match part.term.size:
            case terms.Turning() | terms.Normal() | terms.Tangential() | terms.Relative() as size:
                yield min(size.tail, size.head), max(size.tail, size.head)
            case _:
                pass  # as long as what is drawn already


@frozen
class PartsReader:
    """Reads the parts of one construction."""

    method: Method
    construction: Construction

    @property
    def plane(self) -> Plane:
        return self.construction.plane

    def gives(self, part: Part) -> Iterator[Fact]:
        if isinstance(part, Equation):
            for step in part.steps:
                yield from self.gives(step)
            return
        match part:
            case kinds.Given(point, also):
                yield from ((self.plane, name) for name in (point, *also))
            case kinds.LayOff(tip=point):
                yield self.plane, point
            case kinds.Meet(point=point) | kinds.Image(point=point) | kinds.Touch(point=point):
                yield self.plane, point
            case kinds.Measure(quantity, of):
                turns = any(quantity == turning for turning, _ in QUANTITIES.values())
                yield turning(self.method, quantity, of) if turns else (quantity, of)
            case kinds.Swing(link=link, slide=slide):
                yield from self._solved((link,), (slide,))
            case kinds.Roll(_, angle, slide):
                yield from self._solved((angle,) if angle else (), (slide,) if slide else ())
            case kinds.Fit(_, angles, slides) | kinds.Simultaneous(angles, slides):
                yield from self._solved(angles, slides)
            case kinds.Ray() | kinds.Arc():
                pass
            case _:
                assert_never(part)

    def _solved(self, angles: tuple[str, ...], slides: tuple[str, ...]) -> Iterator[Fact]:
        turns, slips = QUANTITIES[self.plane]
        yield from (turning(self.method, turns, link) for link in angles)
        yield from ((slips, slide) for slide in slides)

    def needs(self, part: Part) -> Iterator[Fact]:
        """The facts that a part starts from, and does not give itself."""
        match part:
            case Equation():
                facts = [fact for step in part.steps for fact in self.needs(step)]
                facts += [fact for term in (*part.left, *part.right) for fact in self._term(term)]
            case kinds.Roll() | kinds.Fit() | kinds.Simultaneous():
                facts = [*self._calculated(part)]
            case _:
                yield from self._drawn(part)
                return
        given = set(self.gives(part))
        yield from (fact for fact in facts if fact not in given)

    def _drawn(self, step: Step) -> Iterator[Fact]:
        match step:
            case kinds.LayOff(term, start):
                yield self.plane, start
                yield from self._term(term)
            case kinds.Ray(through, direction):
                yield self.plane, through
                yield from self._direction(direction)
            case kinds.Arc(about, reach):
                yield self.plane, about
                yield from self._size(reach)
            case kinds.Meet(first, second):
                yield from self._drawn(first)
                yield from self._drawn(second)
            case kinds.Swing(pivot=pivot, through=through, span=span):
                yield from (("position", pivot), ("position", through))
                yield from self._size(span)
            case kinds.Image(link, corners, base):
                yield from ((self.plane, node) for node in base)
                if any(corner not in self.method.mechanism.owners for corner in corners):
                    yield from self._turnings(link)  # a contact is told with the turning it gives
                yield from (("position", corner) for corner in corners if self.plane != "position")
            case kinds.Measure(tail=tail, head=head, lever=lever):
                yield from ((self.plane, node) for node in (tail, head))
                yield from (("position", point) for point in lever if point)
            case kinds.Touch(_, centre, other):
                yield from (("position", point) for point in (centre, other) if point)
            case kinds.Given() | kinds.Roll() | kinds.Fit() | kinds.Simultaneous():
                pass
            case _:
                assert_never(step)

    def _calculated(self, step: kinds.Roll | kinds.Fit | kinds.Simultaneous) -> Iterator[Fact]:
        """The facts that enter a step done by calculation, its own results among them."""
        if isinstance(step, kinds.Fit):
            hung = (closure for closure in step.closures if not closure.floats)
            yield from (("position", point) for closure in hung for point in (closure.start, closure.end))
        elif isinstance(step, kinds.Simultaneous):
            for chain in step.chains:
                yield from (fact for size, _ in chain.known for fact in self._size(size))
                yield from (("position", p) for one in chain.unknown for p in (one.tail, one.head) if p)
                yield from (fact for one in chain.unknown if one.link for fact in self._turnings(one.link))
        for contact in (step.contact,) if isinstance(step, kinds.Roll) else step.contacts:
            yield from (fact for link, _ in contact.angles if link != FRAME for fact in self._turnings(link))
            slides = [slide for slide, _ in contact.way] or ([contact.slide] if contact.slide else [])
            yield from ((QUANTITIES[self.plane][1], slide) for slide in slides)

    def _turnings(self, link: str, quantity: str = "") -> tuple[Fact, ...]:
        return turnings(self.method, quantity or QUANTITIES[self.plane][0], link)

    def _term(self, term: terms.Term) -> Iterator[Fact]:
        if term.size is not None:
            yield from self._size(term.size)
        if term.direction is not None:
            yield from self._direction(term.direction)

    def _size(self, size: Size) -> Iterator[Fact]:
        match size:
            case terms.Drawn(tail, head):
                yield from ((self.plane, node) for node in (tail, head) if node)
            case terms.Turning(link, tail, head) | terms.Normal(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("position", tail), ("position", head))
            case terms.Tangential(link, tail, head):
                yield from self._turnings(link, "alpha")
                yield from (("position", tail), ("position", head))
            case terms.Coriolis(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("velocity", tail), ("velocity", head))
            case terms.Driven(slide):
                yield QUANTITIES[self.plane][1], slide
            case terms.Relative(link, seen_from, tail, head):  # a driven rotation is known, and moves
                yield from ((f"driven {quantity}", f"{link}/{seen_from}") for quantity in ("omega", "alpha"))
                yield from (("position", tail), ("position", head))
            case terms.Span(parts):
                yield from (("s", part.slide) for part in parts if isinstance(part, terms.Slid))
            case _:
                assert_never(size)

    def _direction(self, direction: Direction) -> Iterator[Fact]:
        match direction:
            case terms.Along(tail, head) | terms.Across(tail, head):
                yield from (("position", tail), ("position", head))
            case terms.AlongGuide(slide) | terms.AcrossGuide(slide):
                yield from self._turnings(self.method.structure.slides[slide].guide, "theta")
            case terms.Quarter(link, tail, head):
                yield from self._turnings(link, "omega")
                yield from (("velocity", tail), ("velocity", head))
            case _:
                assert_never(direction)
