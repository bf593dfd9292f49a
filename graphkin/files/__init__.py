"""TOML -> `Mechanism`, with errors that name file, line and key.

    file --source--> text --toml--> data and lines --schema, links--> tables in SI
         --links (shapes), pairs (lines), drivers, draft--> Mechanism

`values` has the closed table of units, `fields` the kinds of value. A new pair kind needs a table in `schema` (and its
name in `TABLES` and `TABLES_AT` there) and a reader in `pairs`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphkin.files.draft import remarks
    from graphkin.files.loader import MechanismFile, from_dict, load, load_stream, loads

__all__ = ["MechanismFile", "from_dict", "load", "load_stream", "loads", "remarks"]


def __getattr__(name: str) -> object:
    """Names are imported when first used: those of the library are listed without reading a file."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{'draft' if name == 'remarks' else 'loader'}"), name)
