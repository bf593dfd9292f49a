"""The sheet shows how it was drawn: acts with the numbers of the sentences, equations, what is given; three styles."""

from __future__ import annotations

import cmath
import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from library_sheets import drawing
from library_sheets import library_sheet as sheet

from graphkin.check import measure
from graphkin.cli import main
from graphkin.construction import Drawn, Fit, Image, LayOff, Meet, Plot
from graphkin.errors import Lang, NothingToMeasure
from graphkin.files import library
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.planning.drawn_position import shown
from graphkin.planning.method import Act, made
from graphkin.planning.needed import without_aids
from graphkin.running import replay_all
from graphkin.say import derivation, vector_equations
from graphkin.say.entry import Sentence
from graphkin.sheet import Sheet, Style
from graphkin.sheet.construction_lines import PolygonConstruction
from graphkin.sheet.lettering import Label, formula, vector_label
from graphkin.sheet.marks import ArcMark, Disc, PointMark, Stroke, Text, VectorMark

SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
SEVERAL = ("ex3-1", "p3-16", "p3-17", "p3-22", "s4-ex6", "scotch-yoke")


def read(label: Label) -> str:
    return "".join(run.text for run in label)


def texts(page: Sheet) -> list[str]:
    return [read(mark.label) for mark in page.marks if isinstance(mark, Text)]


# --- numbers ----------------------------------------------------------------------------------


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_every_act_is_told_once_in_its_order(name: str) -> None:
    method = plan(library.load(name))
    plot = replay_all(method)
    entries = list(derivation(method, plot, SCALES, "en", as_planned=True))
    told = [entry.act for entry in entries if isinstance(entry, Sentence) and entry.act is not None]
    method, plot = shown(method, plot)
    assert told == [act for act in method.acts if act in told]
    for act in (act for act in method.acts if act not in told and not nothing_to_draw(act, plot)):  # told with its line
        assert act.plane == "position"
        assert isinstance(act.done, Image)
        assert any(act.done.point in entry.text for entry in entries if isinstance(entry, Sentence))
    numbered = [act for act in method.acts if act.numbered]
    assert [act.number for act in numbered] == list(range(1, len(numbered) + 1))
    assert all(isinstance(act.done, LayOff | Meet | Image) for act in numbered)


def nothing_to_draw(act: Act, plot: Plot) -> bool:
    """A train in its drawn position, which is given; points of polygons that drivers at rest hold on the pole."""
    if isinstance(act.done, Fit):
        return not act.done.closures
    return act.plane != "position" and all(abs(plot.points(act.plane)[point]) < 1e-12 for point in made(act.done))


def test_the_words_and_the_sheet_bear_the_same_numbers() -> None:
    lines = drawing("ex3-1").explain("zh", everything=True)
    told = [line for line in lines if re.match(r"\s*[\u2460-\u2473]", line)]
    assert len(told) == sum(act.numbered for act in drawing("ex3-1").method.acts) == 8
    rings = [mark for mark in sheet("ex3-1").marks if isinstance(mark, Disc) and mark.pen == "construction"]
    letters = [mark for mark in sheet("ex3-1").marks if isinstance(mark, Text)]
    pages = {act.page: act.number for act in drawing("ex3-1").method.acts}
    inside = [[t for t in letters if abs(t.at - ring.centre) < ring.radius] for ring in rings]
    assert len(rings) >= 6
    assert all(read(found.label) == str(pages[ring.step]) for ring, (found,) in zip(rings, inside, strict=True))  # type: ignore[index]


@pytest.mark.parametrize("name", SEVERAL)
def test_what_was_solved_is_thicker(name: str) -> None:
    method = without_aids(drawing(name).method)
    thick = [mark for mark in sheet(name).marks if isinstance(mark, VectorMark) and mark.solved]
    solved = {name for mark in thick for name in (mark.name, *mark.also)}
    unknown = {
        term.name(plane)
        for plane, construction in (("velocity", method.velocity), ("acceleration", method.acceleration))
        for equation in construction.equations
        for term in equation.left + equation.right
        if term.size is None
    }  # fmt: skip
    assert solved >= unknown
    assert all(unknown & {mark.name, *mark.also} for mark in thick)


# --- equations --------------------------------------------------------------------------------


