"""Which mistakes the answers to a problem tell apart, as far as paper allows; no student is drawn up for it.

Mistakes of one kind count as one wherever they are made: to tell them apart helps nobody.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.consequences import SAME, combined, rewrites
from graphkin.marking.key import KeyEntry, Marking, Name
from graphkin.marking.making import asked_alone
from graphkin.marking.verdicts import Columns, columns, columns_of, differences, upright
from graphkin.planning import Method


@frozen
class Telling:
    """What the answers to one problem tell of its mistakes.

    right, tolerance  of the answers (n,)
    names   of the mistakes that say anything of an answer (m,)
    seen    whether one puts an answer beyond its tolerance (m,)
    still   whether one leaves all answers as they are (m,)
    near    which two of different kinds that are seen lie within the tolerance in all answers (m, m)
    same    which two of different kinds give the very same answers (m, m)
    failed  part of the drawings with a pencil whose links do not meet
    """

    right: np.ndarray
    tolerance: np.ndarray
    names: tuple[Name, ...]
    seen: np.ndarray
    still: np.ndarray
    near: np.ndarray
    same: np.ndarray
    failed: float = 0.0


def telling(method: Method, plot: Plot, marking: Marking) -> Telling:
    """By what a mechanism asks for, at the position of a plot."""
    quantities, entries, failed = asked_alone(method, plot, marking)
    found = rewrites(method, plot, quantities, marking.scales)
    values = combined(method, plot, quantities, [(one,) for one in found]).values
    return replace(compared(entries, [one.name for one in found], values), failed=failed)


def compared(entries: Sequence[KeyEntry], names: Sequence[Name], values: np.ndarray) -> Telling:
    """What mistakes give for answers: values (mistakes, answers), NaN where one says nothing of an answer."""
    table = columns(entries)
    rows: list[int] = np.flatnonzero(np.isfinite(values).any(axis=1)).tolist()
    values = upright(table, values[rows])
    with np.errstate(invalid="ignore"):
        off = np.abs(differences(table, values, table.right))
        seen = (off > table.tolerance).any(axis=1)
        still = ~(off > SAME * np.maximum(np.abs(table.right), table.tolerance)).any(axis=1)
    near, same = _rivals(table, values)
    kinds = np.array([names[row][0] for row in rows])
    others = kinds[:, None] != kinds
    kept = tuple(names[row] for row in rows)
    return Telling(table.right, table.tolerance, kept, seen, still, near & others & seen[:, None] & seen, same & others)


def _rivals(table: Columns, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which two rows are within the tolerance, and which are equal; of what one does not judge it says nothing.

    A value that is larger than the right one may be off by as much more.
    """
    near, same = (np.ones((len(values), len(values)), dtype=bool) for _ in range(2))
    with np.errstate(divide="ignore", invalid="ignore"):
        times = np.nan_to_num(np.abs(values) / np.abs(table.right), nan=1.0, posinf=1.0)
        reach = np.where(table.angle, table.tolerance, table.tolerance * np.maximum(times, 1.0))
        for k in range(values.shape[1]):
            one, value = columns_of(table, np.arange(len(table.right)) == k), values[:, k : k + 1]
            off = np.abs(differences(one, value[:, None], value))[..., 0]
            near &= ~(off > np.maximum(reach[:, None, k], reach[:, k]))
            larger = np.maximum(np.abs(value), np.abs(value[:, 0]))
            same &= ~(off > SAME * np.maximum(larger, one.tolerance))
    return near, same
