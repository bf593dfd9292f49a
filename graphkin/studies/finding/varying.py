"""A condition answered again and again while one number of the mechanism file is varied.

The file's text is kept, with that number replaced and nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from graphkin import files as loading
from graphkin.base.geometry import place as place_of
from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.errors import BadRange, GraphkinError, NoDimension, NoSuchDriver, Where
from graphkin.files.toml import replaced_values
from graphkin.files.values import UNITS, quantity_at, split_points, tidy
from graphkin.model.mechanism import FRAME, Dimension, KeyPath, Mechanism
from graphkin.model.naming import driver_number
from graphkin.planning import Method
from graphkin.planning import plan as planned
from graphkin.running import replay_all
from graphkin.studies.finding import conditions
from graphkin.studies.finding.answers import Findings, as_json
from graphkin.studies.finding.find import find, line_of
from graphkin.studies.finding.stretch import checked
from graphkin.studies.sweeps import Road

WHERE = Where("--vary")
MOST = 10_000  # values of a dimension, at most
Plan = Callable[[Mechanism], Method]


@frozen
class DimensionPlace:
    """The place of a dimension: its path in the file, and its kind; or the number of a driver."""

    path: KeyPath
    kind: Dimension
    driver: int | None = None


def dimension(mechanism: Mechanism, name: str) -> DimensionPlace:
    """The place of `AB`, `BDE`, `links.2.AB`, `slide.0.angle`, or of a driver by its name. Raises NoDimension.

    A length of a link that `AB` names goes before a driver of that name: the angle of AB is swept, not varied.
    """
    name = tidy(name.strip())
    kinds = {path: each.dimension for path, each in mechanism.given.items() if isinstance(path[-1], str)}
    single = {path: kind for path, kind in kinds.items() if kind is not None}
    places = [DimensionPlace(path, kind) for path, kind in single.items() if _is_called(path, name)]
    if len(places) == 1:
        return places[0]
    number = driver_number(mechanism, name)
    if not places and number is not None:
        return DimensionPlace((), "length" if mechanism.drivers[number].kind == "slide" else "angle", number)
    # all measures of links, in full where their last key alone would mean two
    measures = [path for path in single if path[:1] == ("links",)]
    possible = [".".join(map(str, path)) if places else str(path[-1]) for path in measures]
    possible += [driver.name for driver in mechanism.drivers]
    raise NoDimension(WHERE, name, tuple(dict.fromkeys(possible)))


def _is_called(path: KeyPath, name: str) -> bool:
    """True if a path is called so: in full, or, a measure of a link, by its last key (`BA` is `AB`)."""
    if ".".join(str(part) for part in path) == name:
        return True
    points = split_points(name)
    if not points or path[:1] != ("links",) or len(path) != 3:
        return False
    return split_points(str(path[2])) in (points, points[::-1])


def replaced(mechanism: Mechanism, place: DimensionPlace, value: float) -> str:
    """The file's text with another value [SI] at a place, in the units of plain numbers."""
    times, divided = next(iter(UNITS[place.kind].values()))
    return replaced_values(mechanism.text, {place.path: value * (divided / times)})


@frozen
class VaryingRow:
    """The findings with one value of the dimension, or the error that stands against it."""

    value: float
    found: Findings | None
    error: GraphkinError | None


