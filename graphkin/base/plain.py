"""Plain data, as JSON can hold it, values made of it, and a checksum over it."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import cache
from hashlib import sha256
from types import UnionType
from typing import Any, Literal, TypeAlias, Union, get_args, get_origin, get_type_hints

Plain: TypeAlias = Union[bool, int, float, str, "Sequence[Plain]", "Mapping[str, Plain]", None]
"""Data that JSON can hold, to be written; what is read is `object` until it is looked at."""
_DIGITS = 4  # of a place
_hints = cache(get_type_hints)


def plain(value: Any) -> Any:
    """A value class as plain data: its fields by name, places as pairs of numbers."""
    if isinstance(value, complex):
        return [round(value.real, _DIGITS) + 0.0, round(value.imag, _DIGITS) + 0.0]
    if isinstance(value, Mapping):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, tuple | list):
        return [plain(each) for each in value]
    if hasattr(value, "__dataclass_fields__"):
        return {each.name: plain(getattr(value, each.name)) for each in fields(value)}
    return value


def built(kind: Any, data: Any) -> Any:
    """A value of this kind from plain data. Raises KeyError, TypeError, ValueError where it does not hold one."""
    origin, inner = get_origin(kind), get_args(kind)
    if kind is complex:
        x, y = (built(float, each) for each in data)
        return complex(x, y)
    if origin is Literal:
        return inner[inner.index(data)]
    if origin in (Union, UnionType):  # a value, or None
        return None if data is None else built(inner[0], data)
    if origin is tuple:
        data = [data] if isinstance(data, str) else data  # as files have it whose names were of one place each
        kinds = [inner[0]] * len(data) if ... in inner else inner
        return tuple(built(each, one) for each, one in zip(kinds, data, strict=True))
    if hasattr(origin, "keys"):
        return {built(inner[0], key): built(inner[1], each) for key, each in data.items()}
    if hasattr(kind, "__dataclass_fields__"):
        return kind(**{each.name: built(_hints(kind)[each.name], data[each.name]) for each in fields(kind)})
    of_kind = isinstance(data, (int, float) if kind is float else kind) and (kind is bool or not isinstance(data, bool))
    if not of_kind or (kind is float and not math.isfinite(data)):
        raise TypeError(f"{data!r} is no {kind.__name__}")
    return float(data) if kind is float else data


def seal(claims: Mapping[str, object]) -> str:
    """A checksum (SHA-256, hexadecimal) over everything a drawing says of itself but the seal."""
    sealed = {key: value for key, value in claims.items() if key != "seal"}
    text = json.dumps(sealed, ensure_ascii=False, sort_keys=True)
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
