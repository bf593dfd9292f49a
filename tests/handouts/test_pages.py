"""Pages of handouts, read from the PDFs: they turn where a reader would turn them, and bear what belongs to a problem."""

from __future__ import annotations

import re

import pytest
from click.testing import CliRunner
from library_sheets import TEXTBOOK, loaded, plain_text
from pdf_pages import faults, pages, read

import graphkin
from graphkin.cli import main
from graphkin.files import library
from graphkin.handouts import handout, in_languages, paging
from graphkin.handouts.document import HandoutHeading, HandoutPicture, HandoutTable, NameLine, Paragraph
from graphkin.handouts.markup import html
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.typst import pdf
from graphkin.outputs.diagram.fonts import chinese_font
from graphkin.outputs.letters import lettered
from graphkin.say.entry import text_lines
from graphkin.sheet import mechanism_sheet
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Text
from graphkin.submissions import Student

pytest.importorskip("pypdf")
pytest.importorskip("typst")
needs_chinese = pytest.mark.skipif(chinese_font() is None, reason="no Chinese font here")


@needs_chinese
@pytest.mark.parametrize(("name", "stage"), [("p3-6a", "solution"), ("ex3-1", "half")])
def test_nothing_is_torn_apart(name, stage):
    """In both languages: no page ends on a colon or has but a few lines, each half has its own feet."""
    content = pdf(in_languages([loaded(name)], stage, ("zh", "en")))
    assert list(faults(content)) == []
    chinese = [bool(re.search("[\u4e00-\u9fff]", page.foot)) for page in read(content)]
    assert set(chinese) == {True, False}
    assert chinese == sorted(chinese, reverse=True)


def test_figures_are_arranged_once_for_both_languages(monkeypatch: pytest.MonkeyPatch):
    """The whole sheet, for its scales, and a figure of each plane."""
    planes, cheapest = [], mechanism_sheet.cheapest

    def counted(contents, paper):
        planes.append(contents.drawing.planes)
        return cheapest(contents, paper)

    monkeypatch.setattr(mechanism_sheet, "cheapest", counted)
    in_languages([graphkin.load("ex3-1")], "solution", ("en", "zh"))
    assert [len(each) for each in planes] == [3, 1, 1, 1]


PAGE = """#set page(width: 210mm, height: 297mm, margin: (x: 20mm, top: 18mm, bottom: 26mm), footer: [foot])
#set text(size: 10.5pt, lang: "en")
#set document(title: "x")
"""


@pytest.mark.parametrize(
    ("body", "kind"),
    [
        ("= T\n" + "Words.\n\n" * 5 + "It follows:\n#pagebreak()\n" + "Words.\n\n" * 5, "colon"),
        ("= T\n" + "Words.\n\n" * 6 + "#pagebreak()\n" + "Words.\n\n" * 2, "few"),
        ("= T\n" + "Words.\n\n" * 6 + "== Next\n#pagebreak()\n" + "Words.\n\n" * 6, "heading"),
        ("= T\n" + "Words.\n\n" * 6 + "#pagebreak()\n#pad(left: 8mm)[x = 3.]\n" + "Words.\n\n" * 6, "apart"),
        ("= T\n" + "Words.\n\n" * 6 + "， words.\n\n", "punctuation"),
    ],
)
def test_the_reader_sees_each_fault(body, kind):
    import typst

    content = typst.compile((PAGE + body).encode(), format="pdf", pdf_standards=["ua-1"])
    assert {each for _, each, _ in faults(content)} - {"hole", "mixed"} == {kind}


def test_pages_turn_where_least_is_empty():
    """A drawing stands with some of what it belongs to; what is taller than a page has one of its own."""
    text = paging.PagePart((Paragraph(plain("x")),))
    drawing = paging.PagePart((Paragraph(plain("x")),), of=0)
    assert paging.pages([text] * 4, [30, 30, 30, 30], 100) == [[0, 1, 2], [3]]
    assert paging.pages([text] * 4, [32, 32, 32, 4], 100) == [[0, 1, 2, 3]]
    assert paging.pages([text, text, text, drawing], [30, 30, 30, 60], 100) == [[0, 3], [1, 2]]
    assert paging.pages([text, text, drawing, text], [30, 40, 50, 40], 100) in ([[0, 2], [1, 3]], [[0], [1, 2], [3]])
    assert paging.pages([text, text], [300, 20], 100) == [[0], [1]]
    assert paging.pages([text, text, drawing], [30, 40, 90], 100) == [[0, 1], [2]]
    assert paging.pages([], [], 100) == []


