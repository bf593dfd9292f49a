"""A template: a mechanism file in which numbers may be ranges, `AB = { from = 20, to = 30, step = 1 }`.

Ranges stand wherever a number does: lengths, angles, speeds, with units as texts (`from = "60 rpm"`). A variant is the
template's own text with numbers in their places: comments and layout stay.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal, InvalidOperation
from pathlib import Path

from graphkin import files as loading
from graphkin.base.value import frozen
from graphkin.errors import NoRange, NotATemplate, TooDeep, Where
from graphkin.files.loader import MechanismFile
from graphkin.files.source import read_text, read_toml
from graphkin.files.toml import replaced_values, value_spans
from graphkin.files.values import is_range
from graphkin.model.mechanism import KeyPath, Mechanism

_NUMBER = re.compile(r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(.*?)\s*", re.S)
_SCALES = re.compile(r"^[ \t]*(?:\[[ \t]*)?scales\b", re.M)
MOST = 100_000  # values that one range has at most


@frozen
class TemplateRange:
    """Evenly spaced values of one number of the file.

    path   its place in the file: ("links", "1", "AB")
    unit   what stands behind each value, "" for a bare number
    """

    path: KeyPath
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

    def numbers(self, student: str, seed: str, attempt: int) -> tuple[int, ...]:
        """A draw: of each range by its place in the file, so that one added elsewhere changes none of the others."""
        digests = (digest(seed, student, str(attempt), each.name) for each in self.ranges)
        return tuple(
            int.from_bytes(bytes_[:8], "big") % each.count for bytes_, each in zip(digests, self.ranges, strict=True)
        )

    def text(self, numbers: Sequence[int]) -> str:
        """The mechanism file with the value of each range that has this number."""
        values = [each.value(number) for each, number in zip(self.ranges, numbers, strict=True)]
        return "".join(part for pair in zip(self.pieces, [*values, ""], strict=True) for part in pair)

    def mechanism(self, numbers: Sequence[int]) -> MechanismFile:
        """Raises what loading raises."""
        return self._read(self.text(numbers))

    def at_scales(self, mechanism: Mechanism, scales: Mapping[str, float]) -> MechanismFile:
        """A problem whose file has these scales of the paper."""
        text = mechanism.text
        if _SCALES.search(text):
            return self._read(replaced_values(text, {("scales", key): scale for key, scale in scales.items()}))
        more = "".join(f"{key} = {scale}\n" for key, scale in scales.items())
        return self._read(f"{text.rstrip()}\n\n[scales]\n{more}")

    def _read(self, text: str) -> MechanismFile:
        return loading.loads(text, name=self.name, file=self.file)


def digest(*parts: str) -> bytes:
    """Draws hang on nothing but these words."""
    return hashlib.sha256("\0".join(parts).encode("utf-8", "surrogatepass")).digest()


def read_template(path: Path) -> Template:
    """Raises NotATemplate, NoRange, TooDeep, and what reading a mechanism file raises."""
    file = str(path)
    text = read_text(path).removeprefix("\ufeff")
    document, lines = read_toml(text, file)
    try:
        tables = {path: table for path, table in _tables(document, ()) if is_range(table)}
        spans = {path: span for path, span in value_spans(text).items() if path in tables}
    except RecursionError:
        raise TooDeep(Where(file)) from None
    if not spans:
        raise NotATemplate(Where(file))
    keys = (Where(file, lines.get(path), ".".join(map(str, path))) for path in spans)
    ranges = tuple(_range(tables[path], path, where) for path, where in zip(spans, keys, strict=True))
    edges = [0, *(edge for span in spans.values() for edge in span), len(text)]
    pieces = tuple(text[start:end] for start, end in zip(edges[::2], edges[1::2], strict=True))
    return Template(path.stem, file, pieces, ranges)


def _tables(value: object, path: KeyPath) -> Iterator[tuple[KeyPath, Mapping[str, object]]]:
    """All tables of a file by their keys."""
    if isinstance(value, dict):
        yield path, value
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _tables(inner, (*path, key))


def _range(table: Mapping[str, object], path: KeyPath, where: Where) -> TemplateRange:
    try:
        parts = {"step": 1, **table}
        (first, unit), (last, other), (step, third) = (_sized(parts.pop(key)) for key in ("from", "to", "step"))
        if parts:
            raise NoRange(where)
    except (InvalidOperation, KeyError, ValueError):
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