@bulky
class VaryingTable:
    """A condition over values of a dimension: `rows` with the `value` [SI], and what is `found` or the `error`."""

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
    which the mechanism cannot be assembled, or the condition not be answered, has a row that says so.
    Raises BadRange, NoDimension, and what `find` raises for a condition that names nothing.
    """
    name, equals, span = text.partition("=")
    if not equals:
        raise BadRange(WHERE, text)
    place = dimension(mechanism, name)
    values = _values(text, span, place)
    match conditions.read(mechanism, condition):  # its own errors are raised once, not in every row
        case conditions.Comparison(quantities=names) | conditions.Extreme(quantities=names):
            checked(mechanism, names)
        case conditions.Scaling(quantity=quantity):
            checked(mechanism, (quantity,))
        case conditions.Slowest(of=line):
            line_of(mechanism, line)
    if place.driver is not None:
        rows = _with_driver_held(plan(mechanism), place.driver, values, condition, ranges, by)
    else:
        rows = _with_measures(mechanism, place, values, partial(_row, condition=condition, ranges=ranges, by=by), plan)
    return VaryingTable(mechanism, name.strip(), place, condition, tuple(rows))


def _row(value: float, method: Method, condition: str, ranges: Sequence[str], by: Road) -> VaryingRow:
    try:
        return VaryingRow(value, find(method, condition, ranges, by), None)
    except GraphkinError as error:
        return VaryingRow(value, None, error)


def _values(text: str, span: str, place: DimensionPlace) -> np.ndarray:
    """FROM, and on by STEP, to TO [SI]. Raises BadRange, and what a wrong unit raises."""
    parts = [part.strip() for part in span.split(":")]
    if len(parts) not in (1, 3):
        raise BadRange(WHERE, text)
    numbers = [quantity_at(WHERE, place.kind, part) for part in parts]
    if len(numbers) == 1:
        return np.array(numbers)
    begin, end, step = numbers
    if not step > 0 or abs(end - begin) / step > MOST:
        raise BadRange(WHERE, text)
    count = math.floor(abs(end - begin) / step + 1e-9)
    return begin + math.copysign(step, end - begin) * np.arange(count + 1)


def _with_driver_held(
    method: Method, number: int, values: np.ndarray, condition: str, ranges: Sequence[str], by: Road
) -> list[VaryingRow]:
    """Rows in which one driver stands at each value; the others move."""
    driver = method.drivers[number]
    unit = "m" if driver.kind == "slide" else "rad"
    at_positions = isinstance(conditions.read(method.mechanism, condition), conditions.Slowest | conditions.Scaling)
    if len(method.drivers) == 1 and not at_positions:
        raise NoDimension(WHERE, driver.name, ())
    if any(text.partition("=")[0].strip() == driver.name for text in ranges):
        raise NoSuchDriver(WHERE, driver.name, ())
    return [_row(at, method, condition, (*ranges, f"{driver.name}={at!r} {unit}"), by) for at in values.tolist()]


def _with_measures(
    mechanism: Mechanism, place: DimensionPlace, values: np.ndarray, row: Callable[[float, Method], VaryingRow],
    plan: Plan,
) -> list[VaryingRow]:  # fmt: skip
    """Rows from the value nearest to the file's on to both sides, so that the assembly goes over step by step."""
    now = mechanism.given[place.path].si
    assert now is not None, "a dimension is a quantity"
    begin = int(np.argmin(np.abs(values - now)))
    start = _positions(plan(mechanism))
    rows: dict[int, VaryingRow] = {}
    for order in (range(begin, values.size), range(begin - 1, -1, -1)):
        sketch = dict(start)
        for k in order:
            value = float(values[k])
            try:
                # the mechanism of a changed text, sketched as it stood before
                changed = loading.loads(replaced(mechanism, place, value), name=mechanism.name, file=mechanism.file)
                fixed = changed.links[FRAME].points
                method = plan(replace(changed, sketch={p: z for p, z in sketch.items() if p not in fixed}))
            except GraphkinError as error:
                rows[k] = VaryingRow(value, None, error)
                continue
            sketch = _positions(method)
            rows[k] = row(value, method)
            start = sketch if k == begin else start
    return [rows[k] for k in sorted(rows)]


def _positions(method: Method) -> dict[str, complex]:
    """The moving points at the drawn position [m]."""
    mechanism, plot = method.mechanism, replay_all(method)
    fixed = mechanism.links[FRAME].points
    return {p: place_of(plot.position[p]) for p in mechanism.points if p not in fixed and p in plot.position}


def table_json(table: VaryingTable) -> dict[str, Plain]:
    """The table as one object: SI units and radians."""
    rows: list[Plain] = []
    for row in table.rows:
        answer: dict[str, Plain] = {"found": as_json(row.found)} if row.found else {"error": str(row.error)}
        rows.append({"value": row.value} | answer)
    return {
        "format": 1, "name": table.mechanism.name, "dimension": table.name, "condition": table.condition, "rows": rows,
    }  # fmt: skip
