"""On which line each key of a TOML text stands, list items included.

`tomllib` gives values without their places, so a second, simpler walk over the same text finds them. It may
only be given a text that `tomllib` has accepted, and relies on that: it checks nothing.
"""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_right
from collections.abc import Callable

Path = tuple[str | int, ...]
"""A key's way from the top: `("slide", 0, "angle")`."""

_BLANK = r"(?:[ \t\r\n]|#[^\n]*)*"
_SPACE = r"[ \t]*"
_BARE = r"[A-Za-z0-9_-]+"
_PLAIN = r"[^,\]}#\n]+"
_STRING = r'(?s:"""(?:\\.|[^\\])*?"{3,5}' r"|'''.*?'{3,5}" r'|"(?:\\.|[^"\\])*"' r"|'[^']*')"


def positions(text: str) -> dict[Path, int]:
    """Key -> line, counted from 1."""
    starts = [0, *(match.end() for match in re.finditer("\n", text))]
    return {path: bisect_right(starts, offset) for path, offset in _TextWalk(text).offsets().items()}


def values(text: str) -> tuple[dict[Path, tuple[int, int]], dict[Path, int]]:
    """Where each value begins and ends, and where the last thing ends that each table with a header has."""
    walk = _TextWalk(text)
    walk.offsets()
    return walk.values, walk.ends


class _TextWalk:
    """One walk over a text; `found` maps each key to the offset where it first stands."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.found: dict[Path, int] = {}
        self.counts: dict[Path, int] = {}
        """How many times each [[table]] has stood so far, less one."""
        self.values: dict[Path, tuple[int, int]] = {}
        self.ends: dict[Path, int] = {}

    def offsets(self) -> dict[Path, int]:
        base: Path = ()
        at = self._after(_BLANK, 0)
        while at < len(self.text):
            if self.text[at] == "[":
                base, at = self._header(at)
            else:
                at = self._pair(at, base)
            self.ends[base] = at
            at = self._after(_BLANK, at)
        return self.found

    def _header(self, at: int) -> tuple[Path, int]:
        """`[links.1]` or `[[slide]]`: the path of what follows."""
        brackets = 2 if self.text.startswith("[[", at) else 1
        keys, end = self._keys(at + brackets)
        for n in range(1, len(keys)):
            self._note(self._resolved(keys[:n]), at)
        path: Path = (*self._resolved(keys[:-1]), keys[-1])
        if brackets == 2:
            self._note(path, at)
            self.counts[path] = self.counts.get(path, -1) + 1
        path = self._resolved(keys)
        self._note(path, at)
        return path, end + brackets

    def _resolved(self, keys: list[str]) -> Path:
        """The path of a header: the last item of each [[table]] on the way is meant."""
        path: Path = ()
        for key in keys:
            path = (*path, key)
            if path in self.counts:
                path = (*path, self.counts[path])
        return path

    def _pair(self, at: int, base: Path) -> int:
        keys, end = self._keys(at)
        path = base
        for key in keys:
            path = (*path, key)
            self._note(path, at)
        return self._value(end + 1, path)

    def _keys(self, at: int) -> tuple[list[str], int]:
        """A dotted key, and where it ends."""
        keys: list[str] = []
        while True:
            at = self._after(_SPACE, at)
            quoted = self.text[at] in "\"'"
            end = self._after(_STRING if quoted else _BARE, at)
            part = self.text[at:end]
            keys.append(str(tomllib.loads(f"key = {part}")["key"]) if quoted else part)
            at = self._after(_SPACE, end)
            if self.text[at] != ".":
                return keys, at
            at += 1

    def _value(self, at: int, path: Path) -> int:
        at = self._after(_SPACE, at)
        end = self._end_of(at, path)
        self.values[path] = at, at + len(self.text[at:end].rstrip())
        return end

    def _end_of(self, at: int, path: Path) -> int:
        match self.text[at]:
            case '"' | "'":
                return self._after(_STRING, at)
            case "[":
                return self._items(at + 1, "]", lambda item, n: self._item(item, (*path, n)))
            case "{":
                return self._items(at + 1, "}", lambda item, _: self._pair(item, path))
            case _:
                return self._after(_PLAIN, at)

    def _item(self, at: int, path: Path) -> int:
        self._note(path, at)
        return self._value(at, path)

    def _items(self, at: int, close: str, read: Callable[[int, int], int]) -> int:
        """What stands between brackets, separated by commas."""
        at, n = self._after(_BLANK, at), 0
        while self.text[at] != close:
            at, n = self._after(_BLANK, read(at, n)), n + 1
            if self.text[at] == ",":
                at = self._after(_BLANK, at + 1)
        return at + 1

    def _note(self, path: Path, at: int) -> None:
        self.found.setdefault(path, at)

    def _after(self, pattern: str, at: int) -> int:
        match = re.compile(pattern).match(self.text, at)
        return at if match is None else match.end()
