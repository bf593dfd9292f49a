"""Groups that no order of ruler and compass reaches: fitted positions, rates solved together, special points."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from typing import assert_never

from graphkin.construction import Chain, Equation, kinds, terms
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.dimensions import driven
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Operand
from graphkin.say.numbers import degrees, number
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading, capitalized
from graphkin.say.rolling import rate_relation, turning_relation


def fitted(reading: Reading, step: kinds.Fit) -> Iterator[Entry]:
    """A group's position by trial (样板法), or a train's by its relations; then what it comes to."""
    structure = reading.method.structure
    turning = {link for base in step.angles for link in _members(reading, base)}
    blocks = {structure.block(structure.slides[slide]) for slide in step.slides}
    members = [link for link in reading.mechanism.moving if link in turning | blocks]
    yield Sentence(_trial(reading, step, members, turning))
    values = [link_angle(reading, link, degrees) for link in members if link in turning]
    for slide, pair in ((slide, structure.slides[slide]) for slide in step.slides):
        if pair.named:
            name, length = names.of_slide("s", slide), float(reading.plot.s[slide])
        else:
            ends = (pair.line.origin, pair.point)
            name, length = f"l_{names.pair(*ends)}", abs(reading.arm(*ends))
        if pair.named or pair.line.named:
            values.append(f"{name} = {number(length * 1000, reading.noise * 1000)} mm")
    yield Sentence(reading.say("contacts.fitted", values=reading.joined(value for value in values if value)))


def _trial(reading: Reading, step: kinds.Fit, members: list[str], turning: set[str]) -> str:
    """The links that are to fit, and when they do."""
    links, relations = reading.links(members), [turning_relation(reading, contact).text for contact in step.contacts]
    if not step.closures:
        return reading.say("contacts.fit train", links=links, relations=reading.listed(relations))
    if all(closure.floats for closure in step.closures):
        return reading.say("contacts.fit floating", links=links, lengths=reading.listed(_arms(reading, step, "")))
    structure, ends = reading.method.structure, dict[str, set[str]]()
    for part in (part for closure in step.closures for part in closure.parts):
        if isinstance(part, terms.Arm):
            ends.setdefault(part.link, set()).update((part.tail, part.head))
        else:
            pair = structure.slides[part.slide]
            ends.setdefault(pair.guide, set()).add(part.slide)
            ends.setdefault(structure.block(pair), set()).add(part.slide)
    joints = Counter({reading.body(link): len(held) for link, held in ends.items() if reading.body(link) != FRAME})
    template = joints.most_common(1)[0][0]  # the link that most of the group's joints hold
    drivers = reading.relative_drivers(turning)
    angles = [driven(reading, k, reading.method.drivers[k])[0].text for k in drivers]
    words = {"links": links, "template": reading.link(template)}
    words["lengths"] = reading.listed(_arms(reading, step, template))
    if not relations and not angles:
        from graphkin.studies.assur import groups

        called = {reading.mechanism.called(link) for link in members}
        number = max((group.cls for group in groups(reading.method) if called & {*group.links}), default=3)
        return reading.say("contacts.fit", cls=reading.say(f"structure.class {number}"), **words)
    by = ["joints", *["rolling"] * bool(relations), *["drivers"] * bool(angles)]
    words["ties"] = reading.listed([reading.say(f"contacts.by {each}") for each in by])
    words["note"] = reading.say("contacts.since drawn") if relations else ""
    return reading.say("contacts.fit coupled", relations=reading.listed([*angles, *relations]), **words)


def _members(reading: Reading, base: str) -> list[str]:
    """The links that turn with a base link, itself first."""
    return list(dict.fromkeys([reading.body(base), *reading.group(base)]))


def _arms(reading: Reading, step: kinds.Fit, template: str) -> list[str]:
    """The other links' lengths, and the lines on which sliding points must lie."""
    parts = [part for closure in step.closures for part in closure.parts]
    texts: dict[object, str] = {}
    for part in (part for part in parts if not isinstance(part, terms.Arm) or part.link != template):
        if isinstance(part, terms.Arm):
            length = reading.on_paper(reading.distance(part.tail, part.head))
            texts.setdefault(frozenset((part.tail, part.head)), f"{names.pair(part.tail, part.head)} = {length} mm")
        elif reading.method.structure.slides_driven.get(part.slide) is not None:
            length = reading.on_paper(abs(float(reading.plot.s[part.slide])))
            texts.setdefault(part.slide, f"{names.of_slide('s', part.slide)} = {length} mm")
        else:
            slide = reading.method.structure.slides[part.slide]
            fixed = slide.guide == FRAME or part.slide in reading.contact_slides
            along = None if fixed else reading.points_along(part.slide)
            guide = names.pair(*along) if along else reading.path(part.slide)
            on = reading.say("contacts.lies on", point=names.point(slide.point), guide=guide)
            texts.setdefault(on, on)
    return list(texts.values())


