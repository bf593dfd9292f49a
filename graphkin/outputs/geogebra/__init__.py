"""A drawing as a GeoGebra file whose objects hang on one another: drag the crank, and the polygons move.

Sliders, the mechanism, its polygons, and what they say, as the zip that GeoGebra opens. `steps` draws a construction;
`state` holds all that it has found, as formulas; `protocol` writes the objects down.
"""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Mapping
from itertools import pairwise

from graphkin.base.geometry import number, place
from graphkin.base.lines import lines_through
from graphkin.construction import Fit, Plane, Plot
from graphkin.errors import GraphkinError, Lang
from graphkin.model.mechanism import FRAME
from graphkin.outputs.geogebra.protocol import BLACK, Colour, Protocol, grouped
from graphkin.outputs.geogebra.state import Drives, GeogebraState
from graphkin.outputs.geogebra.steps import Draughtsman, Nearly
from graphkin.outputs.typesetting import ggb_text
from graphkin.planning import Method
from graphkin.planning.polygon_arrows import arrows
from graphkin.sheet.lettering import point_label, vector_label
from graphkin.sheet.paper import LETTERS, UNITS
from graphkin.sheet.window import PLANES

__all__ = ["TriedOut", "ggb"]

_COLOURS: Mapping[Plane, Colour] = {"position": BLACK, "velocity": (11, 79, 156), "acceleration": (163, 32, 13)}
_GAP = 30.0  # between the figures, in units of the drawing [mm]
MARK = b"graphkin sheet"
_MADE = (1980, 1, 1, 0, 0, 0)  # the date of what is in the zip: always the same, as the bytes are to be


class TriedOut(GraphkinError):
    """A mechanism of several drivers whose positions are found by trial: no list tells where its links lie nearly."""

    name: str
    en = (
        "{name}: its links are fitted by trial and have several drivers, which a GeoGebra construction cannot "
        "follow. Write .svg, .pdf or .dxf instead."
    )
    zh = "{name}：该机构的位置需用样板法试凑，且有多个原动件，GeoGebra 作图无法联动。请改用 .svg、.pdf 或 .dxf。"


def ggb(method: Method, plot: Plot, scales: Mapping[Plane, float], lang: Lang) -> bytes:
    """The drawing as a .ggb file; one of its units is a millimetre of the sheet with these scales. Raises TriedOut
    where links are fitted and several drivers move them."""
    machine = method.mechanism
    fitted = any(isinstance(step, Fit) for step in method.position.steps)
    if fitted and len(method.drivers) > 1:
        raise TriedOut(machine.headline(lang))
    protocol = Protocol()
    origins = _origins(plot, scales)
    drives = _drives(method, plot, protocol, scales)
    near = {link: number(angle) for link, angle in plot.theta.items()}
    state = GeogebraState(protocol, plot.facts, drives, scales, near)
    nearly = Nearly.of(method, protocol, drives[0][0]) if fitted else None
    for construction in method.constructions:
        plane = construction.plane
        captions = {
            name: ggb_text(point_label(name)) for name, node in construction.nodes.items()
            if node.of and (node.site is None or node.site.point not in machine.unnamed)
        }  # fmt: skip
        Draughtsman(construction, plot, state, captions, _COLOURS[plane], origins[plane], nearly).draw()
        if plane == "position":
            _links(method, state, plot)
            continue
        points = state.points[plane]
        for arrow in arrows(machine, construction, plot.points(plane)):
            if points[arrow.tail] != points[arrow.head]:
                caption = ggb_text(vector_label(arrow.name))
                protocol.vector(caption, points[arrow.tail], points[arrow.head], _COLOURS[plane])
    _notes(method, plot, state, origins)
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.comment = MARK
        archive.writestr(zipfile.ZipInfo("geogebra.xml", _MADE), _document(machine.headline(lang), protocol).encode())
    return held.getvalue()


