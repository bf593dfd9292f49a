"""A sheet as SVG: one user unit is one millimetre, and a program can measure it.

svgwrite makes the elements (`debug=False`: its checker refuses `data-*`). Every number is formatted here
with four decimals, so the same sheet gives the same bytes.
"""

from __future__ import annotations

import cmath
import json
import math
import os
import re
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any, ClassVar, assert_never

from graphkin.errors import GraphkinError, Lang
from graphkin.outputs import files
from graphkin.outputs.files import beside
from graphkin.outputs.svgwriting import svgwrite
from graphkin.seal import seal
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import SMALL, Label, scripts
from graphkin.sheet.marks import Arc, Disc, Fill, Mark, Place, PointMark, Shows, Stroke, Text, VectorMark
from graphkin.sheet.paper import PENS, PenName
from graphkin.sheet.scales import KEYS
from graphkin.value import filled

NAMESPACE = "https://graphkin.invalid/sheet/1"
MARKS = (NAMESPACE.encode(),)
_LATIN = "Times New Roman, Liberation Serif, Tinos, serif"
_CHINESE = "Noto Serif CJK SC, Source Han Serif SC, Songti SC, SimSun, WenQuanYi Micro Hei, serif"
_WIDE = re.compile(r"([\u2160-\u217f\u2e80-\u9fff\u3000-\u303f\uff00-\uffef]+)")
_INK, _NEW = "#000000", "#c00000"
_FILLS: dict[Fill, str] = {"none": "none", "paper": "#ffffff", "ink": _INK, "grey": "#dddddd"}
_CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")
_TIP = 2.8
"""Length of an arrow head; on arrows too short for it, half of that [mm]."""


class Unwritable(GraphkinError):
    """Text that no XML file can hold."""

    where: str
    code: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the character {code} cannot stand in a drawing. Remove it from the mechanism file.",
        "zh": "{where}：字符 {code} 不能写入图形文件，请从机构文件中删去。",
    }


def svg(sheet: Sheet) -> str:
    """The SVG text of a sheet. Raises Unwritable where the mechanism file holds control characters."""
    _refuse_control(sheet.mechanism.text, sheet.mechanism.file)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + _drawn(sheet, metadata=True) + "\n"


def inline(sheet: Sheet) -> str:
    """The drawing as an element of a page, without what only a file of its own needs."""
    return _drawn(sheet, metadata=False)


def _drawn(sheet: Sheet, metadata: bool) -> str:
    _refuse_control(sheet.title, sheet.mechanism.file)
    pen = _Pen(sheet, metadata)
    for mark in sheet.marks:
        pen.draw(mark)
    return str(pen.drawing.tostring())


def write(path: str | os.PathLike[str], text: str, force: bool = False) -> None:
    """Write beside, then rename. A file that graphkin did not write is replaced only with `force`.

    Raises FileInTheWay.
    """
    with beside(Path(path), force, MARKS) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")


def refuse(path: Path, force: bool) -> None:
    """Whether a drawing may be written there; several are all asked before the first is written."""
    files.refuse(path, force, MARKS)


def _refuse_control(text: str, where: str) -> None:
    if (found := _CONTROL.search(text)) is not None:
        line = text.count("\n", 0, found.start()) + 1
        raise Unwritable(f"{where}:{line}", f"U+{ord(found.group()):04X}")


def mm(value: float) -> str:
    """Four decimals, no trailing zeros."""
    if not math.isfinite(value):
        raise ValueError(f"a coordinate is {value}")
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text


def _xy(place: Place) -> tuple[str, str]:
    return mm(place.real), mm(place.imag)


# --- elements ---------------------------------------------------------------------------------


