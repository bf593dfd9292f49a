"""The entries of a derivation, data that a page or a handout sets in its own way, and their lines in a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.planning.method import Act
from graphkin.say.catalogue import close, say
from graphkin.say.figures import Formula, written
from graphkin.say.numbers import circled, number
from graphkin.say.text_table import aligned, padded, unbraced, width


@frozen
class Heading:
    """The title, or the name of a part; `plane`: what that part draws."""

    text: str
    plane: Plane | None = None


@frozen
class Sentence:
    """A step of the pencil, or a reason; `act`: the act that it says, whose number the drawing bears, too; `row`: the
    relation behind it, or what it finds, for a column of equations; `item`: one of those to which a sentence leads."""

    text: str
    act: Act | None = None
    row: str = ""
    item: bool = False


@frozen
class Calculation:
    """`name = formula = .. = numbers = value unit (note)`.

    numbers  the last formula with its figures put in; "" where that would say nothing new
    value    in `unit`, without a sign where `note` tells the sense
    relation  its first formula has a row in a column of equations: others hang on it
    """

    name: str
    formulas: tuple[str, ...]
    numbers: Formula | str
    value: float
    unit: str
    note: str = ""
    relation: bool = False

    @property
    def text(self) -> str:
        """The whole chain without its note; nothing is 0 of a unit."""
        figures = [self.figures] if self.figures and self.value else []
        return " = ".join([self.name, *self.formulas, *figures, self.result])

    @property
    def result(self) -> str:
        """The value with its unit."""
        return f"{number(self.value)}{'' if self.unit == '°' else ' '}{self.unit}".rstrip() if self.value else "0"

    @property
    def figures(self) -> str:
        """`numbers` with as many digits as give the value as it is printed."""
        return written(self.numbers, self.value) if isinstance(self.numbers, Formula) else self.numbers


@frozen
class TermRow:
    """One term of a vector equation with its two rows as printed: `⊥BD`, `B→A`, `√`, `?`; `ω1 l_AB`, `?`, `0`."""

    name: str
    direction: str
    size: str


@frozen
class VectorEquation:
    """`front = side = side`; `front` is "" where the first side is the motion sought itself."""

    front: str
    sides: tuple[tuple[TermRow, ...], ...]

    @property
    def arrows(self) -> tuple[TermRow, ...]:
        return tuple(arrow for side in self.sides for arrow in side)

    @property
    def columns(self) -> list[tuple[str, str, str]]:
        """Terms and signs, each with its direction and its size under it."""
        columns = [(self.front, "", "")] if self.front else []
        for k, side in enumerate(self.sides):
            columns += [("=", "", "")] if k or self.front else []
            for n, arrow in enumerate(side):
                columns += [("+", "", "")] if n else []
                columns.append((arrow.name, arrow.direction, arrow.size))
        return columns


Entry = Heading | Sentence | Calculation | VectorEquation


def text_lines(entries: Iterable[Entry], lang: Lang) -> Iterator[str]:
    """One line an entry; three a vector equation."""
    for k, entry in enumerate(entries):
        match entry:
            case Heading(text):
                yield from ([""] if k else [])
                yield text
            case Sentence(text, act, _, item):
                number = f"{circled(act.number)} " if act is not None and act.numbered else ""
                yield f"{'    ' if item else '  '}{number}{unbraced(text)}"
            case Calculation():
                note = say("common.note", lang, note=entry.note) if entry.note else ""
                yield unbraced(f"    {entry.text}{close(note) if lang == 'zh' else note}")
            case VectorEquation():
                rows = aligned([*zip(*entry.columns, strict=True)], "^", " ")
                labels = ["", say("derivation.direction row", lang), say("derivation.size row", lang)]
                room = max(map(width, labels))
                for label, row in zip(labels, rows, strict=True):
                    yield f"    {padded(label, room)}  {row}".rstrip()
            case _:
                assert_never(entry)
