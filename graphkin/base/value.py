"""Value classes: dataclasses of the standard library that share their methods and are declared at their first use.

`dataclasses` writes and compiles six methods for each frozen class, in half a millisecond. graphkin has some hundred
such classes, most of which a command never fills, and `graphkin draw` is to start about as fast as its imports.
`dataclasses.fields`, `dataclasses.replace` and pattern matching work as with any dataclass.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import MISSING, Field, FrozenInstanceError, field, fields, make_dataclass
from functools import cache
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
    """Stands for the fields of a class until they are read; the first value declares the rest."""

    def __init__(self, cls: type, complete: Callable[[type, Data], None] = lambda cls, data: None) -> None:
        self._cls = cls

        def first(value: object, /, *args: object, **named: object) -> None:
            with _ONE_THREAD:
                if vars(cls)["__init__"] is first:
                    entries = _entries(cls)
                    complete(cls, attrgetter(*entries) if entries else lambda value: ())
                    setattr(cls, "__match_args__", tuple(entries))  # noqa: B010
                    setattr(cls, "__init__", _filler(cls, entries))  # noqa: B010
            vars(cls)["__init__"](value, *args, **named)

        setattr(cls, "__init__", first)  # noqa: B010

    def __get__(self, value: object, cls: type) -> dict[str, Field[object]]:
        specs = [(name, kind, *default) for name, (kind, *default) in _entries(self._cls).items()]
        twin = make_dataclass("Fields", specs, namespace={"__doc__": "The same"}, init=False, repr=False, eq=False)
        for name in ("__dataclass_params__", "__dataclass_fields__"):
            setattr(self._cls, name, vars(twin)[name])
        return {each.name: each for each in fields(twin)}


@cache
def _entries(cls: type) -> dict[str, tuple[Any, ...]]:
    """By name the type of each field, and its default, or the `Field` that has it, which no class keeps."""
    own = {name: kind for name, kind in vars(cls).get("__annotations__", {}).items() if "ClassVar" not in kind}
    entries = {name: (kind, *([vars(cls)[name]] if name in vars(cls) else [])) for name, kind in own.items()}
    for name in (name for name, entry in entries.items() if isinstance(entry[-1], Field)):
        delattr(cls, name)
    bases = (base for base in cls.__mro__[1:] if "__dataclass_fields__" in vars(base))
    return next((_entries(base) for base in bases), {}) | entries


def _compare(cls: type, data: Data) -> None:
    """Values of a class are equal when their data are."""

    def equal(self: object, other: object) -> bool:
        return bool(data(self) == data(other)) if other.__class__ is self.__class__ else NotImplemented

    setattr(cls, "__eq__", equal)  # noqa: B010
    setattr(cls, "__hash__", lambda self: hash(data(self)))  # noqa: B010


def _filler(cls: type, entries: Mapping[str, tuple[Any, ...]]) -> Fill:
    """`__init__` by place or by name, with defaults for the rest."""
    names, plain = tuple(entries), {name: default for name, (_, *rest) in entries.items() for default in rest}
    own = {name: plain.pop(name) for name in names if isinstance(plain.get(name), Field)}
    makers = {name: each.default_factory for name, each in own.items() if each.default_factory is not MISSING}
    defaults = plain | {name: each.default for name, each in own.items() if each.default is not MISSING}
    post: Fill | None = getattr(cls, "__post_init__", None)
    rests: dict[tuple[object, ...], dict[str, object]] = {}
    """By how many values are given by place, and which by name: the defaults of all others."""

    def left(count: int, named: Iterable[str]) -> dict[str, object]:
        given = [*names[:count], *named]
        others = entries.keys() - given
        if count > len(names) or len({*given}) < len(given) or {*given} - {*names} or others - {*defaults, *makers}:
            raise TypeError(f"{cls.__name__} wants {', '.join(names)}; given: {count} by place, {[*named]}")
        return {name: default for name, default in defaults.items() if name in others}

    def fill(self: object, /, *args: object, **named: object) -> None:
        data, key = self.__dict__, (len(args), *named)
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
