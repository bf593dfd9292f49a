"""Linkages on one sheet: limits and extreme transmission angles as textbooks draw them, or the family of kinds.

On the left both limit positions over each other (the second thin) with psi or H and theta; on the right the
positions between which the transmission angle lies. Both at one true scale.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial

from graphkin.errors import Lang
from graphkin.say import numbers
from graphkin.say.linkages import amount, kind_name, titled
from graphkin.sheet.layout import papers_for
from graphkin.sheet.lettering import Label, Run, number, plain, point_label, points_label, quantity_label, width
from graphkin.sheet.linkage_figure import dimensioned_limits, dimensioned_transmission, drawn_over, pictured
from graphkin.sheet.marks import Text
from graphkin.sheet.page import Panel, Sheet
from graphkin.sheet.paper import TITLE
from graphkin.sheet.single_figure import Caption, Picture, SheetGrid, panels_in
from graphkin.sheet.titleblock import Table, frame
from graphkin.sheet.window import Figure, Window
from graphkin.studies.linkages import FAMILY, Report, report

_ON_A4 = 2  # so many linkages are drawn on A4
_CAPTION = 22.0  # room for a caption of four lines under each figure [mm]
_COLUMNS, _HEAD, _FOOT = 4, 10.0, 13.0
"""Sketches of the family side by side; room for its title, and for the name under each sketch [mm]."""
_FAMILY: dict[Lang, str] = {"en": "Linkages of four links", "zh": "平面四杆机构的类型"}
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


def limit_sheet(reports: Sequence[Report], lang: Lang = "en", *, paper: str | None = None, title: str = "") -> Sheet:
    """The sheet of the linkages of a mechanism, or of one by itself: a row of figures each, at one scale.

    paper   a key of `PAPERS`; A4 on its side where left out, A3 for three linkages and more
    title   of the title block; the kind of the first where left out

    Raises UnknownPaper.
    """
    chosen = papers_for(paper or ("A4-landscape" if len(reports) <= _ON_A4 else "A3-landscape"))[0]
    heads = (tuple(run for name in one.linkage.names for run in point_label(name)) for one in reports)
    tables = [Table((head, ()), tuple(_rows(one))) for head, one in zip(heads, reports, strict=True)]
    grid, several = SheetGrid.over(chosen, tables), len(reports) > 1
    panels: list[Panel] = []
    for one, row in zip(reports, grid.field.cells(len(reports), 1), strict=True):
        pictures = _pictures(one, lang, several)
        columns = len(pictures) if several or chosen.landscape else 1
        cells = row.cells(len(pictures), columns)
        scale = max(picture.scale(cell) for picture, cell in zip(pictures, cells, strict=True))
        if several:
            pictures = [picture.captioned(f"(1:{scale * 1e3:g}) ") for picture in pictures]
        panels += panels_in(pictures, cells, scale)
    machine = titled(reports[0].linkage, title or kind_name(reports[0], lang))
    return grid.page(panels, machine, lang).sheet()


def family_sheet(lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Every kind of the family once: a sketch at a scale of its own, with its name. Raises UnknownPaper."""
    chosen, pictures = papers_for(paper or "A4-landscape")[0], list[Picture]()
    for member in FAMILY:
        linkage = member.linkage
        caption = Caption((kind_name(report(linkage), lang),), _FOOT)
        pictures.append(pictured([linkage.drawn], partial(drawn_over, linkage, [linkage.drawn]), caption))
    grid = SheetGrid(chosen, chosen.frame.inset(0, _HEAD, 0))
    panels = panels_in(pictures, grid.field.cells(len(pictures), _COLUMNS))
    title, room = plain(_FAMILY[lang]), chosen.frame
    head = Text(title, complex(room.middle.real - width(title, TITLE) / 2, room.top + 7.0), TITLE)
    machine = replace(titled(FAMILY[0].linkage), name="linkages", file="linkages.toml", text="")
    bare = [replace(panel, plane=None) for panel in panels]
    return grid.page(bare, machine, lang, base=[frame(chosen), head], title=_FAMILY[lang]).sheet()


