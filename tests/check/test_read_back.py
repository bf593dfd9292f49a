"""Whatever graphkin draws, check measures and finds right; whatever is moved by 0.02 mm, it finds wrong.

GRAPHKIN_RANDOM=2000 draws so many random mechanisms; GRAPHKIN_MOVED=all moves every coordinate there is.
"""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

import pytest
from reading_back import FAMILIES, drawn, make, read_back, wrong

from graphkin.errors import BadDrawing

EACH = max(1, int(os.environ.get("GRAPHKIN_RANDOM", "0")) // len(FAMILIES))
MOVED = os.environ.get("GRAPHKIN_MOVED", "")


def moved(text: str) -> list[str]:
    """The drawing with one coordinate of one mark moved by 0.02 mm, for every one there is, or some."""
    found = []
    for element in re.finditer(r"<(?:line|circle)\b[^>]*class=\"(?:vector|point|link)\"[^>]*>", text):
        if 'data-form="guide"' in element.group():
            continue  # a guide may be longer or shorter
        for coordinate in re.finditer(r'\b(x1|y1|x2|y2|cx|cy)="([^"]*)"', element.group()):
            new = f'{coordinate[1]}="{float(coordinate[2]) + 0.02:.4f}"'
            at = element.start() + coordinate.start()
            found.append(text[:at] + new + text[at + len(coordinate[0]) :])
    return found


@pytest.mark.many(6)
@pytest.mark.parametrize("family", FAMILIES)
def test_every_random_drawing_is_good_and_anything_moved_is_seen(family: str, tmp_path: Path):
    for seed in range(EACH):
        if (text := drawn(family, seed)) is not None:
            assert not wrong(read_back(tmp_path, text, make(family, seed))), seed
    mechanism, text = make(family, 0), drawn(family, 0)
    assert text is not None
    changes = moved(text)
    for changed in changes if MOVED else random.Random(family).sample(changes, 2):
        try:
            assert wrong(read_back(tmp_path, changed, mechanism))
        except BadDrawing:
            pass