class _Pen:
    """One drawing in the making."""

    def __init__(self, sheet: Sheet, metadata: bool) -> None:
        wide, high = mm(sheet.paper.width), mm(sheet.paper.height)
        self.drawing: Any = svgwrite().Drawing(
            size=(f"{wide}mm", f"{high}mm"), viewBox=f"0 0 {wide} {high}", profile="full", debug=False
        )
        self.drawing["xmlns:gk"] = NAMESPACE
        self.drawing["xml:lang"] = sheet.lang
        self.drawing.set_desc(title=sheet.title)
        if metadata:
            self.drawing.set_metadata(_metadata(sheet))
        for new in (False, True):
            self._marker(new, 1.0)
            self._marker(new, 0.5)

    def _marker(self, new: bool, part: float) -> None:
        """An arrow head whose tip lies exactly on the end of its line."""
        head = self.drawing.marker(
            id=_tip(new, part), insert=("2.8", "0.5"), size=(mm(_TIP * part), mm(part)), orient="auto",
            viewBox="0 0 2.8 1", markerUnits="userSpaceOnUse",
        )  # fmt: skip
        head.add(self.drawing.path(d="M0 0L2.8 .5L0 1Z", fill=_NEW if new else _INK))
        self.drawing.defs.add(head)

    def draw(self, mark: Mark) -> None:
        match mark:
            case Stroke():
                element = self._stroke(mark)
            case Disc():
                element = self.drawing.circle(_xy(mark.centre), mm(mark.radius))
                self._line(element, mark.pen, mark.new, mark.fill)
            case Arc():
                element = self._arc(mark)
            case VectorMark():
                element = self._vector(mark)
            case PointMark():
                element = self._point(mark)
            case Text():
                element = self._text(mark)
            case _:
                assert_never(mark)
        if told := stated(mark):
            element["class"] = _class(mark)
            element.attribs |= {f"data-{key}": value for key, value in told.items()}
        if mark.step is not None:
            element["data-step"] = str(mark.step)
        self.drawing.add(element)

    def _line(self, element: Any, pen: PenName, new: bool, fill: Fill = "none") -> None:
        """Width, dashes, colour and filling."""
        kind = PENS[pen]
        element["fill"] = _NEW if fill == "ink" and new else _FILLS[fill]
        element["stroke"] = _NEW if new else _INK
        element["stroke-width"] = mm(kind.width * (1.6 if new else 1))
        if kind.dashes:
            element["stroke-dasharray"] = " ".join(mm(dash) for dash in kind.dashes)

    def _stroke(self, mark: Stroke) -> Any:
        places = [_xy(place) for place in mark.places]
        if len(places) == 2 and not mark.closed:
            element = self.drawing.line(*places)
        else:
            element = self.drawing.path(d="M" + "L".join(f"{x} {y}" for x, y in places) + ("Z" if mark.closed else ""))
        self._line(element, mark.pen, mark.new, mark.fill)
        element["stroke-linejoin"] = element["stroke-linecap"] = "round"
        return element

    def _arc(self, mark: Arc) -> Any:
        start = mark.centre + cmath.rect(mark.radius, mark.start)
        end = mark.centre + cmath.rect(mark.radius, mark.start + mark.sweep)
        flags = f"{int(abs(mark.sweep) > math.pi)} {int(mark.sweep > 0)}"
        (x1, y1), (x2, y2), radius = _xy(start), _xy(end), mm(mark.radius)
        element = self.drawing.path(d=f"M{x1} {y1}A{radius} {radius} 0 {flags} {x2} {y2}")
        self._line(element, mark.pen, mark.new)
        return element

    def _vector(self, mark: VectorMark) -> Any:
        element = self.drawing.line(_xy(mark.start), _xy(mark.end))
        self._line(element, "vector", mark.new)
        if mark.length > 0.05:
            _head(element, mark.new, 1.0 if mark.length > 1.6 * _TIP else 0.5)
        return element

    def _point(self, mark: PointMark) -> Any:
        element = self.drawing.circle(_xy(mark.at), mm(mark.radius))
        self._line(element, "outline" if mark.fill == "paper" else "construction", mark.new, mark.fill)
        return element

    def _text(self, mark: Text) -> Any:
        """Runs of one script follow one another; where the script changes, the place is given anew."""
        element = self.drawing.text("", font_size=mm(mark.size), fill=_NEW if mark.new else _INK)
        writer = _Line(self.drawing, mark.at, mark.size)
        for span in writer.spans(mark.label):
            element.add(span)
        return element


