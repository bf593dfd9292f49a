"""Photographs among what is handed in: each sheet that is seen is measured, and goes to the student whose it is.

    files --_pictures--> pictures --_seen--> sheets with their velocities --_finished--> with their accelerations
    readings of a student --photo.as_drawing--> a drawing, beside the student's other files (`Photographs.joined`)

An acceleration polygon is measured by the velocities that the student has drawn, which may be on another picture.
"""

from __future__ import annotations

import base64
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property, partial
from itertools import chain, compress
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from graphkin.base.value import bulky
from graphkin.base.worklist import batched
from graphkin.errors import GraphkinError, NoNumbers, OwnFault, UnknownSheet, UnknownStudent, Where
from graphkin.homework import opening
from graphkin.homework.grading.sets import SetMarker
from graphkin.outputs import sheets_json
from graphkin.photo.readings import RoomReading, SheetReading, as_drawing
from graphkin.photo.sheets import PrintedSheet, SheetRoom
from graphkin.submissions import Handed, Limits, guarded, handed_in, limited
from graphkin.submissions.reading import files_of, student_of, where_of, whose
from graphkin.submissions.students import Owner

if TYPE_CHECKING:
    from graphkin.photo.pictures import GreyPicture
    from graphkin.photo.predicted import PredictedCorner
    from graphkin.photo.registering import RegisteredPage

_SECONDS = 60.0  # for a picture
_AT_ONCE, _HELD = 8, 16  # pictures that are looked at; pages that wait for the velocities of their student
_CROP, _QUALITY = 6.0, 60  # of what a teacher looks at: pixels a mm, quality of the JPEG
_Item = TypeVar("_Item", "tuple[Handed, GreyPicture]", "_HeldPage")
Velocities = Mapping[str, "PredictedCorner"]  # of a student's polygon by letter, SI


@bulky
class PhotoJob:
    """The sheets that were printed, and whose they are; crop: pictures of the rooms are wanted, for a teacher."""

    judge: SetMarker
    sheets: tuple[PrintedSheet, ...]
    crop: bool
    limits: Limits
    workers: int = 0


@bulky
class _HeldPage:
    """A sheet whose accelerations are still to be measured, and what it was handed in with."""

    handed: Handed
    reading: SheetReading
    page: RegisteredPage
    velocities: Velocities = field(default_factory=dict)

    @property
    def rooms(self) -> list[SheetRoom]:
        return [room for room in self.reading.sheet.rooms if room.plane == "acceleration"]


class Photographs:
    """The readings of all pictures, and why others cannot be read."""

    def __init__(self, job: PhotoJob) -> None:
        self.job = job
        self.readings, self.failed = list[SheetReading](), list[Handed]()
        self.had_pictures = set[str]()

    def take(self, results: Iterable[_Done]) -> list[_HeldPage]:
        """Keeps what is done; the rest is given back."""
        held = list[_HeldPage]()
        for one in results:
            match one:
                case Handed():
                    self.failed.append(one)
                case SheetReading():
                    self.readings.append(one)
                case _HeldPage():
                    held.append(one)
        return held

    def joined(self, some: Iterable[Handed]) -> Iterator[Handed]:
        """A submission without its pictures and with what was measured on them."""
        from graphkin.photo.pictures import is_picture

        for handed in some:
            if handed.file in self.had_pictures:
                files = (file for file in files_of(handed, self.job.limits) if not is_picture(*file))
                if not (rest := (*files,)):
                    continue
                handed = replace(handed, files=rest)
            student = student_of(handed, self.job.limits, self.job.judge.roster) if self._left else ""
            own = self._left.pop(student, None)
            yield handed if own is None else replace(handed, drawing=own.drawing)

    def left(self) -> Iterator[Handed]:
        """The submissions that are on pictures alone, and each that cannot be read."""
        yield from (*self._left.values(), *self.failed)

    @cached_property
    def _left(self) -> dict[str, Handed]:
        """By student, what stands beside nothing that was gone through."""
        handed = dict[str, Handed]()
        for student in dict.fromkeys(reading.student for reading in self.readings):
            own = [reading for reading in self.readings if reading.student == student]
            printed = [sheet for sheet in self.job.sheets if sheet.student == student]
            lost = any(one.owner.student != student for one in self.failed)
            file, drawn = own[0].picture, any(reading.rooms for reading in own)
            drawing = as_drawing(own, printed, lost) if drawn else None
            reason = None if drawn else NoNumbers(Where(file), f"#{own[0].sheet.number}")
            handed[student] = Handed(Owner(student, student), file, reason=reason, drawing=drawing)
        return handed

    def velocities(self, student: str) -> Velocities | None:
        """As far as they are known; None where none are measured yet."""
        from graphkin.photo.predicted import own_velocities

        rooms = (room for reading in self.readings if reading.student == student for room in reading.rooms)
        drawn = [room for room in rooms if room.room.plane == "velocity"]
        return own_velocities(min(drawn, key=lambda room: room.rank)) if drawn else None


