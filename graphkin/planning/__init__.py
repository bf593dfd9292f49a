"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once: a `Method`.
"""

from __future__ import annotations

from graphkin.planning.method import Method
from graphkin.planning.planner import plan, with_other_points

__all__ = ["Method", "plan", "with_other_points"]
