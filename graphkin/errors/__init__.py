"""Mistakes that a user can make, as data; the sentences stand here once, in both languages.

Every error says three things: where (file, line, key), what is wrong, what to do. Code raises
the data; only the edge (the command line, a notebook) asks for the words.

`base` has the classes all others come from; `files` is about a mechanism file, its keys, values and names, `mechanism` about links, pairs, drivers and poses, `motion` about assembly and movement, `drawings` about what is
measured, photographed, printed or written, `asking` about what is asked for, `studies` about conditions, linkages and instant
centres, `homework` about keys and marks, what is handed in, and problem sets. A new
error is a class in one of them: this module passes on all that those hold, and loads each where something of it is
first asked for.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphkin.errors.asking import *  # noqa: F403
    from graphkin.errors.base import *  # noqa: F403
    from graphkin.errors.drawings import *  # noqa: F403
    from graphkin.errors.files import *  # noqa: F403
    from graphkin.errors.homework import *  # noqa: F403
    from graphkin.errors.mechanism import *  # noqa: F403
    from graphkin.errors.motion import *  # noqa: F403
    from graphkin.errors.studies import *  # noqa: F403

_FILES = ("base", "drawings", "files", "mechanism", "motion", "asking", "studies", "homework")
"""In the order in which a name is looked for: what every command and every mechanism file may meet comes first."""

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        files = (import_module(f"{__name__}.{file}") for file in _FILES)
        owner = None if name.startswith("_") else next((file for file in files if name in vars(file)), None)
        if owner is None:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        globals()[name] = getattr(owner, name)
        return globals()[name]
