"""The position construction: the mechanism drawn from its dimensions and its drivers, with ruler and compass.

The stretches of a loop, arms of bodies and displacements of slides, are the terms of its equation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from itertools import count

from graphkin.base.cache import kept
from graphkin.base.value import filled, frozen
from graphkin.construction import Construction, Equation, Node, Site, Step, kinds, terms
from graphkin.model.mechanism import FRAME
from graphkin.planning.closing import close
from graphkin.planning.equivalent import Contact
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.structure import Hinge, Joint, Sliding, Topology

# --- stretches of a loop ----------------------------------------------------------------------


@frozen
class Stretch:
    """One stretch of a loop: an arm of a body, or the displacement of a slide, turned by its base link."""

    part: terms.Arm | terms.Slid
    tail: str
    head: str
    base: str


def _reversed(part: terms.Arm | terms.Slid) -> terms.Arm | terms.Slid:
    if isinstance(part, terms.Arm):
        return terms.Arm(part.link, part.head, part.tail)
    return terms.Slid(part.slide, -part.sign)


def _stretches(structure: Topology, loop: Loop) -> list[Stretch]:
    """The loop as arms and displacements, from a known point to a known point."""
    stretches: list[Stretch] = []
    for k, joint in enumerate(loop.joints):
        if not isinstance(joint, Hinge):
            pair = structure.slides[joint.slide]
            forward = (loop.bodies[k] if k < len(loop.bodies) else "") == structure.block(pair) or (
                k > 0 and loop.bodies[k - 1] == pair.guide
            )
            ends = (pair.line.origin, pair.point)
            tail, head = ends if forward else ends[::-1]
            displacement = terms.Slid(joint.slide, 1 if forward else -1)
            stretches.append(Stretch(displacement, tail, head, structure.base(pair.guide)))
        if k < len(loop.bodies):
            body = loop.bodies[k]
            tail, head = _end(structure, joint, body), _end(structure, loop.joints[k + 1], body)
            if tail != head:
                stretches.append(Stretch(terms.Arm(body, tail, head), tail, head, structure.base(body)))
    return stretches


def _end(structure: Topology, joint: Joint, body: str) -> str:
    """The point at which a joint holds a body."""
    return joint.point if isinstance(joint, Hinge) else structure.slide_point(joint.slide, body)


def _span(stretches: Sequence[Stretch]) -> terms.Span:
    return terms.Span(tuple(stretch.part for stretch in stretches))


def _term(stage: Loop, run: list[Stretch], known: set[str]) -> terms.Term:
    tail, head, part = run[0].tail, run[-1].head, run[0].part
    if run[0].base not in known:
        return terms.Term(head, tail, "", _span(run), None, tail, head)
    if isinstance(part, terms.Slid):
        size = None if part.slide in stage.slides else _span(run)
        return terms.Term(head, tail, "", size, terms.AlongGuide(part.slide), tail, head)
    return terms.Term(head, tail, "", _span(run), terms.Along(tail, head), tail, head)


def _seen_back(term: terms.Term, reaches: dict[terms.Term, terms.Span]) -> terms.Term:
    """The same arrow seen from its other end."""
    size, direction = term.size, term.direction
    if isinstance(size, terms.Span):
        size = terms.Span(tuple(map(_reversed, reversed(size.parts))))
    if isinstance(direction, terms.Along):
        direction = terms.Along(direction.head, direction.tail)
    back = terms.Term(term.seen_from, term.of, "", size, direction, term.head, term.tail)
    if term in reaches:
        reaches[back] = reaches.pop(term)
    return back


# --- the construction -------------------------------------------------------------------------


def position(structure: Topology, order: tuple[Stage, ...]) -> tuple[Construction, int]:
    """The position construction, and how many crossings in it leave two possibilities."""
    drawing, fitted = _PositionDrawing(structure), set[str]()
    for point in structure.bodies[FRAME]:
        drawing.parts.append(kinds.Given(point))
        drawing.points.add(point)
    for stage in order:
        match stage:
            case Carry(body):
                drawing.fill(body)
            case Bridge():
                tail, head = stage.points
                span = terms.Span((terms.Arm(stage.body, tail, head),))
                drawing.parts.append(kinds.Measure("theta", stage.body, tail, head, span=span))
                drawing.angles.add(drawing.structure.base(stage.body))
                drawing.fill(stage.body)
            case Mesh():
                drawing.mesh(stage)
                fitted.add(stage.slide)
            case Loop():
                drawing.loop(stage)
            case Group():
                drawing.group(stage)
                fitted.update(stage.slides)
    for letter, contact in touching(structure):
        drawing.touch(letter, contact)
    measured = fitted | {part.of for part in drawing.parts if isinstance(part, kinds.Measure) and part.quantity == "s"}
    for slide in structure.measured:
        if slide not in measured and slide not in structure.slides_driven and slide not in drawing.swung:
            drawing.measure_slide(slide)
    nodes = {point: Node(point, point, Site(point, structure.owners[point][0])) for point in drawing.points}
    nodes |= {name: Node(name, "") for name in drawing.asides}
    nodes |= {name: Node(name, name) for name in drawing.contacts}
    return Construction("position", tuple(drawing.parts), nodes), drawing.choices


@filled
class _PositionDrawing:
    structure: Topology
    parts: list[Step | Equation] = field(default_factory=list)
    points: set[str] = field(default_factory=set)
    angles: set[str] = field(default_factory=lambda: {FRAME})
    asides: list[str] = field(default_factory=list)
    choices: int = 0
    fits: int = 0
    contacts: list[str] = field(default_factory=list)
    swung: set[str] = field(default_factory=set)

    def choice(self) -> int:
        self.choices += 1
        return self.choices - 1

    def aside(self) -> str:
        self.asides.append(f"*{len(self.asides) + 1}")
        return self.asides[-1]

    def loop(self, stage: Loop) -> None:
        stretches = _stretches(self.structure, stage)
        # stretches of one unknown group together; those whose direction is known one by one
        runs: list[list[Stretch]] = []
        for stretch in stretches:
            if runs and stretch.base not in self.angles and runs[-1][0].base == stretch.base:
                runs[-1].append(stretch)
            else:
                runs.append([stretch])
        slid = (one for one in stretches if isinstance(one.part, terms.Slid) and one.part.slide in stage.slides)
        if any(one.base in stage.angles for one in slid):
            self.swing(stage, stretches)
        else:
            self.meet(stage, runs)
        for run in runs:
            part = run[0].part
            swung = isinstance(self.parts[-1], kinds.Swing)  # which gives its angle itself
            if run[0].base not in self.angles and not swung:
                link = part.link if isinstance(part, terms.Arm) else self.structure.slides[part.slide].guide
                self.parts.append(kinds.Measure("theta", link, run[0].tail, run[-1].head, span=_span(run)))
        for slide in stage.slides:
            self.measure_slide(slide)
        self.angles.update(stage.angles)
        for body in stage.bodies:
            self.fill(body)

    def meet(self, stage: Loop, runs: list[list[Stretch]]) -> None:
        arrows, reaches = [_term(stage, run, self.angles) for run in runs], dict[terms.Term, terms.Span]()
        for run, term in zip(runs, arrows, strict=True):
            if term.direction is None:
                reaches[term] = _span(run)
        _, second = (k for k, term in enumerate(arrows) if term.unknowns)
        # the known ends of both sides are measured from the drawing's origin
        starts = (terms.Term(start, "", "", terms.Drawn("", start), None, "", start)
                  for start in (arrows[0].tail, arrows[-1].head))  # fmt: skip
        left = (next(starts), *arrows[:second])
        right = (next(starts), *(_seen_back(term, reaches) for term in reversed(arrows[second:])))
        self.parts.append(close(left[-1].head, left, right, reaches, self.aside, self.choice))
        self.points.update(node for term in arrows for node in (term.tail, term.head))

    def swing(self, stage: Loop, stretches: list[Stretch]) -> None:
        slide = stage.slides[0]
        guide = self.structure.slides[slide].guide
        if guide != stage.bodies[0]:
            stretches = [Stretch(_reversed(one.part), one.head, one.tail, one.base) for one in reversed(stretches)]
        self.swung.add(slide)
        ends = stretches[0].tail, stretches[-1].head
        self.parts.append(kinds.Swing(guide, *ends, slide, _span(stretches), choice=self.choice()))

    def mesh(self, stage: Mesh) -> None:
        """A rolling contact; its own point is drawn where both wheels have their places."""
        if stage.contact.slide in self.structure.aside.slides and not stage.contact.way:
            self.measure_slide(stage.contact.slide)
        self.parts.append(kinds.Roll(in_step(stage.contact), stage.angle, stage.slide))
        self.angles |= {stage.angle} - {""}

    def touch(self, letter: str, contact: Contact) -> None:
        """The contact itself, where both wheels have their places."""
        first, second = contact.centres
        if contact.slide:
            self.parts.append(kinds.Touch(letter, second, slide=contact.slide, offset=-contact.radii[1]))
        else:
            self.parts.append(kinds.Touch(letter, first, second, contact.radii[0] / sum(contact.radii)))
        self.contacts.append(letter)

    def group(self, stage: Group) -> None:
        closures = []
        for loop in stage.loops:
            stretches = _stretches(self.structure, loop)
            parts = tuple(stretch.part for stretch in stretches)
            closures.append(kinds.Closure(stretches[0].tail, parts, stretches[-1].head))
        contacts = tuple(in_step(contact) for contact in stage.contacts)
        self.fits += 1
        self.parts.append(kinds.Fit(f"fit {self.fits}", stage.angles, stage.slides, tuple(closures), contacts))
        self.angles.update(stage.angles)
        waiting = list(stage.bodies)
        while waiting:
            body = next(b for b in waiting if {*self.structure.bodies[b]} & self.points or self._half_drawn(b))
            waiting.remove(body)
            self.fill(body)

    def measure_slide(self, slide: str) -> None:
        pair = self.structure.slides[slide]
        if pair.line.origin in self.points and pair.point in self.points and slide not in self.swung:
            self.parts.append(kinds.Measure("s", slide, pair.line.origin, pair.point))

    def fill(self, body: str) -> None:
        """All further points of a body whose angle is known, from one that is, or from the end of a slide."""
        points, shape = self.structure.bodies[body], self.structure.shapes[body]
        start = next((point for point in points if point in self.points), "")
        if not start:  # the end on the body of a known displacement of which the other end is drawn
            pair = self.structure.slides[self._half_drawn(body)]
            forward = body != pair.guide
            tail, start = (pair.line.origin, pair.point) if forward else (pair.point, pair.line.origin)
            if start not in self.points:
                self._lay_off(terms.Slid(pair.name, 1 if forward else -1), terms.AlongGuide(pair.name), tail, start)
                self.points.add(start)
        for point in points:
            if point in self.points:
                continue
            named = () if self.structure.is_pin(body) else self.structure.named(body)
            known = [p for p in named if p in self.points and abs(shape[start] - shape[p]) > 0]
            if known:
                self.parts.append(kinds.Image(body, (start, known[0], point), (start, known[0]), point))
            else:
                self._lay_off(terms.Arm(body, start, point), terms.Along(start, point), start, point)
            self.points.add(point)

    def _half_drawn(self, body: str) -> str:
        """A slide of a body of which an end is drawn."""
        slides = (joint.slide for joint, _ in self.structure.joints(body) if isinstance(joint, Sliding))
        pairs = ((slide, self.structure.slides[slide]) for slide in slides)
        return next((slide for slide, pair in pairs if {pair.line.origin, pair.point} & self.points), "")

    def _lay_off(self, part: terms.Arm | terms.Slid, direction: terms.Direction, tail: str, head: str) -> None:
        term = terms.Term(head, tail, "", terms.Span((part,)), direction, tail, head)
        self.parts.append(kinds.LayOff(term, tail, head))


def touching(structure: Topology) -> Iterator[tuple[str, Contact]]:
    """Each rolling contact with a letter of its own: K, L, .., K', L', .. or what the mechanism leaves free. Not N,
    whose images would be lettered as normal tips are, nor K where there may be a Coriolis tip k'."""
    sliding = any(slide.guide != FRAME for slide in structure.slides.values())
    every = (letter + "'" * primes for primes in count() for letter in "KLMQRHJVWXYZ"[sliding:])
    letters = (letter for letter in every if letter not in structure.owners)
    return zip(letters, structure.contacts, strict=False)


@kept(4)
def contact_letters(structure: Topology) -> dict[str, str]:
    """The letter of each rolling contact, by its name."""
    return {contact.name: letter for letter, contact in touching(structure)}


def in_step(contact: Contact) -> kinds.InStep:
    """The law by which the bodies of a contact move in step."""
    return kinds.InStep(contact.name, contact.angles, contact.slide, contact.on_slide, contact.way)
