"""Data as TOML text, laid out as mechanism files are: titles and questions, then a table with a header each."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from datetime import date, datetime, time
from numbers import Integral, Real
from typing import Any

from graphkin.errors import Where, WrongType
from graphkin.files.values import shown

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def toml(document: Mapping[str, Any]) -> str:
    """The text of a mechanism's data; numpy's numbers and arrays, too, and a complex number for a place.

    Raises WrongType for a value that no TOML file can hold.

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
    plain = {name: value for name, value in document.items() if not _has_header(name, value)}
    lines = [f"{key_text(name)} = {value_text(value, name)}" for name, value in plain.items()]
    for name, value in document.items():
        if name not in plain:
            lines += _with_header(name, value)
    return "\n".join(lines).lstrip("\n") + "\n"


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
            return f"[{value.real!r}, {value.imag!r}]"
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
    raise WrongType(Where("", None, place), "quantity", shown(value))


def _has_header(name: str, value: object) -> bool:
    """Whether it is a table, or tables; a title of two languages stands on one line."""
    several = isinstance(value, list | tuple) and bool(value) and all(isinstance(entry, Mapping) for entry in value)
    return several or (isinstance(value, Mapping) and name != "title")


def _with_header(name: str, value: Any) -> Iterator[str]:
    if not isinstance(value, Mapping):
        for entry in value:
            yield from ("", f"[[{key_text(name)}]]", *_rows(entry, name))
    elif value and all(isinstance(entry, Mapping) for entry in value.values()):
        for key, entry in value.items():
            yield from ("", f"[{key_text(name)}.{key_text(str(key))}]", *_rows(entry, f"{name}.{key}"))
    else:
        yield from ("", f"[{key_text(name)}]", *_rows(value, name))


def _rows(table: Mapping[str, Any], place: str) -> Iterator[str]:
    return (f"{key_text(str(key))} = {value_text(value, f'{place}.{key}')}" for key, value in table.items())


def key_text(name: str) -> str:
    """A key, quoted where TOML wants it."""
    return name if _BARE.fullmatch(name) else value_text(name)
