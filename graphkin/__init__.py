"""graphkin: graphical kinematics for planar mechanisms.

A mechanism is one TOML file. graphkin draws it to scale, writes its vector equations, constructs its
velocity and its acceleration polygon step by step, and proves them right against an analytic solution.

    mechanism.toml -- files --> Mechanism       what the machine is; frozen, holds no position
    Mechanism -- planning.plan --> Method       three constructions, planned once, from topology
    Method + driver values -- running --> Plot  named points and quantities, scalars or arrays
    Plot -- sheet --> Sheet -- outputs --> SVG
    Mechanism -- analytic --> Motion            the other road; it never reads a construction
    proof: one reader of a position holds both roads

    studies: centres, linkages, design, sweeps, finding    data; what of it is drawn, by drafting.replay on a Board
    check: Plot, or a drawing file, beside Motion           results: all of it as plain data
    submissions: whatever students hand in -> the numbers in it, SI
    marking: a Key of a Method, and numbers -> verdicts, own values carried on, likely mistakes
    homework: problems     a template with ranges -> a mechanism for each student, posed well and tellable
              grading      a key and files -> a record a submission
              platforms    sets and records -> files of teaching platforms, and back
    handouts: a problem or its solution on paper, from what `say` and `sheet` make
    any of these -- say --> lines in either language        -- sheet, outputs, equations --> files

A package imports only from those before it in `ORDER`. A construction is data: a reader of its steps (replay,
say, sheet, check) handles every kind of step, and the type checker sees to that. The steps of `construction` draw a
mechanism and its polygons, on complex numbers; `construction.drafting` is beside them, for what is no polygon. A
subject makes data and knows no language; say, sheet, outputs and homework read any subject's data.

Where a new thing goes, and the test that guides it:
- a pair kind: the recipe is in `model/pairs`. Begin with library mechanisms of it, one for each variant and each
  degenerate size: tests/model/test_pairs.py and all tests over the library name the tables that lack it.
- a quantity: a class of `model/quantities/kinds`, its place in the union `Quantity`, its word in `quantities/reading`;
  how it is written in `say/names` and `submissions`, its line in `say/phrases/file_help.py`. mypy names every `match`
  over the union; of the kind yours is like, look for `isinstance` too. Ask for it in a mechanism of the library.
- a step: a class of `construction/kinds` and its place in the union `Step`; mypy names every reader.
- a mistake: a function under `@mistake(id, topic, section)` in the file of `marking/mistakes` for its subject; in
  `say/phrases/marking.py` the lines `mistakes.made ID` and `mistakes.kind ID` (and `look TOPIC` of a new topic); a row
  of `TABLE` in tests/marking/test_mistakes.py, with the numbers that a student gets. If it is common, `_COMMON` in
  `handouts/problem.py`. `graphkin tolerance MECHANISM --power` tells how well it is found.
- an output format: a file of `outputs`, with its writer in `WRITERS` of `outputs/drawings.py`: the commands offer what
  stands there. README.md names the endings in the rows of `draw`; tests/outputs/test_exports.py, test_readme.py.
- a phrase: a line of `say/phrases/SUBJECT.py`, both languages side by side; tests/say/test_catalogue.py.
- an error: a class in a file of `errors`, raised as data; tests/say/test_catalogue.py.
- a subject: a package of `studies` with a public face of one page; `say/phrases/SUBJECT.py` and a reader
  `say/SUBJECT.py`; `sheet/SUBJECT_sheet.py` where there is something to draw; a command in `cli` with its line in
  `COMMANDS`; its command lines, in both languages, in tests/golden.py. tests/test_order.py holds the house's laws.
What a user notices has a line in CHANGELOG.md.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.2.0"

ORDER = (
    "base", "errors", "construction", "model", "files", "planning", "running", "analytic", "proof", "studies", "check",
    "submissions", "marking", "results", "say", "sheet", "outputs", "equations", "api", "homework", "handouts", "cli",
)  # fmt: skip

_WHERE = {
    "Mechanism": "files.MechanismFile",
    "load": "api.load",
    "loads": "files.loads",
    "from_dict": "files.from_dict",
    "Drawing": "api.Drawing",
    "State": "model.readout.State",
    "Sweep": "outputs.tables.SweepFrames",
    "plan": "api.plan",
    "replay": "api.replay",
    "replay_many": "api.replay_many",
    "motion": "api.motion",
    "sweep": "api.sweep",
    "sweep_many": "api.batches.sweep_many",
    "solve_many": "api.batches.solve_many",
    "explain": "say.explain",
    "measure": "check.measure",
    "GraphkinError": "errors.GraphkinError",
}

__all__ = [
    "Drawing", "GraphkinError", "Mechanism", "State", "Sweep", "explain", "from_dict", "load", "loads", "measure",
    "motion", "plan", "replay", "replay_many", "solve_many", "sweep", "sweep_many",
]  # fmt: skip

if TYPE_CHECKING:
    from graphkin.api import Drawing, load, motion, plan, replay, replay_many, sweep
    from graphkin.api.batches import solve_many, sweep_many
    from graphkin.check import measure
    from graphkin.errors import GraphkinError
    from graphkin.files import MechanismFile as Mechanism
    from graphkin.files import from_dict, loads
    from graphkin.model.readout import State
    from graphkin.outputs.tables import SweepFrames as Sweep
    from graphkin.say import explain


def __getattr__(name: str) -> Any:
    """Public names are imported when first used, so that a command loads only what it needs."""
    if name not in _WHERE:
        raise AttributeError(f"module 'graphkin' has no attribute {name!r}")
    module, _, attribute = _WHERE[name].rpartition(".")
    return getattr(import_module(f"graphkin.{module}"), attribute)


def __dir__() -> list[str]:
    return sorted({*__all__, "__all__", "__doc__", "__name__", "__version__"})
