"""Mistakes that a user can make, as data; the sentences stand here once, in both languages.

Every error says three things: where (file, line, key), what is wrong, what to do. Code raises
the data; only the edge (the command line, a notebook) asks for the words.

`base` has the classes all others come from; `files` is about the file as a whole, `keys` about keys, values and names,
`mechanism` about links, pairs, drivers and poses, `motion` about assembly and movement, `drawings` about what is
measured, photographed or written, `asking` about what is asked for, `studies` about conditions, linkages and instant
centres, `homework` about keys and marks, what is handed in, and problem sets, `sheets` about what was printed. A new
error is a class in one of them, and a name in its `__all__`: this module passes on all that those hold, and loads each
where something of it is first asked for.
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
    from graphkin.errors.keys import *  # noqa: F403
    from graphkin.errors.mechanism import *  # noqa: F403
    from graphkin.errors.motion import *  # noqa: F403
    from graphkin.errors.sheets import *  # noqa: F403
    from graphkin.errors.studies import *  # noqa: F403

_FILES = ("base", "drawings", "files", "keys", "mechanism", "motion", "asking", "studies", "homework", "sheets")
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
