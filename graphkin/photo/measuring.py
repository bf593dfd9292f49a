"""A room of a photographed sheet measured: the corners of the polygon that was drawn, and what is not sure of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.photo.fitting import Fit
from graphkin.photo.ink import STRANGE, Ink, Page
from graphkin.photo.predicted import Corner, Way
from graphkin.photo.searching import MISSING, SLIP, Candidate, candidates
from graphkin.photo.sheets import SheetRoom, Unsure

_SHORT = 4.0  # shorter lines may have less ink [mm]
_COVERED = 0.75  # a stroke has ink over so much of its length
_NOWHERE = 5.0  # where the standard deviation is larger nothing is known [mm]
_OFF = 0.2  # corners with a larger standard deviation are not sure [mm]
_ALIKE, _APART = 6.0, 0.4  # constructions that score so alike and lie so far apart are not told apart [mm]
_CLOSE = 0.6  # ink belongs to a refined line when it is no farther off [mm]
_ONE = 0.15  # corners so near each other are one [mm]
_FAR = 2.0  # where a single line ends no farther from where a construction has it, it ends on purpose [mm]
_STRAIN = 2.0  # what contradicts counts so much [mm a standard deviation]
_BLANK = 15.0  # less than so much ink is no drawing [mm]
_HOPELESS = 20.0  # one that scores so much less before its lines are refined is not looked at [mm]
_LIKELY, _ODDER, _TORN = 5.0, 3.0, 5.0
"""A construction was drawn if it departs from what is seen by so many standard deviations more than usual at most, and
by no more than the second beyond the best; none was where lines contradict each other by so many, all in all."""


@frozen
class PageReading:
    """The measures of a room.

    vertices  by letter of the key's construction [mm from the pole, y up], best guesses where not sure
    error     estimated standard deviation [mm]
    """

    vertices: Mapping[str, complex]
    error: float
    unsure: tuple[Unsure, ...] = ()


def measured(page: Page, room: SheetRoom, ways: Sequence[Way]) -> PageReading:
    """The corners of what was drawn in a room, by one of some ways; their letters are those of the first."""
    ink = Ink(page, room)
    if ink.length < _BLANK:
        return PageReading({}, page.rms, (Unsure("blank"),))
    fits = list[_Fit]()
    for one in candidates(ink, ways):
        if one.score > max((fit.score for fit in fits), default=-np.inf) - _HOPELESS:
            fits.append(_Fit(ink, one))
    if not fits:
        return PageReading({}, page.rms, (Unsure("unexplained"),))
    fits.sort(key=lambda fit: fit.score - _ALIKE * (not fit.is_likely), reverse=True)
    best, key = fits[0], ways[0]
    vertices = {letter: corner.at for letter, corner in best.named(key).items()}
    unsure = [*best.unsure()]
    if ink.seen < 1:
        unsure.append(Unsure("outside"))
    unsure += _alike(fits, key)
    left = {letter for one in unsure for letter in one.letters}  # these count for nothing
    offs = [corner.off for letter, corner in best.corners.items() if letter not in left and np.isfinite(corner.off)]
    error = float(np.hypot(page.rms, np.sqrt(np.mean(np.square(offs or [0.0])))))
    return PageReading(vertices, error, tuple(unsure))


def _alike(fits: Sequence[_Fit], key: Way) -> Iterator[Unsure]:
    """Letters that another construction, which fits as well, has elsewhere."""
    others = (fit for fit in fits[1:] if fit.is_likely and fit.score >= fits[0].score - _ALIKE
              and fit.departs <= max(0.0, fits[0].departs) + _ODDER)  # fmt: skip
    best, alike = fits[0].named(key), [fit.named(key) for fit in others]
    for name, corner in best.items():
        apart = max((abs(there[name].at - corner.at) for there in alike if name in there), default=0.0)
        if apart > _APART:
            yield Unsure("alike", (name,), _known(float(np.hypot(corner.off, apart))))


class _Fit(Fit):
    """With its score, its names, and what is not sure of it."""

    def __init__(self, ink: Ink, candidate: Candidate) -> None:
        super().__init__(ink, candidate)
        self.score = self._score()

    def _score(self) -> float:
        """Ink along the refined lines, less needed strokes without any and places that are drawn otherwise [mm]."""
        bare = [(1 - line.covered, s.tail, s.head) for s, line in self.lines.items() if s.needed]
        missing = sum(part * abs(self.at[head] - self.at[tail]) for part, tail, head in bare)
        lines = [(self.at[s.tail], self.at[s.head]) for s in self.lines]
        against = MISSING * float(missing) + SLIP * len(self.candidate.factors) + _STRAIN * self.strain
        return self.ink.along(lines, _CLOSE) - against

    @property
    def is_likely(self) -> bool:
        """A hand may have drawn it."""
        return self.strain <= _TORN and self.departs <= _LIKELY

    def named(self, key: Way) -> dict[str, Corner]:
        """Corners by the letters of the key's method."""
        own = {letter: self.corners[letter] for letter in self.way.letters}
        if self.way is key:
            return own
        by_name = {node.of: name for name, node in self.way.construction.nodes.items()}
        pairs = ((name, by_name.get(node.of, "")) for name, node in key.construction.nodes.items())
        return {name: own[other] for name, other in pairs if other in own}

    def unsure(self) -> Iterator[Unsure]:
        key = self.way.letters
        for stroke, line in self.lines.items():
            length = abs(self.at[stroke.head] - self.at[stroke.tail])
            if stroke.needed and line.covered < _COVERED and length > _SHORT:
                yield Unsure("no ink", tuple(key[k] for k in (stroke.tail, stroke.head) if k != self.pole))
        for k, letter in enumerate(key):
            drawn = [line for s, line in self.lines.items() if k in (s.tail, s.head) and line.covered > 0.5]
            alone = np.abs(np.delete(self.at, k) - self.at[k]).min(initial=np.inf) > _ONE
            if self.corners[letter].off > _OFF or (k != self.pole and not drawn and alone) or k in self.odd:
                short = any(line.length < _SHORT for line in drawn)
                off = 0.0 if k in self.odd or not drawn else _known(self.corners[letter].off)
                yield Unsure("short" if short else "flat" if drawn else "no ink", (letter,), off)
        for k in self.ends:  # also at the rim, where a line may go on
            around = self.at[k] + _FAR * np.exp(0.5j * np.pi * np.arange(4))
            is_far = np.nanmin(np.abs(self.way.corners[:, k] - self.at[k])) > _FAR
            if is_far or not self.ink.inside(around).all():
                yield Unsure("far", (key[k],))
        free = self.way.is_loose and self.candidate.factors  # own velocities would have drawn something else
        if free or self._strange() > STRANGE or not self.is_likely:
            yield Unsure("unexplained")

    def _strange(self) -> float:
        """The longest extent of ink that no line explains, on construction lines beyond the arrows neither [mm]."""
        ends = [(self.at[s.tail], self.at[s.head]) for s, line in self.lines.items() if line.covered > 0.5]
        return self.ink.strange([*self.drawn(), *ends])


def _known(off: float) -> float:
    """A standard deviation, 0 where it says nothing."""
    return off if off < _NOWHERE else 0.0
