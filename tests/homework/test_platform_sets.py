"""Problem sets for platforms: read back by small readers of our own and graded as the platforms grade."""

from __future__ import annotations

import csv
import io
import math
import os
import re
import zipfile
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner
from defusedxml.ElementTree import fromstring
from hypothesis import given, settings
from hypothesis import strategies as st
from moodle_rules import imported, shown
from qti_rules import check_items, check_manifest

import graphkin
from graphkin.cli import main
from graphkin.cli.problems import PLATFORMS
from graphkin.errors import GraphkinError, NotForPlatform
from graphkin.homework import grading
from graphkin.homework.platforms import write_set
from graphkin.homework.platforms.markup import broken, one_line
from graphkin.homework.platforms.question import Part, ProblemSet, Question, Wrong, alternatives, question_of
from graphkin.homework.platforms.set_formats import SETS, weights
from graphkin.homework.platforms.tables import line, points, read_table, unharmed
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, StudentWork
from graphkin.model.quantities import EDGE, read
from graphkin.outputs.files import FileInTheWay
from graphkin.outputs.typesetting import signs
from graphkin.sheet.lettering import formula

HOSTILE = (
    "plain", "a\"b'c", "x~y#z}w{v\\u", "\\", "~", "#", "}", "}~=1:1#", "{1:NUMERICAL:=1:9}", "{#1}", "<b>&amp;</b>",
    "]]><x>", "=cmd|' /C calc'!A0", "+1+1", "-2", "@SUM(A1)", "\t=1", "../../etc/passwd", "C:\\con", "学生一", "%50%3:1",
    "a\nb\r\nc", "\x00\x1b[31m\ud800\uffff", "'=1", "''=1", "a//b/", "\u2028x", "trailing\\", "&#125;", "😀", "ends in {", " ",
)  # fmt: skip
"""Names, ids and texts that break carelessly written files."""
OMEGA = Part("omega 3", -1.25, 0.025, "rad/s", 2.0, (
    Wrong(("omega-sense",), 1.25, 0.025, {"en": "The sense is wrong.", "zh": "转向错误。"}),
    Wrong(("wrong-length",), -2.0, 0.04, {"en": "The length is another link's.", "zh": "长度取错。"}),
), has_sense=True)  # fmt: skip
ALPHA = Part("alpha 3", 62.2, 3.1, "rad/s^2", 3.0, (
    Wrong(("coriolis-omitted", "block-omega"), 12.46, 2.0, {"en": "No Coriolis term.", "zh": "漏了科氏加速度。"}),
    Wrong(("coriolis-reversed",), -37.3, 2.5, {"en": "The Coriolis term points the other way.", "zh": "科氏加速度反向。"}),
    Wrong(("too-near",), 66.0, 2.0, {"en": "hidden", "zh": "hidden"}),
))  # fmt: skip
SET = ProblemSet("shaper", [Question("s1", {"en": "Find.", "zh": "求。"}, (OMEGA, ALPHA))])


def written(tmp_path: Path, kind: str, problems: ProblemSet = SET, lang="en") -> Path:
    path = tmp_path / f"set{SETS[kind].suffix}"
    write_set(path, problems, kind, lang, force=True)
    return path


def hostile_set() -> ProblemSet:
    """Every hostile text as an id, a problem, a name, a unit, a mistake and its sentence."""
    questions = []
    for k, text in enumerate(HOSTILE):
        wrong = Wrong((text,), 5.0 + k, 0.25, {"en": text, "zh": text})
        part = Part(text, -1.5 - k, 0.01, text, 1.0, (wrong,))
        questions.append(Question(text, {"en": text, "zh": text}, (part, OMEGA)))
    return ProblemSet(HOSTILE[2], questions)


def visible(text: str) -> str:
    """A text as any file may change it: what steers is gone, breaks are room."""
    kept = re.sub("[\x00-\x08\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]", "", text)
    return " ".join(kept.split())


def letters(text: str) -> str:
    """What can be read of a text."""
    return re.sub(r"\s", "", visible(text))


