"""Problem sets: each student's own numbers, the same again whenever they are drawn, and always solvable on paper."""

from __future__ import annotations

import cmath
import json
import math
import re
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest
from click.testing import CliRunner
from reading_all import read
from template_text import TEXT, variants

from graphkin import api
from graphkin import files as loading
from graphkin.cli import main
from graphkin.errors import (
    ExcelInside,
    GraphkinError,
    Lang,
    NoRange,
    NotATemplate,
    NotBetween,
    NoVariant,
    StudentTwice,
    StudentWithoutId,
    TooDeep,
    UnknownQuantity,
)
from graphkin.files import library
from graphkin.handouts import problem_folder
from graphkin.handouts.problem import drawn_problem
from graphkin.handouts.problem_folder import SetOrder, write_problems
from graphkin.homework.grading import key_for
from graphkin.homework.problems import Variant, draws, read_template, roster, well_posed
from graphkin.homework.problems.carried import carried
from graphkin.homework.problems.posed import shown_at
from graphkin.outputs.files import FileInTheWay
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say.entry import text_lines
from graphkin.submissions import ReadableProblem, Student


@pytest.fixture
def template(tmp_path: Path) -> Path:
    path = tmp_path / "slide.toml"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_a_template_is_its_own_text_with_numbers_in_it(template: Path):
    read_one = read_template(template)
    assert [each.name for each in read_one.ranges] == ["frame.D.0", "links.1.AB", "driver.0.angle", "driver.0.omega"]
    assert [each.count for each in read_one.ranges] == [21, 9, 25, 7]
    text = read_one.text([1, 0, 6, 3])
    assert "D = [74.5, 0]" in text
    assert "AB = 20   # crank" in text
    assert 'omega = "90 rpm"' in text
    assert "# a comment with AB = { from = 1, to = 2 } in it" in text
    assert read_one.mechanism([1, 0, 6, 3]).worth == {"omega 3": 2, "alpha 3": 3, "a_k B3B2": 1}
    assert read_one.mechanism([1, 0, 6, 3]).drivers[0].rate == pytest.approx(3 * math.pi)


def test_numbers_hang_on_seed_and_id_and_on_no_order(template: Path, known: dict[object, object]):
    read_one, students = read_template(template), roster("4")
    found = {v.student.id: v.numbers for v in variants(read_one, students, "7")}
    known.clear()
    again = {v.student.id: v.numbers for v in variants(read_one, students[::-1], "7")}
    few = {v.student.id: v.numbers for v in variants(read_one, students[1:3], "7")}
    assert found == again
    assert few.items() <= found.items()
    assert found != {v.student.id: v.numbers for v in variants(read_one, students, "3")}
    assert len(set(found.values())) == len(found)


def test_every_variant_is_posed_well(template: Path):
    for variant in variants(read_template(template), roster("4"), "3"):
        found = well_posed(variant.mechanism)
        assert not isinstance(found, str)
        plot = api.replay(api.plan(variant.mechanism))
        assert min(abs(float(sine)) for sine in plot.sines.values()) > math.sin(math.radians(5))
        a = plot.acceleration
        sides = [abs(complex(a[n]) - complex(a[m])) for m, n in (("k'", "b3'"), ("n3'", "b3'"), ("p'", "b2'"), ("b2'", "k'"))]
        assert min(sides[:2]) > 0.02 * max(sides)


