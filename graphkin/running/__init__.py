"""The runner: a method over driver values.

`replay_all` carries a method out, at the drawn position or at any others. How a mechanism gets there is `path`: driver
values along a line, with the dead points where it ends and the change points that it goes through. `tracing` finds
them: it looks along the whole path in small steps (`scanning`), or follows it where links are fitted (`continuation`,
from `nodes` that `looking` finds); `singularities` looks closely where two loci come to touch. `reaching` takes a
mechanism to other positions, and `many_positions` does many of them at once, by the `program` made of
the steps.
"""

from __future__ import annotations

from graphkin.running.replaying import replay_all

__all__ = ["replay_all"]
