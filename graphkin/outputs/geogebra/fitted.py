"""Links that are tried until they fit, as objects of GeoGebra: a list of where they lie nearly, then Newton's steps.

The list is read off the whole motion, position by position, so that every group stays on its own side; the steps find
the place itself, from what the construction has by then. Past a dead point the list ends, and nothing is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Arm, Closure, Fit, slide_key
from graphkin.outputs.geogebra.formulas import FormulaPair, between, known, value
from graphkin.outputs.geogebra.protocol import Protocol
from graphkin.outputs.geogebra.state import GeogebraState
from graphkin.planning import Method
from graphkin.running.path import along, turned
from graphkin.studies.sweeps import course

ROUNDS = 4
"""Steps of Newton's, from a place between two of the list: each doubles the digits that are right."""
_APART_DEG, _PARTS = 1.0, 360
"""How far the places of the list are apart: an angle of the driver's, or a part of a slide's way."""
_SHORT = 1e-6
"""How near to a dead point the list goes [of the way]."""

Row = tuple[str, Mapping[str, str]]
"""known + sum of coefficient * unknown = 0, as formulas."""


@frozen
class Nearly:
    """Where the fitted links lie nearly, by the driver's value.

    at     how many places of the list the driver has gone, and the part of the next (labels of two numbers)
    lists  labels, by what is fitted
    """

    protocol: Protocol
    at: tuple[str, str]
    lists: Mapping[str, str]

    @classmethod
    def of(cls, method: Method, protocol: Protocol, driven: str) -> Nearly:
        """The lists over the whole motion; driven: the label of the driver's value [rad, m]."""
        path = course(method).path
        short = _SHORT * (path.last - path.first)
        low, high = path.first + short, path.last - short
        apart = math.radians(_APART_DEG) if method.drivers[0].kind != "slide" else (high - low) / _PARTS
        t = np.linspace(low, high, 1 + math.ceil((high - low) / apart))
        start = path.start[0] + low
        if path.stops and method.drivers[0].kind != "slide" and not method.structure.contacts:
            middle = value(path.start[0] + (low + high) / 2)  # whole turns away the mechanism stands alike
            driven = protocol.number(f"{driven} - 2 * pi * round(({driven} - {middle}) / (2 * pi))")
        gone = protocol.number(f"({driven} - {value(start)}) / {value(float(t[1] - t[0]))} + 1")
        whole = protocol.number(f"floor({gone})")
        found = turned(method, along(method, path, t))
        names = {name for step in method.position.steps if isinstance(step, Fit) for name in unknowns_of(step)}
        lists = {name: protocol.list_of(np.broadcast_to(found[name], t.shape)) for name in sorted(names)}
        return cls(protocol, (whole, protocol.number(f"{gone} - {whole}")), lists)

    def value(self, name: str) -> str:
        """Between two places of the list."""
        (whole, part), places = self.at, self.lists[name]
        one, next_ = f"Element[{places}, {whole}]", f"Element[{places}, {whole} + 1]"
        return self.protocol.number(f"{one} + {part} * ({next_} - {one})")


def unknowns_of(step: Fit) -> tuple[str, ...]:
    return (*step.angles, *map(slide_key, step.slides))


def settle(step: Fit, state: GeogebraState, trial: Mapping[str, str]) -> None:
    """Take the links as they lie at a trial, by label."""
    for base in step.angles:
        state.settle(0, base, trial[base], counted=True)
    for slide in step.slides:
        state.displace(0, slide, trial[slide_key(slide)])


def closure_rows(closure: Closure, state: GeogebraState) -> Iterator[Row]:
    """What is left open of a way round, along x and along y, and what each unknown does to it [m]."""
    points = state.points["position"]
    gap = known(0j)
    if not closure.floats:
        gap = between(points[closure.end], points[closure.start]).times(value(state.scales["position"]))
    slopes: dict[str, FormulaPair] = {}
    for part in closure.parts:
        if isinstance(part, Arm):
            shape, link = state.facts.shapes[part.link], part.link
            arrow = known(shape[part.head] - shape[part.tail]).by(state.direction_of(link))
        else:
            link = state.facts.lines[part.slide][0]
            way = state.guide(part.slide).times(str(part.sign))
            arrow = way.times(state.slides[0][part.slide])
            slopes[slide_key(part.slide)] = state.bound(way)
        arrow, base = state.bound(arrow), state.facts.turns[link].base
        gap += arrow
        slopes[base] = slopes[base] + arrow.turned if base in slopes else arrow.turned
    yield gap.x, {name: slope.x for name, slope in slopes.items()}
    yield gap.y, {name: slope.y for name, slope in slopes.items()}
