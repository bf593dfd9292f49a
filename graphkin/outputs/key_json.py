"""A key as JSON, and back: all that a problem is marked by. Version 1; SI units, radians."""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.plain import Plain, built, plain
from graphkin.construction import SCALES
from graphkin.errors import BadKey, Where
from graphkin.marking.key import Hypotheses, Key, KeyEntry, KeyStep, Marking, Name

FORMAT, KIND = 1, "graphkin key"
Json = dict[str, Plain]
Read = Mapping[str, Any]  # plain data as it is read, before it is looked at


def key_text(key: Key) -> str:
    """The file's text: one line a quantity and a mistake, so that it can be read and changed."""
    data = key_data(key)
    lines = [f' {_line(name)}: {_line(value)},' for name, value in data.items() if not isinstance(value, list)]
    lists = [f" {_line(name)}: [\n" + ",\n".join(f"  {_line(item)}" for item in value) + "\n ]"
             for name, value in data.items() if isinstance(value, list)]  # fmt: skip
    return "{\n" + "\n".join(lines) + "\n" + ",\n".join(lists) + "\n}\n"


def key_data(key: Key) -> Json:
    """As plain data."""
    singles = key.singles
    tables: list[dict[str, str]] = [{} for _ in singles.names]  # a mistake without one scatters as right values do
    if singles.together is not None:  # the correlations above the diagonal, in hundredths, a byte each, as base64
        above = np.triu_indices(singles.values.shape[1], 1)
        rows = np.round(100 * singles.together[:, *above]).astype(np.int8)
        tables = [{"together": base64.b64encode(row.tobytes()).decode()} for row in rows]
    mistakes = zip(singles.names, singles.values, singles.scatters, tables, strict=True)
    return {
        "kind": KIND, "format": FORMAT, "name": key.name, "title": dict(key.title), "coincident": key.coincident,
        "mechanism": key.text, "marking": plain(key.marking),
        "quantities": [
            {name: value for name, value in plain(entry).items() if name != "doubt" or value} for entry in key.entries
        ],
        "together": [[round(float(x), 6) for x in row] for row in key.together],
        "steps": plain(key.steps),
        "mistakes": [
            {"names": plain(names), "values": _row(values), "scatters": _row(scatters), **own}
            for names, values, scatters, own in mistakes
        ],
        **({"positions": [key_data(one) for one in key.further]} if key.further else {}),
    }  # fmt: skip


def _row(values: Array) -> list[float | None]:
    return [float(f"{x:.12g}") if math.isfinite(x) else None for x in values.tolist()]


def _line(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def key_of(text: str, where: Where) -> Key:
    """The key that a text holds. Raises BadKey."""

    def refused(constant: str) -> float:
        raise ValueError(f"{constant} is no number")

    try:
        return _key(json.loads(text, parse_constant=refused))
    except RecursionError:
        raise BadKey(where, "nested too deep") from None
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as problem:
        kind = "" if isinstance(problem, ValueError) else f"{type(problem).__name__}: "
        raise BadKey(where, f"{kind}{problem}"[:200]) from None


def _require(good: bool, what: str) -> None:
    if not good:
        raise ValueError(what)


def _key(data: Read) -> Key:
    """A key from plain data; whatever is not as it should be raises."""
    _require(isinstance(data, dict) and data.get("kind") == KIND, "kind")
    _require(data.get("format") == FORMAT, f"format {data.get('format')!r}, not {FORMAT}")
    entries = tuple(map(_entry, data["quantities"]))
    _require(bool(entries), "quantities")
    count = len(entries)
    together = _table(data["together"], count)
    _require(together.shape == (count, count) and np.allclose(together, together.T), "together")
    marking: Marking = built(Marking, {"follows": 1.0, **data["marking"]})
    known = SCALES.keys() <= marking.lengths.keys() and {*SCALES.values()} <= marking.scales.keys()
    sizes = (*marking.lengths.values(), marking.angle, marking.relative)
    _require(known and min(sizes) >= 0 and marking.sigmas > 0 and 0 <= marking.follows <= 1, "marking")
    name, text, coincident = (built(str, data[part]) for part in ("name", "mechanism", "coincident"))
    return Key(
        name, text, coincident, marking, entries, together,
        _mistakes(data["mistakes"], count), built(Mapping[str, str], data["title"]),
        built(tuple[KeyStep, ...], data["steps"]), tuple(map(_key, data.get("positions", ()))),
    )  # fmt: skip


def _entry(item: Read) -> KeyEntry:
    entry: KeyEntry = built(KeyEntry, {"doubt": "", **item})
    _require(entry.scatter > 0 and entry.tolerance >= 0 and entry.points >= 0, f"quantities: {entry.text}")
    return entry


def _mistakes(items: Sequence[Read], count: int) -> Hypotheses:
    names = tuple(built(tuple[Name, ...], item["names"]) for item in items)
    values, scatters = (_table([item[key] for item in items], count) for key in ("values", "scatters"))
    _require(all(names) and not np.any(scatters <= 0), "mistakes")
    rows, columns = np.triu_indices(count, 1)
    together = np.full((len(items), count, count), np.nan)  # NaN where nothing is said
    for table, item in zip(together, items, strict=True):
        if (text := item.get("together")) is not None:
            parts = np.frombuffer(base64.b64decode(text, validate=True), dtype=np.int8) / 100
            _require(len(parts) == len(rows) and bool(np.all(np.abs(parts) <= 1)), "together")
            np.fill_diagonal(table, 1.0)
            table[rows, columns] = table[columns, rows] = parts
    return Hypotheses(names, values, scatters, together)


def _table(rows: list[list[float | None]], count: int) -> Array:
    """(rows, count); None is NaN."""
    kinds = {type(x) for row in rows for x in row}
    _require(kinds <= {int, float, type(None)} and all(len(row) == count for row in rows), "table")
    table = np.array(rows, dtype=float).reshape(len(rows), count)
    _require(not np.isinf(table).any(), "table")
    return table