@pytest.mark.many
@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("name", SEVERAL)
def test_the_equations_are_those_of_the_words(name: str, lang: Lang) -> None:
    method, plot = drawing(name).method, drawing(name).plot
    written = [text.removeprefix(" = ") for text in texts(sheet(name, lang=lang))]
    for plane in ("velocity", "acceleration"):
        told = vector_equations(method, plot, SCALES, lang, plane).values()  # type: ignore[arg-type]
        arrows = [arrow for entry in told for arrow in entry.arrows if arrow.size == "?"]
        assert all(read(formula(arrow.name)) in written for arrow in arrows)
        assert all(read(formula(arrow.direction)) in written for arrow in arrows)


@pytest.mark.parametrize(
    ("text", "runs"),
    [
        ("ω3² l_BD", ["ω", "3_", "2^", " ", "l", "BD_"]),
        ("aᵏ_B3B2", ["a", "B_", "3_", "B_", "2_", "k^"]),
        ("⊥BD", ["⊥", "B", "D"]),
        ("(v_DG + v_S4D)", ["(", "v", "DG_", " + ", "v", "S_", "4_", "D_", ")"]),
        ("∥guide ram", ["∥guide ram"]),
        ("AD = 78 mm", ["A", "D", " = 78 mm"]),
        ("?", ["?"]),
    ],
)
def test_formulas_are_set_as_the_field_writes_them(text: str, runs: list[str]) -> None:
    places = {"base": "", "sub": "_", "sup": "^"}
    assert [run.text + places[run.place] for run in formula(text)] == runs


# --- styles -----------------------------------------------------------------------------------


@pytest.mark.many
@pytest.mark.parametrize("style", ["construction", "result"])
@pytest.mark.parametrize("name", SEVERAL)
def test_a_ruler_measures_every_style_that_has_answers(name: str, style: Style, tmp_path: Path) -> None:
    (tmp_path / "sheet.svg").write_text(svg(sheet(name, style)), "utf-8")
    assert measure(tmp_path / "sheet.svg").passed(0.01)


def test_results_alone_show_no_construction() -> None:
    page = sheet("ex3-1", "result")
    assert not [mark for mark in page.marks if isinstance(mark, Stroke | Disc) and mark.pen in ("construction", "measured")]
    assert not [mark for mark in page.marks if isinstance(mark, VectorMark) and mark.solved]
    assert "⊥BD" in texts(sheet("ex3-1"))
    assert "⊥BD" not in texts(page)


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("name", SEVERAL)
def test_what_is_given_holds_no_answer(name: str, lang: Lang, tmp_path: Path) -> None:
    text = svg(page := sheet(name, "given", lang))
    assert not [mark for mark in page.marks if isinstance(mark, VectorMark)]
    answers = [a for a in drawing(name).answers().values() if a is not None and a.value and a.unit not in ("m", "rad")]
    figures = {f"{abs(float(answer.value)):.4g}" for answer in answers}
    given = {f"{abs(float(v)):.4g}" for d in drawing(name).mechanism.drivers for v in (d.rate, d.acceleration)}
    assert not [figure for figure in figures - given if len(figure) > 3 and figure in "".join(texts(page))]
    assert "[[link]]" not in text
    assert "ask" not in text
    (tmp_path / "given.svg").write_text(text, "utf-8")
    with pytest.raises(NothingToMeasure):
        measure(tmp_path / "given.svg")


def test_commands_know_the_styles(tmp_path: Path) -> None:
    run, given = CliRunner().invoke, str(tmp_path / "given.svg")
    assert run(main, ["draw", "ex3-1", "--style", "given", "-o", given]).exit_code == 0
    assert run(main, ["check", given]).exit_code == 3
    assert run(main, ["draw", "ex3-1", "--style", "given", "--only", "velocity", "-o", given]).exit_code == 2


# --- the mechanism ----------------------------------------------------------------------------


def test_measured_lengths_rotations_and_what_is_given_stand_on_the_mechanism() -> None:
    page = sheet("ex3-1")
    assert {"lBD = 69.20 mm", "ω3", "α3", "ω2", "α2"} <= set(texts(page))
    stated = "24 mm", "48 mm", "78 mm", "γ = 100°", "φ1 = 60°", "ω1 = 10 rad/s"  # along links or in a line, as in the file
    assert all(any(one in text for text in texts(page)) for one in stated)
    grey = {"".join(run.text for run in m.label) for m in page.marks if isinstance(m, Text) and m.accent == "grey"}
    assert grey == {"lBD = 69.20 mm"}
    arcs = [mark for mark in page.marks if isinstance(mark, ArcMark) and mark.accent is not None]
    turns = {mark.accent: mark.sweep > 0 for mark in arcs}
    assert turns == {"velocity": True, "acceleration": False}  # clockwise, and counter-clockwise, on paper
    assert any(isinstance(mark, Stroke) and mark.pen == "measured" for mark in page.marks)


