"""Sweeps as tables: CSV, JSON, JSON Lines, Parquet; for notebooks and other programs pandas, polars, Arrow, a diagram.

Files are written part by part, so that their length costs no memory. CSV and Parquet have mm and deg and say so in
their headers; JSON has SI units and radians, as `solve --json`: one object of columns (`.json`), which has to be whole
before it is written, or one object a position (`.jsonl`).
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.base.geometry import Array, number
from graphkin.base.plain import Plain
from graphkin.errors import Lang
from graphkin.errors.arguments import checked
from graphkin.model.quantities import EDGE, Unit, driven
from graphkin.outputs.files import UnknownEnding, beside, needed
from graphkin.studies.sweeps import Course, Road, Sweep, in_parts

if TYPE_CHECKING:
    from graphkin.outputs.diagram.page import DiagramPage

FORMATS = (".csv", ".json", ".jsonl", ".parquet")
MARKS = (b" [deg]", b" [mm]", b' [rad]": ', b' [m]": ', b'"format": 1', b"graphkin")
_SI = {name: Unit("" if name == "1" else name, name) for name in EDGE}
_SHOWN = 8  # rows at either end of a table in a notebook
Seen = Callable[[Sweep], None]  # a function that sees each part that is done


def write(
    path: Path, course: Course, names: tuple[str, ...], by: Road, force: bool = False, seen: Seen = lambda part: None
) -> None:
    """A table into a file, by its suffix; `seen` is shown each part. Raises FileInTheWay, NoFolder, CannotWrite,
    NeedsExtra."""
    parts = shown_parts(in_parts(course, names, by), seen)
    if path.suffix == ".parquet":
        pyarrow, parquet = needed("pyarrow", "parquet"), needed("pyarrow.parquet", "parquet")
        with beside(path, force, MARKS) as draft:
            writer: Any = None
            for part in parts:
                table = pyarrow.table(columns(part)).replace_schema_metadata({"writer": "graphkin"})
                writer = writer or parquet.ParquetWriter(draft, table.schema)
                writer.write_table(table)
            writer.close()
        return
    with beside(path, force, MARKS) as draft, draft.open("w", encoding="utf-8", newline="\n") as file:
        if path.suffix == ".json":
            file.write(json_text(course, parts) + "\n")
        else:
            file.writelines((json_lines if path.suffix == ".jsonl" else csv_lines)(course, parts))


def shown_parts(parts: Iterator[Sweep], seen: Seen) -> Iterator[Sweep]:
    """The parts, each shown to `seen` when it is done."""
    for part in parts:
        yield part
        seen(part)


def columns(part: Sweep, units: Mapping[str, Unit] = EDGE) -> dict[str, Array]:
    """By header, in mm and deg or so: the drivers' values, and each quantity as the terminal has it. Of vectors then x
    and y; where a guide of the frame gives a sign, the size, too."""
    unit = units[part.course.unit]
    table: dict[str, Array] = {f"{part.course.driver.name} [{unit.name}]": part.driven * unit.factor}
    for name, other, values in _others(part):
        table[f"{name} [{units[other].name}]"] = values * units[other].factor
    for entry in part.series:
        shown, factor = units[entry.unit].name or "1", units[entry.unit].factor
        if not entry.is_place:
            table[f"{entry.name} [{shown}]"] = entry.signed * factor
        if entry.along is not None and entry.vectors is not None:  # its value has a sign that its size has not
            table[f"{entry.name} size [{shown}]"] = entry.values * factor
        if entry.vectors is not None:
            table[f"{entry.name} x [{shown}]"] = entry.vectors.real * factor
            table[f"{entry.name} y [{shown}]"] = entry.vectors.imag * factor
    return table


def _others(part: Sweep) -> Iterator[tuple[str, str, Array]]:
    """The other drivers that move on the path: name, SI unit, values."""
    course = part.course
    for k, driver in enumerate(course.method.drivers):
        if k != course.swept and course.path.pace[k]:
            yield driver.name, driven(driver.kind == "slide"), course.path.start[k] + course.path.pace[k] * part.t


def csv_lines(course: Course, parts: Iterator[Sweep]) -> Iterator[str]:
    """The header, then the rows of each part; twelve digits, as RFC 4180 has it but for the line ends."""
    for k, part in enumerate(parts):
        table = columns(part)
        if k == 0:
            yield ",".join(f'"{name}"' if "," in name else name for name in table) + "\n"
        rows = np.column_stack(list(table.values())) + 0.0
        line = ",".join(["%.12g"] * rows.shape[1]) + "\n"
        yield (line * len(rows)) % tuple(rows.ravel().tolist())


def json_lines(course: Course, parts: Iterator[Sweep]) -> Iterator[str]:
    """An object for each position, each by itself: columns as in CSV, in SI units and radians."""
    for part in parts:
        table = columns(part, _SI)
        rows = np.column_stack(list(table.values())) + 0.0
        heads = (json.dumps(head, ensure_ascii=False).replace("%", "%%") for head in table)
        line = "{" + ", ".join(f"{head}: %s" for head in heads) + "}\n"
        numbers: Sequence[float | str] = rows.ravel().tolist()
        if not np.isfinite(rows).all():
            numbers = [value if math.isfinite(value) else "null" for value in rows.ravel().tolist()]
        yield (line * len(rows)) % tuple(numbers)


def json_text(course: Course, parts: Iterator[Sweep]) -> str:
    """One object: the driver's values, the range that is reached, and each quantity with its unit."""
    collected = list(parts)
    low, high = (None, None) if course.full_turn else course.reach
    others = [list(_others(part)) for part in collected]
    together: dict[str, Plain] = {
        name: {"unit": unit, "values": _all(part[k][2] for part in others)}
        for k, (name, unit, _) in enumerate(others[0])
    }
    events: list[list[Plain]] = [[{"at": number(course.value(e.at)), "kind": e.kind, "links": list(e.links)}
                                  for e in some] for some in (course.stops, course.changes)]  # fmt: skip
    quantities: dict[str, dict[str, Plain]] = {}
    for k, first in enumerate(collected[0].series):
        each = [part.series[k] for part in collected]
        quantities[first.name] = {"unit": first.unit, "values": _all(one.signed for one in each)}
        if first.along is not None and first.vectors is not None:
            quantities[first.name]["sizes"] = _all(one.values for one in each)
        if first.vectors is not None:
            vectors = np.concatenate([np.asarray(one.vectors) for one in each])
            quantities[first.name]["vectors"] = [[_finite(vector.real), _finite(vector.imag)] for vector in vectors]
    undefined = _all(part.undefined for part in collected)
    values = _all(part.driven for part in collected)
    data: dict[str, Plain] = {
        "format": 1, "name": course.method.mechanism.name,
        "driver": {"name": course.driver.name, "unit": course.unit, "values": values},
        **({"together": together} if together else {}),
        "range": {
            "full_turn": course.full_turn, "low": low, "high": high,
            "stops": events[0], "change_points": events[1],
            "not_reached": [float(value) for value in course.dropped],
            **({"undefined": undefined} if undefined else {}),
        },
        "quantities": quantities,
    }  # fmt: skip
    return json.dumps(data, ensure_ascii=False, allow_nan=False)


