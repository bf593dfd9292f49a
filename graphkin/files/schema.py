"""The mechanism file's tables, key by key. Values leave here in SI; names leave here tidied.

What needs knowledge of other tables (does the point exist?) is not asked here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Literal

from pydantic_core import SchemaValidator, ValidationError

from graphkin.errors import GraphkinError, MissingKey, UnitAsKey, UnknownKey, Where, WrongCount, WrongType
from graphkin.files import fields
from graphkin.files.fields import further, key, keys, kind_of, table
from graphkin.files.values import UNITS, short_number, shown_value, si_quantity, split_points, tidy
from graphkin.model.mechanism import Dimension, GivenValue, KeyPath

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

FURTHER = "*"  # stands for the keys of a table that are not named one by one: points, lengths and angles

Place = Sequence[float]
Vector = tuple[str, str]
Side = Literal["left", "right"]
Follows = Literal["full", "half", "none"]
CREDIT: Mapping[Follows, float] = {"full": 1.0, "half": 0.5, "none": 0.0}


@table
class Titles:
    en: str | None = key(fields.TEXT, default=None)
    zh: str | None = key(fields.TEXT, default=None)


TITLES = fields.title(Titles)


@table
class FrameTable:
    """`[frame]`: its own name, and the fixed points by theirs."""

    name: str = key(fields.LINK_KEY, default="0")
    points: Mapping[str, Place] = further(fields.PLACE, fields.POINT_PATTERN)


@table
class LinkTable:
    """`[links.X]`: lengths and angles stand as further keys, read in `links`."""

    points: Sequence[str] | None = key(fields.list_of(fields.POINT_NAME), default=None)
    ccw: Sequence[Sequence[str]] | None = key(fields.TRIPLES, default=None)
    shape: Mapping[str, Place] | None = key(fields.mapping(fields.POINT_NAME, fields.PLACE), default=None)
    measures: Mapping[str, object] = further(fields.MEASURE)


@table
class LineTable:
    """The keys that place a line in its link; a slide, a track on a line and a flat profile share them."""

    through: str | Place | None = key(fields.ANCHOR, default=None)
    toward: str | None = key(fields.POINT_NAME, default=None)
    from_: Vector | None = key(fields.VECTOR, default=None)
    angle: float | None = key(fields.ANGLE, default=None)


@table
class SlideTable(LineTable):
    """A block, or a pin, on a line of the guide; with `centre` and `radius`, a pin in a circular slot of the guide."""

    name: str | None = key(fields.NEW_NAME, default=None)
    title: Titles = key(TITLES, default=Titles())
    block: str | None = key(fields.NAME, default=None)
    point: str | None = key(fields.POINT_NAME, default=None)
    pin: str | None = key(fields.POINT_NAME, default=None)
    guide: str = key(fields.NAME)
    tilt: float | None = key(fields.ANGLE, default=None)
    centre: str | Place | None = key(fields.ANCHOR, default=None)
    radius: float | None = key(fields.RADIUS, default=None)


@table
class GearTable:
    links: Sequence[str] = key(fields.two(fields.NAME))
    centres: Sequence[str] = key(fields.two(fields.POINT_NAME))
    radii: Sequence[float] = key(fields.two(fields.RADIUS))
    internal: bool = key(fields.FLAG, default=False)


@table
class RollTable(LineTable):
    name: str | None = key(fields.NEW_NAME, default=None)
    wheel: str = key(fields.NAME)
    centre: str = key(fields.POINT_NAME)
    radius: float = key(fields.RADIUS)
    on: str = key(fields.NAME)
    side: Side | None = key(fields.SIDE, default=None)
    on_centre: str | None = key(fields.POINT_NAME, default=None)
    on_radius: float | None = key(fields.RADIUS, default=None)
    internal: bool | None = key(fields.FLAG, default=None)


@table
class ProfileTable(LineTable):
    centre: str | None = key(fields.POINT_NAME, default=None)
    radius: float | None = key(fields.EDGE_RADIUS, default=None)
    side: Side | None = key(fields.SIDE, default=None)


@table
class CamTable:
    links: Sequence[str] = key(fields.two(fields.NAME))
    profiles: Sequence[ProfileTable] = key(fields.two(fields.entry(ProfileTable)))
    internal: bool = key(fields.FLAG, default=False)


@table
class PoseTable:
    vector: Vector | None = key(fields.VECTOR, default=None)
    angle: float | None = key(fields.ANGLE, default=None)
    from_: Vector | None = key(fields.VECTOR, default=None)
    slide: str | None = key(fields.NAME, default=None)
    at: float | None = key(fields.LENGTH, default=None)


@table
class DriverTable(PoseTable):
    link: str | None = key(fields.NAME, default=None)
    omega: float | None = key(fields.quantity_of("angular velocity"), default=None)
    alpha: float | None = key(fields.quantity_of("angular acceleration"), default=None)
    velocity: float | None = key(fields.quantity_of("velocity"), default=None)
    acceleration: float | None = key(fields.quantity_of("acceleration"), default=None)
    also: Sequence[float] = key(fields.list_of(fields.ALSO), default=())


@table
class ScalesTable:
    """Metres (m/s, m/s²) on one millimetre of paper."""

    length: float | None = key(fields.SCALE, default=None)
    velocity: float | None = key(fields.SCALE, default=None)
    acceleration: float | None = key(fields.SCALE, default=None)


@table
class PointsTable:
    """`[points]`: what each question is worth, by its text, and a value that follows rightly from a wrong one."""

    follows: Follows = key(fields.FOLLOWS, default="full")
    worth: Mapping[str, float] = further(fields.WORTH, fields.QUESTION_PATTERN)


@table
class SketchTable:
    """`[sketch]`: points by their names."""

    points: Mapping[str, Place] = further(fields.PLACE, fields.POINT_PATTERN)


@table
class File:
    """The whole mechanism file."""

    title: Titles = key(TITLES, default=Titles())
    source: Titles = key(TITLES, default=Titles())
    text: Titles = key(TITLES, default=Titles())
    ask: Sequence[str] = key(fields.list_of(fields.TEXT), default=())
    points: PointsTable = key(fields.one_table(PointsTable), default=PointsTable(worth={}))
    frame: FrameTable = key(fields.one_table(FrameTable), default=FrameTable(points={}))
    links: Mapping[str, LinkTable] = key(fields.mapping(fields.LINK_KEY, fields.entry(LinkTable)))
    slide: Sequence[SlideTable] = key(fields.tables(SlideTable), default=())
    gear: Sequence[GearTable] = key(fields.tables(GearTable), default=())
    roll: Sequence[RollTable] = key(fields.tables(RollTable), default=())
    cam: Sequence[CamTable] = key(fields.tables(CamTable), default=())
    driver: Sequence[DriverTable] = key(fields.tables(DriverTable), default=())
    pose: Sequence[PoseTable] = key(fields.tables(PoseTable), default=())
    sketch: Mapping[str, Place] = key(fields.mapping(fields.POINT_NAME, fields.PLACE), default_factory=dict)
    scales: ScalesTable = key(fields.one_table(ScalesTable), default=ScalesTable())


TABLES: Mapping[str, type] = {
    "file": File, "title": Titles, "points": PointsTable, "frame": FrameTable, "link": LinkTable, "slide": SlideTable,
    "gear": GearTable, "roll": RollTable, "cam": CamTable, "profile": ProfileTable, "driver": DriverTable,
    "pose": PoseTable, "sketch": SketchTable, "scales": ScalesTable,
}  # fmt: skip
"""The tables as they are called in the file, in the order in which one writes them."""

TABLES_AT: Mapping[tuple[str, ...], type] = {
    (): File, ("title",): Titles, ("source",): Titles, ("text",): Titles, ("slide", "title"): Titles,
    ("slide",): SlideTable, ("gear",): GearTable, ("roll",): RollTable, ("cam",): CamTable,
    ("cam", "profiles"): ProfileTable,
    ("points",): PointsTable, ("driver",): DriverTable, ("pose",): PoseTable, ("scales",): ScalesTable,
}  # fmt: skip
"""The table at a path, item numbers left out, where its keys are known."""

_VALIDATOR = SchemaValidator(kind_of(File).core)


def read_tables(document: Mapping[str, object]) -> File:
    """The tables of a file. Raises pydantic's ValidationError with all that is wrong in them."""
    file: File = _VALIDATOR.validate_python(document)
    return file


