"""A sheet as SVG: one user unit is one millimetre, and a program can measure it.

svgwrite makes the drawing with its arrow heads (`debug=False`: its checker refuses `data-*`); the marks, of which
there are hundreds, are plain elements. Every number is formatted here with four decimals, so the same sheet gives the
same bytes.
"""

from __future__ import annotations

import cmath
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from functools import partial
from itertools import groupby
from typing import Any, assert_never

from graphkin.errors import GraphkinError
from graphkin.outputs.files import NAMESPACE
from graphkin.outputs.paint import Colours, Ink
from graphkin.outputs.stated import kind, stated, statement
from graphkin.outputs.typesetting import LATIN, mm, runs, short
from graphkin.say.catalogue import say
from graphkin.sheet import Sheet
from graphkin.sheet.arrows import TIP, head_size
from graphkin.sheet.marks import ArcMark, Disc, Half, Mark, Place, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.page import Layer
from graphkin.sheet.paper import written

_INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
_CONTROL = "[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]"

Attributes = Mapping[str, str]
Inside = str | Sequence[ET.Element]
Form = tuple[str, dict[str, str], Inside]  # an element's name, attributes, and what is in it: letters or other elements

_NONE: Attributes = {}


class Unwritable(GraphkinError):
    where: str
    code: str
    en = "{where}: the character {code} cannot stand in a drawing. Remove it from the mechanism file."
    zh = "{where}：字符 {code} 不能写入图形文件，请从机构文件中删去。"


def svg(sheet: Sheet, ink: Ink = "accent") -> str:
    """The SVG text of a sheet. Raises Unwritable where the mechanism file holds control characters."""
    _refuse_control(sheet.mechanism.text, sheet.mechanism.file)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + _drawn(sheet, ink, metadata=True) + "\n"


def inline(sheet: Sheet) -> str:
    """The drawing as an element of a page, without what only a file of its own needs."""
    return _drawn(sheet, "accent", metadata=False)


def _drawn(sheet: Sheet, ink: Ink, metadata: bool) -> str:
    _refuse_control(sheet.title, sheet.mechanism.file)
    pen = SvgPen(sheet, ink, metadata)
    for layer in sheet.layers:
        pen.layer(layer)
    return ET.tostring(pen.drawing.get_xml(), encoding="unicode")


def _refuse_control(text: str, where: str) -> None:
    plain = text.replace("\n", "").isprintable()  # so nearly every file is
    if not plain and (control := re.search(_CONTROL, text)) is not None:
        line = text.count("\n", 0, control.start()) + 1
        raise Unwritable(f"{where}:{line}", f"U+{ord(control.group()):04X}")


def _xy(place: Place) -> tuple[str, str]:
    return mm(place.real), mm(place.imag)


class SvgPen:
    """One drawing in the making. Marks of one layer that follow one another in one paint share it in a group."""

    def __init__(self, sheet: Sheet, ink: Ink, metadata: bool, moving: bool = False) -> None:
        import svgwrite

        wide, high = mm(sheet.paper.width), mm(sheet.paper.height)
        self.drawing: Any = svgwrite.Drawing(
            size=(f"{wide}mm", f"{high}mm"), viewBox=f"0 0 {wide} {high}", profile="full", debug=False
        )
        self.sheet, self.colours, self.metadata = sheet, Colours.of(sheet, ink), metadata
        self.heads: set[str] = set()
        self.drawing["xmlns:gk"] = NAMESPACE
        self.drawing["xml:lang"] = sheet.lang
        self.drawing["font-family"] = LATIN
        self.drawing["stroke-linejoin"] = self.drawing["stroke-linecap"] = "round"
        if metadata:
            self.drawing["xmlns:inkscape"] = _INKSCAPE
            self.drawing["role"] = "img"
            figures = []  # the figures on the sheet, at which scales
            for plane, scale in sheet.scales.items():
                name = say(f"sheet.plane {plane}", sheet.lang)
                figures.append(f"{name}, {''.join(run.text for run in written(plane, scale))}")
            self.drawing.set_desc(title=sheet.title, desc="; ".join(figures))
            self.drawing.set_metadata(_element("gk:sheet", _NONE, statement(sheet, moving)))
        else:
            self.drawing.set_desc(title=sheet.title)

    def layer(self, layer: Layer) -> None:
        if not layer.marks:
            return
        parts = []
        for painted, run in groupby(layer.marks, partial(self.colours.paint, layer)):
            paint, marks = dict(painted), [*run]
            parts.append(
                self.element(marks[0], layer, paint) if len(marks) == 1
                else _element("g", paint, [self.element(mark, layer) for mark in marks])
            )  # fmt: skip
        named = {"inkscape:groupmode": "layer", "inkscape:label": layer.name} if self.metadata else {}
        self.drawing.add(Ready(_element("g", named, parts)))

    def element(self, mark: Mark, layer: Layer, paint: Attributes = _NONE) -> ET.Element:
        """A mark; what is around it has its paint, where it has none itself."""
        name, form, inside = self._form(mark, layer)
        attributes = {**form, **paint}
        if said := stated(mark):
            attributes["class"] = kind(mark)
            attributes |= {f"data-{key}": value for key, value in said.items()}
        if mark.step is not None:
            attributes["data-step"] = str(mark.step)
        return _element(name, attributes, inside)

    def _form(self, mark: Mark, layer: Layer) -> Form:
        match mark:
            case Stroke():
                gaps = _gaps(mark)
                if len(mark.places) == 2 and not mark.closed:
                    return "line", _line(*mark.places) | gaps, ""
                corners = "L".join(" ".join(_xy(place)) for place in mark.places)
                return "path", {"d": "M" + corners + ("Z" if mark.closed else "")} | gaps, ""
            case Disc():
                return _circle(mark.centre, mark.radius)
            case ArcMark():
                turns, flags = (0.0, mark.sweep), f"{int(abs(mark.sweep) > math.pi)} {int(mark.sweep > 0)}"
                ends = (_xy(mark.centre + cmath.rect(mark.radius, mark.start + turn)) for turn in turns)
                (x1, y1), (x2, y2), radius = *ends, mm(mark.radius)
                return "path", {"d": f"M{x1} {y1}A{radius} {radius} 0 {flags} {x2} {y2}"}, ""
            case VectorMark(plane="detail"):
                return "path", {"d": _pointed(mark)}, ""
            case VectorMark():
                return self._vector(mark, self.colours.of_mark(mark, layer))
            case PointMark():
                return _circle(mark.at, mark.radius)
            case Text():
                return _text(mark)
            case _:
                assert_never(mark)

    def _vector(self, mark: VectorMark, colour: str) -> Form:
        """A line and its size in words; the head's tip lies on the line, so far from its end, small on short arrows."""
        form = _line(mark.start, mark.end) | _gaps(mark)
        part, back = head_size(mark)
        name = "-".join(filter(None, ("tip", colour.strip("#"), mm(10 * part), mm(back), mark.half)))
        if mark.length > 0.05:
            form["marker-end"] = f"url(#{name})"
        if mark.length > 0.05 and name not in self.heads:
            self.heads.add(name)
            head = self.drawing.marker(
                id=name, insert=(mm(TIP + back / part), "0.7"), size=(mm(TIP * part), mm(1.4 * part)), orient="auto",
                viewBox=f"0 0 {mm(TIP)} 1.4", markerUnits="userSpaceOnUse",
            )  # fmt: skip
            head.add(self.drawing.path(d=_HEADS[mark.half], fill=colour, stroke="none"))
            self.drawing.defs.add(head)
        if mark.plane not in self.sheet.scales:
            return "line", form, ""
        scale = next(scale for plane, scale in self.sheet.scales.items() if plane == mark.plane)
        size = (mark.length + mark.broken) * scale
        value = f"{size:.4g}" if mark.length > 0.0001 else "0"  # v_B3 = v_C = 0.2712 m/s
        title = f"{' = '.join((mark.name, *mark.also))} = {value} {'m/s' if mark.plane == 'velocity' else 'm/s²'}"
        return "line", form, [_element("title", {}, title)]


