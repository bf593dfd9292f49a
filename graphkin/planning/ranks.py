"""Rank of restraints: what follows from what, and the drawn position at which this is asked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.tolerances import CLOSED, RANK
from graphkin.planning.constraint_jacobian import Array, ConstraintRow, ConstraintRows, Restraints, settled

_STARTS = 12


def rank(slopes: Array) -> int:
    return int(np.linalg.matrix_rank(slopes, tol=RANK)) if slopes.size else 0


def open_by(rows: ConstraintRows) -> float:
    """The widest gap."""
    return float(np.max(np.abs(rows.open), initial=0.0))


def beside(rows: ConstraintRows, labels: Sequence[ConstraintRow]) -> float:
    """How far some equations are from following from the others, 0 to 1."""
    others, own = rows.without(labels).slopes, rows.only(labels)
    back = np.linalg.pinv(others, rcond=RANK) @ others
    return float(np.max(np.linalg.norm(own - own @ back, axis=1) / np.linalg.norm(own, axis=1)))


def drawn_place(restraints: Restraints, aside: Sequence[ConstraintRow] = ()) -> tuple[Array, ConstraintRows]:
    """The drawn position, as near to the sketch as it can be closed; nothing has rolled yet."""
    rng, best = np.random.default_rng(7), None
    for _ in range(_STARTS):
        q = restraints.sketched(rng)
        slips = [row for row in restraints.rows(q).labels if row.kind == "slip"]
        found = settled(restraints, q, [*slips, *aside])
        if best is None or np.sum(found[1].open**2) < np.sum(best[1].open**2):
            best = found
        if open_by(best[1]) < CLOSED:
            break
    assert best is not None
    return best
