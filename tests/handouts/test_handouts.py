"""Handouts: measured on the paper that is printed, and read for what must not be told."""

from __future__ import annotations

import io
import os
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pdf_pages
import pytest
from click.testing import CliRunner
from driven_cylinder import cylinder
from library_sheets import loaded, plain_text
from pdf_lines import lines
from printed_markers import markers

import graphkin
from graphkin.cli import main
from graphkin.files import library, loads
from graphkin.handouts import handout, problem, typst
from graphkin.handouts.document import BlankLine, GridRoom, HandoutPicture, HandoutTable, NameLine, Paragraph, TermRows
from graphkin.handouts.markup import html
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.typst import page_count, pdf
from graphkin.handouts.worksheet import answer_boxes
from graphkin.marking.key import Hypotheses, KeyEntry
from graphkin.outputs.diagram.fonts import chinese_font
from graphkin.photo.markers import MARKERS, MOST, digits
from graphkin.sheet.composition import Planes
from graphkin.sheet.lettering import LABEL, formula, plain
from graphkin.sheet.marks import PointMark, Text, VectorMark
from graphkin.sheet.window import PLANES

_CRUSHER = """
ask = ["omega 5", "alpha 5", "v B", "a B"]
frame = { O = [0, 0], C = [-420, -560], Q = [560, 180] }
links = { 1.OA = 60, 2.AB = 600, 3.CB = 430, 4.BD = 440, 5.QD = 720 }
driver = [{ vector = "OA", angle = 330, omega = "170 r/min" }]
sketch = { B = [0, -600], D = [430, -540] }
"""
PRESS = """
title = "Drawing press"
ask = ["omega 3", "v F", "alpha 3", "a F"]
frame = { A = [0, 0], D = [90, 10] }
links = { 1.AB = 35, 2.BC = 85, 2.BE = 110, 2.CBE = 25, 2.ccw = ["B", "E", "C"], 3.DC = 60, 4.EF = 120, 5.points = ["F"] }
slide = [{ name = "ram", block = "5", point = "F", guide = "frame", through = [110, 0], angle = -90 }]
driver = [{ vector = "AB", angle = 70, omega = "120 r/min", also = [190, 310] }]
sketch = { C = [92, 70], E = [110, 15], F = [110, -110] }
"""
STAGES = ("problem", "blank", "half", "solution")
pypdf = pytest.importorskip("pypdf")
pytest.importorskip("typst")


def _reader(content: bytes):
    return pypdf.PdfReader(io.BytesIO(content))


def _lang(lang: str) -> str:
    if lang == "zh" and chinese_font() is None:
        pytest.skip("no Chinese font here")
    return lang


@pytest.mark.parametrize(("stage", "lang"), [
    *((stage, "en") for stage in STAGES), ("solution", "zh"),
    *(pytest.param(stage, "zh", marks=pytest.mark.further) for stage in STAGES[:-1]),
])  # fmt: skip
def test_pages_are_true_to_scale(stage, lang):
    made = handout([loaded("ex3-1")], stage, _lang(lang))
    content = pdf(made)
    assert content == pdf(made)
    reader = _reader(content)
    for page in reader.pages:
        assert float(page.mediabox.width) == pytest.approx(210 * 72 / 25.4, abs=0.01)
        assert float(page.mediabox.height) == pytest.approx(297 * 72 / 25.4, abs=0.01)
        level = [abs(b - a) for a, b in lines(reader, page) if abs((b - a).imag) < 1e-3]
        assert min(abs(length - 100) for length in level) < 0.01
    assert reader.trailer["/Root"]["/ViewerPreferences"]["/PrintScaling"] == "/None"
    assert reader.trailer["/Root"]["/ViewerPreferences"]["/DisplayDocTitle"]
    told = str(reader.metadata) + reader.xmp_metadata.stream.get_data().decode()
    assert "pdfuaid" in told


def test_every_vector_of_a_solution_is_as_long_as_on_the_sheet():
    made = handout([loaded("ex3-5")], "solution", "en")
    reader = _reader(pdf(made))
    found = [b - a for page in reader.pages for a, b in lines(reader, page)]
    vectors = [
        (mark.end - mark.start).conjugate()
        for block in made.blocks if isinstance(block, HandoutPicture)
        for mark in block.sheet.marks if isinstance(mark, VectorMark) and mark.length > 0.05
    ]  # fmt: skip
    assert len(vectors) > 8
    assert all(min(abs(line - vector) for line in found) < 0.01 for vector in vectors)


def test_fonts_are_embedded():
    reader = _reader(pdf(handout([loaded("ex3-1")], "solution", "en")))
    fonts_found = [font.get_object() for page in reader.pages for font in page["/Resources"]["/Font"].values()]
    assert fonts_found
    for font in fonts_found:
        inner = font["/DescendantFonts"][0].get_object() if "/DescendantFonts" in font else font
        assert any(key.startswith("/FontFile") for key in inner["/FontDescriptor"])