def _all(parts: Iterable[Array]) -> list[float | None]:
    return [_finite(value) for value in np.concatenate(list(parts))]


def _finite(value: float) -> float | None:
    """A number JSON can hold; what has no value there (a quotient by 0) is null."""
    return float(value) + 0.0 if math.isfinite(value) else None


class SweepFrames(Sweep):
    __doc__ = Sweep.__doc__

    def columns(self, si: bool = False) -> dict[str, Array]:
        """By heading, as in CSV: the driver's value, and each quantity; of vectors the size, then x and y.

        si    in rad and m, the arrays of the sweep itself, not copied; else in deg and mm
        """
        if not si:
            return columns(self)
        table: dict[str, Array] = {f"{self.driver} [{self.course.unit}]": self.driven}
        for entry in self.series:
            if not entry.is_place:
                table[f"{entry.name} [{entry.unit}]"] = entry.values
            if entry.vectors is not None:
                table[f"{entry.name} x [{entry.unit}]"] = entry.vectors.real
                table[f"{entry.name} y [{entry.unit}]"] = entry.vectors.imag
        return table

    def to_arrow(self, si: bool = False) -> Any:
        """A `pyarrow.Table` of the columns; arrays of the sweep are not copied. Needs pyarrow."""
        import pyarrow

        return pyarrow.table(self.columns(si))

    def to_pandas(self, si: bool = False) -> Any:
        """A `pandas.DataFrame` of the columns, in deg and mm or in SI. Needs pandas."""
        import pandas  # type: ignore[import-not-found, import-untyped, unused-ignore]

        return pandas.DataFrame(self.columns(si), copy=False)

    def to_polars(self, si: bool = False) -> Any:
        """A `polars.DataFrame` of the columns; by pyarrow, so that nothing is copied. Needs polars and pyarrow."""
        import polars  # type: ignore[import-not-found, unused-ignore]

        return polars.from_arrow(self.to_arrow(si))

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """Whatever takes Arrow (polars, pandas, DuckDB) takes a sweep."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    @checked
    def figure(self, lang: Lang = "en") -> DiagramPage:
        """The motion diagram, a figure of matplotlib's: to be changed, or saved. Raises NothingToDraw."""
        from graphkin.outputs import diagram

        return diagram.figure(self.course, tuple(self), lang, self.by)

    @checked
    def save(self, path: str | Path, lang: Lang = "en", *, force: bool = False) -> Path:
        """Write a table (.csv, .json, .jsonl, .parquet) or the motion diagram (.svg, .png, .pdf), by the file's ending.

        force   even over a file that graphkin did not write
        """
        from graphkin.outputs import diagram

        file = Path(path)
        if file.suffix.lower() in FORMATS:
            write(file, self.course, tuple(self), self.by, force)
        elif file.suffix.lower() not in diagram.FORMATS:
            raise UnknownEnding(str(file), (*FORMATS, *diagram.FORMATS))
        else:
            diagram.write(file, self.course, tuple(self), lang, self.by, force)
        return file

    def _repr_svg_(self) -> str | None:
        """A notebook shows the diagram; nothing of a sweep that has none, of instant centres alone."""
        from graphkin.outputs.diagram import NothingToDraw

        try:
            return self.figure()._repr_svg_()
        except NothingToDraw:
            return None

    def _repr_html_(self) -> str:
        """The mechanism, which plays, over the first and last rows, in deg and mm."""
        import graphkin

        table, count = self.columns(), self.t.size
        rows = [*range(count)] if count <= 2 * _SHOWN else [*range(_SHOWN), None, *range(count - _SHOWN, count)]
        cells = (("…" if k is None else f"{column[k]:.6g}" for column in table.values()) for k in rows)
        lines = [_html_row("th", table), *(_html_row("td", row) for row in cells)]
        playing = graphkin.play(self.course.method)._repr_html_()
        return f"{playing}\n<table>\n<caption>{escape(repr(self)[1:-1])}</caption>\n" + "\n".join(lines) + "\n</table>"


def _html_row(kind: str, cells: Iterable[str]) -> str:
    return f"<tr>{''.join(f'<{kind}>{escape(cell)}</{kind}>' for cell in cells)}</tr>"
