"""The kinds of value a mechanism file has: quantities with units, names, places, points' triples.

Each is a type for pydantic whose complaint is one of graphkin's own errors.
"""

from collections.abc import Callable
from typing import Annotated, Any, Literal, TypeVar

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    PlainValidator,
    Tag,
    ValidationInfo,
    WithJsonSchema,
)
from pydantic.config import JsonDict
from pydantic_core import PydanticCustomError

from graphkin.errors import NOWHERE, GraphkinError, WrongType
from graphkin.loading.names import LINK, POINT, SLIDE, tidy
from graphkin.loading.units import UNITS, Dimension
from graphkin.loading.values import above_zero, formed, quantity, scale, shown, triples, vector, zero_or_more

__all__ = [
    "LINK_PATTERN",
    "MEASURE_PATTERN",
    "NUMBER_SCHEMA",
    "PLACE_SCHEMA",
    "POINT_PATTERN",
    "Acceleration",
    "Alpha",
    "Anchor",
    "Angle",
    "Both",
    "EdgeRadius",
    "Flag",
    "Further",
    "Length",
    "LinkKey",
    "Name",
    "NewName",
    "Omega",
    "Place",
    "Point",
    "Radius",
    "Scale",
    "Side",
    "Text",
    "Triples",
    "Vector",
    "Velocity",
    "a_value",
    "guarded",
]

MEASURE_PATTERN = r"^([A-Z][0-9]*'*){2,3}$"
POINT_PATTERN = r"^[A-Z][0-9]*'*$"
NUMBER_SCHEMA: JsonDict = {"type": ["number", "string"]}
PLACE_SCHEMA: JsonDict = {"type": "array", "items": NUMBER_SCHEMA, "minItems": 2, "maxItems": 2}
LINK_PATTERN = r"^[\w']+$"


def _refuse(problem: GraphkinError) -> PydanticCustomError:
    """The problem, in the wrapping pydantic collects; `complaints` unwraps it."""
    return PydanticCustomError("graphkin", "graphkin", {"problem": problem})


def guarded(read: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """The same reader, its complaint wrapped for pydantic."""

    def guarded(value: Any) -> Any:
        try:
            return read(value)
        except GraphkinError as problem:
            raise _refuse(problem) from None

    return guarded


def _quantity_of(dimension: Dimension) -> tuple[PlainValidator, WithJsonSchema]:
    units = ", ".join(UNITS[dimension])
    schema = {"type": ["number", "string"], "description": f"{dimension}; units: {units}"}
    return PlainValidator(guarded(lambda value: quantity(value, dimension))), WithJsonSchema(schema)


def text_of(kind: str, read: Callable[[str], str] = tidy) -> BeforeValidator:
    """A text; `kind` says in a message what is wanted."""

    def checked(value: object) -> str:
        if not isinstance(value, str):
            raise WrongType(NOWHERE, kind, shown(value))
        return read(value)

    return BeforeValidator(guarded(checked))


def a_value(kind: str, *types: type) -> BeforeValidator:
    """A value of one of the types; says `kind` otherwise."""

    def checked(value: object) -> object:
        if not isinstance(value, types):
            raise WrongType(NOWHERE, kind, shown(value))
        return value

    return BeforeValidator(guarded(checked))


def _also(value: object, info: ValidationInfo) -> float:
    """A further value of what the driver drives: a length for a slide, else an angle."""
    dimension: Dimension = "length" if info.data.get("slide") else "angle"
    try:
        return quantity(value, dimension)
    except GraphkinError as problem:
        raise _refuse(problem) from None


_POINT = {"type": "string", "pattern": POINT_PATTERN}
_Length, _Angle = _quantity_of("length"), _quantity_of("angle")

_TRIPLE = {"type": "array", "items": _POINT, "minItems": 3, "maxItems": 3}
Length = Annotated[float, *_Length]
Radius = Annotated[float, *_Length, AfterValidator(guarded(above_zero))]
EdgeRadius = Annotated[float, *_Length, AfterValidator(guarded(zero_or_more))]
Angle = Annotated[float, *_Angle]
Omega = Annotated[float, *_quantity_of("angular velocity")]
Alpha = Annotated[float, *_quantity_of("angular acceleration")]
Velocity = Annotated[float, *_quantity_of("velocity")]
Acceleration = Annotated[float, *_quantity_of("acceleration")]
Scale = Annotated[float, PlainValidator(guarded(scale)), WithJsonSchema({"type": "number", "exclusiveMinimum": 0})]
Further = Annotated[float, PlainValidator(_also), WithJsonSchema(NUMBER_SCHEMA)]
Flag = Annotated[bool, a_value("flag", bool)]
Text = Annotated[str, text_of("text", str)]
Name = Annotated[str, text_of("name")]
NewName = Annotated[str, text_of("name", formed(SLIDE, "slide"))]
LinkKey = Annotated[str, text_of("name", formed(LINK, "link")), WithJsonSchema({"pattern": LINK_PATTERN})]
Point = Annotated[
    str,
    text_of("name", formed(POINT, "point")),
    WithJsonSchema(_POINT),
]
Vector = Annotated[
    tuple[str, str],
    PlainValidator(guarded(vector)),
    WithJsonSchema({"type": "string", "pattern": r"^([A-Z][0-9]*'*){2}$"}),
]
Place = Annotated[list[Length], Field(min_length=2, max_length=2), a_value("place", list)]
Anchor = Annotated[
    Annotated[str, text_of("anchor", formed(POINT, "point")), WithJsonSchema(_POINT), Tag("a point")]
    | Annotated[Place, Tag("a place")],
    Discriminator(lambda value: "a place" if isinstance(value, list) else "a point"),
]
Side = Annotated[Literal["left", "right"], text_of("name", str)]
Triple = Annotated[list[Point], Field(min_length=3, max_length=3), a_value("triple", list)]
Triples = Annotated[
    list[Triple],
    BeforeValidator(guarded(triples)),
    WithJsonSchema({"type": "array", "items": {"anyOf": [_POINT, _TRIPLE]}}),
]


_Item = TypeVar("_Item")
Both = Annotated[list[_Item], Field(min_length=2, max_length=2), a_value("list", list)]
