"""The page of feedback as a drawing: lines of text, and under them pictures; for platforms that take back drawings."""

from __future__ import annotations

import io
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator

from graphkin.platforms.feedback import Feedback, lines, title
from graphkin.platforms.marked_up import element, one_line

_STEP = 6.0
_LEFT = 10
_WIDTH, _LETTERS = 210, 80
_START = re.compile(r'<svg [^>]*?viewBox="0 0 ([\d.]+) ([\d.]+)"[^>]*>')
_SIZE = re.compile(r' (?:width|height)="[^"]*"')


def drawing(told: Feedback) -> bytes:
    """A drawing as wide as A4, as long as it needs."""
    parts: list[str] = []
    top = _STEP
    for text in (title(told), *lines(told.result, told.lang, told.reveal)):
        top = _text(parts, text, top)
    for picture in told.pictures:
        top = _text(parts, picture.label, top) + _STEP
        if found := _START.match(drawn := picture.data.decode("utf-8", "replace")):
            size = f'<svg x="{_LEFT}" y="{top:g}" width="{found[1]}" height="{found[2]}" '
            parts.append(_SIZE.sub("", found[0]).replace("<svg ", size, 1) + drawn[found.end() :])
            top += float(found[2])
    height = f"{top + _STEP:g}"
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}mm" '
        f'height="{height}mm" viewBox="0 0 {_WIDTH} {height}">' + "\n".join(parts) + "</svg>\n"
    ).encode()


def _text(parts: list[str], text: str, top: float) -> float:
    """A text in rows under a place; the place under it."""
    for row in _broken(one_line(text)):
        top += _STEP
        place = {"x": str(_LEFT), "y": f"{top:g}", "font-size": "4", "font-family": "sans-serif"}
        parts.append(ET.tostring(element("text", row, **place), encoding="unicode"))
    return top


def _broken(told: str) -> Iterator[str]:
    """A text in rows; a Chinese letter is as wide as two others."""
    row, width = io.StringIO(), 0
    for letter in told:
        width += 2 if ord(letter) > 0x2E7F else 1
        if width > _LETTERS:
            yield row.getvalue()
            row, width = io.StringIO(), 2
        row.write(letter)
    yield row.getvalue()
