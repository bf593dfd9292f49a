"""A handout before it is set: blocks with lettered words, drawings in true size, tables."""

from __future__ import annotations

from dataclasses import replace
from math import ceil, inf
from typing import Literal

from graphkin.base.value import bulky, frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.sheet import Sheet
from graphkin.sheet.lettering import Label, plain, width

LETTERS, _GAP, _WIDE, _BLANK = 3.7, 2.0, 146.0, 10.0
"""Of print; between an equation's columns; its width at most, that of a blank at least [mm]."""
GRID = 5.0  # of gridded paper [mm]
_MANY, _FEW = 10, 3  # rows of a table that are as high as one would have them; under gridded paper

Stage = Literal["problem", "blank", "half", "solution"]


@frozen
class HandoutHeading:
    """A heading; level 1 is a problem's title. `said`: what the foot of its pages says of this problem alone;
    `problem`: its place among the owners of a handout."""

    words: Label
    level: int = 2
    said: str = ""
    problem: int | None = None


@frozen
class Paragraph:
    """A paragraph; `act`: the number of the pencil's act that it tells; the drawing bears it, too, in a circle."""

    words: Label
    act: str = ""


@frozen
class FormulaLine:
    """A line of reckoning, set in from the edge."""

    words: Label


@frozen
class TermRows:
    """A vector equation: what stands before its rows, its terms and signs with what is under them; None is a blank."""

    heads: tuple[Label, Label]
    columns: tuple[tuple[Label, Label, Label] | None, ...]

    @property
    def lines(self) -> list[list[Label | None]]:
        """The terms, the directions, the sizes, each behind its head; None where there is to be written. The last side
        of a wide equation stands in further lines, the equals signs one under the other."""
        head, parts = ((), *self.heads), [self.columns]
        columns = [head, *self.columns]
        wide = sum(_GAP + max(width(label, LETTERS) for label in each) if each else _BLANK for each in columns)
        cut = max((k for k, column in enumerate(self.columns) if column and column[0] == plain("=")), default=0)
        if wide > _WIDE and cut > 1:
            parts = [self.columns[:cut], (((), (), ()), *self.columns[cut:])]
        long = max(map(len, parts))
        return [[each[k] if each is not None else None for each in (head, *part)] + [()] * (long - len(part))
                for part in parts for k in range(3)]  # fmt: skip


@frozen
class BlankLine:
    """Words in a line, each with room to write behind it."""

    words: tuple[Label, ...]


@frozen
class NameLine(BlankLine):
    """The line above a problem that a student fills in: each further page bears the first of its words."""


@frozen
class HandoutPicture:
    """A drawing in its true size, in words what it shows, and its number: `Fig. 1`, with a note behind it; `of_all`: it
    stands between the question of a problem and the room for answers."""

    sheet: Sheet
    words: str
    number: str = ""
    of_all: bool = False
    note: str = ""


@frozen
class HandoutTable:
    """Rows under their heads; an empty label is room to write, unless all is `printed`; `under`: the width of gridded
    paper above it [mm]."""

    heads: tuple[Label, ...]
    rows: tuple[tuple[Label, ...], ...]
    under: float = 0.0
    printed: bool = False

    @property
    def row(self) -> float:
        """The height of a row [mm]: of many there is less room for each."""
        return 5.7 if self.printed else 7.5 if len(self.rows) <= (_FEW if self.under else _MANY) else 6.0


@frozen
class GridRoom:
    """Gridded paper [mm] with the pole, from the left upper corner, y down, and one direction through it [rad]; words:
    what is drawn there, for the polygon of this plane at this scale [SI units per mm], which needs so much above and
    below its pole."""

    words: str
    width: float
    height: float
    pole: complex
    name: Label
    direction: float
    mark: Label
    plane: Plane
    scale: float
    above: float = inf
    below: float = inf

    def lower(self, by: float) -> GridRoom:
        """Cut by so much, at lines of the grid, above and below as there is room beside what the polygon needs; all of
        it where there is not as much, so that no height tells of the polygon."""
        over, under = (GRID * max(0, int(free / GRID)) for free in (
            self.pole.imag - self.above, self.height - self.pole.imag - self.below))  # fmt: skip
        cut = GRID * ceil(by / GRID)
        if cut > over + under:
            return self
        top = min(over, max(cut - under, GRID * round(cut * over / (over + under) / GRID)))
        return replace(self, height=self.height - cut, pole=self.pole - 1j * top)


@frozen
class NewPage:
    """A page break; `front`: on the front of a sheet that is printed on both sides."""

    front: bool = False


@frozen
class Foot:
    """The foot of every page; digest: the beginning of the file's SHA-256, where that is one; seed: of the set."""

    stage: str
    version: str
    digest: str
    seed: str
    bar: str

    @property
    def words(self) -> str:
        return " · ".join(filter(None, ("graphkin " + self.version, self.stage, self.seed, self.digest)))


@frozen
class HandoutPart:
    """The beginning of a part in this language, on pages with this foot; contents: the head of its list of problems."""

    lang: Lang
    foot: Foot
    contents: str = ""


Block = (
    HandoutPart | HandoutHeading | BlankLine | Paragraph | FormulaLine | TermRows | HandoutPicture | HandoutTable
    | GridRoom | NewPage
)  # fmt: skip


@bulky
class Handout:
    """One or several problems, in one language or in both: each begins with a part of its own.

    owners  of each problem the name of its mechanism, and the id of the student it is for, or ""
    """

    title: str
    lang: Lang
    blocks: tuple[Block, ...]
    owners: tuple[tuple[str, str], ...] = ()

    @property
    def parts(self) -> list[tuple[HandoutPart, list[Block]]]:
        """Each part with what is in it."""
        parts: list[tuple[HandoutPart, list[Block]]] = []
        for block in self.blocks:
            if isinstance(block, HandoutPart):
                parts.append((block, []))
            else:
                parts[-1][1].append(block)
        return parts
