"""A vector equation in words: why it holds, its rows, its known sizes, how it is drawn, and what it gives."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from graphkin.construction import (
    AcrossGuide,
    Along,
    AlongGuide,
    Arc,
    Coriolis,
    Drawn,
    Driven,
    Equation,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Normal,
    Ray,
    Relative,
    Roll,
    Simultaneous,
    Step,
    Swing,
    Tangential,
    Term,
    Touch,
    Turning,
)
from graphkin.say import names
from graphkin.say.contact_points import same_velocities
from graphkin.say.entry import Calculation, Entry, Sentence, TermRow, VectorEquation
from graphkin.say.numbers import number
from graphkin.say.plane import PolygonReading
from graphkin.say.sizes import known_size, size_row
from graphkin.say.together import instant_centre, special_introduction


def equation(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """Everything about one vector equation, in the order of a textbook."""
    if sentence := _translation(polygon, part):
        yield polygon.told(next(step for step in part.steps if isinstance(step, LayOff)), sentence)
        return
    yield from _chosen(polygon, part)
    yield from same_velocities(polygon, part)
    yield Sentence(_introduction(polygon, part))
    yield worded(polygon, part)
    yield from _whose_rotation(polygon, part)
    terms = part.left + part.right
    laid = (step.term for step in part.steps if isinstance(step, LayOff))
    known = dict.fromkeys(term for term in laid if not isinstance(term.size, Drawn))
    for term in known:
        yield known_size(polygon, term, terms)
    yield from _drawing(polygon, part.steps, terms)
    if centre := instant_centre(polygon, part):
        yield Sentence(centre)
    else:
        yield from _measured(polygon, part)


def known_arrow(polygon: PolygonReading, step: LayOff) -> Iterator[Entry]:
    """A motion that is known without an equation: that of a driven point."""
    size = step.term.size
    if isinstance(size, Normal) and not step.term.part:
        alpha, point = polygon.reading.rate("α", size.link), names.point(size.head)
        tail = names.point(size.tail)
        yield Sentence(polygon.reading.say("derivation.only normal", alpha=alpha, of=point, seen_from=tail))
    yield known_size(polygon, step.term, (step.term,))
    yield polygon.told(step, _lay_off(polygon, step))


# --- the equation itself ------------------------------------------------------------------------


def worded(polygon: PolygonReading, part: Equation) -> VectorEquation:
    """The equation as it is printed: a side that is the motion sought itself stands first."""
    sides = (part.left, part.right)
    if not _alone(part, part.left) and _alone(part, part.right):
        sides = (part.right, part.left)
    front = "" if _alone(part, sides[0]) else polygon.seen(part.of, "")
    terms = part.left + part.right
    left, right = (tuple(_arrow(polygon, term, terms) for term in side) for side in sides)
    return VectorEquation(front, (left, right))


def _alone(part: Equation, side: tuple[Term, ...]) -> bool:
    """Whether a side is nothing but the motion sought."""
    return len(side) == 1 and side[0].of == part.of and not side[0].seen_from


def _arrow(polygon: PolygonReading, term: Term, equation: tuple[Term, ...]) -> TermRow:
    ends = (term.tail, term.head)
    size = size_row(polygon, term)
    resting = size == "0" and isinstance(term.size, Drawn)
    direction = "—" if resting else polygon.direction_row(term, equation)
    name = names.vector(term.name(polygon.plane))
    return TermRow(name, direction, size, polygon.size(*ends), polygon.length_mm(*ends), ends)


def _introduction(polygon: PolygonReading, part: Equation) -> str:
    """Which points of which link, or which coincident points, the equation is about."""
    say = polygon.reading.say
    if special := special_introduction(polygon, part):
        return special
    found = dict.fromkeys(_relation(polygon, term) for term in part.left + part.right if term.seen_from)
    relations = [relation for relation in found if relation]
    if relations:
        first = say("derivation.between relations").join(relations[:-1])
        joined = say("derivation.last relation").join([first, relations[-1]] if first else relations)
        return say(f"derivation.from relations, {polygon.plane}", relations=joined)
    motion = say(f"derivation.motion {polygon.plane}")
    return say("derivation.plain equation", of=names.point(part.of), motion=motion)


def _chosen(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """Why the coincident points are taken where they are: told with the velocities, where there is a choice."""
    terms = part.left + part.right
    known = {term.sites[0].point: term for term in terms if isinstance(term.size, Drawn) and term.sites}
    slips = (term.sites[0].point for term in terms if _coincident(term) and term.size is None and term.sites)
    met = next((point for point in slips if point in known), "")
    if polygon.plane == "velocity" and met and polygon.size(known[met].tail, known[met].head):
        name = names.vector(known[met].name(polygon.plane))
        yield Sentence(polygon.reading.say("derivation.chosen", point=names.point(met), known=name))


def _whose_rotation(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """Which link's rotation the Coriolis term of a pin has: of the one in which its path is straight."""
    reading, structure = polygon.reading, polygon.reading.method.structure
    for term in part.left + part.right:
        if isinstance(term.size, Coriolis) and any(structure.is_pin(site.link) for site in term.sites):
            words = {"point": names.point(term.sites[0].point), "link": reading.link(term.size.link)}
            yield Sentence(reading.say("derivation.path of the slot", rate=reading.rate("ω", term.size.link), **words))