def typeset(text: str) -> str:
    """The same of one whose quantities are set: letters, then what is lowered, then what is raised."""
    every = (sign for line in broken(text) for sign in signs(formula(line)))
    return letters("".join(run.text for sign in every for runs in sign.runs for run in runs))


# --- alternatives -----------------------------------------------------------------------------


def held(part: Part, value: float):
    return next((one for one in alternatives(SET.questions[0], part) if one.holds(Decimal(repr(value)))), None)


@pytest.mark.parametrize(
    ("value", "percent", "ids"),
    [
        (-1.25, 100, ()), (-1.275, 100, ()), (-1.225, 100, ()), (-1.2751, None, None),
        (1.25, 50, ("omega-sense",)), (1.2251, 50, ("omega-sense",)), (1.2249, None, None), (-2.0, 0, ("wrong-length",)), (0.0, None, None),
    ],
)  # fmt: skip
def test_alternatives(value, percent, ids):
    found = held(OMEGA, value)
    assert (found and found.percent) == percent
    assert (found and found.ids) == ids


def test_right_numbers_come_first_then_the_other_sense_then_mistakes_by_tolerance():
    there = alternatives(SET.questions[0], replace(ALPHA, has_sense=True))
    assert [one.percent for one in there] == [100, 50, 0, 0]
    assert there[2].tolerance < there[3].tolerance
    assert [one.percent for one in alternatives(SET.questions[0], ALPHA)] == [100, 0, 0]


def test_a_mistake_that_touches_the_right_value_is_left_out():
    assert all("too-near" not in one.ids for one in alternatives(SET.questions[0], ALPHA))


@pytest.mark.parametrize("name", ["ex3-1", pytest.param("ex3-5", marks=pytest.mark.further), "p3-14"])
def test_a_number_is_worth_what_it_is_to_grade(name):
    """Right, wrong but for its sense, or wrong: whatever is handed in alone, off by whatever part of the tolerance."""
    mechanism = graphkin.load(name)
    marker = Marker(grading.key_for(mechanism))
    question = question_of("s1", marker.key, {"en": "?", "zh": "?"})
    for part, entry in zip(question.parts, (one for one in marker.key.entries if one.points), strict=True):
        factor = EDGE[entry.unit].factor
        values = [sign * entry.right + off * entry.allowed for sign in (1, -1) for off in (-2.4, -1.1, -0.9, 0, 0.9, 1.1, 2.4)]
        works = [StudentWork(str(k), {entry.text: HandedNumber(value)}) for k, value in enumerate(values)]
        for value, marked in zip(values, marker.mark(works), strict=True):
            (one,) = (each for each in marked.judged if each.text == entry.text)
            there = (a for a in alternatives(question, part) if a.holds(Decimal(repr(value * factor))))
            assert next((a.percent for a in there), 0) == 100 * one.credit, (entry.text, value)


def test_mistakes_that_give_the_same_are_said_together():
    wrongs = (Wrong(("a",), 20.0, 0.5, {"en": "A.", "zh": "A。"}), Wrong(("b",), 20.1, 0.6, {"en": "B.", "zh": "B。"}))
    part = Part("v", 10.0, 1.0, "", 1.0, wrongs)
    assert held(part, 20.1).ids == ("a", "b")
    assert held(part, 20.65).ids == ("b",)


def test_any_right_number_counts():
    part = Part("theta 3", 170.0, 1.0, "deg", 1.0, (), also=(-190.0,))
    assert held(part, -190.4).percent == 100
    assert held(part, -192.0) is None


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_a_key_without_a_number_is_refused(bad, tmp_path: Path):
    for part in (Part("v", bad, 1.0, ""), Part("v", 1.0, bad, ""), Part("v", 1.0, -1.0, "")):
        for kind in SETS:
            with pytest.raises(GraphkinError):
                written(tmp_path, kind, ProblemSet("s", [Question("q", {"en": "", "zh": ""}, (part,))]))
    assert not [*tmp_path.iterdir()]


