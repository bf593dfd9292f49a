"""The data of what is handed in: no language, no millimetre but those measured on a drawing, no verdict."""

from __future__ import annotations

import cmath
import hashlib
import math
from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE, GraphkinError, TooMuch, UnsureDrawing, Where, steers
from graphkin.model.mechanism import Mechanism

Sense = Literal["ccw", "cw"]
Counted = Literal["bytes", "members", "elements", "depth", "copies", "answers", "rows", "columns"]
"""Things of which there may be too many in a hostile file."""


@frozen
class ReadableProblem:
    """One problem, as far as reading an answer to it goes.

    questions  as the key writes them (`omega 3`, `a_k B3B2`): what a student calls one of them comes out in these
               words; any other quantity of the mechanism comes out as `quantities` writes it
    further    what is asked at further positions: the same mechanism drawn there
    """

    mechanism: Mechanism
    questions: tuple[str, ...] = ()
    further: tuple[ReadableProblem, ...] = ()

    @property
    def positions(self) -> tuple[ReadableProblem, ...]:
        """The problem at each position, the drawn one first."""
        return self, *self.further


@frozen
class HandedValue:
    """One quantity that was handed in.

    text      as the student wrote it; "" for one measured on a drawing
    value     in SI, with its sign; a sense in words is its sign (62 cw is -62). None where it cannot be read
    sense     the sense that was given in words or by an arrow; None where only a sign says it
    unit      the unit that was written with it, in the house's spelling ("rad/s^2", "mm"); "" where none was
    fault     why it has no value; or, beside a value, that its unit is of another kind: the number is then taken as
              if no unit stood there (a unit is a mistake of its own)
    vector    size and direction in the mechanism's axes, SI, of one that is measured or given with its angle
    within    the angle within which a direction in words holds; 0 of one in numbers [rad]
    """

    text: str
    value: float | None
    sense: Sense | None = None
    unit: str = ""
    fault: GraphkinError | None = None
    vector: complex | None = None
    within: float = 0.0


@frozen
class MeasuredDrawing:
    """All that was measured on a drawing.

    points      by plane and the construction's letter (`b3'`): where on the page [mm, y up]
    scales      by plane: SI unit per mm, as used; None where none is known
    turned      by plane: by how much the drawn polygon stands turned, where it may [rad]
    remarks     for the teacher: what should be looked at
    error       of the points on a photograph of paper [mm]; 0 where a program has drawn
    unsure      what of a photograph should be looked at before it counts
    shifts      how points of which something is unsure may all be off together: independent of each other, each by one
                standard deviation [mm]
    """

    points: Mapping[tuple[Plane, str], complex]
    scales: Mapping[Plane, float]
    turned: Mapping[Plane, float] = field(default_factory=dict)
    where: Where = NOWHERE
    remarks: tuple[GraphkinError, ...] = ()
    error: float = 0.0
    unsure: tuple[UnsureDrawing, ...] = ()
    shifts: tuple[Mapping[tuple[Plane, str], complex], ...] = ()

    @property
    def sure(self) -> dict[tuple[Plane, str], complex]:
        """The points of which nothing is unsure; a plane's first is its pole, which is printed."""
        return {at: place for at, place in self.points.items() if at not in self.off}

    @property
    def off(self) -> dict[tuple[Plane, str], float]:
        """The standard deviations of the points of which something is unsure [mm]; infinite where none is known."""
        poles, off = dict(reversed([*self.points])), dict[tuple[Plane, str], float]()
        for plane, letter in self.points:
            doubts = [one.off or math.inf for one in self.unsure
                      if one.plane == plane and (not one.letters or letter in one.letters)]  # fmt: skip
            if doubts and letter != poles[plane]:
                off[plane, letter] = max(doubts)
        return off

    def vector(self, drawn: complex, plane: Plane) -> complex:
        """A vector that is drawn, SI, turned back."""
        return drawn * self.scales[plane] * cmath.rect(1.0, -self.turned.get(plane, 0.0))

    def in_si(self) -> dict[Plane, dict[str, complex]]:
        """Points from the first of their plane on, as vectors; of planes whose scale is known."""
        places: dict[Plane, dict[str, complex]] = {}
        for (plane, letter), place in self.points.items():
            if plane in self.scales:
                places.setdefault(plane, {})[letter] = self.vector(place, plane)
        return {plane: {letter: at - first for letter, at in points.items()}
                for plane, points in places.items() for first in [next(iter(points.values()))]}  # fmt: skip


