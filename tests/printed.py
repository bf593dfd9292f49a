"""Reads the printed equations back and computes them: a small parser of the text, which knows nothing of its writer.

Every value carries a bound of its rounding error in units of the machine's, so that what cancels is judged fairly.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

SUPER = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
NUMBER = re.compile(r"(\d+(?:\.\d+)?)(?:·10\^\((−?\d+)\))?(°?)")
MORE = re.compile(r"(?![⁰¹²³⁴⁵⁶⁷⁸⁹])[\w'/]")
"""What follows a name that is only the beginning of a longer one."""
FUNCTION = re.compile(r"(cos|sin|tan|atan2)([⁰¹²³⁴⁵⁶⁷⁸⁹]*)")


@dataclass
class Quantity:
    """A number or a matrix, and how far it may be off."""

    value: np.ndarray
    error: np.ndarray

    @classmethod
    def of(cls, value) -> Quantity:
        value = np.asarray(value)
        return cls(value, np.abs(value).astype(float))

    def __add__(self, other):
        return Quantity(self.value + other.value, self.error + other.error)

    def __neg__(self):
        return Quantity(-self.value, self.error)

    def __mul__(self, other):
        a, b = self.value, other.value
        if a.ndim == 2 and b.ndim == 2:
            return Quantity(a @ b, self.error @ abs(b) + abs(a) @ other.error)
        return Quantity(a * b, self.error * abs(b) + abs(a) * other.error)

    def __truediv__(self, other):
        a, b = self.value, other.value
        return Quantity(a / b, (self.error + abs(a / b) * other.error) / abs(b))


def call(name: str, args: list[Quantity]) -> Quantity:
    x = args[0]
    if name == "atan2":
        radius = np.hypot(args[0].value, args[1].value)
        return Quantity(np.arctan2(args[0].value, args[1].value), 1 + (args[0].error + args[1].error) / radius)
    value = getattr(np, name)(x.value)
    slope = 1 + value**2 if name == "tan" else 1.0
    return Quantity(value, abs(value) + slope * x.error)


@dataclass
class Parser:
    text: str
    names: Mapping[str, Quantity]
    matrices: list[Quantity]
    sign: int | None = None
    at: int = 0
    used: set[str] = field(default_factory=set)

    def skip(self) -> str:
        while self.at < len(self.text) and self.text[self.at] == " ":
            self.at += 1
        return self.text[self.at] if self.at < len(self.text) else ""

    def take(self, what: str) -> bool:
        if self.skip() and self.text.startswith(what, self.at):
            self.at += len(what)
            return True
        return False

    def whole(self) -> Quantity:
        found = self.sum()
        assert self.skip() == "", f"left over: {self.text[self.at:]!r} of {self.text!r}"
        return found

    def sum(self) -> Quantity:
        total = None
        while True:
            minus = self.take("−")
            if not minus and self.take("±"):
                assert self.sign is not None, "no sign is said"
                minus = self.sign < 0
            elif not minus:
                self.take("+")
            term = self.quotient()
            term = -term if minus else term
            total = term if total is None else total + term
            if self.skip() not in ("+", "−", "±"):
                return total

    def quotient(self) -> Quantity:
        product = self.factor()
        while (c := self.skip()) and c not in "+−±=/),":
            product = product * self.factor()
        return product / self.factor() if self.take("/") else product

    def factor(self) -> Quantity:
        found = self.atom()
        raised = re.match(r"[⁰¹²³⁴⁵⁶⁷⁸⁹]+", self.text[self.at :])
        if raised:
            self.at += raised.end()
            found = self.power(found, int(raised[0].translate(SUPER)))
        return found

    @staticmethod
    def power(of: Quantity, times: int) -> Quantity:
        found = of
        for _ in range(times - 1):
            found = found * of
        return found

    def bracket(self) -> list[Quantity]:
        """After the opening bracket."""
        found = [self.sum()]
        while self.take(","):
            found.append(self.sum())
        assert self.take(")"), f"no bracket closed at {self.text[self.at:]!r}"
        return found

    def atom(self) -> Quantity:
        self.skip()
        rest = self.text[self.at :]
        if self.take("("):
            return self.bracket()[0]
        if self.take("√("):
            inner = self.bracket()[0]
            root = np.sqrt(inner.value)
            return Quantity(root, inner.error / root if root else np.sqrt(inner.error * 1e-16) * 1e16)
        if self.take("e^("):
            power = self.bracket()[0]
            return Quantity(np.exp(power.value), 1 + power.error)
        if self.take("⟦"):
            return self.matrices[int(self.until("⟧"))]
        if function := FUNCTION.match(rest):
            return self.function(function)
        name = max((n for n in self.names if rest.startswith(n) and not MORE.match(rest[len(n) :])), key=len,
                   default=None)  # fmt: skip
        if name is not None:
            self.at += len(name)
            self.used.add(name)
            return self.names[name]
        if found := NUMBER.match(rest):
            self.at += found.end()
            value = float(found[1]) * 10.0 ** int((found[2] or "0").replace("−", "-"))
            return Quantity.of(np.radians(value) if found[3] else value)
        if re.match(r"i(?![\w'])", rest):
            self.at += 1
            return Quantity.of(1j)
        raise AssertionError(f"cannot read {rest!r} of {self.text!r}")

    def until(self, end: str) -> str:
        stop = self.text.index(end, self.at)
        found, self.at = self.text[self.at : stop], stop + 1
        return found

    def function(self, match: re.Match) -> Quantity:
        self.at += match.end()
        args = self.bracket() if self.take("(") else [self.factor()]
        value = call(match[1], args)
        return self.power(value, int(match[2].translate(SUPER))) if match[2] else value


@dataclass
class Equation:
    """A chain of equal sides, with matrices taken out of the text."""

    sides: list[str]
    matrices: list[list[list[str]]]
    sign: int | None = None

    def side(self, k: int, names: Mapping[str, Quantity]) -> tuple[Quantity, set[str]]:
        used: set[str] = set()
        found = []
        for number, rows in enumerate(self.matrices):
            if f"⟦{number}⟧" not in self.sides[k]:
                found.append(Quantity.of(np.nan))
                continue
            cells = [[self._cell(cell, names, used) for cell in row] for row in rows]
            found.append(Quantity(np.array([[c.value for c in row] for row in cells]),
                                  np.array([[c.error for c in row] for row in cells])))  # fmt: skip
        parser = Parser(self.sides[k], names, found, self.sign)
        return parser.whole(), used | parser.used

    @staticmethod
    def _cell(text: str, names: Mapping[str, Quantity], used: set[str]) -> Quantity:
        parser = Parser(text, names, [])
        value = parser.whole()
        used |= parser.used
        return value


@dataclass
class Section:
    title: str
    equations: list[Equation] = field(default_factory=list)


def plain(text: str) -> str:
    """Letters with a combining sign as one character each."""
    return text.replace("s\u0308", "ʂ").replace("s\u0307", "ṡ")


def sections(text: str) -> list[Section]:
    """The displayed equations under each heading; ± as the next sentence says."""
    found, lines, waiting = [Section("")], plain(text).split("\n"), []
    k = 0
    while k < len(lines):
        if k + 1 < len(lines) and re.fullmatch(r"-{3,}", lines[k + 1]):
            found.append(Section(lines[k]))
            k += 2
        elif lines[k].startswith("    ") and not _tabular(lines, k):
            block = []
            while k < len(lines) and lines[k].startswith("    "):
                block.append(lines[k])
                k += 1
            for equation in _equations(block):
                found[-1].equations.append(equation)
                if any("±" in side for side in equation.sides):
                    waiting.append(equation)
        else:
            for said in re.finditer(r"±\s*=\s*([+−])", lines[k] + " " + (lines[k + 1] if k + 1 < len(lines) else "")):
                if said.start() < len(lines[k]):
                    for equation in waiting:
                        equation.sign = 1 if said[1] == "+" else -1
                    waiting = []
            k += 1
    assert not waiting, "a ± without its sign"
    return found


def _tabular(lines: list[str], k: int) -> bool:
    """Whether the legend begins here: its block is a table."""
    return any(lines[j] in ("Symbols", "符号说明") for j in range(max(0, k - 400), k))


VALUE = re.compile(r"(−?[\d.]+(?:e−?\d+)?)(?: ([+−]) ([\d.]+(?:e−?\d+)?) i)?(°| .*)?")
UNITS = {"°": np.pi / 180, "mm": 1e-3, "mm·rad": 1e-3}
DIGITS = 6


def legend(text: str, share: float) -> dict[str, Quantity]:
    """The printed values in SI units, each off by half a unit of its last digit; `share`: what an error is counted in."""
    found: dict[str, Quantity] = {}
    rows = re.split(r"\n(?:Symbols|符号说明)\n-+\n", plain(text))[1].split("\n")
    for row in rows[2:]:
        if row.strip():
            name, *_, value = re.split(r" {2,}", row.strip())
            found[name] = _read(value, share)
    return found


def _read(text: str, share: float) -> Quantity:
    real, sign, imag, unit = VALUE.fullmatch(text).groups()
    parts = [float(part.replace("−", "-")) for part in (real, imag and (sign + imag).replace("+", "")) if part]
    off = sum(0.5 * 10.0 ** (np.floor(np.log10(abs(part))) + 1 - DIGITS) for part in parts if part)
    size = UNITS.get((unit or "").strip(), 1.0)
    return Quantity(np.asarray(size * (complex(*parts) if sign else parts[0])), np.asarray(size * off / share))


def _equations(block: list[str]) -> list[Equation]:
    """Rows of one display: a line each, or as many lines as the matrices in it are high."""
    block[-1] = re.sub(r"\s{3,}\(\d+\)$", "", block[-1])
    found, k = [], 0
    while k < len(block):
        end, opened = k + 1, block[k].count("⎡")
        opened -= block[k].count("⎣")
        while opened > 0:
            opened += block[end].count("⎡") - block[end].count("⎣")
            end += 1
        found.append(_equation(block[k:end]))
        k = end
    return found


def _equation(lines: list[str]) -> Equation:
    wide = max(map(len, lines))
    grid = [line.ljust(wide) for line in lines]
    matrices, spans = [], []
    for top, line in enumerate(grid):
        for start in [k for k, c in enumerate(line) if c in "⎡["]:
            stop = line.index("⎤" if line[start] == "⎡" else "]", start)
            bottom = top if line[start] == "[" else next(r for r in range(top, len(grid)) if grid[r][start] == "⎣")
            rows = [re.split(r" {3,}", grid[r][start + 1 : stop].strip()) for r in range(top, bottom + 1)]
            spans.append((start, stop, rows))
    text, at = "", 0
    for start, stop, rows in sorted(spans, key=lambda span: span[0]):
        text += _flat(grid, at, start) + f" ⟦{len(matrices)}⟧ "
        matrices.append(rows)
        at = stop + 1
    text += _flat(grid, at, wide)
    return Equation([side.strip() for side in text.split("=")], matrices)


def _flat(grid: list[str], start: int, stop: int) -> str:
    """What stands beside the matrices, on whichever line."""
    return "".join(next((row[k] for row in grid if row[k] != " "), " ") for k in range(start, stop))
