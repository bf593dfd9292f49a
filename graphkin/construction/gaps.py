"""What a group of links leaves open, as a function of its unknowns, for all positions at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.construction.kinds import Closure, Fit, InStep
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.rolling import in_step
from graphkin.construction.terms import Arm, Slid
from graphkin.geometry import Value

Entry = tuple[int, int, Value]
"""Row, column, and what stands there."""
Sliding = tuple[int, int, int | None, Value]
"""Closure, displacement, the base link that turns its line, None where that is known, and the line's direction."""


class Gaps:
    """Gaps of closures and contacts, in units of the group's size; unknowns: angles first, then displacements.

    A closure is known + sum of arm * e^(i angle) + sum of displacement * direction * e^(i angle): all that is known is
    worked out once.
    """

    def __init__(self, step: Fit, plot: Plot, units: np.ndarray, size: float) -> None:
        self.plot, self.units, self.size = plot, units, size
        self.bases = {base: k for k, base in enumerate(step.angles)}
        self.slides = {slide: k for k, slide in enumerate(step.slides)}
        self.closures, self.contacts = len(step.closures), len(step.contacts)
        self.sliding: list[Sliding] = []
        self.turning: list[Entry] = []
        known = [self._closed(k, closure) for k, closure in enumerate(step.closures)]
        self.known = _filled((self.closures,), [(k, 0, value) for k, value in enumerate(known)])
        self.arms = _filled((self.closures, len(self.bases)), self.turning)
        self._roll(step.contacts)

    def at(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Gaps (.., m) and their slopes by each unknown in its unit (.., m, n), for unknowns x (.., n)."""
        turned = np.exp(1j * x[..., : len(self.bases)])
        arrows, gap = self.arms * turned[..., None, :], self.known
        along = np.zeros((*x.shape[:-1], self.closures, len(self.slides)), dtype=complex)
        for closure, slide, base, direction in self.sliding:
            line = direction if base is None else direction * turned[..., base]
            along[..., closure, slide] += line
            if base is not None:
                arrows[..., closure, base] += x[..., len(self.bases) + slide] * line
        gap = gap + arrows.sum(axis=-1)
        for closure, slide, base, direction in self.sliding:
            if base is None:
                gap[..., closure] += x[..., len(self.bases) + slide] * direction
        slope = np.concatenate([1j * arrows, along], axis=-1)
        return self._by_rows(x, gap, slope)

    def _by_rows(self, x: np.ndarray, gap: np.ndarray, slope: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Closures along x and y by turns, then contacts."""
        twice, many = 2 * self.closures, 2 * self.closures + self.contacts
        gaps, slopes = np.empty((*x.shape[:-1], many)), np.empty((*x.shape[:-1], many, x.shape[-1]))
        gaps[..., 0:twice:2], gaps[..., 1:twice:2] = gap.real, gap.imag
        slopes[..., 0:twice:2, :], slopes[..., 1:twice:2, :] = slope.real, slope.imag
        if self.contacts:
            slopes[..., twice:, :] = self.rolled
            gaps[..., twice:] = self.rolled_known + (self.rolled * x[..., None, :]).sum(axis=-1)
        return gaps / self.size, slopes * (self.units / self.size)

    # --- what is known ------------------------------------------------------------------------

    def _closed(self, number: int, closure: Closure) -> Value:
        """Enters the parts of a closure that an unknown turns or pushes; gives the sum of the others [m]."""
        position = self.plot.position
        known = position[closure.start] - position[closure.end]
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
        self.turning.append((number, base, arm * np.exp(1j * facts.relative_angle(link))))
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
        """Contacts are linear as they are."""
        names = [*self.bases, *map(slide_key, self.slides)]
        rows = [in_step(contact, self.plot, "position", {*self.bases}, {*self.slides}) for contact in contacts]
        entries = [(k, names.index(name), value) for k, (_, of) in enumerate(rows) for name, value in of.items()]
        self.rolled = _filled((len(rows), len(names)), entries).real
        self.rolled_known = _filled((len(rows),), [(k, 0, value) for k, (value, _) in enumerate(rows)]).real


def _filled(size: tuple[int, ...], entries: Sequence[Entry]) -> np.ndarray:
    """Entries added up, over the positions of those that are not the same at all."""
    shape = np.broadcast_shapes(*(np.shape(value) for *_, value in entries))
    found = np.zeros((*shape, *size), dtype=complex)
    for row, column, value in entries:
        found[(..., row, column)[: 1 + len(size)]] += value
    return found
