"""DXF by ezdxf: lines, points, circles and texts, blocks taken apart; in mm by the drawing's own unit."""

from __future__ import annotations

import cmath
import io
import math
import re
from collections.abc import Iterator
from typing import Any

from graphkin.errors import BrokenSubmission, TooMuch, Where
from graphkin.submissions.archives import foreign
from graphkin.submissions.picture import Dot, Line, PagePicture, PictureText
from graphkin.submissions.submission import Limits

_Dxf = Any  # a document or an entity of ezdxf
_MM = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 14: 100.0}  # by $INSUNITS: unitless counts as mm
_WIDE = 0.8  # a letter's width in parts of its height
_STACK = re.compile(r"\\S([^;^#/\\]*)\^ ?([^;\\]*);")
"""A raised and a lowered piece of a text, one of which may be empty."""
_Mark = Line | Dot | PictureText


def read_dxf(content: bytes, where: Where, limits: Limits) -> PagePicture:
    """Raises WantsExtra, BrokenSubmission, TooMuch."""
    with foreign(where, "DXF", "ezdxf"):
        from ezdxf import recover

        if content.count(b"\n") > 60 * limits.elements:
            raise TooMuch(where, "elements", limits.elements)
        document, _ = recover.read(io.BytesIO(content))
        reader = _DxfReader(document, where, limits)
        marks = [mark for entity in document.modelspace() for mark in reader.marks(entity, 0)]
    if not marks:
        raise BrokenSubmission(where, "DXF")
    lines, dots = (m for m in marks if isinstance(m, tuple)), (m for m in marks if isinstance(m, Dot))
    return PagePicture(tuple(lines), tuple(dots), tuple(m for m in marks if isinstance(m, PictureText)))


class _DxfReader:
    """Walks the entities once; blocks are followed as often as the limits allow."""

    def __init__(self, document: _Dxf, where: Where, limits: Limits) -> None:
        self.where, self.limits = where, limits
        self.mm = _MM.get(int(document.header.get("$INSUNITS", 0) or 0), 1.0)
        self.walked = 0
        self.hidden = {layer.dxf.name.lower() for layer in document.layers if layer.is_off() or layer.is_frozen()}

    def marks(self, entity: _Dxf, depth: int) -> Iterator[_Mark]:
        self.walked += 1
        self.limits.check(self.where, "elements", self.walked)
        if entity.dxf.get("layer", "0").lower() in self.hidden or entity.dxf.get("invisible", 0):
            return
        match entity.dxftype():
            case "INSERT":  # the marks of a block where it is put, its attributes too
                if depth > min(self.limits.depth, 20):
                    raise TooMuch(self.where, "depth", min(self.limits.depth, 20))
                self.limits.check(self.where, "copies", entity.mcount)
                for single in entity.multi_insert() if entity.mcount > 1 else (entity,):
                    for inner in single.virtual_entities():
                        yield from self.marks(inner, depth + 1)
                for attribute in entity.attribs:
                    yield from self.marks(attribute, depth + 1)
            case "LINE":
                yield self._place(entity.dxf.start), self._place(entity.dxf.end)
            case "LWPOLYLINE" | "POLYLINE":
                lines = (piece for piece in entity.virtual_entities() if piece.dxftype() == "LINE")
                yield from (mark for piece in lines for mark in self.marks(piece, 0))
            case "POINT":
                yield Dot(self._place(entity.dxf.location))
            case "CIRCLE":
                yield Dot(self._place(entity.ocs().to_wcs(entity.dxf.center)))
            case "TEXT" | "ATTRIB":
                yield from self._text(entity)
            case "MTEXT":
                yield from self._mtext(entity)
            case _:
                pass

    def _place(self, point: _Dxf) -> complex:
        place = complex(point.x, point.y) * self.mm
        if not (cmath.isfinite(place) and abs(place) < 1e9):
            raise BrokenSubmission(self.where, "DXF", "coordinates")
        return place

    def _text(self, entity: _Dxf) -> Iterator[PictureText]:
        """From where it is aligned to its left end, along its own line."""
        letters = entity.plain_text().strip()
        placement = entity.get_placement()
        anchor = self._place(entity.ocs().to_wcs(placement[1]))
        ocs, turned = entity.ocs(), math.radians(entity.dxf.get("rotation", 0.0))
        axes = (math.cos(turned), math.sin(turned), 0), (-math.sin(turned), math.cos(turned), 0)
        right, up = (complex(at[0], at[1]) for at in map(ocs.to_wcs, axes))  # its line and across it
        right, up = right / (abs(right) or 1.0), up / (abs(up) or 1.0)
        tall = float(entity.dxf.height) * self.mm
        width = _WIDE * tall * len(letters) * float(entity.dxf.get("width", 1.0) or 1.0)
        name = placement[0].name
        left = 0.0 if name.endswith("LEFT") or name == "LEFT" else width if name.endswith("RIGHT") else width / 2
        low = tall if name.startswith("TOP") else tall / 2 if name.startswith("MIDDLE") else 0.0
        if letters:
            yield PictureText(letters[:400], anchor - left * right - low * up, right, up, width, tall, 0.25 * tall)

    def _mtext(self, entity: _Dxf) -> Iterator[PictureText]:
        """A text of pieces, `v^n_CD`, as people write it; MTEXT has a caret and a blank for a caret."""
        from ezdxf.tools.text import fast_plain_mtext

        def one_line(stack: re.Match[str]) -> str:
            raised, lowered = (piece.strip() for piece in stack.groups())
            return (f"^ {raised}" if raised else "") + (f"_{lowered}" if lowered else "")

        letters = " ".join(str(fast_plain_mtext(_STACK.sub(one_line, entity.text))).split())
        tall = float(entity.dxf.char_height) * self.mm
        width = _WIDE * tall * len(re.sub("[_^]", "", letters))
        direction = entity.dxf.text_direction if entity.dxf.hasattr("text_direction") else None
        degrees = entity.get_rotation() if direction is None else math.degrees(math.atan2(direction.y, direction.x))
        right = cmath.rect(1, math.radians(degrees))
        row, column = divmod(int(entity.dxf.attachment_point) - 1, 3)
        corner = self._place(entity.dxf.insert) - right * width * column / 2 - 1j * right * tall * (1, 0.5, 0)[row]
        if letters:
            yield PictureText(letters[:400], corner, right, 1j * right, width, tall, 0.25 * tall)
