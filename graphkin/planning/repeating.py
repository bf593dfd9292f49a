"""Displacements of sliding pairs that join nothing, as they repeat what other pairs hold: measured like any other."""

from __future__ import annotations

from graphkin.construction import LayOff, Measure, Roll, Simultaneous, Site
from graphkin.model.mechanism import FRAME
from graphkin.planning.images import reach
from graphkin.planning.loop_terms import Slip
from graphkin.planning.polygon import PolygonPlan


def measure_all_slides(polygon: PolygonPlan) -> None:
    """Every sliding pair and every wheel on a line whose motion along it no step has given yet."""
    given = _given(polygon)
    for name in polygon.structure.measured:
        if name not in given:
            _measure(polygon, name)
            given = _given(polygon)


def measure_slide(polygon: PolygonPlan, name: str) -> None:
    """One whose motion no step has given yet."""
    if name not in _given(polygon):
        _measure(polygon, name)


def _measure(polygon: PolygonPlan, name: str) -> None:
    """The point seen from the guide under it; of the acceleration what the Coriolis term leaves."""
    pair, owners = polygon.structure.slides[name], polygon.structure.owners
    of = Site(pair.point, next(body for body in owners[pair.point] if body != pair.guide))
    seen_from = Site(pair.point, pair.guide)
    reach(polygon, of)
    if pair.guide == FRAME:
        polygon.parts.append(Measure(polygon.sliding, name, polygon.pole, polygon.name(of)))
        return
    reach(polygon, seen_from)
    *known, along = polygon.terms(Slip(seen_from, of, False, name))
    polygon.parts += [LayOff(term, term.tail, term.head) for term in known]
    polygon.parts.append(Measure(polygon.sliding, name, along.tail, along.head))


def _given(polygon: PolygonPlan) -> set[str]:
    """The slides whose motion is known: driven, measured or calculated."""
    given = set(polygon.structure.slides_driven)
    for part in polygon.parts:
        if isinstance(part, Measure) and part.quantity == polygon.sliding:
            given.add(part.of)
        elif isinstance(part, Roll):
            given |= {part.slide} - {""}
        elif isinstance(part, Simultaneous):
            given.update(part.slides)
    return given
