"""The mechanism file's tables, key by key. Values leave here in SI; names leave here tidied.

What needs knowledge of other tables (does the point exist?) is not asked here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from pydantic_core import SchemaValidator

from graphkin.files.fields import (
    ALSO,
    ANCHOR,
    ANGLE,
    EDGE_RADIUS,
    FLAG,
    LENGTH,
    LINK_KEY,
    MEASURE_PATTERN,
    NAME,
    NEW_NAME,
    NUMBER,
    PLACE,
    POINT_NAME,
    POINT_PATTERN,
    RADIUS,
    SCALE,
    SIDE,
    TEXT,
    TRIPLES,
    VECTOR,
    anything,
    entry,
    further,
    key,
    kind_of,
    list_of,
    mapping,
    one_table,
    quantity_of,
    table,
    tables,
    title,
    two,
)

FURTHER = "*"
"""Stands for the keys of a table that are not named one by one: points, lengths and angles."""

Place = Sequence[float]
Vector = tuple[str, str]
Side = Literal["left", "right"]


@table
class Titles:
    en: str | None = key(TEXT, default=None)
    zh: str | None = key(TEXT, default=None)


TITLES = title(Titles)

@table
class FrameTable:
    """`[frame]`: its own name, and the fixed points by theirs."""

    name: str = key(LINK_KEY, default="0")
    points: Mapping[str, Place] = further(POINT_PATTERN, PLACE)


@table
class LinkTable:
    """`[links.X]`: lengths and angles stand as further keys, read in `links`."""

    points: Sequence[str] | None = key(list_of(POINT_NAME), default=None)
    ccw: Sequence[Sequence[str]] | None = key(TRIPLES, default=None)
    shape: Mapping[str, Place] | None = key(mapping(POINT_NAME, PLACE), default=None)
    measures: Mapping[str, Any] = further(MEASURE_PATTERN, anything(NUMBER))


@table
class LineTable:
    """What says where a line lies in its link; a slide, a track on a line and a flat profile share it."""

    through: str | Place | None = key(ANCHOR, default=None)
    toward: str | None = key(POINT_NAME, default=None)
    from_: Vector | None = key(VECTOR, default=None)
    angle: float | None = key(ANGLE, default=None)


@table
class SlideTable(LineTable):
    """A block, or a pin, on a line of the guide; with `centre` and `radius`, a pin in a circular slot of the guide."""

    name: str | None = key(NEW_NAME, default=None)
    title: Titles = key(TITLES, default=Titles())
    block: str | None = key(NAME, default=None)
    point: str | None = key(POINT_NAME, default=None)
    pin: str | None = key(POINT_NAME, default=None)
    guide: str = key(NAME)
    tilt: float | None = key(ANGLE, default=None)
    centre: str | Place | None = key(ANCHOR, default=None)
    radius: float | None = key(RADIUS, default=None)


@table
class GearTable:
    links: Sequence[str] = key(two(NAME))
    centres: Sequence[str] = key(two(POINT_NAME))
    radii: Sequence[float] = key(two(RADIUS))
    internal: bool = key(FLAG, default=False)


@table
class RollTable(LineTable):
    name: str | None = key(NEW_NAME, default=None)
    wheel: str = key(NAME)
    centre: str = key(POINT_NAME)
    radius: float = key(RADIUS)
    on: str = key(NAME)
    side: Side | None = key(SIDE, default=None)
    on_centre: str | None = key(POINT_NAME, default=None)
    on_radius: float | None = key(RADIUS, default=None)
    internal: bool | None = key(FLAG, default=None)


@table
class ProfileTable(LineTable):
    centre: str | None = key(POINT_NAME, default=None)
    radius: float | None = key(EDGE_RADIUS, default=None)
    side: Side | None = key(SIDE, default=None)


@table
class CamTable:
    links: Sequence[str] = key(two(NAME))
    profiles: Sequence[ProfileTable] = key(two(entry(ProfileTable)))
    internal: bool = key(FLAG, default=False)


@table
class PoseTable:
    vector: Vector | None = key(VECTOR, default=None)
    angle: float | None = key(ANGLE, default=None)
    from_: Vector | None = key(VECTOR, default=None)
    slide: str | None = key(NAME, default=None)
    at: float | None = key(LENGTH, default=None)


@table
class DriverTable(PoseTable):
    link: str | None = key(NAME, default=None)
    omega: float | None = key(quantity_of("angular velocity"), default=None)
    alpha: float | None = key(quantity_of("angular acceleration"), default=None)
    velocity: float | None = key(quantity_of("velocity"), default=None)
    acceleration: float | None = key(quantity_of("acceleration"), default=None)
    also: Sequence[float] = key(list_of(ALSO), default=())


@table
class ScalesTable:
    """Metres (m/s, m/s²) on one millimetre of paper."""

    length: float | None = key(SCALE, default=None)
    velocity: float | None = key(SCALE, default=None)
    acceleration: float | None = key(SCALE, default=None)


@table
class SketchTable:
    """`[sketch]`: points by their names."""

    points: Mapping[str, Place] = further(POINT_PATTERN, PLACE)


@table
class File:
    """The whole mechanism file."""

    title: Titles = key(TITLES, default=Titles())
    source: Titles = key(TITLES, default=Titles())
    ask: Sequence[str] = key(list_of(TEXT), default=())
    frame: FrameTable = key(one_table(FrameTable), default=FrameTable(points={}))
    links: Mapping[str, LinkTable] = key(mapping(LINK_KEY, entry(LinkTable)))
    slide: Sequence[SlideTable] = key(tables(SlideTable), default=())
    gear: Sequence[GearTable] = key(tables(GearTable), default=())
    roll: Sequence[RollTable] = key(tables(RollTable), default=())
    cam: Sequence[CamTable] = key(tables(CamTable), default=())
    driver: Sequence[DriverTable] = key(tables(DriverTable), default=())
    pose: Sequence[PoseTable] = key(tables(PoseTable), default=())
    sketch: Mapping[str, Place] = key(mapping(POINT_NAME, PLACE), default_factory=dict)
    scales: ScalesTable = key(one_table(ScalesTable), default=ScalesTable())


TABLES: Mapping[str, type] = {
    "file": File, "title": Titles, "frame": FrameTable, "link": LinkTable, "slide": SlideTable, "gear": GearTable,
    "roll": RollTable, "cam": CamTable, "profile": ProfileTable, "driver": DriverTable, "pose": PoseTable,
    "sketch": SketchTable, "scales": ScalesTable,
}  # fmt: skip
"""The tables as they are called in the file, in the order in which one writes them."""

_VALIDATOR = SchemaValidator(kind_of(File).core)


def read_tables(document: Mapping[str, Any]) -> File:
    """The tables of a file. Raises pydantic's ValidationError with all that is wrong in them."""
    tables: File = _VALIDATOR.validate_python(document)
    return tables
