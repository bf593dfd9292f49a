"""The stretches of a loop: arms of bodies and displacements of slides, as terms of its equation and as a way round."""

from __future__ import annotations

from graphkin.base.value import frozen
from graphkin.construction import Along, AlongGuide, Arm, Closure, Drawn, Slid, Span, Term
from graphkin.planning.stages import Loop
from graphkin.planning.structure import Hinge, Joint, Topology


@frozen
class LoopPiece:
    """One stretch of a loop: an arm of a body, or the displacement of a slide."""

    part: Arm | Slid
    tail: str
    head: str
    base: str


def closure(structure: Topology, loop: Loop) -> Closure:
    pieces = pieces_of(structure, loop)
    return Closure(pieces[0].tail, tuple(piece.part for piece in pieces), pieces[-1].head)


def pieces_of(structure: Topology, loop: Loop) -> list[LoopPiece]:
    """The way round as arms and displacements, from a known point to a known point."""
    pieces: list[LoopPiece] = []
    for k, joint in enumerate(loop.joints):
        if not isinstance(joint, Hinge):
            pair = structure.slides[joint.slide]
            forward = (loop.bodies[k] if k < len(loop.bodies) else "") == structure.block(pair) or (
                k > 0 and loop.bodies[k - 1] == pair.guide
            )
            ends = (pair.line.origin, pair.point)
            tail, head = ends if forward else ends[::-1]
            part = Slid(joint.slide, 1 if forward else -1)
            pieces.append(LoopPiece(part, tail, head, structure.base(pair.guide)))
        if k < len(loop.bodies):
            body = loop.bodies[k]
            tail, head = _end(structure, joint, body), _end(structure, loop.joints[k + 1], body)
            if tail != head:
                pieces.append(LoopPiece(Arm(body, tail, head), tail, head, structure.base(body)))
    return pieces


def _end(structure: Topology, joint: Joint, body: str) -> str:
    """The point at which a joint holds a body."""
    return joint.point if isinstance(joint, Hinge) else structure.slide_point(joint.slide, body)


def runs_of(pieces: list[LoopPiece], known: set[str]) -> list[list[LoopPiece]]:
    """Pieces of one unknown group together; pieces whose direction is known one by one."""
    runs: list[list[LoopPiece]] = []
    for piece in pieces:
        if runs and piece.base not in known and runs[-1][0].base == piece.base:
            runs[-1].append(piece)
        else:
            runs.append([piece])
    return runs


def term_of(structure: Topology, stage: Loop, run: list[LoopPiece], known: set[str]) -> Term:
    tail, head = run[0].tail, run[-1].head
    span = Span(tuple(piece.part for piece in run))
    part = run[0].part
    if run[0].base not in known:
        return Term(head, tail, "", span, None, tail, head)
    if isinstance(part, Slid):
        size = None if part.slide in stage.slides else span
        return Term(head, tail, "", size, AlongGuide(part.slide), tail, head)
    return Term(head, tail, "", span, Along(tail, head), tail, head)


def turned_round(piece: LoopPiece) -> LoopPiece:
    part: Arm | Slid
    if isinstance(piece.part, Arm):
        part = Arm(piece.part.link, piece.part.head, piece.part.tail)
    else:
        part = Slid(piece.part.slide, -piece.part.sign)
    return LoopPiece(part, piece.head, piece.tail, piece.base)


def reverse(term: Term, reaches: dict[Term, Span]) -> Term:
    """The same arrow seen from its other end."""
    size = term.size
    if isinstance(size, Span):
        size = Span(tuple(turned_round(LoopPiece(p, "", "", "")).part for p in reversed(size.parts)))
    direction = term.direction
    if isinstance(direction, Along):
        direction = Along(direction.head, direction.tail)
    turned = Term(term.seen_from, term.of, "", size, direction, term.head, term.tail)
    if term in reaches:
        reaches[turned] = reaches.pop(term)
    return turned


def drawn_from(start: str) -> tuple[Term, ...]:
    """The known end of a side, measured from the drawing's origin."""
    return (Term(start, "", "", Drawn("", start), None, "", start),)


def link_of(structure: Topology, piece: LoopPiece) -> str:
    if isinstance(piece.part, Arm):
        return piece.part.link
    return structure.slides[piece.part.slide].guide