def _relation(polygon: PolygonReading, term: Term) -> str:
    of, seen_from = names.point(term.of), names.point(term.seen_from)
    if not term.part and isinstance(term.direction, Along | AcrossGuide):
        return polygon.reading.say("contacts.contact points", of=of, seen_from=seen_from)
    if _coincident(term):
        return polygon.reading.say("derivation.coincident", of=of, seen_from=seen_from)
    link = _link(polygon, term)
    return polygon.reading.say("derivation.points of link", of=of, seen_from=seen_from, link=link) if link else ""


def _coincident(term: Term) -> bool:
    """Whether a relative motion is that of two links past each other."""
    return term.part[:1] in ("k", "r") or (
        not term.part and (isinstance(term.direction, AlongGuide) or isinstance(term.size, Relative | Driven))
    )


def _link(polygon: PolygonReading, term: Term) -> str:
    """The link on which both points of a relative motion lie."""
    if isinstance(term.size, Turning | Normal | Tangential):
        return polygon.reading.link(term.size.link)
    step = polygon.levers.get((term.tail, term.head))
    return polygon.reading.link(step.of) if step else ""


def _translation(polygon: PolygonReading, part: Equation) -> str:
    """A link that cannot turn: all its points move alike, and there is nothing to draw."""
    last = part.right[-1]
    if len(part.right) != 2 or not isinstance(last.size, Turning | Normal):
        return ""
    if not isinstance(part.right[0].size, Drawn) or not polygon.reading.translates(last.size.link):
        return ""
    return polygon.reading.say(
        "derivation.translates",
        link=polygon.reading.link(last.size.link),
        of=polygon.seen(part.of, ""),
        seen_from=names.vector(part.right[0].name(polygon.plane)),
        node=names.point(last.head),
        base=names.point(last.tail),
    )


# --- the pencil ---------------------------------------------------------------------------------


def _drawing(polygon: PolygonReading, steps: tuple[Step, ...], terms: tuple[Term, ...]) -> Iterator[Entry]:
    for step in steps:
        match step:
            case LayOff():
                yield polygon.told(step, _lay_off(polygon, step))
            case Meet():
                yield polygon.told(step, _meet(polygon, step, terms))
            case Ray():
                pass  # told where it crosses another
            case Given(point):
                yield Sentence(polygon.reading.say("derivation.from anywhere", point=names.point(point)))
            case Image() | Measure() | Arc() | Swing() | Roll() | Fit() | Touch() | Simultaneous():
                raise AssertionError("an equation of a polygon is drawn with arrows and lines")
            case _:
                assert_never(step)


def _lay_off(polygon: PolygonReading, step: LayOff) -> str:
    say, term = polygon.reading.say, step.term
    start, tip = names.point(step.start), names.point(step.tip)
    name = names.vector(term.name(polygon.plane))
    if isinstance(term.size, Drawn):
        drawn = names.arrow(term.size.tail, term.size.head)
        return say("derivation.carried", name=name, drawn=drawn, start=start, tip=tip)
    if not polygon.size(term.tail, term.head):
        return say("derivation.lay off nothing", name=name, tip=tip, start=start)
    ends = (step.tip, step.start) if step.backwards else (step.start, step.tip)
    length = polygon.laid(name, term.tail, term.head, ends)
    key = "derivation.lay off backwards" if step.backwards else "derivation.lay off"
    return say(key, name=name, start=start, length=length)


def _meet(polygon: PolygonReading, step: Meet, terms: tuple[Term, ...]) -> str:
    rays = [locus for locus in (step.first, step.second) if isinstance(locus, Ray)]
    directions = [polygon.line_direction(ray.direction, terms) for ray in rays]
    return polygon.reading.say(
        "derivation.meet rays one point" if rays[0].through == rays[1].through else "derivation.meet rays",
        first=names.point(rays[0].through),
        second=names.point(rays[1].through),
        first_direction=directions[0],
        second_direction=directions[1],
        point=names.point(step.point),
    )


# --- what it gives ------------------------------------------------------------------------------


def _measured(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """The unknown arrows, then the motion sought where it is none of them; first in mm, then in SI units."""
    pole, node = polygon.construction.pole, part.left[-1].head
    unknown = [term for term in part.left + part.right if term.unknowns]
    ends = [(term.tail, term.head) for term in unknown]
    sought = not any(_alone(part, side) for side in (part.left, part.right))
    lengths = dict.fromkeys([*ends, (pole, node)] if sought and node != pole else ends)
    listed = [f"{names.stretch(*pair)} = {_millimetres(polygon, pair)}" for pair in lengths]
    joined = polygon.reading.say("common.and").join(listed)
    yield Sentence(polygon.reading.say("derivation.measured", lengths=joined))
    for term in unknown:
        yield _result(polygon, term)
    if sought and node != pole:
        yield _sought(polygon, node)


def _sought(polygon: PolygonReading, node: str) -> Calculation:
    """The motion sought; where it starts from a point at rest, a relative motion is all there is of it."""
    pole, absolute = polygon.construction.pole, polygon.measured_absolute(node)
    name = polygon.name(pole, node)
    return absolute if name == absolute.name else replace(absolute, formulas=(name,), numbers="")


def _millimetres(polygon: PolygonReading, ends: tuple[str, str]) -> str:
    length = polygon.length_mm(*ends)
    return f"{number(length)} mm{polygon.reading.too_short(length)}" if length else "0"


def _result(polygon: PolygonReading, term: Term) -> Calculation:
    if term.over:
        return polygon.measured(term.tail, term.head, names.vector(term.name(polygon.plane)))
    tail, head = term.tail, term.head
    if tail == polygon.construction.pole and polygon.of(head):
        named = polygon.name(tail, head)
        if named == polygon.seen(polygon.of(head), ""):
            return polygon.measured_absolute(head)
    return polygon.measured(tail, head)
