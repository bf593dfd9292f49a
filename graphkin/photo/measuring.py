"""A room of a photographed sheet measured: the corners of the polygon that was drawn, and what is not sure of them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.photo.fitting import COVERED, ONE, FittedCandidate
from graphkin.photo.ink import STRANGE, Ink, MeasuredPaper
from graphkin.photo.predicted import Way
from graphkin.photo.searching import MISSING, SLIP, Candidate, candidates
from graphkin.photo.sheets import SheetRoom, Unsure

_SHORT = 4.0  # shorter lines may have less ink [mm]
_NOWHERE = 5.0  # where the standard deviation is larger nothing is known [mm]
_OFF = 0.2  # corners with a larger standard deviation are not sure [mm]
_ALIKE, _APART = 6.0, 0.4  # constructions that score so alike and lie so far apart are not told apart [mm]
_CLOSE = 0.6  # ink belongs to a refined line when it is no farther off [mm]
_FAR = 2.0  # where a single line ends no farther from where a construction has it, it ends on purpose [mm]
_STRAIN = 2.0  # what contradicts counts so much [mm a standard deviation]
_STILL = 0.03  # what moves corners less is not told [mm]
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
    shifts    how those that are not sure, but known as well as `unsure` says, may all be off together: independent of
              each other, each by one standard deviation [mm]
    """

    vertices: Mapping[str, complex]
    error: float
    unsure: tuple[Unsure, ...] = ()
    shifts: tuple[Mapping[str, complex], ...] = ()


def measured(page: MeasuredPaper, room: SheetRoom, ways: Sequence[Way]) -> PageReading:
    """The corners of what was drawn in a room, by one of some ways; their letters are those of the first."""
    ink = Ink(page, room)
    if ink.length < _BLANK:
        return PageReading({}, page.rms, (Unsure("blank"),))
    fits = list[_Fit]()
    for one in candidates(ink, ways):
        if one.score > max((fit.score for fit in fits), default=-np.inf) - _HOPELESS:
            fits.append(_Fit(ink, one, ways[0]))
    if not fits:
        return PageReading({}, page.rms, (Unsure("unexplained"),))
    fits.sort(key=lambda fit: fit.score - _ALIKE * (not fit.is_likely), reverse=True)
    best, own, rivals = fits[0], fits[0].numbers, [*fits[0].apart(fits[1:])]
    unsure = [*best.unsure(), *best.alike(rivals)]
    if ink.seen < 1:
        unsure.append(Unsure("outside"))
    doubts = {name: [one for one in unsure if name in (one.letters or own)] for name in own}
    known = [name for name, reasons in doubts.items() if reasons and all(one.off for one in reasons)]
    sure = [best.off[own[name]] for name, reasons in doubts.items() if not reasons]
    error = float(np.hypot(page.rms, np.sqrt(np.mean(np.square(sure or [0.0])))))
    vertices = {name: complex(best.at[k]) for name, k in own.items()}
    return PageReading(vertices, error, tuple(unsure), (*best.shifts(rivals, known),))


class _Fit(FittedCandidate):
    """With its score, its corners by the letters of the key's method, and what is not sure of it."""

    def __init__(self, ink: Ink, candidate: Candidate, key: Way) -> None:
        super().__init__(ink, candidate)
        self.score, self.numbers = self._score(), self._numbers(key)

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

    def _numbers(self, key: Way) -> dict[str, int]:
        """Corners by the letters of the key's method."""
        own = {letter: k for k, letter in enumerate(self.way.letters)}
        if self.way is key:
            return own
        by_name = {node.of: name for name, node in self.way.construction.nodes.items()}
        pairs = ((name, by_name.get(node.of, "")) for name, node in key.construction.nodes.items())
        return {name: own[other] for name, other in pairs if other in own}

    def apart(self, others: Iterable[_Fit]) -> Iterator[dict[str, complex]]:
        """From its corners to those of each that fits as well; of more beside their lines than its own, none."""
        for fit in others:
            if fit.is_likely and fit.score >= self.score - _ALIKE and fit.departs <= max(0.0, self.departs) + _ODDER:
                none = fit.odd if len(fit.odd) > len(self.odd) else ()
                there = {name: fit.at[k] for name, k in fit.numbers.items() if k not in none}
                yield {name: complex(there[name] - self.at[k]) for name, k in self.numbers.items() if name in there}

    def alike(self, rivals: Sequence[Mapping[str, complex]]) -> Iterator[Unsure]:
        """Letters that rivals have elsewhere."""
        for name, k in self.numbers.items():
            apart = max((abs(rival.get(name, 0j)) for rival in rivals), default=0.0)
            if apart > _APART:
                yield Unsure("alike", (name,), _known(math.hypot(self.off[k], apart)))

    def shifts(self, rivals: Sequence[Mapping[str, complex]], names: Sequence[str]) -> Iterator[dict[str, complex]]:
        """Shifts by which some corners may be off, each one deviation: as lines leave them, and as rivals have them."""
        numbers = np.array([self.numbers[name] for name in names], dtype=int)
        both = np.r_[numbers, numbers + len(self.at)]
        sizes, ways = np.linalg.eigh(self.spread[np.ix_(both, both)])
        x, y = np.split(ways * np.sqrt(np.maximum(sizes, 0.0)), 2)
        yield from (dict(zip(names, way.tolist(), strict=True)) for way in (x + 1j * y).T if np.abs(way).max() > _STILL)
        yield from ({name: rival.get(name, 0j) / math.sqrt(len(rivals)) for name in names} for rival in rivals)

    def unsure(self) -> Iterator[Unsure]:
        key = self.way.letters
        for stroke, line in self.lines.items():
            length = abs(self.at[stroke.head] - self.at[stroke.tail])
            if stroke.needed and line.covered < COVERED and length > _SHORT:
                yield Unsure("no ink", tuple(key[k] for k in (stroke.tail, stroke.head) if k != self.pole))
        for k, letter in enumerate(key):
            drawn = [line for s, line in self.lines.items() if k in (s.tail, s.head) and line.covered > 0.5]
            alone = np.abs(np.delete(self.at, k) - self.at[k]).min(initial=np.inf) > ONE
            if self.off[k] > _OFF or (k != self.pole and not drawn and alone) or k in self.odd:
                short = any(line.length < _SHORT for line in drawn)
                off = 0.0 if k in self.odd or not drawn else _known(self.off[k])
                yield Unsure("short" if short else "flat" if drawn else "no ink", (letter,), off)
        for k in self.ends:  # also at the rim, where a line may go on
            around = self.at[k] + _FAR * np.exp(0.5j * np.pi * np.arange(4))
            is_far = np.nanmin(np.abs(self.way.corners[:, k] - self.at[k])) > _FAR
            if is_far or not self.ink.inside(around).all():
                yield Unsure("far", (key[k],))
        free = self.way.is_loose and self.candidate.factors  # own velocities would have drawn something else
        ends = [(self.at[s.tail], self.at[s.head]) for s, line in self.lines.items() if line.covered > 0.5]
        strange = self.ink.strange([*self.drawn(), *ends])  # on construction lines beyond the arrows nothing is
        if free or strange > STRANGE or not self.is_likely:
            yield Unsure("unexplained")


def _known(off: float) -> float:
    """A standard deviation, 0 where it says nothing."""
    return float(off) if off < _NOWHERE else 0.0
