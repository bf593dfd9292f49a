"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once; `replay_all` carries them out, for the drawn
position or for any driver values, scalars or arrays.
"""

from __future__ import annotations

from graphkin.methods.method import Method
from graphkin.methods.planner import plan, with_other_points
from graphkin.methods.replaying import replay_all

__all__ = ["Method", "plan", "replay_all", "with_other_points"]