TELLING = library.names()[::3] if "GRAPHKIN_HANDOUTS" in os.environ else ("ex3-1", "ex3-5", "p3-6a")


@pytest.mark.parametrize("name", TELLING)
@pytest.mark.parametrize("stage", ["problem", "blank"])
def test_no_answer_is_told(stage, name):
    """Neither on the page nor in what a PDF or a page says of itself: no answer, and no length of a polygon's arrow."""
    machine = loaded(name)
    problem = drawn_problem(machine, "en")
    answers = [answer for answer in problem.drawing.answers().values() if answer is not None]
    sizes = [abs(answer.vector) if answer.vector is not None else abs(float(answer.value)) for answer in answers]
    sizes += [abs(at) / problem.scales[plane] for plane in problem.polygons for at in problem.drawing.plot.points(plane).values()]
    digits = [text for size in sizes for text in (f"{size:.4g}", f"{1000 * size:.4g}") if len(text.replace(".", "").strip("0")) > 3]
    made = handout([machine], stage, "en")
    reader = _reader(pdf(made))
    told = "".join(page.extract_text() for page in reader.pages) + str(reader.metadata) + html(made) + _alts(reader)
    told += reader.xmp_metadata.stream.get_data().decode()
    assert not [number for number in digits if re.search(rf"(?<![\d.]){re.escape(number)}(?!\d)", told)]
    assert digits or name not in ("ex3-1", "ex3-5", "p3-6a")


def _alts(reader) -> str:
    """What is read aloud of pictures and formulas."""
    objects = [reader.get_object(number) for number in range(1, int(reader.trailer["/Size"]))]
    return "\n".join(str(each["/Alt"]) for each in objects if isinstance(each, dict) and "/Alt" in each)


@pytest.mark.parametrize("name", ["ex3-5", "p3-5", pytest.param("p3-13", marks=pytest.mark.further)])
def test_a_worksheet_tells_nothing_by_its_rooms(name):
    """All are alike; the pole stands where its polygon has room, by lot: another remark in the file, another place."""
    machine = loaded(name)
    rooms = [block for block in handout([machine], "blank", "en").blocks if isinstance(block, GridRoom)]
    solved = handout([machine], "solution", "en")
    pictures = [block.sheet for block in solved.blocks if isinstance(block, HandoutPicture)][-len(rooms) :]
    for room, sheet in zip(rooms, pictures, strict=True):
        assert (room.width, room.height) == (160, 120)
        plane, *_ = (plane for plane in sheet.origins)
        ends = [end - sheet.origins[plane] + room.pole for mark in sheet.marks if isinstance(mark, VectorMark)
                for end in (mark.start, mark.end)]  # fmt: skip
        assert all(0 < at.real < room.width and 0 < at.imag < room.height for at in ends)
    texts = [machine.text + f"# {k}" for k in range(4)]
    again = [next(b for b in handout([graphkin.loads(text)], "blank", "en").blocks if isinstance(b, GridRoom)) for text in texts]
    assert len({room.pole for room in again}) > 2


@pytest.mark.parametrize("name", ["ex3-1", "p3-23b", "p3-6c", "p3-18", "s2-1b"])
def test_sheet_and_handout_have_the_same_scales(name):
    """But where a page has no room for a figure that is large on its sheet: that alone is smaller, and as large as a page
    allows."""
    machine = loaded(name)
    sheet, page = graphkin.Drawing.of(machine).sheet(), drawn_problem(machine, "en")
    smaller = [plane for plane, scale in page.scales.items() if scale != pytest.approx(sheet.scales[plane])]
    assert bool(smaller) == (name not in ("ex3-1", "p3-23b", "p3-18"))
    planes = Planes(page.drawing.method, page.drawing.plot, PLANES, "construction", "en")
    assert all(page.scales[plane] == planes.least[plane] > sheet.scales[plane] for plane in smaller)


def test_a_worksheet_has_room_for_all_that_is_measured():
    """Eight vectors of p3-14's velocities: a row for two of them."""
    blocks = handout([loaded("p3-14")], "blank", "en").blocks
    (table,) = (block for block in blocks if isinstance(block, HandoutTable) and block.under)
    assert len(table.rows) == 4
    assert page_count(pdf(handout([loaded("p3-14")], "blank", "en"))) == 2


