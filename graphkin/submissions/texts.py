"""Bytes into text, whatever program saved them: UTF-8 with or without its mark, UTF-16, GBK."""

from __future__ import annotations

import codecs
import io
from collections.abc import Iterator
from typing import IO

from graphkin.errors import BrokenSubmission, Where

_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
_PIECE = 1 << 16


def decoded(content: bytes, where: Where) -> str:
    """The text of a whole file. Raises BrokenSubmission for what is text in none of these."""
    try:
        return content.decode(_encoding(io.BytesIO(content)))
    except UnicodeDecodeError:
        raise BrokenSubmission(where, "text") from None


def lines_of(stream: IO[bytes], where: Where) -> Iterator[str]:
    """Line after line of a seekable stream, in flat memory; lines far too long are given in pieces."""
    encoding = _encoding(stream)
    with io.TextIOWrapper(stream, encoding, newline="") as text:
        try:
            while line := text.readline(_PIECE):
                yield line
        except UnicodeDecodeError:
            raise BrokenSubmission(where, "text") from None


def _encoding(stream: IO[bytes]) -> str:
    """Its mark says, or zeros at every second place; else UTF-8 if all of it is that, else GBK."""
    start = stream.read(_PIECE)
    stream.seek(0)
    for mark, encoding in _MARKS:
        if start.startswith(mark):
            return encoding
    if len(start) > 3 and 3 * start.count(0) > len(start):
        return "utf-16-le" if start[1] == 0 else "utf-16-be"
    decoder = codecs.getincrementaldecoder("utf-8")()
    try:
        while piece := stream.read(_PIECE):
            decoder.decode(piece)
        decoder.decode(b"", final=True)
        return "utf-8"
    except UnicodeDecodeError:
        return "gb18030"
    finally:
        stream.seek(0)
