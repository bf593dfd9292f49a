"""Example 3-1 at the scales of the book: one millimetre is 0.001 m, 0.01 m/s and 0.1 m/s²."""

from __future__ import annotations

from pathlib import Path

from graphkin.files import loads
from graphkin.model.mechanism import Mechanism

TEXT = (Path(__file__).parent / "cases" / "book-scales.toml").read_text(encoding="utf-8")


def example() -> Mechanism:
    return loads(TEXT, name="ex3-1", file="ex3-1.toml")
