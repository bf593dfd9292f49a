"""The commands as a user types them: what they print, what they write, and their exit status."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from graphkin.cli import main
from graphkin.files import library

FOUR_BAR = """
[frame]
A = [0, 0]
D = [80, 0]
[links.1]
AB = 30
[links.2]
BC = 70
[links.3]
DC = 60
[[driver]]
vector = "AB"
angle = 60
omega = 10
[sketch]
C = [80, 60]
"""


pytestmark = pytest.mark.usefixtures("own_folder")


def run(*words: str, text: str | bytes | None = None) -> Result:
    return CliRunner().invoke(main, list(words), input=text)


def mechanism(text: str = FOUR_BAR, name: str = "mine.toml") -> str:
    Path(name).write_text(text, encoding="utf-8")
    return name


def test_draw_writes_here():
    assert run("draw", "ex3-1").exit_code == 0
    assert run("check", "ex3-1.svg").exit_code == 0


def test_a_sheet_that_bears_too_much_is_told():
    """On the paper that is asked for; on its own choice of paper the same mechanism is fine."""
    crowded = run("draw", "p3-17", "--paper", "letter")
    assert "p3-17: more than this paper bears; try --only velocity" in crowded.stderr
    assert crowded.exit_code == 0
    assert run("draw", "p3-17", "--force").stderr == ""


def test_draw_replaces_only_its_own():
    mechanism()
    assert run("draw", "mine.toml").exit_code == 0
    assert run("draw", "mine.toml").exit_code == 0
    Path("mine.svg").write_text("<svg>mine</svg>")
    refused = run("draw", "mine.toml")
    assert refused.exit_code == 3
    assert "mine.svg" in refused.stderr
    assert Path("mine.svg").read_text() == "<svg>mine</svg>"
    assert run("draw", "mine.toml", "--force").exit_code == 0


def test_draw_from_standard_input_to_standard_output():
    result = run("draw", "-", "-o", "-", text=FOUR_BAR)
    assert result.exit_code == 0
    assert result.stdout.startswith("<?xml")
    assert not list(Path().iterdir())


@pytest.mark.parametrize("only", ["position", "velocity", "acceleration"])
def test_draw_one_figure(only: str):
    assert run("draw", "ex3-1", "--only", only, "-o", "one.svg").exit_code == 0
    assert run("check", "one.svg").exit_code == 0


@pytest.mark.parametrize("paper", ["A4", "A3", "A4-landscape", "A3-landscape", "letter"])
def test_draw_on_paper(paper: str):
    assert run("draw", "ex3-1", "--paper", paper).exit_code == 0
    assert run("check", "ex3-1.svg").exit_code == 0


def test_draw_on_no_such_paper():
    result = run("draw", "ex3-1", "--paper", "B5")
    assert result.exit_code in (2, 3)
    assert "B5" in result.stderr
    assert not list(Path().iterdir())


def test_draw_at_another_angle():
    assert run("draw", "ex3-1", "--angle", "120").exit_code == 0
    assert run("check", "ex3-1.svg").exit_code == 0
    assert run("draw", "ex3-1", "--angle", "120", "--angle", "7").exit_code == 2
    assert run("draw", "ex3-1", "--at", "12").exit_code == 2
    assert run("draw", "ex3-1", "--angle", "nan").exit_code == 2


def test_draw_steps():
    assert run("draw", "ex3-1", "--steps", "steps").exit_code == 0
    pages = sorted(Path("steps").iterdir())
    assert len(pages) > 10
    assert {"ex3-1-01.svg"} < {page.name for page in pages}
    assert not Path("ex3-1.svg").exists()
    assert run("draw", "ex3-1", "--steps", "steps", "-o", "whole.svg").exit_code == 0
    assert Path("whole.svg").exists()
    for page in pages:
        assert run("check", str(page)).exit_code == 0, page


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_solve_json(name: str):
    result = run("solve", "--json", name)
    assert result.exit_code == 0, result.stderr
    found = json.loads(result.stdout)
    assert found["format"] == 1
    assert found["name"] == name
    for position in found["positions"]:
        assert position["worst"] < 1e-9
        assert position["links"].keys() == position["analytic"]["links"].keys()
        assert position["points"].keys() == position["analytic"]["points"].keys()


def test_solve_several_goes_on():
    mechanism("x = 1", "bad.toml")
    result = run("solve", "--json", "ex3-1", "bad.toml", "no-such", "ex3-5")
    assert result.exit_code == 3
    lines = [json.loads(line) for line in result.stdout.splitlines()]
    assert [line["name"] for line in lines] == ["ex3-1", "bad", "no-such", "ex3-5"]
    assert ["error" in line for line in lines] == [False, True, True, False]


def test_solve_also():
    mechanism(FOUR_BAR.replace("angle = 60", "angle = 60\nalso = [120, 220]"))
    found = json.loads(run("solve", "--json", "mine.toml").stdout)
    assert len(found["positions"]) == 3
    assert all(position["worst"] < 1e-9 for position in found["positions"])


def test_solve_for_people():
    result = run("solve", "ex3-1", "ex3-5")
    assert result.exit_code == 0
    assert "ω3 = −3.91933 rad/s (clockwise)" in result.stdout


@pytest.mark.many(4)
@pytest.mark.parametrize("name", [name for k, name in enumerate(library.names()) if k % 3])
def test_explain(name: str):
    """In Chinese, where the kept words are not compared."""
    result = run("explain", name, "--lang", "zh")
    assert result.exit_code == 0, result.stderr
    assert "解" in result.stdout or "速度" in result.stdout


def test_check_statuses():
    run("draw", "ex3-1")
    text = Path("ex3-1.svg").read_text("utf-8")
    Path("bad.svg").write_text(text.replace('data-name="b3" ', 'data-name="b3" cx="1" ', 1) if False else text, "utf-8")
    first = text.index('class="point"')
    at = text.index('cx="', first) + 4
    end = text.index('"', at)
    Path("moved.svg").write_text(text[:at] + f"{float(text[at:end]) + 0.02:.4f}" + text[end:], "utf-8")
    Path("nothing.svg").write_text("nothing")
    assert run("check", "ex3-1.svg").exit_code == 0
    assert run("check", "moved.svg").exit_code == 1
    assert run("check", "moved.svg", "--tolerance", "0.1").exit_code == 0
    assert run("check", "ex3-1.svg", "moved.svg").exit_code == 1
    assert run("check", "nothing.svg", "ex3-1.svg").exit_code == 3
    assert run("check", "ex3-1.svg", "--tolerance", "-1").exit_code == 2


def test_list_and_show():
    result = run("list", "--lang", "zh")
    assert all(name in result.stdout for name in library.names())
    shown = run("show", "ex3-1")
    assert run("draw", "-", "-o", "-", text=shown.stdout).exit_code == 0
    unknown = run("show", "ex3-l")
    assert unknown.exit_code == 3
    assert "ex3-1" in unknown.stderr


def test_schema():
    assert json.loads(run("schema").stdout)["type"] == "object"


def test_usage():
    assert run("draw").exit_code == 2
    assert run("no-such").exit_code == 2
    for command in ("draw", "explain", "solve", "check", "list", "show", "schema"):
        assert "Example" in run(command, "--help").stdout


REFUSED = {
    "empty": "",
    "not utf-8": b"\xff\xfe\x00",
    "broken": "[frame",
    "too large": "#" * (1 << 20) + "\n",
    "too few drivers": FOUR_BAR[: FOUR_BAR.index("[[driver]]")] + "[sketch]\nC = [80, 60]\n",
    "two on one freedom": FOUR_BAR + '[[driver]]\nvector = "DC"\nangle = 90\n',
    "cannot be assembled": FOUR_BAR.replace("BC = 70", "BC = 5"),
    "between two assemblies": FOUR_BAR.replace("C = [80, 60]", "C = [47.5, 13]"),
    "dead point": FOUR_BAR.replace("angle = 60", "angle = 0").replace("BC = 70", "BC = 110"),
    "scale too fine": FOUR_BAR + "[scales]\nlength = 0.00001\n",
    "infinite": FOUR_BAR.replace("AB = 30", "AB = inf"),
    "mistyped key": FOUR_BAR.replace("omega", "omgea"),
    "mistyped point": FOUR_BAR.replace('vector = "AB"', 'vector = "AX"'),
}


@pytest.mark.parametrize("lang", ["en", "zh"])
@pytest.mark.parametrize("kind", REFUSED)
def test_bad_input(kind: str, lang: str):
    text = REFUSED[kind]
    Path("bad.toml").write_bytes(text if isinstance(text, bytes) else text.encode())
    for command in ("draw", "explain"):
        result = run(command, "bad.toml", "--lang", lang)
        assert result.exit_code == 3, (command, result.output)
        assert "bad.toml" in result.stderr
        assert "Traceback" not in result.stderr
        assert any("\u4e00" <= letter <= "\u9fff" for letter in result.stderr) == (lang == "zh")
    assert [path.name for path in Path().iterdir()] == ["bad.toml"]


def test_a_folder_and_no_file():
    Path("folder.toml").mkdir()
    for name in ("folder.toml", "nothing.toml", "sub/ex3-1"):
        result = run("draw", name)
        assert result.exit_code == 3, result.output
        assert result.stderr.strip()


def test_drivers_are_counted():
    two = FOUR_BAR + '[[driver]]\nvector = "DC"\nangle = 96.1\n'
    mechanism(two)
    assert "2 drivers" in run("draw", "mine.toml").stderr
    five = FOUR_BAR.replace("BC = 70", "BE = 40\n[links.4]\nEC = 50").replace("C = [80, 60]", "C = [80, 60]\nE = [40, 60]")
    mechanism(five)
    result = run("draw", "mine.toml")
    assert result.exit_code == 3
    assert "degrees of freedom) is 2, and drivers take 1" in result.stderr


# --- find, equations, centres -------------------------------------------------------------------


def test_find_draws_what_it_finds():
    done = run("find", "p3-4a", "a_k B3B2 = 0", "-o", "zeros.svg")
    assert done.exit_code == 0
    assert [line.split()[2] for line in done.stdout.splitlines()[1:]] == ["90°:", "202.024°:", "270°:", "337.976°:"]
    written = re.sub("<[^>]*>", "", Path("zeros.svg").read_text("utf-8"))
    assert all(f"({letter}) φAB = " in written for letter in "abcd")


@pytest.mark.parametrize("condition", ["nonsense", "v Q = 0", "max", "v C = 3 kg", "omega 3 = ", "slowest 9", ""])
def test_find_refuses_what_is_no_condition(condition: str):
    for lang in ("en", "zh"):
        done = run("find", "p3-13", condition, "--lang", lang)
        assert done.exit_code == 3, done.stdout
        assert len(done.stderr.strip().splitlines()) == 1


@pytest.mark.parametrize("form", [[], ["--json"]], ids=["table", "json"])
@pytest.mark.parametrize(("lengths", "status"), [("300:320:10", 3), ("30:320:140", 0)], ids=["none fits", "one fits"])
def test_a_variation_of_errors_alone_is_an_error(form: list[str], lengths: str, status: int):
    assert run("find", "ex3-5", "max omega 3", "--vary", f"AB={lengths}", *form).exit_code == status


def test_find_varies_a_dimension():
    rows = json.loads(run("find", "p3-21", "stroke s piston", "--vary", "DH=55:125:35", "--json").stdout)["rows"]
    assert run("find", "p3-21", "stroke s piston", "--vary", "DH=55:125:35", "--vary", "AB=9:10:1").exit_code == 2
    assert [round(row["value"] * 1000, 9) for row in rows] == [55, 90, 125]
    strokes = [row["found"]["range"] * 1000 for row in rows]
    assert strokes == pytest.approx([84.0883, 77.6603, 43.3246], abs=1e-4)


@pytest.mark.parametrize("kind", [".txt", ".html", ".tex"])
def test_equations_are_written(kind: str):
    for _ in range(2):
        assert run("equations", "ex3-5", "--method", "matrix", "-o", f"out{kind}").exit_code == 0
    assert run("equations", "ex3-5", "-o", "out.doc").exit_code == 2
    Path(f"mine{kind}").write_text("mine")
    assert run("equations", "ex3-5", "-o", f"mine{kind}").exit_code == 3
    assert Path(f"mine{kind}").read_text() == "mine"


def test_centres_as_json_lines():
    mechanism("[frame\n", "broken.toml")
    done = run("centres", "--json", "fig3-4", "broken.toml", "p3-11b")
    assert done.exit_code == 3
    first, second, third = (json.loads(line) for line in done.stdout.splitlines())
    assert first["centres"]["P13"]["at"] == pytest.approx([0.066404, 0.182442], abs=1e-6)
    assert first["centres"]["P13"]["by"] == [["P12", "P23"], ["P14", "P34"]]
    assert "broken.toml" in second["error"]
    assert third["centres"]["P14"]["by"] == "slide"
    assert "direction" in third["centres"]["P13"]


def test_centres_are_drawn_and_measured():
    assert run("centres", "fig3-4", "-o", "c.svg").exit_code == 0
    assert run("check", "c.svg").exit_code == 0
    Path("c.svg").write_text(Path("c.svg").read_text("utf-8").replace('data-name="P13" data-of="P13"', 'data-name="P24" data-of="P24"'))
    assert run("check", "c.svg").exit_code == 1
    assert run("centres", "ex3-7", "--steps", "steps").exit_code == 0
    assert len(list(Path("steps").glob("*.svg"))) == 15


@pytest.mark.parametrize(
    "words",
    [
        ["fig3-4", "--about", "3"], ["fig3-4", "--about", "3", "--bobillier", "E"], ["fig3-6", "--centrodes", "3,1"],
        ["fig3-6", "--centrodes", "3,1", "--animate"], ["fig3-10", "--path", "P13"], ["p3-11b", "--fit"],
    ],
)  # fmt: skip
def test_what_lies_around_a_centre_is_drawn_and_told(words: list[str]):
    for lang in ("en", "zh")[: 1 if "--animate" in words else 2]:
        done = run("centres", *words, "-o", "out.svg", "--force", "--lang", lang)
        assert done.exit_code == 0, done.stderr
        assert Path("out.svg").read_text("utf-8").startswith("<?xml")
        assert run("centres", *[word for word in words if word not in ("--animate", "--fit")], "--lang", lang).stdout


def test_a_pole_of_two_velocities():
    assert "(71.43, −142.9) mm" in run("centres", "--velocities", "A 0,0 1,0.5; B 100,0 1,-0.2").stdout
    assert "ω = 0" in run("centres", "--velocities", "A 0,0 1,0; B 0,100 1,0").stdout
    for wrong in ("A 0,0 1,0; B 100,0 2,0", "A 0,0 1,0", "A 0,0 1,0; B 0,0 1,0", "nonsense"):
        refused = run("centres", "--velocities", wrong)
        assert refused.exit_code == 3
        assert refused.stderr.startswith("--velocities")


@pytest.mark.parametrize(
    "words", [["--about", "9"], ["--about", "1"], ["--about", "3", "--bobillier", "Z"], ["--centrodes", "3,9"], ["--path", "P39"]]
)
def test_centres_that_are_not_there(words: list[str]):
    refused = run("centres", "fig3-4", *words)
    assert refused.exit_code == 3, refused.stdout
    assert len(refused.stderr.strip().splitlines()) == 1


# --- linkage, design ----------------------------------------------------------------------------


def degrees(value: float) -> float:
    return value * 180 / 3.141592653589793


def test_linkage_of_the_textbook():
    """Examples 2.2 and 2.4, by lengths and by the mechanism's file."""
    for words in (["--fourbar", "15", "48", "55", "45"], ["s2-2"]):
        found = json.loads(run("linkage", *words, "--json").stdout)
        assert (found["format"], found["kind"], found["grashof"], found["driver"]) == (1, "crank-rocker", True, "AB")
        assert degrees(found["swing"]) == pytest.approx(40.535, abs=5e-4)
        assert degrees(found["theta"]) == pytest.approx(29.859, abs=5e-4)
        assert found["K"] == pytest.approx(1.3978, abs=1e-4)
        assert degrees(found["gamma_min"]) == pytest.approx(32.984, abs=5e-4)
        assert sorted(round(degrees(end["gamma"]), 3) for end in found["critical"]) == [32.984, 70.885]
        assert found["dead_points"]["AB"] == []
        assert len(found["dead_points"]["CD"]) == 2
    for words in (["--slider", "20", "65", "15"], ["s2-4"]):
        found = json.loads(run("linkage", *words, "--json").stdout)
        assert found["kind"] == "slider-crank"
        assert found["stroke"] * 1000 == pytest.approx(41.240, abs=5e-4)
        assert degrees(found["theta"]) == pytest.approx(9.307, abs=5e-4)
        assert found["K"] == pytest.approx(1.109, abs=5e-4)
        assert degrees(found["alpha_max"]) == pytest.approx(32.579, abs=5e-4)


