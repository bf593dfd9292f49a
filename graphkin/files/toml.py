"""TOML text: data written as mechanism files are laid out, where each key and value stands, other values put in.

`tomllib` gives values without their places, so a second, simpler walk over the same text finds them. It may only be
given a text that `tomllib` has accepted, and relies on that: it checks nothing.
"""

from __future__ import annotations

import copy
import json
import re
import tomllib
from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from datetime import date, datetime, time
from functools import lru_cache
from numbers import Integral, Real
from typing import Any, TypeAlias

from graphkin.errors import Where, WrongType
from graphkin.files.values import shown_value, tidy
from graphkin.model.mechanism import KeyPath

Document: TypeAlias = dict[str, Any]  # the data of a file, as `tomllib` gives them

_IN_A_LINE = ("title", "source", "text")  # tables of a text in each language
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def parsed(text: str) -> Document:
    """The data of a TOML text. Raises ValueError for a text that is none, RecursionError for one nested too deeply."""
    return tomllib.loads(text)


def toml(document: Mapping[str, object]) -> str:
    """The text of a mechanism's data: titles and questions, then a table with a header each.

    Numpy's numbers and arrays do, too, and a complex number for a place. Raises WrongType for a value that no TOML file
    can hold.

    >>> print(toml({"ask": ["v B"], "links": {"1": {"AB": 24}}, "driver": [{"vector": "AB", "omega": 10}]}))
    ask = ["v B"]
    <BLANKLINE>
    [links.1]
    AB = 24
    <BLANKLINE>
    [[driver]]
    vector = "AB"
    omega = 10
    <BLANKLINE>
    """
    plain = {name: value for name, value in document.items()
             if not _several(value) and (name in _IN_A_LINE or not isinstance(value, Mapping))}  # fmt: skip
    lines = [f"{key_text(name)} = {value_text(value, name)}" for name, value in plain.items()]
    for name, value in document.items():
        if name not in plain:
            lines += _with_header(name, value)
    return "\n".join(lines).lstrip("\n") + "\n"


def key_text(name: str) -> str:
    """A key, quoted where TOML wants it."""
    return str(name) if _BARE_KEY.fullmatch(str(name)) else value_text(str(name))


def value_text(value: object, place: str = "") -> str:
    """One value as it stands behind `=`; `place` is what a message calls it."""
    match value:
        case bool():
            return str(value).lower()
        case Integral():
            return str(int(value))
        case Real():
            return repr(float(value))
        case complex():
            return f"[{float(value.real)!r}, {float(value.imag)!r}]"
        case str():
            return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
        case date() | datetime() | time():
            return value.isoformat()
        case Mapping():
            inner = (f"{key_text(str(key))} = {value_text(entry, f'{place}.{key}')}" for key, entry in value.items())
            return f"{{ {', '.join(inner)} }}"
        case _:
            pass
    if hasattr(value, "tolist"):
        return value_text(value.tolist(), place)
    if isinstance(value, list | tuple):
        return f"[{', '.join(value_text(entry, f'{place}.{k}') for k, entry in enumerate(value))}]"
    raise WrongType(Where("", None, place), "quantity", shown_value(value))


def _several(value: object) -> bool:
    """True of a list of tables."""
    return isinstance(value, list | tuple) and bool(value) and all(isinstance(entry, Mapping) for entry in value)


def _with_header(name: str, value: object) -> Iterator[str]:
    if isinstance(value, list | tuple):
        for entry in value:
            yield from ("", f"[[{key_text(name)}]]", *_rows(entry, name))
        return
    assert isinstance(value, Mapping)
    if value and all(isinstance(entry, Mapping) for entry in value.values()):
        for key, entry in value.items():
            yield from ("", f"[{key_text(name)}.{key_text(str(key))}]", *_rows(entry, f"{name}.{key}"))
    else:
        yield from ("", f"[{key_text(name)}]", *_rows(value, name))


def _rows(table: Mapping[str, object], place: str) -> Iterator[str]:
    return (f"{key_text(str(key))} = {value_text(value, f'{place}.{key}')}" for key, value in table.items())


def replaced_values(text: str, values: Mapping[KeyPath, object]) -> str:
    """The text with other values at these places; a key that is not there is added at the end of its table. Comments
    and layout stay, unless a whole table is missing."""
    spans, ends = _value_spans(text)
    edits: list[tuple[int, int, str]] = []
    for path, value in values.items():
        if path in spans:
            edits.append((*spans[path], value_text(value, ".".join(map(str, path)))))
        elif path[:-1] in ends and path[:-1]:
            end = text.find("\n", ends[path[:-1]])
            end = len(text) if end < 0 else end
            edits.append((end, end, f"\n{key_text(str(path[-1]))} = {value_text(value, '.'.join(map(str, path)))}"))
        else:
            return toml(with_values(tomllib.loads(text), values))
    for begin, end, new in sorted(edits, reverse=True):
        text = text[:begin] + new + text[end:]
    return text


def value_spans(text: str) -> dict[KeyPath, tuple[int, int]]:
    """The beginning and the end of each value of a text, in their order, by its keys as they are typed."""
    return _TextWalk(text).values


@lru_cache(maxsize=16)
def _value_spans(text: str) -> tuple[dict[KeyPath, tuple[int, int]], dict[KeyPath, int]]:
    """The span of each value, and the end of the last thing that each table with a header has."""
    walk = _TextWalk(text)
    return ({tidied(path): span for path, span in walk.values.items()},
            {tidied(path): end for path, end in walk.ends.items()})  # fmt: skip


