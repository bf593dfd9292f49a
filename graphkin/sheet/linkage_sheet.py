"""Linkages on one sheet: limits and extreme transmission angles as textbooks draw them, or the family of kinds.

On the left both limit positions over each other (the second thin) with psi or H and theta; on the right the
positions between which the transmission angle lies. Both at one true scale.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations

from graphkin.base.lines import away_from
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.say.catalogue import say
from graphkin.say.linkages import kind_name, limit_caption, titled, transmission_caption
from graphkin.say.reading import capitalized
from graphkin.sheet import lettering, symbols
from graphkin.sheet.drafting_figure import angle
from graphkin.sheet.fixed_link import grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import LABEL, Label, Run, number, plain, point_label, points_label, quantity_label, valued
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Stroke, Text
from graphkin.sheet.mechanism_figure import moving_links
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import papers_for
from graphkin.sheet.single_figure import SCALE, Picture, gridded
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.titleblock import Strip, Table
from graphkin.sheet.window import Entry, Extent, Figure, Window
from graphkin.studies.linkages import FAMILY, Linkage, Report, report
from graphkin.studies.linkages.assembled import posed
from graphkin.studies.linkages.linkage import LinkagePosition

_ON_A4 = 2  # so many linkages are drawn on A4
_HEAD = 10.0  # room for the title of the family [mm]


def limit_sheet(reports: Sequence[Report], lang: Lang = "en", *, paper: str | None = None, title: str = "") -> Sheet:
    """The sheet of the linkages of a mechanism, or of one by itself: a row of figures each, at one scale; on A4 on its
    side where no paper is given, A3 for three linkages and more; title: the kind of the first where left out. Raises
    UnknownPaper."""
    chosen = papers_for(paper or ("A4-landscape" if len(reports) <= _ON_A4 else "A3-landscape"))[0]
    several = len(reports) > 1
    tables = [found_sizes(one, "".join(one.linkage.names) if several else "") for one in reports]
    _, panels = gridded([_pictures(one, lang, several) for one in reports], chosen, Strip(tables))
    machine = titled(reports[0].linkage, title or capitalized(kind_name(reports[0], lang)))
    return Page(chosen, panels, machine, None, lang, Strip(tables)).sheet()


def family_sheet(lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Every kind of the family once: a sketch at a scale of its own, with its name. Raises UnknownPaper."""
    chosen, pictures = papers_for(paper or "A4-landscape")[0], list[Picture]()
    for linkage in (member.linkage for member in FAMILY):
        draw = partial(drawn_over, linkage, [linkage.drawn])
        pictures.append(_picture([linkage.drawn], draw, kind_name(report(linkage), lang)))
    _, panels = gridded([[picture] for picture in pictures], chosen, Strip(), _HEAD)
    title, room, size = say("linkages.sheet family", lang), chosen.frame, lettering.TITLE
    left = room.middle.real - lettering.width(plain(title), size) / 2
    head = Text(plain(title), complex(left, room.top + 7.0), size)
    machine = replace(titled(FAMILY[0].linkage), name="linkages", file="linkages.toml", text="")
    bare = [replace(panel, plane=None, before=(*panel.before, *[head][k:])) for k, panel in enumerate(panels)]
    return Page(chosen, bare, machine, None, lang, Strip(), title).sheet()


def _pictures(one: Report, lang: Lang, several: bool) -> list[Picture]:
    """Limits and transmission angles; with `several`, captions have the letters of the linkage and its own scale."""
    start = f"{''.join(one.linkage.names)}: " if several else ""
    pictures = [_limits(one, lang, start)] if one.limits else []
    if one.critical and one.gamma_min is not None and not one.level:
        pictures.append(_transmission(one, lang, start))
    ends = one.critical[:2]
    pictures = pictures or [_picture(ends, partial(drawn_over, one.linkage, ends), start + kind_name(one, lang))]
    return [replace(each, texts=(*each.texts, SCALE)) for each in pictures] if several else pictures


def _limits(one: Report, lang: Lang, start: str) -> Picture:
    def draw(window: Window) -> Figure:
        return Figure.of(_limit_angles(one, window)) + drawn_over(one.linkage, one.limits, window, around=one.critical)

    head, *more = limit_caption(one, lang)
    return _picture(one.limits, draw, start + head, *more, ground=one.guided)


def _transmission(one: Report, lang: Lang, start: str) -> Picture:
    """The position of the least transmission angle, and one to compare it with; first one that is not folded flat."""
    others = [end for end in one.critical if end is not one.least[0]]
    shown = sorted((one.least[0], *others[:1]), key=lambda end: end.is_flat)
    shown = [one.linkage.drawn, shown[0]] if shown[0].is_flat else shown

    def draw(window: Window) -> Figure:
        linkage = drawn_over(one.linkage, shown, window, True, (*one.limits, *one.critical))
        return Figure.of(_transmission_angles(one, shown, window)) + linkage

    head, *more = transmission_caption(one, lang)
    return _picture(shown, draw, start + head, *more, ground=one.guided)