@pytest.mark.parametrize(("change", "error"), [
    (("{ from = 20, to = 28, step = 1 }", "{ from = 28, to = 20, step = 1 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = 20, to = 28, step = 0 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = nan, to = 28, step = 1 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = 20, to = 1e300, step = 1 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = 20, to = 28, step = 1e-9 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = 20, to = 28, steps = 1 }"), NoRange),
    (("{ from = 20, to = 28, step = 1 }", "{ from = 20, step = 1 }"), NoRange),
    (('to = "120 rpm"', 'to = "120 rad/s"'), NoRange),
    (('"omega 3" = 2', '"omega 9" = 2'), UnknownQuantity),
    (('"omega 3" = 2', '"omega 3" = -2'), NotBetween),
    (("DC = 48", "DC = 480"), GraphkinError),
    (('omega = { from = "60 rpm", to = "120 rpm", step = "10 rpm" }', "omega = 0"), NoVariant),
    (("angle = 100", "angle = 100\nspeed = 3"), GraphkinError),
])  # fmt: skip
def test_what_is_wrong_with_a_template_is_said(
    template: Path, change: tuple[str, str], error: type[GraphkinError], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr("graphkin.homework.problems.draws._HOPELESS", 3)
    monkeypatch.setattr("graphkin.homework.problems.draws._TRIES", 20)
    monkeypatch.setattr("graphkin.homework.problems.draws._SAMPLE_TRIES", 20)
    assert change[0] in TEXT
    template.write_text(TEXT.replace(*change), encoding="utf-8")
    with pytest.raises(error) as caught:
        variants(read_template(template), roster("1"), "1")
    assert caught.value.message("zh") != caught.value.message("en")


def test_a_template_that_is_nested_too_deep(tmp_path: Path):
    (tmp_path / "a.toml").write_text(f"x = {'[' * 400}{']' * 400}\nlinks.1 = {{ AB = {{ from = 1, to = 2 }} }}\n")
    with pytest.raises(TooDeep):
        read_template(tmp_path / "a.toml")


def test_a_template_without_ranges(tmp_path: Path):
    (tmp_path / "a.toml").write_text(api.load("ex3-1").text, encoding="utf-8")
    with pytest.raises(NotATemplate):
        read_template(tmp_path / "a.toml")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "gb18030", "utf-16"])
def test_a_roster_in_any_encoding(tmp_path: Path, encoding: str):
    path = tmp_path / "class.csv"
    path.write_bytes("姓名,学号\n王小明,2027001\n李雷,2027002\n,\n".encode(encoding))
    assert roster(str(path)) == (Student("2027001", (("姓名", "王小明"),)), Student("2027002", (("姓名", "李雷"),)))


def test_a_bare_list_and_a_number(tmp_path: Path):
    (tmp_path / "a.csv").write_text("s1\ns2\n")
    assert [s.id for s in roster(str(tmp_path / "a.csv"))] == ["s1", "s2"]
    assert [s.id for s in roster("10")][0:10:9] == ["s01", "s10"]
    (tmp_path / "a.csv").write_text("student\ns1\ns1\n")
    with pytest.raises(StudentTwice):
        roster(str(tmp_path / "a.csv"))
    (tmp_path / "a.csv").write_text("id,name\ns1,Anna\n,Bob\n")
    with pytest.raises(StudentWithoutId, match="Bob"):
        roster(str(tmp_path / "a.csv"))


@pytest.mark.parametrize(("table", "called"), [
    ("id,name,email\n101,Anna Li,anna@uni.edu\n", "101 Anna Li"),
    ("学号,姓名,邮箱,登录名\n2027001,王小明,wang@uni.edu,wxm\n", "2027001 王小明"),
    ("First name,Last name,Email address\nAnna,Li,anna@uni.edu\n", "Anna Li"),
    ("email\nanna@uni.edu\n", "anna@uni.edu"),
    ("id\n101\n", "101"),
])  # fmt: skip
def test_a_student_s_page_has_no_address(rocker: Path, tmp_path: Path, table: str, called: str):
    """It stands there only for want of a name; the set's list, for the teacher, has all of the row."""
    (tmp_path / "class.csv").write_text(table, encoding="utf-8")
    students = roster(str(tmp_path / "class.csv"))
    [*_] = write_problems(order(rocker, tmp_path / "set", students))
    (page,) = (path for path in (tmp_path / "set" / "students").glob("*.html") if not path.name.startswith("_"))
    text = page.read_text("utf-8")
    assert f" · {called} (" in text
    assert ("uni.edu" in text) is ("@" in called)
    assert ("uni.edu" in table) is ("uni.edu" in (tmp_path / "set" / "teacher" / "set.json").read_text("utf-8"))


@pytest.mark.parametrize("number", ["0", "-3", "100001", "9" * 30])
def test_so_many_students_are_none(number: str):
    with pytest.raises(NotBetween, match="from 1 to 100,000"):
        roster(number)


