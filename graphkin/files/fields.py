"""The kinds of value a mechanism file has: quantities with units, names, places, points' triples, tables.

A kind has the rule for a value twice: for pydantic's core, which checks whole files and collects what is
wrong, and for JSON Schema, which editors read. Complaints are graphkin's own errors. (The core alone is
imported: with pydantic's models around it, reading a file would take ten times as long as checking it.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, Field, field, fields, is_dataclass
from typing import TYPE_CHECKING, Any, TypeVar, dataclass_transform

from pydantic_core import PydanticCustomError

from graphkin.base.value import frozen
from graphkin.errors import NOWHERE, BadName, GraphkinError, NotBetween, NotOneOf, WrongType
from graphkin.files import values
from graphkin.files.values import name_reader, shown_value, si_quantity
from graphkin.model.mechanism import Dimension

if TYPE_CHECKING:
    from pydantic_core.core_schema import ValidationInfo

LENGTH_PATTERN, ANGLE_PATTERN = (rf"^([A-Z][0-9]*'*){{{points}}}$" for points in (2, 3))
POINT_PATTERN = r"^[A-Z][0-9]*'*$"
QUESTION_PATTERN = "[ ,0-9]"  # every question has one of these; no key that is a word has
MOST_POINTS = 1e6
Schema = dict[str, Any]
"""The rule for a value, as pydantic's core or as JSON Schema reads it: `type`, and what belongs to that type."""

_T = TypeVar("_T")


@frozen
class FieldKind:
    """The rule for a value, for pydantic's core and for JSON Schema, and its dimension where it is a quantity."""

    core: Schema
    json: Schema
    dimension: Dimension | None = None


def _guarded(read: Callable[..., _T]) -> Callable[..., _T]:
    """The same reader, its complaint in the wrapping the core collects; `complaints` unwraps it."""

    def guarded(*value: object) -> _T:
        try:
            return read(*value)
        except GraphkinError as problem:
            raise PydanticCustomError("graphkin", "graphkin", {"problem": problem}) from None

    return guarded


def _kind(read: Callable[[object], object], json: Schema, dimension: Dimension | None = None) -> FieldKind:
    """The kind of value that a reader gives."""
    core = {"type": "function-plain", "function": {"type": "no-info", "function": _guarded(read)}}
    return FieldKind(core, json, dimension)


def _before(read: Callable[[object], object], inner: Schema) -> Schema:
    """The schema for what a reader makes of a value."""
    return {"type": "function-before", "function": {"type": "no-info", "function": _guarded(read)}, "schema": inner}


def _of_type(kind: str, expected: type, inner: Schema) -> Schema:
    """The schema for values of one type; says `kind` otherwise."""

    def checked(value: object) -> object:
        if not isinstance(value, expected):
            raise WrongType(NOWHERE, kind, shown_value(value))
        return value

    return _before(checked, inner)


def quantity_rule(dimension: Dimension, least: str = "") -> Schema:
    """The place of the JSON Schema's rule for a quantity, of any size, `above zero` or `from zero` on."""
    return {"$ref": f"#/$defs/{' '.join([dimension, *least.split()]).replace(' ', '_')}"}


def quantity_of(dimension: Dimension, check: Callable[[float], float] = float, least: str = "") -> FieldKind:
    """A number or a text with a unit."""
    return _kind(lambda value: check(si_quantity(value, dimension)), quantity_rule(dimension, least), dimension)


def _text(kind: str, read: Callable[[str], str] = values.tidy, **json: str) -> FieldKind:
    """A text; `kind` says in a message what is expected."""

    def checked(value: object) -> str:
        if not isinstance(value, str):
            raise WrongType(NOWHERE, kind, shown_value(value))
        return read(value)

    return _kind(checked, json or {"type": "string"})


def _further_value(value: object, info: ValidationInfo) -> float:
    """A further value of what the driver drives: a length for a slide, else an angle."""
    return si_quantity(value, "length" if info.data.get("slide") else "angle")


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise WrongType(NOWHERE, "flag", shown_value(value))
    return value