@frozen
class FilledTerm:
    """A term of an equation by its number in its plane, with the choices that were made; "" where none was."""

    plane: Plane
    equation: int
    term: str
    direction: str
    magnitude: str


@frozen
class BoardStep:
    """One act of the pencil.

    at       its places [mm from the pole, y up]: the ends of an arrow or a line, the place of a point
    name     of the arrow or the point; through, line: of a line, as the student took them
    """

    number: int
    plane: Plane
    tool: str
    at: tuple[complex, ...]
    name: str = ""
    through: str = ""
    line: str = ""


@frozen
class BoardWork:
    """The equations and the drawing of one board; scales [SI unit per mm] as the student chose them."""

    equations: tuple[FilledTerm, ...] = ()
    steps: tuple[BoardStep, ...] = ()
    scales: Mapping[Plane, float] = field(default_factory=dict)


@frozen
class Submission:
    """The answers of one student, or why they cannot be read.

    student  the id; text of any kind, never a path (`safe_name` makes a file's name of it)
    file     as results call it: the path, or `class.zip!folder/answer.svg`
    values   by question, in the key's words; reason: why nothing of it can be marked, and there are none
    notes    what was passed over: a question that is none, a second answer to one, a letter that was not found
    place    line of a class table, or name of the member of an archive: under which results go back to the platform
    drawings  what was measured on the drawing of each position, by its number
    board     the equations and the steps of a drawing board's file, of the drawn position
    """

    student: str
    file: str
    values: Mapping[str, HandedValue] = field(default_factory=dict)
    reason: GraphkinError | None = None
    notes: tuple[GraphkinError, ...] = ()
    place: str = ""
    drawings: Mapping[int, MeasuredDrawing] = field(default_factory=dict)
    board: BoardWork | None = None


@frozen
class Limits:
    """The most of a hostile file that is looked at.

    seconds  for one submission; bytes of a file or member, and of one that pictures of a whole class may be in;
             members of a class's archive, bytes of all of them together, and how much larger than packed; parts of a
             file that is an archive inside; elements and depth of a drawing, copies (`use`, blocks) followed; answers
             in one file; rows and columns of a class table
    turned   whether a polygon may stand turned on the page
    names    names of a drawing's marked points, in the file's order, where it has no letters
    """

    seconds: float = 10.0
    bytes: int = 16 << 20
    pile_bytes: int = 256 << 20
    members: int = 500_000
    archive_bytes: int = 64 << 30
    parts: int = 20_000
    ratio: float = 200.0
    elements: int = 50_000
    depth: int = 100
    copies: int = 5_000
    answers: int = 500
    rows: int = 1_000_000
    columns: int = 1_000
    turned: bool = False
    names: tuple[str, ...] = ()

    def check(self, where: Where, name: Counted, count: int) -> None:
        """Raises TooMuch where there are more of something than are looked at."""
        if count > (most := getattr(self, name)):
            raise TooMuch(where, name, most)


_RESERVED = {"con", "prn", "aux", "nul", *(f"{port}{k}" for port in ("com", "lpt") for k in range(10))}
LONGEST_ID = 200
DRAWINGS = (".svg", ".ggb", ".dxf")
"""Kinds of files that may show one position of several, whose number ends their name."""


def tidy_id(text: str) -> str:
    """An id as it is shown: without blanks about it, and nothing in it that steers a screen."""
    return "".join(letter for letter in " ".join(text.split()) if not steers(letter))[:LONGEST_ID]


def safe_name(student: str) -> str:
    """A file's name for an id: its plain letters, and a mark of the whole id wherever that is not all of it.

    >>> safe_name("s1"), safe_name("../../etc")
    ('s1', 'etc-74ccf3c5b4c1')
    """
    name = "".join(letter if letter.isalnum() or letter in "_-" else "-" for letter in student[:60]).strip("-_")
    if name and name == student and name.isascii() and name == name.lower() and name not in _RESERVED:
        return name
    mark = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:12]
    return f"{name}-{mark}" if name else mark


def fingerprint(*parts: bytes | str) -> str:
    """Of some texts, in a few letters.

    >>> fingerprint("a", "b") == fingerprint("a", b"b") != fingerprint("ab")
    True
    """
    whole = hashlib.sha256()
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        whole.update(b"%d:" % len(data) + data)
    return whole.hexdigest()[:16]