def found_sizes(one: Report, name: str = "", swing: str = "ψ") -> Table:
    """Its lengths, and what is found of it; among several after its name. swing: what its output's range is called."""
    turn, psi, theta, high, k = math.degrees(1), *(plain(letter, True) for letter in (swing, *"θHK"))
    least, most = quantity_label("γ", "min"), quantity_label("α", "max")
    sizes: list[tuple[Label, float | None, float, str]] = []
    sizes += [(points_label(link), size, 1e3, " mm") for link, size in one.linkage.sizes.items()]
    sizes += [(psi, one.swing, turn, "°"), (high, one.stroke, 1e3, " mm"), (theta, one.theta, turn, "°"),
              (k, one.k, 1.0, ""), (least, one.gamma_min, turn, "°"), (most, one.alpha_max, turn, "°")]  # fmt: skip
    columns: list[tuple[Label, Label]] = [((), points_label(name))] if name else []
    columns += [(letter, (*number(s * factor), *plain(unit))) for letter, s, factor, unit in sizes if s is not None]
    heads, values = zip(*columns, strict=True)
    return Table(heads, (values,))


Row = Sequence[LinkagePosition]  # positions drawn over each other

_SHORT = 8.0  # a shorter bar bears no letters of its own [mm]
_STROKE_OFF = 15.0  # how far from the guide the stroke's dimension line lies [mm]
_BESIDE_HINGE, _BESIDE_BLOCK = (0.42, 11.0, 30.0), (0.3, 14.0, 34.0)
"""Radius of psi: share of the output's arm, least and most [mm]; beside a block it needs more room."""
_SEEN = 0.05  # an arm that leaves its link's line by more does not show its direction [mm]
_PAST_BLOCK = 6.5  # side of the square in a right angle where it is to be seen beside a block [mm]


def _picture(positions: Row, draw: Callable[[Window], Figure], *texts: str, ground: Sequence[complex] = ()) -> Picture:
    places = [*ground, *(place for position in positions for place in position.places)]
    return Picture(Extent.of(places, draw), draw, texts)


def on_paper(position: LinkagePosition, window: Window) -> list[Place]:
    """The points of a linkage on paper [mm]."""
    return [window(place) for place in position.places]


def drawn_over(linkage: Linkage, positions: Row, window: Window, primes: bool = False, around: Row = ()) -> Figure:
    """Ground, thin positions, the thick one; moving points by numbers or primes; around: those of other figures."""
    machine = linkage.mechanism()
    first, *others = (Skeleton(machine, posed(linkage, machine, position), window, {}) for position in positions)
    elsewhere = [Skeleton(machine, posed(linkage, machine, position), window, {}) for position in around]
    marks = list(grounds(first, *others, *elsewhere).marks)
    for skeleton in reversed(others):
        for mark in _links(linkage, skeleton):
            marks.append(replace(mark, pen="thin") if isinstance(mark, Stroke | Disc) else mark)
    labels = [*_names(linkage, positions, first, primes)]
    named = [*zip(linkage.names, on_paper(positions[0], window), strict=True)]
    for (one, start), (other, end) in combinations(named, 2):  # links by their ends, as their lengths are called
        name = next((name for name in (one + other, other + one) if name in linkage.sizes), "")
        if name and abs(end - start) > _SHORT:
            if all(FRAME in machine.owners[pivot] for pivot in (one, other)):  # where no bar is
                marks.insert(0, Stroke((start, end), "construction"))
            labels.append(LabelRequest(points_label(name), start, end, gap=1.2, size=LABEL, spare=True))
    for pair in machine.slides if linkage.sizes.get("e") else ():  # from a pivot square to the line of the guide
        owned = linkage.names if pair.guide == FRAME else machine.links[pair.guide].points
        pivot, on = (dict(named)[name] for name in (next(p for p in linkage.names if p in owned), pair.point))
        along = window.turned(cmath.rect(1, positions[0].turn))
        foot = on + along * ((pivot - on) / along).real
        marks.insert(0, Stroke((pivot, foot), "construction"))
        labels.append(LabelRequest(plain("e", italic=True), pivot, foot, gap=1.2, size=LABEL))
    return Figure([*marks, *_links(linkage, first)], labels)


def _links(linkage: Linkage, skeleton: Skeleton) -> Iterator[Mark]:
    """Hinges as plain circles, for such a figure is looked at, not measured; points without a letter are not shown."""
    for mark in moving_links(skeleton):
        if not isinstance(mark, PointMark):
            yield mark
        elif mark.name in linkage.names:
            yield Disc(mark.at, mark.radius, "outline", mark.fill)


