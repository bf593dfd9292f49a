"""A condition looked for again and again while a dimension of the mechanism is varied."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from graphkin import files as loading
from graphkin.base.value import frozen
from graphkin.errors import BadRange, GraphkinError, NoDimension, NoSuchDriver
from graphkin.files.values import read_quantity
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.planning import plan as planned
from graphkin.running import replay_all
from graphkin.studies.finding import conditions
from graphkin.studies.finding.answers import Findings
from graphkin.studies.finding.data import as_json
from graphkin.studies.finding.dimensions import WHERE, DimensionPlace, dimension, replaced, value_at
from graphkin.studies.finding.find import find
from graphkin.studies.finding.points import line_of
from graphkin.studies.finding.quantities import checked
from graphkin.studies.sweeps import Road

MOST = 10_000
"""Values of a dimension, at most."""
Plan = Callable[[Mechanism], Method]


@frozen
class VaryingRow:
    """What was found with one value of the dimension; `error` says why nothing could be looked for."""

    value: float
    found: Findings | None
    error: GraphkinError | None


@frozen
class VaryingTable:
    """A condition over values of a dimension [SI]."""

    mechanism: Mechanism
    name: str
    place: DimensionPlace
    condition: str
    rows: tuple[VaryingRow, ...]


def vary(
    mechanism: Mechanism, text: str, condition: str, ranges: Sequence[str] = (), by: Road = "construction",
    plan: Plan = planned,
) -> VaryingTable:  # fmt: skip
    """`AB=20:60:1`: the condition for each length AB; `screw=55:125:5`: for each place of a driver at rest.

    The assembly is kept: from the value in the file on to both sides, each sketched by the one before. A value with
    which the mechanism cannot be assembled, or nothing can be looked for, has a row that says so.
    Raises BadRange, NoDimension, and what `find` raises for a condition that names nothing.
    """
    name, equals, span = text.partition("=")
    if not equals:
        raise BadRange(WHERE, text)
    place = dimension(mechanism, name)
    values = _values(text, span, place)
    _refuse(mechanism, condition)
    if place.driver is not None:
        rows = list(_driven(plan(mechanism), place.driver, values, condition, ranges, by))
    else:
        rows = _measured(mechanism, place, values, condition, ranges, by, plan)
    return VaryingTable(mechanism, name.strip(), place, condition, tuple(rows))


def _refuse(mechanism: Mechanism, condition: str) -> None:
    """What is wrong with the condition itself is said once, not in every row."""
    match conditions.read(mechanism, condition):
        case conditions.Comparison() | conditions.Extreme() as wanted:
            checked(mechanism, wanted.quantities)
        case conditions.Scaling() as wanted:
            checked(mechanism, (wanted.quantity,))
        case conditions.Slowest() as wanted:
            line_of(mechanism, wanted.of)


def _values(text: str, span: str, place: DimensionPlace) -> np.ndarray:
    """FROM, and on by STEP, to TO [SI]. Raises BadRange, and what a wrong unit raises."""
    parts = [part.strip() for part in span.split(":")]
    if len(parts) not in (1, 3):
        raise BadRange(WHERE, text)
    try:
        numbers = [read_quantity(conditions.plain(part), place.kind) for part in parts]
    except GraphkinError as error:
        raise error.at(WHERE) from None
    if len(numbers) == 1:
        return np.array(numbers)
    begin, end, step = numbers
    if not step > 0 or abs(end - begin) / step > MOST:
        raise BadRange(WHERE, text)
    count = math.floor(abs(end - begin) / step + 1e-9)
    return begin + math.copysign(step, end - begin) * np.arange(count + 1)


# --- a driver at rest -------------------------------------------------------------------------


def _driven(
    method: Method, number: int, values: np.ndarray, condition: str, ranges: Sequence[str], by: Road
) -> Iterator[VaryingRow]:
    """The other drivers move; this one stands at each value."""
    driver = method.drivers[number]
    unit = "m" if driver.kind == "slide" else "rad"
    if len(method.drivers) == 1 and not isinstance(
        conditions.read(method.mechanism, condition), conditions.Slowest | conditions.Scaling
    ):
        raise NoDimension(WHERE, driver.name, ())
    if any(text.partition("=")[0].strip() == driver.name for text in ranges):
        raise NoSuchDriver(WHERE, driver.name, ())
    for value in map(float, values):
        held = f"{driver.name}={value!r} {unit}"
        yield _row(value, lambda held=held: find(method, condition, (*ranges, held), by))  # type: ignore[misc]


def _row(value: float, look: Callable[[], Findings]) -> VaryingRow:
    try:
        return VaryingRow(value, look(), None)
    except GraphkinError as error:
        return VaryingRow(value, None, error)


# --- a measure of the file --------------------------------------------------------------------


def _measured(
    mechanism: Mechanism,
    place: DimensionPlace,
    values: np.ndarray,
    condition: str,
    ranges: Sequence[str],
    by: Road,
    plan: Plan,
) -> list[VaryingRow]:
    """From the value nearest to the file's on to both sides, so that the assembly goes over step by step."""
    now = _now(mechanism, place)
    begin = int(np.argmin(np.abs(values - now)))
    start = _positions(plan(mechanism))
    found: dict[int, VaryingRow] = {}
    for order in (range(begin, values.size), range(begin - 1, -1, -1)):
        sketch = dict(start)
        for k in order:
            value = float(values[k])
            try:
                method = plan(_with(mechanism, place, value, sketch))
            except GraphkinError as error:
                found[k] = VaryingRow(value, None, error)
                continue
            sketch = _positions(method)
            found[k] = _row(value, lambda method=method: find(method, condition, ranges, by))  # type: ignore[misc]
            start = sketch if k == begin else start
    return [found[k] for k in sorted(found)]


def _now(mechanism: Mechanism, place: DimensionPlace) -> float:
    """The value in the file [SI]."""
    return read_quantity(value_at(tomllib.loads(mechanism.text), place.path), place.kind)


def _with(mechanism: Mechanism, place: DimensionPlace, value: float, sketch: dict[str, complex]) -> Mechanism:
    """The mechanism with another dimension, sketched as it stood before."""
    changed = loading.loads(replaced(mechanism, place, value), name=mechanism.name, file=mechanism.file)
    fixed = changed.links[FRAME].points
    return replace(changed, sketch={point: z for point, z in sketch.items() if point not in fixed})


def _positions(method: Method) -> dict[str, complex]:
    """Where the moving points are at the drawn position [m]."""
    mechanism = method.mechanism
    plot = replay_all(method)
    fixed = mechanism.links[FRAME].points
    return {p: complex(plot.position[p]) for p in mechanism.points if p not in fixed and p in plot.position}


# --- for programs -----------------------------------------------------------------------------


def table_json(found: VaryingTable) -> dict[str, Any]:
    """SI units and radians."""
    rows = [
        {"value": row.value, **({"found": as_json(row.found)} if row.found else {"error": str(row.error)})}
        for row in found.rows
    ]
    heads = {"format": 1, "name": found.mechanism.name, "dimension": found.name, "condition": found.condition}
    return heads | {"rows": rows}
