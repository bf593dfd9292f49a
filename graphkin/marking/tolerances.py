"""The accuracy that paper allows: the scatter of each quantity by pencil, and the steps that cost most of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import assert_never

import numpy as np

from graphkin.base.geometry import Value, number
from graphkin.base.scales import finer
from graphkin.base.value import bulky, frozen
from graphkin.construction import Construction, LayOff, Plane, Plot, Simultaneous, Term, terms
from graphkin.marking.answers import ArrowPlaces, arrows_of, drawn_answer, readable, size_of
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.key import TELLS, Key, KeyEntry, Marking, Sort, part_off
from graphkin.marking.pencil import Mark, Pencil, PencilHand, Slips, called, drawn_positions, seed_of
from graphkin.marking.rewrite import Rewrite
from graphkin.model.mechanism import ROUNDING
from graphkin.model.quantities import Quantity, kinds
from graphkin.planning import Method

_AT_ONCE, _NUMBERS = 64, 2**21
"""Mistakes that are drawn at once, each many times; fewer where more numbers than these are read off."""
_HARDLY = 0.05  # where a smaller part of the drawings closes, nobody begins again
DRAWINGS = 2000  # drawings of the right construction
_PARTS = ((0.6826894921370859, 1.0), (0.99, 2.5758293035489004))
"""These parts of its values lie within so many standard deviations of a normal quantity."""


@frozen
class Drawings:
    """One mechanism drawn many times with a pencil, positions (n,).

    failed  part of the drawings whose links did not meet. Whoever draws one begins again, on another sheet: it is none
            of the n, unless hardly any closes
    """

    method: Method
    pencil: Pencil
    slips: Slips
    arrows: ArrowPlaces
    positions: Plot
    failed: float = 0.0

    @classmethod
    def of(cls, method: Method, pencil: Pencil, slips: Slips) -> Drawings:
        with np.errstate(invalid="ignore", divide="ignore"):
            positions = drawn_positions(method, pencil, slips)
            failed = float(1 - _closed(positions, slips.count).mean())
            if 0 < failed < 1 - _HARDLY:  # the first drawings that close, as many as there were
                more = slips.more(int(1.5 * slips.count / (1 - failed)) + 10)
                kept = np.flatnonzero(_closed(drawn_positions(method, pencil, more), more.count))
                slips = more.only(kept[: slips.count])
                positions = drawn_positions(method, pencil, slips)
            return cls(method, pencil, slips, arrows_of(method), positions, failed)

    def values(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]] = ((),)) -> np.ndarray:
        """Values that are read off: (columns, n, quantities); each column is drawn with its mistakes."""
        parts = [*self.parts(quantities, columns)]
        return np.concatenate(parts) if parts else np.empty((0, self.slips.count, len(quantities)))

    def parts(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]) -> Iterator[np.ndarray]:
        """The same, some columns at a time: of many links all of them are more than a memory holds."""
        some = min(_AT_ONCE, max(1, _NUMBERS // (self.slips.count * max(1, len(quantities)))))
        for k in range(0, len(columns), some):
            yield self._values(quantities, columns[k : k + some])

    def _values(self, quantities: Sequence[Quantity], columns: Sequence[Sequence[Rewrite]]) -> np.ndarray:
        edited = [column for column in columns if any(rewrite.edits for rewrite in column)]
        hand = PencilHand(self.pencil, self.slips, self.method.facts(), [(), *edited])  # others are the right drawing
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            plot = redraw(self.method, hand.placed(self.method, self.positions), hand, hand.shape)
            answers = [drawn_answer(self.method, plot, quantity, self.arrows).value for quantity in quantities]
            slips = [self._slip(plot, quantity) for quantity in quantities]
            readings = [np.broadcast_to(value + slip, hand.shape) for value, slip in zip(answers, slips, strict=True)]
        drawn = np.stack(readings, axis=-1).astype(float, copy=False) if readings else np.empty((*hand.shape, 0))
        rows = count(1)
        values = drawn[[next(rows) if any(rewrite.edits for rewrite in column) else 0 for column in columns]]
        numbers = {quantity.text: k for k, quantity in enumerate(quantities)}
        for row, rewrites in enumerate(columns):
            whole = values[row].copy()
            for written in (one for rewrite in rewrites for one in rewrite.asked):
                k = numbers[written.quantity]
                is_vector, read = isinstance(quantities[k], kinds.Moving), values[row, :, k]
                factor = complex(written.factor)
                if written.other:
                    values[row, :, k] = whole[:, numbers[written.other]]
                elif written.instead is None:  # so many times what was read
                    values[row, :, k] = read * (abs(factor) if is_vector else factor.real)
                else:  # another value, which scatters as what was read does
                    other = factor * written.instead
                    around = number(size_of(quantities[k], other)) if is_vector else other.real
                    values[row, :, k] = read + (around - float(np.nanmean(read)))
        return values

    def _slip(self, plot: Redrawing, quantity: Quantity) -> Value:
        """The error of what is read off at the end; rotations were read on the way, products are calculated."""
        lengths, slips = self.pencil.lengths, self.slips
        match quantity:
            case kinds.Rotation(word="theta"):
                return self.pencil.angle * slips.of(Mark("position", "reading", (quantity.text,)))
            case kinds.Displacement() | kinds.Place():
                return lengths["position"] * slips.of(Mark("position", "reading", (quantity.text,)))
            case kinds.Moving() | kinds.Component():
                plane: Plane = "velocity" if quantity.letter == "v" else "acceleration"
                ends = self.arrows.of(quantity if isinstance(quantity, kinds.Moving) else quantity.whole)
                if ends is not None and ends[0] in plot.laid:
                    return 0.0
                of = (quantity.text,) if ends is None else ends[0][1:]
                return lengths[plane] * slips.of(Mark(plane, "reading", of))
            case kinds.Rotation() | kinds.Quotient() | kinds.Track() | kinds.Centre():
                return 0.0
            case _:
                assert_never(quantity)


def _closed(positions: Plot, count: int) -> np.ndarray:
    """The drawings that have a place for every point (count,), as booleans."""
    closed = np.ones(count, dtype=bool)
    for place in positions.position.values():
        closed &= np.isfinite(place)
    return closed


def spread(values: np.ndarray, around: np.ndarray, sorts: Sequence[Sort]) -> np.ndarray:
    """Standard deviations over drawings (.., n, quantities) from values (.., quantities).

    NaN where most drawings fail; others are left out. By how much two thirds of the values are off at most, or nearly
    all, whichever is more: near a dead point the ends reach far. Sizes count without sign, angles modulo a turn.
    """
    size, angle = (np.array([sort == kind for sort in sorts], dtype=bool) for kind in ("size", "angle"))
    around = around[..., None, :]
    with np.errstate(invalid="ignore"):  # beyond all size, or of a value that is
        off = np.where(size, np.abs(values) - np.abs(around), values - around)
        off = np.abs(np.where(angle, off - 2 * np.pi * np.round(off / (2 * np.pi)), off))
    off = np.sort(off, axis=-2)  # NaN come last
    count = np.isfinite(off).sum(axis=-2)
    deviations = []
    for part, sigmas in _PARTS:
        place = np.maximum(np.ceil(part * count).astype(int) - 1, 0)
        deviations.append(np.take_along_axis(off, place[..., None, :], axis=-2)[..., 0, :] / sigmas)
    return np.where(2 * count < values.shape[-2], np.nan, np.maximum(*deviations))


def pencil_of(marking: Marking) -> Pencil:
    """The pencil of a student: its errors of length by plane [mm], and of angles [deg]."""
    return Pencil({plane: marking.lengths[plane] for plane in ("position", "velocity", "acceleration")}, marking.angle)


def drawings_of(method: Method, marking: Marking, count: int, part: float = 1.0) -> Drawings:
    """The mechanism drawn so many times, with a part of the errors; the same drawings again for the same mechanism."""
    return Drawings.of(method, pencil_of(marking).times(part), Slips(seed_of(method.mechanism), count))


# --- the costliest steps -----------------------------------------------------------------------


_FEWER = 500
_LARGER = (1.5, 2.0, 2.5, 3.0, 4.0, 5.0)  # so many times as large a drawing is tried
_COUNTS = 1e-4  # a step with a smaller part of the scatter is left out


@frozen
class Cost:
    """The cost of one step: its part of each quantity's scatter (variance), by quantity. name: of an arrow, a guide."""

    mark: Mark
    name: str
    parts: Mapping[str, float]
    over_all: float


