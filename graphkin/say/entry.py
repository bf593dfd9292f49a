"""What a derivation is made of. Every entry is data, so that a page or a handout can set it in its own way."""

from __future__ import annotations

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.planning.method import Act
from graphkin.say.figures import Formula, written
from graphkin.say.numbers import number


@frozen
class Heading:
    """The title, or the name of a part; `plane`: what that part draws."""

    text: str
    plane: Plane | None = None


@frozen
class Sentence:
    """What the pencil does, or why; `act`: which act of it is told, whose number the drawing bears, too."""

    text: str
    act: Act | None = None


@frozen
class Calculation:
    """`name = formula = .. = numbers = value unit (note)`.

    numbers  the last formula with its figures put in; "" where that would say nothing new
    value    in `unit`, without a sign where `note` tells the sense
    """

    name: str
    formulas: tuple[str, ...]
    numbers: Formula | str
    value: float
    unit: str
    note: str = ""

    @property
    def text(self) -> str:
        """The whole chain without its note; nothing is 0 of a unit."""
        figures = [self.figures] if self.figures and self.value else []
        return " = ".join([self.name, *self.formulas, *figures, self.result])

    @property
    def result(self) -> str:
        """The value with its unit."""
        return f"{number(self.value)} {self.unit}".rstrip() if self.value else "0"

    @property
    def figures(self) -> str:
        """`numbers` with as many digits as give the value as it is printed."""
        return written(self.numbers, self.value) if isinstance(self.numbers, Formula) else self.numbers


@frozen
class TermRow:
    """One term of a vector equation with its two rows.

    direction, size   as the rows print them: `⊥BD`, `B→A`, `√`, `?`; `ω1 l_AB`, `√`, `?`, `0`
    value, length_mm  its size in SI units, and on paper
    ends              the points of the polygon between which it lies
    """

    name: str
    direction: str
    size: str
    value: float
    length_mm: float
    ends: tuple[str, str]

    @property
    def size_known(self) -> bool:
        return self.size != "?"

    @property
    def direction_known(self) -> bool:
        return self.direction != "?"


@frozen
class VectorEquation:
    """`front = side = side`; `front` is "" where the first side is the motion sought itself."""

    front: str
    sides: tuple[tuple[TermRow, ...], ...]

    @property
    def arrows(self) -> tuple[TermRow, ...]:
        return tuple(arrow for side in self.sides for arrow in side)


Entry = Heading | Sentence | Calculation | VectorEquation
