"""Files as bytes: archives, never unpacked to disk and read as far as is allowed; and text in any usual encoding."""

from __future__ import annotations

import codecs
import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO
from zipfile import BadZipFile, ZipFile, ZipInfo

from graphkin.errors import BrokenSubmission, GraphkinError, TooMuch, WantsExtra, Where
from graphkin.submissions.submission import Limits

_JUNK = ("__MACOSX/", ".DS_Store", "Thumbs.db", "desktop.ini")
_FLAG_UTF8, _FLAG_LOCKED = 0x800, 0x1
_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
_PIECE = 1 << 16


@contextmanager
def foreign(where: Where, kind: str, package: str = "") -> Iterator[None]:
    """A file read by another's package, which raises whatever it meets in one that is broken. Raises WantsExtra,
    BrokenSubmission."""
    try:
        yield
    except ImportError:
        raise WantsExtra(where, kind, package) from None
    except (MemoryError, GraphkinError):
        raise
    except Exception as problem:
        raise BrokenSubmission(where, kind, type(problem).__name__) from None


_PILES = (".pdf", ".jpg", ".jpeg", ".png")  # in which the pictures of a whole class may be


def opened(source: bytes | Path, where: Where) -> ZipFile:
    """Raises BrokenSubmission."""
    try:
        return ZipFile(io.BytesIO(source) if isinstance(source, bytes) else source)
    except (BadZipFile, OSError, ValueError, NotImplementedError, OverflowError) as problem:
        raise BrokenSubmission(where, "ZIP", str(problem)[:80]) from None


def checked_zip(content: bytes, where: Where, limits: Limits) -> None:
    """Raises TooMuch, BrokenSubmission for a file that is a zip inside (.xlsx, .ggb) and beyond the limits, or whose
    members are larger than they say: a bomb is packed behind a small number."""
    with opened(content, where) as archive:
        infos = archive.infolist()
        if len(infos) > limits.parts:
            raise TooMuch(where, "members", limits.parts)
        if sum(info.file_size for info in infos) > 16 * limits.bytes:
            raise TooMuch(where, "archive", 16 * limits.bytes)
        for info in infos:
            _check_ratio(info, where, limits)
            with foreign(where, "ZIP"), archive.open(info) as stream:
                left = info.file_size + 1
                while left > 0 and (piece := stream.read(min(left, 1 << 20))):
                    left -= len(piece)


def members(archive: ZipFile, where: Where, limits: Limits) -> Iterator[ZipInfo]:
    """The files in it. Raises TooMuch."""
    infos = archive.infolist()
    limits.check(where, "members", sum(not info.is_dir() for info in infos))
    if sum(info.file_size for info in infos) > limits.archive_bytes:
        raise TooMuch(where, "archive", limits.archive_bytes)
    archive.NameToInfo.clear()  # of a large class that is much, and no member is asked for by its name
    for info in infos:
        if info.is_dir():
            continue
        name = member_name(info)
        if not any(part in name for part in _JUNK) and not name.rpartition("/")[2].startswith("._"):
            yield info


def member_name(info: ZipInfo) -> str:
    """Its name as its maker wrote it: archives that say no encoding hold UTF-8 or GBK."""
    if info.flag_bits & _FLAG_UTF8 or info.filename.isascii():
        return info.filename
    try:
        raw = info.filename.encode("cp437")
    except UnicodeEncodeError:
        return info.filename
    for encoding in ("utf-8", "gb18030"):
        try:
            return raw.decode(encoding)
        except UnicodeDecodeError:
            continue
    return info.filename


def content(stream: IO[bytes], name: str, where: Where, limits: Limits) -> bytes:
    """All of a file. Raises TooMuch."""
    most = limits.pile_bytes if name.lower().endswith(_PILES) else limits.bytes
    if len(whole := stream.read(most + 1)) > most:
        raise TooMuch(where, "bytes", most)
    return whole


def read_member(archive: ZipFile, info: ZipInfo, where: Where, limits: Limits) -> bytes:
    """Its bytes. Raises TooMuch, BrokenSubmission."""
    if info.flag_bits & _FLAG_LOCKED:
        raise BrokenSubmission(where, "ZIP", "password")
    _check_ratio(info, where, limits)
    with foreign(where, "ZIP"), archive.open(info) as stream:
        return content(stream, info.filename, where, limits)


def _check_ratio(info: ZipInfo, where: Where, limits: Limits) -> None:
    if info.file_size > 100_000 and info.file_size > limits.ratio * max(1, info.compress_size):
        raise TooMuch(where, "ratio", limits.ratio)


def decoded(content: bytes, where: Where) -> str:
    """The text of a whole file. Raises BrokenSubmission for what is text in none of these."""
    try:
        return content.decode(_encoding(io.BytesIO(content)))
    except UnicodeDecodeError:
        raise BrokenSubmission(where, "text") from None


def lines_of(stream: IO[bytes], where: Where) -> Iterator[str]:
    """Line after line of a seekable stream, in flat memory; lines far too long are given in pieces."""
    with io.TextIOWrapper(stream, _encoding(stream), newline="") as text:
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
