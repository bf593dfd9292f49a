"""Constructions recorded once, as a flat program for many positions.

`recorder` replays them with quantities that are only `written` down, on a `tape` of `operations` and `products`;
`calculated` writes down what is found by trial. `layout` says where results are to lie, and the `writer` makes NumPy
`calls` of what is `needed` for them, `vectors` as wholes, with few changes of `signs`. `program` carries them out, a
`run` at a time, in `memory` that is lent again, and `lazy_plot` is the plot that it gives, read by its `columns`.
"""

from __future__ import annotations

from graphkin.running.compiled.columns import Entry
from graphkin.running.compiled.lazy_plot import TABLES
from graphkin.running.compiled.operations import CannotRecord
from graphkin.running.compiled.program import Program, compiled_program

__all__ = ["TABLES", "CannotRecord", "Entry", "Program", "compiled_program"]
