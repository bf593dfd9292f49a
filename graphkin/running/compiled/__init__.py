"""Constructions recorded once, as a flat program for many positions.

`recorder` replays them with quantities that only write down, on a `tape` of `operations` and `products`, how they come
about; `layout` says where the results are to lie, and the `writer` makes NumPy `calls` of these. `program` carries them
out, in `memory` that is lent again, and `lazy_plot` is the plot that it gives, read by its `columns`. `calculated`
writes down what is found by trial.
"""

from __future__ import annotations

from graphkin.running.compiled.columns import Entry
from graphkin.running.compiled.lazy_plot import TABLES
from graphkin.running.compiled.operations import CannotRecord
from graphkin.running.compiled.program import Program, compiled_program

__all__ = ["TABLES", "CannotRecord", "Entry", "Program", "compiled_program"]
