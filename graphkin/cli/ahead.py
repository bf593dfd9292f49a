"""Mechanisms of a command that are read and solved ahead of their turn, so that those of one topology go together."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from graphkin.errors import GraphkinError

if TYPE_CHECKING:
    from graphkin.agreement import Proved
    from graphkin.mechanism import Mechanism
    from graphkin.planning import Method

BATCH = 256
"""So many files are read ahead."""


class SolvedAhead:
    """What is known of each source when its turn comes. Nothing is said or refused before that."""

    def __init__(self, sources: Sequence[str]) -> None:
        self._left = [source for source in sources if source not in ("", "-")] if len(sources) > 1 else []
        self._known: dict[str, tuple[Mechanism, tuple[Method, Proved] | None]] = {}

    def of(self, source: str) -> tuple[Mechanism | None, tuple[Method, Proved] | None]:
        """The mechanism, None where it is still to be read; its method and both roads, None where it goes alone."""
        if source not in self._known and source in self._left[:BATCH]:
            some, self._left = self._left[:BATCH], self._left[BATCH:]
            self._known = dict(_solved(some))
        return self._known.get(source, (None, None))


def _solved(sources: Sequence[str]) -> list[tuple[str, tuple[Mechanism, tuple[Method, Proved] | None]]]:
    from graphkin import api
    from graphkin.alike import proved_together

    read: dict[str, Mechanism] = {}
    for source in sources:
        try:
            read[source] = api.load(source)
        except (GraphkinError, OSError):  # refused when its turn comes
            continue
    return list(zip(read, zip(read.values(), proved_together([*read.values()]), strict=True), strict=True))