Untold = Mapping[str, tuple[float, Mapping[str, float] | None]]


@bulky
class Tolerances:
    """Quantities with what they may be off, and steps, the costliest first.

    drawings  how often the construction was drawn
    failed    part of the drawings whose links did not meet
    untold    as `untold` has it
    """

    key: Key
    entries: tuple[KeyEntry, ...]
    costs: tuple[Cost, ...]
    drawings: int
    failed: float
    untold: Untold

    def worst(self, text: str) -> Cost | None:
        """The step that costs a quantity most."""
        some = [cost for cost in self.costs if cost.parts.get(text, 0.0) > 0]
        return max(some, key=lambda cost: cost.parts[text], default=None)


def tolerances(key: Key, method: Method) -> Tolerances:
    """The scatter of a key's quantities, taken apart: one error of the pencil at a time."""
    quantities = [q for entry in key.entries if (q := readable(method.mechanism, entry.text)) is not None]
    every = drawings_of(method, key.marking, DRAWINGS)
    values = every.values(quantities)[0]
    right, sorts = np.array([entry.right for entry in key.entries]), [entry.sort for entry in key.entries]
    whole, asked = spread(values, right, sorts), np.array([entry.points != 0 for entry in key.entries], dtype=bool)
    names = {"position": _guides(method)}
    costs, pencil = [], pencil_of(key.marking)
    unmoved = Drawings.of(method, pencil, Slips(seed_of(method.mechanism), _FEWER, lambda mark: False))
    for mark in list(every.slips.seen):
        slips = Slips(seed_of(method.mechanism), _FEWER, mark.__eq__)
        # an error of a polygon leaves the mechanism as it is
        drawn = Drawings.of(method, pencil, slips) if mark.plane == "position" else replace(unmoved, slips=slips)
        alone = spread(drawn.values(quantities)[0], right, sorts)
        with np.errstate(invalid="ignore", divide="ignore"):
            parts = np.nan_to_num((alone / whole) ** 2, nan=0.0, posinf=0.0)
        parts = np.append(parts, np.mean(parts[asked]) if asked.any() else 0.0)
        # both are sampled: of one step's scatter alone there may come out a little more
        *of_each, over_all = map(float, np.where(parts > ROUNDING, np.minimum(parts, 1.0), 0.0))
        by_text = {entry.text: part for entry, part in zip(key.entries, of_each, strict=True)}
        named = names.setdefault(mark.plane, _arrows(method))
        costs.append(Cost(mark, named.get(mark.of, ""), by_text, over_all))
    costly = sorted((cost for cost in costs if max(cost.parts.values()) > _COUNTS), key=lambda cost: -cost.over_all)
    failed = every.failed + (1 - every.failed) * float(np.isnan(values).any(axis=1).mean())
    return Tolerances(key, key.entries, tuple(costly), DRAWINGS, failed, untold(key, method))


