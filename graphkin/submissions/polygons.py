"""What the polygons of a problem have: letters, the vectors between them, and which is known from the start."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphkin import planning, running
from graphkin.base.value import frozen
from graphkin.construction import (
    LETTER,
    Construction,
    Driven,
    Given,
    LayOff,
    Normal,
    Plane,
    Relative,
    Tangential,
    Turning,
)
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.submissions.questions import Questions


@frozen
class PolygonVector:
    """An arrow of a polygon: the question that its size answers ("" for none), tail and head by their letters."""

    question: str
    tail: str
    head: str


@frozen
class PaperPolygon:
    """One plane as it is drawn on paper.

    letters  by letter those that mean the same point: of the pole also the fixed points', that sit on it
    vectors  all arrows between letters
    known    vectors that are laid off from what is given alone, with their values [m/s, m/s^2], the first first
    """

    plane: Plane
    letters: Mapping[str, tuple[str, ...]]
    vectors: tuple[PolygonVector, ...]
    known: tuple[tuple[PolygonVector, complex], ...]


def polygons(mechanism: Mechanism, questions: Questions) -> tuple[PaperPolygon, ...]:
    """Of velocities and of accelerations. Raises what planning raises."""
    method = planning.plan(mechanism)
    plot = running.replay_all(method)
    found = []
    for construction in (method.velocity, method.acceleration):
        values = plot.points(construction.plane)
        vectors = tuple(_vectors(construction, questions))
        known = tuple(
            (vector, complex(values[vector.head]) - complex(values[vector.tail]))
            for vector in _known(construction, mechanism, vectors)
            if vector.tail in values and vector.head in values
        )
        found.append(PaperPolygon(construction.plane, _letters(construction), vectors, known))
    return tuple(found)


def _letters(construction: Construction) -> dict[str, tuple[str, ...]]:
    on_pole = _on_pole(construction)
    prime = "'" if construction.plane == "acceleration" else ""
    pole = tuple(dict.fromkeys([construction.pole, *(letter + prime for letter in "poq"), *on_pole]))
    names = [name for name in construction.nodes if name not in on_pole and name[0].isalpha()]
    alike = {name: tuple(dict.fromkeys((name, name.rstrip("'") + prime))) for name in names}
    return {construction.pole: tuple(name for name in pole if name not in names), **alike}


def _on_pole(construction: Construction) -> dict[str, None]:
    """The pole and the fixed points that sit on it; another point may be the first to be drawn."""
    given = [step for step in construction.steps if isinstance(step, Given) and step.point == construction.pole]
    return dict.fromkeys([construction.pole, *(name for step in given for name in step.also)])


def _vectors(construction: Construction, questions: Questions) -> Iterator[PolygonVector]:
    """Those of the equations, then the absolute motions that are not among them."""
    letter, drawn = LETTER[construction.plane], set[tuple[str, str]]()
    on_pole = _on_pole(construction)
    for term in construction.vectors().values():
        tail = construction.pole if term.tail in on_pole else term.tail
        drawn.add((tail, term.head))
        comma = "," if "@" in term.of + term.seen_from and term.seen_from else ""
        word = f"{letter}_{term.part}" if term.part else letter
        asked = "" if term.over else _question(questions, f"{word} {term.of}{comma}{term.seen_from}")
        yield PolygonVector(asked, tail, term.head)
    for name, node in construction.nodes.items():
        if node.site is not None and name not in on_pole and (construction.pole, name) not in drawn:
            yield PolygonVector(_question(questions, f"{letter} {node.of}"), construction.pole, name)


def _question(questions: Questions, text: str) -> str:
    found = questions.read(text)
    return found[0] if found is not None else ""


def _known(
    construction: Construction, mechanism: Mechanism, vectors: Sequence[PolygonVector]
) -> Iterator[PolygonVector]:
    """What is laid off from the givens alone: motions of driven links, and driven sliding."""
    driven = {driver.link for driver in mechanism.drivers if driver.from_link == FRAME and driver.kind != "slide"}
    by_ends = {(vector.tail, vector.head): vector for vector in vectors}
    for step in construction.steps:
        if not isinstance(step, LayOff):
            continue
        match step.term.size:
            case Turning(link, _, _) | Normal(link, _, _) | Tangential(link, _, _) if link in driven:
                yield by_ends.get((step.start, step.tip), PolygonVector("", step.start, step.tip))
            case Driven() | Relative():
                yield by_ends.get((step.start, step.tip), PolygonVector("", step.start, step.tip))
            case _:
                pass