# --- steps ------------------------------------------------------------------------------------


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_each_step_has_its_sentence_and_only_the_planes_asked(lang: Lang) -> None:
    method = drawing("ex3-1").method
    pages = list(drawing("ex3-1").step_sheets(only="velocity", lang=lang))
    acts = [act for act in method.acts if act.plane == "velocity"]
    assert len(pages) == len(acts) == 3
    signs = ["".join(texts(page)) for page in pages]
    assert all(chr(0x2460 + k) in text for k, text in enumerate(signs))
    assert not any(text == "ω3" for page in pages for text in texts(page))


def test_a_line_stops_before_letters() -> None:
    """Direction lines are drawn last, and shortened where labels stand."""
    from graphkin.sheet.free_room import FreeRoom
    from graphkin.sheet.label_candidates import LabelScene
    from graphkin.sheet.lettering import plain
    from graphkin.sheet.paper import Room

    free = FreeRoom(LabelScene((), [Text(plain("xxxx"), 20 + 1j, 4.0)], Room(0, -10, 60, 10)))
    assert 18 < free.reach(0j, 1 + 0j, 50) < 20
    assert free.reach(0j, -1j, 8) == 8
    assert PolygonConstruction.__doc__


@pytest.mark.parametrize("name", ["p3-14", "ex3-2"])
def test_a_direction_label_stands_at_a_line_of_its_own(name: str) -> None:
    """No line that only bears its label lies on an arrow."""
    marks = sheet(name).marks
    arrows = [mark for mark in marks if isinstance(mark, VectorMark) and mark.length > 1]
    strokes = [mark for mark in marks if isinstance(mark, Stroke) and mark.pen == "construction"]
    lines = [mark for mark in strokes if len(mark.places) == 2]  # no right angles
    points = [mark.at for mark in marks if isinstance(mark, PointMark)]
    tips = [line.places[-1] for line in lines if min(abs(line.places[-1] - point) for point in points) > 1]
    assert tips
    for tip in tips:
        near = [abs(((tip - arrow.start) / (arrow.end - arrow.start)).imag) * arrow.length for arrow in arrows
                if 0 < ((tip - arrow.start) / (arrow.end - arrow.start)).real < 1]  # fmt: skip
        assert not near or min(near) > 0.3


def test_a_figure_shows_the_order_of_its_steps() -> None:
    numbers = [mark for mark in sheet("s3-shaper").marks if isinstance(mark, Text) and read(mark.label).isdigit()]
    arrows = [mark for mark in sheet("s3-shaper").marks if isinstance(mark, VectorMark)]
    ends = [end for arrow in arrows for end in (arrow.start, (arrow.start + arrow.end) / 2, arrow.end)]
    beside = {int(read(text.label)) for text in numbers if min(abs(text.at - end) for end in ends) < 20}
    assert beside >= {act.number for act in drawing("s3-shaper").method.acts if act.numbered}


# --- other sheets -----------------------------------------------------------------------------


def test_every_linkage_of_a_mechanism_is_drawn(tmp_path: Path) -> None:
    out = tmp_path / "limits.svg"
    assert CliRunner().invoke(main, ["linkage", "ex3-7", "-o", str(out), "--lang", "en"]).exit_code == 0
    text = re.sub(r"<[^>]+>", "", out.read_text("utf-8"))
    assert "ABC:" in text
    assert "CDE:" in text


def test_the_pole_of_two_velocities_has_a_sheet(tmp_path: Path) -> None:
    out = tmp_path / "pole.svg"
    words = ["centres", "--velocities", "A 0,0 1,0.5; B 100,0 1,-0.2", "-o", str(out)]
    assert CliRunner().invoke(main, words).exit_code == 0
    assert out.read_text("utf-8").count("<line") > 5
    assert CliRunner().invoke(main, [*words, "--steps", str(tmp_path)]).exit_code == 2


