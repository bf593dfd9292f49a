"""Results worked out of an object, kept for when they are asked for again.

Mechanisms, methods and paths are too large to be hashed. They cannot be changed, so one and the same object gives the
same again: it is told by its identity, and held as long as what is kept of it.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import wraps
from typing import ParamSpec, TypeVar

_Args = ParamSpec("_Args")
_Result = TypeVar("_Result")


def kept(most: int, objects: int = 1) -> Callable[[Callable[_Args, _Result]], Callable[_Args, _Result]]:
    """A function of some objects first, then of small values, that keeps what it gave the last `most` times."""

    def keeping(make: Callable[_Args, _Result]) -> Callable[_Args, _Result]:
        results: dict[Hashable, tuple[object, _Result]] = {}

        @wraps(make)
        def get(*args: _Args.args, **named: _Args.kwargs) -> _Result:
            place = (*map(id, args[:objects]), *args[objects:], *sorted(named.items()))
            entry = results.pop(place, None) or (args[:objects], make(*args, **named))
            results[place] = entry
            if len(results) > most:
                for oldest in [*results][:-most]:
                    results.pop(oldest, None)
            return entry[1]

        return get

    return keeping
