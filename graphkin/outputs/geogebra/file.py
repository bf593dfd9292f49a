"""The whole file: sliders, the mechanism, its polygons, what they tell; as the zip that GeoGebra opens."""

from __future__ import annotations

import io
import math
import zipfile
from collections.abc import Iterator, Mapping
from typing import ClassVar

from graphkin.construction import Construction, Fit, Plane, Plot
from graphkin.errors import GraphkinError, Lang
from graphkin.model.mechanism import FRAME, Driver
from graphkin.outputs.geogebra.fitted import Nearly
from graphkin.outputs.geogebra.formulas import grouped
from graphkin.outputs.geogebra.protocol import BLACK, Colour, Protocol
from graphkin.outputs.geogebra.state import Drives, GeogebraState
from graphkin.outputs.geogebra.steps import Draughtsman
from graphkin.planning import Method
from graphkin.sheet.lettering import Label, point_label, vector_label
from graphkin.sheet.paper import LETTERS, UNITS
from graphkin.sheet.polygons import arrows
from graphkin.sheet.skeleton import hull, in_line
from graphkin.sheet.window import PLANES

_COLOURS: Mapping[Plane, Colour] = {"position": BLACK, "velocity": (11, 79, 156), "acceleration": (163, 32, 13)}
_GAP = 30.0
"""Between the figures, in units of the drawing [mm]."""
MARK = b"graphkin sheet"
_MADE = (1980, 1, 1, 0, 0, 0)
"""The date of what is in the zip: always the same, as the bytes are to be."""


class TriedOut(GraphkinError):
    """A mechanism of several drivers whose positions are found by trial: no list tells where its links lie nearly."""

    name: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{name}: its links are fitted by trial and have several drivers, which a GeoGebra construction cannot "
        "follow. Write .svg, .pdf or .dxf instead.",
        "zh": "{name}：该机构的位置需用样板法试凑，且有多个原动件，GeoGebra 作图无法联动。请改用 .svg、.pdf 或 .dxf。",
    }


def ggb(method: Method, plot: Plot, scales: Mapping[Plane, float], lang: Lang) -> bytes:
    """The drawing as a .ggb file; one of its units is a millimetre of the sheet with these scales.

    Raises TriedOut where links are fitted and several drivers move them.
    """
    fitted = any(isinstance(step, Fit) for step in method.position.steps)
    if fitted and len(method.drivers) > 1:
        raise TriedOut(method.mechanism.headline(lang))
    protocol = Protocol()
    origins = _origins(method, plot, scales)
    drives = _drives(method, protocol, _below(method, plot, scales))
    state = GeogebraState(
        protocol, plot.facts, drives, scales, {link: float(angle) for link, angle in plot.theta.items()}
    )
    nearly = Nearly.of(method, protocol, drives.values[0]) if fitted else None
    for construction in method.constructions:
        plane = construction.plane
        captions = dict(_captions(method, construction))
        Draughtsman(construction, plot, state, captions, _COLOURS[plane], origins[plane], nearly).draw()
        if plane == "position":
            _links(method, state, plot)
        else:
            _vectors(method, construction, plot, state)
    _notes(method, plot, state, origins)
    return _zipped(_document(method.mechanism.headline(lang), protocol, origins))


# --- where the figures lie --------------------------------------------------------------------


def _origins(method: Method, plot: Plot, scales: Mapping[Plane, float]) -> dict[Plane, complex]:
    """The mechanism where it is; right of it the velocities, then the accelerations."""
    origins: dict[Plane, complex] = {}
    right, middle = 0.0, 0.0
    for plane in PLANES:
        places = [complex(at) / scales[plane] for at in plot.points(plane).values()]
        least, most = min(at.real for at in places), max(at.real for at in places)
        height = sum((min(at.imag for at in places), max(at.imag for at in places))) / 2
        origins[plane] = 0j if plane == "position" else complex(right + _GAP - least, middle - height)
        middle = height if plane == "position" else middle
        right = origins[plane].real + most
    return origins


def _below(method: Method, plot: Plot, scales: Mapping[Plane, float]) -> complex:
    """Left below the mechanism: where the first slider stands."""
    places = [complex(plot.position[p]) / scales["position"] for p in method.mechanism.points if p in plot.position]
    return complex(min(at.real for at in places), min(at.imag for at in places) - _GAP)


# --- what is driven ---------------------------------------------------------------------------


def _drives(method: Method, protocol: Protocol, at: complex) -> Drives:
    values, rates, accelerations = [], [], []
    for k, driver in enumerate(method.drivers):
        values.append(_value(driver, float(method.facts().values[k]), protocol, at - 12j * k, method.size))
        unit = "m" if driver.kind == "slide" else "rad"
        rates.append(protocol.constant(f"{_rate(driver, 1)} {driver.name}", driver.rate, f"{unit}/s"))
        accelerations.append(protocol.constant(f"{_rate(driver, 2)} {driver.name}", driver.acceleration, f"{unit}/s²"))
    return Drives(tuple(values), tuple(rates), tuple(accelerations))


