"""The page that a student gets back: what the picture shows, how much of it is told, whose drawing lies over it."""

from __future__ import annotations

import cmath
import os
import re
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest
import random_mechanisms

from graphkin.construction import Plot
from graphkin.errors import Where
from graphkin.files import library
from graphkin.homework import grading, platforms
from graphkin.homework.platforms.feedback import Feedback
from graphkin.homework.platforms.pages import drawing, html
from graphkin.homework.platforms.result import Result
from graphkin.marking import Rewrite, rewrites, rewritten
from graphkin.marking.consequences import DrawingComparison, compare_drawings
from graphkin.outputs import marks_json
from graphkin.outputs.marks_json import drawn_of, record
from graphkin.outputs.svg import inline, svg
from graphkin.planning import Method, plan
from graphkin.running import replay_all
from graphkin.say.catalogue import say
from graphkin.sheet import Sheet, sheet
from graphkin.sheet.marks import Disc, Text, VectorMark
from graphkin.sheet.mistake_sheet import mistake_sheets
from graphkin.sheet.obstacles import bounds
from graphkin.submissions.submission import MeasuredDrawing

RANDOM = max(1, int(os.environ.get("GRAPHKIN_RANDOM", "800")) // 800)
"""Random mechanisms of each family; more of them, triads too, with GRAPHKIN_RANDOM=8000 in the environment."""
LANGS = ("en", "zh")


@cache
def drawn(name: str) -> tuple[Method, Plot]:
    method = plan(library.load(name))
    return method, replay_all(method)


def made(name: str, *words: str) -> Rewrite:
    """The first mistake that can be made with these words in its name."""
    method, plot = drawn(name)
    return next(one for one in rewrites(method, plot) if set(words) <= {one.id, *one.of, one.form, one.way})


def found(name: str, *mistakes: tuple[str, ...]) -> DrawingComparison:
    return compare_drawings(*drawn(name), [made(name, *words) for words in mistakes])


def ends(of: DrawingComparison) -> dict[str, set[str]]:
    """What is drawn otherwise: arrows as `b2' k'`, and points of images."""
    return {
        plane: {" ".join(sorted(pair)) for pair in of.arrows.get(plane, ())} | of.images.get(plane, frozenset())
        for plane in of.planes
    }


# --- what differs -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "mistakes", "otherwise"),
    [
        ("ex3-1", [("coriolis-omitted",)], {"acceleration": {"b2' k'"}}),
        ("ex3-1", [("driver-reversed",)], {"velocity": {"b2 p"}}),
        ("ex3-1", [("wrong-radius", "⊥BC")], {"velocity": {"b3 p"}, "acceleration": {"n3' p'", "b2' k'"}}),
        ("ex3-1", [("tangential-along", "a^t_B3D")], {"acceleration": {"b3' n3'"}}),
        ("ex3-1", [("wrong-tail", "a^k_B3B2")], {"acceleration": {"b2' k'"}}),
        ("ex3-1", [("other-assembly",)], {"position": set(), "velocity": set(), "acceleration": set()}),
        ("ex3-5", [("image-mirrored",)], {"velocity": {"e"}, "acceleration": {"e'"}}),
        ("ex3-5", [("omega-sense", "omega 2")], {}),
        ("ex3-5", [("normal-omitted", "a^n_CB"), ("image-mirrored", "v, a")],
         {"velocity": {"e"}, "acceleration": {"b' n2'", "e'"}}),
    ],
)  # fmt: skip
def test_what_is_drawn_otherwise(name, mistakes, otherwise):
    assert ends(found(name, *mistakes)) == otherwise


def arrows(of: list[Sheet], name: str) -> list[VectorMark]:
    return [mark for one in of for mark in one.marks if isinstance(mark, VectorMark) and mark.name == name]


def test_both_polygons_are_to_one_scale():
    """MARKING's values of example 3-1: a^r 0.1846 where all is right, 2.168 without Coriolis; a_B2 2.4 in both."""
    picture = mistake_sheets(*drawn("ex3-1"), found=found("ex3-1", ("coriolis-omitted",)))
    right, wrong = (mark.length for mark in arrows(picture, "a_B2"))
    assert right == pytest.approx(wrong)
    lengths = [mark.length / right * 2.4 for mark in arrows(picture, "a^r_B3B2")]
    assert lengths == pytest.approx([0.18463, 2.16789], rel=1e-4)
    thick, gone = arrows(picture, "a^k_B3B2")
    assert (thick.new, gone.length) == (True, pytest.approx(0, abs=1e-9))
    assert [mark.pen for mark in arrows(picture, "a_B2")] == ["leader", "vector"]
    assert not any(mark.new for mark in arrows(picture, "a^r_B3B2"))


