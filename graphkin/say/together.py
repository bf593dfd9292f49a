"""Groups that no order of ruler and compass reaches: fitted positions, rates solved together, special points."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import assert_never

from graphkin.construction import (
    Across,
    AcrossGuide,
    Along,
    AlongGuide,
    Arm,
    Chain,
    Direction,
    Drawn,
    Equation,
    Fit,
    Meet,
    Quarter,
    Ray,
    Simultaneous,
    Term,
)
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Operand
from graphkin.say.given_sizes import driven
from graphkin.say.numbers import degrees, number
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading
from graphkin.say.rolling_relation import relation_of, turned

# --- position -----------------------------------------------------------------------------------


def fitted(reading: Reading, step: Fit) -> Iterator[Entry]:
    """A group's position by trial (样板法), or a train's by its relations; then what it comes to."""
    turning = {link for base in step.angles for link in _members(reading, base)}
    members = [link for link in reading.mechanism.moving if link in turning | _blocks(reading, step)]
    yield Sentence(_tried(reading, step, members, turning))
    found = [_angle(reading, link) for link in members if link in turning]
    found += [_slide(reading, slide) for slide in step.slides]
    values = reading.say("common.and").join(value for value in found if value)
    yield Sentence(reading.say("contacts.fitted", values=values))


def _tried(reading: Reading, step: Fit, members: list[str], turning: set[str]) -> str:
    """The links that are to fit, and when they do."""
    links = reading.listed([reading.link(link) for link in members])
    relations = [turned(reading, contact).text for contact in step.contacts]
    if not step.closures:
        return reading.say("contacts.fit train", links=links, relations=reading.listed(relations))
    if all(closure.floats for closure in step.closures):
        return reading.say("contacts.fit floating", links=links, lengths=reading.listed(_arms(reading, step, "")))
    template, numbers = _template(reading, step), reading.relative_drivers(turning)
    turned_by = [driven(reading, k, reading.method.drivers[k])[0].text for k in numbers]
    words = {"links": links, "template": reading.link(template)}
    words["lengths"] = reading.listed(_arms(reading, step, template))
    if not relations and not turned_by:
        cls = reading.say(f"structure.class {_class(reading, members)}")
        return reading.say("contacts.fit", cls=cls, **words)
    by = ["joints", *["rolling"] * bool(relations), *["drivers"] * bool(turned_by)]
    words["ties"] = reading.listed([reading.say(f"contacts.by {each}") for each in by])
    words["note"] = reading.say("contacts.since drawn") if relations else ""
    return reading.say("contacts.fit coupled", relations=reading.listed([*turned_by, *relations]), **words)


def _class(reading: Reading, members: list[str]) -> int:
    """That of the group some links make up."""
    from graphkin.studies.assur import groups

    called = {reading.mechanism.called(link) for link in members}
    return max((group.cls for group in groups(reading.method) if called & {*group.links}), default=3)


def _blocks(reading: Reading, step: Fit) -> set[str]:
    """The links that only slide, of a group."""
    structure = reading.method.structure
    return {structure.block(structure.slides[slide]) for slide in step.slides}


def _members(reading: Reading, base: str) -> list[str]:
    """The links that turn with a base link, itself first."""
    return list(dict.fromkeys([reading.body(base), *reading.group(base)]))


def _template(reading: Reading, step: Fit) -> str:
    """The link that most of the group's joints hold."""
    ends: dict[str, set[str]] = {}
    for closure in step.closures:
        for part in closure.parts:
            if isinstance(part, Arm):
                ends.setdefault(part.link, set()).update((part.tail, part.head))
            else:
                pair = reading.method.structure.slides[part.slide]
                ends.setdefault(pair.guide, set()).add(part.slide)
                ends.setdefault(reading.method.structure.block(pair), set()).add(part.slide)
    joints = Counter({reading.body(link): len(held) for link, held in ends.items() if reading.body(link) != FRAME})
    return joints.most_common(1)[0][0]