_DRIVER_KEYS: Mapping[Dimension, str] = {
    "length": "at", "angle": "angle", "angular velocity": "omega", "angular acceleration": "alpha",
    "velocity": "velocity", "acceleration": "acceleration",
}  # fmt: skip
"""The key of a driver that takes a quantity."""


def complaints(
    error: ValidationError, where: Callable[..., Where], lines: Mapping[KeyPath, int]
) -> Iterator[GraphkinError]:
    """The findings of pydantic's core as graphkin's own errors; what it adds to the paths of `lines` is left out."""
    for detail in error.errors(include_url=False):
        path = detail["loc"]
        while path and path not in lines and detail["type"] != "missing":
            path = path[:-1]
        yield _complaint(detail, where(*path))


def _complaint(detail: ErrorDetails, where: Where) -> GraphkinError:
    context = detail.get("ctx", {})
    key = str(detail["loc"][-1]) if detail["loc"] else ""
    match detail["type"]:
        case "graphkin":
            problem: GraphkinError = context["problem"]
            return problem.at(where)
        case "missing":
            return MissingKey(where, key)
        case "extra_forbidden":
            table = TABLES_AT.get(tuple(part for part in detail["loc"][:-1] if isinstance(part, str)))
            # a unit that stands where the key does (`rpm = 95`) is said by the key that takes it
            value = detail["input"]
            possible = tuple(keys(table)) if table else ()
            meant = next((_DRIVER_KEYS[dimension] for dimension, units in UNITS.items() if key in units), None)
            if meant in possible and isinstance(value, int | float) and not isinstance(value, bool):
                return UnitAsKey(where, key, meant, f"{short_number(value)} {key}")
            return UnknownKey(where, key[:40], possible)
        case "too_short" | "too_long":
            expected = context.get("min_length", context.get("max_length"))
            return WrongCount(where, int(expected or 0), len(detail["input"]))
        case kind:
            return WrongType(where, "list" if kind == "list_type" else "table", shown_value(detail["input"]))