@pytest.mark.parametrize(("lang", "said"), [("en", "line at 150° to +x"), ("zh", "与 +x 成 150°")])
def test_the_line_through_the_pole_is_explained(lang, said):
    """It has the direction of the first arrow, which is given with the driver, and serves to set a triangle against."""
    blocks = handout([loaded("ex3-1")], "blank", lang).blocks
    k = next(k for k, block in enumerate(blocks) if isinstance(block, GridRoom) and block.plane == "velocity")
    assert np.degrees(blocks[k].direction) == pytest.approx(150)
    text = next(block for block in blocks[k - 1 :: -1] if isinstance(block, Paragraph)).words
    assert said in "".join(run.text for run in text)


@pytest.mark.parametrize(("lang", "said"), [("en", "measure in it the lengths that are not given"), ("zh", "未给定的长度由图量取")])
def test_a_length_that_is_measured_has_paper_for_the_mechanism(lang, said):
    """BC of a guide, AB of a cylinder, AC of a cam; none where every length is given."""
    guide = 'frame = { A = [0, 60], C = [0, 0] }\nlinks = { 1.AB = 25, 3.CD = 110, 2.points = ["B"] }\nsketch = { D = [30, 105] }\n'
    guide += 'slide = [{ block = "2", point = "B", guide = "3", through = "C", toward = "D" }]\n'
    guide += 'driver = [{ vector = "AB", angle = 20, omega = 9 }]\nask = ["omega 3"]\n'
    machines = {"ex3-1": True, "s3-cam": True, "ex3-4": True, "fig3-1": False, "s2-4": False} if lang == "en" else {}
    for machine, measured in ((loads(guide), True), (loads(cylinder(-0.08, 0.1)), True),
                              *((loaded(name), yes) for name, yes in machines.items())):  # fmt: skip
        blocks = handout([machine], "blank", lang).blocks
        lead = {block.plane: plain_text(blocks[k - 1].words) for k, block in enumerate(blocks) if isinstance(block, GridRoom)}
        assert ("position" in lead) is measured, machine.name
        if measured and drawn_problem(machine, lang).posed_at[1]:
            assert said in lead["position"]


@pytest.mark.parametrize(("given", "at"), [("", 0), ("angle = 263.6\n", 173.6)])
def test_the_line_through_the_pole_does_not_give_an_asked_angle_away(given, at):
    """The crank's, where the rocker's is given; where the crank's own is, it may be used."""
    pose = "" if given else '[[pose]]\nvector = "DC"\nangle = 104\n'
    machine = loads(f"""
ask = ["theta 1", "theta 3", "v C", "a C"]
frame = {{ A = [0, 0], D = [71, -23] }}
links = {{ 1.AB = 27.5, 2.BC = 88, 3.DC = 63 }}
sketch = {{ B = [-20, -18], C = [56, 38] }}
{pose}
[[driver]]
vector = "AB"
omega = -7.7
{given}""")
    rooms = [block for block in handout([machine], "blank", "en").blocks if isinstance(block, GridRoom)]
    assert [room.plane for room in rooms] == ["position", "velocity", "acceleration"]
    for room in rooms[1:]:
        assert np.degrees(room.direction) % 90 == pytest.approx(at % 90, abs=0.1)


@pytest.mark.parametrize("upto", [0, 1])
def test_a_half_worked_solution_stops_between_equations(upto):
    """All that is left has room: its equations, and a table, and gridded paper where the polygon is not begun."""
    blocks = handout([loaded("ex3-5")], "half", "en", upto=upto).blocks
    rows = [block for block in blocks if isinstance(block, TermRows)]
    assert [None in block.columns for block in rows] == [False] * upto + [True] * (2 - upto)
    assert [block.plane for block in blocks if isinstance(block, GridRoom)] == ["acceleration"] * (1 - upto)
    assert sum(isinstance(block, HandoutTable) and block.under > 0 for block in blocks) == 2 - upto


def test_a_half_worked_solution_of_several_positions_says_where_the_others_are_drawn():
    blocks = handout([loads(PRESS)], "half", "en").blocks
    told = [plain_text(block.words) for block in blocks if isinstance(block, Paragraph)]
    assert "Go on with what follows (Fig. 2), for position #1; the others on paper of your own:" in told


def test_a_question_in_words_is_a_sentence_of_its_own():
    machine = loads(PRESS.replace('"a F"]', '"a F", "How far does F travel?"]'))
    for lang, left in (("en", "Left to you: How far does F travel?"), ("zh", "留给读者：How far does F travel?")):
        lines = [line.strip() for line in graphkin.Drawing.of(machine).explain(lang)]
        assert "How far does F travel?" in lines
        assert left in lines
        assert not any("F travel" in line for line in lines if line not in ("How far does F travel?", left))


@pytest.mark.parametrize(("lang", "words"), [("en", "same or opposite"), ("zh", "同向或反向")])
def test_a_ratio_of_rotations_says_what_may_be_written(lang, words):
    machine = loads(GEARS.replace('"omega 4"', '"omega 4/omega 2"'))
    first = answer_boxes(drawn_problem(machine, lang)).rows[0]
    assert [plain_text(cell) for cell in first[2:4]] == ["—", words]