class Ready:
    """An element that is made already, for a drawing of svgwrite's, which asks its parts for theirs."""

    def __init__(self, element: ET.Element) -> None:
        self._element = element

    def get_xml(self) -> ET.Element:
        return self._element


def _element(name: str, attributes: Attributes, inside: Inside = "") -> ET.Element:
    """Its attributes in the order of their names, as svgwrite has them."""
    element = ET.Element(name, dict(sorted(attributes.items())))
    if isinstance(inside, str):
        element.text = inside
    else:
        element.extend(inside)
    return element


def _line(start: Place, end: Place) -> dict[str, str]:
    (x1, y1), (x2, y2) = _xy(start), _xy(end)
    return {"x1": x1, "y1": y1, "x2": x2, "y2": y2}


def _gaps(mark: Stroke | VectorMark) -> dict[str, str]:
    """The gaps of a broken line."""
    return {"stroke-dasharray": " ".join(map(mm, dashes)), "stroke-linecap": "butt"} if (dashes := mark.dashes) else {}


def _circle(centre: Place, radius: float) -> Form:
    x, y = _xy(centre)
    return "circle", {"cx": x, "cy": y, "r": mm(radius)}, ""


def _text(mark: Text) -> Form:
    """Letters of one style as one; else each run at its own place, so that no viewer has to set them."""
    size, spans = {"font-size": mm(mark.size)}, runs(mark)
    if mark.turn:
        size["transform"] = f"rotate({short(math.degrees(mark.turn))} {short(mark.at.real)} {short(mark.at.imag)})"
    if len(spans) == 1:
        (span,) = spans
        place = {"x": short(span.at.real), "y": short(span.at.imag)}
        return "text", size | place | span.type(0), span.text
    elements, line = [], math.nan
    for span in spans:
        place = {"x": short(span.at.real)} | ({"y": short(span.at.imag)} if span.at.imag != line else {})
        elements.append(_element("tspan", place | span.type(mark.size), span.text))
        line = span.at.imag
    return "text", size, elements


_HEADS: Mapping[Half, str] = {"": "M0 .2L2.8 .7L0 1.2Z", "left": "M0 0L2.8 .7L0 .7Z", "right": "M0 .7L2.8 .7L0 1.4Z"}


def _pointed(mark: VectorMark) -> str:
    """A line and its head as one outline, for an arrow that no ruler measures."""
    start, end = _xy(mark.start), _xy(mark.end)
    line = f"M{start[0]} {start[1]}L{end[0]} {end[1]}"
    if mark.length <= 0.05:
        return line
    along, (part, back) = (mark.end - mark.start) / mark.length, head_size(mark)
    tip = mark.end - along * back
    foot, left, right = tip - along * TIP * part, *_WIDTHS[mark.half]
    corners = (_xy(tip), _xy(foot - 1j * along * left * part), _xy(foot + 1j * along * right * part))
    return line + "M" + "L".join(f"{x} {y}" for x, y in corners) + "Z"


_WIDTHS: Mapping[Half, tuple[float, float]] = {"": (0.45, 0.45), "left": (0.6, 0.0), "right": (0.0, 0.6)}
"""Half widths of such a head to the left and to the right, with the line around it those of others [mm]."""