def _arms(reading: Reading, step: Fit, template: str) -> list[str]:
    """The other links' lengths, and the lines on which sliding points must lie."""
    found: dict[str, None] = {}
    for closure in step.closures:
        for part in closure.parts:
            if isinstance(part, Arm) and part.link != template:
                pair = names.pair(part.tail, part.head)
                found[f"{pair} = {reading.on_paper(reading.distance(part.tail, part.head))} mm"] = None
            elif not isinstance(part, Arm):
                slide = reading.method.structure.slides[part.slide]
                if reading.method.structure.slides_driven.get(part.slide) is not None:
                    symbol = names.of_slide("s", part.slide)
                    length = abs(float(reading.plot.s[part.slide]))
                    found[f"{symbol} = {reading.on_paper(length)} mm"] = None
                else:
                    fixed = slide.guide == FRAME or part.slide in reading.contact_slides
                    along = None if fixed else reading.points_along(part.slide)
                    guide = names.pair(*along) if along else reading.path(part.slide)
                    found[reading.say("contacts.lies on", point=names.point(slide.point), guide=guide)] = None
    return list(found)


def _angle(reading: Reading, link: str) -> str:
    points = reading.method.structure.named(link)
    if len(points) < 2:
        return ""
    angle = degrees(reading.plot.arm(points[0], points[1]))
    arrow = names.arrow(points[0], points[1])
    return reading.say("derivation.angle of", name=reading.rate("θ", link), angle=angle, arrow=arrow)


def _slide(reading: Reading, slide: str) -> str:
    pair = reading.method.structure.slides[slide]
    value = number(float(reading.plot.s[slide]) * 1000, reading.noise * 1000)
    if pair.named:
        return f"{names.of_slide('s', slide)} = {value} mm"
    if pair.line.named:
        ends = names.pair(pair.line.origin, pair.point)
        exactly = float(abs(reading.plot.arm(pair.line.origin, pair.point)))
        return f"l_{ends} = {number(exactly * 1000, reading.noise * 1000)} mm"
    return ""


def special_point(reading: Reading, step: Meet) -> str:
    """Where the lines of two legs meet."""
    site = reading.method.position.nodes[step.point].site
    assert site is not None
    lines = [_line(reading, locus) for locus in (step.first, step.second) if isinstance(locus, Ray)]
    words = {"first": lines[0], "second": lines[1], "point": step.point}
    return reading.say("contacts.special point", link=reading.link(site.link), **words)


def _line(reading: Reading, ray: Ray) -> str:
    match ray.direction:
        case Along(tail, head):
            return reading.say("contacts.leg line", line=names.pair(tail, head))
        case AcrossGuide(slide):
            return reading.say("contacts.leg normal", through=names.point(ray.through), guide=reading.path(slide))
        case Across() | AlongGuide() | Quarter():
            raise AssertionError("a leg's line runs along a bar or across a guide")
        case _:
            assert_never(ray.direction)


# --- polygons: special points -------------------------------------------------------------------


def special_introduction(polygon: PolygonReading, part: Equation) -> str:
    """What an equation of two legs is about; "" for any other."""
    legs = [term for term in part.left + part.right if term.over]
    node = polygon.construction.nodes[part.left[-1].head]
    if not legs or node.site is None:
        return ""
    first, second = (_leg(polygon, term) for term in legs)
    link = polygon.reading.link(node.site.link)
    return polygon.reading.say("contacts.special", of=names.point(part.of), link=link, first=first, second=second)


def _leg(polygon: PolygonReading, term: Term) -> str:
    direction: Direction | None = term.direction
    match direction:
        case Across(tail, head) | Along(tail, head):
            return names.pair(tail, head)
        case AlongGuide(slide) | AcrossGuide(slide):
            return polygon.reading.path(slide)
        case Quarter() | None:
            raise AssertionError("a leg has one unknown direction line")
        case _:
            assert_never(direction)


def instant_centre(polygon: PolygonReading, part: Equation) -> str:
    """Both legs on the fixed link: nothing to measure; "" otherwise."""
    legs = [term for term in part.left + part.right if term.over]
    head = part.left[-1].head
    node, pole = polygon.construction.nodes[head], polygon.construction.pole
    if polygon.plane != "velocity" or len(legs) != 2 or node.site is None or len(part.left + part.right) != 2:
        return ""
    if any(term.tail != pole for term in legs):
        return ""
    return polygon.reading.say(
        "contacts.instant centre",
        point=names.point(node.site.point),
        link=polygon.reading.link(node.site.link),
        name=polygon.seen(part.of, ""),
    )


# --- polygons: together -------------------------------------------------------------------------


