"""The base of all errors: a place, data, and one sentence a language made of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import ClassVar, Literal, NamedTuple, dataclass_transform

from graphkin.base.value import filled, frozen

Lang = Literal["en", "zh"]
WordTable = Mapping[str, tuple[str, str]]  # English, Chinese


@frozen
class Where:
    """A place in a mechanism file: `shaper.toml:14, links.4.DE`."""

    file: str
    line: int | None = None
    key: str = ""

    def __str__(self) -> str:
        file = self.file.replace("\n", "\\n")
        place = file if self.line is None else f"{file}:{self.line}"
        return ", ".join(filter(None, (place, self.key)))


NOWHERE = Where("")  # stands until the one who knows the place fills it in (`GraphkinError.at`)


@dataclass_transform(eq_default=False)
class GraphkinError(Exception):
    """Something the user can mend. Exit status 3 at the command line.

    A subclass names its data as a dataclass does, and has its sentence in English and in Chinese; a field that is a key
    of a table is said in the table's words: `class WrongType(LocatedError, expected=KINDS)`.
    """

    __match_args__: ClassVar[tuple[str, ...]] = ()
    en: ClassVar[str] = ""
    zh: ClassVar[str] = ""
    exit_code: ClassVar[int] = 3
    _tables: ClassVar[Mapping[str, WordTable]] = {}

    def __init_subclass__(cls, **tables: WordTable) -> None:
        cls._tables = {**cls._tables, **tables}
        cls.__doc__ = cls.__doc__ or cls.en
        filled(cls)

    def message(self, lang: Lang = "en") -> str:
        """The sentence, with this error's own data in it."""
        text = (self.zh if lang == "zh" else self.en).format(**self._words(lang)).rstrip()
        # nothing may steer a terminal, wherever it came from: names of files, words of a command
        return "".join(ascii(letter)[1:-1] if letter != "\n" and steers(letter) else letter for letter in text)

    def at(self, where: Where, **more: object) -> GraphkinError:
        """The same error at a place, for those that were raised with `NOWHERE`; with more data that is known there."""
        moved: Callable[..., GraphkinError] = type(self)
        return moved(**{**self._data(), "where": where, **more})

    def _words(self, lang: Lang) -> dict[str, object]:
        """The data as the sentence takes them: names are listed as the language does, by `{names:,}` with commas."""
        return {
            name: _Names(value, lang) if isinstance(value, tuple) and all(isinstance(x, str) for x in value) else value
            for name, value in self._data().items()
        } | {name: table[getattr(self, name)][lang == "zh"] for name, table in self._tables.items()}

    def _data(self) -> dict[str, object]:
        return {name: getattr(self, name) for name in self.__match_args__}

    def __str__(self) -> str:
        return self.message("en")

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.message()!r})"

    def __reduce__(self) -> tuple[type[GraphkinError], tuple[object, ...]]:
        return type(self), tuple(self._data().values())


def steers(letter: str) -> bool:
    """True of a character that steers a screen or a printer instead of showing something, or may stand in no text.
    Controls, lone halves of characters, ends of lines and paragraphs, marks that turn the direction of reading, and
    what Unicode calls noncharacters. Letters too new for this Python are not among them."""
    if letter.isprintable():
        return False
    number = ord(letter)
    return any(low <= number <= high for low, high in _STEERING) or number & 0xFFFE == 0xFFFE


_STEERING = (
    (0x00, 0x1F), (0x7F, 0x9F), (0x2028, 0x202E), (0x2066, 0x2069), (0xD800, 0xDFFF), (0xFDD0, 0xFDEF), (0xFFF9, 0xFFFB)
)  # fmt: skip


class LocatedError(GraphkinError):
    """An error at a place: in a file, in an option of a command, in an argument of a call."""

    where: Where


class AboutText(LocatedError):
    """An error about what somebody wrote."""

    given: str


class AboutLink(LocatedError):
    link: str


class Choice(AboutText):
    """Something named that is not there: `{hint}` says what is, the nearest first."""

    possible: tuple[str, ...]

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "hint": _hint(self.given, self.possible, lang)}


def _hint(given: str, possible: Sequence[str], lang: Lang) -> str:
    """`Did you mean B? There are A, B, C.`"""
    import difflib

    folded = {name.casefold(): name for name in reversed(possible)}
    near = [folded[name] for name in difflib.get_close_matches(str(given).casefold(), list(folded), 1, 0.5)]
    shown = ", ".join(possible[:40]) + (", .." if len(possible) > 40 else "")
    if lang == "zh":
        ask = "".join(f"是否为 {name}？" for name in near)
        return ask + (f"可用：{shown}。" if shown else "")
    ask = "".join(f"Did you mean {name}? " for name in near)
    return ask + (f"Possible: {shown}." if shown else "")


class _Names(NamedTuple):
    names: tuple[str, ...]
    lang: Lang

    def __format__(self, form: str) -> str:
        return ", ".join(self.names) if form == "," else listed(self.names, self.lang)


def listed(names: Iterable[str], lang: Lang) -> str:
    """`2 and 3`; `2、3`."""
    names = list(names)
    if lang == "zh" or len(names) < 2:
        return "、".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


class AboutLinks(LocatedError):
    """An error about several links, listed as the language does."""

    links: tuple[str, ...]


class Several(GraphkinError):
    """All that is wrong with one file, in the order of its lines."""

    problems: tuple[GraphkinError, ...]

    def message(self, lang: Lang = "en") -> str:
        return "\n".join(problem.message(lang) for problem in self.problems)
