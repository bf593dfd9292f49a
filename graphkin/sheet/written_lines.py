"""Short texts one after another, broken into lines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.base.value import frozen
from graphkin.sheet.lettering import Label, joined, width
from graphkin.sheet.marks import Place, Text

_PITCH = 1.45
"""From base line to base line, as a part of the letters' size."""


@frozen
class WrittenLines:
    """Lines of letters of one size [mm]."""

    lines: tuple[Label, ...]
    letters: float

    @classmethod
    def of(cls, labels: Sequence[Label], room: float, letters: float, between: str = ",  ") -> WrittenLines:
        """As many labels on each line as fit its width [mm]."""
        lines: list[list[Label]] = []
        for label in labels:
            if lines and width(joined([*lines[-1], label], between), letters) <= room:
                lines[-1].append(label)
            else:
                lines.append([label])
        return cls(tuple(joined(line, between) for line in lines), letters)

    @property
    def size(self) -> complex:
        """Width and height [mm]."""
        wide = max((width(line, self.letters) for line in self.lines), default=0.0)
        return complex(wide, _PITCH * self.letters * len(self.lines))

    def marks(self, corner: Place, step: int | None = None) -> Iterator[Text]:
        """From their upper left corner."""
        for k, line in enumerate(self.lines):
            yield Text(line, corner + 1j * self.letters * (_PITCH * k + 1.0), self.letters, step)
