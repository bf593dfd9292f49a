"""The figure's marks as TikZ, in millimetres; y runs down as on the sheet."""

from __future__ import annotations

import math
from typing import assert_never

from graphkin.equations.latex import words
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import run_size, scripts
from graphkin.sheet.marks import Arc, Disc, Fill, Mark, Place, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.paper import PENS, PenName

_FILLS: dict[Fill, str] = {"none": "", "paper": ", fill=white", "ink": ", fill=black", "grey": ", fill=black!13",
                           "tint": ", fill=black!10"}  # fmt: skip
_POINTS_PER_MM = 72.27 / 25.4


def tikz(sheet: Sheet) -> str:
    """A `tikzpicture`."""
    body = "\n".join(line for mark in sheet.marks for line in _mark(mark))
    return f"\\begin{{tikzpicture}}[x=1mm,y=-1mm]\n{body}\n\\end{{tikzpicture}}"


def _mark(mark: Mark) -> list[str]:
    match mark:
        case Stroke():
            way = " -- ".join(_at(place) for place in mark.places) + (" -- cycle" if mark.closed else "")
            return [rf"\draw[{_pen(mark.pen, mark.new)}{_FILLS[mark.fill]}, line join=round, line cap=round] {way};"]
        case Disc():
            return [_circle(_pen(mark.pen, mark.new) + _FILLS[mark.fill], mark.centre, mark.radius)]
        case Arc():
            start, end = math.degrees(mark.start), math.degrees(mark.start + mark.sweep)
            first = mark.centre + mark.radius * complex(math.cos(mark.start), math.sin(mark.start))
            shape = f"start angle={_mm(-start)}, end angle={_mm(-end)}, radius={_mm(mark.radius)}mm"
            return [rf"\draw[{_pen(mark.pen, mark.new)}] {_at(first)} arc[{shape}];"]
        case VectorMark():
            return [rf"\draw[{_pen('outline', mark.new)}, -latex] {_at(mark.start)} -- {_at(mark.end)};"]
        case PointMark():
            pen = _pen("outline" if mark.fill == "paper" else "construction", mark.new)
            return [_circle(pen + _FILLS[mark.fill], mark.at, mark.radius)]
        case Text():
            return _text(mark)
        case _:
            assert_never(mark)


def _circle(style: str, centre: Place, radius: float) -> str:
    return rf"\draw[{style}] {_at(centre)} circle[radius={_mm(radius)}mm];"


def _text(mark: Text) -> list[str]:
    found = []
    for run, start, drop in scripts(mark.label, mark.size):
        size = run_size(run, mark.size) * _POINTS_PER_MM
        style = rf"\fontsize{{{_mm(size)}}}{{{_mm(size)}}}\selectfont" + (r"\itshape" if run.italic else "")
        colour = ", red!75!black" if mark.new else ""
        at = _at(mark.at + complex(start, drop))
        found.append(rf"\node[anchor=base west, inner sep=0{colour}] at {at} {{{style} {words(run.text)}}};")
    return found


def _pen(pen: PenName, new: bool) -> str:
    kind = PENS[pen]
    dashes = "".join(f"{'on' if k % 2 == 0 else 'off'} {_mm(dash)}mm " for k, dash in enumerate(kind.dashes))
    pattern = f", dash pattern={dashes.strip()}" if dashes else ""
    return f"line width={_mm(kind.width)}mm{', red!75!black' if new else ''}{pattern}"


def _mm(value: float) -> str:
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text


def _at(place: Place) -> str:
    return f"({_mm(place.real)},{_mm(place.imag)})"
