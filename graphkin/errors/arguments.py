"""Arguments of public calls, held against what their annotations say, before anything is done with them."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import wraps
from numbers import Integral, Real
from os import PathLike
from reprlib import repr as shortened
from typing import ParamSpec, TypeVar, cast, get_args

from graphkin.errors.base import GraphkinError, Where
from graphkin.errors.files import NotOneOf, OutOfRange, WrongType

_Given = ParamSpec("_Given")
_Done = TypeVar("_Done")
_Fits = Callable[[object], bool]
_Wanted = tuple[list[_Fits], tuple[str, ...], tuple[str, ...]]  # what fits, what that is called, words
_ANY: _Wanted = ([], (), ())


def _finite(value: object) -> bool:
    try:
        return isinstance(value, Real) and math.isfinite(value)
    except OverflowError:  # a whole number beyond all floats
        return False


def _any(*kinds: type) -> _Fits:
    return lambda value: isinstance(value, kinds)


def _all(fits: _Fits, kind: type = Sequence) -> _Fits:
    def fit(value: object) -> bool:
        if not isinstance(value, Iterable) or not isinstance(value, kind) or isinstance(value, str | bytes):
            return False
        return getattr(value, "ndim", 1) > 0 and all(map(fits, value))  # NumPy's numbers are arrays, too

    return fit


def _called(name: str) -> _Fits:
    """By the name of its class: one that was never loaded nobody can have."""
    return lambda value: any(kind.__name__ == name for kind in type(value).__mro__)


_files = _all(_any(str, PathLike), Collection)

_PLAIN: dict[str, tuple[_Fits, str]] = {
    "None": (lambda value: value is None, "text"),
    "bool": (lambda value: type(value).__name__ == "bool", "flag"),  # NumPy's, too
    "int": (lambda value: isinstance(value, Integral) and not isinstance(value, bool) and int(value) >= 0,
            "count"),
    "float": (_finite, "number"),
    "str": (_any(str), "text"),
    "Path": (_any(PathLike), "file"),
    "Size": (lambda value: isinstance(value, str) or _finite(value), "quantity"),
    "Sequence[str]": (_all(_any(str)), "texts"),
    "Sequence[float]": (_all(_finite), "pencil"),
    "Sequence[Size]": (_all(lambda value: isinstance(value, str) or _finite(value)), "numbers"),
    "Sequence[str|Path]": (_files, "file"),
    "Iterable[str|Path]": (lambda value: isinstance(value, Iterator) or _files(value), "file"),
    "Iterable[int]": (_all(_any(Integral), Collection), "numbers"),
    "Executor": (lambda value: hasattr(value, "submit"), "executor"),
    "Key": (_called("Key"), "table"),
    "Limits": (_called("Limits"), "table"),
    "Photographs": (_called("Photographs"), "table"),
}
"""By annotation: whether a value is such a one, and what it is called. What is not here is looked at by its reader."""


@contextmanager
def in_python() -> Iterator[None]:
    """Errors name arguments, not the options of a command."""
    try:
        yield
    except GraphkinError as error:
        where = getattr(error, "where", None)
        if isinstance(where, Where) and where.file.startswith("--"):
            name = where.file[2:].replace("-", "_")
            raise error.at(Where("ranges" if name == "driver" else name)) from None
        raise


def checked(call: Callable[_Given, _Done]) -> Callable[_Given, _Done]:
    """The call, whose errors name its arguments. It raises WrongType for an argument that is no text, number, flag,
    file where one is wanted, and for None where that says nothing; OutOfRange for numbers that are none, NotOneOf for a
    word that is not among those of its Literal."""
    names: list[str] = []  # of the places
    wanted: dict[str, _Wanted] = {}

    @wraps(call)
    def looked_at(*args: _Given.args, **named: _Given.kwargs) -> _Done:
        if not wanted:
            wanted.update(_looked_for(call, names))
        places = names + names[-1:] * len(args)  # what is more belongs to the last, `*mechanisms`
        for name, value in (*zip(places, args), *named.items()):
            fits, kinds, words = wanted.get(name, _ANY)
            if fits and isinstance(value, Real) and not _finite(value):
                raise OutOfRange(Where(name), shortened(value))
            if fits and not any(each(value) for each in fits):
                if words and isinstance(value, str):
                    raise NotOneOf(Where(name), value, words)
                whole = isinstance(value, Integral) and "count" in kinds
                raise WrongType(Where(name), "count" if whole else kinds[0], shortened(value))
        with in_python():
            made = call(*args, **named)
        return cast(_Done, _one_by_one(made)) if isinstance(made, Generator) else made

    return looked_at


def _one_by_one(made: Iterator[object]) -> Iterator[object]:
    """Results that are made, and raise, while one asks for them."""
    with in_python():
        yield from made


def _looked_for(call: Callable[..., object], names: list[str]) -> dict[str, _Wanted]:
    """By the names of its parameters; `names` gets those that have a place."""
    from inspect import Parameter, signature

    parameters = signature(call).parameters.values()
    names += [each.name for each in parameters if each.kind is not Parameter.KEYWORD_ONLY]
    named = getattr(call, "__globals__", {})
    return {each.name: _wanted(str(each.annotation), named, each.default in (None, each.empty)) for each in parameters}


def _wanted(annotation: str, named: Mapping[str, object], free: bool) -> _Wanted:
    """Whatever may be given; nothing where anything may, as far as is known here; free: None, too."""
    parts = annotation.replace("str | Path]", "str|Path]").split(" | ")
    words = tuple(word for part in parts for word in get_args(named.get(part)) if isinstance(word, str))
    known = {part: _PLAIN.get(part, (lambda value: isinstance(value, str) and value in words, "text")) for part in parts if part in _PLAIN or words}
    if len(known) == len(parts):
        return [fits for fits, _ in known.values()], tuple(kind for _, kind in known.values()), words
    return _ANY if free else ([lambda value: value is not None], ("text",), ())
