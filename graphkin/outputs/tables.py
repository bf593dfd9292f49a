"""Tables."""

from __future__ import annotations

import io
import json
import math
from collections.abc import Callable, Iterator, Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from graphkin.errors import GraphkinError, Lang
from graphkin.model.quantities import EDGE, Unit, driven
from graphkin.outputs.files import beside
from graphkin.studies.sweeps import Course, Road, Series, Sweep, in_parts

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORMATS = (".csv", ".json", ".jsonl", ".parquet")
MARKS = (b" [deg]", b" [mm]", b' [rad]": ', b' [m]": ', b'"format": 1', b"graphkin")
_SI = {name: Unit("" if name == "1" else name, name) for name in EDGE}
_LINES = 4096
"""So many lines are made at once."""
Seen = Callable[[Sweep], None]
"""Is shown each part that is done."""


class NoParquet(GraphkinError):
    """Parquet is asked for, and its library is not there."""

    path: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{path}: writing Parquet needs pyarrow: pip install 'graphkin[parquet]'. Or write .csv or .json.",
        "zh": "{path}：写 Parquet 需要 pyarrow：pip install 'graphkin[parquet]'。也可改写 .csv 或 .json。",
    }


def write(
    path: Path, course: Course, names: tuple[str, ...], by: Road, force: bool = False, seen: Seen = lambda part: None
) -> None:
    """A table into a file, by its suffix; `seen` is shown each part.

    Raises FileInTheWay, NoFolder, CannotWrite, NoParquet.
    """
    found = told(in_parts(course, names, by), seen)
    if path.suffix == ".parquet":
        _write_parquet(path, course, found, force)
        return
    with beside(path, force, MARKS) as draft, draft.open("w", encoding="utf-8", newline="\n") as file:
        if path.suffix == ".json":
            file.write(json_text(course, found) + "\n")
        else:
            for lines in (json_lines if path.suffix == ".jsonl" else csv_lines)(course, found):
                file.write(lines)


def told(found: Iterator[Sweep], seen: Seen) -> Iterator[Sweep]:
    """The parts, each shown to `seen` when it is done."""
    for part in found:
        yield part
        seen(part)


# --- columns ----------------------------------------------------------------------------------


def columns(part: Sweep, units: Mapping[str, Unit] = EDGE) -> dict[str, np.ndarray]:
    """By header, in mm and deg or so: the drivers' values, and each quantity as the terminal has it.

    Of vectors then x and y; where a guide of the frame gives a sign, the size, too.
    """
    driver = part.course.driver.name
    unit = units[part.course.unit]
    found = {f"{driver} [{unit.name}]": part.driven * unit.factor}
    for name, other, values in _others(part):
        found[f"{name} [{units[other].name}]"] = values * units[other].factor
    for entry in part.series:
        found |= _columns(entry, units[entry.unit])
    return found


def _columns(entry: Series, shown: Unit) -> Iterator[tuple[str, np.ndarray]]:
    unit, factor = shown.name or "1", shown.factor
    if not entry.is_place:
        yield f"{entry.name} [{unit}]", entry.signed * factor
    if _has_size(entry):
        yield f"{entry.name} size [{unit}]", entry.values * factor
    if entry.vectors is not None:
        yield f"{entry.name} x [{unit}]", entry.vectors.real * factor
        yield f"{entry.name} y [{unit}]", entry.vectors.imag * factor


def _has_size(entry: Series) -> bool:
    """Whether its value has a sign that its size has not."""
    return entry.along is not None and entry.vectors is not None


def _others(part: Sweep) -> Iterator[tuple[str, str, np.ndarray]]:
    """The other drivers that move on the path: name, SI unit, values."""
    course = part.course
    for k, driver in enumerate(course.method.drivers):
        if k != course.swept and course.path.pace[k]:
            unit = driven(driver.kind == "slide")
            yield driver.name, unit, course.path.start[k] + course.path.pace[k] * part.t


def csv_lines(course: Course, found: Iterator[Sweep]) -> Iterator[str]:
    """The header, then the rows of each part; twelve digits, as RFC 4180 has it but for the line ends."""
    for number, part in enumerate(found):
        table = columns(part)
        if number == 0:
            yield ",".join(_quoted(name) for name in table) + "\n"
        rows = np.column_stack(list(table.values())) + 0.0
        line = ",".join(["%.12g"] * rows.shape[1]) + "\n"
        yield (line * len(rows)) % tuple(rows.ravel().tolist())


def _quoted(name: str) -> str:
    return f'"{name}"' if "," in name else name


# --- JSON -------------------------------------------------------------------------------------


def json_text(course: Course, found: Iterator[Sweep]) -> str:
    """One object: the driver's values, the range that is reached, and each quantity with its unit."""
    collected = list(found)
    low, high = course.reach
    values = _all([part.driven for part in collected])
    data: dict[str, Any] = {
        "format": 1,
        "name": course.method.mechanism.name,
        "driver": {"name": course.driver.name, "unit": course.unit, "values": values},
        **({"together": others} if (others := _together(collected)) else {}),
        "range": {
            "full_turn": course.full_turn,
            "low": None if course.full_turn else low,
            "high": None if course.full_turn else high,
            "stops": [_event(course, stop) for stop in course.stops],
            "change_points": [_event(course, change) for change in course.changes],
            "not_reached": [float(value) for value in course.dropped],
            **({"undefined": undefined} if (undefined := _all([part.undefined for part in collected])) else {}),
        },
        "quantities": {
            entry.name: _quantity([part.series[k] for part in collected])
            for k, entry in enumerate(collected[0].series)
        },
    }
    return json.dumps(data, ensure_ascii=False, allow_nan=False)


