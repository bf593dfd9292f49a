"""The pole of a body from two of its velocities, constructed on paper: perpendiculars, or similar triangles."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Link, Mechanism
from graphkin.say.catalogue import in_both
from graphkin.say.centre_about import pole_words
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.layout import divided, papers_for
from graphkin.sheet.lettering import Run, number, plain, point_label, quantity_label
from graphkin.sheet.marks import Disc, Place, Stroke
from graphkin.sheet.page import Page, Sheet
from graphkin.sheet.paper import finest
from graphkin.sheet.single_figure import Caption, Picture
from graphkin.sheet.symbols import SWEEP, arrow_head, spin
from graphkin.sheet.titleblock import Strip, Table, strip_height
from graphkin.sheet.window import Entry, Extent, Figure, Window
from graphkin.studies.centres.two_velocities import TwoVelocities

_ARROW = 45.0  # the greater velocity is drawn no longer than this [mm]
_BEYOND = 12.0  # the length of lines past their points [mm]; a line that meets none, so much more
_SQUARE, _RADIUS = 2.2, 9.0
_FOOT = 24.0  # room for what is said under the figure [mm]


def pole_sheet(velocities: TwoVelocities, lang: Lang = "en", *, paper: str | None = None) -> Sheet:
    """Raises UnknownPaper."""
    chosen = papers_for(paper or "A4-landscape")[0]
    fastest = max(map(abs, velocities.velocities))
    speed = finest(complex(fastest, fastest), complex(_ARROW, _ARROW))

    def draw(window: Window) -> Figure:
        return Figure.of(_entries(velocities, window, speed))

    places = [*velocities.points, *([velocities.place] if cmath.isfinite(velocities.place) else [])]
    caption = Caption(tuple(pole_words(velocities, lang)), _FOOT)
    far = plain("\u221e" if cmath.isinf(velocities.place) else "")
    rows = [(quantity_label("ω", ""), (*number(abs(velocities.omega)), Run(" rad/s")))]
    if cmath.isfinite(velocities.place):
        at = (("x", velocities.place.real), ("y", velocities.place.imag))
        rows = [*((quantity_label(letter, "P"), (*number(value * 1e3), Run(" mm"))) for letter, value in at), *rows]
    tables = [Table((quantity_label("P", ""), far), tuple(rows))]
    field, foot = divided(chosen, strip_height(chosen, tables))
    picture = Picture(Extent.of(places, draw), draw, caption)
    strip = Strip(foot, tables, further={"velocity": speed} if fastest else {})
    title = in_both("about.pole title")
    machine = Mechanism("velocities", "1", {FRAME: Link(FRAME, {})}, title=title, file="velocities")
    return Page(chosen, [picture.panel(field, picture.scale(field))], machine, (), lang, strip).sheet()


def _entries(velocities: TwoVelocities, window: Window, speed: float) -> Iterator[Entry]:
    pole = window(velocities.place) if cmath.isfinite(velocities.place) else None
    ends = [window(point) for point in velocities.points]
    tips = [end + velocity.conjugate() / speed for end, velocity in zip(ends, velocities.velocities, strict=True)]
    if velocities.case == "similar" and pole is not None:
        yield _line([*ends, pole])
        yield _line([*tips, pole])
    elif velocities.case in ("meet", "infinity"):
        for end, tip in zip(ends, tips, strict=True):
            if abs(tip - end) < 1:
                continue
            along = (tip - end) / abs(tip - end)  # the perpendicular of a velocity, with its right angle
            side = along * 1j if pole is None or ((along * 1j).conjugate() * (pole - end)).real > 0 else along * -1j
            reach = _BEYOND * 4 if pole is None else abs(pole - end) + _BEYOND
            yield Stroke((end, end + side * reach), "construction")
            yield Stroke(tuple(end + off * _SQUARE for off in (along, along + side, side)), "construction")
    yield Stroke((ends[0], ends[1]), "visible")
    for name, end, tip in zip(velocities.names, ends, tips, strict=True):
        yield Disc(end, 0.6, "outline", "ink")
        yield LabelRequest(point_label(name), end, gap=0.9, away=end - tip)
        if abs(tip - end) > 1:
            along = (tip - end) / abs(tip - end)
            yield Stroke((end, tip - 2 * along), "vector", accent="velocity")
            yield replace(arrow_head(tip, along, None), accent="velocity")
            yield LabelRequest(quantity_label("v", name), end, tip)
    if pole is not None:
        yield Disc(pole, 0.9, "outline", "paper")
        yield LabelRequest(quantity_label("P", ""), pole, gap=1.2, away=pole - ends[0])
        if velocities.omega:
            start, sense = cmath.rect(1, math.radians(30)), math.copysign(1, velocities.omega)
            yield from spin(pole, start, sense, _RADIUS)
            middle = start * cmath.rect(1, -sense * SWEEP / 2)
            yield LabelRequest(quantity_label("ω", ""), pole + middle * _RADIUS, gap=0.9, away=middle)


def _line(places: list[Place]) -> Stroke:
    """Through places on one line, and on past them."""
    one, other = max(((a, b) for a in places for b in places), key=lambda pair: abs(pair[1] - pair[0]))
    beyond = (other - one) / (abs(other - one) or 1) * _BEYOND
    return Stroke((one - beyond, other + beyond), "construction")
