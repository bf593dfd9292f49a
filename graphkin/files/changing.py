"""A mechanism's text with other values in it: comments, layout and everything else stay."""

from __future__ import annotations

import copy
import tomllib
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from graphkin.errors import NoSuchValue, Where
from graphkin.files.names import POINT, split_points, tidy
from graphkin.files.positions import Path, values
from graphkin.files.toml import key_text, toml, value_text
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import driver_number

_PLAIN_TABLES = ("frame", "links", "sketch", "scales")
_OF_ITEMS = ("slide", "gear", "roll", "cam", "driver", "pose")
_RATES = ("angle", "at", "omega", "alpha", "velocity", "acceleration", "also")


def changed_text(mechanism: Mechanism, given: Mapping[str, object]) -> str:
    """The mechanism's file with other values, each named as `Mechanism.with_` says.

    Raises NoSuchValue for a name that means nothing in this file, or more than one thing.
    """
    document = _document(mechanism.text)
    found = {_place(mechanism, document, tidy(name.strip())): value for name, value in given.items()}
    return rewritten(mechanism.text, found)


def rewritten(text: str, given: Mapping[Path, object]) -> str:
    """The text with other values at these places; a key that is not there is added at the end of its table."""
    spans, ends = _stood(text)
    edits: list[tuple[int, int, str]] = []
    for path, value in given.items():
        if path in spans:
            edits.append((*spans[path], value_text(value)))
        elif path[:-1] in ends and path[:-1]:
            end = text.find("\n", ends[path[:-1]])
            end = len(text) if end < 0 else end
            edits.append((end, end, f"\n{key_text(str(path[-1]))} = {value_text(value)}"))
        else:
            return toml(_put(copy.deepcopy(_document(text)), given))
    for begin, end, new in sorted(edits, reverse=True):
        text = text[:begin] + new + text[end:]
    return text


@lru_cache(maxsize=16)
def _stood(text: str) -> tuple[dict[Path, tuple[int, int]], dict[Path, int]]:
    """Where values stand, and where tables end, primes in keys tidied."""
    spans, ends = values(text)
    return {_tidied(path): span for path, span in spans.items()}, {_tidied(path): end for path, end in ends.items()}


@lru_cache(maxsize=16)
def _document(text: str) -> dict[str, Any]:
    return tomllib.loads(text)


def _tidied(path: Path) -> Path:
    return tuple(tidy(part) if isinstance(part, str) else part for part in path)


def _put(document: dict[str, Any], given: Mapping[Path, object]) -> dict[str, Any]:
    """The data with other values at these places."""
    for path, value in given.items():
        table: Any = document
        for part in path[:-1]:
            table = table[_own(table, part)] if isinstance(table, list) else table.setdefault(_own(table, part), {})
        table[_own(table, path[-1])] = value
    return document


def _own(table: Any, part: str | int) -> Any:
    """A key as this table writes it."""
    if isinstance(table, list):
        return part
    return next((key for key in table if tidy(key) == part), part)


# --- what a name means ------------------------------------------------------------------------


def _place(mechanism: Mechanism, document: dict[str, Any], name: str) -> Path:
    """The path that a name means. Raises NoSuchValue."""
    found = list(dict.fromkeys(_places(mechanism, document, name)))
    if len(found) == 1:
        return found[0]
    possible = [".".join(map(str, path)) for path in found] or list(_possible(mechanism, document))
    raise NoSuchValue(Where(mechanism.file), name, tuple(possible))


def _places(mechanism: Mechanism, document: dict[str, Any], name: str) -> Iterator[Path]:
    """All that it may mean."""
    if "." in name:
        yield from _dotted(mechanism, document, name.split("."))
    elif POINT.fullmatch(name):
        yield from _of_point(mechanism, document, name)
    elif points := split_points(name):
        yield from (path for path in _measures(document) if split_points(str(path[-1])) in (points, points[::-1]))
    else:
        yield from _of_item(mechanism, document, *name.partition(" ")[::2])


def _measures(document: dict[str, Any]) -> Iterator[Path]:
    """The lengths and angles of links."""
    for link, table in document.get("links", {}).items():
        yield from (("links", tidy(link), tidy(key)) for key in table if len(split_points(tidy(key))) > 1)


def _of_point(mechanism: Mechanism, document: dict[str, Any], point: str) -> Iterator[Path]:
    """Its coordinates in the frame, in a link's shape, or in the sketch."""
    if _has(document.get("frame", {}), point):
        yield "frame", point
        return
    for link, table in document.get("links", {}).items():
        if _has(table.get("shape", {}), point):
            yield "links", tidy(link), "shape", point
    if point in mechanism.points:
        yield "sketch", point


def _of_item(mechanism: Mechanism, document: dict[str, Any], key: str, of: str) -> Iterator[Path]:
    """`omega AB`, `at ram`, `angle ram`; of the only driver also `omega` alone."""
    drivers = document.get("driver", [])
    if not of and key in _RATES and len(drivers) == 1:
        yield "driver", 0, key
    if of and (number := driver_number(mechanism, of.strip())) is not None and key in _RATES:
        yield "driver", number, key
        return
    for table in ("slide", "roll", "pose") if of else ():
        for number, entry in enumerate(document.get(table, [])):
            if of.strip() in (entry.get("name"), entry.get("vector"), entry.get("slide")) and _has(entry, key):
                yield table, number, key


def _dotted(mechanism: Mechanism, document: dict[str, Any], parts: list[str]) -> Iterator[Path]:
    """`links.1.AB`, `slide.ram.angle`, `driver.0.omega`, `gear.0.radii.1`, `sketch.C`."""
    table = parts[0]
    if table in _PLAIN_TABLES and (len(parts) > 2 or table != "links"):
        path: Path = tuple(parts)
    elif table in _OF_ITEMS and len(parts) > 2:
        items = document.get(table, [])
        names = [entry.get("name") or entry.get("vector") or entry.get("slide") for entry in items]
        number = names.index(parts[1]) if parts[1] in names else int(parts[1]) if parts[1].isdecimal() else -1
        if not 0 <= number < len(items):
            return
        path = (table, number, *(int(part) if part.isdecimal() else part for part in parts[2:]))
    else:
        return
    if table in _OF_ITEMS or table in ("sketch", "scales") or _stands(document, path):
        yield path


def _stands(document: Any, path: Path) -> bool:
    for part in path:
        key = _own(document, part)
        if isinstance(document, dict) and key in document:
            document = document[key]
        else:
            return False
    return True


def _has(table: Any, key: str) -> bool:
    return isinstance(table, dict) and any(tidy(own) == key for own in table)


def _possible(mechanism: Mechanism, document: dict[str, Any]) -> Iterator[str]:
    """What there is, as people would name it."""
    yield from (str(path[-1]) for path in _measures(document))
    for driver, entry in zip(mechanism.drivers, document.get("driver", [])):
        yield from (f"{key} {driver.name}" for key in _RATES if key in entry)
    yield from (tidy(point) for point in document.get("frame", {}) if POINT.fullmatch(tidy(point)))
    for slide in document.get("slide", []):
        yield from (f"{key} {slide['name']}" for key in ("angle", "tilt", "radius") if key in slide and "name" in slide)
    yield from (f"slide.{k}.angle" for k, slide in enumerate(document.get("slide", [])) if "angle" in slide)
