"""graphkin: graphical kinematics for planar mechanisms.

A mechanism is one TOML file. graphkin draws it to scale, writes its vector equations, constructs its
velocity and its acceleration polygon step by step, and proves them right against an analytic solution.

    mechanism.toml -- loading --> Mechanism     what the machine is; frozen, holds no position
    Mechanism -- planning.plan --> Method       three constructions, planned once, from topology
    Method + driver values -- running --> Plot  named points and quantities, scalars or arrays
    Plot -- sheet --> Sheet -- outputs --> SVG
    Mechanism -- analytic --> Motion            the other road; it never reads a construction

    subjects: centres, linkages, design, sweeps, finding    data; what of it is drawn, by drafting.replay on a Board
    homework: submissions  whatever students hand in -> the numbers in it, SI
              marking      a Key of a Method, and numbers -> verdicts, own values carried on, likely mistakes
              grading      a key and files -> a record a submission
              problems     a template with ranges -> a mechanism for each student, posed well and tellable
              handouts     a problem or its solution on paper, from what `say` and `sheet` make
              platforms    sets and records -> files of teaching platforms, and back
    check: Plot, or a drawing file, beside Motion           results: all of it as plain data
    any of these -- say --> lines in either language        -- sheet, outputs, equations --> files

A module imports only from those before it in `ORDER`. A construction is data: a reader of its steps (replay,
say, sheet, check) handles every kind of step, and the type checker sees to that. The steps of `construction` draw a
mechanism and its polygons, on complex numbers; `drafting` is beside them, for what is no polygon. A subject makes data
and knows no language; say, sheet, outputs and platforms read any subject's data.

How to add a subject:
1. A package with a public face of one page, its line in `ORDER` before `say`: data made of a mechanism, a method or
   numbers. Its errors in a file of `errors`.
2. `say/phrases/SUBJECT.py`, and a reader `say/SUBJECT.py`: its data and a language -> lines.
3. `sheet/SUBJECT_sheet.py` where there is something to draw: its data -> Sheet.
4. A command in `cli`, its line in `COMMANDS` there: parse, call one function, print.
5. Its command lines, in both languages, in tests/golden.py. test_order and test_catalogue hold it to the house's laws.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.2.0"

ORDER = (
    "value", "kept", "waiting", "sending", "errors", "geometry", "tolerances", "usual", "construction", "drafting",
    "pairs", "mechanism", "stacking", "naming", "motions", "quantities", "measured", "readable", "loading", "library",
    "starters", "planning", "running", "seal", "analytic", "freedoms", "assur", "readings", "standing", "agreement",
    "centres", "linkages", "design", "sweeps", "finding",
    "check", "submissions", "marking", "results", "say", "sheet", "outputs", "equations", "api", "batches", "grading",
    "problems", "platforms", "handouts", "reference", "cli",
)  # fmt: skip

_WHERE = {
    "Mechanism": "loading",
    "load": "api",
    "loads": "loading",
    "from_dict": "loading",
    "Drawing": "api",
    "State": "readable",
    "Sweep": "outputs.frames",
    "plan": "api",
    "replay": "api",
    "replay_many": "api",
    "motion": "api",
    "sweep": "api",
    "sweep_many": "batches",
    "solve_many": "batches",
    "explain": "say",
    "measure": "check",
    "GraphkinError": "errors",
}

__all__ = [
    "Drawing", "GraphkinError", "Mechanism", "State", "Sweep", "explain", "from_dict", "load", "loads", "measure",
    "motion", "plan", "replay", "replay_many", "solve_many", "sweep", "sweep_many",
]  # fmt: skip

if TYPE_CHECKING:
    from graphkin.api import Drawing, load, motion, plan, replay, replay_many, sweep
    from graphkin.batches import solve_many, sweep_many
    from graphkin.check import measure
    from graphkin.errors import GraphkinError
    from graphkin.loading import Mechanism, from_dict, loads
    from graphkin.outputs.frames import Sweep
    from graphkin.readable import State
    from graphkin.say import explain


def __getattr__(name: str) -> Any:
    """Public names are imported when first used, so that a command loads only what it needs."""
    if name not in _WHERE:
        raise AttributeError(f"module 'graphkin' has no attribute {name!r}")
    return getattr(import_module(f"graphkin.{_WHERE[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*__all__, "__all__", "__doc__", "__name__", "__version__"})
