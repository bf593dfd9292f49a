"""Constructions recorded once, as a flat program for many positions.

`recorder` replays them with quantities that only write down, on a `tape` of `operations`, how they come about; `calls`
makes NumPy calls of these, `columns` says where the results lie, `program` carries the calls out, and `lazy_plot` is
the plot that it gives. `calculated` writes down what is found by trial.
"""

from __future__ import annotations

from graphkin.running.compiled.lazy_plot import TABLES
from graphkin.running.compiled.operations import CannotRecord
from graphkin.running.compiled.program import Program, compiled_program

__all__ = ["TABLES", "CannotRecord", "Program", "compiled_program"]