def test_a_drawing_stands_before_the_next_section():
    """Where a page more is not the price of it: half a page is left empty rather."""
    text = paging.PagePart((Paragraph(plain("x")),))
    head = paging.PagePart((HandoutHeading(plain("x")), Paragraph(plain("x"))))
    drawing = paging.PagePart((Paragraph(plain("x")),), of=0)
    parts = [head, text, drawing, head, text, text, text]
    assert paging.pages(parts, [40, 10, 62, 25, 10, 20, 20], 100) == [[0, 1], [2, 3, 4], [5, 6]]
    assert paging.pages(parts, [40, 10, 70, 25, 10, 20, 10], 100) == [[0, 1, 3, 4], [2, 5, 6]]


def test_no_line_of_a_section_stands_alone():
    text = paging.PagePart((Paragraph(plain("x")),))
    head = paging.PagePart((HandoutHeading(plain("x")), Paragraph(plain("x"))))
    # the first section's last line is not the first of a page, nor a heading with its line the last
    assert paging.pages([head, text, text, head, text], [20, 40, 30, 20, 40], 115) == [[0, 1, 2], [3, 4]]
    lines = [text, text, text, head, text, text]
    assert paging.pages(lines, [44, 44, 6, 20, 60, 90], 100) == [[0, 1, 2], [3, 4], [5]]


def test_units_and_fractions_are_not_broken():
    from graphkin.handouts.typst import _run

    for text in ("14.1 rad/s² (", "0.0762/0.0025 = 30.48"):
        assert "/\u2060" in _run(plain(text)[0])


def test_what_leads_holds_on_to_what_follows():
    blocks = handout([loaded("ex3-1")], "half", "en").blocks[1:]
    for part in paging.page_parts(blocks):
        last = part.blocks[-1]
        assert not isinstance(last, HandoutHeading | NameLine)
        assert not (isinstance(last, Paragraph) and last.words[-1].text.endswith(":"))
    assert sum(part.of is not None for part in paging.page_parts(blocks)) == 2


@pytest.mark.parametrize(
    ("text", "slanted"),
    [
        ("From A lay off AB; a circle about B meets it at a.", ["A", "AB", "B", "a"]),
        ("A and D are at rest, so a and d lie on p.", ["A", "D", "a", "d", "p"]),
        ("It is as long as pc, carried to C; do so at bd.", ["p", "c", "C", "b", "d"]),
        ("A line at 5 m from D, 3 m/s along CX, e.g. 0.2 s.", ["D"]),
        ("固定点 A、D 不动，故 a、d 与 p 重合，与 x 轴正向成 60°，10 m/s。", ["A", "D", "a", "d", "p", "x"]),
    ],
)
def test_letters_of_points_are_in_italics(text, slanted):
    runs = lettered(text, ("A", "B", "C", "D"))
    assert "".join(run.text for run in runs) == text
    slants = "".join(run.text for run in runs if run.italic)
    assert slants == "".join(slanted)


STORY = """text = { en = "The crank AB turns evenly.", zh = "曲柄 AB 匀速转动。" }
[points]
"omega 3" = 4
"""


def test_a_story_stands_before_what_is_given():
    text = STORY.split("\n", 1)[0] + "\n" + library.text("ex3-1") + STORY.split("\n", 1)[1]
    machine = graphkin.loads(text)
    for stage, lang, story, worth in (
        ("problem", "en", "The crank AB turns evenly.", "(points: 8)"), ("solution", "zh", "曲柄 AB 匀速转动。", "（8 分）"),
    ):  # fmt: skip
        title, *blocks = [each for each in handout([machine], stage, lang).blocks if isinstance(each, Paragraph | HandoutHeading)]
        assert any(machine.credit(lang) in plain_text(each.words) for each in blocks)  # as the sheet has it
        blocks = blocks[stage == "solution" :]
        assert "".join(run.text for run in blocks[0].words) == story
        assert "".join(run.text for run in title.words).endswith(worth)
        assert next(text_lines(drawn_problem(machine, lang).posed, lang)).strip() == story


