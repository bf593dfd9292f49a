"""GeoGebra files, reckoned through by a reader of their own at several places of a turn."""

from __future__ import annotations

import io
import math
import os
import re
import shutil
import subprocess
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from geogebra import Reckoned

import graphkin
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.outputs.geogebra import ggb
from graphkin.outputs.typesetting import ggb_text
from graphkin.running import replay_all
from graphkin.sheet import scales_of
from graphkin.sheet.lettering import point_label

PLACES = 4
OPENED = PLACES if "GRAPHKIN_RANDOM" in os.environ else 2
"""So many of them the program itself is started at, a second and a half each."""


def _values(drawn: list[float], kinds: list[str], k: int) -> list[float]:
    return [v + (k * math.tau / PLACES if kind != "slide" else 0.001 * k) for v, kind in zip(drawn, kinds, strict=True)]


@pytest.mark.many
@pytest.mark.parametrize("name", [*library.names()[::6], "ex3-2", "ex3-3"])
def test_every_point_moves_with_the_slider(name: str):
    drawing = graphkin.Drawing.of(graphkin.load(name))
    method, scales = drawing.method, scales_of(drawing.method, drawing.plot)
    content = ggb(method, drawing.plot, scales, "en")
    assert content == ggb(method, drawing.plot, scales, "en")
    kinds = [driver.kind for driver in method.drivers]
    drawn = [float(value) for value in method.facts().values]
    sliders = Reckoned(content).sliders
    seen = 0
    for k in range(0, PLACES, 4 if method.fits else 1):
        values = _values(drawn, kinds, k)
        shown = [v * 1000 if kind == "slide" else math.degrees(v) for v, kind in zip(values, kinds, strict=True)]
        try:
            plot = replay_all(method, values)
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
    caption = ggb_text(point_label(point))
    return [label for label, text in found.captions.items() if text == caption]


def test_fitted_links_stay_on_their_side_up_to_a_dead_point():
    """A degree short of it they are where the drawing has them; past it there is nothing."""
    drawing = graphkin.Drawing.of(graphkin.load("ex3-2"))
    scales = scales_of(drawing.method, drawing.plot)
    content = ggb(drawing.method, drawing.plot, scales, "en")
    (slider,) = Reckoned(content).sliders
    for degrees, there in ((156.8, True), (165.0, False)):
        found = Reckoned(content, {slider: degrees})
        place = found.point("E") * scales["position"]
        assert np.isfinite(place) == there
        if there:
            assert abs(place - replay_all(drawing.method, [math.radians(degrees)]).position["E"]) < 1e-9


@pytest.mark.skipif(shutil.which("geogebra") is None or shutil.which("xvfb-run") is None, reason="no GeoGebra here")
def test_the_real_program_turns_the_crank(tmp_path: Path):
    """GeoGebra opens the file with its slider at several places and nothing else known; it says what it makes of it."""
    drawing = graphkin.Drawing.of(graphkin.load("ex3-5"))
    method, scales = drawing.method, scales_of(drawing.method, drawing.plot)
    content = ggb(method, drawing.plot, scales, "en")
    drawn = float(method.facts().values[0])
    with ThreadPoolExecutor(2) as both:
        places = [drawn + k * math.tau / PLACES for k in range(1, OPENED + 1)]
        told = list(both.map(lambda k: _told(content, math.degrees(places[k]), tmp_path / str(k)), range(OPENED)))
    for place, said in zip(places, told, strict=True):
        plot = replay_all(method, [place])
        for plane, label, pole in (("velocity", "c", "p"), ("acceleration", "c'", "p'")):
            there = (_said(said, label) - _said(said, pole)) * scales[plane]
            assert abs(there - plot.points(plane)[label]) < 0.01 * scales[plane]


def _told(content: bytes, degrees: float, folder: Path) -> str:
    """What GeoGebra says of each object, the slider moved and every other place forgotten."""
    folder.mkdir()
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        text = archive.read("geogebra.xml").decode()
    lines = text.splitlines()
    for k, line in enumerate(lines):
        if "<slider" in line:
            lines[k] = re.sub(r'<value val="[^"]*"', f'<value val="{degrees!r}"', line)
        elif "<coords" in line and k and "<expression" in lines[k - 1]:
            lines[k] = re.sub("<coords[^>]*>", "", line)
    with zipfile.ZipFile(folder / "a.ggb", "w") as archive:
        archive.writestr("geogebra.xml", "\n".join(lines))
    command = ["xvfb-run", "-a", "geogebra", f"--regressionFile={folder / 'a.txt'}", str(folder / "a.ggb")]
    subprocess.run(command, check=True, capture_output=True, timeout=120)
    return (folder / "a.txt").read_text(encoding="utf-8")


def _said(told: str, label: str) -> complex:
    """A point's place: the last two numbers of its line, before the 1 that free points end with."""
    line = next(line for line in told.splitlines() if line.startswith(f"Point {label} ="))
    numbers = line.rpartition("= ")[2].split()
    return complex(float(numbers[0]), float(numbers[1]))
