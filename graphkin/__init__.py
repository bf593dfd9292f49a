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
    photo: a picture of a sheet of paper -> polygons in mm, beside what `marking` expects
    homework: problems     a template with ranges -> a mechanism for each student, posed well and tellable
              grading      a key and files -> a record a submission
              platforms    sets and records -> files of teaching platforms, and back
    handouts: a problem or its solution on paper, from what `say` and `sheet` make
    page: a mechanism to play with, and a drawing board, in a browser, of the same
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
  of `TABLE` in tests/marking/test_mistakes.py, with the numbers that a student gets. If it is common, `COMMON` in
  `marking/diagnosis.py`. `graphkin tolerance MECHANISM --power` tells how well it is found.
- an output format: a file of `outputs`, its ending in `DRAWN` of `outputs/drawings.py` and a case of `content` there:
  the commands offer it. `say/manual.md` names the endings in the line of `draw`; tests/outputs/test_exports.py,
  test_readme.py.
- a phrase: a line of `say/phrases/SUBJECT.py`, both languages side by side; tests/say/test_catalogue.py.
- an error: a class in a file of `errors`, raised as data; tests/say/test_catalogue.py.
- a subject: a package of `studies` with a public face of one page; `say/phrases/SUBJECT.py` and a reader
  `say/SUBJECT.py`; `sheet/SUBJECT_sheet.py` where there is something to draw; a command in `cli` with its line in
  `COMMANDS`, its line and picture in `say/manual.md`; its command lines, in both languages, in tests/golden.py.
  tests/test_order.py holds the house's laws.
What a user notices has a line in CHANGELOG.md.

The matrices are small: with OPENBLAS_NUM_THREADS=1, set before NumPy is loaded, long mechanisms take a fraction of the
time. The command line sets it where the user has not.
"""

from __future__ import annotations

from importlib import import_module
from types import FunctionType

TYPE_CHECKING = False  # `typing` takes longer to load than all of this, and until then Ctrl-C prints a traceback

__version__ = "0.2.0"

ORDER = (
    "base", "errors", "construction", "model", "files", "planning", "running", "analytic", "proof", "studies", "check",
    "submissions", "marking", "photo", "results", "say", "sheet", "outputs", "equations", "api", "homework", "handouts",
    "page", "cli",
)  # fmt: skip

_HOMES = {
    "api": "Drawing load motion plan replay sweep trial",
    "api.answers": "centres data_of design find lines_of linkage sheet_of structure",
    "api.batches": "solve_many sweep_many",
    "check": "measure",
    "errors": "GraphkinError",
    "files": "MechanismFile from_dict loads",
    "handouts.saving": "handout",
    "homework.result_files": "grade_into",
    "homework.grading": "grade power tolerance",
    "model.readout": "State",
    "outputs.tables": "SweepFrames",
    "page.board_set": "problems",
    "page.player": "play",
}
_CALLED = {"Mechanism": "MechanismFile", "Sweep": "SweepFrames"}

__all__ = [
    "Drawing", "GraphkinError", "Mechanism", "State", "Sweep", "centres", "data_of", "design", "find", "from_dict",
    "grade", "grade_into", "handout", "lines_of", "linkage", "load", "loads", "measure", "motion", "plan", "play",
    "power", "problems", "replay", "sheet_of", "solve_many", "structure", "sweep", "sweep_many", "tolerance", "trial",
]  # fmt: skip

if TYPE_CHECKING:
    from typing import Any

    from graphkin.api import Drawing, load, motion, plan, replay, sweep, trial
    from graphkin.api.answers import centres, data_of, design, find, lines_of, linkage, sheet_of, structure
    from graphkin.api.batches import solve_many, sweep_many
    from graphkin.check import measure
    from graphkin.errors import GraphkinError
    from graphkin.files import MechanismFile as Mechanism
    from graphkin.files import from_dict, loads
    from graphkin.handouts.saving import handout
    from graphkin.homework.grading import grade, power, tolerance
    from graphkin.homework.result_files import grade_into
    from graphkin.model.readout import State
    from graphkin.outputs.tables import SweepFrames as Sweep
    from graphkin.page.board_set import problems
    from graphkin.page.player import play


def __getattr__(name: str) -> Any:
    """Public names are imported when first used, so that a command loads only what it needs; a call looks at its
    arguments first."""
    if name not in __all__:
        raise AttributeError(f"module 'graphkin' has no attribute {name!r}")
    from graphkin.errors.arguments import checked

    own = _CALLED.get(name, name)
    public = getattr(import_module(next(f"graphkin.{home}" for home in _HOMES if own in _HOMES[home].split())), own)
    if isinstance(public, FunctionType) and not public.__module__.startswith("graphkin.files"):  # it looks itself
        public = checked(public)
        public.__module__ = __name__  # where processes find it
    globals()[name] = public
    return public


def __dir__() -> list[str]:
    return sorted({*__all__, "__all__", "__doc__", "__name__", "__version__"})
