"""Mistakes that a user can make, as data; the sentences stand here once, in both languages.

Every error says three things: where (file, line, key), what is wrong, what to do. Code raises
the data; only the edge (the command line, a notebook) asks for the words.

`base` has the classes all others come from; `files` is about the file as a whole, `keys` about keys, values and names,
`shapes` about a link's measures, `pairs` about sliding pairs, gears, rolling and cams, `drivers` about drivers and
poses, `motion` about assembly and movement, `drawings` about what is measured or written, `marking`, `submissions`,
`answers` and `problem_sets` about homework, `asking` about what is asked for, `finding` about conditions. A new error is
a class in one of them, and a name in its `__all__`: this module passes on all that those hold, and loads each where
something of it is first asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphkin.errors.answers import *  # noqa: F403
    from graphkin.errors.asking import *  # noqa: F403
    from graphkin.errors.base import *  # noqa: F403
    from graphkin.errors.centring import *  # noqa: F403
    from graphkin.errors.design import *  # noqa: F403
    from graphkin.errors.drawings import *  # noqa: F403
    from graphkin.errors.drivers import *  # noqa: F403
    from graphkin.errors.files import *  # noqa: F403
    from graphkin.errors.finding import *  # noqa: F403
    from graphkin.errors.keys import *  # noqa: F403
    from graphkin.errors.linkages import *  # noqa: F403
    from graphkin.errors.marking import *  # noqa: F403
    from graphkin.errors.motion import *  # noqa: F403
    from graphkin.errors.pairs import *  # noqa: F403
    from graphkin.errors.problem_sets import *  # noqa: F403
    from graphkin.errors.shapes import *  # noqa: F403
    from graphkin.errors.submissions import *  # noqa: F403

_FILES = (
    "base", "drawings", "files", "keys", "shapes", "drivers", "pairs", "motion", "asking", "centring", "finding",
    "linkages", "design", "marking", "submissions", "answers", "problem_sets",
)  # fmt: skip
"""In the order in which a name is looked for: what every command and every mechanism file may meet comes first."""

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        files = (import_module(f"{__name__}.{file}") for file in _FILES)
        if name == "__all__":
            return [each for file in files for each in file.__all__]
        owner = None if name.startswith("__") else next((file for file in files if name in file.__all__), None)
        if owner is None:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        globals()[name] = getattr(owner, name)
        return globals()[name]