def with_values(document: Mapping[str, object], values: Mapping[KeyPath, object]) -> dict[str, object]:
    """A copy of a file's data with other values at these places; tables that are missing are made."""
    changed = copy.deepcopy(dict(document))
    for path, value in values.items():
        table: dict[str, object] | list[object] = changed
        for part in path[:-1]:
            inner = table[int(part)] if isinstance(table, list) else table.setdefault(own_key(table, part), {})
            assert isinstance(inner, dict | list)
            table = inner
        if isinstance(table, list):
            table[int(path[-1])] = value
        else:
            table[own_key(table, path[-1])] = value
    return changed


def own_key(table: Mapping[str, object], part: str | int) -> str:
    """A key as this table writes it: primes may be printed ones there."""
    return next((key for key in table if tidy(key) == part), str(part))


def tidied(path: KeyPath) -> KeyPath:
    """A path with the primes of its names as typed on a keyboard."""
    return tuple(tidy(part) if isinstance(part, str) else part for part in path)


_BLANK = r"(?:[ \t\r\n]|#[^\n]*)*"
_SPACE = r"[ \t]*"
_PLAIN = r"[^,\]}#\n]+"
_STRING = r'(?s:"""(?:\\.|[^\\])*?"{3,5}' r"|'''.*?'{3,5}" r'|"(?:\\.|[^"\\])*"' r"|'[^']*')"


def key_positions(text: str) -> dict[KeyPath, int]:
    """The line of each key, list items included, counted from 1."""
    starts = [0, *(match.end() for match in re.finditer("\n", text))]
    return {path: bisect_right(starts, offset) for path, offset in _TextWalk(text).keys.items()}


class _TextWalk:
    """One walk over a text.

    keys    the offset where each key first stands
    values  where each value begins and ends
    ends    where the last thing ends that each table with a header has
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.keys: dict[KeyPath, int] = {}
        self.values: dict[KeyPath, tuple[int, int]] = {}
        self.ends: dict[KeyPath, int] = {}
        self._counts: dict[KeyPath, int] = {}  # the number of the last [[table]] of each name so far, from 0
        table: KeyPath = ()
        at = self._after(_BLANK, 0)
        while at < len(text):
            if text[at] == "[":
                # `[links.1]` or `[[slide]]`: the path of what follows
                brackets = 2 if self.text.startswith("[[", at) else 1
                names, end = self._names(at + brackets)
                for n in range(1, len(names)):
                    self.keys.setdefault(self._resolved(names[:n]), at)
                path: KeyPath = (*self._resolved(names[:-1]), names[-1])
                if brackets == 2:
                    self.keys.setdefault(path, at)
                    self._counts[path] = self._counts.get(path, -1) + 1
                path = self._resolved(names)
                self.keys.setdefault(path, at)
                table, at = path, end + brackets
            else:
                at = self._key_and_value(at, table)
            self.ends[table] = at
            at = self._after(_BLANK, at)

    def _resolved(self, names: list[str]) -> KeyPath:
        """The path of a header: the last item of each [[table]] on the way is meant."""
        path: KeyPath = ()
        for name in names:
            path = (*path, name)
            if path in self._counts:
                path = (*path, self._counts[path])
        return path

    def _key_and_value(self, at: int, table: KeyPath) -> int:
        names, end = self._names(at)
        path = table
        for name in names:
            path = (*path, name)
            self.keys.setdefault(path, at)
        return self._value(end + 1, path)

    def _names(self, at: int) -> tuple[list[str], int]:
        """The parts of a dotted key, and where it ends."""
        names: list[str] = []
        while True:
            at = self._after(_SPACE, at)
            quoted = self.text[at] in "\"'"
            end = self._after(_STRING if quoted else _BARE_KEY.pattern, at)
            part = self.text[at:end]
            names.append(str(tomllib.loads(f"key = {part}")["key"]) if quoted else part)
            at = self._after(_SPACE, end)
            if self.text[at] != ".":
                return names, at
            at += 1

    def _value(self, at: int, path: KeyPath) -> int:
        """The end of the value that begins here; it and what is in it are noted, an item of a list as a key, too."""
        self.keys.setdefault(path, at)
        at = self._after(_SPACE, at)
        match self.text[at]:
            case '"' | "'":
                end = self._after(_STRING, at)
            case "[":
                end = self._items(at + 1, "]", lambda item, n: self._value(item, (*path, n)))
            case "{":
                end = self._items(at + 1, "}", lambda item, _: self._key_and_value(item, path))
            case _:
                end = self._after(_PLAIN, at)
        self.values[path] = at, at + len(self.text[at:end].rstrip())
        return end

    def _items(self, at: int, close: str, read: Callable[[int, int], int]) -> int:
        """The end of what stands between brackets, separated by commas."""
        at, n = self._after(_BLANK, at), 0
        while self.text[at] != close:
            at, n = self._after(_BLANK, read(at, n)), n + 1
            if self.text[at] == ",":
                at = self._after(_BLANK, at + 1)
        return at + 1

    def _after(self, pattern: str, at: int) -> int:
        match = re.compile(pattern).match(self.text, at)
        return at if match is None else match.end()
