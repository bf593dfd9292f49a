"""Sheets of one mechanism at several positions as one moving SVG."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.outputs.svg import svg
from graphkin.sheet import Sheet

SECONDS = 8.0


def animation(frames: Sequence[Sheet], seconds: float = SECONDS) -> str:
    """One SVG that shows the frames in turn, again and again (SMIL); a still viewer shows the first.

    What all frames have in common stands in it once.
    """
    first = frames[0]
    common = [mark for mark in first.marks if all(mark in frame.marks for frame in frames[1:])]
    head, body, foot = _parts(first.redrawn(lambda mark: mark if mark in common else None))
    groups = []
    for number, frame in enumerate(frames):
        own = frame.redrawn(lambda mark: None if mark in common else mark)
        groups.append(_group(number, len(frames), seconds, _parts(own)[1]))
    return head + body + "".join(groups) + foot


def _parts(sheet: Sheet) -> tuple[str, str, str]:
    """An SVG's text up to its first mark; its marks, with the arrow heads they need; its end."""
    text = svg(sheet)
    start = text.index("</metadata>") + len("</metadata>")
    end = text.rindex("</svg>")
    return text[:start], text[start:end], text[end:]


def _group(number: int, count: int, seconds: float, body: str) -> str:
    """The marks of one frame, seen for its share of the time."""
    start, end = f"{number / count:.6f}", f"{(number + 1) / count:.6f}"
    if count == 1:
        return f"<g>{body}</g>"
    values, keys = ("hidden;visible;hidden", f"0;{start};{end}") if number else ("visible;hidden", f"0;{end}")
    if number == count - 1:
        values, keys = "hidden;visible", f"0;{start}"
    state = "hidden" if number else "visible"
    return (
        f'<g visibility="{state}"><animate attributeName="visibility" values="{values}" keyTimes="{keys}" '
        f'calcMode="discrete" dur="{seconds:g}s" repeatCount="indefinite"/>{body}</g>'
    )
