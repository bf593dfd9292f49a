"""Points that the construction adds to the mechanism: special points with the lines that meet there, and contacts."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence

from graphkin.base import geometry
from graphkin.base.rooms import corners
from graphkin.construction import Along, Meet, Plot, Ray, Site, Swing, Touch
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.method import pages
from graphkin.proof.readings import readings
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import solution_centres
from graphkin.say.tangents import feet
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import plain, point_label, quantity_label
from graphkin.sheet.marks import Disc, PointMark, Stroke
from graphkin.sheet.polygons import named_site
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import HINGE, THIN_HEAD, arrow_head, right_angle
from graphkin.sheet.window import Entry

_BEYOND = 6.0  # how far a leg's line goes on past the special point [mm]
_CUT = 34.0  # how much is drawn of a line to a special point off the paper [mm]
_AXIS = 9.0  # the length of an axis [mm]
_SHORT = 0.5  # a shorter line, or radius, is not drawn [mm]
_FAR = 1.9  # so many times larger the mechanism may become for a special point's sake


def _special_points(method: Method) -> Iterator[tuple[str, list[Ray], int]]:
    """Each special point, the two lines that meet there, and the step in which they do."""
    page = pages(method)
    for step in method.position.steps:
        if isinstance(step, Meet) and step.point in method.special:
            rays = [line for line in (step.first, step.second) if isinstance(line, Ray)]
            if len(rays) == 2:
                yield step.point, rays, page["position", step]


def named_specials(method: Method, plot: Plot, others: list[complex]) -> Mapping[str, complex]:
    """Special points, asked centres and their origin, where they lie near enough to the mechanism to be drawn [m]."""
    low, high = corners(others)
    size, near = max((high - low).real, (high - low).imag), dict[str, complex]()
    places = {name: geometry.place(plot.position[name]) for name, *_ in _special_points(method)}
    for name, at in {**places, **_asked(method, plot)}.items():
        least, most = corners([low, high, at])
        if max((most - least).real, (most - least).imag) <= _FAR * size:
            near[name] = at
    return near


def _asked(method: Method, plot: Plot) -> dict[str, complex]:
    """Instant centres that a solution finds, and the origin "" where there are such, off the origin [m]."""
    centres = solution_centres(method.mechanism) if plot.omega else []
    motions = readings(method, plot) if centres else None
    every = {centre.text: geometry.place(centre.place(motions)) for centre in centres if motions is not None}
    places = {name: at for name, at in every.items() if cmath.isfinite(at)}
    return {**places, "": 0j} if any(map(abs, places.values())) else places


def drawn_when(method: Method) -> int | None:
    """The act after which asked centres are found: the mechanism is drawn then."""
    return max((act.page for act in method.acts if act.plane == "position"), default=None)


def asked_centres(method: Method, skeleton: Skeleton, drawn: Sequence[complex]) -> Iterator[Entry]:
    """Asked centres, and the axes at the origin in which their places are told; those on a joint by their letters."""
    plot, last = skeleton.plot, drawn_when(method)
    if not isinstance(plot, Plot):
        return  # of a linkage that is only placed nothing is asked
    points = [skeleton.at(point) for point in (*skeleton.points, *method.special) if point in plot.position]
    pivots = [skeleton.at(driver.vector[0]) for driver in method.mechanism.drivers if driver.vector is not None]
    for name, at in ((name, skeleton.window(place)) for name, place in _asked(method, plot).items() if place in drawn):
        if name:
            joint = any(abs(point - at) < HINGE for point in points)
            if not joint:
                yield from (Disc(at, 1.0, "thin", "paper", step=last), Disc(at, 0.4, "thin", "ink", step=last))
            yield LabelRequest(quantity_label("P", name[1:]), at, gap=HINGE, step=last, spare=2 * joint)
        else:
            for letter, way in (("x", 1), ("y", -1j)) if all(abs(at - pivot) > 0.1 for pivot in pivots) else ():
                tip = at + _AXIS * way
                yield from (Stroke((at, tip), "thin"), arrow_head(tip, way, None, THIN_HEAD))
                yield LabelRequest(plain(letter, italic=True), tip, gap=0.3, away=way)


def specials(method: Method, skeleton: Skeleton, drawn: Sequence[complex]) -> Iterator[Entry]:
    """The legs' lines, thin, from their far ends through where they meet; from their near ends towards it only where it
    is not among the places drawn [m]."""
    sites = {node.site: node.of for node in method.velocity.nodes.values() if node.site is not None}
    for name, rays, step in _special_points(method):
        at, shown = skeleton.at(name), geometry.place(skeleton.plot.position[name]) in drawn
        for ray in rays if cmath.isfinite(at) else ():  # else the legs are parallel: neither points anywhere
            way = (ray.direction.tail, ray.direction.head) if isinstance(ray.direction, Along) else ()
            start = sorted(map(skeleton.at, (ray.through, *way)), key=lambda end: abs(end - at))[-1 if shown else 0]
            if abs(at - start) < (_SHORT if shown else 1e-9):  # an end of the leg is the special point itself
                continue
            along = (at - start) / abs(at - start)
            if shown:
                yield Stroke((start, at + along * _BEYOND), "thin", step=step)
                continue
            tip, label = start + along * _CUT, (*plain("→ "), *point_label(name))
            head = arrow_head(tip, along, step)
            yield from (Stroke((start, tip), "thin", step=step), head)
            yield from (LabelRequest(label, end, gap=0.6, step=step) for end in (tip, head.places[-1]))
        if shown:
            node = method.position.nodes[name]
            of, site = (node.of, "") if node.site is None else (sites.get(node.site, node.of), named_site(node.site))
            yield PointMark("position", name, of, at, 0.6, step=step, site=site)
            yield LabelRequest(point_label(name), at, gap=0.8, step=step)


def contacts(method: Method, skeleton: Skeleton) -> Iterator[Entry]:
    """Contacts of wheels, as small points with their letters."""
    page = pages(method)
    for step in method.position.steps:
        if isinstance(step, Touch):
            at, number = skeleton.at(step.point), page["position", step]
            site = named_site(Site(step.point, FRAME))
            yield PointMark("position", step.point, step.point, at, 0.6, step=number, site=site)
            yield LabelRequest(point_label(step.point), at, gap=0.8, away=1 - 1j, step=number)


def touched(method: Method, plot: Plot, skeleton: Skeleton) -> Iterator[Entry]:
    """Where guide lines touch the circles about their pivots, with radius and tangent at a right angle."""
    page, letters = pages(method), feet(Reading(method, plot, {}, "en"))
    for step in method.position.steps:
        if isinstance(step, Swing) and step.slide in letters:
            pivot, through = skeleton.at(step.pivot), skeleton.at(step.through)
            along, number = skeleton.direction(method.structure.slides[step.slide].line), page["position", step]
            foot = through - (along.conjugate() * (through - pivot)).real * along
            if min(abs(foot - pivot), abs(foot - through)) >= _SHORT:
                yield Stroke((pivot, foot, through), "construction", step=number)
                yield from right_angle(foot, pivot - foot, through - foot, step=number)
                yield Disc(foot, 0.6, "thin", "ink", step=number)
                label = point_label(letters[step.slide].replace("′", "'"))
                yield LabelRequest(label, foot, gap=0.8, away=foot - pivot, step=number)
