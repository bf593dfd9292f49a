"""A template: a mechanism file in which numbers may be ranges, `AB = { from = 20, to = 30, step = 1 }`.

Ranges stand wherever a number does: lengths, angles, speeds, with units as texts (`from = "60 rpm"`). A variant is the
template's own text with numbers in their places: comments and layout stay.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal, InvalidOperation
from pathlib import Path

from graphkin import files as loading
from graphkin.base.value import frozen
from graphkin.errors import BrokenToml, NoRange, NotATemplate, Where
from graphkin.files.source import read_text, read_toml
from graphkin.files.toml import parsed, replaced_values
from graphkin.model.mechanism import Mechanism

_SPAN = re.compile(r"""\{(?:[^{}"'#]|"[^"\n]*"|'[^'\n]*')*\}""")
_NUMBER = re.compile(r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(.*?)\s*", re.S)
_SCALES = re.compile(r"^[ \t]*(?:\[[ \t]*)?scales\b", re.M)
_MARK = 7_310_000_000_000
MOST = 100_000  # values that one range has at most


@frozen
class TemplateRange:
    """Evenly spaced values of one number of the file.

    path   its place in the file: ("links", "1", "AB")
    unit   what stands behind each value, "" for a bare number
    """

    path: tuple[str | int, ...]
    first: Decimal
    step: Decimal
    count: int
    unit: str

    def value(self, number: int) -> str:
        """Its text in the file, `24` or `"60 rpm"`."""
        text = f"{(self.first + number * self.step).normalize():f}"
        return f'"{text} {self.unit}"' if self.unit else text

    @property
    def name(self) -> str:
        return ".".join(str(part) for part in self.path)


@frozen
class Template:
    """A template's text taken apart.

    pieces  the text between the ranges, one more than there are ranges
    """

    name: str
    file: str
    pieces: tuple[str, ...]
    ranges: tuple[TemplateRange, ...]

    def text(self, numbers: Sequence[int], scales: Mapping[str, float] | None = None) -> str:
        """The mechanism file with the value of each range that has this number, and with these scales of the paper."""
        values = [each.value(number) for each, number in zip(self.ranges, numbers, strict=True)]
        text = "".join(part for pair in zip(self.pieces, [*values, ""], strict=True) for part in pair)
        if not scales:
            return text
        if _SCALES.search(text):
            return replaced_values(text, {("scales", key): scale for key, scale in scales.items()})
        return f"{text.rstrip()}\n\n[scales]\n" + "".join(f"{key} = {scale}\n" for key, scale in scales.items())

    def mechanism(self, numbers: Sequence[int], scales: Mapping[str, float] | None = None) -> Mechanism:
        """Raises what loading raises."""
        return loading.loads(self.text(numbers, scales), name=self.name, file=self.file)


def read_template(path: Path) -> Template:
    """Raises NotATemplate, NoRange, and what reading a mechanism file raises."""
    file = str(path)
    text = read_text(path).removeprefix("\ufeff")
    _, lines = read_toml(text, file)
    spans = list(_ranges_in(text))
    if not spans:
        raise NotATemplate(Where(file))
    paths = _places(text, spans, file)
    tables = (parsed(f"x = {text[start:end]}")["x"] for start, end in spans)
    keys = (Where(file, lines.get(path), ".".join(map(str, path))) for path in paths)
    ranges = tuple(_range(table, path, where) for table, path, where in zip(tables, paths, keys, strict=True))
    edges = [0, *(edge for span in spans for edge in span), len(text)]
    pieces = tuple(text[start:end] for start, end in zip(edges[::2], edges[1::2], strict=True))
    return Template(path.stem, file, pieces, ranges)


def _ranges_in(text: str) -> Iterator[tuple[int, int]]:
    """The start and end of each range, outside of comments."""
    for match in _SPAN.finditer(text):
        line = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
        if "#" in re.sub(r""""[^"\n]*"|'[^'\n]*'""", "", line):
            continue
        try:
            table = parsed(f"x = {match.group()}")["x"]
        except ValueError:
            continue
        if {"from", "to"} <= table.keys() <= {"from", "to", "step"}:
            yield match.span()


def _places(text: str, spans: Sequence[tuple[int, int]], file: str) -> list[tuple[str | int, ...]]:
    """The key of each range: a number of its own is put in its place, and looked for in what is read."""
    marked, end = "", 0
    for k, (start, stop) in enumerate(spans):
        marked, end = f"{marked}{text[end:start]}{_MARK + k}", stop
    try:
        paths = dict(_marked_numbers(parsed(marked + text[end:]), ()))
    except (ValueError, RecursionError) as problem:
        raise BrokenToml(Where(file), str(problem)) from None
    if set(paths) != set(range(len(spans))):
        raise NoRange(Where(file))
    return [paths[k] for k in range(len(spans))]


def _marked_numbers(value: object, path: tuple[str | int, ...]) -> Iterator[tuple[int, tuple[str | int, ...]]]:
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _marked_numbers(inner, (*path, key))
    elif type(value) is int and value >= _MARK:
        yield value - _MARK, path


def _range(table: Mapping[str, object], path: tuple[str | int, ...], where: Where) -> TemplateRange:
    try:
        (first, unit), (last, other), (step, third) = (_sized(table.get(key, 1)) for key in ("from", "to", "step"))
    except (InvalidOperation, ValueError):
        raise NoRange(where) from None
    units = {name for name in (unit, other, third) if name}
    if len(units) > 1 or not (step > 0 and last > first and (last - first) / step < MOST):
        raise NoRange(where)
    return TemplateRange(path, first, step, int((last - first) / step) + 1, next(iter(units), ""))


def _sized(value: object) -> tuple[Decimal, str]:
    """A number and its unit. Raises ValueError, InvalidOperation."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise ValueError
    match = _NUMBER.fullmatch(str(value))
    if match is None or len(match[1]) > 30:
        raise ValueError
    number = Decimal(match[1])
    if not abs(number) < Decimal(10) ** 12:
        raise ValueError
    return number, match[2]
