"""A linkage's limits and its extreme transmission angles on one sheet, as textbooks draw them.

On the left both limit positions over each other (the second thin) with psi or H and theta; on the right the
positions between which the transmission angle lies. Both at one true scale.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from graphkin.errors import Lang
from graphkin.linkages import Report
from graphkin.linkages.linkage import Position
from graphkin.mechanism import Mechanism
from graphkin.sheet import Sheet
from graphkin.sheet.labels import Room, settle
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import plain, width
from graphkin.sheet.linkage_angles import dimensioned_limits, dimensioned_transmission
from graphkin.sheet.linkage_figure import drawn_over, values
from graphkin.sheet.marks import Mark, Text
from graphkin.sheet.obstacles import bounds
from graphkin.sheet.paper import BODY, Paper
from graphkin.sheet.scales import finest
from graphkin.sheet.titleblock import broken, strip, strip_heights
from graphkin.sheet.window import Figure, Window
from graphkin.value import frozen
from graphkin.words.linkages import amount, degrees, kind_name, titled

__all__ = ["limit_sheet"]

_LETTERS = 7.0
"""What labels need around a figure [mm]."""
_CAPTION = 22.0
"""Room for a caption of four lines under each figure [mm]."""
_TRIAL = 80.0
"""Size of a figure when it is drawn to see how far its signs reach [mm]."""


@frozen
class _Panel:
    """One figure: its positions, how it is drawn, what stands under it."""

    positions: tuple[Position, ...]
    draw: Callable[[Window], Figure]
    caption: tuple[str, ...]


def limit_sheet(report: Report, lang: Lang = "en", *, paper: str | None = None, title: str = "") -> Sheet:
    """The sheet of a report.

    paper   a key of `PAPERS`; A4 on its side where left out
    title   of the title block; the kind where left out

    Raises UnknownPaper.
    """
    chosen = papers_for(paper or "A4-landscape")[0]
    panels = _panels(report, lang)
    cells = _cells(chosen, len(panels))
    reaches = [_reach(panel) for panel in panels]
    scale = max(_scale(panel, reach, cell) for panel, reach, cell in zip(panels, reaches, cells))
    headline = title or kind_name(report, lang)
    machine = _mechanism(report, headline)
    marks = list(strip(machine, [], chosen, _strip(chosen), {"position": scale}, {}, lang))
    windows = [_window(panel, reach, cell, scale) for panel, reach, cell in zip(panels, reaches, cells)]
    for panel, window, cell in zip(panels, windows, cells):
        marks += _drawn(panel, window, cell)
    drivers = tuple(float(driver.value or 0.0) for driver in machine.drivers)
    origins = {"position": windows[0].origin}
    return Sheet(chosen, tuple(marks), {"position": scale}, origins, machine, drivers, headline, lang)  # type: ignore[arg-type]


def _mechanism(report: Report, headline: str) -> Mechanism:
    """The linkage as a mechanism, for what the drawing file says of it."""
    return replace(titled(report.linkage), title={"en": headline, "zh": headline})


# --- what is drawn ------------------------------------------------------------------------------


def _panels(report: Report, lang: Lang) -> list[_Panel]:
    panels = []
    if report.limits:
        panels.append(_Panel(report.limits, lambda window: _limits(report, window), _limit_caption(report, lang)))
    if report.critical and report.gamma_min is not None and not report.level:
        shown = _shown(report)
        panels.append(_Panel(shown, lambda window: _transmission(report, shown, window), _gamma_caption(report, lang)))
    if not panels:
        ends = report.critical[:2]
        panels.append(_Panel(ends, lambda window: drawn_over(report.linkage, ends, window), (kind_name(report, lang),)))
    return panels


def _shown(report: Report) -> tuple[Position, ...]:
    """The position of the least transmission angle first, and one to compare it with."""
    least = report.least[0]
    others = [end for end in report.critical if end is not least]
    return (least, *others[:1])


def _limits(report: Report, window: Window) -> Figure:
    figure = drawn_over(report.linkage, report.limits, window)
    more = dimensioned_limits(report, window)
    return Figure(more.marks + figure.marks, figure.wanted + more.wanted)


def _transmission(report: Report, shown: tuple[Position, ...], window: Window) -> Figure:
    figure = drawn_over(report.linkage, shown, window, primes=True)
    more = dimensioned_transmission(report, shown, window)
    return Figure(more.marks + figure.marks, figure.wanted + more.wanted)


_WORDS: dict[str, dict[Lang, str]] = {
    "limits": {"en": "Limit positions of {output}", "zh": "{output} 的极限位置"},
    "k": {"en": "K = (180° + θ)/(180° − θ) = {k}", "zh": "K = (180° + θ)/(180° − θ) = {k}"},
    "timed": {"en": "K = {k} (crank {crank})", "zh": "K = {k}（曲柄 {crank}）"},
    "one": {"en": "θ = 0, K = 1: no quick return", "zh": "θ = 0，K = 1，无急回特性"},
    "dead": {"en": "dead points where {driver} drives: {values}", "zh": "{driver} 主动时的死点：{values}"},
    "none": {"en": "no dead point where {driver} drives", "zh": "{driver} 主动时无死点"},
    "gamma": {"en": "Transmission angle, {driver} driving", "zh": "传动角（{driver} 主动）"},
    "least": {
        "en": "γ min = {gamma}, α max = {alpha}, {driver} at {values}",
        "zh": "γ min = {gamma}，α max = {alpha}，{driver} 在 {values}",
    },
}


def _degrees(angle: float) -> str:
    return degrees(angle, "zh")


def _limit_caption(report: Report, lang: Lang) -> tuple[str, ...]:
    found = [_WORDS["limits"][lang].format(output=report.output)]
    if report.k is not None:
        key = "timed" if report.timed_by else "one" if report.slow is None else "k"
        found.append(_WORDS[key][lang].format(k=f"{report.k:.5g}", crank=report.timed_by))
    other = [name for name in report.dead if name != report.driver][:1]
    return (*found, *(_dead(report, name, lang) for name in other))


def _gamma_caption(report: Report, lang: Lang) -> tuple[str, ...]:
    values = ", ".join(amount(report, end.driver, "zh") for end in report.least)
    words = {"gamma": _degrees(report.gamma_min or 0.0), "alpha": _degrees(report.alpha_max or 0.0)}
    found = [_WORDS["gamma"][lang].format(driver=report.driver)]
    found.append(_WORDS["least"][lang].format(**words, driver=report.driver, values=values))
    return (*found, *([_dead(report, report.driver, lang)] if report.driver in report.dead else []))


def _dead(report: Report, driver: str, lang: Lang) -> str:
    values = report.dead[driver]
    slides = driver == report.slide
    said = ", ".join(f"{value * 1e3:.5g} mm" if slides else _degrees(value) for value in values)
    return _WORDS["dead" if values else "none"][lang].format(driver=driver, values=said)


# --- where it stands -----------------------------------------------------------------------------


def _strip(paper: Paper) -> Room:
    foot = paper.height - paper.margin
    return Room(paper.margin, foot - strip_heights([])[paper.name], paper.width - paper.margin, foot)


def _cells(paper: Paper, count: int) -> list[Room]:
    """Rooms side by side, or over each other on paper that stands upright."""
    room = _strip(paper)
    left, right, top, foot = room.left, room.right, paper.margin, room.top
    if paper.landscape:
        wide = (right - left) / count
        return [Room(left + k * wide, top, left + (k + 1) * wide, foot) for k in range(count)]
    high = (foot - top) / count
    return [Room(left, top + k * high, right, top + (k + 1) * high) for k in range(count)]


def _corners(panel: _Panel) -> tuple[complex, complex]:
    places = values(panel.positions)
    low = complex(min(z.real for z in places), min(z.imag for z in places))
    return low, complex(max(z.real for z in places), max(z.imag for z in places))


def _reach(panel: _Panel) -> Room:
    """How far signs go beyond the points on each side [mm]."""
    low, high = _corners(panel)
    scale = finest(high - low, complex(_TRIAL, _TRIAL))
    left, top, right, bottom = bounds(panel.draw(Window(0j, scale)).marks)
    return Room(
        max(0.0, low.real / scale - left) + _LETTERS, max(0.0, -high.imag / scale - top) + _LETTERS,
        max(0.0, right - high.real / scale) + _LETTERS, max(0.0, bottom + low.imag / scale) + _LETTERS,
    )  # fmt: skip


def _scale(panel: _Panel, reach: Room, cell: Room) -> float:
    low, high = _corners(panel)
    wide = cell.right - cell.left - reach.left - reach.right
    tall = cell.bottom - cell.top - reach.top - reach.bottom - _CAPTION
    return finest(high - low, complex(max(wide, 1.0), max(tall, 1.0)))


def _window(panel: _Panel, reach: Room, cell: Room, scale: float) -> Window:
    """The figure in the middle of its cell."""
    low, high = _corners(panel)
    size = (high - low) / scale
    x = (cell.left + cell.right - size.real - reach.left - reach.right) / 2 + reach.left
    y = (cell.top + cell.bottom - _CAPTION - size.imag - reach.top - reach.bottom) / 2 + reach.top + size.imag
    return Window(complex(x, y) - low.conjugate() / scale, scale)


def _drawn(panel: _Panel, window: Window, cell: Room) -> list[Mark]:
    figure = panel.draw(window)
    inner = Room(cell.left + 1, cell.top + 1, cell.right - 1, cell.bottom - _CAPTION)
    settled = settle(figure.wanted, figure.marks, inner)
    if settled.clashes:
        settled = settle(figure.wanted, figure.marks, inner, far=True)
    return [*figure.marks, *settled.marks, *_caption(panel.caption, cell)]


def _caption(caption: tuple[str, ...], cell: Room) -> list[Mark]:
    """Lines in the middle under the figure."""
    marks: list[Mark] = []
    pen = cell.bottom - _CAPTION + 5.0
    for text in caption:
        for line in broken(text, BODY, cell.right - cell.left - 6):
            label = plain(line)
            marks.append(Text(label, complex((cell.left + cell.right - width(label, BODY)) / 2, pen), BODY))
            pen += 1.35 * BODY
    return marks
