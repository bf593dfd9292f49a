"""graphkin: graphical kinematics for planar mechanisms.

A mechanism is one TOML file. graphkin draws it to scale, writes its vector equations, constructs its
velocity and its acceleration polygon step by step, and proves them right against an analytic solution.

    mechanism.toml -- loading --> Mechanism     what the machine is; frozen, holds no position
    Mechanism -- planning.plan --> Method       three constructions, planned once, from topology
    Method + driver values -- running --> Plot  named points and quantities, scalars or arrays
    Plot -- sheet --> Sheet -- outputs --> SVG
    Mechanism -- analytic --> Motion            the other road; it never reads a construction
    check: Plot, or a drawing file, beside Motion

    subjects (centres, design): Construction -- drafting.replay --> Board of points, lines, circles, numbers

A module imports only from those before it in `ORDER`. A construction is data: a reader of its steps (replay,
words, sheet, check) handles every kind of step, and the type checker sees to that. The steps of `construction` draw a
mechanism and its polygons, on complex numbers; `drafting` is beside them, for what is no polygon. Words come before
design as long as design words itself.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

ORDER = (
    "value", "errors", "geometry", "construction", "drafting", "pairs", "mechanism", "naming", "motions",
    "quantities", "loading", "library", "planning", "running", "seal", "analytic", "freedoms", "assur", "readings",
    "agreement", "centres", "linkages", "words", "design", "sweeps", "marking", "check", "results", "reports", "sheet",
    "outputs", "equations", "finding", "api", "batches", "submissions", "grading", "problems", "platforms", "cli",
)  # fmt: skip

_WHERE = {
    "load": "api",
    "plan": "api",
    "replay": "api",
    "motion": "analytic",
    "Drawing": "api",
    "explain": "words",
    "measure": "check",
    "sweep": "api",
    "sweep_many": "batches",
    "GraphkinError": "errors",
}

__all__ = ["Drawing", "GraphkinError", "explain", "load", "measure", "motion", "plan", "replay", "sweep", "sweep_many"]

if TYPE_CHECKING:
    from graphkin.analytic import motion
    from graphkin.api import Drawing, load, plan, replay, sweep
    from graphkin.batches import sweep_many
    from graphkin.check import measure
    from graphkin.errors import GraphkinError
    from graphkin.words import explain


def __getattr__(name: str) -> Any:
    """Public names are imported when first used, so that a command loads only what it needs."""
    if name not in _WHERE:
        raise AttributeError(f"module 'graphkin' has no attribute {name!r}")
    return getattr(import_module(f"graphkin.{_WHERE[name]}"), name)
