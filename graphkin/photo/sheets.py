"""The print on each sheet that is to be photographed: whose it is, and where its rooms to draw in lie."""

from __future__ import annotations

from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Plane

Reason = Literal["blank", "outside", "no ink", "short", "flat", "alike", "unexplained", "far", "twice", "lost"]


@frozen
class SheetRoom:
    """Gridded paper on a page.

    position  of the problem, where it asks for several: 1 is the drawn one
    pole      where it is printed; low, high: corners of the room, left upper and right lower [mm from the left upper
              corner of the paper, x right, y down]
    scale     SI units per mm; direction: of the line through the pole that is printed [rad]
    """

    plane: Plane
    position: int
    pole: complex
    low: complex
    high: complex
    scale: float
    direction: float = 0.0


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


@frozen
class Unsure:
    """A reason why corners are not sure; those of the whole room, where it names none.

    reason  "blank": hardly anything is drawn; "outside": a part of the room is not on the picture; "no ink": a stroke
            is not there; "short": a line too short to tell its direction; "flat": lines that cross too flatly, or one
            that ends nowhere; "alike": two constructions fit; "unexplained": long lines of no construction; "far":
            where no construction has it; "twice": another picture shows it otherwise; "lost": no picture shows it
    off     their standard deviation [mm]; 0 where it is not known
    """

    reason: Reason
    letters: tuple[str, ...] = ()
    off: float = 0.0
