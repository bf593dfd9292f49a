"""What a page shows at a position of its drivers, held against the analysis."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import TYPE_CHECKING

from graphkin.analytic import motion
from graphkin.check.expected import point_value, vector_value, widened
from graphkin.model.mechanism import Mechanism
from graphkin.model.quantities import EDGE, driven

if TYPE_CHECKING:
    from playwright.sync_api import Page

_READ = """() => [...document.querySelectorAll('svg.drawing > g[data-plane]')].filter(g => !g.hasAttribute('hidden')).map(g => ({
  plane: g.dataset.plane, scale: Number(g.dataset.scale),
  marks: [...g.querySelectorAll('.vector, .point')].filter(e => getComputedStyle(e).visibility === 'visible').map(e => ({
    data: Object.fromEntries(Object.entries(e.dataset).map(([k, v]) => ['data-' + k.replace(/[A-Z]/g, c => '-' + c.toLowerCase()), v])),
    at: ['x1', 'y1', 'x2', 'y2', 'cx', 'cy'].map(a => e.getAttribute(a)).filter(a => a !== null).map(Number)}))}))"""


def shown(page: Page) -> list[dict]:
    """The planes that are drawn: their scale, and their vectors and points with their data and places."""
    return page.evaluate(_READ)


def fragment(machine: Mechanism, values: tuple[float, ...]) -> str:
    """The hash of a position; values [rad, m]."""
    drivers = zip(machine.drivers, values, strict=True)
    return "#" + "&".join(f"{driver.name}={value * EDGE[driven(driver.kind == 'slide')].factor:.6f}" for driver, value in drivers)


def off(machine: Mechanism, values: tuple[float, ...], planes: list[dict]) -> dict[str, float]:
    """How far each vector and each distance of a point from the plane's first is from the analysis [mm]."""
    points = [(mark["data"], 0j) for plane in planes for mark in plane["marks"] if "data-site" in mark["data"]]
    exact = widened(machine, motion(machine, values), SimpleNamespace(points=points))
    worst: dict[str, float] = {}
    for plane in planes:
        first = None
        for mark in plane["marks"]:
            data, at = mark["data"], [complex(x, -y) for x, y in zip(mark["at"][::2], mark["at"][1::2], strict=True)]
            name = f"{plane['plane']} {data['data-name']}"
            if len(at) == 2 and (right := vector_value(exact, plane["plane"], data)) is not None:
                worst[name] = abs(at[1] - at[0] - right / plane["scale"])
            if len(at) == 1 and (right := point_value(machine, exact, plane["plane"], data)) is not None:
                base, first = (first or (at[0], right)), first or (at[0], right)
                worst[name] = abs(at[0] - base[0] - (right - base[1]) / plane["scale"])
    assert all(math.isfinite(each) for each in worst.values()), worst
    return worst