def test_a_mistake_without_a_number_is_passed_over():
    part = Part("v", 1.0, 0.1, "", 1.0, (Wrong(("m",), float("nan"), 0.1, {}), Wrong(("m",), 2.0, float("inf"), {})))
    assert [one.percent for one in alternatives(SET.questions[0], part)] == [100]


# --- Moodle -----------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["moodle", "moodle-numerical"])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_moodle_grades(kind, lang, tmp_path: Path):
    fields = [field for question in imported(written(tmp_path, kind, lang=lang)) for field in question.fields]
    for field, part in zip(fields, (OMEGA, ALPHA), strict=True):
        assert field.weight == part.points
        assert field.grade(part.number)[0] == 1
        assert field.grade(part.number - 1.01 * part.tolerance) == (0, "")
        for wrong in part.wrongs:
            if wrong.ids != ("too-near",):
                share, said = field.grade(wrong.number)
                assert share == (0.5 if wrong.ids == ("omega-sense",) else 0)
                assert wrong.mistake[lang].rstrip(".。") in shown(said)
        assert field.grade(1e6) == (0, "")


@pytest.mark.parametrize("kind", ["moodle", "moodle-numerical"])
def test_moodle_takes_hostile_texts(kind, tmp_path: Path):
    problems = hostile_set()
    found = imported(written(tmp_path, kind, problems))
    fields = [field for question in found for field in question.fields]
    assert len(fields) == 2 * len(HOSTILE)
    for question, own, other in zip(problems.questions, fields[::2], fields[1::2], strict=True):
        wrong = question.parts[0].wrongs[0]
        share, said = own.grade(wrong.number)
        assert share == 0
        assert " ".join(shown(said).split()) == visible(f"This number is consistent with: {wrong.mistake['en']}.")
        assert own.grade(question.parts[0].number)[0] == other.grade(-1.25)[0] == 1
        text = next(one.text for one in found if own in one.fields)
        assert typeset(question.text["en"]) in letters(shown(re.sub("</?(p|i|math|m[a-z]+)>|<br>", " ", text)))


def test_moodle_tells_the_mistakes_of_random_problems(tmp_path: Path):
    """Right -> full, each mistake -> its own words at 0 %, whatever the numbers are."""
    random = Random(12)
    questions = [Question(str(k), {"en": "?", "zh": "?"}, (_random_part(random),)) for k in range(60)]
    for question, got in zip(questions, imported(written(tmp_path, "moodle", ProblemSet("r", questions))), strict=True):
        (part,), (field,) = question.parts, got.fields
        assert field.grade(part.number)[0] == 1
        for edge in (0.999, -0.999):
            assert field.grade(part.number + edge * part.tolerance)[0] == 1
        kept = {name for one in alternatives(question, part) for name in one.ids}
        for wrong in part.wrongs:
            share, said = field.grade(wrong.number)
            apart = abs(wrong.number - part.number) > (part.tolerance + wrong.tolerance) * 1.003
            assert (wrong.ids[0] in kept) >= apart
            if apart:
                assert share == 0
                assert wrong.mistake["en"] in said


def _random_part(random: Random) -> Part:
    size = 10 ** random.uniform(-6, 6)
    number, tolerance = random.uniform(-1, 1) * size, size * 10 ** random.uniform(-4, -1)
    wrongs = (
        Wrong((f"m{k}",), random.uniform(-1.2, 1.2) * size, tolerance * random.uniform(0.3, 3), {"en": f"(m{k})", "zh": ""})
        for k in range(12)
    )
    return Part("v E", number, tolerance, "m/s", 1.0, tuple(wrongs))


@pytest.mark.parametrize(
    ("worth", "whole"),
    [((2.0, 3.0), (2, 3)), ((1.5, 1.0), (3, 2)), ((0.25, 1.0, 0.5), (1, 4, 2)), ((0.0, 1.0), (0, 1)), ((1 / 3,), (33,))],
)
def test_weights_are_whole_and_in_proportion(worth, whole):
    assert weights([Part("v", 1.0, 0.1, "", each) for each in worth]) == whole