def stated(mark: Mark) -> dict[str, str]:
    """What a mark says that it shows, for a reader to hold it to: the element's `data-*`."""
    match mark:
        case VectorMark():
            known: dict[str, str] = {key: getattr(mark, key) for key in ("plane", "name", "tail", "head")}
            sites = zip(("of", "seen-from", "over", "onto"), mark.sites, strict=False)
            return _filled(known | {"part": mark.part} | dict(sites))
        case PointMark():
            named: dict[str, str] = {key: getattr(mark, key) for key in ("plane", "name", "of")}
            return _filled(named | {"site": mark.site})
        case Stroke(shows=Shows() as shows) | Disc(shows=Shows() as shows):
            lies = {"plane": shows.plane, "link": shows.link, "form": shows.form, "points": " ".join(shows.points)}
            return _filled(lies | {"line": shows.line})
        case _:
            return {}


def _filled(said: dict[str, str]) -> dict[str, str]:
    return {key: value for key, value in said.items() if value}


def _class(mark: Mark) -> str:
    return {VectorMark: "vector", PointMark: "point"}.get(type(mark), "link")


def _tip(new: bool, part: float) -> str:
    """Name of an arrow head."""
    return "tip" + ("-small" if part < 1 else "") + ("-new" if new else "")


def _head(element: Any, new: bool, part: float = 1.0) -> None:
    element["marker-end"] = f"url(#{_tip(new, part)})"


@filled
class _Line:
    """Lays the runs of a label one after another."""

    drawing: Any
    at: Place
    size: float
    pen: float = 0.0
    low: float = 0.0
    family: str = ""

    def spans(self, label: Label) -> list[Any]:
        from graphkin.sheet.lettering import advance

        found: list[Any] = []
        for run, start, drop in scripts(label, self.size):
            size = self.size * (1.0 if run.place == "base" else SMALL)
            for text in filter(None, _WIDE.split(run.text)):
                found.append(self._span(text, run.italic, size, start, drop))
                start += advance(text, run.italic) * size
                self.pen = start
        return found

    def _span(self, text: str, italic: bool, size: float, start: float, drop: float) -> Any:
        family = _CHINESE if _WIDE.match(text) else _LATIN
        words: dict[str, Any] = {"font_family": family, "font_size": mm(size)}
        if italic and family == _LATIN:
            words["font_style"] = "italic"
        if family != self.family:
            words |= {"x": [mm(self.at.real + start)], "y": [mm(self.at.imag + drop)]}
        else:
            shifts = {"dx": start - self.pen, "dy": drop - self.low}
            words |= {key: [mm(shift)] for key, shift in shifts.items() if abs(shift) > 1e-6}
        self.family, self.low = family, drop
        return self.drawing.tspan(text, **words)


def _rounded(place: Place) -> list[float]:
    return [round(place.real, 4), round(place.imag, 4)]


def _metadata(sheet: Sheet) -> ET.Element:
    """What a reader needs to solve the same problem anew; a checker trusts only the lines."""
    machine = sheet.mechanism
    data: dict[str, object] = {
        "format": 2,
        "program": "graphkin",
        "mechanism": machine.text,
        "name": machine.name,
        "file": Path(machine.file).name,
        "drivers": list(sheet.drivers),
        "scales": {KEYS[plane]: scale for plane, scale in sheet.scales.items()},
        "origin": {plane: _rounded(origin) for plane, origin in sheet.origins.items()},
    }
    drawn = [(_class(mark), told) for mark in sheet.marks if (told := stated(mark))]
    data["drawn"] = sorted([kind, *sorted(f"{key}={value}" for key, value in told.items())] for kind, told in drawn)
    texts = [mark for mark in sheet.marks if isinstance(mark, Text)]
    data["letters"] = sorted(["".join(run.text for run in text.label), *_rounded(text.at)] for text in texts)
    data["signs"] = len(sheet.marks) - len(texts) - len(drawn)
    data["seal"] = seal(data)
    element = ET.Element("gk:sheet")
    element.text = json.dumps(data, ensure_ascii=False)
    return element
