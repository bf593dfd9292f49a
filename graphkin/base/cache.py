"""What was worked out of an object, kept for when it is asked for again.

Mechanisms, methods and paths are too large to be hashed. They cannot be changed, so one and the same object gives the
same again: it is told by its identity, and held as long as what is kept of it.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from typing import ParamSpec, TypeVar

__all__ = ["kept"]

_Asked = ParamSpec("_Asked")
_Found = TypeVar("_Found")


def kept(most: int, objects: int = 1) -> Callable[[Callable[_Asked, _Found]], Callable[_Asked, _Found]]:
    """A function of some objects first, then of small values, that keeps what it gave the last `most` times."""

    def keeping(make: Callable[_Asked, _Found]) -> Callable[_Asked, _Found]:
        found: dict[Hashable, tuple[object, _Found]] = {}

        @wraps(make)
        def get(*args: _Asked.args, **named: _Asked.kwargs) -> _Found:
            place = (*map(id, args[:objects]), *args[objects:], *sorted(named.items()))
            entry = found.pop(place, None) or (args[:objects], make(*args, **named))
            found[place] = entry
            if len(found) > most:
                for oldest in [*found][:-most]:
                    found.pop(oldest, None)
            return entry[1]

        return get

    return keeping