@pytest.mark.parametrize("name", ["ex3-1", pytest.param("ex3-5", marks=pytest.mark.further), "p3-14"])
def test_moodle_tells_the_mistakes_of_a_key(name, tmp_path: Path):
    """A library mechanism's own key: what tells its mistakes is there, and the right values are right."""
    mechanism = graphkin.load(name)
    asked = [read(mechanism, text) for text in (*mechanism.ask, f"theta {mechanism.moving[-1]}")]
    key = grading.key_for(mechanism, quantities=asked)
    question = question_of("s1", key, {"en": "?", "zh": "?"})
    asked = [entry for entry in key.entries if entry.points]
    (found,) = imported(written(tmp_path, "moodle", ProblemSet("r", [question])))
    for part, field, entry in zip(question.parts, found.fields, asked, strict=True):
        factor = EDGE[entry.unit].factor
        for off in (0.0, 0.99, -0.99):
            assert field.grade((entry.right + off * entry.tolerance) * factor)[0] == 1
        there = alternatives(question, part)
        ids = {id for one in there for id in one.ids}
        assert ids or entry.sort == "angle"
        for wrong in part.wrongs:
            first = next((one for one in there if one.holds(Decimal(repr(wrong.number)))), None)
            if first is not None and first.percent < 100:
                share, said = field.grade(wrong.number)
                assert share == first.percent / 100
                assert "consistent with" in said
                assert wrong.ids[0] in first.ids
            else:
                off = abs(wrong.number - part.number) - part.tolerance - wrong.tolerance
                assert off <= 0.004 * (part.tolerance + wrong.tolerance)
        column = key.entries.index(entry)
        scatters = [float(x) for x in key.singles.scatters[:, column] if math.isfinite(x)]
        assert [wrong.tolerance for wrong in part.wrongs] == pytest.approx([3 * factor * x for x in scatters])
        if entry.sort == "angle":
            assert field.grade(entry.right * factor - math.copysign(360, entry.right))[0] == 1


@settings(max_examples=int(os.environ.get("GRAPHKIN_RANDOM", "60")), deadline=None)
@given(text=st.text(st.one_of(st.sampled_from("\\\\#~}{=%&;<>:1'\"\n \u0000\u0085"), st.characters()), max_size=30))
def test_moodle_takes_any_text(text, tmp_path_factory: pytest.TempPathFactory):
    """As a problem, a name, a unit and a mistake: Moodle shows what was written, and grades it."""
    wrong = Wrong(("m",), 5.0, 0.25, {"en": f"[{text}]", "zh": ""})
    part = Part(text, -1.5, 0.01, text, 1.0, (wrong,))
    problems = ProblemSet(text, [Question(text, {"en": f"[{text}]", "zh": ""}, (part,))])
    folder = tmp_path_factory.mktemp("any")
    for kind in ("moodle", "moodle-numerical"):
        (question,) = imported(written(folder, kind, problems))
        (field,) = question.fields
        assert [one.fraction for one in field.answers] == [1, 0]
        assert visible(f"[{text}]") in " ".join(shown(field.grade(5.0)[1]).split())
        assert typeset(f"[{text}]") in letters(shown(re.sub("</?(p|i|math|m[a-z]+)>|<br>", " ", question.text)))
    for kind in ("qti", "csv", "xuexitong"):
        written(folder, kind, problems)
    for cell in next(csv.reader(io.StringIO(line([text, "end"]), newline="")), [""])[:1]:
        assert unharmed(cell) == one_line(text)


# --- QTI --------------------------------------------------------------------------------------


def unspaced(data: bytes):
    """An XML tree without its namespaces."""
    root = fromstring(data)
    for node in root.iter():
        node.tag = node.tag.rpartition("}")[2]
    return root


def qti_score(item, value: float) -> float:
    """What an item gives for a number, by its conditions."""
    for condition in item.iter("respcondition"):
        if _holds(condition.find("conditionvar")[0], value):
            return float(condition.findtext("setvar"))
    return 0.0


