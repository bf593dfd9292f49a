"""What pydantic's core found wrong, in graphkin's own errors: with line and key, and without pydantic's words."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from pydantic_core import ValidationError

from graphkin.errors import GraphkinError, MissingKey, UnitAsKey, UnknownKey, Where, WrongCount, WrongType
from graphkin.files.fields import keys
from graphkin.files.positions import Path
from graphkin.files.schema import (
    CamTable,
    DriverTable,
    File,
    GearTable,
    PoseTable,
    ProfileTable,
    RollTable,
    ScalesTable,
    SlideTable,
    Titles,
)
from graphkin.files.units import UNITS, Dimension, short_number
from graphkin.files.values import shown

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

KEYS: Mapping[Dimension, str] = {
    "length": "at", "angle": "angle", "angular velocity": "omega", "angular acceleration": "alpha",
    "velocity": "velocity", "acceleration": "acceleration",
}  # fmt: skip
"""The key of a driver that takes a quantity."""

TABLES: Mapping[tuple[str, ...], type] = {
    (): File,
    ("title",): Titles,
    ("source",): Titles,
    ("slide", "title"): Titles,
    ("slide",): SlideTable,
    ("gear",): GearTable,
    ("roll",): RollTable,
    ("cam",): CamTable,
    ("cam", "profiles"): ProfileTable,
    ("driver",): DriverTable,
    ("pose",): PoseTable,
    ("scales",): ScalesTable,
}
"""Which keys are possible where, item numbers left out."""


def complaints(
    error: ValidationError, where: Callable[..., Where], known: Mapping[Path, int]
) -> Iterator[GraphkinError]:
    """One error each. `known` are the keys the file has: what pydantic adds to a path is left out."""
    for detail in error.errors(include_url=False):
        path = detail["loc"]
        while path and path not in known and detail["type"] != "missing":
            path = path[:-1]
        yield _complaint(detail, where(*path))


def _complaint(detail: ErrorDetails, where: Where) -> GraphkinError:
    context = detail.get("ctx", {})
    key = str(detail["loc"][-1]) if detail["loc"] else ""
    match detail["type"]:
        case "graphkin":
            problem: GraphkinError = context["problem"]
            return problem.at(where)
        case "missing":
            return MissingKey(where, key)
        case "extra_forbidden":
            return _unknown(where, key, detail["input"], _possible(detail["loc"][:-1]))
        case "too_short" | "too_long":
            expected = context.get("min_length", context.get("max_length"))
            return WrongCount(where, int(expected or 0), len(detail["input"]))
        case kind:
            return WrongType(where, "list" if kind == "list_type" else "table", shown(detail["input"]))


def _unknown(where: Where, key: str, value: object, possible: tuple[str, ...]) -> GraphkinError:
    """A unit that stands where the key does (`rpm = 95`) is said by the key that takes it."""
    meant = next((KEYS[quantity] for quantity, units in UNITS.items() if key in units), None)
    if meant in possible and isinstance(value, int | float) and not isinstance(value, bool):
        return UnitAsKey(where, key, meant, f"{short_number(value)} {key}")
    return UnknownKey(where, key[:40], possible)


def _possible(path: tuple[int | str, ...]) -> tuple[str, ...]:
    """The keys of the table at this path."""
    table = TABLES.get(tuple(part for part in path if isinstance(part, str)))
    return tuple(keys(table)) if table else ()