def link_angle(reading: Reading, link: str, printed: Callable[[complex], str]) -> str:
    """`θ3 = 63.4° (B→C)` of a link's first two points; "" of a link that has not two."""
    points = reading.method.structure.named(link)[:2]
    if len(points) < 2:
        return ""
    name, angle = reading.rate("θ", link), printed(reading.arm(*points))
    return reading.say("derivation.angle of", name=name, angle=angle, arrow=names.arrow(*points))


def special_point(reading: Reading, step: kinds.Meet) -> str:
    """The point in which the lines of two legs meet."""
    site = reading.method.position.nodes[step.point].site
    assert site is not None
    lines = []
    for ray in (locus for locus in (step.first, step.second) if isinstance(locus, kinds.Ray)):
        match ray.direction:
            case terms.Along(tail, head):
                lines.append(reading.say("contacts.leg line", line=names.pair(tail, head)))
            case terms.AcrossGuide(slide):
                words = {"through": names.point(ray.through), "guide": reading.path(slide)}
                lines.append(reading.say("contacts.leg normal", **words))
            case terms.Across() | terms.AlongGuide() | terms.Quarter():
                raise AssertionError("a leg's line runs along a bar or across a guide")
            case _:
                assert_never(ray.direction)
    words = {"first": lines[0], "second": lines[1], "point": step.point}
    return reading.say("contacts.special point", link=reading.link(site.link), **words)


def special_introduction(polygon: PolygonReading, part: Equation) -> str:
    """The two legs that an equation is about; "" for any other."""
    legs = [term for term in part.left + part.right if term.over]
    site = polygon.construction.nodes[part.left[-1].head].site
    if not legs or site is None:
        return ""
    lines = []
    for term in legs:
        match term.direction:
            case terms.Across(tail, head) | terms.Along(tail, head):
                lines.append(names.pair(tail, head))
            case terms.AlongGuide(slide) | terms.AcrossGuide(slide):
                lines.append(polygon.reading.path(slide))
            case terms.Quarter() | None:
                raise AssertionError("a leg has one unknown direction line")
            case _:
                assert_never(term.direction)
    first, second = lines
    link = polygon.reading.link(site.link)
    return polygon.reading.say("contacts.special", of=names.point(part.of), link=link, first=first, second=second)


def instant_centre(polygon: PolygonReading, part: Equation) -> str:
    """Both legs on the fixed link: nothing to measure; "" otherwise."""
    both_sides, pole = part.left + part.right, polygon.construction.pole
    site = polygon.construction.nodes[part.left[-1].head].site
    legs = all(term.over and term.tail == pole for term in both_sides)
    if polygon.plane != "velocity" or len(both_sides) != 2 or not legs or site is None:
        return ""
    words = {"point": names.point(site.point), "link": polygon.reading.link(site.link)}
    words |= {"node": names.point(part.left[-1].head), "pole": names.point(pole)}
    return polygon.reading.say("contacts.instant centre", name=polygon.seen(part.of, ""), **words)


def about_centre(polygon: PolygonReading, part: Equation) -> str:
    """A special point that is an instant centre, about which the motion sought turns; "" of any other equation."""
    pole = polygon.construction.pole
    for term in part.left + part.right if polygon.plane == "velocity" else ():
        direction = term.direction
        if not isinstance(direction, terms.Across) or term.tail != pole or term.seen_from or term.over:
            continue
        special = polygon.reading.method.special.intersection((direction.tail, direction.head))
        for point, site in ((point, polygon.reading.method.position.nodes[point].site) for point in special):
            assert site is not None
            words = {"point": names.point(point), "link": polygon.reading.link(site.link)}
            words |= {"name": polygon.vector(term), "direction": polygon.direction(direction)}
            return polygon.reading.say("contacts.about centre", **words)
    return ""