def test_what_is_carried_to_another_place_is_drawn_there() -> None:
    """The tangential acceleration of C1 is found at one end of the polygon and laid off at another."""
    page = drawing("ex3-4").sheet(lang="en")
    done = {act: act.done for act in drawing("ex3-4").method.acts if isinstance(act.done, LayOff)}
    (act, step), *_ = ((act, step) for act, step in done.items() if isinstance(step.term.size, Drawn))
    points = {mark.name: mark.at for mark in page.marks if isinstance(mark, PointMark) and mark.plane == act.plane}
    lines = [mark for mark in page.marks if isinstance(mark, Stroke) and mark.step == act.page]
    drawn = sum(abs(mark.places[1] - mark.places[0]) for mark in lines if mark.pen == "measured")
    assert drawn > 0.7 * abs(points[step.tip] - points[step.start])


@pytest.mark.parametrize(("text", "written"), [
    ("aⁿ_{J1_3,J1_1}", "aJ1 3, J1 1n"), ("γ_min", "γmin"), ("v_B@3", "vB 3"), ("n3,1′", "n3,1′"),
])  # fmt: skip
def test_subscripts_read_as_on_the_labels(text: str, written: str) -> None:
    label = formula(text)
    assert "".join(run.text for run in label) == written
    assert all(run.place == "sub" for run in label if run.text[0].isdigit())


# --- what stands beside a polygon -------------------------------------------------------------


def test_an_equation_bears_the_numbers_of_the_steps_that_it_needs() -> None:
    """C of example 3-1 is found by image, after the equations; none is told twice, in two lines either."""
    assert [text for text in texts(sheet("ex3-1")) if "–" in text] == ["1–2", "4–7"]


def test_instant_centres_that_are_asked_for_stand_in_the_results_in_bold() -> None:
    marks = [mark for mark in sheet("p3-11a").marks if isinstance(mark, Text) and "34.37" in read(mark.label)]
    assert [read(mark.label) for mark in marks] == ["(0, 34.37)"]
    assert all(run.bold for run in marks[0].label)


@pytest.mark.parametrize("name", ["p3-16", "p3-12", "p3-19", "ex3-3"])
def test_each_arrow_of_an_equation_has_its_name_on_the_drawing(name: str) -> None:
    marks = sheet(name).marks
    named = {"".join(run.text for run in mark.label).removeprefix(" = ") for mark in marks
             if isinstance(mark, Text)}  # fmt: skip
    arrows = {arrow.name for arrow in marks if isinstance(arrow, VectorMark) and arrow.length > 0.1}
    for construction in (drawing(name).method.velocity, drawing(name).method.acceleration):
        for term in construction.vectors():
            assert term not in arrows or "".join(run.text for run in vector_label(term)) in named, term


@pytest.mark.parametrize(("name", "row"), [("s4-ex4", "vO2 = ωH lO1O2"), ("p3-12", "∆ck1l2 ∽ ∆CKL")])
def test_what_no_equation_gives_has_a_row(name: str, row: str) -> None:
    assert row in {"".join(run.text for run in mark.label) for mark in sheet(name).marks
                   if isinstance(mark, Text)}  # fmt: skip


def test_a_name_joins_others_at_its_own_step() -> None:
    """In the velocity polygon e falls on d and is found after it."""
    steps = {read(mark.label): mark.step or 0 for mark in sheet("p3-22").marks if isinstance(mark, Text)}
    assert steps["d"] < steps[", e"]


def test_the_point_of_a_tangent_stands_in_the_figure() -> None:
    for style in ("construction", "given"):
        assert ("T" in texts(sheet("ex3-1", style))) == (style == "construction")


@pytest.mark.parametrize("name", ["ex3-1", "ex3-5", "p3-23b", "s2-2", "s3-four", "s4-ex3", "s4-ex5"])
def test_both_arcs_of_a_link_bend_about_one_middle_or_the_same_way(name: str) -> None:
    """So that heads which point alike mean one sense."""
    marks, ways = sheet(name).marks, dict[str, list[tuple[complex, complex]]]()
    for head in (mark for mark in marks if isinstance(mark, Stroke) and mark.shows and mark.shows.form in ("omega", "alpha")):
        arcs = (mark for mark in marks if isinstance(mark, ArcMark))
        tips = {arc: arc.centre + cmath.rect(arc.radius, arc.start + arc.sweep) for arc in arcs}
        arc = min(tips, key=lambda arc: min(abs(place - tips[arc]) for place in head.places))
        ways.setdefault(head.shows.link, []).append((arc.centre, cmath.rect(1, arc.start + arc.sweep / 2)))
    both = [own for own in ways.values() if len(own) == 2]
    assert both
    for (centre, way), (other, other_way) in both:
        assert abs(centre - other) < 1e-6 or (way.conjugate() * other_way).real > 0.9