def test_linkage_is_drawn_and_told_in_both_languages():
    for lang, word in (("en", "crank-rocker"), ("zh", "曲柄摇杆机构")):
        done = run("linkage", "s2-2", "-o", "limits.svg", "--lang", lang)
        assert done.exit_code == 0
        assert word in done.stdout
    assert run("list", "--kinds", "-o", "kinds.svg").exit_code == 0


def test_linkage_with_another_link_as_frame():
    text = run("linkage", "ex3-5", "--fix", "2").stdout
    Path("held.toml").write_text(text, encoding="utf-8")
    assert run("draw", "held.toml").exit_code == 0
    assert run("check", "held.svg").exit_code == 0


@pytest.mark.parametrize(
    "words",
    [["--fourbar", "15", "48", "55", "450"], ["--fourbar", "1", "2", "x", "4"], ["--slider", "-1", "65", "15"], ["ex3-4", "--fix", "9"],
     ["--fourbar", "0", "0", "0", "0"], ["--fourbar", "nan", "1", "1", "1"], ["s4-ex4"]],
)  # fmt: skip
def test_linkages_that_are_none(words: list[str]):
    for lang in ("en", "zh"):
        refused = run("linkage", *words, "--lang", lang)
        assert refused.exit_code == 3, refused.stdout
        assert len(refused.stderr.strip().splitlines()) == 1
    assert run("linkage").exit_code == 2


