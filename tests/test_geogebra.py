"""GeoGebra files, reckoned through by a reader of their own at a dozen places of a turn."""

from __future__ import annotations

import math

import numpy as np
import pytest

import graphkin
from graphkin import library
from graphkin.errors import GraphkinError
from graphkin.outputs.geogebra import TriedOut, ggb
from graphkin.outputs.geogebra.file import written
from graphkin.sheet import scales_of
from graphkin.sheet.lettering import point_label
from tests.geogebra import Reckoned

PLACES = 12


def _values(drawn: list[float], kinds: list[str], k: int) -> list[float]:
    return [v + (k * math.tau / PLACES if kind != "slide" else 0.001 * k) for v, kind in zip(drawn, kinds, strict=True)]


@pytest.mark.parametrize("name", library.names())
def test_every_point_moves_with_the_slider(name: str):
    drawing = graphkin.Drawing.of(graphkin.load(name))
    method, scales = drawing.method, scales_of(drawing.method, drawing.plot, "en")
    try:
        content = ggb(method, drawing.plot, scales, "en")
    except TriedOut:
        assert method.fits
        return
    assert content == ggb(method, drawing.plot, scales, "en")
    kinds = [driver.kind for driver in method.drivers]
    drawn = [float(value) for value in method.facts().values]
    sliders = Reckoned(content).sliders
    seen = 0
    for k in range(PLACES):
        values = _values(drawn, kinds, k)
        shown = [v * 1000 if kind == "slide" else math.degrees(v) for v, kind in zip(values, kinds, strict=True)]
        try:
            plot = graphkin.replay(method, values)
        except GraphkinError:  # past a dead point
            continue
        if not np.isfinite([plot.acceleration[name] for name in plot.acceleration]).all():
            continue
        found = Reckoned(content, dict(zip(sliders, shown, strict=True)))
        seen += 1
        for construction in method.constructions:
            plane = construction.plane
            pole = found.values[_labels(found, construction.pole)[0]] if construction.pole else 0j
            for point, value in plot.points(plane).items():
                there = [(found.values[label] - pole) * scales[plane] for label in _labels(found, point)]
                if there:
                    off = min(abs(place - value) for place in there)
                    assert off < 1e-9 * max(1.0, abs(value)), (k, plane, point)
    assert seen


def _labels(found: Reckoned, point: str) -> list[str]:
    caption = written(point_label(point))
    return [label for label, text in found.captions.items() if text == caption]