@pytest.mark.parametrize("paper", ["letter-landscape", "A4-landscape", "A3-landscape", "letter", "A4"])
def test_what_is_drawn_together_stands_on_one_page(paper):
    """Heading, equations, gridded paper and table of each polygon; A3 that lies has two of them beside each other."""
    read = pdf_pages.read(pdf(handout([loads(PRESS)], "blank", "en"), paper))
    texts = ["\n".join(line.text for line in page.body) for page in read]
    for plane in ("Velocity polygon", "Acceleration polygon"):
        (page,) = (text for text in texts if plane in text)
        assert all(words in page for words in ("direction:", "The line at", "measured (mm)"))
    assert (texts[-1].count(" polygon,") == 2) is (paper == "A3-landscape")


def test_a_written_solution_of_the_web_has_its_figures(tmp_path: Path):
    assert CliRunner().invoke(main, ["explain", "ex3-1", "-o", str(tmp_path / "x.html")]).exit_code == 0
    assert (tmp_path / "x.html").read_text("utf-8").count("<figure>") == 3


def test_gridded_paper_is_cut_as_far_as_its_polygon_allows():
    """At lines of the grid; where that is not enough it stays as it is, and its height tells nothing."""
    (room, *_) = (block for block in handout([loads(PRESS)], "blank", "en").blocks if isinstance(block, GridRoom))
    lower = room.lower(12)
    assert lower.height == room.height - 15
    assert (room.pole - lower.pole).imag % 5 == 0
    assert lower.pole.imag >= room.above
    assert lower.height - lower.pole.imag >= room.below
    assert room.lower(100) is room


def test_without_any_equation_the_last_polygon_is_left():
    """Wheels alone: every velocity is an image. The half-worked solution is no whole one."""
    wheels = GEARS.replace('"omega 5", "alpha 5", "v F", "a F"', '"v E"')
    blocks = handout([loads(wheels)], "half", "en").blocks
    assert [block.plane for block in blocks if isinstance(block, GridRoom)] == ["velocity"]
    assert not any(isinstance(block, TermRows) for block in blocks)


def test_a_blank_has_the_slots_and_the_signs_of_its_own_equation():
    """And a line for each magnitude that is reckoned for an arrow."""
    press = loads(PRESS)
    solved = [block for block in handout([press], "solution", "en").blocks if isinstance(block, TermRows)]
    blocks = handout([press], "blank", "en").blocks
    blank = [block for block in blocks if isinstance(block, TermRows)]
    signs = [[term and plain_text(term[0]) for term in block.columns] for block in blank]
    assert signs == [[text if text in "=+" else None for text in (plain_text(term[0]) for term in block.columns)] for block in solved]
    assert len({len(each) for each in signs[2:]}) == 2
    lines = [[plain_text(word) for word in block.words] for block in blocks if isinstance(block, BlankLine) and not isinstance(block, NameLine)]
    assert lines == [["vB ="], ["aB =", "aCDn =", "aCBn =", "aFEn ="]]


def test_a_polygon_that_is_not_begun_is_paper_with_its_pole():
    """The velocities are one equation; of the accelerations nothing is drawn where they are to be gone on with."""
    made = handout([loads('ask = ["omega 4", "alpha 4"]' + cylinder(-0.08, 0.1))], "half", "en", upto=1)
    pictures = [block for block in made.blocks if isinstance(block, HandoutPicture)]
    assert all(any(isinstance(mark, PointMark) for mark in picture.sheet.marks) for picture in pictures)
    assert [block.plane for block in made.blocks if isinstance(block, GridRoom)] == ["acceleration"]


def test_links_whose_drivers_are_at_rest_stand_still_in_half_worked_solutions_too():
    """The engine's screw is not turned: D is a fixed point, the first equation is that of C."""
    markup = html(handout([loaded("p3-21")], "half", "en", upto=0))
    told = re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", markup))
    assert "so these links stand still" in told
    assert "C and B are points of link 2" in told
    assert "coincident" not in told


