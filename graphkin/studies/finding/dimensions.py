"""One number of a mechanism file given another value: the same text with that number replaced, and nothing else."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from typing import Any

from graphkin.base.value import frozen
from graphkin.errors import NoDimension, Where
from graphkin.files.values import UNITS, split_points, tidy
from graphkin.model.mechanism import Dimension, Mechanism
from graphkin.model.naming import driver_number

WHERE = Where("--vary")
Path = tuple[str | int, ...]

KINDS: dict[str, Dimension] = {
    "angle": "angle", "tilt": "angle", "at": "length", "radius": "length", "on_radius": "length",
    "omega": "angular velocity", "alpha": "angular acceleration",
    "velocity": "velocity", "acceleration": "acceleration",
}  # fmt: skip
"""What keys of the file that are no measures are measured in."""
_NUMBER = r"""(?:"[^"\n]*"|'[^'\n]*'|[-+0-9.][-+.\w]*)"""


@frozen
class DimensionPlace:
    """Where a dimension stands: its path in the file, and what it measures; or the number of a driver."""

    path: Path
    kind: Dimension
    driver: int | None = None


def dimension(mechanism: Mechanism, name: str) -> DimensionPlace:
    """What `AB`, `BDE`, `links.2.AB`, `slide.0.angle`, or a driver's name means. Raises NoDimension.

    A length of a link that `AB` names goes before a driver of that name: the angle of AB is swept, not varied.
    """
    name = tidy(name.strip())
    paths = [path for path in mechanism.lines if _named(path, name)]
    document = tomllib.loads(mechanism.text) if mechanism.text else {}
    single = [path for path in paths if _is_single(value_at(document, path))]
    found = [DimensionPlace(path, kind) for path in single if (kind := _kind(path))]
    if len(found) == 1:
        return found[0]
    drivers = [driver.name for driver in mechanism.drivers]
    number = driver_number(mechanism, name)
    if not found and number is not None:
        return DimensionPlace((), "length" if mechanism.drivers[number].kind == "slide" else "angle", number)
    possible = (*_possible(mechanism, document, ambiguous=bool(found)), *drivers)
    raise NoDimension(WHERE, name, tuple(dict.fromkeys(possible)))


def _named(path: Path, name: str) -> bool:
    """Whether a path is called so: in full, or, a measure of a link, by its last key (`BA` is `AB`)."""
    if ".".join(str(part) for part in path) == name:
        return True
    points = split_points(name)
    if not points or path[:1] != ("links",) or len(path) != 3:
        return False
    return split_points(str(path[2])) in (points, points[::-1])


def _kind(path: Path) -> Dimension | None:
    """What a key measures; None for one that is no single dimension."""
    if path[:1] == ("links",):
        return {2: "length", 3: "angle"}.get(len(split_points(str(path[-1])))) if len(path) == 3 else None  # type: ignore[return-value]
    return KINDS.get(str(path[-1])) if len(path) > 1 else None


def _possible(mechanism: Mechanism, document: dict[str, Any], ambiguous: bool) -> Iterator[str]:
    """All measures of links, in full where their last key alone would mean two."""
    for path in mechanism.lines:
        if path[:1] == ("links",) and _kind(path) and _is_single(value_at(document, path)):
            yield ".".join(str(part) for part in path) if ambiguous else str(path[-1])


def value_at(document: Any, path: Path) -> Any:
    """The value that stands at a path, however its primes are written; None where there is none."""
    for part in path:
        if isinstance(document, dict):
            document = {tidy(key): value for key, value in document.items()}.get(str(part))
        elif isinstance(document, list) and isinstance(part, int) and part < len(document):
            document = document[part]
        else:
            return None
    return document


def _is_single(value: object) -> bool:
    return isinstance(value, int | float | str) and not isinstance(value, bool)


def replaced(mechanism: Mechanism, place: DimensionPlace, value: float) -> str:
    """The file's text with another value [SI] at a place, in the units of plain numbers."""
    text = mechanism.text
    lines = text.splitlines(keepends=True)
    start = sum(len(line) for line in lines[: mechanism.lines[place.path] - 1])
    end = start + len(lines[mechanism.lines[place.path] - 1])
    before = tomllib.loads(text)
    shown = repr(value * _plain_unit(place.kind))
    for match in re.finditer(rf"""(=\s*)({_NUMBER})""", text[start:end]):
        changed = text[: start + match.start(2)] + shown + text[start + match.end(2) :]
        if _differs_only_at(before, changed, place.path):
            return changed
    raise NoDimension(WHERE, ".".join(map(str, place.path)), ())


def _plain_unit(kind: Dimension) -> float:
    """How many of the unit of plain numbers one in SI is."""
    times, divided = next(iter(UNITS[kind].values()))
    return divided / times


def _differs_only_at(before: dict[str, Any], changed: str, path: Path) -> bool:
    """Whether a changed text is the same file but for one value."""
    try:
        after = tomllib.loads(changed)
    except tomllib.TOMLDecodeError:
        return False
    return _flat(before, path) == _flat(after, path) and value_at(after, path) is not None


def _flat(value: Any, path: Path) -> Any:
    """A document with what stands at the path left out."""
    if isinstance(value, dict):
        head = path[0] if path else None
        rest = {tidy(key): entry for key, entry in value.items()}
        if len(path) == 1:
            return {key: entry for key, entry in rest.items() if key != head}
        return {key: _flat(entry, path[1:]) if key == head else entry for key, entry in rest.items()}
    if isinstance(value, list) and path:
        return [_flat(entry, path[1:]) if k == path[0] else entry for k, entry in enumerate(value)]
    return value
