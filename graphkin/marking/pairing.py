"""Two mistakes made together: what every pair of them gives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.construction import Plot
from graphkin.marking.consequences import combined, rewrites
from graphkin.marking.key import Hypotheses, Key
from graphkin.marking.rewrite import Rewrite
from graphkin.model.quantities import Quantity
from graphkin.planning import Method

_MOST = 6000
"""Pairs beyond so many are not tried: among so many, chance hits outweigh hints."""


def pairs_of(method: Method, plot: Plot, key: Key, quantities: Sequence[Quantity]) -> Hypotheses:
    """What pairs of mistakes give. Each of two scatters as much as the one that scatters more, in proportion."""
    found = {one.name: one for one in rewrites(method, plot, quantities, key.marking.scales)}
    rows = {row[0]: k for k, row in enumerate(key.singles.names) if row[0] in found}
    both = list(_pairs([found[name] for name in rows]))[:_MOST]
    if not both:
        return Hypotheses((), np.empty((0, len(quantities))), np.empty((0, len(quantities))))
    values = combined(method, plot, quantities, both).values
    one, other = (np.array([rows[pair[k].name] for pair in both]) for k in (0, 1))
    scatters = np.fmax(_scaled(key, one, values), _scaled(key, other, values))
    return Hypotheses(tuple((one.name, other.name) for one, other in both), values, scatters)


def _pairs(single: Sequence[Rewrite]) -> Iterator[tuple[Rewrite, Rewrite]]:
    """Those made at different places; what was drawn right and written otherwise only beside what was drawn wrong."""
    drawn = [rewrite for rewrite in single if rewrite.edits]
    written = [rewrite for rewrite in single if not rewrite.edits]
    for k, one in enumerate(drawn):
        places = {edit.spot for edit in one.edits}
        yield from ((one, other) for other in drawn[k + 1 :] if places.isdisjoint(edit.spot for edit in other.edits))
    yield from ((one, other) for one in drawn for other in written)


def _scaled(key: Key, rows: np.ndarray, values: np.ndarray) -> np.ndarray:
    """The scatter of single mistakes, larger where the pair's values are."""
    single, scatter = key.singles.values[rows], key.singles.scatters[rows]
    with np.errstate(divide="ignore", invalid="ignore"):
        larger = np.abs(values) / np.abs(single)
    return np.where(np.isfinite(values), scatter * np.where(np.isfinite(larger), np.maximum(larger, 1.0), 1.0), np.nan)
