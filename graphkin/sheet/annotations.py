"""Annotations of the mechanism beside its own signs: lengths that are measured, rotations, and what is given.

They are drawn last, where signs and labels have left room; what has none is left out.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from itertools import islice

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Rotation, read
from graphkin.planning.method import rate_found
from graphkin.say.dimensions import dimensions, length_text, measured_lengths
from graphkin.say.reading import Reading
from graphkin.sheet.free_room import Annotations, FreeRoom
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import formula, quantity_label
from graphkin.sheet.marks import ArcMark, Form, Mark, Shows, Stroke, Text
from graphkin.sheet.paper import LEAST
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import SWEEP, spin
from graphkin.sheet.text_blocks import EquationBlock, WrittenLines

_RADII = (7.0, 9.5, 12.0, 15.0)  # of the arcs that show how a link turns [mm]
_ROUND = tuple(cmath.rect(1, math.tau * k / 48) for k in range(48))
_TURNS, _SWEPT = _ROUND[::2], 1 + round(48 * SWEEP / math.tau)
"""Directions round a point in which places are tried; those in which an arc may start, and the number it passes."""
_NARROWER = (75.0, 50.0, 30.0, 20.0)  # given dimensions are written in shorter lines where long ones have no room [mm]
_SHORT = 5.0  # a shorter length is told by words alone [mm]
_TRIED = 12  # so many places are tried for an arc whose letter finds no room beside it
_HALF = 0.9  # half of the width that an arc with its head takes [mm]
_LETTERS: dict[str, tuple[str, Plane]] = {"omega": ("ω", "velocity"), "alpha": ("α", "acceleration")}


@frozen
class MechanismNotes:
    """Annotations of a mechanism with what the solution reads off it.

    planes  of which results may be shown; none where only what is given is drawn
    """

    skeleton: Skeleton
    reading: Reading
    planes: Sequence[Plane] = field(default_factory=tuple)
    loose: Sequence[EquationBlock] = ()

    def lines(self) -> list[Mark]:
        return []

    def __call__(self, free: FreeRoom) -> Annotations:
        """All of it among what stands there."""
        added = Annotations()
        for one, other in measured_lengths(self.reading) if self.planes else ():
            self._add_length(one, other, free, added)
        machine = self.reading.mechanism
        asked = [quantity for text in machine.ask if (quantity := read(machine, text)) is not None]
        for half in dict.fromkeys(half for quantity in asked for half in quantity.halves):
            if isinstance(half, Rotation) and half.word in _LETTERS and _LETTERS[half.word][1] in self.planes:
                added.over.extend(self._arc(half, free))
        if self.planes:
            texts = [formula(text) for text in dimensions(self.reading)]
            for wide in (free.room.size.real - 8, *_NARROWER):  # in lines at the foot of the figure
                lines = WrittenLines.of(texts, wide, LEAST)
                if lines.lines and (corner := free.corner(lines.size, from_below=True)) is not None:
                    marks: list[Mark] = [*lines.marks(corner)]
                    free.add(marks)
                    added.over.extend(marks)
                    break
        return added

    def _add_length(self, one: str, other: str, free: FreeRoom, added: Annotations) -> None:
        """A thin line between two points with the length it has, where there is room for its letters."""
        start, end = self.skeleton.at(one), self.skeleton.at(other)
        if abs(end - start) < _SHORT or not (pieces := free.pieces(start, end)):
            return
        step = self.skeleton.step(one, other)
        want = LabelRequest(formula(length_text(self.reading, one, other)), start, end, gap=0.5, size=LEAST, step=step)
        if letters := next(free.letters([want])):
            added.over.extend(letters)
            lines = [Stroke(piece, "measured", step=step) for piece in pieces]
            added.under.extend(lines)
            free.add(lines)

    def _arc(self, rotation: Rotation, free: FreeRoom) -> list[Mark]:
        """An arc in the sense in which the link turns, about one of its points, with its letter."""
        (letter, plane), link = _LETTERS[rotation.word], rotation.link
        value = float((self.reading.plot.omega if plane == "velocity" else self.reading.plot.alpha)[link])
        driven = any(driver.link == link for driver in self.reading.mechanism.drivers)
        if driven or not self.reading.usual.rate(value, plane):
            return []
        step, sense = rate_found(self.reading.method, plane, link), math.copysign(1, value)
        label = quantity_label(letter, self.reading.mechanism.called(link))
        form: Form = "omega" if plane == "velocity" else "alpha"
        for point, radius, start in islice(self._places(link, sense, free), _TRIED):
            at, shows = self.skeleton.at(point), Shows(link, form, (point,))
            middle = start * cmath.rect(1, -sense * SWEEP / 2)
            want = LabelRequest(label, at + middle * radius, gap=0.9, away=middle, step=step)
            arc = spin(at, start, sense, radius, step, shows)
            if letters := free.letters_with(arc, want):  # in the colour of the polygon
                marks = [replace(mark, accent=plane) if isinstance(mark, ArcMark | Stroke | Text) else mark
                         for mark in (*arc, *letters)]  # fmt: skip
                free.add(marks)
                return marks
        return []

    def _places(self, link: str, sense: float, free: FreeRoom) -> Iterator[tuple[str, float, complex]]:
        """Places with room for such an arc: its point, radius, direction in which it starts; fixed points first."""
        owners, skeleton = self.reading.mechanism.owners, self.skeleton
        points = sorted(skeleton.named(link), key=lambda point: FRAME not in owners[point])
        swept = (2 * np.arange(len(_TURNS))[:, None] - int(sense) * np.arange(_SWEPT)) % len(_ROUND)
        for point in points:
            around = skeleton.at(point) + np.outer(_RADII, _ROUND)
            middle = np.stack([around.real, around.imag], axis=-1)
            clear = free.free((middle - _HALF).reshape(-1, 2), (middle + _HALF).reshape(-1, 2)).reshape(around.shape)
            for radius, places in zip(_RADII, clear, strict=True):
                yield from ((point, radius, _TURNS[k]) for k in np.flatnonzero(places[swept].all(axis=1)))
