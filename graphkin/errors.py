"""What a user can get wrong, as data; the sentences stand here once, in both languages.

Every error says three things: where (file, line, key), what is wrong, what to do. Code raises
the data; only the edge (the command line, a notebook) asks for the words.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import ClassVar, Literal

Lang = Literal["en", "zh"]

__all__ = ["GraphkinError", "Lang", "Several", "Where"]


@dataclass(frozen=True, slots=True)
class Where:
    """A place in a mechanism file: `shaper.toml:14, links.4.DE`."""

    file: str
    line: int | None = None
    key: str = ""

    def __str__(self) -> str:
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{place}, {self.key}" if self.key else place


@dataclass(eq=False)
class GraphkinError(Exception):
    """Something the user can mend. Exit status 3 at the command line."""

    text: ClassVar[dict[Lang, str]] = {"en": "", "zh": ""}
    exit_code: ClassVar[int] = 3

    def message(self, lang: Lang = "en") -> str:
        """The sentence, with this error's own data in it."""
        return self.text[lang].format(**self._words(lang))

    def _words(self, lang: Lang) -> dict[str, object]:
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def __str__(self) -> str:
        return self.message("en")


@dataclass(eq=False)
class Several(GraphkinError):
    """All that is wrong with one file, in the order of its lines."""

    problems: tuple[GraphkinError, ...]

    def message(self, lang: Lang = "en") -> str:
        return "\n".join(problem.message(lang) for problem in self.problems)
