"""The page of feedback as a drawing: lines of text, and under them pictures; for platforms that take back drawings."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field

from graphkin.homework.platforms.feedback import Feedback, at_the_end, table, title, under_table
from graphkin.homework.platforms.marked_up import element, one_line
from graphkin.homework.platforms.result import ResultPicture

_SIZE, _STEP, _BETWEEN = 4.0, 6.0, 5.0
"""Of letters, of rows, between columns [mm]."""
_LEFT, _WIDTH, _ROOM = 10.0, 210.0, 184.0
_START = re.compile(r'<svg [^>]*?viewBox="0 0 ([\d.]+) ([\d.]+)"[^>]*>')
_SIZES = re.compile(r' (?:width|height)="[^"]*"')
_PIECE = re.compile("[\u2e80-\uffef]|[^\\s\u2e80-\uffef]+\\s*|\\s+")


def drawing(told: Feedback) -> bytes:
    """A drawing as wide as A4, as long as it needs."""
    page = _SvgPage()
    page.write(title(told))
    if told.result.lines:
        page.tabulate([*table(told)])
    for text in under_table(told):
        page.write(text)
    for picture in told.pictures:
        page.show(picture)
    for text in at_the_end(told):
        page.write(text)
    return page.whole()


@dataclass
class _SvgPage:
    """What is on it, and how far down it goes [mm]."""

    parts: list[str] = field(default_factory=list)
    top: float = _STEP

    def whole(self) -> bytes:
        high = f"{self.top + 2 * _STEP:g}"
        return (
            f'<?xml version="1.0" encoding="UTF-8"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}mm" '
            f'height="{high}mm" viewBox="0 0 {_WIDTH:g} {high}"><rect width="100%" height="100%" fill="#ffffff"/>\n'
            + "\n".join(self.parts) + "</svg>\n"
        ).encode()  # fmt: skip

    def write(self, text: str) -> None:
        """A text in as many rows as it needs."""
        for row in _broken(one_line(text)):
            self.top += _STEP
            self.letter(row, _LEFT)

    def letter(self, text: str, x: float, anchor: str = "start") -> None:
        place = {"x": f"{x:g}", "y": f"{self.top:g}", "text-anchor": anchor}
        made = element("text", text, **place, **{"font-size": f"{_SIZE:g}", "font-family": "sans-serif"})
        self.parts.append(ET.tostring(made, encoding="unicode"))

    def tabulate(self, rows: list[tuple[str, ...]]) -> None:
        """Columns side by side, numbers to the right."""
        rows = [tuple(map(one_line, row)) for row in rows]
        widths = [max(map(_width, column)) for column in zip(*rows, strict=True)]
        for row in rows:
            self.top += _STEP
            start = _LEFT
            for k, (text, width) in enumerate(zip(row, widths, strict=True)):
                words = k in (0, len(row) - 2)
                self.letter(text, start if words else start + width, "start" if words else "end")
                start += width + _BETWEEN
        self.top += _STEP / 2

    def show(self, picture: ResultPicture) -> None:
        """What is said of a drawing of graphkin's own, and the drawing; of another picture the words alone."""
        self.write(picture.label)
        if found := _START.match(drawn := picture.data.decode("utf-8", "replace")):
            self.top += _STEP
            size = f'<svg x="{_LEFT:g}" y="{self.top:g}" width="{found[1]}" height="{found[2]}" '
            self.parts.append(_SIZES.sub("", found[0]).replace("<svg ", size, 1) + drawn[found.end() :])
            self.top += float(found[2])


def _width(text: str) -> float:
    """About what a text takes [mm]; a Chinese letter is as wide as high."""
    return sum(_SIZE if ord(letter) > 0x2E7F else 0.53 * _SIZE for letter in text)


def _broken(text: str) -> Iterator[str]:
    """A text in rows, between words where there are some; a word longer than a row is broken."""
    row = ""
    for piece in _PIECE.findall(text):
        while _width(row + piece.rstrip()) > _ROOM:
            if not row:
                count = int(_ROOM / _SIZE)
                row, piece = piece[:count], piece[count:]
            yield row.rstrip()
            row = ""
        row += piece
    yield row.rstrip()
