"""Library mechanisms whose pairs and groups are solved."""

from __future__ import annotations

from graphkin import library
from graphkin.methods.stages import stages
from graphkin.methods.structure import Structure


def _solved(name: str) -> bool:
    mechanism = library.load(name)
    if mechanism.gears or mechanism.rolls or mechanism.cams or mechanism.poses:
        return False
    return not stages(Structure(mechanism))[1]


SOLVABLE = tuple(name for name in library.names() if _solved(name))
