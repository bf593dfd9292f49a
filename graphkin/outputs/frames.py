"""A sweep as other programs and notebooks take it: pandas, polars, Arrow, a diagram, a table."""

from __future__ import annotations

import io
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from graphkin.errors import Lang
from graphkin.outputs.tables import columns
from graphkin.studies import sweeps

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN = 8
"""Rows at either end of a table in a notebook."""


class SweepFrames(sweeps.Sweep):
    __doc__ = sweeps.Sweep.__doc__

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
        lines = [_row("th", table)]
        lines += [_row("td", ("…" if k is None else f"{column[k]:.6g}" for column in table.values())) for k in rows]
        return f"<table>\n<caption>{escape(repr(self)[1:-1])}</caption>\n" + "\n".join(lines) + "\n</table>"


def _row(kind: str, cells: Any) -> str:
    return f"<tr>{''.join(f'<{kind}>{escape(cell)}</{kind}>' for cell in cells)}</tr>"


def _in_si(sweep: sweeps.Sweep) -> dict[str, np.ndarray]:
    """The columns of `tables.columns`, in SI: what the sweep holds is not copied."""
    found = {f"{sweep.driver} [{sweep.course.unit}]": sweep.driven}
    for entry in sweep.series:
        if not entry.is_place:
            found[f"{entry.name} [{entry.unit}]"] = entry.values
        if entry.vectors is not None:
            found[f"{entry.name} x [{entry.unit}]"] = entry.vectors.real
            found[f"{entry.name} y [{entry.unit}]"] = entry.vectors.imag
    return found


def framed(sweep: sweeps.Sweep) -> SweepFrames:
    """The same sweep, as programs and notebooks take it."""
    return SweepFrames(**vars(sweep))