def stated_values(document: Mapping[str, object]) -> dict[KeyPath, GivenValue]:
    """All that a file states, by place and in its order: tables and lists, each followed by what is in it."""
    return {value.path: value for value in _stated_in(document, (), None)}


def _stated_in(content: Mapping[str, object] | Sequence[object], path: KeyPath, around: object) -> Iterator[GivenValue]:
    """The values of a table or a list at a path; `around` is the table or list that it is in."""
    items: Iterable[tuple[str | int, object]] = content.items() if isinstance(content, Mapping) else enumerate(content)
    for part, written in items:
        place = (*path, tidy(part) if isinstance(part, str) else part)
        if isinstance(written, dict | list):
            yield GivenValue(place, written)
            yield from _stated_in(written, place, content)
        else:
            dimension = _dimension(place, around)
            yield GivenValue(place, written, dimension, None if dimension is None else si_quantity(written, dimension))


def _dimension(path: KeyPath, around: object) -> Dimension | None:
    """The dimension of a single value; None for a name, a flag, a scale."""
    match path:
        case ("links", _, str(key)):
            measures: Mapping[int, Dimension] = {2: "length", 3: "angle"}
            return measures.get(len(split_points(key)))
        case ("links", _, "shape", _, int()) | ("frame" | "sketch", _, int()) | (*_, "through" | "centre", int()):
            return "length"
        case ("driver", int(), "also", int()):
            return "length" if isinstance(around, dict) and "slide" in around else "angle"
        case _:
            *above, name = [part for part in path if isinstance(part, str)]
            kind = keys(TABLES_AT[tuple(above)]).get(name) if tuple(above) in TABLES_AT else None
            dimension: Dimension | None = None if kind is None else kind.metadata["kind"].dimension
            return dimension
