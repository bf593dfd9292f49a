"""The gallery is what graphkin draws now, and every drawing in it passes its check."""

from __future__ import annotations

import pytest
from gallery import FEEDBACK, FIGURES, differences, drawings, feedback

from graphkin import library
from graphkin.check import measure


@pytest.mark.parametrize("name", [*library.names(), FEEDBACK])
def test_gallery(name: str):
    chinese = name in library.names()[::3]  # the others differ from English ones in their words alone
    for path, text in feedback() if name == FEEDBACK else drawings(name, chinese):
        old = FIGURES / path
        found = list(differences(old.read_text("utf-8"), text))
        if found:
            new = old.with_suffix(".new.svg")
            new.write_text(text, encoding="utf-8", newline="\n")
            pytest.fail(f"{new} differs from {old.name}: {found[:3]}; rebuild with tests/gallery.py if it is right")


SHEETS = sorted(path for path in FIGURES.glob("*/*.svg") if path.parent.name != FEEDBACK)


@pytest.mark.parametrize("path", SHEETS[::3], ids=lambda path: path.name)
def test_gallery_is_good(path):
    assert measure(path).passed(0.01)


def test_gallery_is_whole():
    assert {path.name for path in FIGURES.iterdir() if path.is_dir()} == {*library.names(), FEEDBACK}
