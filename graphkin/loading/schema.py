"""The mechanism file's tables, key by key. Values leave here in SI; names leave here tidied.

Only this module and `fields` import pydantic, and only `loader` imports this one, when a file is read.
What needs knowledge of other tables (does the point exist?) is not asked here.
"""

from typing import Annotated

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, WithJsonSchema

from graphkin.loading.fields import (
    MEASURE_PATTERN,
    NUMBER_SCHEMA,
    PLACE_SCHEMA,
    POINT_PATTERN,
    Acceleration,
    Alpha,
    Anchor,
    Angle,
    Both,
    EdgeRadius,
    Flag,
    Further,
    Length,
    LinkKey,
    Name,
    NewName,
    Omega,
    Place,
    Point,
    Radius,
    Scale,
    Side,
    Text,
    Triples,
    Vector,
    Velocity,
    a_value,
    guarded,
)
from graphkin.loading.values import titles

__all__ = [
    "CamTable",
    "DriverTable",
    "File",
    "FrameTable",
    "GearTable",
    "LineTable",
    "LinkTable",
    "PoseTable",
    "ProfileTable",
    "RollTable",
    "ScalesTable",
    "SlideTable",
]


class Table(BaseModel):
    """A table whose keys are all known; those that are left out are None."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Titles(Table):
    en: Text | None = None
    zh: Text | None = None


_TITLES = {"anyOf": [{"type": "string"}, Titles.model_json_schema()]}


class FrameTable(Table):
    """`[frame]`: its own name, and the fixed points by theirs."""

    model_config = ConfigDict(
        extra="allow",
        frozen=True,
        json_schema_extra={"patternProperties": {POINT_PATTERN: PLACE_SCHEMA}, "additionalProperties": False},
    )
    __pydantic_extra__: dict[str, Place]

    name: LinkKey = "0"


class LinkTable(Table):
    """`[links.X]`: lengths and angles stand as further keys, read in `links`."""

    model_config = ConfigDict(
        extra="allow",
        frozen=True,
        json_schema_extra={
            "patternProperties": {MEASURE_PATTERN: NUMBER_SCHEMA},
            "additionalProperties": False,
        },
    )

    points: Annotated[list[Point], a_value("list", list)] | None = None
    ccw: Triples | None = None
    shape: Annotated[dict[Point, Place], a_value("table", dict)] | None = None


class LineTable(Table):
    """What says where a line lies in its link; a slide, a track on a line and a flat profile share it."""

    through: Anchor | None = None
    toward: Point | None = None
    from_: Vector | None = Field(None, alias="from")
    angle: Angle | None = None


class SlideTable(LineTable):
    name: NewName | None = None
    block: Name | None = None
    point: Point | None = None
    pin: Point | None = None
    guide: Name
    tilt: Angle | None = None


class GearTable(Table):
    links: Both[Name]
    centres: Both[Point]
    radii: Both[Radius]
    internal: Flag = False


class RollTable(LineTable):
    name: NewName | None = None
    wheel: Name
    centre: Point
    radius: Radius
    on: Name
    side: Side | None = None
    on_centre: Point | None = None
    on_radius: Radius | None = None
    internal: Flag | None = None


class ProfileTable(LineTable):
    centre: Point | None = None
    radius: EdgeRadius | None = None
    side: Side | None = None


class CamTable(Table):
    links: Both[Name]
    profiles: Both[ProfileTable]
    internal: Flag = False


class PoseTable(Table):
    vector: Vector | None = None
    angle: Angle | None = None
    from_: Vector | None = Field(None, alias="from")
    slide: Name | None = None
    at: Length | None = None


class DriverTable(PoseTable):
    link: Name | None = None
    omega: Omega | None = None
    alpha: Alpha | None = None
    velocity: Velocity | None = None
    acceleration: Acceleration | None = None
    also: Annotated[list[Further], a_value("list", list)] = []


class ScalesTable(Table):
    """Metres (m/s, m/s²) on one millimetre of paper."""

    length: Scale | None = None
    velocity: Scale | None = None
    acceleration: Scale | None = None


class File(Table):
    """The whole mechanism file."""

    title: Annotated[Titles, BeforeValidator(guarded(titles)), WithJsonSchema(_TITLES)] = Titles()
    source: Text = ""
    ask: Annotated[list[Text], a_value("list", list)] = []
    frame: Annotated[FrameTable, a_value("table", dict)] = FrameTable.model_construct()
    links: Annotated[dict[LinkKey, LinkTable], a_value("table", dict)]
    slide: Annotated[list[SlideTable], a_value("tables", list)] = []
    gear: Annotated[list[GearTable], a_value("tables", list)] = []
    roll: Annotated[list[RollTable], a_value("tables", list)] = []
    cam: Annotated[list[CamTable], a_value("tables", list)] = []
    driver: Annotated[list[DriverTable], a_value("tables", list)] = []
    pose: Annotated[list[PoseTable], a_value("tables", list)] = []
    sketch: Annotated[dict[Point, Place], a_value("table", dict)] = {}
    scales: Annotated[ScalesTable, a_value("table", dict)] = ScalesTable()
