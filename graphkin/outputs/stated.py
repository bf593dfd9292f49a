"""The data in a drawing for a program that measures it: what each mark shows, and the problem behind all."""

from __future__ import annotations

import cmath
import json
from pathlib import Path
from typing import assert_never

from graphkin.base.plain import seal
from graphkin.outputs.typesetting import lettered
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Shows, Stroke, Text, VectorMark
from graphkin.sheet.paper import KEYS


def stated(mark: Mark) -> dict[str, str]:
    """The data that a mark says it shows, for a reader to hold it to: the element's `data-*`."""
    said: dict[str, str] = {}
    match mark:
        case VectorMark(plane="detail") | PointMark(plane="detail"):
            pass
        case VectorMark():
            said = {key: getattr(mark, key) for key in ("plane", "name", "tail", "head", "part")}
            said |= zip(("of", "seen-from", "over", "onto"), mark.sites, strict=False)
            said |= {key: f"{length:.4f}" for key in ("aside", "broken") if (length := getattr(mark, key))}
        case PointMark():
            said = {key: getattr(mark, key) for key in ("plane", "name", "of", "site")}
        case Stroke(shows=Shows() as shows) | Disc(shows=Shows() as shows):
            said = {key: getattr(shows, key) for key in ("plane", "link", "form")}
            said |= {"points": " ".join(shows.points), "line": shows.line}
        case _:
            pass
    return {key: value for key, value in said.items() if value}


def kind(mark: Mark) -> str:
    """The class of a mark in the file: vector, point or link."""
    return {VectorMark: "vector", PointMark: "point"}.get(type(mark), "link")


def _xy(place: Place) -> list[float]:
    return [round(place.real, 4), round(place.imag, 4)]


def statement(sheet: Sheet, moving: bool = False) -> str:
    """The data for solving the same problem anew; a checker trusts only the lines. What is given, what moves, and what
    carries no mechanism is not measured: it bears no seal."""
    machine = sheet.mechanism
    data: dict[str, object] = {
        "format": 3, "program": "graphkin", "mechanism": machine.text, "name": machine.name, "title": sheet.title,
        "file": Path(machine.file).name, "drivers": list(sheet.drivers),
        "scales": {KEYS[plane]: scale for plane, scale in sheet.scales.items()},
        "origin": {plane: _xy(origin) for plane, origin in sheet.origins.items()},
    }  # fmt: skip
    if not sheet.paper.margin:
        data["tight"] = True
    if sheet.given:  # the file may tell answers, in a remark
        data |= {"style": "given", "mechanism": "", "drivers": []}
    elif moving or not machine.text.strip():
        data["style"] = "moving" if moving else "bare"
    else:
        data |= _drawn(sheet)
        data["seal"] = seal(data)
    return json.dumps(data, ensure_ascii=False)


def _drawn(sheet: Sheet) -> dict[str, object]:
    """Contents of each mark, the texts, and where signs are that show nothing: a reader holds the sheet to them."""
    every = [(mark, stated(mark)) for mark in sheet.marks]
    drawn = [(kind(mark), said) for mark, said in every if said]
    placed = any(isinstance(mark, PointMark) and mark.plane in KEYS for mark, _ in every)
    texts = [mark for mark, _ in every if isinstance(mark, Text)]
    signs = []  # held against no length: what shows nothing, or a line of a link without points of it
    for mark, said in every:
        unheld = not placed and kind(mark) == "link" and said.get("form") != "ruler"
        if not isinstance(mark, Text) and (not said or unheld):
            one, other = _ends(mark)
            signs.append([*_xy(one), *_xy(other)])
    return {
        "drawn": sorted([sort, *sorted(f"{key}={value}" for key, value in said.items())] for sort, said in drawn),
        "letters": sorted([lettered(text), *_xy(text.at)] for text in texts),
        "signs": sorted(signs),
    }


def _ends(mark: Mark) -> tuple[Place, Place]:
    """The start of a sign, and its middle corner or, of a circle, its middle, as `graphkin.check.signs` sees them."""
    match mark:
        case Stroke():
            corners = (*mark.places, *mark.places[: mark.closed])
            return corners[0], corners[len(corners) // 2]
        case Disc(centre=at, radius=radius) | PointMark(at=at, radius=radius):
            return at + radius, at
        case ArcMark():
            start, end = (mark.centre + cmath.rect(mark.radius, mark.start + turn) for turn in (0.0, mark.sweep))
            return start, (start + end) / 2 - mark.radius * (1 + 1j)
        case VectorMark():
            return mark.start, mark.end
        case Text():
            return mark.at, mark.at
        case _:
            assert_never(mark)