def test_more_equations_than_there_are_and_scans_of_solutions_are_refused(tmp_path: Path):
    """Of a book's problems the longest has so many."""
    output = ("-o", str(tmp_path / "a.pdf"), "--lang", "en")
    over = CliRunner().invoke(main, ["handout", "ex3-5", "s2-2", "--stage", "half", "--upto", "3", *output])
    assert (over.exit_code, over.stderr) == (3, "--upto: 3 will not do: a number from 0 to 1 is wanted here. Correct it.\n")
    scan = CliRunner().invoke(main, ["handout", "ex3-5", "--scan", "1", *output])
    assert scan.exit_code == 3
    assert "a solution leaves nothing to measure" in scan.stderr
    for stage in ("problem", "blank", "solution"):
        whole = CliRunner().invoke(main, ["handout", "ex3-5", "--stage", stage, "--upto", "1", *output])
        assert (whole.exit_code, "Take --stage half" in whole.stderr) == (3, True)
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("kind", ["pdf", "html"])
def test_a_handout_of_its_own_is_written_over_and_no_other_file(kind: str, tmp_path: Path):
    """Also where a long list of all that is in it follows what tells whose it is."""
    path, own = tmp_path / f"a.{kind}", tmp_path / f"mine.{kind}"
    own.write_bytes(b"%PDF-1.7 " + bytes(100_000))
    for name, told in ((path, 0), (path, 0), (own, 3)):
        run = CliRunner().invoke(main, ["handout", "ex3-1", "--stage", "problem", "-o", str(name)])
        assert run.exit_code == told, run.output
    assert path.read_bytes() != own.read_bytes()


def test_no_line_ends_within_a_subscript():
    """`F r2, F c2` of a link with a long name is one sign."""
    words = typst._words(formula("v_F_r2,F_c2 = 0.15 m/s"))
    low = words.partition("#sub[")[2].partition("]")[0]
    assert '#emph("c")' in low
    assert " " not in low


def test_of_a_single_equation_none_is_done():
    rows = [block for block in handout([loaded("ex3-4")], "half", "en").blocks if isinstance(block, TermRows)]
    assert [None in block.columns for block in rows] == [True]


def test_figures_show_what_the_text_tells():
    """Steps of the text are numbered without holes, and the drawing bears the same numbers as far as they have room; its
    equations stand in the text alone. All positions are said."""
    blocks = handout([loaded("p3-22")], "solution", "en").blocks
    told = [int(block.act) for block in blocks if isinstance(block, Paragraph) and block.act]
    assert told == [*range(1, len(told) + 1)]
    polygons = [block.sheet for block in blocks if isinstance(block, HandoutPicture)][1:]
    texts = {"".join(run.text for run in mark.label) for sheet in polygons for mark in sheet.marks if isinstance(mark, Text)}
    rings = [part.partition("–") for text in texts if re.fullmatch(r"[\d–, ]+", text) for part in text.split(", ")]
    drawn = {number for one, _, last in rings for number in range(int(one), int(last or one) + 1)}
    assert drawn <= {*told}
    assert len(drawn) >= len(told) - 3
    assert not {"direction:", "magnitude:"} & texts
    given = handout([loaded("curved-slot")], "problem", "en").blocks
    assert sum(isinstance(block, Paragraph) and block.words[0].text.startswith("#") for block in given) == 4


def test_what_has_no_room_in_a_figure_stands_in_the_text_alone():
    """A narrow figure, whose speed has no room beside it: the text gives it, and no small letters do."""
    blocks = handout([loads(_CRUSHER)], "solution", "en").blocks
    figure = next(block.sheet for block in blocks if isinstance(block, HandoutPicture))
    small = [mark.label for mark in figure.marks if isinstance(mark, Text) and mark.size < LABEL]
    assert not [text for text in map(plain_text, small) if "=" in text]
    assert any("170 r/min" in plain_text(block.words) for block in blocks if isinstance(block, Paragraph))


def test_a_wide_equation_stands_in_two_lines():
    """The last side under the first, the equals signs one under the other; a narrow one, and one to fill in, in one."""
    sign = plain("=")
    term, equals = (plain("a" * 12),) * 3, (sign, (), ())
    wide = TermRows((plain("direction"), plain("size")), (term, equals, term, term, term, equals, *[term] * 4))
    assert [len(line) for line in wide.lines] == [7] * 6
    assert [line[2] for line in wide.lines] == [sign, (), (), sign, (), ()]
    assert [line[0] for line in wide.lines] == [(), *wide.heads] * 2
    assert len(replace(wide, columns=wide.columns[:3]).lines) == 3
    assert len(replace(wide, columns=(None, equals, *[None] * 9)).lines) == 3


def test_a_pole_that_is_found_last_is_none_to_begin_from():
    """The cylinder's arrow is known, and those on both sides of it are sought: text and paper say the same."""
    for lang, text in (("en", "which is found last, comes to lie at p,"), ("zh", "使最后确定的极点落在 p 处")):
        blocks = handout([loads(cylinder(0.1, 0))], "blank", lang).blocks
        lead = [plain_text(blocks[k - 1].words) for k, block in enumerate(blocks) if isinstance(block, GridRoom)]
        assert [text in words for words in lead] == [False, True, False]  # the mechanism is before them


