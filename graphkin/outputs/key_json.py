"""A key as JSON, and back: all that a problem is marked by. Version 1; SI units, radians."""

from __future__ import annotations

import base64
import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any, cast, get_args

import numpy as np

from graphkin.base.geometry import Array
from graphkin.base.plain import Plain
from graphkin.errors import BadKey, Where
from graphkin.marking.key import Doubt, Hypotheses, Key, KeyEntry, KeyStep, Marking, Name, Sort

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
    marking, singles = key.marking, key.singles
    tables: list[dict[str, str]] = [{} for _ in singles.names]  # a mistake without one scatters as right values do
    if singles.together is not None:  # the correlations above the diagonal, in hundredths, a byte each, as base64
        above = np.triu_indices(singles.values.shape[1], 1)
        rows = np.round(100 * singles.together[:, *above]).astype(np.int8)
        tables = [{"together": base64.b64encode(row.tobytes()).decode()} for row in rows]
    mistakes = zip(singles.names, singles.values, singles.scatters, tables, strict=True)
    return {
        "kind": KIND, "format": FORMAT, "name": key.name, "title": dict(key.title), "coincident": key.coincident,
        "mechanism": key.text,
        "marking": {
            "lengths": dict(marking.lengths), "angle": marking.angle, "scales": dict(marking.scales),
            "sigmas": marking.sigmas, "relative": marking.relative, "follows": marking.follows,
        },
        "given": list(key.given),
        "quantities": [
            {each.name: getattr(entry, each.name) for each in fields(KeyEntry) if each.name != "doubt" or entry.doubt}
            for entry in key.entries
        ],
        "together": [[round(float(x), 6) for x in row] for row in key.together],
        "steps": [
            {"plane": step.plane, "left": list(step.left), "right": list(step.right), "gives": list(step.gives)}
            for step in key.steps
        ],
        "mistakes": [
            {"names": [list(name) for name in names], "values": _row(values), "scatters": _row(scatters), **own}
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
        data = json.loads(text, parse_constant=refused)
    except RecursionError:
        raise BadKey(where, "nested too deep") from None
    except ValueError as problem:
        raise BadKey(where, str(problem)) from None
    try:
        return _KeyReader(where).key(data)
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as problem:
        raise BadKey(where, f"{type(problem).__name__}: {problem}"[:200]) from None


class _KeyReader:
    """Takes plain data apart; whatever is not as it should be raises."""

    def __init__(self, where: Where) -> None:
        self.where = where

    def key(self, data: Read) -> Key:
        self._require(isinstance(data, dict) and data.get("kind") == KIND, "kind")
        self._require(data.get("format") == FORMAT, f"format {data.get('format')!r}, not {FORMAT}")
        entries = tuple(self._entry(item) for item in data["quantities"])
        self._require(bool(entries), "quantities")
        count = len(entries)
        together = self._table(data["together"], count)
        self._require(together.shape == (count, count) and np.allclose(together, together.T), "together")
        text = [data[name] for name in ("name", "mechanism", "coincident")]
        self._require(all(isinstance(part, str) for part in text), "mechanism")
        item, planes = data["marking"], ("position", "velocity", "acceleration")
        lengths = {plane: self._number(item["lengths"][plane], plane) for plane in planes}
        scales = {name: self._number(item["scales"][name], "scales") for name in ("length", "velocity", "acceleration")}
        angle, sigmas, relative = (self._number(item[name], name) for name in ("angle", "sigmas", "relative"))
        follows = self._number(item.get("follows", 1.0), "follows")
        self._require(min(*lengths.values(), angle, relative) >= 0 and sigmas > 0 and 0 <= follows <= 1, "marking")
        return Key(
            text[0], text[1], text[2], Marking(lengths, angle, scales, sigmas, relative, follows), entries,
            tuple(self._number(x, "given") for x in data["given"]), together, self._mistakes(data["mistakes"], count),
            {str(lang): str(title) for lang, title in data["title"].items()},
            tuple(KeyStep(str(step["plane"]), *(tuple(map(str, step[name])) for name in ("left", "right", "gives")))
                  for step in data["steps"]),
            tuple(self.key(item) for item in data.get("positions", ())),
        )  # fmt: skip

    def _entry(self, item: Read) -> KeyEntry:
        what = f"quantities: {item['text']}"
        self._require(isinstance(item["text"], str) and item["sort"] in ("sense", "size", "angle"), what)
        right, scatter, tolerance, points = (
            self._number(item[name], what) for name in ("right", "scatter", "tolerance", "points")
        )
        self._require(scatter > 0 and tolerance >= 0 and points >= 0 and isinstance(item["unit"], str), what)
        doubt = item.get("doubt", "")
        self._require(doubt in get_args(Doubt), what)
        return KeyEntry(item["text"], item["unit"], cast(Sort, item["sort"]), right, scatter, tolerance, points, doubt)

    def _mistakes(self, items: Iterable[Read], count: int) -> Hypotheses:
        names, values, scatters, together = [], [], [], []
        rows, columns = np.triu_indices(count, 1)
        for item in items:
            name = tuple(cast(Name, tuple(str(part) for part in one)) for one in item["names"])
            self._require(bool(name) and all(len(one) == 4 for one in name), "mistakes")
            names.append(name)
            values.append(item["values"])
            scatters.append(item["scatters"])
            table, text = np.full((count, count), np.nan), item.get("together")  # NaN where nothing is said
            if text is not None:
                parts = np.frombuffer(base64.b64decode(text, validate=True), dtype=np.int8) / 100
                self._require(len(parts) == len(rows) and bool(np.all(np.abs(parts) <= 1)), "together")
                np.fill_diagonal(table, 1.0)
                table[rows, columns] = table[columns, rows] = parts
            together.append(table)
        tables = self._table(values, count), self._table(scatters, count)
        self._require(not np.any(tables[1] <= 0), "mistakes")
        return Hypotheses(tuple(names), *tables, np.array(together).reshape(-1, count, count))

    def _table(self, rows: list[list[float | None]], count: int) -> Array:
        """(rows, count); None is NaN."""
        kinds = {type(x) for row in rows for x in row}
        self._require(kinds <= {int, float, type(None)} and all(len(row) == count for row in rows), "table")
        table = np.array(rows, dtype=float).reshape(len(rows), count)
        self._require(not np.isinf(table).any(), "table")
        return table

    def _number(self, value: object, what: str) -> float:
        self._require(isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value), what)
        return float(cast(float, value))

    def _require(self, good: bool, what: str) -> None:
        if not good:
            raise BadKey(self.where, what)
