"""The position construction: the mechanism drawn from its dimensions and its drivers, with ruler and compass."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from itertools import count

from graphkin.base.cache import kept
from graphkin.base.value import filled
from graphkin.construction import (
    Along,
    AlongGuide,
    Arm,
    Construction,
    Equation,
    Fit,
    Given,
    Image,
    InStep,
    LayOff,
    Measure,
    Node,
    Roll,
    Site,
    Slid,
    Span,
    Step,
    Swing,
    Term,
    Touch,
)
from graphkin.model.mechanism import FRAME
from graphkin.planning.closing import close
from graphkin.planning.equivalent import Contact
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.stretches import (
    LoopPiece,
    closure,
    drawn_from,
    link_of,
    pieces_of,
    reverse,
    runs_of,
    term_of,
    turned_round,
)
from graphkin.planning.structure import Sliding, Topology


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

    # --- stages -------------------------------------------------------------------------------

    def slid(self, slide: str, body: str) -> str:
        """The end of a known displacement that lies on `body`."""
        pair = self.structure.slides[slide]
        forward = body != pair.guide
        tail, head = (pair.line.origin, pair.point) if forward else (pair.point, pair.line.origin)
        if head not in self.points:
            term = Term(
                head, tail, "", Span((Slid(slide, 1 if forward else -1),)), AlongGuide(slide), tail, head
            )
            self.parts.append(LayOff(term, tail, head))
            self.points.add(head)
        return head

    def bridge(self, stage: Bridge) -> None:
        tail, head = stage.points
        self.parts.append(
            Measure("theta", stage.body, tail, head, span=Span((Arm(stage.body, tail, head),)))
        )
        self.angles.add(self.structure.base(stage.body))
        self.fill(stage.body)

    def loop(self, stage: Loop) -> None:
        pieces = pieces_of(self.structure, stage)
        runs = runs_of(pieces, self.angles)
        if any(isinstance(p.part, Slid) and p.part.slide in stage.slides and p.base in stage.angles for p in pieces):
            self.swing(stage, pieces)
        else:
            self.meet(stage, runs)
        for run in runs:
            if run[0].base not in self.angles:
                link = link_of(self.structure, run[0])
                self.measure_angle(link, run)
        for slide in stage.slides:
            self.measure_slide(slide)
        self.angles.update(stage.angles)
        for body in stage.bodies:
            self.fill(body)

    def meet(self, stage: Loop, runs: list[list[LoopPiece]]) -> None:
        terms, reaches = [], {}
        for run in runs:
            term = term_of(self.structure, stage, run, self.angles)
            if term.direction is None:
                reaches[term] = Span(tuple(piece.part for piece in run))
            terms.append(term)
        unknown = [k for k, term in enumerate(terms) if term.unknowns]
        left = drawn_from(terms[0].tail) + tuple(terms[: unknown[1]])
        right = drawn_from(terms[-1].head) + tuple(reverse(t, reaches) for t in reversed(terms[unknown[1] :]))
        equation = close(left[-1].head, left, right, reaches, self.aside, self.choice)
        self.parts.append(equation)
        self.points.update(node for term in terms for node in (term.tail, term.head))

    def swing(self, stage: Loop, pieces: list[LoopPiece]) -> None:
        guide = self.structure.slides[stage.slides[0]].guide
        if guide != stage.bodies[0]:
            pieces = [turned_round(piece) for piece in reversed(pieces)]
        pivot, through = pieces[0].tail, pieces[-1].head
        span = Span(tuple(piece.part for piece in pieces))
        self.swung.add(stage.slides[0])
        self.parts.append(
            Swing(guide, pivot, through, stage.slides[0], span, choice=self.choice())
        )

    def mesh(self, stage: Mesh) -> None:
        """A rolling contact; its own point is drawn where both wheels have their places."""
        if stage.contact.slide in self.structure.aside.slides and not stage.contact.way:
            self.measure_slide(stage.contact.slide)
        self.parts.append(Roll(in_step(stage.contact), stage.angle, stage.slide))
        self.angles |= {stage.angle} - {""}

    def touch(self, letter: str, contact: Contact) -> None:
        """The contact itself, where both wheels have their places."""
        first, second = contact.centres
        if contact.slide:
            self.parts.append(Touch(letter, second, slide=contact.slide, offset=-contact.radii[1]))
        else:
            self.parts.append(Touch(letter, first, second, contact.radii[0] / sum(contact.radii)))
        self.contacts.append(letter)

    def group(self, stage: Group) -> None:
        closures = tuple(closure(self.structure, loop) for loop in stage.loops)
        contacts = tuple(in_step(contact) for contact in stage.contacts)
        self.fits += 1
        self.parts.append(Fit(f"fit {self.fits}", stage.angles, stage.slides, closures, contacts))
        self.angles.update(stage.angles)
        waiting = list(stage.bodies)
        while waiting:
            body = next(b for b in waiting if self._startable(b))
            waiting.remove(body)
            self.fill(body)

    def _startable(self, body: str) -> bool:
        """Whether some point of a body is drawn, or the other end of one of its slides."""
        ends = set(self.structure.bodies[body])
        for joint, _ in self.structure.joints(body):
            if isinstance(joint, Sliding):
                slide = self.structure.slides[joint.slide]
                ends |= {slide.line.origin, slide.point}
        return bool(ends & self.points)

    # --- further points -----------------------------------------------------------------------

    def measure_angle(self, link: str, run: list[LoopPiece]) -> None:
        """A swing has found its angle itself; any other group's is read off."""
        if isinstance(self.parts[-1], Swing):
            return
        span = Span(tuple(piece.part for piece in run))
        self.parts.append(Measure("theta", link, run[0].tail, run[-1].head, span=span))

    def measure_slide(self, slide: str) -> None:
        pair = self.structure.slides[slide]
        if pair.line.origin in self.points and pair.point in self.points and slide not in self.swung:
            self.parts.append(Measure("s", slide, pair.line.origin, pair.point))

    def fill(self, body: str) -> None:
        """All further points of a body whose angle is known, from one that is, or from the end of a slide."""
        start = next((p for p in self.structure.bodies[body] if p in self.points), "") or self._start(body)
        for point in self.structure.bodies[body]:
            if point in self.points:
                continue
            known = [p for p in self.structure.named(body) if p in self.points and self._apart(body, p, start)]
            if known:
                self.parts.append(Image(body, (start, known[0], point), (start, known[0]), point))
            else:
                arm = Span((Arm(body, start, point),))
                term = Term(point, start, "", arm, Along(start, point), start, point)
                self.parts.append(LayOff(term, start, point))
            self.points.add(point)

    def _start(self, body: str) -> str:
        slides = (joint.slide for joint, _ in self.structure.joints(body) if isinstance(joint, Sliding))
        return next(
            self.slid(slide, body)
            for slide in slides
            if {self.structure.slides[slide].line.origin, self.structure.slides[slide].point} & self.points
        )

    def _apart(self, body: str, first: str, second: str) -> bool:
        if self.structure.is_pin(body):
            return False
        shape = self.structure.shapes[body]
        return abs(shape[second] - shape[first]) > 0


