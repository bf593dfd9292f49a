"""What a group of links leaves open, as a function of its unknowns, for all positions at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction.kinds import Closure, Fit, InStep
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.rolling import in_step
from graphkin.construction.terms import Arm, Slid

Entry = tuple[int, int, Value]
"""Row, column, and what stands there."""
Sliding = tuple[int, int, int | None, Value]
"""Closure, displacement, the base link that turns its line, None where that is known, and the line's direction."""


class Gaps:
    """Gaps of closures and contacts, in units of the group's size; unknowns: angles first, then displacements.

    A closure is known + sum of arm * e^(i angle) + sum of displacement * direction * e^(i angle): all that is known is
    worked out once.
    """

    def __init__(self, step: Fit, plot: Plot, size: float) -> None:
        self.plot, self.size = plot, size
        self.bases = {base: k for k, base in enumerate(step.angles)}
        self.slides = {slide: k for k, slide in enumerate(step.slides)}
        self.units = np.array([1.0] * len(self.bases) + [size] * len(self.slides))
        self.sliding: list[Sliding] = []
        self.turning: list[Entry] = []
        known = [(0, k, self._closed(k, closure)) for k, closure in enumerate(step.closures)]
        self.known = _filled((1, len(known)), known)[..., 0, :] / size
        self.arms = _filled((len(self.bases), len(known)), self.turning) / size
        self._roll(step.contacts)

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the positions over which what is known differs."""
        rolled = () if self.rolled is None else (self.rolled[0].shape[:-1], self.rolled[1].shape[:-2])
        lines = (np.shape(direction) for *_, direction in self.sliding)
        return np.broadcast_shapes(self.known.shape[:-1], self.arms.shape[:-2], *rolled, *lines)

    def at(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Gaps (.., m) and their slopes by each unknown in its unit (.., m, n), for unknowns x (.., n).

        Closures along x and y by turns, as complex numbers lie in memory; then contacts.
        """
        angles = len(self.bases)
        turned = np.exp(1j * x[..., :angles])
        arrows = self.arms * turned[..., None]
        slope = np.zeros((*x.shape, self.known.shape[-1]), dtype=complex)
        straight = np.zeros((*x.shape[:-1], self.known.shape[-1]), dtype=complex)
        for closure, slide, base, direction in self.sliding:
            line = direction if base is None else direction * turned[..., base]
            slope[..., angles + slide, closure] = line
            into = straight if base is None else arrows[..., base, :]
            into[..., closure] += x[..., angles + slide] / self.size * line
        np.multiply(arrows, 1j, out=slope[..., :angles, :])
        gap = self.known + straight + arrows.sum(axis=-2)
        gaps, slopes = gap.view(float), slope.view(float).swapaxes(-1, -2)
        return (gaps, slopes) if self.rolled is None else self._rolling(self.rolled, x, gaps, slopes)

    def _rolling(
        self, rolled: tuple[np.ndarray, np.ndarray], x: np.ndarray, gaps: np.ndarray, slopes: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """With contacts, which are linear as they are."""
        known, by_each = rolled
        gap = (known + (by_each * x[..., None, :]).sum(axis=-1)) / self.size
        slope = np.broadcast_to(by_each * (self.units / self.size), (*x.shape[:-1], *by_each.shape[-2:]))
        return np.concatenate([gaps, gap], axis=-1), np.concatenate([slopes, slope], axis=-2)

    # --- what is known ------------------------------------------------------------------------

    def _closed(self, number: int, closure: Closure) -> Value:
        """Enters the parts of a closure that an unknown turns or pushes; gives the sum of the others [m]."""
        position = self.plot.position
        known = 0j if closure.floats else position[closure.start] - position[closure.end]
        for part in closure.parts:
            if isinstance(part, Arm):
                shape = self.plot.facts.shapes[part.link]
                known = known + self._turned(number, part.link, shape[part.head] - shape[part.tail])
            else:
                known = known + self._slid(number, part)
        return known

    def _turned(self, number: int, link: str, arm: Value) -> Value:
        """An arm that an unknown turns is entered with 0 left; else as it lies."""
        facts = self.plot.facts
        base = self.bases.get(facts.turns[link].base)
        if base is None:
            return arm * np.exp(1j * self.plot.theta[link])
        self.turning.append((base, number, arm * np.exp(1j * facts.relative_angle(link))))
        return 0.0

    def _slid(self, number: int, part: Slid) -> Value:
        guide, _, direction = self.plot.facts.lines[part.slide]
        slide, line = self.slides.get(part.slide), part.sign * direction
        if slide is None:
            return self._turned(number, guide, self.plot.s[part.slide] * line)
        base = self.bases.get(self.plot.facts.turns[guide].base)
        angle = self.plot.theta[guide] if base is None else self.plot.facts.relative_angle(guide)
        self.sliding.append((number, slide, base, line * np.exp(1j * angle)))
        return 0.0

    def _roll(self, contacts: Sequence[InStep]) -> None:
        """What contacts know, and what each unknown adds to them."""
        names = [*self.bases, *map(slide_key, self.slides)]
        rows = [in_step(contact, self.plot, "position", {*self.bases}, {*self.slides}) for contact in contacts]
        entries = [(k, names.index(name), value) for k, (_, of) in enumerate(rows) for name, value in of.items()]
        by_each = _filled((len(rows), len(names)), entries).real
        known = _filled((1, len(rows)), [(0, k, value) for k, (value, _) in enumerate(rows)]).real[..., 0, :]
        self.rolled = (known, by_each) if rows else None


def _filled(size: tuple[int, int], entries: Sequence[Entry]) -> np.ndarray:
    """Entries added up, over the positions of those that are not the same at all."""
    shape = np.broadcast_shapes(*(np.shape(value) for *_, value in entries))
    found = np.zeros((*shape, *size), dtype=complex)
    for row, column, value in entries:
        found[..., row, column] += value
    return found
