"""Library mechanisms whose pairs and groups are solved."""

from __future__ import annotations

from graphkin import library
from graphkin.errors import HigherClass, NotYetSolved
from graphkin.methods import plan


def _solved(name: str) -> bool:
    try:
        plan(library.load(name))
    except (HigherClass, NotYetSolved):
        return False
    return True


SOLVABLE = tuple(name for name in library.names() if _solved(name))
