"""From a path to a text, and from a text to plain TOML data with the line of every key."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import cached_property, partial
from pathlib import Path
from typing import IO, TypeVar

from graphkin import errors
from graphkin.errors import Where
from graphkin.files.toml import Document, key_positions, tidied
from graphkin.files.values import tidy
from graphkin.model.mechanism import GivenValue, KeyPath

_T = TypeVar("_T")

LARGEST_FILE = 1_000_000  # mechanism files have some hundred bytes; more than this many are refused

_BLANKS = "\t\n\r"  # control characters that may stand in a text; there they are blanks
_WITHOUT_BLANKS = str.maketrans("", "", _BLANKS)
_WIDE_MARKS = (b"\xff\xfe", b"\xfe\xff")
_NO_XML = re.compile("[\ufffe\uffff]")

_PARTS = 32
_DEEP = rf"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{_PARTS}}}"""
"""A key of so many parts; thousands of them would cost gigabytes before anyone could refuse them."""

_PLACE = r"\s*\(at (?:line ([0-9]+), column [0-9]+|end of document)\)$"
_QUOTED = r"""\"[^"]*("|$)|'[^']*('|$)|#.*"""
"""Texts in quotes, to the end of the line where one is not closed, and remarks."""


def read_text(path: Path) -> str:
    """The file's text."""
    where = Where(str(path))
    try:
        if path.is_dir():
            raise errors.IsFolder(where)
        with path.open("rb") as stream:
            return decoded_text(read_bytes(stream, where.file), where.file)
    except FileNotFoundError:
        beside: list[str] = []  # the mechanism files of the same folder
        with suppress(OSError):
            beside = sorted(other.name for other in path.parent.glob("*.toml"))
        raise errors.NoFile(where, path.name, tuple(beside)) from None
    except (OSError, ValueError) as problem:
        raise errors.Unreadable(where, getattr(problem, "strerror", None) or str(problem)) from None


def read_bytes(stream: IO[bytes], file: str) -> bytes:
    """The bytes that come in, and no more of them than a mechanism file may have."""
    try:
        return stream.read(LARGEST_FILE + 1)
    except OSError as problem:
        raise errors.Unreadable(Where(file), problem.strerror or str(problem)) from None


def mechanism_name(path: Path) -> str:
    """The name of a mechanism after its file; a character that no text may hold becomes an underscore."""
    return "".join("_" if errors.steers(letter) else letter for letter in path.stem)


def decoded_text(content: bytes, file: str) -> str:
    """The text of a file's bytes; a byte order mark is not part of it."""
    _check_size(len(content), file)
    if content.startswith(_WIDE_MARKS) or b"\0" in content[:2]:  # without a mark
        raise errors.NotUtf8(Where(file), "UTF-16")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        raise errors.NotUtf8(Where(file, line), "") from None


class Deferred(Mapping[KeyPath, _T]):
    """A table of keys that is made when something of it is first read: of few files is it."""

    def __init__(self, make: Callable[[], Mapping[KeyPath, _T]]) -> None:
        self._make = make

    @cached_property
    def _table(self) -> Mapping[KeyPath, _T]:
        return self._make()

    def __getitem__(self, path: KeyPath) -> _T:
        return self._table[path]

    def __iter__(self) -> Iterator[KeyPath]:
        return iter(self._table)

    def __len__(self) -> int:
        return len(self._table)


def stated_in(text: str) -> dict[KeyPath, GivenValue]:
    """All that a mechanism file's text states, by place and in its order."""
    from graphkin.files.schema import stated_values

    return stated_values(tomllib.loads(text.removeprefix("\ufeff")))


def key_lines(text: str, file: str) -> dict[KeyPath, int]:
    """The line of each key of a text that `tomllib` accepts, counted from 1; primes in names are tidied."""
    try:
        return {tidied(path): line for path, line in key_positions(text).items()}
    except RecursionError:
        raise errors.TooDeep(Where(file)) from None


def read_toml(text: str, file: str) -> tuple[Document, Mapping[KeyPath, int]]:
    """The data, and the line of each key."""
    _check_size(len(text), file)
    text = text.removeprefix("\ufeff")
    if any(line.count(".") >= _PARTS and re.search(_DEEP, line) is not None for line in text.split("\n")):
        raise errors.TooDeep(Where(file))
    try:
        document = tomllib.loads(text)
        lines = Deferred(partial(key_lines, text, file))
        _refuse_control(document, lines, text, file)
    except RecursionError:
        raise errors.TooDeep(Where(file)) from None
    except ValueError as problem:
        reason, line = str(problem), None
        if (place := re.search(_PLACE, reason)) is not None:
            line = int(place[1]) if place[1] else text.rstrip("\n").count("\n") + 1
            stray = re.search(r"[^\x00-\x7f]", re.sub(_QUOTED, "", text.split("\n")[line - 1]))
            if stray is not None:
                code = f"U+{ord(stray.group()):04X}"
                raise errors.StrayLetter(Where(file, line), stray.group(), code) from None
        raise errors.BrokenToml(Where(file, line), re.sub(_PLACE, "", reason)) from None
    if not document:
        raise errors.EmptyFile(Where(file))
    return document, lines


def _refuse_control(document: Document, lines: Mapping[KeyPath, int], text: str, file: str) -> None:
    """Texts and names go to terminals, into XML, TeX and tables: no character in them may mean more than itself."""
    if (match := _NO_XML.search(text)) is not None:
        above = text.count("\n", 0, match.start())
        raise errors.ControlCharacter(Where(file, above + 1), f"U+{ord(match.group()):04X}")
    if "\\" not in text and text.translate(_WITHOUT_BLANKS).isprintable():
        return
    for path, word in _words(document, ()):
        if word.isprintable():
            continue
        bad = next((letter for letter in word if errors.steers(letter) and letter not in _BLANKS), None)
        if bad is not None:
            line = next((lines[path[:n]] for n in range(len(path), 0, -1) if path[:n] in lines), None)
            place = "".join(letter for letter in ".".join(map(str, path)) if not errors.steers(letter))
            raise errors.ControlCharacter(Where(file, line, place), f"U+{ord(bad):04X}")


def _words(value: object, path: KeyPath) -> Iterator[tuple[KeyPath, str]]:
    """Every key and every text of a document, with its place."""
    match value:
        case str():
            yield path, value
        case list():
            for number, item in enumerate(value):
                yield from _words(item, (*path, number))
        case dict():
            for key, item in value.items():
                yield (*path, tidy(key)), key
                yield from _words(item, (*path, tidy(key)))
        case _:
            pass


def _check_size(size: int, file: str) -> None:
    if size > LARGEST_FILE:
        raise errors.FileTooLarge(Where(file), LARGEST_FILE / 1e6)
