"""A straight line fixed in a link: the path of a sliding pair, a rack, the flat face of a cam follower."""

from __future__ import annotations

from typing import Any

from graphkin.base.value import frozen


@frozen
class Line:
    """A directed line of `link`, through its point `origin`.

    origin     a point of the link; lines of the frame given by coordinates have a point of their own there, whose
               name starts with a small letter (`s0`, `r1`), so that no user's point can clash
    direction  unit complex number in the link's own axes
    named      whether people named the origin
    base       the two points from whose direction the file measures it, if from any
    """

    link: str
    origin: str
    direction: complex
    named: bool = True
    base: tuple[str, str] | None = None

    @property
    def on_axis(self) -> bool:
        """Whether it is its link's own axis, as the line of a link of one point where nothing else is said."""
        same: Any = self.direction == 1  # of many mechanisms at once, an array
        return same if isinstance(same, bool) else bool(same.all())