def _pictures(one: Report, lang: Lang, several: bool) -> list[Picture]:
    """Limits and transmission angles; with `several`, captions begin with the letters of the linkage."""
    pictures = [_limits(one, lang)] if one.limits else []
    if one.critical and one.gamma_min is not None and not one.level:
        pictures.append(_transmission(one, lang))
    if not pictures:
        ends, caption = one.critical[:2], Caption((kind_name(one, lang),), _CAPTION)
        pictures.append(pictured(ends, partial(drawn_over, one.linkage, ends), caption))
    name = "".join(one.linkage.names)
    return [picture.captioned(f"{name}: ") for picture in pictures] if several else pictures


def _limits(one: Report, lang: Lang) -> Picture:
    def draw(window: Window) -> Figure:
        return _over(drawn_over(one.linkage, one.limits, window), dimensioned_limits(one, window))

    texts = [_WORDS["limits"][lang].format(output=one.output)]
    if one.k is not None:
        key = "timed" if one.timed_by else "one" if one.slow is None else "k"
        texts.append(_WORDS[key][lang].format(k=numbers.number(one.k, digits=5), crank=one.timed_by))
    texts += [_dead(one, name, lang) for name in one.dead if name != one.driver][:1]
    return pictured(one.limits, draw, Caption(tuple(texts), _CAPTION))


def _transmission(one: Report, lang: Lang) -> Picture:
    """The position of the least transmission angle first, and one to compare it with."""
    shown = (one.least[0], *[end for end in one.critical if end is not one.least[0]][:1])

    def draw(window: Window) -> Figure:
        angles = dimensioned_transmission(one, shown, window)
        return _over(drawn_over(one.linkage, shown, window, primes=True), angles)

    gamma, alpha = numbers.angle(one.gamma_min or 0.0), numbers.angle(one.alpha_max or 0.0)
    letter, values = "s" if one.driver == one.slide else "φ", ", ".join(amount(one, end.driver) for end in one.least)
    least = _WORDS["least"][lang].format(gamma=gamma, alpha=alpha, letter=letter, driver=one.driver, values=values)
    texts = [_WORDS["gamma"][lang].format(driver=one.driver), least]
    texts += [_dead(one, one.driver, lang)] if one.driver in one.dead else []
    return pictured(shown, draw, Caption(tuple(texts), _CAPTION))


def _over(linkage: Figure, angles: Figure) -> Figure:
    """The linkage over the arcs, its letters before theirs."""
    return Figure(angles.marks + linkage.marks, linkage.wanted + angles.wanted)


def _dead(one: Report, driver: str, lang: Lang) -> str:
    values, slides = one.dead[driver], driver == one.slide
    texts = (f"{round(value * 1e3, 6) + 0.0:.5g} mm" if slides else numbers.angle(value) for value in values)
    shown = ", ".join(texts).replace("-", "−")
    return _WORDS["dead" if values else "none"][lang].format(driver=driver, values=shown)


def _rows(one: Report) -> Iterator[tuple[Label, Label]]:
    for name, size in one.linkage.sizes.items():
        yield points_label(name), (*number(size * 1e3), Run(" mm"))
    amounts = (
        (quantity_label("ψ", ""), one.swing, "°"), (quantity_label("H", ""), one.stroke, " mm"),
        (quantity_label("θ", ""), one.theta, "°"), (quantity_label("K", ""), one.k, ""),
        ((Run("γ", True), Run("min", place="sub")), one.gamma_min, "°"),
        ((Run("α", True), Run("max", place="sub")), one.alpha_max, "°"),
    )  # fmt: skip
    for name_label, value, unit in amounts:
        if value is not None:
            shown = {"°": math.degrees(value), " mm": value * 1e3}.get(unit, value)
            yield name_label, (*number(shown), *((Run(unit),) if unit else ()))