def photographs(paths: Iterable[str | Path], job: PhotoJob) -> Photographs:
    """All pictures in these files looked at, and readings of before taken as they are. Nothing of a picture is kept
    but what was measured, and crops where these are asked for. Raises NoSheetList, Unreadable."""
    found, others, held = Photographs(job), list[Path](), list[_HeldPage]()
    for path in map(Path, paths):
        if sheets_json.is_readings(path):
            with opening(path):
                found.readings += sheets_json.read_readings(path)
        else:
            others.append(path)
    for some in batched(_pictures(others, found) if job.sheets else (), _AT_ONCE * max(1, job.workers)):
        held += found.take(_each(partial(_seen, job), some, job.workers))
        long = len(held) - _HELD
        knows = [found.velocities(one.reading.student) is not None or k < long for k, one in enumerate(held)]
        _finish([*compress(held, knows)], found)
        held = [one for one, known in zip(held, knows, strict=True) if not known]
    _finish(held, found)
    found.readings.sort(key=lambda reading: reading.sheet.number)
    return found


def _finish(held: Sequence[_HeldPage], found: Photographs) -> None:
    """Pages that were held, by the velocities that are known now."""
    ready = [replace(one, velocities=found.velocities(one.reading.student) or {}) for one in held]
    found.take(_each(partial(_finished, found.job), ready, found.job.workers))


def _pictures(paths: Iterable[Path], found: Photographs) -> Iterator[tuple[Handed, GreyPicture]]:
    """Each picture with what it was handed in with."""
    from graphkin.photo.pictures import is_picture, pictures_in

    for handed in handed_in(paths, found.job.limits, found.job.judge.roster):
        bare = replace(handed, files=())
        for name, content in files_of(handed, found.job.limits):
            if is_picture(name, content):
                found.had_pictures.add(handed.file)
                where = where_of(handed, name)
                try:
                    yield from ((bare, picture) for picture in pictures_in(name, content, where))
                except GraphkinError as problem:
                    found.failed.append(_refused(bare, where, problem))


# --- as a worker does it ----------------------------------------------------------------------------------------------


_Work = tuple[Handed, "GreyPicture"] | _HeldPage
_Done = Handed | SheetReading | _HeldPage


def _each(work: Callable[[_Item], list[_Done]], items: Sequence[_Item], workers: int) -> Iterator[_Done]:
    """The results of each, in order, here or by workers."""
    every = partial(_all, work)
    if workers:
        results = guarded(every, ([item] for item in items), workers, _SECONDS, _lost)
    else:
        results = chain.from_iterable(every([item]) for item in items)
    yield from chain.from_iterable(results)


def _all(work: Callable[[_Item], list[_Done]], items: Sequence[_Item]) -> list[list[_Done]]:
    """It never raises."""
    results = list[list[_Done]]()
    for item in items:
        try:
            with limited(_SECONDS, _where(item)):
                results.append(work(item))
        except GraphkinError as problem:
            results.append(_lost(item, problem))
        except Exception as problem:
            results.append(_lost(item, type(problem).__name__))
    return results


def _where(item: _Work) -> Where:
    return Where(item.reading.picture) if isinstance(item, _HeldPage) else item[1].where


def _lost(item: _Work, problem: GraphkinError | str) -> list[_Done]:
    where = _where(item)
    reason = OwnFault(where, problem) if isinstance(problem, str) else problem
    return [_refused(item.handed if isinstance(item, _HeldPage) else item[0], where, reason)]


def _refused(handed: Handed, where: Where, reason: GraphkinError) -> Handed:
    return replace(handed, file=str(where), reason=reason)