def _holds(node, value: float) -> bool:
    match node.tag:
        case "or":
            return any(_holds(each, value) for each in node)
        case "and":
            return all(_holds(each, value) for each in node)
        case "varequal":
            return value == float(node.text)
        case "vargte":
            return value >= float(node.text)
        case "varlte":
            return value <= float(node.text)
    raise AssertionError(node.tag)


def bank(path: Path):
    """The one bank of questions that the manifest names; all other files are figures."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        resources = [*unspaced(archive.read("imsmanifest.xml")).iter("resource")]
        (bank,) = (each for each in resources if each.attrib["type"] == "imsqti_xmlv1p2")
        name = bank.find("file").attrib["href"]
        check_manifest(archive.read("imsmanifest.xml"))
        check_items(archive.read(name))
        assert name == f"{bank.attrib['identifier']}/{bank.attrib['identifier']}.xml"
        assert {each.attrib["type"] for each in resources if each is not bank} <= {"webcontent"}
        files = {file.attrib["href"] for each in resources for file in each.iter("file")}
        assert files | {"imsmanifest.xml"} == set(archive.namelist())
        tree = unspaced(archive.read(name))
        for source in re.findall('img src="([^"]*)"', " ".join(each.text or "" for each in tree.iter("mattext"))):
            assert source.removeprefix("%24IMS-CC-FILEBASE%24/") in files
    assert [each.tag for each in tree] == ["objectbank"]
    return tree.find("objectbank")


def field(item, label: str) -> str:
    return next(each.findtext("fieldentry") for each in item.iter("qtimetadatafield") if each.findtext("fieldlabel") == label)


def test_qti_grades(tmp_path: Path):
    tree = bank(written(tmp_path, "qti"))
    assert field(tree, "bank_title") == "shaper"
    for item, part in zip(tree.iter("item"), (OMEGA, ALPHA), strict=True):
        assert field(item, "question_type") == "numerical_question"
        assert float(field(item, "points_possible")) == part.points
        assert item.find("presentation/response_str/render_fib").attrib["fibtype"] == "Decimal"
        for value, score in ((0.0, 100), (0.99, 100), (-0.99, 100), (1.01, 0), (-2.0, 0)):
            assert qti_score(item, part.number + value * part.tolerance) == score
        for wrong in part.wrongs[:2]:
            assert qti_score(item, wrong.number) == 0
        assert len([*item.iter("respcondition")]) == 1, "Canvas gives all points for any answer that is listed"


def test_qti_takes_hostile_texts(tmp_path: Path):
    idents = [node.attrib["ident"] for node in bank(written(tmp_path, "qti", hostile_set())).iter("item")]
    assert len(set(idents)) == len(idents) == 2 * len(HOSTILE)
    assert all(re.fullmatch("[A-Za-z_][A-Za-z0-9_]*", ident) for ident in idents)


def test_qti_refuses_what_canvas_rounds_away(tmp_path: Path):
    part = Part("v E", 5e-5, 1e-6, "m/s")
    with pytest.raises(NotForPlatform) as refused:
        written(tmp_path, "qti", ProblemSet("s", [Question("q", {"en": "", "zh": ""}, (part,))]))
    assert "0.00005" in refused.value.message("en")
    assert not [*tmp_path.iterdir()]


# --- tables and Word --------------------------------------------------------------------------


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_csv_has_every_alternative(lang, tmp_path: Path):
    data = written(tmp_path, "csv", lang=lang).read_bytes()
    rows = [*csv.reader(io.StringIO(data.decode("utf-8-sig"), newline=""))]
    assert len(rows[0]) == 10
    told = [(row[0], row[2], int(row[5]), Decimal(row[6]), Decimal(row[7])) for row in rows[1:]]
    there = [
        ("s1", part.name, one.percent, one.number, one.tolerance)
        for part in (OMEGA, ALPHA) for one in alternatives(SET.questions[0], part)
    ]  # fmt: skip
    assert told == there


def test_no_cell_is_a_formula(tmp_path: Path):
    path = written(tmp_path, "csv", hostile_set())
    for row in csv.reader(io.StringIO(path.read_text("utf-8-sig"), newline="")):
        for cell in row:
            assert not cell.startswith(("=", "+", "@", "\t", "\r")), cell
            assert not cell.startswith("-") or re.fullmatch(r"-[0-9.]+", cell), cell
    back = [row[0] for row in read_table(path)][1:]
    assert {text for text in back if text} >= {visible(text) for text in HOSTILE if "=" in text and "\t" not in text}


def test_word_file_is_plain_paragraphs(tmp_path: Path):
    path = written(tmp_path, "xuexitong", lang="zh")
    with zipfile.ZipFile(path) as archive:
        assert archive.namelist()[0] == "[Content_Types].xml"
        document = unspaced(archive.read("word/document.xml"))
        targets = [each.attrib["Target"] for each in unspaced(archive.read("_rels/.rels"))]
    assert targets == ["word/document.xml"]
    lines = ["".join(node.text for node in paragraph.iter("t")) for paragraph in document.iter("p")]
    assert lines[0].startswith("1.【填空题】")
    assert lines[1] == "答案：-1.25"
    assert lines[2] == "答案解析：±0.025"
    assert lines[3].startswith("2.【填空题】")
    assert lines[4] == "答案：62.2"


def test_word_file_takes_hostile_texts(tmp_path: Path):
    with zipfile.ZipFile(written(tmp_path, "xuexitong", hostile_set())) as archive:
        document = unspaced(archive.read("word/document.xml"))
    lines = ["".join(node.text for node in paragraph.iter("t")) for paragraph in document.iter("p")]
    assert len(lines) == 6 * len(HOSTILE)
    for number, (question, answer) in enumerate(zip(lines[::3], lines[1::3], strict=True), 1):
        assert question.startswith(f"{number}.【填空题】")
        assert re.fullmatch(r"答案：-?[0-9.]+", answer)


def test_word_file_opens_in_a_word_reader(tmp_path: Path):
    docx = pytest.importorskip("docx")
    found = [paragraph.text for paragraph in docx.Document(str(written(tmp_path, "xuexitong"))).paragraphs]
    assert found[1] == "答案：-1.25"


def test_the_table_for_excel_has_a_row_a_blank(tmp_path: Path):
    openpyxl = pytest.importorskip("openpyxl")
    head, *rows = openpyxl.load_workbook(written(tmp_path, "xuexitong-xlsx", lang="zh"))["课程题库"].iter_rows(values_only=True)
    assert [(row[head.index("正确答案")], row[head.index("选项A")], row[head.index("选项数")]) for row in rows] == [
        ("-1.25", "-1.25", 1), ("62.2", "62.2", 1),
    ]  # fmt: skip
    assert {row[head.index("题目类型")] for row in rows} == {"填空题"}
    assert all(row[head.index("大题题干")].endswith("= ____") for row in rows)
    hostile = openpyxl.load_workbook(written(tmp_path, "xuexitong-xlsx", hostile_set()))["课程题库"]
    assert len([*hostile.iter_rows(min_row=2)]) == 2 * len(HOSTILE)


# --- the command ------------------------------------------------------------------------------

TEMPLATE = """
ask = ["omega 3", "alpha 3"]
[points]
"omega 3" = 2
"alpha 3" = 1.5
[frame]
name = "4"
A = [0, 0]
D = [78, 0]
[links.1]
AB = { from = 20, to = 28, step = 1 }
[links.2]
points = ["B"]
[links.3]
DC = 48
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
from = "DC"
angle = 100
[[driver]]
vector = "AB"
angle = { from = 40, to = 120, step = 5 }
omega = 10
[sketch]
C = [65, 46]
"""


def test_the_command_writes_sets(tmp_path: Path):
    template, out = tmp_path / "shaper.toml", tmp_path / "out" / "teacher"
    template.write_text(TEMPLATE)
    words = ["problems", str(template), "--students", "2", "-o", str(tmp_path / "out"), "--lang", "zh"]
    formats = [word for kind in SETS for word in ("--format", kind)]
    done = CliRunner().invoke(main, [*words, *formats])
    assert done.exit_code == 0, done.output
    found = imported(out / "set-moodle.xml")
    assert [one.name for one in found] == ["shaper s1", "shaper s2"]
    for one, name in zip(found, ("s1", "s2"), strict=True):
        key = grading.key_from(str(out / f"{name}.key.json"))
        right = {entry.text: entry for entry in key.entries}
        for field, asked, weight in zip(one.fields, ("omega 3", "alpha 3"), (4, 3), strict=True):
            assert field.weight == weight
            assert field.grade(right[asked].right)[0] == 1
            assert field.grade(right[asked].right + 0.98 * right[asked].tolerance)[0] == 1
        assert "<mi>AB</mi>" in one.text
        assert not re.search("omega|alpha|points|AB =", one.text), "letters of the sheets, and no words of the file"
        assert 'src="@@PLUGINFILE@@/figure.svg"' in one.text
    assert len(imported(out / "set-moodle-numerical.xml")) == 4
    assert len([*bank(out / "set-qti.zip").iter("item")]) == 4
    assert {path.name for path in out.iterdir()} >= {"set-csv.csv", "set-xuexitong.docx", "set.json", "s1.toml"}
    again = CliRunner().invoke(main, [*words, "--format", "moodle"])
    assert again.exit_code == 0, "its own files are written anew"
    assert set(PLATFORMS) == set(SETS)


# --- all of them ------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", SETS)
def test_same_bytes(kind, tmp_path: Path):
    first = written(tmp_path, kind, hostile_set()).read_bytes()
    assert written(tmp_path, kind, hostile_set()).read_bytes() == first
    if zipfile.is_zipfile(io.BytesIO(first)):
        assert {each.date_time for each in zipfile.ZipFile(io.BytesIO(first)).infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_totals_are_equal(tmp_path: Path):
    """Points and numbers of every format are those of one value, rounding included."""
    parts = tuple(Part(f"v {name}", 1 / 3 + k, 0.01 / 3, "m/s", worth) for k, (name, worth) in enumerate(
        (("A", 1.5), ("B", 2 / 3), ("C", 0.125), ("D", 1.005))
    ))  # fmt: skip
    question = Question("s", {"en": "?", "zh": "?"}, parts)
    problems = ProblemSet("t", [question])
    total = sum(points(part.points) for part in parts)
    assert total == Decimal("3.31")
    cloze = imported(written(tmp_path, "moodle", problems))[0].fields
    single = [one.fields[0] for one in imported(written(tmp_path, "moodle-numerical", problems))]
    assert sum(Decimal(str(each.weight)) for each in single) == total
    assert [each.weight / cloze[0].weight for each in cloze] == pytest.approx([each.weight / single[0].weight for each in single])
    tree = bank(written(tmp_path, "qti", problems))
    assert sum(Decimal(field(item, "points_possible")) for item in tree.iter("item")) == total
    rows = [*read_table(written(tmp_path, "csv", problems))][1:]
    assert sum(Decimal(row[4]) for row in rows if row[5] == "100") == total
    for part, one, item in zip(parts, cloze, tree.iter("item"), strict=True):
        right = alternatives(question, part)[0]
        assert {one.answers[0].number, float(item.find(".//varequal").text)} == {float(right.number)}


@pytest.mark.parametrize("kind", SETS)
def test_a_foreign_file_is_not_replaced(kind, tmp_path: Path):
    path = tmp_path / f"set{SETS[kind].suffix}"
    path.write_bytes(b"another's work")
    with pytest.raises(FileInTheWay):
        write_set(path, SET, kind)
    assert path.read_bytes() == b"another's work"
    write_set(path, SET, kind, force=True)
    write_set(path, SET, kind)
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_a_factor_is_told_once():
    """Of one value, of all of its unit, carried on: for one number these are one."""
    question = question_of("q", grading.key_from("ex3-5"), {"en": "", "zh": ""})
    for part in question.parts:
        for one in alternatives(question, part):
            told = [text["en"].partition(" of a unit")[0] for text in one.mistakes if "factor" in text["en"]]
            assert len(told) == len(set(told))