def test_design_of_the_textbook():
    """Example 2.3, written as a mechanism that draws, and proved by its own report."""
    words = ["design", "rocker", "--length", "80", "--swing", "40", "--K", "1.3", "--frame", "71"]
    best = json.loads(run(*words, "--json").stdout)["solutions"][0]
    assert best["a"] * 1000 == pytest.approx(20.773, abs=5e-4)
    assert best["b"] * 1000 == pytest.approx(89.960, abs=5e-4)
    assert run(*words, "-o", "design.svg", "--steps", "steps", "--toml", "found.toml").exit_code == 0
    assert run("draw", "found.toml").exit_code == 0
    back = json.loads(run("linkage", "found.toml", "--json").stdout)
    assert degrees(back["swing"]) == pytest.approx(40, abs=1e-7)
    assert back["K"] == pytest.approx(1.3, abs=1e-9)


@pytest.mark.parametrize(
    "words",
    [
        ["slider", "--stroke", "40", "--K", "1.2", "--offset", "15"], ["guide-bar", "--K", "1.5", "--frame", "100"],
        ["rocker", "--length", "80", "--swing", "40", "--K", "1.3"],
        ["positions", "--at", "0,50 0", "--at", "25,60 -10", "--at", "50,55 -30", "--coupler", "60"],
        ["positions", "--at", "0,50 0", "--at", "25,60 -10", "--coupler", "60"],
        ["angles", "--pair", "0:0", "--pair", "40:30", "--pair", "90:70", "--frame", "100"],
    ],
)  # fmt: skip
def test_designs_are_drawn_and_told(words: list[str]):
    for lang in ("en", "zh"):
        done = run("design", *words, "-o", "design.svg", "--lang", lang)
        assert done.exit_code == 0, done.stderr
    assert json.loads(run("design", *words, "--json").stdout)["format"] == 1