@pytest.mark.parametrize("old", [False, True])
def test_a_workbook_by_another_name_is_told(old: bool, tmp_path: Path):
    path = tmp_path / "class.csv"
    openpyxl.Workbook().save(path)
    if old:
        path.write_bytes(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(2000))
    with pytest.raises(ExcelInside, match="this is an Excel file"):
        roster(str(path))


def order(template: Path, folder: Path, students: tuple[Student, ...], seed: str = "1", lang: Lang = "en") -> SetOrder:
    return SetOrder(folder, read_template(template), students, seed, lang)


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.fixture
def rocker(tmp_path: Path) -> Path:
    """A template that is soon drawn."""
    path = tmp_path / "rocker.toml"
    path.write_text((Path(__file__).parents[1] / "cases/homework/rocker.toml").read_text("utf-8"), encoding="utf-8")
    return path


def test_what_is_written(rocker: Path, tmp_path: Path):
    students = (Student("../../evil"), Student("a/b", (("name", "Ann"),)), Student("A"), Student("a"))
    folder = tmp_path / "out" / "set"
    found = [one for one in write_problems(order(rocker, folder, students)) if isinstance(one, Variant)]
    assert {path.name for path in tmp_path.iterdir()} == {"out", "rocker.toml"}
    listed = json.loads((folder / "teacher" / "set.json").read_text("utf-8"))
    for variant in found:
        entry = listed["students"][variant.student.id]
        assert loading.load(folder / "teacher" / entry["file"]).text.split("\n", 1)[1] == variant.mechanism.text
    page = folder / "students" / listed["students"]["a/b"]["file"].replace(".toml", ".html")
    assert "Ann" in page.read_text("utf-8")
    handed_out = {path.suffix for path in (folder / "students").iterdir()}
    assert handed_out == {".html", ".xlsx"}, "no key and no TOML is handed out"
    before = files(folder)
    list(write_problems(order(rocker, folder, students)))
    assert before == files(folder)
    (folder / "teacher" / "set.json").write_text("mine")
    with pytest.raises(FileInTheWay):
        list(write_problems(order(rocker, folder, students, "2")))
    assert all(before[name] == content for name, content in files(folder).items() if not name.endswith("set.json"))