@pytest.mark.parametrize("answer", [True, False])
def test_an_arrow_that_is_left_out_has_its_place_marked(answer: bool):
    """Where there is nothing else to be seen of it: not over the right drawing, in which it is."""
    of = found("ex3-1", ("coriolis-omitted",))
    picture = mistake_sheets(*drawn("ex3-1"), found=of, answer=answer)
    rings = [mark for one in picture for mark in one.marks if isinstance(mark, Disc) and mark.new]
    assert len(rings) == (0 if answer else 1)


def test_a_mistake_of_another_size_keeps_the_right_polygon_legible():
    """Three orders of magnitude apart: each at a scale of its own, which is told."""
    picture = mistake_sheets(*drawn("ex3-1"), found=found("ex3-1", ("conversion", "carried", "omega 3", "10³")))
    right, wrong = arrows(picture, "a^n_B3D")
    assert min(right.length, wrong.length) > 3
    assert len({text for text in texts(picture) if "(m/s²)/mm" in text}) == 2


def texts(of: list[Sheet]) -> list[str]:
    return ["".join(run.text for run in mark.label) for one in of for mark in one.marks if isinstance(mark, Text)]


@pytest.mark.parametrize("lang", LANGS)
def test_how_much_is_told(lang):
    """Without the answer there is the wrong drawing alone, and no scale."""
    of = found("ex3-1", ("coriolis-omitted",))
    whole, alone = (mistake_sheets(*drawn("ex3-1"), found=of, answer=answer, lang=lang) for answer in (True, False))
    assert [len(arrows(one, "a^t_B3D")) for one in (whole, alone)] == [2, 1]
    assert [any("mm" in text for text in texts(one)) for one in (whole, alone)] == [True, False]
    assert [say("pictures.under right over", lang) in texts(one) for one in (whole, alone)] == [True, False]


FAMILIES = [random_mechanisms.six_bar, random_mechanisms.epicyclic, *([random_mechanisms.triad] if RANDOM > 1 else [])]


