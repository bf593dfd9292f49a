"""Words, JSON and sheets of every command are what they were; what changes on purpose is rewritten by golden.py, the gallery
by gallery.py, and every drawing in it passes its check."""

from __future__ import annotations

from pathlib import Path

import pytest
from gallery import changed, drawings
from golden import GOLDEN, commands, place, said, unlike

from graphkin.check import measure
from graphkin.files import library

LINES = list(commands())
TOLD = set(library.names()[::3])
"""Of the others no Chinese solution and sheet is made anew: the English ones are made of the same data."""
TELLING = ("solve", "explain", "structure")


def of_a_mechanism(line: str) -> bool:
    """One of those that every mechanism has."""
    return line.split()[0] in TELLING


def compared(line: str) -> bool:
    words = line.split()
    return words[0] != "explain" or "zh" not in words or words[1] in TOLD


def hold(line: str) -> None:
    path = place(line)
    assert not unlike(path, path.read_text("utf-8"), said(line)), line


@pytest.mark.parametrize("line", [line for line in LINES if not of_a_mechanism(line)])
def test_golden(line: str):
    hold(line)


@pytest.mark.parametrize("name", library.names())
def test_a_mechanism_is_told_and_drawn_as_it_was(name: str, tmp_path: Path):
    """One after the other, as all hang on one plan and one arrangement."""
    for line in LINES:
        if of_a_mechanism(line) and line.split()[1] == name and compared(line):
            hold(line)
    for path, text in drawings(name, name in TOLD):
        assert not changed(path, text)
        hold_to_a_ruler(tmp_path / "drawing.svg", text)


def hold_to_a_ruler(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8")
    report = measure(path)
    assert report.passed(0.01), [m for m in report.measured if m.off_mm > 0.01] + list(report.faults)
    assert max(entry.off_mm for entry in report.measured) < 0.0005


def test_golden_is_whole():
    assert {path.name for path in GOLDEN.iterdir()} == {place(line).name for line in LINES}
    assert len({place(line) for line in LINES}) == len(LINES)
    assert {line.split()[1] for line in LINES if of_a_mechanism(line)} == set(library.names())