def test_problems_and_figures_have_numbers(tmp_path):
    """From a number on; a name is written where the problem is nobody's own."""
    done = CliRunner().invoke(
        main, ["handout", "ex3-1", "p3-6a", "--stage", "problem", "--number", "7", "--lang", "en", "-o", str(tmp_path / "a.pdf")]
    )
    assert done.exit_code == 0, done.output
    lines = [line.text for page in pages((tmp_path / "a.pdf").read_bytes()) for line in page]
    assert [line[:10] for line in lines if line.startswith("Problem")] == ["Problem 7.", "Problem 8."]
    figures = [line for line in lines if re.fullmatch(r"Fig\. \d", line)]
    assert figures == ["Fig. 1", "Fig. 2"]
    assert any(line.startswith("Name") for line in lines)
    solved = handout([loaded("ex3-1")], "solution", "en").blocks
    numbers = [block.number for block in solved if isinstance(block, HandoutPicture)]
    assert numbers == ["Fig. 1", "Fig. 2 (steps 1–2)", "Fig. 3 (steps 3–6)"]  # which may stand before the last of them
    mine = handout([loaded("ex3-1")], "problem", "en", whose=[Student("20240001", (("name", "Li Lei"),))]).blocks
    assert not any(isinstance(block, NameLine) for block in mine)
    assert [block.number for block in mine if isinstance(block, HandoutPicture)] == ["Fig. 1"]
    assert drawn_problem(loaded("ex3-1"), "en").title in "".join(run.text for run in mine[1].words)


@needs_chinese
def test_each_half_lists_its_own_problems():
    names = ("ex3-1", "ex3-5", "p3-6a", "ex3-7")
    made = in_languages([loaded(name) for name in names], "problem", ("en", "zh"))
    page = html(made)
    assert page.count("<li>") == 8
    assert len(re.findall("<section lang=", page)) == 2
    listed = [page for page in read(pdf(made)) if page.body[0].text in ("Problems", "目录")]
    assert [len(page.body) for page in listed] == [5, 5]


def test_a_problem_is_one_block_and_gives_no_angle_away():
    """Data, question and figure in this order, the room for answers behind them; asked for an angle, it stands elsewhere."""
    for name, elsewhere in (("ex3-5", True), ("ex3-1", False)):
        blocks = handout([loaded(name)], "problem", "en").blocks[1:]
        (part,) = paging.page_parts(blocks)
        assert part.blocks == tuple(blocks)
        (figure,) = (block for block in blocks if isinstance(block, HandoutPicture))
        assert bool(figure.note) is elsewhere
        told = {"".join(run.text for run in mark.label) for mark in figure.sheet.marks if isinstance(mark, Text)}
        assert any(text.startswith("φ") and "=" in text for text in told) is not elsewhere
        assert any(text.startswith("φ") for text in told)
        assert (figure.sheet.drivers != graphkin.Drawing.of(loaded(name)).plot.facts.values) is elsewhere
        assert len(read(pdf(handout([loaded(name)], "problem", "en")))) == 1


@needs_chinese
@pytest.mark.parametrize(("name", "lang"), [("curved-slot", "en"), ("s2-1a", "zh"), ("s3-ic", "zh")])
def test_a_problem_has_room_on_its_page(name, lang):
    """With a column for each of several positions, a smaller figure where much is asked; still each answer has a box."""
    made = handout([loaded(name)], "problem", lang)
    assert len(read(pdf(made))) == 1
    (table,) = (block for block in made.blocks if isinstance(block, HandoutTable))
    places = 1 + len(loaded(name).drivers[0].also)
    assert len(table.heads) == (2 + places if places > 1 else 4)
    assert len(table.rows) >= len(loaded(name).ask)


def test_a_figure_that_would_be_far_too_small_stands_on_the_next_page():
    """At the scale to use, so that directions can be taken from it; the room for answers is behind it."""
    made = handout([loaded("s3-guide")], "blank", "en")
    (figure,) = (block for block in made.blocks if isinstance(block, HandoutPicture))
    assert figure.sheet.scales == pytest.approx({"position": 0.0006})
    assert figure.note == ""
    assert [any(line.role == "Figure" for line in page.body) for page in read(pdf(made))][:2] == [False, True]


def test_a_worksheet_with_many_vectors_is_one_page():
    """Three equations, gridded paper and the table to measure into stand on one page; the mechanism has one before."""
    content = pdf(handout([graphkin.load(TEXTBOOK / "scissors.toml")], "blank", "en"))
    assert len(read(content)) == 1 + 3
