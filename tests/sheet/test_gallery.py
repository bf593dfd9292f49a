"""The gallery is what graphkin draws now: feedback, a path, a worksheet, the manual; and it is whole."""

from __future__ import annotations

import re

import pytest
from gallery import FEEDBACK, FIGURES, HANDOUT, MANUAL, PATH, changed, differences, manual, special, worksheet

from graphkin.check import measure
from graphkin.errors import Lang
from graphkin.files import library
from graphkin.outputs.markdown import slug

ROUNDING = re.compile(r"[-−]?\d\.\de(?:[-−]1\d|\+00)")  # the last bits of a difference are another processor's


@pytest.mark.parametrize("name", [FEEDBACK, PATH])
def test_gallery(name: str):
    """Sheets of mechanisms are compared with what else is told of them, in tests/cli/test_golden.py."""
    for path, text in special(name):
        assert not changed(path, text)


def test_the_gallery_s_own_files_are_good():
    """Read back as they lie there."""
    assert all(measure(FIGURES / name / f"{name}.svg").passed(0.01) for name in ("ex3-1", "p3-15", PATH))


@pytest.mark.parametrize("name", library.names())
def test_a_drawing_has_the_same_scales_on_the_same_paper_in_both_languages(name: str):
    english, chinese = ((FIGURES / name / f"{name}{end}.svg").read_text("utf-8") for end in ("", "-zh"))
    (ours,), (theirs,) = (re.findall(r"<desc>(.*?)</desc>", text) for text in (english, chinese))
    scales = [re.findall(r"= ([\d.e-]+)", told) for told in (ours, theirs)]
    assert scales[0] == scales[1] != []
    assert english.partition("viewBox")[2][:16] == chinese.partition("viewBox")[2][:16]


def test_gallery_is_whole():
    assert {path.name for path in FIGURES.iterdir() if path.is_dir()} == {*library.names(), FEEDBACK, PATH, MANUAL}


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_the_manual_is_of_now(lang: Lang):
    """Its texts but for the breaking of lines, its drawings but for that of another package; its links lead somewhere."""
    *drawn, (path, page) = manual(lang)
    kept = (FIGURES / path).read_text("utf-8")
    pairs = zip(kept.split("\n\n"), page.split("\n\n"), strict=False)
    anew = [new for old, new in pairs if ROUNDING.sub("", old).split() != ROUNDING.sub("", new).split()]
    assert (anew[:1], kept.split()[-9:]) == ([], page.split()[-9:]), "rebuild with tests/gallery.py manual"
    for name, svg in drawn:
        old = (FIGURES / name).read_text("utf-8")
        assert name.stem.startswith("sweep") or not list(differences(old, svg)), name
    contents = re.findall(r"\]\((#.*?)\)", page.split("\n\n")[3])
    assert len(set(contents)) == len(contents) > 30, "each link leads somewhere else"
    heads = {slug(head) for head in re.findall("(?m)^#+ (.*)", page)}
    links = re.findall(r"\]\((?!http)([^)]+)\)|(?:src|href)=\"([^\"]+)", re.sub("(?ms)^ *```.*?^ *```$", "", page))
    assert len(links) > 150
    for link in map("".join, links):
        assert link[1:] in heads if link[0] == "#" else (FIGURES / MANUAL / link).is_file(), link


def test_the_picture_of_a_worksheet_is_of_now():
    """As far as other letters of the same size leave it alike: in spots of a few millimetres."""
    image, numpy = pytest.importorskip("PIL.Image"), pytest.importorskip("numpy")
    pytest.importorskip("typst")
    now, kept = worksheet(), image.open(FIGURES / f"{HANDOUT}.png")
    assert now.size == kept.size
    spots = [numpy.asarray(each.convert("L").resize((90, 64), image.Resampling.BOX), dtype=float) for each in (now, kept)]
    assert numpy.abs(spots[0] - spots[1]).max() < 60
    assert numpy.abs(spots[0] - spots[1]).mean() < 1.5
