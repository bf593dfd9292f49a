"""Positions that were found, drawn side by side."""

from __future__ import annotations

from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.running.other_positions import moved_to
from graphkin.say.finding import caption, lines
from graphkin.sheet import Sheet
from graphkin.sheet.gallery_sheet import MOST, side_by_side
from graphkin.studies.finding import Findings


def drawn(method: Method, found: Findings, lang: Lang = "en", *, paper: str | None = None) -> tuple[Sheet, int] | None:
    """The sheet, and how many positions found no room on it; None where no position was found that can be drawn.

    Raises UnknownPaper; DeadPoint or NotReached for a position that can be told but not drawn.
    """
    positions = found.shown or ((found.nearest,) if found.nearest is not None else ())
    if not positions:
        return None
    shown = positions[:MOST]
    plots = [moved_to(method, position.drivers) for position in shown]
    captions = [caption(found, position) for position in shown]
    slowest = {entry.position.t: entry for entry in found.slow}
    slow = [slowest.get(position.t) for position in shown]
    sheet = side_by_side(method, plots, captions, lang, paper=paper, told=[*lines(found, lang)], slow=slow)
    return sheet, len(positions) - len(shown)