def _names(linkage: Linkage, positions: Row, first: Skeleton, primes: bool) -> Iterator[LabelRequest]:
    """Pivots once, moving points at every position."""
    places = [place for position in positions for place in position.places]
    window, centre = first.window, sum(places) / len(places)
    for k, name in enumerate(linkage.names):
        fixed = FRAME in first.mechanism.owners[name]
        for count, position in enumerate(positions[:1] if fixed else positions, start=1):
            at, label = window(position.places[k]), point_label(name)
            if primes and not fixed and len(positions) > 1:
                label = (*label, Run("′" * count))
            elif not fixed and len(positions) > 1:  # after a comma where the name has a subscript of its own
                comma = "," if any(run.place == "sub" for run in label) else ""
                label = (*label, Run(f"{comma}{count}", False, "sub"))
            yield LabelRequest(label, at, gap=symbols.HINGE + 0.4, away=at - window(centre))


def _limit_angles(report: Report, window: Window) -> Iterator[Entry]:
    """psi or H between the limits, theta at the crank's pivot, and right angles."""
    yield from _theta(report, window)
    for end in report.limits:
        if end.how == "across":  # a crank at right angles to a bar that slides over its pin
            first, pin, last = on_paper(end, window)[:3]
            yield from symbols.right_angle(pin, first - pin, last - pin, _PAST_BLOCK)
    if report.swing is not None:
        yield from _psi(report, window)
    elif report.stroke is not None:
        yield from _stroke(report, report.stroke, window)


def _psi(report: Report, window: Window) -> Iterator[Entry]:
    """At the output's pivot, over its range."""
    pivot, tip = report.linkage.arm
    first = on_paper(report.limits[0], window)
    at, span = first[pivot], report.output_range
    share, least, most = _BESIDE_BLOCK if report.slide else _BESIDE_HINGE
    radius = min(max(share * abs(first[tip] - at), least), most)
    label = valued(plain("ψ", True), math.degrees(span.width), "°")
    yield from angle(at, cmath.rect(1, -span.low), -span.width, radius, label)
    for end in report.limits:
        along = window.turned(cmath.rect(1, end.output))
        arm = on_paper(end, window)[tip] - at
        if abs((along.conjugate() * arm).imag) > _SEEN:
            yield Stroke((at, at + along * (radius + 3)), "construction")


def _theta(report: Report, window: Window) -> Iterator[Entry]:
    """Between the crank at the first limit and the crank at the second, carried on beyond its pivot."""
    if report.theta is None or report.timed_by:
        return
    order = -1 if report.linkage.driver == "rocker" else 1
    first, second = (on_paper(end, window)[::order] for end in report.limits)
    at, start, end = first[0], first[1] - first[0], second[0] - second[1]
    radius = max(abs(start) + 7.0, 13.0)
    if report.limits[0].how == "across" and report.theta > 1e-6:
        yield Stroke((at, at + end / abs(end) * (radius + 3)), "construction")
        yield Stroke((first[1], at + start / abs(start) * (radius + 3)), "construction")
    label = valued(plain("θ", True), math.degrees(report.theta), "°")
    yield from angle(at, start, cmath.phase(end / start), radius, label)


def _stroke(report: Report, length: float, window: Window) -> Iterator[Entry]:
    """A dimension line beside the guide, on the side of the ground."""
    along = window.turned(cmath.rect(1, report.limits[0].turn))
    places = [on_paper(end, window) for end in report.limits]
    one, other = (there[-1] for there in places)
    side = away_from(one, along, [place for there in places for place in there])
    level = (one / side).real + _STROKE_OFF
    line, extensions, heads = symbols.dimension_line((one, other), side, level, clear=(4.5, 4.5))
    yield from (line, *extensions, *heads)
    label = valued(plain("H", True), length * 1e3, " mm")
    yield LabelRequest(label, line.places[0], line.places[1], gap=0.4, away=side, size=LABEL)


def _transmission_angles(report: Report, positions: Row, window: Window) -> Iterator[Entry]:
    """gamma at each position; for a slider the pressure angle alpha, which is seen against the guide."""
    for count, end in enumerate(positions, start=1):
        seen, gamma = report.linkage.seen(end), end.gamma or 0.0
        if not abs(seen.one) * abs(seen.other):  # points on one another
            continue
        radius, letter = (8.0 + 8.0 * count, "α") if seen.pressure else (15.0, "γ")
        value, name = math.pi / 2 - gamma if seen.pressure else gamma, (Run(letter, True), Run("′" * count))
        label = valued(name, math.degrees(value), "°")
        at, one, other = window(seen.at), window.turned(seen.one), window.turned(seen.other)
        one = -one if (one.conjugate() * other).real < 0 else one  # the acute angle; what no link shows is drawn on
        yield from (Stroke((at, at + side / abs(side) * (radius + 3)), "construction") for side in (one, other))
        yield from symbols.right_angle(at, one, other)
        yield from angle(at, one, cmath.phase(other / one), radius, label)
