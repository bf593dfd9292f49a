"""Puts printed formulas into a calculator, which knows nothing of their writer."""

from __future__ import annotations

import re
from itertools import pairwise
from math import radians, sin

NUMBER = r"−?\d+(?:\.\d+)?(?:e−?\d+)?"
FORMULA = re.compile(r"[−(]*\d[\d.e−+×/²() ]*(?:[×/²+]| − )[\d.e−+×/²() ]*")
RESULT = re.compile(rf"{NUMBER}")


def calculated(formula: str) -> float:
    formula = re.sub(r"sin ([\d.]+)°", lambda found: repr(sin(radians(float(found[1])))), formula)
    python = formula.replace("−", "-").replace("×", "*").replace("²", "**2")
    assert re.fullmatch(r"[-0-9.e*/+() ]+", python), formula
    return float(eval(python))


def last_digit(text: str) -> float:
    """The unit of the last digit; of a number of more than four digits before its point, of the fourth."""
    mantissa, _, exponent = text.lstrip("−").partition("e")
    whole, _, part = mantissa.partition(".")
    unit = -len(part) if part else max(0, len(whole) - 4)
    return 10.0 ** (unit + int(exponent.replace("−", "-") or 0))


def chains(line: str) -> list[tuple[str, str]]:
    """Formulas of figures alone, each with the figure after it."""
    found = []
    for formula, after in pairwise(re.split(r" = ", line)):
        if FORMULA.fullmatch(re.sub(r"sin ([\d.]+)°", r"\1", formula.strip())) and (result := RESULT.match(after)):
            found.append((formula.strip(), result[0]))
    return found


def hold(lines: list[str]) -> int:
    """How many formulas there are; each gives what is printed after it."""
    count = 0
    for line in lines:
        for formula, result in chains(line):
            off = abs(calculated(formula) - calculated(result))
            assert off <= 0.5 * last_digit(result) * (1 + 1e-6), line
            count += 1
    return count