def test_a_book_has_its_contents_and_its_answers():
    names = ("ex3-1", "ex3-5", "p3-6a", "ex3-7")
    made = handout([loaded(name) for name in names], "problem", "en", answers=True)
    reader = _reader(pdf(made))
    text = "".join(page.extract_text() for page in reader.pages)
    assert "Problems" in text
    assert "Answers" in text
    assert len(reader.outline) >= len(names)


class _Tags(HTMLParser):
    """Whether what opens is closed again."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.mark.parametrize("name", library.names()[::20])
def test_pages_of_a_browser_need_nothing_else(name):
    made = handout([loaded(name)], "solution", "en")
    page = html(made)
    assert not _Tags(page).open
    assert not re.search(r'(src|href)="(?!#)', page)
    assert "<math>" in page
    assert any(isinstance(block, Paragraph) and block.act for block in made.blocks)


KNOWN = (0xB532, 0x0F9A, 0x332D, 0x9946, 0x549E, 0x79CD, 0x9E2E, 0xC4F2)
"""The first markers of the dictionary as it is published."""


def test_markers_are_told_apart_however_they_lie():
    """Each differs in three squares or more from every other one, turned as it may be, and from itself turned."""
    assert MARKERS[:8] == KNOWN
    assert len(MARKERS) == 250
    bits = np.array([[word >> (15 - k) & 1 for k in range(16)] for word in MARKERS]).reshape(-1, 4, 4)
    for turn in range(4):
        differ = (bits[:, None] != np.rot90(bits, turn, axes=(1, 2))[None]).sum(axis=(2, 3))
        assert differ[~np.eye(250, dtype=bool)].min() >= 3
        assert turn == 0 or differ.diagonal().min() >= 3


def test_sheets_of_a_class_are_told_apart_on_paper(tmp_path: Path):
    """What is painted on each page is read: its corners, and a number that goes on from page to page and file to file."""
    command = ["handout", "ex3-1", "ex3-5", "--stage", "problem", "--scan", "245", "-o", str(tmp_path)]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    readers = [pypdf.PdfReader(tmp_path / f"{name}.pdf") for name in ("ex3-1", "ex3-5")]
    told = []
    for page in [page for reader in readers for page in reader.pages]:
        found = markers(page.pdf, page)
        corners = [min(found, key=lambda at, c=c: abs(at - c)) for c in (14 + 14j, 196 + 14j, 196 + 283j, 14 + 283j)]
        assert max(abs(at - c) for at, c in zip(corners, (14 + 14j, 196 + 14j, 196 + 283j, 14 + 283j))) < 0.01
        assert [MARKERS.index(found[at]) for at in corners] == [0, 1, 2, 3]
        left, right = (MARKERS.index(found[at]) for at in sorted({*found} - {*corners}, key=lambda at: at.real))
        told.append((left - 4) * 246 + right - 4)
        assert f"#{told[-1]}" in page.extract_text()
    assert told == list(range(245, 245 + len(told)))
    assert len(told) >= 2


def test_a_class_has_numbers_enough():
    numbers = {digits(number) for number in range(MOST + 1)}
    assert len(numbers) == MOST + 1 > 60_000
    assert {max(pair) for pair in numbers} <= set(range(4, 250))


def test_a_camera_reads_them(tmp_path: Path):
    """By the library that photographs are read with, where it is there."""
    cv2, pdfium = pytest.importorskip("cv2"), pytest.importorskip("pypdfium2")
    path = tmp_path / "a.pdf"
    path.write_bytes(pdf(handout([loaded("ex3-1")], "blank", "en"), scan=31415))
    picture = np.array(pdfium.PdfDocument(path)[1].render(scale=200 / 72).to_pil().convert("L"))
    reader = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_250))
    assert {0, 1, 2, 3, *digits(31416)} == set(reader.detectMarkers(picture)[1].ravel().tolist())


@pytest.mark.parametrize("name", ["p3-16", pytest.param("p3-17", marks=pytest.mark.further)])
def test_images_of_wheels_fit_the_page(name: str):
    """They reach beyond the points of the polygon, and count where its scale is chosen."""
    figures = [block for block in handout([loaded(name)], "solution", "en").blocks if isinstance(block, HandoutPicture)]
    assert len(figures) > 1
    assert all(each.sheet.paper.width <= 170 and each.sheet.paper.height <= 250 for each in figures)


def test_a_folder_gets_a_file_for_each(tmp_path: Path):
    command = ["handout", "ex3-1", "ex3-5", "--stage", "problem", "-o", str(tmp_path / "sheets"), "--seed", "7"]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    assert sorted(path.name for path in (tmp_path / "sheets").iterdir()) == ["ex3-1.pdf", "ex3-5.pdf"]
    assert "seed 7" in _reader((tmp_path / "sheets" / "ex3-1.pdf").read_bytes()).pages[0].extract_text()


@pytest.fixture(scope="module")
def homework(tmp_path_factory) -> Path:
    """A class's problem set in its folder."""
    folder = tmp_path_factory.mktemp("class")
    (folder / "class.csv").write_text("id,name\n20240001,Li Lei\n20240002,Han Meimei\n", encoding="utf-8")
    template = folder / "slide.toml"
    template.write_text(library.text("ex3-1").replace("AB = 24", "AB = { from = 20, to = 28, step = 1 }"), encoding="utf-8")
    command = ["problems", str(template), "--students", str(folder / "class.csv"), "--seed", "27", "-o", str(folder / "set")]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    return folder / "set"


