"""What a drawing says of itself, for a program that measures it: what each mark shows, and the problem behind all."""

from __future__ import annotations

import json
from pathlib import Path

from graphkin.outputs.spans import lettered
from graphkin.seal import seal
from graphkin.sheet import Sheet
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Shows, Stroke, Text, VectorMark
from graphkin.sheet.scales import KEYS


def stated(mark: Mark) -> dict[str, str]:
    """What a mark says that it shows, for a reader to hold it to: the element's `data-*`."""
    match mark:
        case VectorMark(plane="detail") | PointMark(plane="detail"):
            return {}
        case VectorMark():
            known: dict[str, str] = {key: getattr(mark, key) for key in ("plane", "name", "tail", "head")}
            sites = zip(("of", "seen-from", "over", "onto"), mark.sites, strict=False)
            return _filled(known | {"part": mark.part, "aside": str(mark.aside or "")} | dict(sites))
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


def kind(mark: Mark) -> str:
    return {VectorMark: "vector", PointMark: "point"}.get(type(mark), "link")


def _rounded(place: Place) -> list[float]:
    return [round(place.real, 4), round(place.imag, 4)]


def statement(sheet: Sheet) -> str:
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
    if sheet.given:  # the file may tell answers, in a remark
        data |= {"style": "given", "mechanism": "", "drivers": []}
    if not sheet.paper.margin:
        data["tight"] = True
    drawn = [(kind(mark), said) for mark in sheet.marks if (said := stated(mark))]
    data["drawn"] = sorted([sort, *sorted(f"{key}={value}" for key, value in said.items())] for sort, said in drawn)
    texts = [mark for mark in sheet.marks if isinstance(mark, Text)]
    data["letters"] = sorted([lettered(text), *_rounded(text.at)] for text in texts)
    data["signs"] = len(sheet.marks) - len(texts) - len(drawn)
    data["seal"] = seal(data)
    return json.dumps(data, ensure_ascii=False)
