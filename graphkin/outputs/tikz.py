"""A sheet as TikZ, in true millimetres: a LaTeX file that stands alone, or whose picture is copied into another."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import partial
from itertools import groupby
from typing import assert_never

from graphkin.outputs.paint import Colours, Ink
from graphkin.outputs.typesetting import tex_words
from graphkin.sheet import Sheet
from graphkin.sheet.marks import ArcMark, Disc, Fill, Mark, Place, PointMark, Stroke, Text, VectorMark
from graphkin.sheet.paper import PENS, PenName

MARK = b"% graphkin sheet"
LIBRARIES = (r"\usepackage{xcolor}", r"\usepackage{tikz}", r"\usetikzlibrary{arrows.meta}")
"""The preamble of a document that holds a picture."""
_POINT = 72.27 / 25.4  # teX's points in a millimetre
_FILLS: dict[Fill, str] = {
    "none": "", "paper": "fill=white", "ink": "fill=.", "grey": "fill=black!13", "tint": "fill=., fill opacity=0.1",
}  # fmt: skip
_WIDE = re.compile(r"[\u2e80-\u9fff\uff00-\uffef]")


def tikz(sheet: Sheet, ink: Ink = "accent") -> str:
    """The LaTeX text of a sheet."""
    drawn, paper = picture(sheet, ink), sheet.paper
    chinese = _WIDE.search(drawn) is not None
    fonts = "newtxmath" if chinese else "newtxtext,newtxmath"
    lines = [
        MARK.decode() + ": one unit is a millimetre of the sheet" + ("; compile with xelatex" if chinese else ""),
        r"\documentclass{article}",
        rf"\usepackage[paperwidth={_mm(paper.width)}mm, paperheight={_mm(paper.height)}mm, margin=0pt]{{geometry}}",
        *LIBRARIES,
        r"\usepackage{amsmath}",
        *([r"\usepackage[fontset=fandol]{ctex}"] if chinese else []),
        rf"\IfFileExists{{newtxmath.sty}}{{\usepackage{{{fonts}}}}}{{\usepackage{{fix-cm}}}}",
        r"\pagestyle{empty}", r"\begin{document}", r"\noindent%", drawn, r"\end{document}", "",
    ]  # fmt: skip
    return "\n".join(lines)


def picture(sheet: Sheet, ink: Ink = "accent") -> str:
    """Its picture alone, for a document that has `LIBRARIES`."""
    colours = Colours.of(sheet, ink)
    lines = [
        r"\begin{tikzpicture}[x=1mm, y=-1mm, line cap=round, line join=round,",
        r"  letters/.style={anchor=base west, inner sep=0pt, outer sep=0pt},",
        r"  arrow/.style={-{Stealth[length=2.8mm, width=0.9mm]}}]",
        rf"\useasboundingbox (0, 0) rectangle ({_mm(sheet.paper.width)}, {_mm(sheet.paper.height)});",
    ]
    for layer in sheet.layers:
        for colour, marks in groupby(layer.marks, partial(colours.of_mark, layer=layer)):
            lines += [rf"\color[HTML]{{{colour.strip('#').upper()}}}", *map(_mark, marks)]
    return "\n".join([*lines, r"\end{tikzpicture}"])


def _mark(mark: Mark) -> str:
    match mark:
        case Stroke():
            ends = " -- ".join(map(_place, mark.places)) + (" -- cycle" if mark.closed else "")
            return rf"\draw[{_pen(mark.pen, mark.fill, mark.dashes)}] {ends};"
        case Disc():
            return rf"\draw[{_pen(mark.pen, mark.fill)}] {_place(mark.centre)} circle[radius={_mm(mark.radius)}];"
        case ArcMark():
            start = mark.centre + mark.radius * complex(math.cos(mark.start), math.sin(mark.start))
            turn = f"start angle={_mm(math.degrees(mark.start))}, delta angle={_mm(math.degrees(mark.sweep))}"
            return rf"\draw[{_pen(mark.pen)}] {_place(start)} arc[{turn}, radius={_mm(mark.radius)}];"
        case VectorMark():
            look = _pen(mark.pen, broken=mark.dashes) + (", arrow" if mark.length > 0.05 else "")
            return rf"\draw[{look}] {_place(mark.start)} -- {_place(mark.end)};"
        case PointMark():
            return rf"\draw[{_pen('outline', mark.fill)}] {_place(mark.at)} circle[radius={_mm(mark.radius)}];"
        case Text():
            size = f"{mark.size * _POINT:.2f}"
            font = rf"\fontsize{{{size}}}{{{size}}}\selectfont"
            turned = f", rotate={_mm(-math.degrees(mark.turn))}" if mark.turn else ""
            return rf"\node[letters{turned}, font={font}] at {_place(mark.at)} {{{tex_words(mark.label)}}};"
        case _:
            assert_never(mark)


def _pen(pen: PenName, fill: Fill = "none", broken: Sequence[float] = ()) -> str:
    kind = PENS[pen]
    lengths = enumerate(broken or kind.dashes)
    dashes = " ".join(f"{'on' if k % 2 == 0 else 'off'} {_mm(dash)}mm" for k, dash in lengths)
    look = [f"line width={_mm(kind.width)}mm", f"dash pattern={dashes}" if dashes else "", _FILLS[fill]]
    look += ["line cap=butt"] if broken else []
    return ", ".join(filter(None, look))


def _place(place: Place) -> str:
    return f"({_mm(place.real)}, {_mm(place.imag)})"


def _mm(length: float) -> str:
    return f"{round(length, 4) + 0.0:g}" if abs(length) < 1000 else f"{length:.4f}"