def solved_together(polygon: PolygonReading, step: kinds.Simultaneous) -> Iterator[Entry]:
    """The equations, their unknowns, and what they come to."""
    reading, plane = polygon.reading, polygon.plane
    members = [link for base in step.angles for link in _members(reading, base)]
    if in_ratio := _constant_ratio(polygon, step, members):
        yield from in_ratio
        return
    slides = [reading.displacement(names.SLIDING[plane], slide) for slide in step.slides]
    unknowns = reading.listed([*(polygon.rate(link) for link in members), *slides])
    said = []
    if step.chains:
        loops = reading.listed([_loop(reading, chain) for chain in step.chains])
        said.append(reading.say("contacts.the loops", which=len(step.chains) > 1, loops=loops))
    if step.contacts:
        relations = reading.listed([rate_relation(polygon, contact).text for contact in step.contacts])
        said.append(reading.say("contacts.the relations", relations=relations))
    if sums := reading.rotations(members, names.RATE[plane]):
        said.append(reading.say("contacts.the rotations", sums=reading.listed(sums)))
    known = [size for chain in step.chains for size, _ in chain.known]
    floats = not step.contacts and not any(isinstance(size, terms.Drawn) for size in known)
    alone = "contacts.together, one" if len(step.chains) == 1 else "contacts.together"
    coupled = len(said) > bool(step.chains)  # ruler and triangle may find a way there
    key = "contacts.closed in themselves" if floats else "contacts.together, coupled" if coupled else alone
    equations = capitalized(reading.say("contacts.and both").join(said))
    row = f"{unknowns} {reading.say('sheet.together')}"
    yield Sentence(reading.say(key, unknowns=unknowns, equations=equations), row=row)
    for link in dict.fromkeys(members):
        value = reading.turning(link, plane)
        yield Calculation(polygon.rate(link), (), "", abs(value), polygon.rate_unit, reading.sense(value))
    for slide, symbol in zip(step.slides, slides, strict=True):
        yield Calculation(symbol, (), "", reading.sliding(slide, plane), names.UNIT[plane])


def _constant_ratio(polygon: PolygonReading, step: kinds.Simultaneous, members: list[str]) -> list[Entry]:
    """A gear train that turns as one driven link does: its accelerations have the ratios of its velocities (Willis)."""
    reading, plot = polygon.reading, polygon.reading.plot
    known = {link for contact in step.contacts for link, _ in contact.angles} - {*members, FRAME}
    moved = [link for link in known if plot.omega[link]]
    others = any(plot.alpha[link] for link in known - {*moved})
    if polygon.plane == "velocity" or step.chains or step.slides or len(moved) != 1 or others:
        return []
    input_, wheels = moved[0], list(dict.fromkeys(members))
    rate, turning = reading.rate("α", input_), reading.rate("ω", input_)
    if reading.ruler is not None:
        return []  # velocities that were read have not quite the ratio of the radii
    said: list[Entry] = [Sentence(reading.say("contacts.constant ratio"))]
    for link in wheels:
        first, second, third = (Operand(float(v)) for v in (plot.alpha[input_], plot.omega[link], plot.omega[input_]))
        formula, value = f"{rate} {reading.rate('ω', link)}/{turning}", float(plot.alpha[link])
        note = reading.signed(value)
        said.append(Calculation(polygon.rate(link), (formula,), first * second / third, value, "rad/s²", note))
    return said


def _loop(reading: Reading, chain: Chain) -> str:
    """`A–B–C–D`: the joints that a chain of arrows passes."""
    points: dict[str, None] = {}
    for unknown in chain.unknown:
        slide = reading.method.structure.slides[unknown.slide] if unknown.slide else None
        ends = (unknown.tail, unknown.head) if slide is None else (slide.point,)
        points |= dict.fromkeys(names.point(point) for point in ends if reading.named(point))
    return "–".join(points)
