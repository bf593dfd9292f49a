"""Constructions replayed by one program for many positions.

`recorder` replays them once with quantities that note each real operation on a `tape`; `fitting` notes what is
calculated by Newton's method. `in_numpy` and `in_c` write the tape as NumPy calls and as a C function; a `program`
carries either out, block by block, and gives a plot.
"""

from __future__ import annotations

from graphkin.running.program.program import ReplayProgram, recorded_program
from graphkin.running.program.recorder import TABLES, Entry
from graphkin.running.program.tape import CannotRecord

__all__ = ["TABLES", "CannotRecord", "Entry", "ReplayProgram", "recorded_program"]