def solved_together(polygon: PolygonReading, step: Simultaneous) -> Iterator[Entry]:
    """Which equations, which unknowns, and what they come to."""
    reading, plot = polygon.reading, polygon.reading.plot
    members = [link for base in step.angles for link in _members(reading, base)]
    if in_ratio := _constant_ratio(polygon, step, members):
        yield from in_ratio
        return
    slides = [_symbol(polygon, slide) for slide in step.slides]
    unknowns = reading.listed([*(polygon.rate(link) for link in members), *slides])
    said = []
    if step.chains:
        loops = reading.listed([_loop(polygon, chain) for chain in step.chains])
        said.append(reading.say("contacts.the loop" if len(step.chains) == 1 else "contacts.the loops", loops=loops))
    if step.contacts:
        relations = reading.listed([relation_of(polygon, contact).text for contact in step.contacts])
        said.append(reading.say("contacts.the relations", relations=relations))
    if sums := reading.rotations(members, names.RATE[polygon.plane]):
        said.append(reading.say("contacts.the rotations", sums=reading.listed(sums)))
    equations = reading.say("contacts.and both").join(said)
    equations = equations[0].upper() + equations[1:]
    floats = not any(isinstance(size, Drawn) for chain in step.chains for size, _ in chain.known) and not step.contacts
    alone = "contacts.together, one" if len(step.chains) == 1 else "contacts.together"
    coupled = len(said) > bool(step.chains)  # ruler and triangle may find a way there
    key = "contacts.closed in themselves" if floats else "contacts.together, coupled" if coupled else alone
    yield Sentence(reading.say(key, unknowns=unknowns, equations=equations))
    table = plot.omega if polygon.plane == "velocity" else plot.alpha
    for link in dict.fromkeys(members):
        value = reading.usual.rate(float(table[link]), polygon.plane)
        note = reading.say("common.ccw" if value > 0 else "common.cw") if value else ""
        yield Calculation(polygon.rate(link), (), "", abs(value), polygon.rate_unit, note)
    rates = plot.s_rate if polygon.plane == "velocity" else plot.s_acceleration
    for slide, symbol in zip(step.slides, slides, strict=True):
        value = reading.usual.motion(float(rates[slide]), polygon.plane)
        yield Calculation(symbol, (), "", value, names.UNIT[polygon.plane])


def _constant_ratio(polygon: PolygonReading, step: Simultaneous, members: list[str]) -> list[Entry]:
    """A gear train that turns as one driven link does: its accelerations have the ratios of its velocities (Willis)."""
    reading, plot = polygon.reading, polygon.reading.plot
    known = {link for contact in step.contacts for link, _ in contact.angles} - {*members, FRAME}
    moved = [link for link in known if plot.omega[link]]
    others = any(plot.alpha[link] for link in known - {*moved})
    if polygon.plane == "velocity" or step.chains or step.slides or len(moved) != 1 or others:
        return []
    input_, wheels = moved[0], list(dict.fromkeys(members))
    rate, turning = reading.rate("α", input_), reading.rate("ω", input_)
    if not plot.alpha[input_]:
        zero = " = ".join([*(reading.rate("α", link) for link in wheels), "0"])
        return [Sentence(reading.say("contacts.constant ratio at rest", rate=rate, zero=zero))]
    if reading.ruler is not None:
        return []  # velocities that were read have not quite the ratio of the radii
    said: list[Entry] = [Sentence(reading.say("contacts.constant ratio"))]
    for link in wheels:
        first, second, third = (Operand(float(v)) for v in (plot.alpha[input_], plot.omega[link], plot.omega[input_]))
        formula, value = f"{rate} {reading.rate('ω', link)}/{turning}", float(plot.alpha[link])
        note = reading.signed(value)
        said.append(Calculation(polygon.rate(link), (formula,), first * second / third, value, "rad/s²", note))
    return said


def _symbol(polygon: PolygonReading, slide: str) -> str:
    pair = polygon.reading.method.structure.slides[slide]
    name = pair.name if pair.named else names.point(pair.point)
    return names.of_slide(names.SLIDING[polygon.plane], name)


def _loop(polygon: PolygonReading, chain: Chain) -> str:
    """`ABCD`: the joints that a chain of arrows passes."""
    reading = polygon.reading
    slides = reading.method.structure.slides
    points: dict[str, None] = {}
    for unknown in chain.unknown:
        ends = (slides[unknown.slide].point,) if unknown.slide else (unknown.tail, unknown.head)
        points |= dict.fromkeys(names.point(point) for point in ends if reading.named(point))
    return "–".join(points)