def _rate(driver: Driver, order: int) -> str:
    return ("v", "a")[order - 1] if driver.kind == "slide" else ("ω", "α")[order - 1]


def _value(driver: Driver, drawn: float, protocol: Protocol, at: complex, size: float) -> str:
    """A slider in degrees or millimetres, and the number in radians or metres that follows it."""
    if driver.kind == "slide":
        shown, reach = drawn * 1000, size * 1000
        slider = protocol.slider(f"{driver.name} [mm]", shown, shown - reach, shown + reach, reach / 200, at)
        return protocol.number(f"{slider} / 1000")
    shown = math.degrees(drawn)
    slider = protocol.slider(f"{driver.name} [°]", shown, shown - 360, shown + 360, 1.0, at)
    return protocol.number(f"{slider} * pi / 180")


# --- what is seen -----------------------------------------------------------------------------


def written(label: Label) -> str:
    """A label as GeoGebra shows it: subscripts as `_{..}`, a part above them by LaTeX."""
    parts = {"base": "{}", "sub": "_{{{}}}", "sup": "^{{{}}}"}
    text = "".join(parts[run.place].format(run.text.replace("′", "'")) for run in label)
    return f"${text}$" if any(run.place == "sup" for run in label) else text


def _captions(method: Method, construction: Construction) -> Iterator[tuple[str, str]]:
    """What each point is called that bears a letter on the sheet."""
    unnamed = method.mechanism.unnamed
    for name, node in construction.nodes.items():
        if node.of and (node.site is None or node.site.point not in unnamed):
            yield name, written(point_label(name))


def _links(method: Method, state: GeogebraState, plot: Plot) -> None:
    """The sides of every moving link between its named points, and the lines of its guides."""
    points, machine = state.points["position"], method.mechanism
    for link in machine.moving:
        names = [name for name in machine.named(link) if name in points]
        places = [complex(plot.position[name]) for name in names]
        for one, other in _sides(places):
            state.protocol.segment(points[names[one]], points[names[other]])
    for slide in machine.slides:
        if slide.line.origin in points:
            direction = state.protocol.direction(state.guide(slide.name).point)
            state.protocol.line(points[slide.line.origin], direction)


def _sides(places: list[complex]) -> list[tuple[int, int]]:
    """A bar's two ends, or the outline of three points and more."""
    if len(places) < 2:
        return []
    if (ends := in_line(places)) is not None:
        return [ends]
    around = hull(places)
    return list(zip(around, (*around[1:], around[0]), strict=True))


def _vectors(method: Method, construction: Construction, plot: Plot, state: GeogebraState) -> None:
    """The arrows of the sheet's polygon."""
    points, plane = state.points[construction.plane], construction.plane
    for arrow in arrows(method.mechanism, construction, plot.points(plane)):
        if points[arrow.tail] != points[arrow.head]:
            caption = written(vector_label(arrow.name))
            state.protocol.vector(caption, points[arrow.tail], points[arrow.head], _COLOURS[plane])


def _notes(method: Method, plot: Plot, state: GeogebraState, origins: Mapping[Plane, complex]) -> None:
    """The scales, and how every link turns, over the polygons."""
    for plane in PLANES:
        top = max(complex(at).imag / state.scales[plane] for at in plot.points(plane).values())
        at = complex(origins[plane].real, origins[plane].imag + top + _GAP / 2)
        scale = f"μ_{LETTERS[plane]} = {state.scales[plane]:.6g} {UNITS[plane]}"
        state.protocol.note(f'"{scale}"', at)
    for order, (letter, unit) in enumerate((("ω", "rad/s"), ("α", "rad/s²")), 1):
        plane = PLANES[order]
        low = min(complex(at).imag / state.scales[plane] for at in plot.points(plane).values())
        at = complex(origins[plane].real, origins[plane].imag + low - _GAP / 2)
        for k, link in enumerate(link for link in method.mechanism.moving if link != FRAME):
            name = method.mechanism.called(link).replace('"', "")
            state.protocol.note(f'"{letter} {name} = " + {grouped(state.turn(link, order))} + " {unit}"', at - 8j * k)


# --- the file ---------------------------------------------------------------------------------


def _document(title: str, protocol: Protocol, origins: Mapping[Plane, complex]) -> str:
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


def _zipped(document: str) -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.comment = MARK
        archive.writestr(zipfile.ZipInfo("geogebra.xml", _MADE), document.encode())
    return held.getvalue()