@pytest.mark.parametrize(
    "words",
    [
        ["rocker", "--length", "80", "--swing", "40", "--K", "1.3", "--frame", "20"],
        ["rocker", "--length", "80", "--swing", "40", "--K", "0.9"], ["rocker", "--length", "-8", "--swing", "40", "--K", "1.3"],
        ["slider", "--stroke", "40", "--K", "nan"], ["slider", "--stroke", "4 kg", "--K", "1.2"],
        ["positions", "--at", "10,40 60,70"], ["positions", "--at", "nonsense", "--at", "1,2 3,4"],
        ["angles", "--pair", "3", "--frame", "100"], ["guide-bar", "--K", "1.5"],
    ],
)  # fmt: skip
def test_designs_that_cannot_be(words: list[str]):
    for lang in ("en", "zh"):
        refused = run("design", *words, "--lang", lang)
        assert refused.exit_code == 3, refused.stdout
        assert len(refused.stderr.strip().splitlines()) == 1


@pytest.mark.parametrize(("lang", "said"), [("en", "Aborted!"), ("zh", "已中断。")])
@pytest.mark.parametrize("first", [True, False])
def test_broken_off_is_said_in_the_reader_s_language(
    lang: str, said: str, first: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("graphkin.cli.drawing.explain.callback", interrupted)
    args = ["--lang", lang, "explain", "ex3-1"] if first else ["explain", "ex3-1", "--lang", lang]
    done = CliRunner().invoke(main, args)
    assert done.exit_code == 130
    assert done.stderr.strip() == said


@pytest.mark.parametrize(("words", "said"), [
    (("design", "slider", "--stroke", "40", "--K", "1"), "offset e = 0"),
    (("tolerance", "ex3-1", "--pencil", "0,0"), "is no pencil"),
])  # fmt: skip
def test_what_is_no_condition_or_no_pencil_is_refused_with_what_to_do(words: tuple[str, ...], said: str) -> None:
    result = run(*words)
    assert (result.exit_code, result.stdout) == (3, "")
    assert said in result.stderr


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("draw --bogus", "错误：没有选项 '--bogus'。"),
        ("draw", "缺少参数 'MECHANISM...'"),
        ("draw ex3-1 --arrow", "是否为 '--arrows'？"),
        ("draw ex3-1 --style red", "'--style' 的值有误：'red' 不在 'construction', 'result', 'given' 之中。"),
        ("draw ex3-1 --dpi 3", "'--dpi' 的值有误：3.0 不在范围 20<=x<=2400 之内。"),
        ("show ex3-1 ex3-2", "多余的参数（ex3-2）"),
        ("none", "没有命令 'none'。"),
        ("explain ex3-1 -o x.doc", "x.doc：要写的文件须以 .html, .tex, .md 结尾"),
        ("linkage ex3-5 --fix 2 --json", "--fix：请去掉 --json, -o"),
        ("draw ex3-1 --angle 120 --angle 7", "ex3-1 没有可用于 --angle 的原动件了"),
    ],
)
@pytest.mark.parametrize("where", ["before", "after", "environment"])
def test_wrong_usage_is_told_in_the_users_language(
    words: str, told: str, where: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if where == "environment":
        monkeypatch.setenv("GRAPHKIN_LANG", "zh")
    line = {"before": f"--lang zh {words}", "after": f"{words} --lang=zh", "environment": words}[where]
    done = run(*line.split())
    assert done.exit_code == 2
    assert told in done.output
    english = run(*words.split(), "--lang", "en")
    assert english.exit_code == 2
    assert not re.search("[\u4e00-\u9fff]", english.output)


def test_help_in_chinese():
    for line in ("--lang zh solve --help", "solve --lang zh -h", "help solve --lang zh"):
        told = run(*line.split()).output
        assert "用法:" in told
        assert "图解与解析并列" in told, "as the manual says it"
        assert "graphkin solve ex3-7 --angle 120" in told
    assert "[NAME" not in run("show", "-h", "--lang", "zh").output
    assert "Print all results" in run("solve", "--help").output
