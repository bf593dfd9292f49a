"""What the planner cannot do with a mechanism, said before it tries."""

from __future__ import annotations

from graphkin.errors import NotYetSolved
from graphkin.mechanism import Mechanism

__all__ = ["refuse_unsolved"]


def refuse_unsolved(mechanism: Mechanism) -> None:
    """Gears, rolling and cams, wheels driven by themselves, and positions given by a pose."""
    for table, pairs in (("gear", mechanism.gears), ("roll", mechanism.rolls), ("cam", mechanism.cams)):
        if pairs:
            raise NotYetSolved(mechanism.where(table, 0), f"[[{table}]]")
    for k, driver in enumerate(mechanism.drivers):
        if driver.kind == "spin":
            raise NotYetSolved(mechanism.where("driver", k, "link"), "a driver with link = ..")
        if driver.value is None:
            raise NotYetSolved(mechanism.where("pose", 0), "[[pose]]")
