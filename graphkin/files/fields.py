"""The kinds of value a mechanism file has: quantities with units, names, places, points' triples, tables.

A kind says what a value must be twice: to pydantic's core, which checks whole files and collects what is
wrong, and to JSON Schema, which editors read. Complaints are graphkin's own errors. (The core alone is
imported: with pydantic's models around it, reading a file would take ten times as long as checking it.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, field, fields
from typing import Any, TypeVar, dataclass_transform

from pydantic_core import PydanticCustomError

from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, GraphkinError, NotOneOf, WrongType
from graphkin.files.names import LINK, POINT, SLIDE, tidy
from graphkin.files.units import Dimension
from graphkin.files.values import above_zero, formed, quantity, scale, shown, titles, triples, vector, zero_or_more

MEASURE_PATTERN = r"^([A-Z][0-9]*'*){2,3}$"
POINT_PATTERN = r"^[A-Z][0-9]*'*$"
Schema = dict[str, Any]
"""What a value must be, as pydantic's core reads it: `type`, and what belongs to that type."""
NUMBER: dict[str, Any] = {"type": ["number", "string"]}
"""What JSON Schema says of any quantity."""

_T = TypeVar("_T")


@frozen
class FieldKind:
    """What a value must be: for pydantic's core, and for JSON Schema; of what dimension, where it is a quantity."""

    core: Schema
    json: dict[str, Any]
    dimension: Dimension | None = None


# --- checking ---------------------------------------------------------------------------------


def _guarded(read: Callable[..., Any]) -> Callable[..., Any]:
    """The same reader, its complaint in the wrapping the core collects; `complaints` unwraps it."""

    def guarded(*value: Any) -> Any:
        try:
            return read(*value)
        except GraphkinError as problem:
            raise PydanticCustomError("graphkin", "graphkin", {"problem": problem}) from None

    return guarded


def _read(read: Callable[[Any], Any], json: dict[str, Any]) -> FieldKind:
    return FieldKind({"type": "function-plain", "function": {"type": "no-info", "function": _guarded(read)}}, json)


def _before(read: Callable[[Any], Any], inner: Schema) -> Schema:
    """The schema for what a reader makes of a value."""
    return {"type": "function-before", "function": {"type": "no-info", "function": _guarded(read)}, "schema": inner}


def _of_type(kind: str, wanted: type, inner: Schema) -> Schema:
    """The schema for values of one type; says `kind` otherwise."""

    def checked(value: object) -> object:
        if not isinstance(value, wanted):
            raise WrongType(NOWHERE, kind, shown(value))
        return value

    return _before(checked, inner)


def anything(json: dict[str, Any]) -> FieldKind:
    """A value that is looked at later."""
    return FieldKind({"type": "any"}, json)


# --- single values ----------------------------------------------------------------------------


def quantity_of(dimension: Dimension, check: Callable[[float], float] = float) -> FieldKind:
    """A number or a text with a unit."""
    read = _read(lambda value: check(quantity(value, dimension)), NUMBER)
    return FieldKind(read.core, read.json, dimension)


def _text(kind: str, read: Callable[[str], str] = tidy, **json: str) -> FieldKind:
    """A text; `kind` says in a message what is wanted."""

    def checked(value: object) -> str:
        if not isinstance(value, str):
            raise WrongType(NOWHERE, kind, shown(value))
        return read(value)

    return _read(checked, json or {"type": "string"})


def _also(value: object, info: Any) -> float:
    """A further value of what the driver drives: a length for a slide, else an angle."""
    return quantity(value, "length" if info.data.get("slide") else "angle")


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise WrongType(NOWHERE, "flag", shown(value))
    return value


def _side(value: str) -> str:
    if value not in ("left", "right"):
        raise NotOneOf(NOWHERE, shown(value), ("left", "right"))
    return value


LENGTH, ANGLE = quantity_of("length"), quantity_of("angle")
RADIUS, EDGE_RADIUS = quantity_of("length", above_zero), quantity_of("length", zero_or_more)
ALSO = FieldKind({"type": "function-plain", "function": {"type": "with-info", "function": _guarded(_also)}}, NUMBER)
SCALE = _read(scale, {"type": "number", "exclusiveMinimum": 0})
FLAG = _read(_flag, {"type": "boolean"})
TEXT = _text("text", lambda text: " ".join(text.split()))
NAME, NEW_NAME = _text("name"), _text("name", formed(SLIDE, "slide"))
LINK_KEY = _text("name", formed(LINK, "link"), pattern=r"^[\w']+$")
POINT_NAME = _text("name", formed(POINT, "point"), type="string", pattern=POINT_PATTERN)
VECTOR = _read(vector, {"type": "string", "pattern": r"^([A-Z][0-9]*'*){2}$"})
SIDE = _text("name", _side)
SIDE.json["enum"] = ["left", "right"]


# --- several values ---------------------------------------------------------------------------


def list_of(item: FieldKind, kind: str = "list", count: int | None = None) -> FieldKind:
    """A list of values, of any or of one certain length."""
    length = {} if count is None else {"min_length": count, "max_length": count}
    core = _of_type(kind, list, {"type": "list", "items_schema": item.core, **length})
    return FieldKind(core, {"type": "array", "items": item.json, **_counted(count)}, item.dimension)


