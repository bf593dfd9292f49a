"""A motion diagram drawn with matplotlib: panels, axes, curves, upright lines; `notes` writes at the curves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from graphkin.base.geometry import number
from graphkin.errors import Lang
from graphkin.model.units import Unit
from graphkin.outputs.diagram import panels
from graphkin.outputs.diagram.curves import Curves
from graphkin.outputs.diagram.fonts import has_chinese, pieces, typeset, writable
from graphkin.outputs.diagram.notes import DrawnPanel, note_peaks
from graphkin.outputs.paint import ACCENTS
from graphkin.say.catalogue import say
from graphkin.sheet.lettering import Label, joined, width
from graphkin.sheet.results import label_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axes._base import _AxesBase
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.offsetbox import AnnotationBbox

    from graphkin.outputs.diagram.page import DiagramPage

MM, POINT = 1 / 25.4, 25.4 / 72  # inches in a millimetre, millimetres in a point
WIDTH, A4 = 180.0, 267.0
LEFT, PLAIN_RIGHT, SIDE = 16.0, 5.0, 14.0  # room left of the panels, right of them, and for each axis on the right [mm]
HIGH, LOW = 58.0, 34.0
TOP, FOOT, LINE, BETWEEN = 14.0, 10.5, 4.0, 3.5
ROW = 4.8  # height of a row of a legend [mm]
BROAD, THIN = 0.35, 0.18  # lines after ISO 128 [mm]
_UNDER = -15.0  # the name of the x axis, under that [pt]
GREY = "#d8d8d8"
DASHES: tuple[str | tuple[float, tuple[float, ...]], ...] = (
    "-", (0, (7, 2)), (0, (8, 2, 1.5, 2)), (0, (2.5, 1.5)), (0, (8, 2, 1.5, 2, 1.5, 2)), (0, (1, 1.4)),
)  # fmt: skip
"""By these curves of a panel are told apart; their colour is that of the plane, as on sheets."""


def draw(curves: Curves, lang: Lang) -> DiagramPage:
    """All panels of a diagram, with title, legends, extremes and notes."""
    from matplotlib.text import Text

    from graphkin.outputs.diagram.page import DiagramPage

    layout = panels.panels({group[0]: curves.series[group[0]].unit for group in curves.alike})
    rows = []  # of each legend: as wide as its labels, with their samples of a line, are
    for panel in layout:
        size = sum(width(_label(curves, k), 9 * POINT) + 15.0 for axis in panel.axes for k in axis.curves)
        rows.append(max(1, math.ceil(size / (WIDTH - LEFT - 2 * SIDE - 30.0))))
    notes = [*panels.foot_lines(curves, layout, lang)]
    room = A4 - TOP - FOOT - len(notes) * LINE - sum(row * ROW + BETWEEN for row in rows)
    high = min(HIGH, max(LOW, room / len(rows)))
    total = TOP + FOOT + len(notes) * LINE + sum(high + row * ROW + BETWEEN for row in rows)
    page = DiagramPage(curves.course.method.mechanism.headline(lang), WIDTH * MM, total * MM)
    drawn, level = [], total - TOP
    for panel, row in zip(layout, rows, strict=True):
        level -= row * ROW + high
        drawn.append(_panel(page, curves, panel, lang, (level / total, high / total), row, last=panel is layout[-1]))
        level -= BETWEEN
    _head(page, curves, lang, total)
    _fit_sides(page, drawn)
    for k, line in enumerate(notes):
        start, foot = drawn[0].sides[0].get_position().x0, ((len(notes) - k) * LINE - 1.5) / total
        page.add_artist(_line(line, 8, (start, foot), (0.0, 0.0)))
    note_peaks(page, curves, drawn, lang)
    for text in page.findobj(Text):
        assert isinstance(text, Text)
        text.set_math_fontfamily("stix")
    return page


def _line(
    text: str, size: float, at: tuple[float, float], side: tuple[float, float], of: str = "figure fraction",
    off: tuple[float, float] = (0.0, 0.0),
) -> AnnotationBbox:  # fmt: skip
    """Words and formulas in one line; side: which part of it lies so far `off` [pt] the place."""
    from matplotlib.offsetbox import AnnotationBbox, HPacker

    box = HPacker(children=[*pieces(text, size)], align="baseline", pad=0, sep=0)
    return AnnotationBbox(
        box, at, xybox=off, xycoords=of, boxcoords="offset points", box_alignment=side, frameon=False, pad=0
    )


def _label(curves: Curves, k: int) -> Label:
    """The quantity of a curve, and those that lie on it: `ω₂ = ω₃`."""
    group = next(group for group in curves.alike if group[0] == k)
    return joined([label_of(curves.series[j].quantity, "/") for j in group], " = ")


def _head(page: Figure, curves: Curves, lang: Lang, total: float) -> None:
    """Title and drivers; long ones are written smaller."""
    mechanism = curves.course.method.mechanism
    lines = (writable(mechanism.headline(lang)), 11.0, 6.0), (panels.about_drivers(curves, lang), 9.0, 10.5)
    for k, (text, size, below) in enumerate(lines):
        wide = sum(1.0 if has_chinese(letter) else 0.5 for letter in text) * size * POINT
        size *= min(1.0, (WIDTH - 10.0) / wide)
        if k:  # quantities in italics, as at the curves
            page.add_artist(_line(text, size, (0.5, 1 - below / total), (0.5, 0.25)))
        else:
            page.text(0.5, 1 - below / total, text, fontsize=size, parse_math=False, ha="center")


def _panel(
    page: Figure, curves: Curves, panel: panels.CurvePanel, lang: Lang, place: tuple[float, float], rows: int,
    last: bool,
) -> DrawnPanel:  # fmt: skip
    """Axes, curves and legend of one panel; `place`: where its lower edge is and how high it is, of the page."""
    low, high = place
    first = page.add_axes((LEFT / WIDTH, low, 1 - (LEFT + PLAIN_RIGHT) / WIDTH, high), label=panel.kind)
    sides = [first, *(first.twinx() for _ in panel.axes[1:])]
    for side, axis, ends in zip(sides, panel.axes, panels.limits(curves, panel), strict=True):
        side.set_ylim(*ends)
        _divide(side, side, axis.unit, curves.shown(axis.unit), ends, lang)
    _across(first, curves, lang, last)
    lines: dict[int, tuple[Axes, Line2D]] = {}
    across = curves.course.value(curves.t) * curves.shown(curves.course.unit).factor
    for side, k in ((side, k) for side, axis in zip(sides, panel.axes, strict=True) for k in axis.curves):
        dashes, entry = DASHES[len(lines) % len(DASHES)], curves.series[k]
        (line,) = side.plot(
            across, entry.signed * curves.shown(entry.unit).factor, color=ACCENTS.get(panel.kind, "black"),
            linestyle=dashes, linewidth=BROAD / POINT, label=typeset(_label(curves, k)), gid=f"curve-{k}",
            solid_joinstyle="round",
        )  # fmt: skip
        lines[k] = side, line
    first.set_title(say(f"diagrams.panel {panel.kind}", lang), loc="left", fontsize=9, pad=4, y=1.0)
    first.legend(  # above the panel, so that it never hides a curve
        handles=[line for _, line in lines.values()], loc="lower right", bbox_to_anchor=(1.0, 1.0),
        ncols=math.ceil(len(lines) / rows), frameon=False, borderaxespad=0.15, borderpad=0.1, handlelength=3.2,
        handletextpad=0.5, columnspacing=1.4, labelspacing=0.15, fontsize=9,
    )  # fmt: skip
    bottom, top = first.get_ylim()
    if bottom < 0 < top and (panel.kind != "position" or len(panel.axes) == 1):
        first.axhline(0, color="black", linewidth=THIN / POINT, zorder=1.5)
    for event in curves.events:  # where the driver stops, and change points
        at = number(curves.course.value(event.at)) * curves.shown(curves.course.unit).factor
        first.axvline(at, color="black", linewidth=THIN / POINT, zorder=1.5, linestyle=(0, (12, 3, 2, 3)))
    return DrawnPanel(tuple(sides), lines)


def _divide(axis: _AxesBase, side: Axes, unit: str, shown: Unit, ends: tuple[float, float], lang: Lang) -> None:
    """Round ticks and name of a y axis beside `side`; very large and small numbers have a power of ten. At most one
    tick in 7 mm, and none so near to the lower edge that its figure would stand on those of the x axis."""
    (low, high), size = ends, max(map(abs, ends))
    power = 0 if size == 0 or 0.01 <= size < 1e5 else 3 * math.floor(math.log10(size) / 3)
    height = side.bbox.height / side.figure.dpi / MM
    low += (high - low) * 1.2 / height
    ticks = panels.division(low, high, most=max(3, int(height / 7)), degrees=unit == "rad")
    axis.set_yticks(ticks, labels=[_tick(value / 10**power, ticks, power) for value in ticks])
    axis.set_ylabel(panels.upright_label(unit, shown, lang, power), labelpad=3)
    axis.tick_params(direction="in", width=THIN / POINT, length=3, labelsize=8, pad=2.5)
    for spine in axis.spines.values():
        spine.set_linewidth(THIN / POINT)


def _tick(value: float, ticks: Sequence[float], power: int) -> str:
    step = abs(ticks[1] - ticks[0]) / 10**power if len(ticks) > 1 else 1.0
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    return f"{value:.{digits}f}".replace("-", "−") if abs(value) > 1e-9 * step else "0"


def _across(first: Axes, curves: Curves, lang: Lang, last: bool) -> None:
    """The x axis: a turn by 30 degrees; a little wider than the range where stops are at its ends."""
    course = curves.course
    factor = curves.shown(course.unit).factor
    low, high = sorted(number(course.value(t)) * factor for t in (curves.low, curves.high))
    beyond = 0.015 * (high - low) if course.path.stops else 0.0
    first.set_xlim(low - beyond, high + beyond)
    ticks = panels.division(low, high, most=13, degrees=course.angular)
    first.set_xticks(ticks, labels=[_tick(value, ticks, 0) for value in ticks] if last else [""] * len(ticks))
    first.grid(color=GREY, linewidth=THIN / POINT / 2)
    first.set_axisbelow(True)
    if last:
        first.add_artist(_line(panels.across(curves, lang), 9, (0.5, 0), (0.5, 1.0), "axes fraction", (0, _UNDER)))


def _fit_sides(page: Figure, drawn: Sequence[DrawnPanel]) -> None:
    """All panels equally wide, with room for what is written beside them."""
    for _ in range(2):
        page.draw_without_rendering()
        renderer = page.canvas.get_renderer()  # type: ignore[attr-defined]
        tight = (side.get_tightbbox(renderer) for panel in drawn for side in panel.sides)
        boxes = [box for box in tight if box is not None]
        frame = drawn[0].sides[0].bbox
        edge = 2.5 * MM * page.dpi
        left = frame.x0 - min(box.x0 for box in boxes) + edge
        right = max(box.x1 for box in boxes) - frame.x1 + edge
        for panel in drawn:
            for side in panel.sides:
                place, whole = side.get_position(), page.bbox.width
                side.set_position((left / whole, place.y0, 1 - (left + right) / whole, place.height))
