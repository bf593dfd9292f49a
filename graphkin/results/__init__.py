"""All results of a mechanism as plain data: what `solve --json` prints. SI units, radians, vectors as [x, y]."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from graphkin.base import geometry
from graphkin.base.geometry import Value, dot
from graphkin.base.plain import Plain
from graphkin.construction import Plot, Site
from graphkin.errors import Lang
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import ROUNDING, Mechanism
from graphkin.model.naming import Seen
from graphkin.model.quantities import Centre, read
from graphkin.model.quantities.kinds import relative
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.proof.roads import Proved, proved
from graphkin.running import driver_values
from graphkin.studies.centres import centres, place

__all__ = ["results"]

Json = Mapping[str, Plain]


def results(
    mechanism: Mechanism, method: Method, lang: Lang = "en", values: Sequence[float] | None = None
) -> Json:
    """One object for one mechanism, an entry in `positions` for the drawn one and for each of `also`, or one alone for
    other driver values [rad, m]."""
    first, *others = driver_values(method) if values is None else [tuple(values)]
    found = proved(method, values)
    return {
        "format": 1,
        "name": mechanism.name,
        "title": mechanism.headline(lang),
        "positions": [
            _position(mechanism, method, first, found),
            *(_position(mechanism, method, each, proved(method, each)) for each in others),
        ],
    }


def _position(mechanism: Mechanism, method: Method, values: tuple[float, ...], found: Proved) -> Json:
    plot, seen = found.plot, readings(method, found.plot)
    return {
        "drivers": list(values),
        **_motions(mechanism, seen),
        "coincident": dict(_coincident(method, seen)),
        "ask": {question: _answer(method, plot, seen, question) for question in mechanism.ask},
        "analytic": _motions(mechanism, found.exact),
        "worst": found.worst,
    }


def _motions(mechanism: Mechanism, motions: Motions) -> Json:
    """Links, points and slides, by either road."""
    cut = mechanism.usual.cut
    return {
        "links": {
            link: {
                "theta": _direction(motions.theta[link]),
                "omega": _number(cut(motions.omega[link], "rad/s")),
                "alpha": _number(cut(motions.alpha[link], "rad/s^2")),
            }
            for link in mechanism.moving
            if link in motions.theta
        },
        "points": {point: _point(mechanism, motions, point) for point in mechanism.points},
        "slides": {
            name: {
                "s": _number(cut(motions.s[name], "m")),
                "v": _number(cut(motions.s_rate[name], "m/s")),
                "a": _number(cut(motions.s_acceleration[name], "m/s^2")),
            }
            for name in [pair.name for pair in mechanism.pairs if pair.path is not None]
            if name in motions.s_acceleration
        },
    }


def _point(mechanism: Mechanism, motions: Motions, point: str) -> Json:
    link, cut = mechanism.owners[point][0], mechanism.usual.cut
    return {
        "r": _vector(cut(motions.position[point], "m")),
        "v": _vector(cut(motions.velocity_at(point, link), "m/s")),
        "a": _vector(cut(motions.acceleration_at(point, link), "m/s^2")),
    }


def _coincident(method: Method, drawn: Motions) -> Iterator[tuple[str, Json]]:
    """Each pair of coincident points of the polygons, seen either way round."""
    sites, points = method.sites, set(method.mechanism.points)
    of_point: dict[str, list[str]] = {}
    for label, site in sites.items():
        of_point.setdefault(site.point, []).append(label)
    for label in sites:
        point = sites[label].point
        for other in of_point[point] if point in points else ():
            if other == label:
                continue
            of, seen_from = _home(method, sites[label]), _home(method, sites[other])
            comma = "," if "@" in label + other else ""
            cut = method.mechanism.usual.cut
            yield f"{label}{comma}{other}", {
                "v": _vector(cut(relative(drawn, "velocity", "", of, seen_from), "m/s")),
                "a_k": _vector(cut(relative(drawn, "acceleration", "k", of, seen_from), "m/s^2")),
                "a_r": _vector(cut(relative(drawn, "acceleration", "r", of, seen_from), "m/s^2")),
            }


def _home(method: Method, site: Site) -> Seen:
    """A site on the link that people name for it."""
    owned = site.link in method.mechanism.owners[site.point]
    link = method.coincident.get(site.point, site.link) if owned else method.structure.home(site.link)
    return Seen(site.point, link, True)


def _answer(method: Method, plot: Plot, motions: Motions, question: str) -> Json:
    quantity = read(method.mechanism, question)
    if isinstance(quantity, Centre):
        entry = place(centres(method, plot), *quantity.links)
        return {"value": None, "unit": "m"} | {key: entry[key] for key in ("at", "direction") if key in entry}
    found = None if quantity is None else quantity.shown(motions)
    if quantity is not None and quantity.is_place and found is not None and found.vector is not None:
        return {"value": None, "unit": "m", "at": _vector(found.vector)}
    if found is None or not math.isfinite(_number(found.value)):
        return {"value": None, "unit": None if found is None else found.unit}
    vector = {} if found.vector is None else {"vector": _vector(found.vector)}
    if quantity is not None and quantity.along is not None and found.vector is not None:  # signed, as in tables
        signed = {"value": _number(dot(quantity.along, found.vector)), "size": _number(found.value)}
        return {**signed, "unit": found.unit, **vector}
    return {"value": _number(found.value), "unit": found.unit, **vector}


def _number(value: Value) -> float:
    return geometry.number(value) + 0.0


def _direction(value: Value) -> float:
    """An angle from 0 up to a turn; 0 or a turn but for rounding is 0 [rad]."""
    angle = geometry.number(value) % math.tau
    return 0.0 if min(angle, math.tau - angle) <= ROUNDING else angle


def _vector(value: Value) -> list[float]:
    vector = geometry.place(value)
    return [vector.real + 0.0, vector.imag + 0.0]