@pytest.mark.parametrize("make", FAMILIES)
@pytest.mark.parametrize("seed", range(RANDOM))
def test_any_mistake_in_any_mechanism(make, seed):
    method = plan(make(seed))
    plot = replay_all(method)
    every = rewrites(method, plot)
    for k in range(seed, len(every), 1 + len(every) // 2):
        of = compare_drawings(method, plot, [every[k], every[-k]])
        own = {plane: points_of(of.other, plane, 1) for plane in ("velocity", "acceleration")}
        picture = mistake_sheets(method, plot, found=of, own=own, answer=bool(k % 2), lang=LANGS[k % 2])
        for one in picture:
            left, top, right, bottom = bounds(one.marks)
            assert (min(left, top), right, bottom) >= (-1, 0, 0)
            assert (right, bottom) <= (one.paper.width + 1, one.paper.height + 1)
            assert inline(one).startswith("<svg")


def points_of(plot: Plot, plane: str, skip: int = 0) -> dict[str, complex]:
    there = {name: complex(value) for name, value in plot.points(plane).items() if cmath.isfinite(complex(value))}
    return dict([*there.items()][skip:])


# --- a drawing that was handed in -------------------------------------------------------------


def test_measured_points_are_turned_back_and_scaled():
    """From the first point on; a plane without a scale has none."""
    turn = cmath.rect(1, 0.3)
    page = {("velocity", "p"): 40 + 7j, ("velocity", "b"): 40 + 7j + 50 * turn, ("acceleration", "p'"): 0j}
    si = MeasuredDrawing(page, {"velocity": 0.01}, {"velocity": 0.3}).in_si()
    assert si == {"velocity": {"p": 0, "b": pytest.approx(0.5)}}


def handed_in(path: Path, name: str, *mistakes: tuple[str, ...]) -> Path:
    """A drawing with mistakes, as a student may have drawn it."""
    method, plot = drawn(name)
    wrong = rewritten(method, plot, [made(name, *words) for words in mistakes])
    page = svg(sheet(method, wrong, only=("velocity", "acceleration")))
    path.write_text(re.sub("<metadata>.*?</metadata>", "", page, flags=re.S), encoding="utf-8")
    return path


def graded(judge: grading.SetMarker, *paths: Path) -> list[Result]:
    return [platforms.from_record(record(one), Where("x")) for one in grading.grade(judge, paths)]


def test_their_polygon_over_both(tmp_path: Path):
    judge = grading.judge_from("ex3-1")
    (result,) = graded(judge, handed_in(tmp_path / "s1.svg", "ex3-1", ("coriolis-omitted",)))
    assert result.drawn["acceleration"]["k'"] == pytest.approx(result.drawn["acceleration"]["b2'"], abs=0.01)
    of = found("ex3-1", ("coriolis-omitted",))
    picture = mistake_sheets(*drawn("ex3-1"), found=of, own=result.drawn)
    right, own = arrows(picture, "a^t_B3D")
    assert (right.pen, own.pen) == ("leader", "vector")
    sizes = [abs(plot.acceleration["b3'"] - plot.acceleration["n3'"]) for plot in (drawn("ex3-1")[1], of.other)]
    assert own.length / right.length == pytest.approx(sizes[1] / sizes[0], rel=1e-3), "it is what they drew"
    assert "(k′)" in texts(picture), "where they have it, beside the right one"
    sentence, alone = platforms.PolygonPictures(judge)(result, "en", "mistake")
    assert b"mm\xe2" not in alone.data
    whole, *both = platforms.PolygonPictures(judge)(result, "en", "answer")
    for told, some in ((sentence, [alone]), (whole, both)):  # of brackets where there are any
        assert (say("pictures.brackets", "en") in told.label) == any(b">(<" in one.data for one in some)
    assert alone.label == f"Acceleration polygon: {sentence.label}", "for those who hear the page"


def test_a_short_arrow_is_magnified():
    """The Coriolis term of example 3-1 in a polygon of which all else is much larger: a circle, and a larger one."""
    found_there = found("ex3-1", ("normal-size", "a_B2", "ω1 l_AB"))
    alone = mistake_sheets(*drawn("ex3-1"), found=found_there, answer=False)
    short, *lens = arrows(alone, "a_B2")
    assert (short.length < 8, short.new) == (True, True)
    assert [(mark.plane, mark.new) for mark in lens] == [("detail", True)]
    assert lens[0].length > 8
    assert any(text.startswith("I′") and ": 1)" in text for text in texts(alone))


def test_right_work_over_the_right_polygon(tmp_path: Path):
    judge = grading.judge_from("ex3-5")
    (result,) = graded(judge, handed_in(tmp_path / "s1.svg", "ex3-5"))
    pictures = platforms.PolygonPictures(judge)
    assert not result.suspicions
    sentence, *polygons = pictures(result, "en", "answer")
    assert (sentence.label, len(polygons)) == ("", 2), "every point lies where it should"
    assert not pictures(result, "en", "mistake")


def test_points_far_off_do_not_spoil_the_figure():
    there = drawn("ex3-1")[1].velocity
    own = {"velocity": {"p": 0j, "b2": there["b2"], "b3": 1e30 + 1e30j, "no such": 1j}, "acceleration": {"b2'": 3j}}
    picture = mistake_sheets(*drawn("ex3-1"), own=own)
    plain = mistake_sheets(*drawn("ex3-1"), own={"velocity": {"p": 0j}, "acceleration": {"p'": 0j}})
    (one,), (two,) = (arrows(of, "v_B3B2") for of in (picture, plain))
    assert one.length > 0.3 * two.length
    assert sum(isinstance(mark, Disc) and mark.pen != "leader" for one in picture for mark in one.marks) == 3


def test_a_drawing_is_kept_for_marking_anew(tmp_path: Path):
    judge = grading.judge_from("ex3-1")
    path = handed_in(tmp_path / "s1.svg", "ex3-1", ("coriolis-half",))
    (first,) = grading.grade(judge, [path])
    marks_json.write(tmp_path / "marks.json", [marks_json.text(record(first))])
    (again,) = grading.grade(judge, [tmp_path / "marks.json"])
    assert again.drawn.keys() == first.drawn.keys() == {"velocity", "acceleration"}
    assert again.drawn["velocity"] == pytest.approx(first.drawn["velocity"], rel=1e-5, abs=1e-6)


@pytest.mark.parametrize("told", [{"colour": {}}, {"velocity": {"p": [1]}}, {"velocity": {"p": [1, "nan"]}}, {"velocity": 3}])
def test_what_is_no_drawing_is_refused(told):
    with pytest.raises((ValueError, TypeError, AttributeError)):
        drawn_of({"drawn": told})


# --- the page ---------------------------------------------------------------------------------


class Reader(HTMLParser):
    """The tags of a page, and whether they close."""

    def __init__(self, page: bytes) -> None:
        super().__init__()
        self.open: list[str] = []
        self.seen: list[str] = []
        self.feed(page.decode("utf-8"))
        self.close()

    def handle_starttag(self, tag, attributes):
        self.seen.append(tag)
        if tag != "meta":
            self.open.append(tag)
        assert not any(value and value.startswith(("http", "//")) for key, value in attributes if "xmlns" not in key)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def answers(path: Path, student: str, text: str) -> Path:
    path.write_text(f"student = '''{student}'''\n[answers]\n{text}", encoding="utf-8")
    return path


@pytest.mark.parametrize("lang", LANGS)
@pytest.mark.parametrize("reveal", ["hint", "mistake", "answer"])
def test_a_page(lang, reveal, tmp_path: Path):
    """Whole, of itself, with nothing of the student's as markup; a hint has no picture."""
    judge, student = grading.judge_from("ex3-1"), "<script>x</script>&\"'"
    (result,) = graded(judge, answers(tmp_path / "a.toml", student, '"alpha 3" = 12.5\n"a_k B3B2" = 0'))
    told = Feedback(result, lang, reveal, platforms.PolygonPictures(judge)(result, lang, reveal))
    page = Reader(html(told))
    assert page.open == []
    assert "script" not in page.seen
    assert ("svg" in page.seen) == (reveal != "hint")
    words = html(told).decode()
    assert (say("verdicts.tolerance", lang) in words) == ("62.22" in words) == (reveal == "answer")
    assert say("verdicts.verdict wrong", lang) in words
    assert b"<script" not in drawing(told)
    assert ("a^k_B3B2" in words) == (reveal != "hint")


def test_what_is_not_drawn_otherwise_is_said(tmp_path: Path):
    """Example 3-5 with the sense of ω2 misread: both polygons stay."""
    judge = grading.judge_from("ex3-5")
    given = '"omega 2" = 2.624\n"omega 3" = 2.853\n"alpha 2" = 35.06\n"alpha 3" = 52.45'
    (result,) = graded(judge, answers(tmp_path / "a.toml", "s", given))
    (picture,) = platforms.PolygonPictures(judge)(result, "en", "mistake")
    assert (picture.label, picture.data) == (say("pictures.nothing", "en"), b"")
    told = Feedback(result, "en", "mistake", [picture])
    assert picture.label in html(told).decode()


def test_an_error_of_ours_costs_the_picture_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    judge = grading.judge_from("ex3-1")
    (result,) = graded(judge, answers(tmp_path / "a.toml", "s", '"alpha 3" = 12.5\n"a_k B3B2" = 0'))
    monkeypatch.setattr("graphkin.homework.platforms.polygon_pictures.mistake_sheets", lambda *a, **k: 1 / 0)
    (picture,) = platforms.PolygonPictures(judge)(result, "en", "answer")
    assert "ZeroDivisionError" in picture.label
    assert not picture.data


def test_a_page_for_each(tmp_path: Path):
    judge = grading.judge_from("ex3-1")
    files = [answers(tmp_path / f"{k}.toml", student, '"alpha 3" = 12.5\n"a_k B3B2" = 0')
             for k, student in enumerate(("s1", "../s2"))]  # fmt: skip
    there = graded(judge, *files)
    pictures = platforms.PolygonPictures(judge)
    platforms.write_results(tmp_path / "out", there, "pages", pictures=pictures)
    pages = sorted((tmp_path / "out" / "pages").iterdir())
    assert len(pages) == 2
    assert all(page.read_bytes().count(b'<svg role="img"') == 2 for page in pages)
    platforms.write_results(tmp_path / "pl", there, "prairielearn", pictures=pictures)
    assert "data:image/svg+xml;base64," in (tmp_path / "pl" / "prairielearn" / "s1" / "results.json").read_text()


def test_the_class_figure_says_where_nothing_was_diagnosed():
    from graphkin.homework.platforms.class_report import class_figure, class_report

    page = class_figure(class_report([]), "en")
    assert not any(axes.axison for axes in page.axes)
    assert all(axes.texts for axes in page.axes)
