"""Value classes: dataclasses of the standard library that share their methods and are declared at their first use.

`dataclasses` writes and compiles six methods for each frozen class, in half a millisecond. graphkin has some hundred
such classes, most of which a command never fills, and `graphkin draw` is to start about as fast as its imports.
`dataclasses.fields`, `dataclasses.replace` and pattern matching work as with any dataclass.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from operator import attrgetter
from threading import RLock
from typing import Any, TypeVar, dataclass_transform

__all__ = ["Lazy", "bulky", "filled", "frozen"]

_T = TypeVar("_T")
Data = Callable[[object], object]
Fill = Callable[..., None]
_ONE_THREAD = RLock()


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[_T]) -> type[_T]:
    """Like `dataclass(frozen=True)`; a class may have a `__repr__` of its own."""
    for name, method in {"__setattr__": _refuse, "__delattr__": _refuse, "__repr__": _text}.items():
        if name != "__repr__" or name not in vars(cls):
            setattr(cls, name, method)
    setattr(cls, "__dataclass_fields__", _Undeclared(cls, _compare))  # noqa: B010
    return cls


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def bulky(cls: type[_T]) -> type[_T]:
    """Like `frozen`, for what is long: its `repr` is as much as one line holds."""
    setattr(cls, "__repr__", _one_line)  # noqa: B010
    return frozen(cls)


@dataclass_transform(eq_default=False, field_specifiers=(field,))
def filled(cls: type[_T]) -> type[_T]:
    """Like `dataclass(eq=False)`: an `__init__` that fills the fields, and nothing else of a dataclass."""
    setattr(cls, "__dataclass_fields__", _Undeclared(cls))  # noqa: B010
    return cls


class Lazy(Mapping[str, _T]):
    """A table with known names, each entry of which is made when it is first read."""

    def __init__(self, names: Iterable[str], make: Callable[[str], _T]) -> None:
        self._made: dict[str, _T | None] = dict.fromkeys(names)
        self._make = make

    def __getitem__(self, name: str) -> _T:
        entry = self._made[name]
        if entry is None:
            entry = self._made[name] = self._make(name)
        return entry

    def __contains__(self, name: object) -> bool:
        return name in self._made

    def __reduce__(self) -> tuple[type, tuple[dict[str, _T]]]:
        """Sent elsewhere it is a plain table."""
        return dict, (dict(self),)

    def __iter__(self) -> Iterator[str]:
        return iter(self._made)

    def __len__(self) -> int:
        return len(self._made)


class _Undeclared:
    """Stands for the fields of a class until `dataclasses` reads them."""

    def __init__(self, cls: type, complete: Callable[[type, Data], None] = lambda cls, data: None) -> None:
        self._cls = cls

        def first(value: object, /, *args: object, **named: object) -> None:
            with _ONE_THREAD:
                if vars(cls)["__init__"] is first:
                    entries = _entries(cls)
                    complete(cls, attrgetter(*entries) if entries else lambda value: ())
                    setattr(cls, "__init__", _filler(cls, entries))  # noqa: B010
            vars(cls)["__init__"](value, *args, **named)

        setattr(cls, "__init__", first)  # noqa: B010

    def __get__(self, value: object, cls: type) -> dict[str, Field[object]]:
        with _ONE_THREAD:
            if vars(self._cls).get("__dataclass_fields__") is self:
                delattr(self._cls, "__dataclass_fields__")
                dataclass(init=False, repr=False, eq=False)(self._cls)
        return {each.name: each for each in fields(self._cls)}


def _entries(cls: type) -> dict[str, object]:
    """The fields of a class, those of its bases first: a default, or a `Field` with one, or MISSING."""
    entries, declared = dict[str, object](), vars(cls).get("__dataclass_fields__")
    if isinstance(declared, dict):
        return {each.name: each for each in fields(cls)}
    for base in cls.__bases__[::-1]:
        entries |= _entries(base)
    if declared is not None:
        kinds = vars(cls).get("__annotations__", {})
        entries |= {name: getattr(cls, name, MISSING) for name in kinds if "ClassVar" not in str(kinds[name])}
        setattr(cls, "__match_args__", (*entries,))  # noqa: B010
    return entries


def _compare(cls: type, data: Data) -> None:
    """Values of a class are equal when their data are."""

    def equal(self: object, other: object) -> bool:
        return bool(data(self) == data(other)) if other.__class__ is self.__class__ else NotImplemented

    setattr(cls, "__eq__", equal)  # noqa: B010
    setattr(cls, "__hash__", lambda self: hash(data(self)))  # noqa: B010


def _filler(cls: Any, entries: Mapping[str, object]) -> Fill:
    """`__init__` by place or by name, with defaults for the rest."""
    names = tuple(entries)
    values = {name: each.default if isinstance(each, Field) else each for name, each in entries.items()}
    defaults = {name: value for name, value in values.items() if value is not MISSING}
    makers = {name: each.default_factory for name, each in entries.items()
              if isinstance(each, Field) and each.default_factory is not MISSING}  # fmt: skip
    filled, whole = {*defaults, *makers}, len(names)
    post: Fill | None = getattr(cls, "__post_init__", None)
    rests: dict[tuple[object, ...], dict[str, object]] = {}
    """By how many values are given by place, and which by name: the defaults of all others."""

    def left(count: int, named: Iterable[str]) -> dict[str, object]:
        given = [*names[:count], *named]
        others = entries.keys() - given
        if count > len(names) or len({*given}) < len(given) or not {*given} <= entries.keys() or others - filled:
            raise TypeError(f"{cls.__name__} wants {', '.join(names)}; given: {count} by place, {[*named]}")
        return {name: defaults[name] for name in names if name in others and name in defaults}

    def fill(self: object, /, *args: object, **named: object) -> None:
        data = self.__dict__
        if not named and len(args) == whole:
            data.update(zip(names, args))
        else:
            key = len(args), *named
            if (rest := rests.get(key)) is None:
                rest = rests[key] = left(len(args), named)
            data.update(zip(names, args), **named)
            data.update(rest)
            if makers:
                data.update((name, make()) for name, make in makers.items() if name not in data)
        if post is not None:
            post(self)

    return fill


def _text(self: Any) -> str:
    return f"{type(self).__name__}({', '.join(f'{each.name}={getattr(self, each.name)!r}' for each in fields(self))})"


def _one_line(self: object) -> str:
    text = " ".join(_text(self).split())
    return text if len(text) < 160 else f"{text[:150]} ..)"


def _refuse(self: object, name: str, *_: object) -> None:
    raise FrozenInstanceError(f"{type(self).__name__}.{name} cannot be changed")
