"""Answers as sixty students with different habits write them: each is read, or its reason is told; none is 0."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import pytest

from graphkin import api
from graphkin.errors import NOWHERE
from graphkin.submissions import Limits
from graphkin.submissions.answers import answers
from graphkin.submissions.grammar import WORDS
from graphkin.submissions.questions import Questions

QUESTIONS = Questions(api.load("ex3-1"))
LINES = Path(__file__).with_name("answers_as_written.txt").read_text("utf-8").splitlines()
ROWS = [line.rsplit("|", 3) for line in LINES if not line.startswith("# ")]
WAYS = {"left": 180, "down": 270, "right": 0, "up": 90, "down-left": 225, "up-right": 45}


@pytest.mark.parametrize(("text", "question", "expected", "direction"), [[cell.strip() for cell in row] for row in ROWS])
def test_an_answer_as_it_is_written(text: str, question: str, expected: str, direction: str):
    found = answers([(question, text, NOWHERE)], QUESTIONS, Limits()).values.get(question)
    if expected == "nothing":
        assert found is None
        return
    assert found is not None
    if expected == "not read":
        assert found.value is None
        assert found.text == text
        assert found.fault is not None
        assert all(found.fault.message(lang) for lang in ("en", "zh"))
        return
    assert found.fault is None, found.fault.message("en")
    assert found.value is not None
    value = abs(found.value) if direction else found.value
    assert value == pytest.approx(float(expected), rel=2e-5)
    if not direction:
        assert found.vector is None
        return
    assert found.vector is not None
    assert abs(found.vector) == pytest.approx(float(expected), rel=2e-5)
    assert found.within == (WORDS if direction in WAYS else 0.0)
    degrees = math.radians(WAYS[direction] if direction in WAYS else float(direction))
    assert cmath.phase(found.vector / cmath.rect(1, degrees)) == pytest.approx(0, abs=1e-4)


def test_there_are_enough_of_them():
    assert len(ROWS) >= 300
