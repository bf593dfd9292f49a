"""Slips of a pencil: normal, drawn once for everything that is drawn, the same again from the same seed."""

from __future__ import annotations

from collections.abc import Callable
from zlib import crc32

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.model.mechanism import Mechanism


@frozen
class Mark:
    """One thing that a pencil or a ruler does: where a slip may be.

    plane, what   the plane, and the kind: "point", "link", "guide", "driver", "arrow", "line", "image", "reading"
    of            what it is done to, as the plane names it
    """

    plane: Plane
    what: str
    of: tuple[str, ...]


class Slips:
    """The errors of one pencil in `count` drawings: standard normal, (count,) for each mark.

    A mark's errors hang on the seed and on the mark alone, so that two drawings in which something else differs are
    made by one and the same hand. `allowed` says which marks have any; `seen` are those that were asked for.
    """

    def __init__(self, seed: int, count: int, allowed: Callable[[Mark], bool] | None = None) -> None:
        self.seed, self.count, self.allowed = seed, count, allowed
        self.seen: dict[Mark, None] = {}
        self._drawn = count
        self._kept: np.ndarray | slice = slice(None)

    def more(self, count: int) -> Slips:
        """The same pencil, which goes on to more drawings."""
        return Slips(self.seed, count, self.allowed)

    def only(self, kept: np.ndarray) -> Slips:
        """Some of its drawings (numbers,), the others thrown away."""
        one = self.more(self.count)
        one.count, one._kept, one._drawn = len(kept), kept, self._drawn
        return one

    def of(self, mark: Mark, which: int = 0) -> np.ndarray | float:
        """The errors of a mark in units of the pencil's; `which` tells several of one mark apart."""
        self.seen[mark] = None
        if self.allowed is not None and not self.allowed(mark):
            return 0.0
        number = crc32(repr((mark.plane, mark.what, mark.of, which)).encode())
        drawn: np.ndarray = np.random.default_rng([self.seed, number]).standard_normal(self._drawn)[self._kept]
        return drawn


def seed_of(mechanism: Mechanism) -> int:
    """A number that hangs on what the mechanism is."""
    written = mechanism.text or repr((mechanism.name, mechanism.links, mechanism.drivers))
    return crc32(written.encode())
