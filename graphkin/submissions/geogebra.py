"""GeoGebra's .ggb: a zip with `geogebra.xml`. Points by their labels; one of its units counts as a millimetre, unless a
text of the file says `unit = 10 mm`.

Coordinates in a saved file are what GeoGebra last computed, homogeneous: they are divided by z.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Iterator, Mapping
from xml.etree.ElementTree import Element

from graphkin.errors import BrokenSubmission, Where
from graphkin.submissions import archives
from graphkin.submissions.picture import Dot, PagePicture, PictureArrow, PictureText
from graphkin.submissions.submission import Limits
from graphkin.submissions.svg import xml_root

_POINT = re.compile(r"\(\s*([-+0-9.eE]+)\s*,\s*([-+0-9.eE]+)\s*\)")
_UNIT = re.compile(r"(?:unit|单位)\s*=\s*([0-9]+(?:\.[0-9]+)?)\s*mm", re.I)
_VECTOR = re.compile(r"(?:Vector|Vektor|Vecteur)\[\s*(.+)\s*\]", re.I)


def read_ggb(content: bytes, where: Where, limits: Limits) -> PagePicture:
    """Raises BrokenSubmission, TooMuch."""
    archives.checked_zip(content, where, limits)
    with archives.opened(content, where) as archive:
        infos = archives.members(archive, where, limits)
        inside = next((info for info in infos if archives.member_name(info) == "geogebra.xml"), None)
        if inside is None:
            raise BrokenSubmission(where, "GeoGebra", "geogebra.xml")
        xml = archives.read_member(archive, inside, where, limits)
    root = xml_root(xml, where, "GeoGebra", limits, forbid_dtd=True)
    construction = root.find("construction")
    if root.tag != "geogebra" or construction is None:
        raise BrokenSubmission(where, "GeoGebra")
    elements = [element for element in construction if element.tag == "element"]
    points: dict[str, tuple[Element, complex]] = {}  # none that is undefined or at infinity
    for element in (element for element in elements if element.get("type") == "point"):
        x, y, z = (_number(element.find("coords"), key) for key in "xyz")
        if x is not None and y is not None and z and abs(place := complex(x, y) / z) <= 1e9:
            points[element.get("label", "")] = element, place
    places = {label: place for label, (_, place) in points.items()}
    written = {e.get("label", ""): e.get("exp", "") for e in construction if e.tag == "expression"}
    ends = dict(_ends(construction, places, written))
    named = ((e, written.get(e.get("label", ""), "").strip('"')) for e in elements if e.get("type") == "text")
    texts = [PictureText(text, places.get("", 0j), 1 + 0j, 1j, 0.0, 0.0) for _, text in named if "=" in text]
    units = (_UNIT.search(text.text) for text in texts)
    mm = next((float(unit[1]) for unit in units if unit is not None), 1.0)
    mm = mm if 1e-6 < mm < 1e6 else 1.0
    arrows = []
    for element in (element for element in elements if element.get("type") == "vector"):
        pair = ends.get(element.get("label", ""))
        x, y = (_number(element.find("coords"), key) for key in "xy")
        if pair is None and x is not None and y is not None:  # that no two points made, from where it starts
            start = element.find("startPoint")
            tail = complex(_number(start, "x") or 0.0, _number(start, "y") or 0.0)
            pair = tail, tail + complex(x, y)
        arrows += [PictureArrow(_name(element), mm * pair[0], mm * pair[1])] if pair is not None else []
    dots = tuple(Dot(mm * place, _name(element)) for element, place in points.values())
    lines = tuple((mm * one, mm * other) for one, other in ends.values())
    return PagePicture(lines, dots, tuple(texts), tuple(arrows))


def _number(element: Element | None, key: str) -> float | None:
    try:
        value = float(element.get(key, "")) if element is not None else float("nan")
    except ValueError:
        return None
    return value if abs(value) < 1e12 else None


def _name(element: Element) -> str:
    """Its caption where one is shown (or its name is the program's own), else its name."""
    caption, mode = element.find("caption"), element.find("labelMode")
    shown = caption is not None and mode is not None and mode.get("val") in ("3", "9")
    name = caption.get("val", "") if shown and caption is not None else element.get("label", "")
    return name.replace("%n", element.get("label", ""))[:60]


def _ends(
    construction: Element, places: Mapping[str, complex], written: Mapping[str, str]
) -> Iterator[tuple[str, tuple[complex, complex]]]:
    """Segments and vectors by the command that made them."""
    for command in construction.iter("command"):
        given, made = command.find("input"), command.find("output")
        if command.get("name") not in ("Segment", "Vector", "Ray", "Line") or given is None or made is None:
            continue
        ends = [_point(given.get(key, ""), places) for key in ("a0", "a1") if given.get(key)]
        ends = [0j, *ends] if len(ends) == 1 and command.get("name") == "Vector" else ends
        if len(ends) == 2 and ends[0] is not None and ends[1] is not None:
            yield made.get("a0", ""), (ends[0], ends[1])
    for label, text in written.items():
        if (vector := _VECTOR.fullmatch(text.strip())) is not None:
            ends = [_point(part, places) for part in re.split(r",(?![^(]*\))", vector[1])]
            if len(ends) == 2 and ends[0] is not None and ends[1] is not None:
                yield label, (ends[0], ends[1])


def _point(text: str, places: Mapping[str, complex]) -> complex | None:
    """By its name, or written as (1, 2)."""
    name = text.strip()
    if name in places:
        return places[name]
    pair = _POINT.fullmatch(name)
    try:
        place = complex(float(pair[1]), float(pair[2])) if pair is not None else None
    except ValueError:
        return None
    return place if place is not None and cmath.isfinite(place) else None
