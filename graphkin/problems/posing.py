"""The problems of a template's draws, solved ahead of their turn: those of several students together.

What numbers a draw has is known beforehand, and all draws of a template are of one topology.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from graphkin.agreement import Proved
from graphkin.alike import proved_together
from graphkin.errors import GraphkinError
from graphkin.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.problems.posed import Posed, Refused, well_posed
from graphkin.problems.template import Template

Numbers = tuple[int, ...]
_Known = tuple[Mechanism | GraphkinError, tuple[Method, Proved] | None]
AHEAD = 24
"""Draws that are solved together."""


class Posing:
    """Problems by their numbers; `likely` gives those that will be asked for, in about that order.

    refused  numbers that are no good problem, and why: of few variants each is drawn many times
    """

    def __init__(self, template: Template, likely: Iterable[Numbers]) -> None:
        self._template, self._likely = template, iter(likely)
        self._known: dict[Numbers, _Known] = {}
        self.refused: dict[Numbers, Refused] = {}

    def of(self, numbers: Numbers) -> tuple[Mechanism, Posed | Refused]:
        """The mechanism and its problem, or what is against it. Raises what reading and solving raise."""
        if numbers not in self._known:
            kept = list(self._known.items())[-AHEAD:]
            self._known = {**dict(kept), **dict(self._solved([numbers, *self._next()]))}
        read, together = self._known.pop(numbers)
        if isinstance(read, GraphkinError):
            raise read
        return read, well_posed(read, together)

    def _next(self) -> Iterator[Numbers]:
        """The next few that are not known already."""
        for numbers, _ in zip(self._likely, range(AHEAD - 1), strict=False):
            if numbers not in self._known:
                yield numbers

    def _solved(self, some: list[Numbers]) -> Iterator[tuple[Numbers, _Known]]:
        read = {numbers: self._read(numbers) for numbers in some}
        ready = {numbers: each for numbers, each in read.items() if isinstance(each, Mechanism)}
        together = dict(zip(ready, proved_together([*ready.values()]), strict=True))
        yield from ((numbers, (each, together.get(numbers))) for numbers, each in read.items())

    def _read(self, numbers: Numbers) -> Mechanism | GraphkinError:
        try:
            return self._template.mechanism(numbers)
        except GraphkinError as error:
            return error
