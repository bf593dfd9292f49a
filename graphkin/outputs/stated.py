"""What a drawing says of itself, for a program that measures it: what each mark shows, and the problem behind all."""

from __future__ import annotations

import cmath
import json
from pathlib import Path
from typing import assert_never

from graphkin.base.checksum import seal
from graphkin.outputs.spans import lettered
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Disc, Mark, Place, PointMark, Shows, Stroke, Text, VectorMark
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


def statement(sheet: Sheet, moving: bool = False) -> str:
    """The data for solving the same problem anew; a checker trusts only the lines.

    What is given, what moves, and what carries no mechanism is not measured: it bears no seal.
    """
    machine = sheet.mechanism
    data: dict[str, object] = {
        "format": 3,
        "program": "graphkin",
        "mechanism": machine.text,
        "name": machine.name,
        "title": sheet.title,
        "file": Path(machine.file).name,
        "drivers": list(sheet.drivers),
        "scales": {KEYS[plane]: scale for plane, scale in sheet.scales.items()},
        "origin": {plane: _rounded(origin) for plane, origin in sheet.origins.items()},
    }
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
    drawn = [(kind(mark), said) for mark in sheet.marks if (said := stated(mark))]
    placed = any(isinstance(mark, PointMark) and mark.plane in KEYS for mark in sheet.marks)
    texts = [mark for mark in sheet.marks if isinstance(mark, Text)]
    return {
        "drawn": sorted([sort, *sorted(f"{key}={value}" for key, value in said.items())] for sort, said in drawn),
        "letters": sorted([lettered(text), *_rounded(text.at)] for text in texts),
        "signs": sorted([*_rounded(one), *_rounded(other)] for mark in sheet.marks if _is_sign(mark, placed)
                        for one, other in (_ends(mark),)),
    }  # fmt: skip


def _is_sign(mark: Mark, placed: bool) -> bool:
    """True if a mark is held against no length: one that shows nothing, or a line of a link without points of it."""
    said = stated(mark)
    unheld = not placed and kind(mark) == "link" and said.get("form") != "ruler"
    return not isinstance(mark, Text) and (not said or unheld)


def _ends(mark: Mark) -> tuple[Place, Place]:
    """Where a sign begins, and its middle corner or, of a circle, its middle, as `graphkin.check.claims` sees them."""
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