@pytest.mark.parametrize("target", ["sheets", "print.pdf"])
def test_a_class_gets_its_own_sheets(homework: Path, target: str, tmp_path: Path):
    """A file each, or one to print; each page says whose it is by id and name, of which set, and has a number of its own."""
    command = ["handout", str(homework), "--stage", "blank", "--lang", "en", "--scan", "10", "-o", str(tmp_path / target)]
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 0, done.output
    paths = sorted((tmp_path / target).iterdir()) if target == "sheets" else [tmp_path / target]
    assert [path.name for path in paths if path.suffix == ".json"] == (["sheets.json"] if target == "sheets" else [])
    paths = [path for path in paths if path.suffix == ".pdf"]
    assert [path.stem for path in paths] == (["20240001", "20240002"] if target == "sheets" else ["print"])
    texts = [page.extract_text() for path in paths for page in pypdf.PdfReader(path).pages]
    students = ("20240001 Li Lei", "20240002 Han Meimei")
    assert [[who in text for who in students] for text in texts] == [[True, False]] * 4 + [[False, True]] * 4
    for number, text in enumerate(texts, 10):
        assert "seed 27" in text
        assert f"#{number} " in text


def test_each_problem_begins_on_a_front(homework: Path, tmp_path: Path):
    """Printed on both sides, no sheet is two students'."""
    command = ["handout", str(homework), "--stage", "blank", "--lang", "en", "--duplex", "-o", str(tmp_path / "a.pdf")]
    assert CliRunner().invoke(main, command).exit_code == 0
    texts = [page.extract_text() for page in pypdf.PdfReader(tmp_path / "a.pdf").pages]
    first = [next(k for k, text in enumerate(texts) if who in text) for who in ("Li Lei", "Han Meimei")]
    assert [number % 2 for number in first] == [0, 0]


@pytest.mark.parametrize("text", ["", "[]", '{"seed": 1}', '{"seed": 1, "students": {"a": {"file": "../a.toml"}}}'])
def test_a_list_that_is_none_is_said(text: str, tmp_path: Path):
    (tmp_path / "set.json").write_text(text, encoding="utf-8")
    done = CliRunner().invoke(main, ["handout", str(tmp_path), "--lang", "en", "-o", str(tmp_path / "a.pdf")])
    assert done.exit_code == 3
    assert "problem set" in done.output


def test_no_boxes_where_no_chinese_font_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    import graphkin.outputs.diagram.fonts as found

    monkeypatch.setattr(found, "chinese_font", lambda: None)
    monkeypatch.delenv(typst.VARIABLE, raising=False)
    done = CliRunner().invoke(main, ["handout", "ex3-1", "--lang", "zh", "-o", str(tmp_path / "a.pdf")])
    assert done.exit_code == 3
    assert "fonts-noto-cjk" in done.output
    assert not list(tmp_path.iterdir())
    done = CliRunner().invoke(main, ["handout", "ex3-1", "--font", str(tmp_path), "-o", str(tmp_path / "a.pdf")])
    assert done.exit_code in (2, 3)


@pytest.mark.parametrize("kind", [".html", ".tex", ".md"])
def test_a_solution_is_written_by_the_ending(kind: str, tmp_path: Path):
    path = tmp_path / f"a{kind}"
    for _ in range(2):
        done = CliRunner().invoke(main, ["explain", "ex3-1", "--lang", "en", "-o", str(path)])
        assert done.exit_code == 0, done.output
    text = path.read_text(encoding="utf-8")
    assert "3.919" in text
    assert "62.22" in text
    path.write_text("mine")
    assert CliRunner().invoke(main, ["explain", "ex3-1", "-o", str(path)]).exit_code == 3
    assert path.read_text() == "mine"


