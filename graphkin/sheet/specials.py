"""Points the construction adds to the mechanism: special points with the lines that meet there, and contacts."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping

from graphkin.base.value import frozen
from graphkin.construction import Along, Arc, Direction, Meet, Plot, Ray, Site, Touch
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.step_numbers import pages
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import plain, point_label
from graphkin.sheet.marks import Mark, Place, PointMark, Stroke
from graphkin.sheet.polygons import named_site
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import arrow_head
from graphkin.sheet.window import Figure

_BEYOND = 6.0
"""How far a leg's line goes on past the special point [mm]."""
_CUT = 34.0
"""How much is drawn of a line to a special point off the paper [mm]."""
_FAR = 1.9
"""So many times larger the mechanism may become for a special point's sake."""


@frozen
class _Special:
    """A special point: its letter, its site as written (`S4`) and as `S@4`, and the two lines."""

    name: str
    of: str
    site: str
    rays: tuple[Ray, Ray]
    step: int


def _found(method: Method) -> Iterator[_Special]:
    sites = {node.site: node.of for node in method.velocity.nodes.values() if node.site is not None}
    page = pages(method)
    for step in method.position.steps:
        if not isinstance(step, Meet) or step.point not in method.special:
            continue
        node = method.position.nodes[step.point]
        if isinstance(step.first, Arc) or isinstance(step.second, Arc):
            continue
        of = sites.get(node.site, node.of) if node.site is not None else node.of
        site = named_site(node.site) if node.site is not None else ""
        yield _Special(step.point, of, site, (step.first, step.second), page["position", step])


def named_specials(method: Method, plot: Plot, others: list[complex]) -> Mapping[str, complex]:
    """Special points that lie near enough to the mechanism to be drawn [m]."""
    xs, ys = [z.real for z in others], [z.imag for z in others]
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    found: dict[str, complex] = {}
    for special in _found(method):
        at = complex(plot.position[special.name])
        wide = max(*xs, at.real) - min(*xs, at.real)
        high = max(*ys, at.imag) - min(*ys, at.imag)
        if max(wide, high) <= _FAR * size:
            found[special.name] = at
    return found


def specials(method: Method, skeleton: Skeleton, drawn: list[complex]) -> Figure:
    """The legs' lines, thin, to where they meet; towards it only where it is not among the places drawn [m]."""
    figure = Figure()
    for special in _found(method):
        at = skeleton.at(special.name)
        if not cmath.isfinite(at):  # the legs are parallel: neither points anywhere
            continue
        if complex(skeleton.plot.position[special.name]) in drawn:
            for ray in special.rays:
                figure.marks += _line(skeleton, ray, at, special.step)
            dot = PointMark("position", special.name, special.of, at, 0.6, step=special.step, site=special.site)
            figure.marks.append(dot)
            figure.wanted.append(LabelRequest(point_label(special.name), at, gap=0.8, step=special.step))
        else:
            for ray in special.rays:
                towards = _towards(skeleton, ray, at, special.step)
                figure.marks += towards
                label = (*plain("→ "), *point_label(special.name))
                tips = [mark.places[-1] for mark in towards if isinstance(mark, Stroke)]
                figure.wanted += [LabelRequest(label, tip, gap=0.6, step=special.step) for tip in tips]
    return figure


def _line(skeleton: Skeleton, ray: Ray, at: Place, step: int) -> list[Mark]:
    """From the leg's far end through the special point."""
    start = _start(skeleton, ray.through, ray.direction, at)
    way = at - start
    if abs(way) < 0.5:
        return []
    return [Stroke((start, at + way / abs(way) * _BEYOND), "thin", step=step)]


def _start(skeleton: Skeleton, through: str, direction: Direction, at: Place) -> Place:
    """Of a bar, the end farther from the special point."""
    ends = [through]
    if isinstance(direction, Along):
        ends += [direction.tail, direction.head]
    return max((skeleton.at(end) for end in ends), key=lambda place: abs(place - at))


def _towards(skeleton: Skeleton, ray: Ray, at: Place, step: int) -> list[Mark]:
    """From the leg's near end a little way, with an arrow; nothing where that is the special point itself."""
    ends = [ray.through]
    if isinstance(ray.direction, Along):
        ends += [ray.direction.tail, ray.direction.head]
    start = min((skeleton.at(end) for end in ends), key=lambda place: abs(place - at))
    if at == start:
        return []
    way = (at - start) / abs(at - start)
    return [Stroke((start, start + way * _CUT), "thin", step=step), arrow_head(start + way * _CUT, way, step)]


def contacts(method: Method, skeleton: Skeleton) -> Figure:
    """Where wheels touch, as small points with their letters."""
    figure = Figure()
    page = pages(method)
    for step in method.position.steps:
        if isinstance(step, Touch):
            at, number = skeleton.at(step.point), page["position", step]
            site = named_site(Site(step.point, FRAME))
            figure.marks.append(PointMark("position", step.point, step.point, at, 0.6, step=number, site=site))
            figure.wanted.append(LabelRequest(point_label(step.point), at, gap=0.8, away=1 - 1j, step=number))
    return figure