def position(structure: Topology, order: tuple[Stage, ...]) -> tuple[Construction, int]:
    """The position construction, and how many crossings in it leave two possibilities."""
    drawing = _PositionDrawing(structure)
    for point in structure.bodies[FRAME]:
        drawing.parts.append(Given(point))
        drawing.points.add(point)
    for stage in order:
        match stage:
            case Carry(body):
                drawing.fill(body)
            case Bridge():
                drawing.bridge(stage)
            case Mesh():
                drawing.mesh(stage)
            case Loop():
                drawing.loop(stage)
            case Group():
                drawing.group(stage)
    known = _found_otherwise(order)
    for letter, contact in touching(structure):
        drawing.touch(letter, contact)
    measured = known | {part.of for part in drawing.parts if isinstance(part, Measure) and part.quantity == "s"}
    for slide in structure.measured:
        if slide not in measured and slide not in structure.slides_driven and slide not in drawing.swung:
            drawing.measure_slide(slide)
    nodes = {point: Node(point, point, Site(point, structure.owners[point][0])) for point in drawing.points}
    nodes |= {name: Node(name, "") for name in drawing.asides}
    nodes |= {name: Node(name, name) for name in drawing.contacts}
    return Construction("position", tuple(drawing.parts), nodes), drawing.choices


def _found_otherwise(order: tuple[Stage, ...]) -> set[str]:
    """Slides whose displacement a contact or a fit gives."""
    found: set[str] = set()
    for stage in order:
        if isinstance(stage, Mesh):
            found |= {stage.slide}
        elif isinstance(stage, Group):
            found |= set(stage.slides)
    return found


def touching(structure: Topology) -> Iterator[tuple[str, Contact]]:
    """Each rolling contact with a letter of its own: K, L, .., K', L', .. or what the mechanism leaves free.

    Not N, whose images would be lettered as normal tips are, nor K where there may be a Coriolis tip k'.
    """
    sliding = any(slide.guide != FRAME for slide in structure.slides.values())
    every = (letter + "'" * primes for primes in count() for letter in "KLMQRHJVWXYZ"[sliding:])
    letters = (letter for letter in every if letter not in structure.owners)
    return zip(letters, structure.contacts, strict=False)


@kept(4)
def contact_letters(structure: Topology) -> dict[str, str]:
    """The letter of each rolling contact, by its name."""
    return {contact.name: letter for letter, contact in touching(structure)}


def in_step(contact: Contact) -> InStep:
    return InStep(contact.name, contact.angles, contact.slide, contact.on_slide, contact.way)
