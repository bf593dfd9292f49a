"""TOML -> `Mechanism`, with errors that name file, line and key.

    file --source--> text --tomllib, positions--> data and lines --schema, measures--> tables in SI
         --links (shapes), slides, contacts, drivers, joints--> Mechanism

`units` is the closed table of units, `fields` the kinds of value. A new pair kind needs a table in `schema` (and its
name in `TABLES` there and in `complaints.TABLES`) and a reader beside `slides` and `contacts`, called in `loader`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphkin.files.loader import MechanismFile, from_dict, load, load_stream, loads
    from graphkin.files.questions import remarks

__all__ = ["MechanismFile", "from_dict", "load", "load_stream", "loads", "remarks"]


def __getattr__(name: str) -> object:
    """What is asked for, when it is: names of the library are listed without reading a file."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{'questions' if name == 'remarks' else 'loader'}"), name)
