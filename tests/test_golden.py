"""Words, JSON and sheets of every command are what they were; what changes on purpose is rewritten by golden.py."""

from __future__ import annotations

import pytest
from golden import GOLDEN, commands, place, said, unlike

LINES = list(commands())


@pytest.mark.parametrize("line", LINES)
def test_golden(line: str):
    path = place(line)
    assert not unlike(path, path.read_text("utf-8"), said(line))


def test_golden_is_whole():
    assert {path.name for path in GOLDEN.iterdir()} == {place(line).name for line in LINES}
    assert len({place(line) for line in LINES}) == len(LINES)