def _origins(plot: Plot, scales: Mapping[Plane, float]) -> dict[Plane, complex]:
    """The mechanism where it is; right of it the velocities, then the accelerations."""
    origins: dict[Plane, complex] = {}
    right, middle = 0.0, 0.0
    for plane in PLANES:
        places = [place(at) / scales[plane] for at in plot.points(plane).values()]
        least, most = min(at.real for at in places), max(at.real for at in places)
        height = sum((min(at.imag for at in places), max(at.imag for at in places))) / 2
        origins[plane] = 0j if plane == "position" else complex(right + _GAP - least, middle - height)
        middle = height if plane == "position" else middle
        right = origins[plane].real + most
    return origins


def _drives(method: Method, plot: Plot, protocol: Protocol, scales: Mapping[Plane, float]) -> Drives:
    """A slider for each driver, left below the mechanism, and its rates."""
    places = [place(plot.position[p]) / scales["position"] for p in method.mechanism.points if p in plot.position]
    at = complex(min(each.real for each in places), min(each.imag for each in places) - _GAP)
    values, rates, accelerations = [], [], []
    for k, driver in enumerate(method.drivers):
        drawn, corner, size = float(method.facts().values[k]), at - 12j * k, method.size
        if driver.kind == "slide":  # moved in millimetres or degrees; what follows counts in metres or radians
            speed, gain, unit, factor = "v", "a", "m", "/ 1000"
            slider = protocol.slider(f"{driver.name} [mm]", drawn * 1000, size * 1000, size * 1000 / 200, corner)
        else:
            speed, gain, unit, factor = "ω", "α", "rad", "* pi / 180"
            slider = protocol.slider(f"{driver.name} [°]", math.degrees(drawn), 360, 1.0, corner)
        values.append(protocol.number(f"{slider} {factor}"))
        rates.append(protocol.constant(f"{speed} {driver.name}", driver.rate, f"{unit}/s"))
        accelerations.append(protocol.constant(f"{gain} {driver.name}", driver.acceleration, f"{unit}/s²"))
    return values, rates, accelerations


def _links(method: Method, state: GeogebraState, plot: Plot) -> None:
    """The sides of every moving link between its named points, and the lines of its guides."""
    points, machine = state.points["position"], method.mechanism
    for link in machine.moving:
        names = [name for name in machine.named(link) if name in points]
        places = [place(plot.position[name]) for name in names]
        if len(places) < 2:
            continue
        for through, closed in lines_through(places):
            for one, other in pairwise((*through, *through[:closed])):
                state.protocol.segment(points[names[one]], points[names[other]])
    for slide in machine.slides:
        if slide.line.origin in points:
            state.protocol.line(points[slide.line.origin], state.protocol.direction(state.guide(slide.name).point))


def _notes(method: Method, plot: Plot, state: GeogebraState, origins: Mapping[Plane, complex]) -> None:
    """The scales, and how every link turns, over the polygons."""
    heights = {plane: [place(at).imag / state.scales[plane] for at in plot.points(plane).values()] for plane in PLANES}
    for plane in PLANES:
        at = complex(origins[plane].real, origins[plane].imag + max(heights[plane]) + _GAP / 2)
        state.protocol.note(f'"μ_{LETTERS[plane]} = {state.scales[plane]:.6g} {UNITS[plane]}"', at)
    for order, (letter, unit) in enumerate((("ω", "rad/s"), ("α", "rad/s²")), 1):
        plane = PLANES[order]
        at = complex(origins[plane].real, origins[plane].imag + min(heights[plane]) - _GAP / 2)
        for k, link in enumerate(link for link in method.mechanism.moving if link != FRAME):
            name = method.mechanism.called(link).replace('"', "")
            state.protocol.note(f'"{letter} {name} = " + {grouped(state.turn(link, order))} + " {unit}"', at - 8j * k)


def _document(title: str, protocol: Protocol) -> str:
    from xml.sax.saxutils import quoteattr

    return (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        '<geogebra format="5.0" version="5.0.0.0" app="classic">\n'
        '<euclidianView><size width="1200" height="700"/><coordSystem xZero="120" yZero="450" scale="3" yscale="3"/>'
        '<evSettings axes="false" grid="false"/></euclidianView>\n'
        '<kernel><continuous val="false"/><decimals val="4"/><angleUnit val="degree"/><coordStyle val="0"/></kernel>\n'
        f'<construction title={quoteattr(title)} author="graphkin" date="">\n{protocol.text()}\n</construction>\n'
        "</geogebra>\n"
    )