def test_a_set_goes_on_where_it_was_broken_off(rocker: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Files are there as soon as they are whole, and the same as of a set that was written at once; nothing is made twice."""
    students = roster("3")
    assert len(list(write_problems(order(rocker, tmp_path / "whole", students)))) == 3
    writing = write_problems(order(rocker, tmp_path / "set", students))
    first = next(writing)
    assert sum(name.endswith(".key.json") for name in files(tmp_path / "set")) == 1
    writing.close()
    made: list[object] = []
    monkeypatch.setattr(problem_folder, "key_for", lambda *args: made.append(args) or key_for(*args))
    found = list(write_problems(order(rocker, tmp_path / "set", students)))
    assert first == found[0]
    assert len(made) == 2
    assert files(tmp_path / "set") == files(tmp_path / "whole")
    fewer = [one for one in write_problems(order(rocker, tmp_path / "set", students[:2])) if isinstance(one, Path)]
    gone = {path.name for path in fewer}
    assert gone == {f"s{k}{end}" for k in (3,) for end in (".html", ".toml", ".key.json")}
    assert not gone & {Path(name).name for name in files(tmp_path / "set")}


def test_several_processes_write_the_same(rocker: Path, tmp_path: Path):
    """Also where students would get the same, so that some are drawn once more."""
    text = rocker.read_text("utf-8")
    assert "from = 40, to = 80" in text
    rocker.write_text(text.replace("from = 40, to = 80", "from = 60, to = 65").replace("from = 24", "from = 33"), encoding="utf-8")
    students = roster("3")
    with ThreadPoolExecutor(2) as executor:
        found = list(write_problems(order(rocker, tmp_path / "several", students), executor))
    assert [one.student.id for one in found if isinstance(one, Variant)] == [
        one.student.id for one in write_problems(order(rocker, tmp_path / "one", students)) if isinstance(one, Variant)
    ]
    assert files(tmp_path / "several") == files(tmp_path / "one")


@pytest.mark.parametrize("lang", ["en", "zh"])
def test_the_workbook_reads_back_as_it_is_filled_in(lang: Lang, template: Path, tmp_path: Path):
    list(write_problems(order(template, tmp_path / "set", roster("1"), lang=lang)))
    book = openpyxl.load_workbook(tmp_path / "set" / "students" / "_answers.xlsx")
    rows = {row[0].value: row for row in book.active.iter_rows()}
    rows[{"en": "student number", "zh": "学号"}[lang]][1].value = "s1"
    rows["ω3"][1].value, rows["ω3"][3].value = 3.9, "顺时针"
    rows["aᵏ_B3B2"][1].value, rows["aᵏ_B3B2"][3].value = 2.5, 30  # degrees, as the page's table has them
    book.save(tmp_path / "handed-in.xlsx")
    mechanism = loading.load(tmp_path / "set" / "teacher" / "s1.toml")
    (found,) = read([tmp_path / "handed-in.xlsx"], ReadableProblem(mechanism, mechanism.ask))
    assert (found.student, found.reason) == ("s1", None)
    assert {q: v.value for q, v in found.values.items()} == pytest.approx({"omega 3": -3.9, "a_k B3B2": 2.5})
    assert found.values["a_k B3B2"].vector == pytest.approx(cmath.rect(2.5, math.radians(30)))
    page = (tmp_path / "set" / "students" / "_hand-in.html").read_text("utf-8")
    for text in ("What to hand in", "提交要求", "_answers.xlsx", "20270001.svg", "<mi>n</mi><mn>3</mn>"[:9]):
        assert text in page


def test_few_variants_are_shared_and_said(template: Path, tmp_path: Path):
    narrow = TEXT.replace("from = 74, to = 84, step = 0.5", "from = 78, to = 79, step = 1").replace("from = 20, to = 28", "from = 24, to = 25")
    fixed = narrow.replace("{ from = 30, to = 150, step = 5 }", "60").replace('{ from = "60 rpm", to = "120 rpm", step = "10 rpm" }', "10")
    template.write_text(fixed, encoding="utf-8")
    found = variants(read_template(template), roster("5"), "1")
    assert sum(variant.shared for variant in found) >= 1
    result = CliRunner().invoke(main, ["problems", str(template), "--students", "5", "-o", str(tmp_path / "set"), "--lang", "en"])
    assert "note: " in result.stderr


def test_a_class_larger_than_its_ranges_has_each_problem_about_as_often(template: Path):
    """Only the crank's angle varies: as many as are different come first, then those that the fewest have."""
    text = library.text("ex3-1")
    assert text.count("angle = 60\n") == 1
    template.write_text(text.replace("angle = 60\n", "angle = { from = 20, to = 110, step = 10 }\n"), encoding="utf-8")
    found = variants(read_template(template), roster("14"), "1")
    often = Counter(variant.numbers for variant in found)
    assert 1 < len(often) == sum(not variant.shared for variant in found)
    assert max(often.values()) - min(often.values()) <= 1


def test_numbers_that_are_refused_are_solved_once(template: Path, monkeypatch: pytest.MonkeyPatch):
    """Of two variants that are both no problem 200 draws are made, and each is solved once beside what the paper is found by."""
    fixed = TEXT.replace("{ from = 30, to = 150, step = 5 }", "60").replace('{ from = "60 rpm", to = "120 rpm", step = "10 rpm" }', "10")
    fixed = fixed.replace("from = 74, to = 84, step = 0.5", "from = 78, to = 79, step = 1").replace("{ from = 20, to = 28, step = 1 }", "24")
    template.write_text(fixed, encoding="utf-8")
    solved = []
    monkeypatch.setattr(draws, "well_posed", lambda mechanism: solved.append(mechanism) or "short")
    with pytest.raises(NoVariant, match="a vector too short to measure: 200"):
        variants(read_template(template), roster("3"), "1")
    assert len(solved) <= draws._SAMPLE_TRIES + 2


DRAG_LINK = """ask = ["omega 3", "v C"]
frame = { A = [0, 0], D = [30, 0] }
links = { 1.AB = { from = 60, to = 66, step = 1 }, 2.BC = 62, 3.DC = 70 }
driver = [{ vector = "AB", angle = { from = 0, to = 355, step = 5 }, omega = 10 }]
sketch = { C = [60, 60] }
"""


def test_all_students_have_one_assembly(template: Path, tmp_path: Path):
    """C goes all the way round, so that for half of the crank's angles the sketch is nearer to the crossed linkage."""
    template.write_text(DRAG_LINK, encoding="utf-8")
    result = CliRunner().invoke(main, ["problems", str(template), "--students", "8", "-o", str(tmp_path / "set"), "--lang", "en"])
    assert result.exit_code == 0, result.output
    sides, sketched = set(), []
    for path in sorted((tmp_path / "set" / "teacher").glob("s?.toml")):
        mechanism = loading.load(path)
        place = replay_all(plan(mechanism)).position
        sides.add(math.copysign(1, ((place["C"] - place["B"]) * (place["D"] - place["B"]).conjugate()).imag))
        if mechanism.sketch["C"] != 0.06 + 0.06j:
            sketched.append(path.stem)
            assert abs(mechanism.sketch["C"] - place["C"]) < 1e-5
    assert len(sides) == 1
    assert sketched
    assert f"{len(sketched)} students the sketch is nearer to another assembly, or between two: " in result.stderr
    assert all(name in result.stderr for name in sketched)


def test_numbers_to_which_the_assembly_does_not_lead_are_no_problem(template: Path):
    """A crank longer than its rod turns to and fro on one side of the guide's point; on the other side it would again."""
    text = """ask = ["v C"]
frame.A = [0, 0]
links = { 1.AB = 50, 2.BC = 30, 3.points = ["C"] }
slide = [{ block = "3", point = "C", guide = "frame", through = "A" }]
driver = [{ vector = "AB", angle = { from = -20, to = 199, step = 1 }, omega = 10 }]
sketch = { C = [74, 0] }
"""
    template.write_text(text, encoding="utf-8")
    read_one = read_template(template)
    angle = {k: read_one.mechanism([k]).drivers[0].value for k in (20, 50, 190, 210)}
    assert [round(math.degrees(value)) for value in angle.values()] == [0, 30, 170, 190]
    assert [carried(read_one, [k]) is not None for k in angle] in ([True, True, False, False], [False, False, True, True])
    for k in (190, 210):
        plan(read_one.mechanism([k]))  # it can be put together there


def test_the_command(template: Path, tmp_path: Path):
    """What it writes is in test_week.py."""
    out = tmp_path / "set"
    bad = CliRunner().invoke(main, ["problems", str(template), "--students", str(tmp_path / "no.csv"), "-o", str(out)])
    assert bad.exit_code == 3
    assert "no.csv" in bad.stderr
    assert not out.exists()


@pytest.mark.parametrize(("question", "shown", "angle"), [
    ("omega 3", "ω3.", ""), ("v_y C", "v_C,y.", ""), ("a_k B3B2", "aᵏ_B3B2.", ""), ("omega 3 / omega 2", "ω3/ω2.", ""),
    ("theta 3", "θ3.", "θ3 is the angle of the direction D→C from +x, counter-clockwise."),
    ("theta 2", "θ2.", "θ2 is the angle of the sliding direction on link 3 from +x, counter-clockwise."),
])  # fmt: skip
def test_what_is_asked_is_written_as_in_a_book(question: str, shown: str, angle: str):
    mechanism = loading.loads(re.sub("(?m)^ask .*", f'ask = ["{question}"]', library.load("ex3-1").text))
    assert mechanism.ask == (question,)
    lines = [line.strip() for line in text_lines(drawn_problem(mechanism, "en", "s1").posed, "en")]
    assert lines[lines.index("Find") + 1] == shown
    assert lines[lines.index("Find") + 2 :] == [angle] * bool(angle)


@pytest.mark.parametrize(("question", "there"), [
    ("path E", False), ("x E", False), ("theta 3", False), ("s ram", False), ("P13", False), ("v E", True), ("omega 3", True),
])  # fmt: skip
def test_no_figure_shows_what_is_asked(question: str, there: bool) -> None:
    """What the position alone gives could be measured on the figure."""
    method = plan(replace(library.load("ex3-7"), ask=(question,)))
    shown = shown_at(method, replay_all(method))
    assert shown is not None
    assert shown[1] is there
