"""The power to tell mistakes apart: students drawn up who make one, with a pencil that errs, and are diagnosed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.base.value import bulky, frozen
from graphkin.marking.consequences import rewrites
from graphkin.marking.diagnosis import Explainer
from graphkin.marking.discriminability import Observed, observed
from graphkin.marking.key import Name
from graphkin.marking.marker import Marker
from graphkin.marking.pencil import Slips, seed_of
from graphkin.marking.rewrite import Rewrite
from graphkin.marking.tolerances import Drawings, pencil_of
from graphkin.marking.weights import MOVED, ONE, shifts

_Parts = tuple[Observed, float, float, float]
"""An observer's view of a mistake; part of its students who have a wrong value, are told of it, and of no other."""
_DIGITS = 4
_RIGHT = 2000  # students who work right: a mistake named to one of them is a false alarm
_AT_ONCE = 64  # mistakes whose students are drawn up at once


@frozen
class MistakePower:
    """The outcome for the students who make one mistake.

    moved        by how many standard deviations it moves a handed-in value, at most
    applicable   whether that is more than a pencil might
    observed     what an observer would make of it who knows this mistake alone; None where it is not applicable
    wrong        part of the students who have a value judged wrong
    named        part whose best explanation, or set of explanations, has this mistake; alone: and no other
    """

    name: Name
    moved: float
    applicable: bool
    observed: Observed | None = None
    wrong: float = np.nan
    named: float = np.nan
    alone: float = np.nan

    @property
    def tellable(self) -> bool:
        """True if paper can tell it: most students who make it hand in what tells them from others."""
        return self.observed is not None and self.observed.tellable


@bulky
class Power:
    """The power of a problem to tell mistakes.

    texts        what the students hand in
    alarms       part of right work by pencil that has a value judged wrong, and that gets a mistake
    random       part of random wrong numbers that gets a mistake
    """

    texts: tuple[str, ...]
    trials: int
    found: tuple[MistakePower, ...]
    alarms: tuple[float, float]
    random: float


def power(marker: Marker, trials: int = 200, texts: Sequence[str] | None = None) -> Power:
    """Students of every single mistake; `texts`: what they hand in, all of the key's quantities where left out."""
    handed = _handed(marker, texts)
    slips = Slips(seed_of(marker.method.mechanism) ^ 0x5EED, trials)  # others than the key's tolerances come from
    outcomes = tuple(_outcomes(marker, Drawings.of(marker.method, pencil_of(marker.key.marking), slips), handed))
    kept = tuple(entry.text for entry, there in zip(marker.key.entries, handed, strict=True) if there)
    # numbers of the right sizes or up to five times larger or smaller, of any sense
    rng = np.random.default_rng(seed_of(marker.method.mechanism) ^ 0xD1CE)
    shape = (2 * trials, len(handed))
    largest = np.maximum(np.abs(marker.table.right), 10 * marker.table.scatter)
    given = largest * 5.0 ** rng.uniform(-1, 1, shape) * rng.choice((-1.0, 1.0), shape)
    given = _printed(np.where(handed, np.where(marker.table.size, np.abs(given), given), np.nan))
    return Power(kept, trials, outcomes, alarms(marker, texts), _wrong_and_named(marker, given)[1])


def _outcomes(marker: Marker, drawings: Drawings, handed: np.ndarray) -> Iterator[MistakePower]:
    key, table = marker.key, marker.table
    scales = key.marking.scales
    known = {one.name: one for one in rewrites(marker.method, marker.plot, marker.quantities, scales)}
    moved = shifts(table, key.singles.values)
    moved[:, ~handed] = np.nan
    most = np.fmax.reduce(moved, axis=1, initial=0.0)
    rows = [row for row, names in enumerate(key.singles.names) if most[row] > MOVED and names[0] in known]
    judged, tried = handed & np.isfinite(key.singles.values), dict[int, _Parts]()
    for there in filter(np.any, np.unique(judged[rows], axis=0)):
        same = np.array([row for row in rows if (judged[row] == there).all()])
        explainer = Explainer(key, marker.table, there, key.singles, ONE, lambda: marker.other_methods)
        for some in np.split(same, range(_AT_ONCE, len(same), _AT_ONCE)):
            columns: list[tuple[Rewrite, ...]] = [(known[key.singles.names[row][0]],) for row in some]
            tried |= _tried(marker, explainer, there, some, _printed(drawings.values(marker.quantities, columns)))
    for row, names in enumerate(key.singles.names):
        yield MistakePower(names[0], float(most[row]), row in tried, *tried.get(row, ()))


def _tried(
    marker: Marker, explainer: Explainer, there: np.ndarray, rows: np.ndarray, given: np.ndarray
) -> dict[int, _Parts]:
    """Those who hand in the same quantities (rows, trials, quantities), by row; nothing where most drawings fail."""
    drawn = np.isfinite(given[..., there]).all(axis=2)  # students whose drawing fails hand in nothing
    most = 2 * drawn.sum(axis=1) >= given.shape[1]
    if not most.any():
        return {}
    rows, drawn = rows[most], drawn[most]
    given, of = np.where(there, given[most], np.nan)[drawn], np.nonzero(drawn)[0]
    key = marker.key
    known = explainer.names
    ids = np.array([names[0][0] for names in known], dtype=object)
    mine = np.array([[names == key.singles.names[row] for names in known] for row in rows])
    other = ids != np.array([key.singles.names[row][0][0] for row in rows], dtype=object)[:, None]
    _, wrong = marker.judged(given)
    same = np.concatenate([best.same for best in explainer.best(given, wrong)])
    named = (same & mine[of]).any(axis=1)
    each = wrong.any(axis=1), named, named & ~(same & other[of]).any(axis=1)
    count = drawn.sum(axis=1)
    parts = [(np.bincount(of, one, minlength=len(rows)) / count).tolist() for one in each]
    ideal = [
        observed(explainer, int(np.argmax(one)), given[of == k], lambda values: marker.judged(values)[1])
        for k, one in enumerate(mine)
    ]
    return dict(zip(rows.tolist(), zip(ideal, *parts, strict=True), strict=True))


def _handed(marker: Marker, texts: Sequence[str] | None) -> np.ndarray:
    """The key's quantities that are handed in, as booleans."""
    return np.array([texts is None or entry.text in texts for entry in marker.key.entries], dtype=bool)


def alarms(marker: Marker, texts: Sequence[str] | None = None) -> tuple[float, float]:
    """Right work by a pencil: part that has a value judged wrong, and that gets a mistake; `texts` as above."""
    handed = _handed(marker, texts)
    slips = Slips(seed_of(marker.method.mechanism) ^ 0xA1A, _RIGHT)
    drawn = Drawings.of(marker.method, pencil_of(marker.key.marking), slips).values(marker.quantities)[0]
    given = _printed(np.where(handed, drawn, np.nan)[np.isfinite(drawn[:, handed]).all(axis=1)])
    return _wrong_and_named(marker, given)


def _wrong_and_named(marker: Marker, given: np.ndarray) -> tuple[float, float]:
    """The part of some work that has a value judged wrong, and that gets a mistake."""
    _, wrong = marker.judged(given)
    named = [bool(one.explanations) for one in marker.diagnoses(given, wrong)]
    return float(wrong.any(axis=1).mean()), float(np.mean(named))


def _printed(values: np.ndarray) -> np.ndarray:
    """In four digits."""
    with np.errstate(divide="ignore", invalid="ignore"):
        power = np.floor(np.log10(np.abs(values)))
    step = 10.0 ** (np.where(np.isfinite(power), power, 0.0) - (_DIGITS - 1))
    return np.round(values / step) * step