def json_lines(course: Course, found: Iterator[Sweep]) -> Iterator[str]:
    """An object for each position, each by itself: columns as in CSV, in SI units and radians."""
    for part in found:
        table = columns(part, _SI)
        rows = np.column_stack(list(table.values())) + 0.0
        heads = (json.dumps(head, ensure_ascii=False).replace("%", "%%") for head in table)
        line = "{" + ", ".join(f"{head}: %s" for head in heads) + "}\n"
        for some in np.array_split(rows, 1 + len(rows) // _LINES):
            numbers: list[Any] = some.ravel().tolist()
            if not np.isfinite(some).all():
                numbers = [number if math.isfinite(number) else "null" for number in numbers]
            yield (line * len(some)) % tuple(numbers)
def _together(found: list[Sweep]) -> dict[str, Any]:
    """The other drivers that move, by name."""
    rows = [list(_others(part)) for part in found]
    return {
        name: {"unit": unit, "values": _all([part[k][2] for part in rows])} for k, (name, unit, _) in enumerate(rows[0])
    }


def _event(course: Course, event: Any) -> dict[str, Any]:
    return {"at": float(course.value(event.at)), "kind": event.kind, "links": list(event.links)}


def _quantity(found: list[Series]) -> dict[str, Any]:
    data: dict[str, Any] = {"unit": found[0].unit, "values": _all([entry.signed for entry in found])}
    if _has_size(found[0]):
        data["sizes"] = _all([entry.values for entry in found])
    if found[0].vectors is not None:
        vectors = np.concatenate([np.asarray(entry.vectors) for entry in found])
        data["vectors"] = [[_number(v.real), _number(v.imag)] for v in vectors]
    return data


def _all(found: list[np.ndarray]) -> list[float | None]:
    return [_number(value) for value in np.concatenate(found)]


def _number(value: float) -> float | None:
    """A number JSON can hold; what has no value there (a quotient by 0) is null."""
    return float(value) + 0.0 if math.isfinite(value) else None


# --- Parquet ----------------------------------------------------------------------------------


def _write_parquet(path: Path, course: Course, found: Iterator[Sweep], force: bool) -> None:
    try:
        import pyarrow  # type: ignore[import-not-found, unused-ignore]
        import pyarrow.parquet  # type: ignore[import-not-found, unused-ignore]
    except ImportError:
        raise NoParquet(str(path)) from None
    with beside(path, force, MARKS) as draft:
        writer: Any = None
        for part in found:
            table = pyarrow.table(columns(part)).replace_schema_metadata({"writer": "graphkin"})
            writer = writer or pyarrow.parquet.ParquetWriter(draft, table.schema)
            writer.write_table(table)
        writer.close()


SHOWN = 8
"""Rows at either end of a table in a notebook."""


class SweepFrames(Sweep):
    __doc__ = Sweep.__doc__

    def columns(self, si: bool = False) -> dict[str, np.ndarray]:
        """By heading, as in CSV: the driver's value, and each quantity; of vectors the size, then x and y.

        si    in rad and m, the arrays of the sweep itself; else in deg and mm
        """
        return _in_si(self) if si else columns(self)

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

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        """Whatever takes Arrow (polars, pandas, DuckDB) takes a sweep."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def figure(self, lang: Lang = "en") -> Figure:
        """The motion diagram, by matplotlib: to be changed, or saved with `savefig`. Raises NothingToDraw."""
        from graphkin.outputs import diagram

        return diagram.figure(self.course, tuple(self), lang, self.by)

    def _repr_svg_(self) -> str | None:
        """A notebook shows the diagram; nothing of a sweep that has none, of instant centres alone."""
        from graphkin.outputs import diagram

        text = io.StringIO()
        try:
            page = self.figure()
        except diagram.NothingToDraw:
            return None
        with diagram.settings():
            title = self.course.method.mechanism.headline("en")
            page.savefig(text, format="svg", metadata=diagram.metadata(".svg", title))
        return text.getvalue()

    def _repr_html_(self) -> str:
        """Its first and last rows, in deg and mm."""
        table = self.columns()
        count = self.t.size
        rows = [*range(count)] if count <= 2 * SHOWN else [*range(SHOWN), None, *range(count - SHOWN, count)]
        lines = [_html_row("th", table)]
        lines += [_html_row("td", ("…" if k is None else f"{column[k]:.6g}" for column in table.values())) for k in rows]
        return f"<table>\n<caption>{escape(repr(self)[1:-1])}</caption>\n" + "\n".join(lines) + "\n</table>"


def _html_row(kind: str, cells: Any) -> str:
    return f"<tr>{''.join(f'<{kind}>{escape(cell)}</{kind}>' for cell in cells)}</tr>"


def _in_si(sweep: Sweep) -> dict[str, np.ndarray]:
    """The columns of `tables.columns`, in SI: what the sweep holds is not copied."""
    found = {f"{sweep.driver} [{sweep.course.unit}]": sweep.driven}
    for entry in sweep.series:
        if not entry.is_place:
            found[f"{entry.name} [{entry.unit}]"] = entry.values
        if entry.vectors is not None:
            found[f"{entry.name} x [{entry.unit}]"] = entry.vectors.real
            found[f"{entry.name} y [{entry.unit}]"] = entry.vectors.imag
    return found


def framed(sweep: Sweep) -> SweepFrames:
    """The same sweep, as programs and notebooks take it."""
    return SweepFrames(**vars(sweep))