def _seen(job: PhotoJob, item: tuple[Handed, GreyPicture]) -> list[_Done]:
    """The sheets on a picture."""
    from graphkin.photo.predicted import own_velocities
    from graphkin.photo.registering import registered

    (handed, picture), done = item, list[_Done]()
    for page in registered(picture, {(sheet.width, sheet.height) for sheet in job.sheets}):
        try:
            if isinstance(page, GraphkinError):
                raise page
            sheet, student = _owned(job, handed, picture.where, page.number)
            drawn = [room for room in sheet.rooms if room.plane == "velocity"]
            rooms = tuple(_room(job, page, room, student, {}) for room in drawn)
            held = _HeldPage(handed, SheetReading(sheet, student, str(picture.where), rooms), page)
            if held.rooms and not rooms:
                done.append(held)
            else:
                done += _finished(job, replace(held, velocities=own_velocities(rooms[0]) if rooms else {}))
        except GraphkinError as problem:
            done.append(_refused(handed, picture.where, problem))
    return done


def _owned(job: PhotoJob, handed: Handed, where: Where, number: int) -> tuple[PrintedSheet, str]:
    """The sheet, and the student whose it is. Raises UnknownSheet, UnknownStudent, TwoNames, SameName."""
    sheet = next((sheet for sheet in job.sheets if sheet.number == number), None)
    if sheet is None:
        raise UnknownSheet(where, number)
    student = whose(handed, [sheet.student] if sheet.student else [], job.judge.roster, where)
    marker = job.judge.marker(student)
    if marker is None:
        raise UnknownStudent(where, student)
    if not sheet.student and sheet.problem != marker.key.name:
        raise UnknownSheet(where, number)
    return sheet, student


def _finished(job: PhotoJob, held: _HeldPage) -> list[_Done]:
    """A sheet with its accelerations."""
    rooms = (_room(job, held.page, room, held.reading.student, held.velocities) for room in held.rooms)
    return [replace(held.reading, rooms=(*held.reading.rooms, *rooms))]


def _room(job: PhotoJob, page: RegisteredPage, room: SheetRoom, student: str, velocities: Velocities) -> RoomReading:
    """The drawing in a room."""
    from graphkin.photo.measuring import measured
    from graphkin.photo.predicted import predicted

    marker, plane = job.judge.marker(student), room.plane
    assert marker is not None, "who is not of the class was refused before"
    polygon = marker.method.velocity if plane == "velocity" else marker.method.acceleration
    arrows = (marker.problem.arrows.at_poles((plane, term.tail, term.head)) for term in polygon.vectors().values())
    lines = tuple(dict.fromkeys((tail, head) for _, tail, head in arrows if tail != head))
    found = measured(page, room, predicted(marker.method, marker.plot, room, velocities))
    points = {polygon.pole: 0j, **found.vertices}
    letters = tuple(dict.fromkeys((polygon.pole, *chain.from_iterable(lines), *points)))
    crop = _crop(page, room) if job.crop else ""
    return RoomReading(room, points, letters, lines, found.error, found.unsure, found.shifts, crop=crop)


def _crop(page: RegisteredPage, room: SheetRoom) -> str:
    """The room set straight."""
    import cv2

    _, content = cv2.imencode(".jpg", page.crop(room.low, room.high, _CROP), [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    return f"data:image/jpeg;base64,{base64.b64encode(content.tobytes()).decode()}"


# --- the lists of printed sheets --------------------------------------------------------------------------------------


def printed_sheets(key: str, paths: Iterable[str | Path], named: Path | None = None) -> tuple[PrintedSheet, ...]:
    """The printed sheets, by the list that is named; else by those in KEY's folder or beside KEY, else by those beside
    what is handed in. Raises NoSheetList, NoFile, Unreadable."""
    own, pictures = Path(key), [path if os.path.isdir(path) else path.parent for path in map(Path, paths)]
    near = [*([own] if os.path.isdir(own) else []), *own.parents[:2]] if key and os.path.exists(own) else []
    nearby = [[path for folder in dict.fromkeys(folders) for path in sorted(folder.glob(f"*{sheets_json.NAME}"))]
              for folders in (near, pictures)]  # fmt: skip
    for lists in nearby if named is None else [[named]]:
        sheets: dict[int, PrintedSheet] = {}
        for path in lists:
            with opening(path):
                sheets |= {sheet.number: sheet for sheet in sheets_json.read_sheets(path)}
        if sheets:
            return tuple(sheets.values())
    return ()
