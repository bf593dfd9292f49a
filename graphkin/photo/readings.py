"""The measurements of sheets, apart from any picture; and the sheets of a student as one drawing.

Of a room that is there twice the better reading counts: one that a teacher has confirmed, then one with less that is
unsure, then the more exact one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from graphkin.base.value import bulky
from graphkin.construction import Plane
from graphkin.errors import GraphkinError, SheetTwice, UnsureDrawing, Where
from graphkin.photo.sheets import PrintedSheet, Reason, SheetRoom, Unsure
from graphkin.submissions import MeasuredDrawing

_APART = 1.0  # drawings whose corners are farther apart than both may be off, and by so much, are not the same [mm]


@bulky
class RoomReading:
    """A room as it was measured.

    points     by letter [mm from the pole, y up], the pole's first
    letters    all that the polygon has; lines: pairs of them that arrows join
    error      estimated [mm]
    shifts     how those that are not sure may be off together, each by one standard deviation [mm]
    confirmed  by a teacher, who has looked at it
    crop       the room set straight, as an address that holds a JPEG, where one was asked for
    """

    room: SheetRoom
    points: Mapping[str, complex]
    letters: tuple[str, ...] = ()
    lines: tuple[tuple[str, str], ...] = ()
    error: float = 0.0
    unsure: tuple[Unsure, ...] = ()
    shifts: tuple[Mapping[str, complex], ...] = ()
    confirmed: bool = False
    crop: str = ""

    @property
    def is_blank(self) -> bool:
        return any(one.reason == "blank" for one in self.unsure)

    @property
    def rank(self) -> tuple[bool, bool, int, float]:
        """The better reading has less."""
        return not self.confirmed, self.is_blank, len(self.unsure), self.error

    def is_other(self, other: RoomReading) -> bool:
        """True if they do not show the same drawing."""
        both = self.points.keys() & other.points.keys()
        apart = max((abs(self.points[letter] - other.points[letter]) for letter in both), default=0.0)
        return apart > _APART + 3 * (self.error + other.error)

    def drawing(
        self, where: Where, remarks: Iterable[GraphkinError] = (), more: Iterable[Reason] = ()
    ) -> MeasuredDrawing:
        """The drawing; more: reasons why all of it is unsure."""
        plane, unsure = self.room.plane, (*self.unsure, *map(Unsure, more))
        points = {(plane, letter): place for letter, place in self.points.items()}
        doubts = tuple(UnsureDrawing(where, plane, one.reason, one.letters, one.off) for one in unsure)
        shifts = tuple({(plane, letter): by for letter, by in one.items()} for one in self.shifts)
        known = ((), ()) if self.confirmed else (doubts, shifts)
        return MeasuredDrawing(points, {plane: self.room.scale}, {}, where, tuple(remarks), self.error, *known)


@bulky
class SheetReading:
    """A sheet on a picture: what was printed, whose it is, where it was seen, and its rooms."""

    sheet: PrintedSheet
    student: str
    picture: str
    rooms: tuple[RoomReading, ...] = ()


def as_drawing(readings: Sequence[SheetReading], printed: Iterable[PrintedSheet], lost: bool) -> MeasuredDrawing:
    """The readings of a student as one drawing.

    printed  all sheets of the student; lost: one of them may be on a picture that could not be read
    """
    of: dict[Plane, list[tuple[SheetReading, RoomReading]]] = {}
    for reading in readings:
        for room in reading.rooms:
            of.setdefault(room.room.plane, []).append((reading, room))
    drawings = []
    for several in of.values():
        (reading, room), *others = sorted(several, key=lambda each: each[1].rank)
        others = [each for each in others if not each[1].is_blank]
        remarks = [SheetTwice(Where(other.picture), other.sheet.number, reading.picture) for other, _ in others]
        differ: list[Reason] = ["twice"] if any(room.is_other(other) for _, other in others) else []
        drawings.append(room.drawing(Where(reading.picture), remarks, differ))
    where = Where(readings[0].picture)
    missing = {room.plane for sheet in printed for room in sheet.rooms} - {"position", *of} if lost else ()
    drawings += [MeasuredDrawing({}, {}, unsure=(UnsureDrawing(where, plane, "lost"),)) for plane in sorted(missing)]
    return MeasuredDrawing(
        {at: place for one in drawings for at, place in one.points.items()},
        {plane: scale for one in drawings for plane, scale in one.scales.items()}, {}, where,
        tuple(remark for one in drawings for remark in one.remarks), max(one.error for one in drawings),
        tuple(unsure for one in drawings for unsure in one.unsure),
        tuple(shift for one in drawings for shift in one.shifts),
    )  # fmt: skip