def test_what_problems_would_not_ask_is_said(tmp_path: Path):
    """A handout of a mechanism asks what its file asks; who hands it out reads what `tolerance` says of it."""
    told = CliRunner().invoke(main, ["tolerance", "ex3-3", "--lang", "en"]).stdout
    (sentence,) = (line for line in told.splitlines() if "`graphkin problems` asks no such value" in line)
    for stage, name, said in (("problem", "ex3-3", True), ("solution", "ex3-3", False), ("problem", "ex3-5", False)):
        args = ["handout", name, "--stage", stage, "-o", str(tmp_path / f"{name}-{stage}.html"), "--lang", "en"]
        result = CliRunner().invoke(main, args)
        assert result.exit_code == 0
        assert (f"ask: {sentence}" in result.stderr) is said
        assert ("asks no such value" in result.stderr) is said


def test_further_positions_that_cannot_be_told_are_said():
    text = library.text("ex3-3").replace("[[driver]]", "[[driver]]\nalso = [61]", 1)
    first, *others = problem.untold_answers(graphkin.loads(text), "en")
    assert "ω6 may" in first
    assert "ω6 #2 may" in " ".join(others)


def test_common_mistakes_list_only_what_they_move():
    """Along a guide that runs the other way the same speed comes with a sign; the answer has none, nor has the mistake."""
    entries = (KeyEntry("v E", "m/s", "size", 0.176, 0.003, 0.009, 1.0), KeyEntry("theta 3", "rad", "angle", 6.2, 0.01, 0.03))
    values = np.array([[-0.176, 6.2 - 2 * np.pi], [-0.25, 3.0]])
    names = ((("coriolis-omitted", "", (), ""),), (("coriolis-reversed", "", (), ""),))
    moved = problem._moved(SimpleNamespace(entries=entries, singles=Hypotheses(names, values, values)))
    assert moved.tolist() == [[False, False], [True, True]]


def test_a_mistake_that_turns_a_vector_alone_is_listed_with_its_direction():
    """Reversed, the Coriolis acceleration has its size."""
    posed = problem.drawn_problem(loaded("ex3-1"), "en")
    told = ["".join(run.text for run in block.words) for block in problem.common_mistakes(posed) if isinstance(block, Paragraph)]
    (reversed_,) = (each for each in told if "pointing the other way" in each)
    assert "aB3B2k = 2.515 m/s² (at 115.6° to +x)" in reversed_
    assert not any("to +x" in each for each in told if each != reversed_)


def test_what_a_pencil_allows_is_in_plain_figures():
    fast = loaded("fig3-1").with_({"driver.0.omega": "2000 rpm"})
    text = html(handout([fast], "solution", "en"))
    allowed = re.findall(r"± ?([^<]*)", text)
    assert max(float(one) for one in allowed) >= 100
    assert not any("e" in one for one in allowed)


def test_a_solution_has_the_answers_at_further_positions_and_grids_say_of_which_they_are():
    mechanism = graphkin.loads(library.text("ex3-3").replace("[[driver]]", "[[driver]]\nalso = [61]", 1))
    text = re.sub("<[^>]*>", "", html(handout([mechanism], "solution", "en")))
    assert text.count("#2") == 2  # among the positions, before the answers
    assert "for position #1" in html(handout([mechanism], "blank", "en"))
    assert "for position #1" not in html(handout([loaded("ex3-3")], "blank", "en"))


GEARS = """
ask = ["omega 4", "omega 5", "alpha 5", "v F", "a F"]
frame = { A = [0, 0], B = [66, 0], C = [114, 36] }
links = { 2.points = ["A"], 3.points = ["B"], 4.CE = 29, 5.EF = 118, 6.points = ["F"] }
gear = [{ links = ["2", "3"], centres = ["A", "B"], radii = [19, 47] },
        { links = ["3", "4"], centres = ["B", "C"], radii = [18, 42] }]
slide = [{ block = "6", point = "F", guide = "frame", through = [0, 40] }]
driver = [{ link = "2", omega = "420 rpm", alpha = 25 }]
pose = [{ vector = "CE", angle = 128 }]
sketch = { E = [96, 59], F = [212, 40] }
"""


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_mistakes_to_look_for_can_be_made_by_whoever_follows_the_solution(lang):
    """Each of their arrows is printed there, a crank's normal acceleration has its name, and no number is absurd."""
    crusher = graphkin.load(Path(__file__).parents[1] / "cases" / "jaw-crusher.toml")
    for machine in (crusher, loads(GEARS)):
        posed = problem.drawn_problem(machine, lang)
        paragraphs = [block for block in problem.common_mistakes(posed) if isinstance(block, Paragraph)]
        told = ["".join(run.text for run in block.words) for block in paragraphs]
        assert len(told) == 3
        crank = "aAOn" if machine is crusher else "aECn"  # what turns as a driver, or the ratios of wheels, have it
        assert any(crank in each for each in told)
        assert f"aⁿ_{crank[1:3]}" in "\n".join(graphkin.Drawing.of(machine).explain())
        for each in told:
            assert max(float(size) for size in re.findall(r"= −?([\d.]+)", each)) < 5 * 60
