"""Value classes: dataclasses that share their methods, so that a class costs next to nothing at start-up.

`dataclasses` writes and compiles six methods for each frozen class, in half a millisecond. graphkin has some
hundred such classes, and `graphkin draw` is to start about as fast as its imports. `dataclasses.fields`,
`dataclasses.replace` and pattern matching work as with any dataclass.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from operator import attrgetter
from typing import Any, TypeVar, dataclass_transform

__all__ = ["Lazy", "filled", "frozen"]

_T = TypeVar("_T")


@dataclass(init=False, repr=False, eq=False)
class _Sample:
    """A class as `dataclasses` declares it."""

    entry: int


_FIELDS, _HOW = "__dataclass_fields__", "__dataclass_params__"
_OFTEN = 200
"""A class that is filled so many times in a run has its own `__init__` written: three times as fast, and worth half a
millisecond."""
_PLAIN = getattr(fields(_Sample)[0], "_field_type")  # noqa: B009


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(cls: type[_T]) -> type[_T]:
    """Like `dataclass(frozen=True)`; a class may write itself in a way of its own."""
    names = getattr(filled(cls), "__match_args__")  # noqa: B009
    data = attrgetter(*names) if names else lambda value: ()
    methods = {"__eq__": _equal(data), "__hash__": _hashed(data), "__repr__": _written}
    if "__repr__" in vars(cls):
        del methods["__repr__"]
    for name, method in (methods | {"__setattr__": _refused, "__delattr__": _refused}).items():
        setattr(cls, name, method)
    return cls


@dataclass_transform(eq_default=False, field_specifiers=(field,))
def filled(cls: type[_T]) -> type[_T]:
    """Like `dataclass(eq=False)`: an `__init__` that fills the fields, and nothing else of a dataclass."""
    _declare(cls)
    setattr(cls, "__init__", _filling(cls))  # noqa: B010
    return cls


class Lazy(Mapping[str, _T]):
    """A table with known names, each entry of which is made when it is first read."""

    def __init__(self, names: Iterable[str], make: Callable[[str], _T]) -> None:
        self._made: dict[str, _T | None] = dict.fromkeys(names)
        self._make = make

    def __getitem__(self, name: str) -> _T:
        found = self._made[name]
        if found is None:
            found = self._made[name] = self._make(name)
        return found

    def __contains__(self, name: object) -> bool:
        return name in self._made

    def __reduce__(self) -> tuple[type, tuple[dict[str, _T]]]:
        """Sent elsewhere it is a plain table."""
        return dict, (dict(self),)

    def __iter__(self) -> Iterator[str]:
        return iter(self._made)

    def __len__(self) -> int:
        return len(self._made)


def _declare(cls: Any) -> None:
    """What `dataclasses` reads of a class: its fields, those it inherits first. Annotations are texts, and stay so."""
    found = {name: each for base in reversed(cls.__mro__[1:]) for name, each in vars(base).get(_FIELDS, {}).items()}
    for name, kind in vars(cls).get("__annotations__", {}).items():
        if kind.startswith("ClassVar"):
            continue
        given = vars(cls).get(name, MISSING)
        entry: Any = given if isinstance(given, Field) else field(default=given)
        entry.name, entry.type, entry._field_type = name, kind, _PLAIN
        entry.kw_only = False
        found[name] = entry
        if entry.default is not MISSING:
            setattr(cls, name, entry.default)
        elif isinstance(given, Field):
            delattr(cls, name)
    setattr(cls, _FIELDS, found)
    setattr(cls, _HOW, getattr(_Sample, _HOW))
    setattr(cls, "__match_args__", tuple(found))  # noqa: B010


def _filling(cls: Any) -> Callable[..., None]:
    """`__init__(self, ..)`, which is made when the first one is filled: most classes of a run never are."""

    def first(self: Any, *args: Any, **given: Any) -> None:
        fill = _filler(cls)
        _replace(cls, first, fill)
        fill(self, *args, **given)

    return first


def _replace(cls: Any, fill: Callable[..., None], other: Callable[..., None]) -> None:
    """A way to fill instead of one, where the class has not been given its own meanwhile."""
    if vars(cls).get("__init__") is fill:
        cls.__init__ = other


def _filler(cls: Any) -> Callable[..., None]:
    """Values by place or by name, defaults for the rest. A class that is filled often gets a way of its own."""
    names = tuple(cls.__match_args__)
    known = frozenset(names)
    entries = getattr(cls, _FIELDS)
    defaults = {name: entry.default for name, entry in entries.items() if entry.default is not MISSING}
    makers = {name: entry.default_factory for name, entry in entries.items() if entry.default_factory is not MISSING}
    post = getattr(cls, "__post_init__", None)
    rests: dict[int, dict[str, Any] | None] = {}
    """What a number of values by place leaves to the defaults, where it may."""
    count = 0

    def left(given: int) -> dict[str, Any] | None:
        """Reckoned once for each number."""
        most = given <= len(names) and all(name in defaults for name in names[given:])
        rests[given] = {name: defaults[name] for name in names[given:]} if most else None
        return rests[given]

    def fill(self: Any, *args: Any, **given: Any) -> None:
        nonlocal count
        count += 1
        if count == _OFTEN and (own := _own_filler(cls, defaults, makers)):
            _replace(cls, fill, own)
        data = self.__dict__
        number = len(args)
        rest = None if given else rests[number] if number in rests else left(number)
        if rest is not None:
            data.update(zip(names, args))
            if rest:
                data.update(rest)
        else:
            fill_by_name(data, args, given)
        if post is not None:
            post(self)

    def fill_by_name(data: dict[str, Any], args: tuple[Any, ...], given: dict[str, Any]) -> None:
        data.update(defaults)
        data.update(zip(names, args), **given)
        if makers:
            data.update((name, make()) for name, make in makers.items() if name not in data)
        if data.keys() != known or len(args) > len(names) or not given.keys().isdisjoint(names[: len(args)]):
            raise TypeError(f"{cls.__name__} wants {', '.join(names)}; given: {len(args)} by place, {[*given]}")

    return fill


def _own_filler(cls: Any, defaults: Mapping[str, Any], makers: Mapping[str, Any]) -> Callable[..., None] | None:
    """`__init__(self, name, x=..)`, as `dataclasses` would write it; none where what is needed stands last."""
    names = cls.__match_args__
    free = [name in defaults or name in makers for name in names]
    if free != sorted(free):
        return None
    known: dict[str, Any] = {f"_{k}": defaults.get(name, makers.get(name)) for k, name in enumerate(names)}
    given = [f"{name}=_{k}" if free[k] else name for k, name in enumerate(names)]
    filled = [
        f" _data[{name!r}] = " + (f"_{k}() if {name} is _{k} else {name}" if name in makers else name)
        for k, name in enumerate(names)
    ]
    last = [" _self.__post_init__()"] if hasattr(cls, "__post_init__") else []
    lines = [f"def __init__({', '.join(['_self', *given])}):", " _data = _self.__dict__", *filled, *last]
    exec("\n".join(lines), known)
    made: Callable[..., None] = known["__init__"]
    made.__qualname__ = f"{cls.__qualname__}.__init__"
    return made


def _equal(data: Callable[[Any], Any]) -> Callable[[Any, object], bool]:
    return lambda self, other: data(self) == data(other) if other.__class__ is self.__class__ else NotImplemented


def _hashed(data: Callable[[Any], Any]) -> Callable[[Any], int]:
    return lambda self: hash(data(self))


def _written(self: Any) -> str:
    data = ", ".join(f"{field.name}={getattr(self, field.name)!r}" for field in fields(self))
    return f"{type(self).__name__}({data})"


def _refused(self: Any, name: str, *_: object) -> None:
    raise FrozenInstanceError(f"{type(self).__name__}.{name} cannot be changed")
