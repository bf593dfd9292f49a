"""What was printed on each sheet that is to be photographed: whose it is, and where its rooms to draw in lie."""

from __future__ import annotations

from graphkin.base.value import frozen
from graphkin.construction import Plane


@frozen
class SheetRoom:
    """Gridded paper on a page.

    position  of the problem, where it asks for several: 1 is the drawn one
    pole      where it is printed; low, high: corners of the room, left upper and right lower [mm from the left upper
              corner of the paper, x right, y down]
    scale     SI units per mm
    """

    plane: Plane
    position: int
    pole: complex
    low: complex
    high: complex
    scale: float


@frozen
class PrintedSheet:
    """One page of paper.

    number   as its markers tell it
    problem  name of the mechanism; student: whose it is, "" where it is anybody's
    width, height  of the paper [mm]
    """

    number: int
    problem: str
    student: str
    width: float
    height: float
    rooms: tuple[SheetRoom, ...] = ()
