"""A vector equation in words: why it holds, its rows, its known sizes, how it is drawn, and what it gives."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from graphkin.construction import Equation, Step, Term, kinds, terms
from graphkin.say import names
from graphkin.say.entry import Entry, Sentence, TermRow, VectorEquation
from graphkin.say.numbers import number
from graphkin.say.plane import PolygonReading, size_calculation, size_row
from graphkin.say.rolling import same_velocities
from graphkin.say.simultaneous import about_centre, instant_centre, special_introduction


def equation(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """Everything about one vector equation, in the order of a textbook."""
    if sentence := _translation(polygon, part):
        row = f"{polygon.seen(part.of, '')} = {polygon.vector(part.right[0])}"
        yield polygon.sentence(next(step for step in part.steps if isinstance(step, kinds.LayOff)), sentence, row)
        return
    if centre := instant_centre(polygon, part):
        yield polygon.sentence(next(step for step in part.steps if isinstance(step, kinds.Meet)), centre)
        return
    both_sides, reading = part.left + part.right, polygon.reading
    # why the coincident points lie there: said with the velocities, where there is a choice
    known = {term.sites[0].point: term for term in both_sides if isinstance(term.size, terms.Drawn) and term.sites}
    slips = (term.sites[0].point for term in both_sides if _coincident(term) and term.size is None and term.sites)
    met = next((point for point in slips if point in known), "")
    if polygon.plane == "velocity" and met and polygon.size(known[met].tail, known[met].head):
        yield Sentence(reading.say("derivation.chosen", point=names.point(met), known=polygon.vector(known[met])))
    yield from same_velocities(polygon, part)
    yield from (Sentence(centre) for centre in [about_centre(polygon, part)] if centre)
    yield Sentence(_introduction(polygon, part))
    yield worded(polygon, part)
    for term in both_sides:  # of the Coriolis term of a pin, the link whose rotation it has
        if isinstance(term.size, terms.Coriolis) and any(reading.method.structure.is_pin(s.link) for s in term.sites):
            words = {"point": names.point(term.sites[0].point), "link": reading.link(term.size.link)}
            yield Sentence(reading.say("derivation.path of the slot", rate=reading.rate("ω", term.size.link), **words))
    laid = (step.term for step in part.steps if isinstance(step, kinds.LayOff))
    for term in dict.fromkeys(term for term in laid if not isinstance(term.size, terms.Drawn)):
        yield size_calculation(polygon, term, both_sides)
    yield from _drawing(polygon, part.steps, both_sides)
    yield from _measured(polygon, part)


def known_arrow(polygon: PolygonReading, step: kinds.LayOff) -> Iterator[Entry]:
    """A motion that is known without an equation: that of a driven point."""
    size = step.term.size
    if isinstance(size, terms.Normal) and not step.term.part:
        words = {"of": names.point(size.head), "seen_from": names.point(size.tail)}
        alpha = polygon.reading.rate("α", size.link)
        yield Sentence(polygon.reading.say("derivation.only normal", alpha=alpha, **words))
    size_of = size_calculation(polygon, step.term, (step.term,))
    yield size_of
    row = " = ".join([size_of.name, *(size_of.formulas or (() if size_of.value else ("0",)))])
    yield polygon.sentence(step, _lay_off(polygon, step), row)


def worded(polygon: PolygonReading, part: Equation) -> VectorEquation:
    """The equation as it is printed: a side that is the motion sought itself stands first."""
    front = "" if part.is_sought(part.sides[0]) else polygon.seen(part.of, "")
    both_sides = part.left + part.right
    rows: list[tuple[TermRow, ...]] = []
    for side in part.sides:
        row = []
        for term in side:
            size = size_row(polygon, term)
            resting = size == "0" and isinstance(term.size, terms.Drawn)
            direction = "—" if resting else polygon.direction_row(term, both_sides)
            row.append(TermRow(polygon.vector(term), direction, size))
        rows.append(tuple(row))
    return VectorEquation(front, tuple(rows))


def _introduction(polygon: PolygonReading, part: Equation) -> str:
    """The points of one link, or the coincident points, that the equation is about."""
    say = polygon.reading.say
    if special := special_introduction(polygon, part):
        return special
    relations = dict.fromkeys(_relation(polygon, term) for term in part.left + part.right if term.seen_from)
    *before, last = [relation for relation in relations if relation] or [""]
    if last:
        first = [say("derivation.between relations").join(before)] if before else []
        joined = say("derivation.last relation").join([*first, last])
        return say(f"derivation.from relations, {polygon.plane}", relations=joined)
    motion = say(f"derivation.motion {polygon.plane}")
    return say("derivation.plain equation", of=names.point(part.of), motion=motion)


def _relation(polygon: PolygonReading, term: Term) -> str:
    words = {"of": names.point(term.of), "seen_from": names.point(term.seen_from)}
    if not term.part and isinstance(term.direction, terms.Along | terms.AcrossGuide):
        return polygon.reading.say("contacts.contact points", **words)
    if _coincident(term):
        return polygon.reading.say("derivation.coincident", **words)
    links = {site.link for site in term.sites if len(term.sites) > 1}
    if isinstance(term.size, terms.Turning | terms.Normal | terms.Tangential):
        links = {term.size.link}
    if len(links) == 1:
        words["link"] = polygon.reading.link(*links)
    return polygon.reading.say("derivation.points of link", **words) if "link" in words else ""


def _coincident(term: Term) -> bool:
    """True of the relative motion of two links past each other."""
    sliding = isinstance(term.direction, terms.AlongGuide) or isinstance(term.size, terms.Relative | terms.Driven)
    return term.part[:1] in ("k", "r") or (not term.part and sliding)


def _translation(polygon: PolygonReading, part: Equation) -> str:
    """A link that cannot turn: all its points move alike, and there is nothing to draw."""
    first, last = part.right[0], part.right[-1]
    carried = len(part.right) == 2 and isinstance(first.size, terms.Drawn)
    if not carried or not isinstance(last.size, terms.Turning | terms.Normal):
        return ""
    if not polygon.reading.translates(last.size.link):
        return ""
    words = {"link": polygon.reading.link(last.size.link), "of": polygon.seen(part.of, "")}
    words |= {"seen_from": polygon.vector(first), "node": names.point(last.head), "base": names.point(last.tail)}
    return polygon.reading.say("derivation.translates", **words)


def _drawing(polygon: PolygonReading, steps: tuple[Step, ...], both_sides: tuple[Term, ...]) -> Iterator[Entry]:
    for step in steps:
        match step:
            case kinds.LayOff():
                yield polygon.sentence(step, _lay_off(polygon, step))
            case kinds.Meet():
                one, other = (locus for locus in (step.first, step.second) if isinstance(locus, kinds.Ray))
                words = {"first": names.point(one.through), "second": names.point(other.through)}
                for which, ray in (("first", one), ("second", other)):
                    words[f"{which}_direction"] = direction = polygon.line_direction(ray.direction, both_sides)
                    words[f"{which}_line"] = _ray(polygon, direction)
                key = "derivation.meet rays one point" if one.through == other.through else "derivation.meet rays"
                yield polygon.sentence(step, polygon.reading.say(key, point=names.point(step.point), **words))
            case kinds.Ray():
                pass  # told where it crosses another
            case kinds.Given(point):
                yield Sentence(polygon.reading.say("derivation.from anywhere", point=names.point(point)))
            case kinds.Image() | kinds.Measure() | kinds.Roll() | kinds.Simultaneous() | kinds.Arc() | kinds.Swing():
                raise AssertionError("an equation of a polygon is drawn with arrows and lines")
            case kinds.Fit() | kinds.Touch():
                raise AssertionError("positions are drawn before")
            case _:
                assert_never(step)


def _ray(polygon: PolygonReading, direction: str) -> str:
    """`the line ⊥BC`; with words of a line that has no points to be called by."""
    if re.search("^[a-z]{2}|[\u4e00-\u9fff]", direction[1:]):
        return polygon.reading.say("derivation.ray beside", line=direction[1:], which=int(direction[0] == "⊥"))
    return polygon.reading.say("derivation.ray", direction=direction)


def _lay_off(polygon: PolygonReading, step: kinds.LayOff) -> str:
    say, term = polygon.reading.say, step.term
    start, tip, name = names.point(step.start), names.point(step.tip), polygon.vector(term)
    if isinstance(term.size, terms.Drawn):
        drawn = names.arrow(term.size.tail, term.size.head)
        return say("derivation.carried", name=name, drawn=drawn, start=start, tip=tip)
    if not polygon.size(term.tail, term.head):
        return say("derivation.lay off nothing", name=name, tip=tip, start=start)
    ends = (step.tip, step.start) if step.backwards else (step.start, step.tip)
    length = polygon.laid(name, term.tail, term.head, ends)
    key = "derivation.lay off backwards" if step.backwards else "derivation.lay off"
    return say(key, name=name, start=start, length=length)


def _measured(polygon: PolygonReading, part: Equation) -> Iterator[Entry]:
    """The unknown arrows, then the motion sought where it is none of them; first in mm, then in SI units."""
    reading, pole, node = polygon.reading, polygon.construction.pole, part.left[-1].head
    unknown = [term for term in part.left + part.right if term.unknowns]
    ends = [(term.tail, term.head) for term in unknown]
    sought = node != pole and not any(part.is_sought(side) for side in (part.left, part.right))
    lengths = []
    for pair in dict.fromkeys([*ends, (pole, node)] if sought else ends):
        length = polygon.length_mm(*pair)
        shown = f"{number(length)} mm{reading.too_short(length)}" if length else "0"
        lengths.append(f"{names.stretch(*pair)} = {shown}")
    yield Sentence(reading.say("derivation.measured", lengths=reading.joined(lengths)))
    for term in unknown:
        arrow, of = (term.tail, term.head), polygon.of(term.head) if term.tail == pole else ""
        if not term.over and of and polygon.name(*arrow) == polygon.seen(of, ""):
            yield polygon.measured_absolute(term.head)
        else:
            yield polygon.measured(*arrow, polygon.vector(term) if term.over else "")
    if sought:  # where it starts from a point at rest, a relative motion is all there is of it
        absolute, name = polygon.measured_absolute(node), polygon.name(pole, node)
        yield absolute if name == absolute.name else replace(absolute, formulas=(name,), numbers="")