def parts_off(method: Method, entries: Sequence[KeyEntry]) -> dict[str, float]:
    """The part of each value that may be off, by its question."""
    return {entry.text: part_off(entry, method.mechanism.usual.size(entry.unit)) for entry in entries}


def untold(key: Key, method: Method) -> Untold:
    """The answers that paper does not tell, which `problems` does not ask for: the part that may be off, more than
    `TELLS`, and the scales of the first larger drawing that tells it, where one does."""
    asked = [entry for entry in key.entries if entry.points]
    size, right = method.mechanism.usual.size, np.array([entry.right for entry in asked])
    parts = parts_off(method, asked)
    off: dict[str, tuple[float, Mapping[str, float] | None]]
    off = {text: (part, None) for text, part in parts.items() if part > TELLS}
    quantities = [q for entry in asked if (q := readable(method.mechanism, entry.text)) is not None]
    for times in reversed(_LARGER) if off and not key.marking.relative else ():
        lengths = {plane: error / times for plane, error in key.marking.lengths.items()}
        drawn = drawings_of(method, replace(key.marking, lengths=lengths), DRAWINGS).values(quantities)[0]
        scatters = spread(drawn, right, [entry.sort for entry in asked])
        for entry, scatter in zip(asked, scatters, strict=True):
            there = part_off(replace(entry, tolerance=key.marking.sigmas * scatter), size(entry.unit))
            if entry.text in off and there <= TELLS:
                scales = {name: finer(1.001 * scale / times) for name, scale in key.marking.scales.items()}
                off[entry.text] = parts[entry.text], scales
    return off


def _guides(method: Method) -> dict[tuple[str, ...], str]:
    """Guides, and the starts of their lines, that have no name of their own: by the point that slides."""
    names: dict[tuple[str, ...], str] = {}
    for name, slide in method.structure.slides.items():
        called = name if slide.named else slide.point
        names |= {(name,): called} | ({} if slide.line.named else {(slide.guide, slide.line.origin): called})
    return names


def _arrows(method: Method) -> dict[tuple[str, ...], str]:
    """The names of arrows in the polygons, by what marks call them."""
    names: dict[tuple[str, ...], str] = {}
    for construction in (method.velocity, method.acceleration):
        for step in construction.steps:
            if isinstance(step, LayOff) and step.term.size is not None:
                names.setdefault(called(step.term.size), step.term.name(construction.plane))
            elif isinstance(step, Simultaneous):
                for size in (size for chain in step.chains for size, _ in chain.known):
                    names.setdefault(called(size), _name(size, construction.plane, method.velocity))
    return names


def _name(size: terms.Size, plane: Plane, velocity: Construction) -> str:
    """An arrow of equations that are solved together, by its kind and its points."""
    match size:
        case terms.Driven(slide):
            return slide
        case terms.Normal(_, tail, head) | terms.Tangential(_, tail, head) | terms.Turning(_, tail, head):
            part = {terms.Normal: "n", terms.Tangential: "t"}.get(type(size), "")
            return Term(head, tail, part, None, None, "", "").name(plane)
        case terms.Coriolis(_, tail, head):
            at = next(node.site.point for node in (velocity.nodes[tail], velocity.nodes[head]) if node.site)
            of, seen_from = (at if node == velocity.pole else velocity.nodes[node].of for node in (head, tail))
            return Term(of, seen_from, "k", None, None, "", "").name(plane)
        case _:
            return ""
