"""The instant centres of a mechanism, at one position or at many."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import cached_property

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.construction.drafting import Board
from graphkin.planning import Method
from graphkin.studies.centres.search import Centring, centre_name, search


@frozen
class Centres:
    """Instant centres: how they are found, the plot they are found over, and the board that holds them."""

    method: Method
    centring: Centring
    plot: Plot
    board: Board

    @property
    def names(self) -> list[str]:
        """By the numbers of their links."""
        return [name for pair in self.pairs for name in [self.name(*pair)] if name in self.centring.links]

    @cached_property
    def pairs(self) -> tuple[tuple[str, str], ...]:
        """Every two links, N(N-1)/2 of them (3-5)."""
        return tuple(sorted(self._all_pairs(), key=self._numbers))

    def _all_pairs(self) -> Iterator[tuple[str, str]]:
        yield from self.centring.links.values()
        yield from self.centring.together

    def _numbers(self, pair: tuple[str, str]) -> tuple[object, ...]:
        called = [self.method.mechanism.called(link) for link in pair]
        return tuple((0, int(name), "") if name.isdecimal() else (1, 0, name) for name in called)

    def name(self, first: str, second: str) -> str:
        return centre_name(self.method.mechanism, first, second)

    def place(self, first: str, second: str) -> Value:
        """Where the centre of two links is [m]; infinite at infinity, NaN where they do not move against each other."""
        return complex(np.nan, np.nan) if self.together(first, second) else self.board.at(self.name(first, second))

    def finite(self, first: str, second: str) -> complex | None:
        """The same; None at infinity, and where there is none."""
        place = complex(self.place(first, second))
        return place if cmath.isfinite(place) else None

    def together(self, first: str, second: str) -> bool:
        """Whether two links do not move against each other, and so have no centre."""
        return self.name(first, second) not in self.board.points

    def direction(self, first: str, second: str) -> Value:
        """Where a centre at infinity lies [rad]."""
        return self.board.direction(self.name(first, second))


def centres(method: Method, plot: Plot) -> Centres:
    """The instant centres at the position of a plot in which all three planes are drawn."""
    centring, plot, board = search(method, plot)
    return Centres(method, centring, plot, board)
