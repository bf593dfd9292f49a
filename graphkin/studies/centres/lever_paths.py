"""From which link to which a motion is carried on: over the fewest and best levers."""

from __future__ import annotations

import cmath
import heapq
from collections.abc import Callable, Collection
from functools import cache, cached_property
from math import inf, log10

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME
from graphkin.studies.centres.instant_centres import Centres


@frozen
class LeverPaths:
    """Instant centres as a net of levers. size: of the mechanism [m]"""

    found: Centres
    size: float

    def path(self, known: Collection[str], standing: Collection[str], target: str) -> list[str] | None:
        """The cheapest way to a link (Dijkstra); None where there is none.

        known     links that move, and whose motion is known; standing  links at rest, from which none is carried on
        """
        best, queue = dict.fromkeys(known, 0.0), [(0.0, link, [link]) for link in known]
        heapq.heapify(queue)
        while queue:
            cost, base, path = heapq.heappop(queue)
            if base == target:
                return path
            for link in self.found.method.mechanism.moving:
                total = inf if link in path or link in standing else cost + self._cost_once(base, link)
                if total < best.get(link, inf):
                    best[link] = total
                    heapq.heappush(queue, (total, link, [*path, link]))
        return None

    @cached_property
    def _cost_once(self) -> Callable[[str, str], float]:
        """By two links; reckoned once, as it is asked for on the way to every link."""
        return cache(self._cost)

    def _cost(self, base: str, link: str) -> float:
        """1 for a good lever, more for one that is very short or very long; infinite for none."""
        if self.found.together(base, link):
            return 1.0
        finite = self.found.finite
        own, other, common = finite(FRAME, base), finite(FRAME, link), finite(base, link)
        if common is None:
            both = (own is None) == (other is None)
            return (1.0 if own is not None else 5.0) if both and self._triangle_closes(own, base, link) else inf
        if other is None:
            return inf if own is None else 1.0 + self._badness(own, common)
        if abs(other - common) < 1e-4 * self.size:
            return inf
        return 1.0 + self._badness(other, common) + (self._badness(own, common) if own is not None else 0.0)

    def _triangle_closes(self, own: complex | None, base: str, link: str) -> bool:
        if own is not None:
            return True
        if self.found.together(FRAME, link):
            return False
        far, common = (float(self.found.direction(*two)) for two in ((FRAME, link), (base, link)))
        return abs(cmath.rect(1, far - common).imag) > 1e-3

    def _badness(self, first: complex, second: complex) -> float:
        off = max(abs(first - second) / self.size, 1e-9)
        return max(0.0, log10(0.1 / off)) + max(0.0, log10(off / 10))