def _one_of(*words: str) -> FieldKind:
    """One of some words."""

    def checked(value: str) -> str:
        if value not in words:
            raise NotOneOf(NOWHERE, shown_value(value), words)
        return value

    kind = _text("name", checked)
    kind.json["enum"] = [*words]
    return kind


def _worth(value: object) -> float:
    """The points of an answer."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise WrongType(NOWHERE, "number", shown_value(value))
    if not 0 <= value < MOST_POINTS:
        raise NotBetween(NOWHERE, shown_value(value), 0, MOST_POINTS)
    return float(value)


def _vector(value: object) -> tuple[str, str]:
    """Two different points: `AB`."""
    if not isinstance(value, str):
        raise WrongType(NOWHERE, "vector", shown_value(value))
    points = values.split_points(values.tidy(value))
    if len(points) != 2 or points[0] == points[1]:
        raise BadName(NOWHERE, "vector", shown_value(value))
    return points[0], points[1]


LENGTH, ANGLE = quantity_of("length"), quantity_of("angle")
RADIUS = quantity_of("length", values.above_zero, "above zero")
EDGE_RADIUS = quantity_of("length", values.zero_or_more, "from zero")
MEASURE = FieldKind({"type": "any"}, {LENGTH_PATTERN: RADIUS.json, ANGLE_PATTERN: quantity_rule("angle", "from zero")})
"""Lengths and angles of a link, which are looked at later."""
_ALSO_READER = {"type": "with-info", "function": _guarded(_further_value)}
ALSO = FieldKind({"type": "function-plain", "function": _ALSO_READER},
                 {"anyOf": [quantity_rule("length"), quantity_rule("angle")]})  # fmt: skip
SCALE = _kind(values.scale_value, {"type": "number", "exclusiveMinimum": 0})
FLAG = _kind(_flag, {"type": "boolean"})
TEXT = _text("text", lambda text: " ".join(text.split()))
NAME, NEW_NAME = _text("name"), _text("name", name_reader(values.SLIDE, "slide"))
LINK_KEY = _text("name", name_reader(values.LINK, "link"), pattern=r"^[\w']+$")
POINT_NAME = _text("name", name_reader(values.POINT, "point"), type="string", pattern=POINT_PATTERN)
VECTOR = _kind(_vector, {"type": "string", "pattern": r"^([A-Z][0-9]*'*){2}$"})
SIDE, FOLLOWS = _one_of("left", "right"), _one_of("full", "half", "none")
WORTH = _kind(_worth, {"type": "number", "minimum": 0, "exclusiveMaximum": MOST_POINTS})


def list_of(item: FieldKind, kind: str = "list", count: int | None = None) -> FieldKind:
    """A list of values, of any or of one certain length."""
    length = {} if count is None else {"min_length": count, "max_length": count}
    core = _of_type(kind, list, {"type": "list", "items_schema": item.core, **length})
    counted = {} if count is None else {"minItems": count, "maxItems": count}
    return FieldKind(core, {"type": "array", "items": item.json, **counted}, item.dimension)


def two(item: FieldKind) -> FieldKind:
    """One value for each of two links."""
    return list_of(item, count=2)


def mapping(names: FieldKind, kind: FieldKind) -> FieldKind:
    """A table whose keys are names themselves, each with a value of one kind."""
    core = _of_type("table", dict, {"type": "dict", "keys_schema": names.core, "values_schema": kind.core})
    json = {"type": "object", "patternProperties": {names.json["pattern"]: kind.json}}
    return FieldKind(core, json, kind.dimension)


def _as_triples(value: object) -> object:
    """One triple or a list of them: a list of them."""
    if not isinstance(value, list):
        raise WrongType(NOWHERE, "triple", shown_value(value))
    return [value] if value and all(not isinstance(item, list) for item in value) else value


PLACE = list_of(LENGTH, "place", 2)
_ANCHOR_POINT = _text("anchor", name_reader(values.POINT, "point"), **POINT_NAME.json)
ANCHOR = FieldKind({"type": "tagged-union", "choices": {"a point": _ANCHOR_POINT.core, "a place": PLACE.core},
                    "discriminator": lambda value: "a place" if isinstance(value, list) else "a point"},
                   {"oneOf": [_ANCHOR_POINT.json, PLACE.json]})  # fmt: skip
_TRIPLE = list_of(POINT_NAME, "triple", 3)
TRIPLES = FieldKind(_before(_as_triples, {"type": "list", "items_schema": _TRIPLE.core}),
                    {"type": "array", "items": {"anyOf": [POINT_NAME.json, _TRIPLE.json]}})  # fmt: skip


_KINDS: dict[type, FieldKind] = {}  # by the class of a table, the kind of value that becomes an instance of it


def key(kind: FieldKind, **default: Any) -> Any:
    """A key of a table; it may be left out where there is a `default` or a `default_factory`."""
    return field(**default, metadata={"kind": kind})


def further(kind: FieldKind, pattern: str = "") -> dict[str, _T]:
    """All keys of a table that are not named, by a dictionary; an editor expects this pattern, or the kind's own."""
    rules = {pattern: kind.json} if pattern else kind.json
    return field(default_factory=dict, metadata={"further": kind, "rules": rules})


