"""The gallery is what graphkin draws now, and every drawing in it passes its check."""

from __future__ import annotations

import pytest
from gallery import FEEDBACK, FIGURES, HANDOUT, PATH, differences, drawings, special, worksheet

from graphkin.check import measure
from graphkin.files import library


@pytest.mark.parametrize("name", [*library.names(), FEEDBACK, PATH])
def test_gallery(name: str):
    chinese = name in library.names()[::3]  # the others differ from English ones in their words alone
    for path, text in special(name) if name in (FEEDBACK, PATH) else drawings(name, chinese):
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
    assert {path.name for path in FIGURES.iterdir() if path.is_dir()} == {*library.names(), FEEDBACK, PATH}


def test_the_picture_of_a_worksheet_is_of_now():
    """As far as other letters of the same size leave it alike: in spots of a few millimetres."""
    image, numpy = pytest.importorskip("PIL.Image"), pytest.importorskip("numpy")
    pytest.importorskip("typst")
    now, kept = worksheet(), image.open(FIGURES / f"{HANDOUT}.png")
    assert now.size == kept.size
    spots = [numpy.asarray(each.convert("L").resize((90, 64), image.Resampling.BOX), dtype=float) for each in (now, kept)]
    assert numpy.abs(spots[0] - spots[1]).max() < 60
    assert numpy.abs(spots[0] - spots[1]).mean() < 1.5
