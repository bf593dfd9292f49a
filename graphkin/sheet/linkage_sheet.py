"""A linkage's limits and its extreme transmission angles on one sheet, as textbooks draw them.

On the left both limit positions over each other (the second thin) with psi or H and theta; on the right the
positions between which the transmission angle lies. Both at one true scale.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.errors import Lang
from graphkin.say.linkages import amount, kind_name, titled
from graphkin.say.numbers import angle as degrees
from graphkin.say.numbers import number
from graphkin.sheet.layout import divided, papers_for
from graphkin.sheet.linkage_angles import dimensioned_limits, dimensioned_transmission
from graphkin.sheet.linkage_figure import drawn_over, pictured
from graphkin.sheet.linkage_table import linkage_tables
from graphkin.sheet.page import Page, Panel, Sheet
from graphkin.sheet.paper import Room
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.titleblock import Strip, strip_height
from graphkin.sheet.window import Figure, Window
from graphkin.studies.linkages import Report
from graphkin.studies.linkages.linkage import LinkagePosition

_ON_A4 = 2
"""So many linkages are drawn on A4."""
_CAPTION = 22.0
"""Room for a caption of four lines under each figure [mm]."""


def limit_sheet(reports: Sequence[Report], lang: Lang = "en", *, paper: str | None = None, title: str = "") -> Sheet:
    """The sheet of the linkages of a mechanism, or of one by itself: a row of figures each, at one scale.

    paper   a key of `PAPERS`; A4 on its side where left out, A3 for three linkages and more
    title   of the title block; the kind of the first where left out

    Raises UnknownPaper.
    """
    chosen = papers_for(paper or ("A4-landscape" if len(reports) <= _ON_A4 else "A3-landscape"))[0]
    rows, tables = [_pictures(report, lang, len(reports) > 1) for report in reports], linkage_tables(reports)
    field, foot = divided(chosen, strip_height(chosen, tables))
    placed = _placed(rows, field, chosen.landscape)
    panels = [panel for row in placed for panel in _panels(row, len(rows) > 1)]
    machine = titled(reports[0].linkage, title or kind_name(reports[0], lang))
    drivers = [driver.value or 0.0 for driver in machine.drivers]
    return Page(chosen, panels, machine, drivers, lang, Strip(foot, tables)).sheet()


def _placed(rows: Sequence[list[Picture]], field: Room, landscape: bool) -> Iterator[list[tuple[Picture, Room]]]:
    """Each figure with its cell: a row a linkage; a single one's over one another on upright paper."""
    for pictures, row in zip(rows, field.cells(len(rows), 1), strict=True):
        columns = 1 if len(rows) == 1 and not landscape else len(pictures)
        yield list(zip(pictures, row.cells(len(pictures), columns), strict=True))


def _panels(row: list[tuple[Picture, Room]], told: bool) -> Iterator[Panel]:
    """A linkage's figures at one scale; with `told`, which the captions give."""
    scale = max(picture.scale(cell) for picture, cell in row)
    for picture, cell in row:
        shown = picture.captioned(f"(1:{scale * 1e3:g}) ") if told else picture
        yield shown.panel(cell, scale)


# --- what is drawn ------------------------------------------------------------------------------


def _pictures(report: Report, lang: Lang, several: bool) -> list[Picture]:
    """With `several`, captions begin with the letters of the linkage."""
    found = []
    if report.limits:
        found.append(_limits(report, lang))
    if report.critical and report.gamma_min is not None and not report.level:
        found.append(_transmission(report, lang))
    if not found:
        ends, name = report.critical[:2], kind_name(report, lang)
        found.append(pictured(ends, lambda window: drawn_over(report.linkage, ends, window), _caption(name)))
    name = "".join(report.linkage.names)
    return [one.captioned(f"{name}: ") for one in found] if several else found


def _caption(*texts: str) -> Caption:
    return Caption(texts, _CAPTION)


def _limits(report: Report, lang: Lang) -> Picture:
    def draw(window: Window) -> Figure:
        return _over(drawn_over(report.linkage, report.limits, window), dimensioned_limits(report, window))

    return pictured(report.limits, draw, _caption(*_limit_caption(report, lang)))


def _transmission(report: Report, lang: Lang) -> Picture:
    shown = _shown(report)

    def draw(window: Window) -> Figure:
        angles = dimensioned_transmission(report, shown, window)
        return _over(drawn_over(report.linkage, shown, window, primes=True), angles)

    return pictured(shown, draw, _caption(*_gamma_caption(report, lang)))


def _over(linkage: Figure, angles: Figure) -> Figure:
    """The linkage over the arcs, its letters before theirs."""
    return Figure(angles.marks + linkage.marks, linkage.wanted + angles.wanted)


def _shown(report: Report) -> tuple[LinkagePosition, ...]:
    """The position of the least transmission angle first, and one to compare it with."""
    least = report.least[0]
    others = [end for end in report.critical if end is not least]
    return (least, *others[:1])


_WORDS: dict[str, dict[Lang, str]] = {
    "limits": {"en": "Limit positions of {output}", "zh": "{output} 的极限位置"},
    "k": {"en": "K = (180° + θ)/(180° − θ) = {k}", "zh": "K = (180° + θ)/(180° − θ) = {k}"},
    "timed": {"en": "K = {k} (crank {crank})", "zh": "K = {k}（曲柄 {crank}）"},
    "one": {"en": "θ = 0, K = 1: no quick return", "zh": "θ = 0，K = 1，无急回特性"},
    "dead": {"en": "dead points where {driver} drives: {values}", "zh": "{driver} 主动时的死点：{values}"},
    "none": {"en": "no dead point where {driver} drives", "zh": "{driver} 主动时无死点"},
    "gamma": {"en": "Transmission angle, {driver} driving", "zh": "传动角（{driver} 主动）"},
    "least": {
        "en": "γ_min = {gamma}, α_max = {alpha}, at {letter}_{driver} = {values}",
        "zh": "γ_min = {gamma}，α_max = {alpha}，此时 {letter}_{driver} = {values}",
    },
}


def _degrees(angle: float) -> str:
    return degrees(angle)


def _limit_caption(report: Report, lang: Lang) -> tuple[str, ...]:
    found = [_WORDS["limits"][lang].format(output=report.output)]
    if report.k is not None:
        key = "timed" if report.timed_by else "one" if report.slow is None else "k"
        found.append(_WORDS[key][lang].format(k=number(report.k, digits=5), crank=report.timed_by))
    other = [name for name in report.dead if name != report.driver][:1]
    return (*found, *(_dead(report, name, lang) for name in other))


def _gamma_caption(report: Report, lang: Lang) -> tuple[str, ...]:
    values = ", ".join(amount(report, end.driver) for end in report.least)
    words = {"gamma": _degrees(report.gamma_min or 0.0), "alpha": _degrees(report.alpha_max or 0.0)}
    found = [_WORDS["gamma"][lang].format(driver=report.driver)]
    letter = "s" if report.driver == report.slide else "φ"
    found.append(_WORDS["least"][lang].format(**words, letter=letter, driver=report.driver, values=values))
    return (*found, *([_dead(report, report.driver, lang)] if report.driver in report.dead else []))


def _dead(report: Report, driver: str, lang: Lang) -> str:
    values = report.dead[driver]
    slides = driver == report.slide
    said = ", ".join(f"{round(value * 1e3, 6) + 0.0:.5g} mm" if slides else _degrees(value) for value in values)
    said = said.replace("-", "−")
    return _WORDS["dead" if values else "none"][lang].format(driver=driver, values=said)