def _counted(count: int | None) -> dict[str, Any]:
    return {} if count is None else {"minItems": count, "maxItems": count}


def two(item: FieldKind) -> FieldKind:
    """One value for each of two links."""
    return list_of(item, count=2)


def mapping(names: FieldKind, values: FieldKind) -> FieldKind:
    """A table whose keys are names themselves."""
    core = _of_type("table", dict, {"type": "dict", "keys_schema": names.core, "values_schema": values.core})
    return FieldKind(
        core, {"type": "object", "patternProperties": {names.json["pattern"]: values.json}}, values.dimension
    )


def _either(names: FieldKind, places: FieldKind) -> FieldKind:
    """A point's name, or a place."""
    core = {
        "type": "tagged-union",
        "choices": {"a point": names.core, "a place": places.core},
        "discriminator": lambda value: "a place" if isinstance(value, list) else "a point",
    }
    return FieldKind(core, {"oneOf": [names.json, places.json]})


def _triples() -> FieldKind:
    """One triple of points or several."""
    triple = list_of(POINT_NAME, "triple", 3)
    core = _before(triples, {"type": "list", "items_schema": triple.core})
    return FieldKind(core, {"type": "array", "items": {"anyOf": [POINT_NAME.json, triple.json]}})


PLACE = list_of(LENGTH, "place", 2)
ANCHOR = _either(_text("anchor", formed(POINT, "point"), **POINT_NAME.json), PLACE)
TRIPLES = _triples()


# --- tables -----------------------------------------------------------------------------------


def key(kind: FieldKind, *, default: Any = MISSING, default_factory: Any = MISSING) -> Any:
    """A key of a table; it may be left out where there is a default."""
    return field(default=default, default_factory=default_factory, metadata={"kind": kind})


def further(pattern: str, kind: FieldKind) -> Any:
    """All keys of a table that are not named, by a dictionary; an editor expects this pattern of them."""
    return field(default_factory=dict, metadata={"further": kind, "pattern": pattern})


@dataclass_transform(kw_only_default=True, frozen_default=True, field_specifiers=(key, further))
def table(cls: type[_T]) -> type[_T]:
    """A table made of `key`s; others are refused where there is no `further`. `from_` is the key `from`."""
    cls.__doc__ = cls.__doc__ or f"`{cls.__name__}`"
    made: Any = frozen(cls)
    rest = next((field for field in fields(made) if "further" in field.metadata), None)
    made.kind = FieldKind(_checking(made, rest), _object(made, rest))
    return cls


def kind_of(cls: Any) -> FieldKind:
    """The kind of value that becomes an instance of a table's class."""
    kind: FieldKind = cls.kind
    return kind


def keys(cls: Any) -> dict[str, Field[Any]]:
    """The fields of a table by the keys they have in the file."""
    return {field.name.rstrip("_"): field for field in fields(cls) if "kind" in field.metadata}


def one_table(cls: Any) -> FieldKind:
    """A value that is such a table."""
    return FieldKind(_of_type("table", dict, kind_of(cls).core), _reference(cls))


def tables(cls: Any) -> FieldKind:
    """`[[..]]`: any number of such tables."""
    return list_of(entry(cls), "tables")


def entry(cls: Any) -> FieldKind:
    """A table among others of its kind."""
    return FieldKind(kind_of(cls).core, _reference(cls))


def _reference(cls: Any) -> dict[str, Any]:
    return {"$ref": f"#/$defs/{cls.__name__}"}


def title(cls: Any) -> FieldKind:
    """A text, or such a table of one for each language."""
    core = _before(titles, kind_of(cls).core)
    return FieldKind(core, {"anyOf": [{"type": "string"}, kind_of(cls).json]})


def _required(field: Field[Any]) -> bool:
    return field.default is MISSING and field.default_factory is MISSING


def _checking(cls: Any, rest: Field[Any] | None) -> Schema:
    """What makes an instance of the class of a table that is right."""
    named = {
        field.name: {
            "type": "typed-dict-field", "schema": field.metadata["kind"].core, "required": _required(field),
            "validation_alias": name,
        }
        for name, field in keys(cls).items()
    }  # fmt: skip

    def make(data: dict[str, Any]) -> Any:
        if rest is not None:
            data = {name: data.pop(name) for name in named if name in data} | {rest.name: data}
        return cls(**data)

    others = {"extra_behavior": "forbid"} if rest is None else {
        "extra_behavior": "allow", "extras_schema": rest.metadata["further"].core,
    }  # fmt: skip
    checked = {"type": "typed-dict", "fields": named, **others}
    return {"type": "function-after", "function": {"type": "no-info", "function": make}, "schema": checked}


def _object(cls: Any, rest: Field[Any] | None) -> dict[str, Any]:
    json: dict[str, Any] = {
        "type": "object",
        "additionalProperties": False,
        "properties": {name: field.metadata["kind"].json for name, field in keys(cls).items()},
    }
    if required := [name for name, field in keys(cls).items() if _required(field)]:
        json["required"] = required
    if rest is not None:
        json["patternProperties"] = {rest.metadata["pattern"]: rest.metadata["further"].json}
    return json
