"""From a path to a text, and from a text to plain TOML data with the line of every key."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path as FilePath
from typing import Any

from graphkin.errors import (
    BrokenToml,
    EmptyFile,
    FileTooLarge,
    IsFolder,
    NoFile,
    NotUtf8,
    TooDeep,
    Unreadable,
    Where,
)
from graphkin.loading.names import tidy
from graphkin.loading.positions import Path, positions

__all__ = ["LARGEST_FILE", "decoded", "read_text", "read_toml"]

LARGEST_FILE = 1_000_000
"""Mechanism files have some hundred bytes; more than this many are refused."""

_PLACE = re.compile(r"\s*\(at (?:line ([0-9]+), column [0-9]+|end of document)\)$")


def read_text(path: FilePath) -> str:
    """The file's text."""
    where = Where(str(path))
    try:
        if path.is_dir():
            raise IsFolder(where)
        with path.open("rb") as stream:
            content = stream.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise NoFile(where, path.name, _beside(path)) from None
    except (OSError, ValueError) as problem:
        raise Unreadable(where, getattr(problem, "strerror", None) or str(problem)) from None
    return decoded(content, where.file)


def decoded(content: bytes, file: str) -> str:
    """The text of a file's bytes; a byte order mark is not part of it."""
    _check_size(len(content), file)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        raise NotUtf8(Where(file, line)) from None


def read_toml(text: str, file: str) -> tuple[dict[str, Any], dict[Path, int]]:
    """The data, and the line of each key (primes in keys tidied in the paths)."""
    _check_size(len(text), file)
    text = text.removeprefix("\ufeff")
    try:
        document = tomllib.loads(text)
        lines = positions(text)
    except RecursionError:
        raise TooDeep(Where(file)) from None
    except ValueError as problem:
        raise _broken(str(problem), text, file) from None
    if not document:
        raise EmptyFile(Where(file))
    return document, {_tidied(path): line for path, line in lines.items()}


def _broken(reason: str, text: str, file: str) -> BrokenToml:
    place = _PLACE.search(reason)
    line = None
    if place is not None:
        line = int(place[1]) if place[1] else text.rstrip("\n").count("\n") + 1
    return BrokenToml(Where(file, line), _PLACE.sub("", reason))


def _beside(path: FilePath) -> tuple[str, ...]:
    """The mechanism files of the same folder."""
    try:
        return tuple(sorted(other.name for other in path.parent.glob("*.toml")))
    except OSError:
        return ()


def _check_size(size: int, file: str) -> None:
    if size > LARGEST_FILE:
        raise FileTooLarge(Where(file), LARGEST_FILE / 1e6)


def _tidied(path: Path) -> Path:
    return tuple(tidy(part) if isinstance(part, str) else part for part in path)
