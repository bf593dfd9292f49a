"""A room of a photographed sheet measured: the corners of the polygon that was drawn, and what is not sure of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.value import frozen
from graphkin.marking.key import Name
from graphkin.photo.ink import STRANGE, Ink, Page
from graphkin.photo.lines import Corner, Line, crossing, free_end, line_near
from graphkin.photo.predicted import Predicted, Stroke, Way
from graphkin.photo.searching import MISSING, SLIP, Candidate, candidates, drawn_strokes
from graphkin.photo.sheets import SheetRoom, Unsure

_REACHES = (2.0, 1.2, 0.8)  # a line is sought so far from where it is expected, closer each time [mm]
_SHORT, _FLAT = 4.0, np.sin(np.radians(12))  # shorter lines, flatter crossings are not measured
_COVERED = 0.75  # a stroke has ink over so much of its length
_OFF = 0.17  # corners with a larger standard deviation are not sure [mm]
_ALIKE, _APART = 4.0, 0.3  # constructions that score so alike and lie so far apart are not told apart [mm]
_TELLS = 20.0  # lines that are longer tell how the hand wobbles [mm]
_CLOSE = 0.6  # ink belongs to a refined line when it is no farther off [mm]
_ONE = 0.15  # corners so near each other are one [mm]
_FAR = 2.0  # where a single line ends no farther from where a construction has it, it ends on purpose [mm]
_BLANK = 15.0  # less than so much ink is no drawing [mm]
_NAMED = 1.0  # the worst departure, in what a pencil allows, of a construction that is named


@frozen
class PageReading:
    """The measures of a room.

    vertices      by letter of the key's construction [mm from the pole, y up], best guesses where not sure
    error         estimated standard deviation [mm]
    construction  the mistakes that draw what was measured, each of them alone; () where it is right, None where neither
    """

    vertices: Mapping[str, complex]
    error: float
    unsure: tuple[Unsure, ...] = ()
    construction: tuple[tuple[Name, ...], ...] | None = None


def measured(page: Page, room: SheetRoom, predicted: Predicted) -> PageReading:
    """The corners of what was drawn in a room."""
    ink = Ink(page, room, predicted.direction)
    if ink.length < _BLANK:
        return PageReading({}, page.rms, (Unsure("blank"),))
    fits = [_Fit(ink, one) for one in candidates(ink, predicted)]
    if not fits:
        return PageReading({}, page.rms, (Unsure("unexplained"),))
    fits.sort(key=lambda fit: -fit.score)
    best, key = fits[0], predicted.ways[0]
    vertices = {letter: corner.at for letter, corner in best.named(key).items()}
    unsure = [*best.unsure()]
    if ink.seen < 1:
        unsure.append(Unsure("outside"))
    names = best.names()
    if names is None and not best.candidate.factors:  # taken for a construction from which it departs
        unsure.append(Unsure("unexplained"))
    unsure += _alike(fits, key)
    left = {letter for one in unsure for letter in one.letters}  # these count for nothing
    offs = [corner.off for letter, corner in best.corners.items() if letter not in left and np.isfinite(corner.off)]
    error = float(np.hypot(page.rms, max(offs, default=0.0)))
    return PageReading(vertices, error, tuple(unsure), names)


def _alike(fits: Sequence[_Fit], key: Way) -> Iterator[Unsure]:
    """Letters that another construction, which fits as well, has elsewhere."""
    best, letters = fits[0].named(key), dict[str, None]()
    for other in fits[1:]:
        if other.score >= fits[0].score - _ALIKE:
            there = other.named(key)
            both = [name for name in best if name in there]
            letters.update(dict.fromkeys(name for name in both if abs(there[name].at - best[name].at) > _APART))
    if letters:
        yield Unsure("alike", tuple(letters))


class _Fit:
    """A candidate with its lines refined: corners by letter, lines by stroke."""

    def __init__(self, ink: Ink, candidate: Candidate) -> None:
        self.ink, self.candidate, self.way = ink, candidate, candidate.way
        self.pole = self.way.pole
        self.at = candidate.corners.copy()
        self.lines: dict[Stroke, Line] = {}
        self.corners: dict[str, Corner] = {}
        self.ends = set[int]()  # corners at which a single line ends
        self.together = _together(candidate.corners)
        for reach in _REACHES:
            self._refine(reach)
        self.score = self._score()

    def _refine(self, reach: float) -> None:
        long = [line.spread for line in self.lines.values() if line.length > _TELLS]
        spread = float(np.quantile(long, 0.3)) if long else np.inf
        self.lines = {}
        for stroke in drawn_strokes(self.way, self.at):
            line = line_near(self.ink, (self.at[stroke.tail], self.at[stroke.head]), reach, spread, stroke.goes_on)
            if stroke.needed or line.covered > 0.95:
                self.lines[stroke] = line
        long = [line.scatter for line in self.lines.values() if line.length > _TELLS]
        wobble = float(np.median(long)) if long else 0.0
        self.lines = {stroke: line.drawn_by(wobble) for stroke, line in self.lines.items()}
        at, self.ends = self.at.copy(), set()
        for same in self.together:
            corner = Corner(0j, 0.0) if self.pole in same else self._corner(same)
            self.corners.update(dict.fromkeys((self.way.letters[k] for k in same), corner))
            if np.isfinite(corner.off) and abs(corner.at - self.at[same[0]]) < 2.5 * reach + 1:
                at[same] = corner.at
        self.at = at

    def _corner(self, same: list[int]) -> Corner:
        """One corner, where its lines cross; strokes that need not be drawn count where others do not tell it."""
        there = [(s, line) for s, line in self.lines.items() if (s.tail in same) != (s.head in same)]
        every = [(s, line) for s, line in there if line.covered > 0.5 and line.length >= _SHORT]
        near = self.at[same[0]]
        for needed in (True, False):
            some = [line for stroke, line in every if stroke.needed or not needed]
            if len(some) > 1 and _steep(some) >= _FLAT:
                return crossing(some, near)
        inwards = [self.at[stroke.tail if stroke.head in same else stroke.head] for stroke, _ in there]
        one_side = all(((each - near) * (inwards[0] - near).conjugate()).real > 0 for each in inwards)
        if every and len(every) == len(there) and one_side and not any(stroke.goes_on for stroke, _ in every):
            line = max(every, key=lambda each: (each[0].needed, each[1].length))[1]
            self.ends |= {*same}
            return free_end(self.ink, line, near, inwards[0])
        return Corner(near, np.inf)

    def _score(self) -> float:
        """Ink along the refined lines, less needed strokes without any and places that are drawn otherwise [mm]."""
        bare = [(1 - line.covered, s.tail, s.head) for s, line in self.lines.items() if s.needed]
        missing = sum(part * abs(self.at[head] - self.at[tail]) for part, tail, head in bare)
        lines = [(self.at[s.tail], self.at[s.head]) for s in self.lines]
        return self.ink.along(lines, _CLOSE) - MISSING * float(missing) - SLIP * len(self.candidate.factors)

    def named(self, key: Way) -> dict[str, Corner]:
        """Corners by the letters of the key's method."""
        own = {letter: self.corners[letter] for letter in self.way.letters}
        if self.way is key:
            return own
        by_name = {node.of: name for name, node in self.way.construction.nodes.items()}
        pairs = ((name, by_name.get(node.of, "")) for name, node in key.construction.nodes.items())
        return {name: own[other] for name, other in pairs if other in own}

    def names(self) -> tuple[tuple[Name, ...], ...] | None:
        """The mistakes whose construction this is."""
        off = self.way.departures({name: one.at for name, one in self.corners.items() if np.isfinite(one.off)})
        if off[0] <= _NAMED:
            return ()
        if off.min() > 1.5 * _NAMED:
            return None
        fits = np.flatnonzero(off <= max(_NAMED, 1.2 * off.min()))
        return tuple(tuple(one.name for one in self.way.columns[k]) for k in fits)

    def unsure(self) -> Iterator[Unsure]:
        key = self.way.letters
        for stroke, line in self.lines.items():
            length = abs(self.at[stroke.head] - self.at[stroke.tail])
            if stroke.needed and line.covered < _COVERED and length > _SHORT:
                yield Unsure("no ink", tuple(key[k] for k in (stroke.tail, stroke.head) if k != self.pole))
        for letter, corner in self.corners.items():
            if not corner.off <= _OFF:
                k = key.index(letter)
                drawn = [line for s, line in self.lines.items() if k in (s.tail, s.head)]
                short = any(line.length < _SHORT for line in drawn)
                yield Unsure("short" if short else "flat" if drawn else "no ink", (letter,))
        for k in self.ends:  # also at the rim, where a line may go on
            around = self.at[k] + _FAR * np.exp(0.5j * np.pi * np.arange(4))
            is_far = np.nanmin(np.abs(self.way.corners[:, k] - self.at[k])) > _FAR
            if is_far or not self.ink.inside(around).all():
                yield Unsure("far", (key[k],))
        if self._strange() > STRANGE:
            yield Unsure("unexplained")

    def _strange(self) -> float:
        """The longest extent of ink that no line explains, on construction lines beyond the arrows neither [mm]."""
        lines = [line for line in self.lines.values() if line.covered > 0.5]
        return self.ink.strange([(line.middle - 400 * line.along, line.middle + 400 * line.along) for line in lines])


def _together(corners: np.ndarray) -> list[list[int]]:
    """Corners by number, those that lie on each other together."""
    groups: list[list[int]] = []
    for k, at in enumerate(corners):
        group = next((group for group in groups if abs(corners[group[0]] - at) < _ONE), None)
        groups.append([k]) if group is None else group.append(k)
    return groups


def _steep(lines: Sequence[Line]) -> float:
    """The sine of the largest angle between any two lines."""
    along = np.array([line.along for line in lines])
    return float(np.abs((along[:, None] * along.conj()).imag).max())