@dataclass_transform(kw_only_default=True, frozen_default=True, field_specifiers=(key, further))
def table(cls: type[_T]) -> type[_T]:
    """A table made of `key`s; others are refused where there is no `further`. `from_` is the key `from`."""
    cls.__doc__ = cls.__doc__ or f"`{cls.__name__}`"
    made = frozen(cls)
    rest = next((each for each in _fields(made) if "further" in each.metadata), None)
    json: Schema = {"type": "object", "additionalProperties": False,
                    "properties": {name: each.metadata["kind"].json for name, each in keys(made).items()}}  # fmt: skip
    if required := [name for name, each in keys(made).items() if _required(each)]:
        json["required"] = required
    if rest is not None:
        json["patternProperties"] = rest.metadata["rules"]
    _KINDS[made] = FieldKind(_checking(made, rest), json)
    return cls


def kind_of(cls: type) -> FieldKind:
    """The kind of value that becomes an instance of a table's class."""
    return _KINDS[cls]


def _fields(cls: type) -> tuple[Field[object], ...]:
    assert is_dataclass(cls)
    return fields(cls)


def keys(cls: type) -> dict[str, Field[object]]:
    """The fields of a table by the keys they have in the file."""
    return {each.name.rstrip("_"): each for each in _fields(cls) if "kind" in each.metadata}


def one_table(cls: type) -> FieldKind:
    """A value that is such a table."""
    return FieldKind(_of_type("table", dict, kind_of(cls).core), entry(cls).json)


def tables(cls: type) -> FieldKind:
    """`[[..]]`: any number of such tables."""
    return list_of(entry(cls), "tables")


def entry(cls: type) -> FieldKind:
    """A table among others of its kind."""
    return FieldKind(kind_of(cls).core, {"$ref": f"#/$defs/{cls.__name__}"})


def title(cls: type) -> FieldKind:
    """A text, or such a table of one for each language."""

    def in_both(value: object) -> object:
        """One title serves both languages."""
        if not isinstance(value, str | dict):
            raise WrongType(NOWHERE, "title", shown_value(value))
        return {"en": value, "zh": value} if isinstance(value, str) else value

    return FieldKind(_before(in_both, kind_of(cls).core), {"anyOf": [{"type": "string"}, kind_of(cls).json]})


def _required(each: Field[object]) -> bool:
    return each.default is MISSING and each.default_factory is MISSING


def _checking(cls: type, rest: Field[object] | None) -> Schema:
    """The schema that makes an instance of the class of a table that is right."""
    named = {
        each.name: {
            "type": "typed-dict-field", "schema": each.metadata["kind"].core, "required": _required(each),
            "validation_alias": name,
        }
        for name, each in keys(cls).items()
    }  # fmt: skip

    def make(data: dict[str, object]) -> object:
        if rest is not None:
            data = {name: data.pop(name) for name in named if name in data} | {rest.name: data}
        return cls(**data)

    others = {"extra_behavior": "forbid"} if rest is None else {
        "extra_behavior": "allow", "extras_schema": rest.metadata["further"].core,
    }  # fmt: skip
    checked = {"type": "typed-dict", "fields": named, **others}
    return {"type": "function-after", "function": {"type": "no-info", "function": make}, "schema": checked}
