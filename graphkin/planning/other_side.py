"""A mechanism that cannot be put together, and could be with a wheel or a profile on the other side of its line."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphkin.errors import GraphkinError, OtherSide
from graphkin.model.mechanism import Mechanism
from graphkin.model.pairs import Cam, Pair, RollingContact
from graphkin.planning.planner import plan


def other_side(mechanism: Mechanism) -> OtherSide | None:
    """The error that names the first `side` whose opposite closes the mechanism."""
    for k, pair in enumerate(mechanism.pairs):
        for turned, path, left in _turned(pair):
            pairs = (*mechanism.pairs[:k], turned, *mechanism.pairs[k + 1 :])
            try:
                plan(replace(mechanism, pairs=pairs))
            except GraphkinError:
                continue
            return OtherSide(mechanism.where(*mechanism.path(pair), *path, "side"), "left" if left else "right")
    return None


def _turned(pair: Pair) -> Iterator[tuple[Pair, tuple[str | int, ...], bool]]:
    """The pair with one side changed, where in its table that side stands, and what it is then."""
    if isinstance(pair, RollingContact) and pair.line is not None:
        yield replace(pair, left=not pair.left), (), not pair.left
    if isinstance(pair, Cam):
        for n, face in enumerate(pair.profiles):
            if face.line is not None:
                faces = [replace(each, left=not each.left) if each is face else each for each in pair.profiles]
                yield replace(pair, profiles=(faces[0], faces[1])), ("profiles", n), not face.left
