"""What the commands share: several mechanisms, `--watch`, names that a shell completes, lists of some mechanisms."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.shell_completion import ShellComplete
from click.testing import CliRunner, Result
from si_values import si

from graphkin import api
from graphkin.cli import main, watching
from graphkin.files import library
from graphkin.proof.readings import mechanism_at

FILE = library.text("ex3-5")


pytestmark = pytest.mark.usefixtures("own_folder")


def run(*words: str, text: str | bytes | None = None) -> Result:
    return CliRunner().invoke(main, list(words), input=text)


# --- several mechanisms, other positions -------------------------------------------------------


@pytest.mark.parametrize("command", ["explain", "solve", "structure", "equations", "linkage"])
def test_several_mechanisms(command: str) -> None:
    """As one after the other; one that is refused stops none."""
    alone = [run(command, name).stdout for name in ("ex3-1", "fig3-1")]
    result = run(command, "ex3-1", "no-such", "fig3-1")
    assert result.exit_code == 3
    assert "no-such" in result.stderr
    assert all(text.strip() in result.stdout for text in alone)


def test_several_drawings() -> None:
    assert run("draw", "ex3-1", "fig3-1").exit_code == 0
    assert Path("ex3-1.svg").exists()
    assert Path("fig3-1.svg").exists()
    assert run("draw", "ex3-1", "fig3-1", "-o", "one.svg").exit_code == 2
    assert run("equations", "ex3-1", "fig3-1", "-o", "one.txt").exit_code == 2


def test_several_drawings_into_a_folder() -> None:
    """One that is refused stops none."""
    result = run("draw", "ex3-1", "no-such", "fig3-1", "--only", "position", "-o", "sheets/new")
    assert (result.exit_code, sorted(path.name for path in Path("sheets/new").iterdir())) == (3, ["ex3-1.svg", "fig3-1.svg"])


@pytest.mark.parametrize("words", [("draw",), ("draw", "-o", "sheets"), ("handout", "-o", "sheets")])
def test_two_files_of_one_name_are_not_written_into_one(words: tuple[str, ...]) -> None:
    for folder, name in (("a", "ex3-1"), ("b", "fig3-1")):
        Path(folder).mkdir()
        Path(folder, "x.toml").write_text(run("show", name).stdout, encoding="utf-8")
    result = run(*words, "a/x.toml", "b/x.toml")
    assert (result.exit_code, "written into x." in result.stderr) == (2, True)
    assert sorted(path.name for path in Path().iterdir()) == ["a", "b"]


@pytest.mark.parametrize("command", ["solve", "structure"])
def test_what_is_printed_is_written(command: str) -> None:
    """Again, too; but not over a file of another's, and nothing where nothing could be told."""
    for _ in range(2):
        assert run(command, "ex3-1", "no-such", "fig3-1", "-o", "told.jsonl").exit_code == 3
        assert run(command, "ex3-1", "fig3-1", "-o", "told.txt").exit_code == 0
    assert Path("told.jsonl").read_text("utf-8") == run(command, "ex3-1", "no-such", "fig3-1", "--json").stdout
    assert Path("told.txt").read_text("utf-8").startswith(run(command, "ex3-1", "fig3-1").stdout)
    Path("own.txt").write_text("mine", encoding="utf-8")
    assert run(command, "ex3-1", "-o", "own.txt").exit_code == 3
    assert Path("own.txt").read_text("utf-8") == "mine"
    assert run(command, "ex3-1", "fig3-1", "-o", "told.json").exit_code == 2
    assert run(command, "no-such", "-o", "none.txt").exit_code == 3
    assert not Path("none.txt").exists()


def test_solve_at_another_angle() -> None:
    (position,) = json.loads(run("solve", "ex3-5", "--angle", "100", "--json").stdout)["positions"]
    Path("mine.toml").write_text(FILE, encoding="utf-8")
    rows = run("sweep", "ex3-5", "--driver", "100:110:10", "--of", "omega 3", "-o", "-").stdout.splitlines()
    assert position["links"]["3"]["omega"] == pytest.approx(float(rows[1].split(",")[1]), rel=1e-9)
    assert run("solve", "ex3-5", "--angle", "100", "--angle", "20").exit_code == 2


def test_another_angle_is_another_drawn_position() -> None:
    """As a file that is drawn there: on the branch on which the drawn one stands, past where a sketch would mislead."""
    method = api.plan(library.load("ex3-5"))
    there = mechanism_at(method, [math.radians(250)])
    Path("there.toml").write_text(there.text, encoding="utf-8")
    for command in ("equations", "structure", "linkage"):
        turned, told = run(command, "ex3-5", "--angle", "250"), run(command, "there.toml")
        assert (turned.exit_code, turned.stderr) == (0, ""), command
        assert turned.stdout == told.stdout, command
    assert "250°" in run("equations", "-", "--angle", "250", text=FILE).stdout
    assert run("structure", "ex3-5", "--angle", "100", "--angle", "20").exit_code == 2
    assert run("linkage", "--fourbar", "15", "48", "55", "45", "--angle", "20").exit_code == 2


ELSEWHERE = [("ex3-3", 0.5), ("p3-17", 0.05), ("p3-22", 0.03), ("s4-ex6", -0.7), ("p3-19", 0.3)]


@pytest.mark.parametrize(("name", "aside"), ELSEWHERE)
def test_a_mechanism_stands_elsewhere(name: str, aside: float) -> None:
    """Poses, displacements, several drivers: its file has them of there, and moves on as it did."""
    method = api.plan(library.load(name))
    values = [float(value) + aside for value in method.facts(None).values]
    there = mechanism_at(method, values)
    drawn, again = api.replay(method, si(method, values)), api.replay(api.plan(there))
    for link in there.moving:
        assert again.omega[link] == pytest.approx(drawn.omega[link], rel=1e-7, abs=1e-9)
        assert again.alpha[link] == pytest.approx(drawn.alpha[link], rel=1e-6, abs=1e-7)
    assert all(abs(again["path " + p].si - drawn["path " + p].si) < 1e-9 * method.size for p in there.points)


def test_a_drawing_changed_by_hand_is_kept() -> None:
    draw = ("draw", "ex3-1", "--only", "velocity", "--tight")
    assert run(*draw).exit_code == 0
    fresh = Path("ex3-1.svg").read_text(encoding="utf-8")
    assert run(*draw, "--lang", "zh").exit_code == 0, "as it was drawn it is drawn anew"
    moved = re.sub(r'(class="vector"[^>]*x1=")(\d+)', lambda found: found[1] + str(int(found[2]) + 1), fresh, count=1)
    added = fresh.replace("</svg>", '<text x="20" y="20" font-size="4">mine</text></svg>')
    for text in (moved, added):
        assert text != fresh
        Path("ex3-1.svg").write_text(text, encoding="utf-8")
        result = run(*draw)
        assert (result.exit_code, "changed by hand" in result.stderr) == (3, True)
        assert Path("ex3-1.svg").read_text(encoding="utf-8") == text
    assert run(*draw, "--force").exit_code == 0
    assert Path("ex3-1.svg").read_text(encoding="utf-8") == fresh


def test_check_as_data() -> None:
    drawing = run("draw", "fig3-1", "-o", "-").stdout
    good = json.loads(run("check", "-", "--json", text=drawing).stdout)
    assert (good["passed"], good["faults"]) == (True, [])
    assert max(entry["off"] for entry in good["measured"]) < 0.01
    result = run("check", "-", "--json", text="no drawing")
    assert (result.exit_code, "error" in json.loads(result.stdout)) == (3, True)


def test_solve_has_the_signs_of_tables() -> None:
    asked = json.loads(run("solve", "fig3-1", "--json").stdout)["positions"][0]["ask"]["a C"]
    ((_, swept),) = swept_rows("fig3-1", "a C")
    assert asked["value"] == pytest.approx(swept)
    assert asked["value"] == -asked["size"] < 0
    printed = run("solve", "fig3-1").stdout
    assert len(re.findall(r"(?m)^a_C +0\.863225 ", printed)) == printed.count("a_C = 0.863225 m/s² (horizontally to the left)") == 1


def swept_rows(name: str, of: str) -> list[list[float]]:
    _, rows = swept(name, "--driver", "60:61:2", "--of", of)
    return [row[:2] for row in rows]


# --- watch -------------------------------------------------------------------------------------


def saving(monkeypatch: pytest.MonkeyPatch, texts: list[str]) -> None:
    """The file is saved with one text after the other, then Ctrl-C is pressed."""
    left: Iterator[str] = iter(texts)

    def saved() -> None:
        text = next(left, None)
        if text is None:
            raise KeyboardInterrupt
        Path("new").write_text(text, encoding="utf-8")
        Path("new").replace("mine.toml")

    monkeypatch.setattr(watching, "wait", saved)


def test_watch_goes_on_through_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    Path("mine.toml").write_text(FILE, encoding="utf-8")
    saving(monkeypatch, [FILE.replace("[links.1]", "[links.1"), FILE + "\n# the same\n"])
    result = run("draw", "mine.toml", "--watch")
    assert result.exit_code == 0
    assert result.stdout.splitlines() == ["mine.svg", "mine.svg"]
    assert "mine.toml:" in result.stderr


def test_watch_explains_what_is_new(monkeypatch: pytest.MonkeyPatch) -> None:
    Path("mine.toml").write_text(FILE, encoding="utf-8")
    other = library.text("ex3-1")
    saving(monkeypatch, [other])
    result = run("explain", "mine.toml", "--watch")
    assert run("explain", "ex3-5").stdout in result.stdout
    assert result.stdout.endswith(run("explain", "ex3-1").stdout)


def test_watch_looks_at_files() -> None:
    assert run("draw", "ex3-1", "--watch").exit_code == 2
    assert run("explain", "-", "--watch", text=FILE).exit_code == 2


def test_a_file_that_is_away_for_a_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    file, acted = Path("mine.toml"), []
    file.write_text("1")
    steps = iter([file.unlink, lambda: file.write_text("22"), lambda: None])

    def wait() -> None:
        step = next(steps, None)
        if step is None:
            raise KeyboardInterrupt
        step()

    monkeypatch.setattr(watching, "wait", wait)
    watching.watch(["mine.toml"], lambda name: acted.append(file.read_text()))
    assert acted == ["1", "22"]


# --- names ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("command", ["draw", "explain", "solve", "sweep", "find", "centres", "linkage", "structure",
                                     "equations", "tolerance", "show"])  # fmt: skip
def test_a_shell_completes_names(command: str) -> None:
    offered = ShellComplete(main, {}, "graphkin", "_GRAPHKIN_COMPLETE").get_completions([command], "ex3-")
    assert [item.value for item in offered] == [name for name in library.names() if name.startswith("ex3-")]
    files = ShellComplete(main, {}, "graphkin", "_GRAPHKIN_COMPLETE").get_completions([command], "mine")
    assert command == "show" or [item.type for item in files] == ["file"]


def test_list_some() -> None:
    everything = run("list").stdout.splitlines()
    gears = run("list", "--kind", "gear").stdout.splitlines()
    assert set(gears) < set(everything)
    assert {line.split()[0] for line in gears} == {n for n in library.names() if "[[gear]]" in library.text(n)}
    groups = [run("list", "--group", group).stdout.splitlines() for group in library.groups()]
    assert sorted(line for lines in groups for line in lines) == sorted(everything)
    assert run("list", "--source", "no such book").stdout == ""
    hinges = run("list", "--kind", "hinge", "--source", "3-").stdout.split()
    assert all(not library.load(line).pairs for line in hinges if library.has(line))


# --- one value under one heading -----------------------------------------------------------------


def swept(*words: str) -> tuple[list[str], list[list[float]]]:
    head, *rows = run("sweep", *words, "-o", "-").stdout.splitlines()
    return head.split(","), [[float(cell) for cell in row.split(",")] for row in rows]


def test_one_heading_has_one_value_in_every_format() -> None:
    """A point led by the frame's guide goes forth and back: signed in the terminal, in CSV and in JSON."""
    words = ("fig3-1", "--driver", "0:360:30", "--of", "v C, v B")
    head, rows = swept(*words)
    assert head[1:6] == ["v C [m/s]", "v C size [m/s]", "v C x [m/s]", "v C y [m/s]", "v B [m/s]"]
    assert min(row[1] for row in rows) < 0 < max(row[1] for row in rows)
    assert all(abs(row[1]) == pytest.approx(row[2], abs=1e-12) for row in rows)
    printed = [line.split() for line in run("sweep", *words).stdout.splitlines()[2 : 2 + len(rows)]]
    assert all(float(line[1].replace("−", "-")) == pytest.approx(row[1], rel=1e-5, abs=1e-12) for line, row in zip(printed, rows))
    run("sweep", *words, "-o", "table.json")
    found = json.loads(Path("table.json").read_text("utf-8"))["quantities"]
    assert found["v C"]["values"] == pytest.approx([row[1] for row in rows], abs=1e-11)
    assert found["v C"]["sizes"] == pytest.approx([row[2] for row in rows], abs=1e-11)
    assert "sizes" not in found["v B"]


def test_a_second_driver_has_a_column() -> None:
    head, rows = swept("p3-22", "--of", "theta 5")
    drivers = library.load("p3-22").drivers
    assert [name.split(" ")[0] for name in head[:2]] == [driver.name for driver in drivers]
    assert len({round(row[1] - row[0] * (rows[1][1] - rows[0][1]) / (rows[1][0] - rows[0][0]), 6) for row in rows}) == 1


def test_check_through_a_pipe() -> None:
    drawing = run("draw", "ex3-1", "-o", "-").stdout
    good = run("check", "-", text=drawing)
    assert (good.exit_code, "good" in good.stdout) == (0, True)
    bad = run("check", "-", text="no drawing")
    assert bad.exit_code == 3
    assert "<stdin>" in bad.stderr


def test_a_constant_has_no_greatest_value() -> None:
    said = run("sweep", "s4-ex4", "--driver", "0:80:20", "--of", "omega 2").stdout
    assert "ω2 = " in said
    assert "throughout" in said
    assert "greatest" not in said


def test_rows_of_an_accelerated_driver_are_said_to_be_no_moments_of_one_motion() -> None:
    said = "not moments of one motion"
    assert said not in run("sweep", "ex3-1", "--driver", "0:80:20").stdout
    Path("fast.toml").write_text(library.text("ex3-1").replace("omega = 10", "omega = 10\nalpha = 5"), encoding="utf-8")
    assert said in run("sweep", "fast.toml", "--driver", "0:80:20").stdout


def test_a_mechanism_without_a_title_is_named_once() -> None:
    Path("e.toml").write_text(re.sub("(?m)^title.*\n", "", FILE), encoding="utf-8")
    assert run("solve", "e.toml").stdout.splitlines()[0] == "e"


def test_curves_are_told_in_short() -> None:
    assert len(run("centres", "fig3-4", "--path", "P13").stdout) < 2000
    assert json.loads(run("centres", "fig3-4", "--path", "P13", "--json").stdout)


def test_structure_as_data() -> None:
    lines = run("structure", "--json", "ex3-1", "no-such", "ex3-2").stdout.splitlines()
    first, wrong, second = map(json.loads, lines)
    assert (first["freedoms"], first["formula"], first["class"], second["class"]) == (1, 1, 2, 3)
    assert [link for group in second["groups"] for link in group["links"]]
    assert "error" in wrong


def test_a_slide_may_be_driven_by_the_name_it_is_printed_with() -> None:
    text = library.text("ex3-1")
    begin, end = text.index("[[driver]]"), text.index("[sketch]")
    driven = text[:begin] + '[[driver]]\nslide = "s0"\nat = 58.867\nvelocity = 0.1\n\n' + text[end:]
    lines = run("solve", "-", text=driven).stdout.splitlines()
    assert "position: s0 = 58.867 mm" in lines
    assert any(re.match(r"θ1 +60\.0", line) for line in lines)
    assert "no sliding pair" in run("solve", "-", text=driven.replace('"s0"', '"s1"')).stderr


def test_values_for_each_driver() -> None:
    machine = library.load("ex3-1")
    for act in (lambda: api.motion(machine, [1, 2]), lambda: api.Drawing.of(machine, [1, 2])):
        with pytest.raises(ValueError, match=r"1 drivers, 2 values. Give one value, or one array of many, for each of AB"):
            act()


def test_handout_at_another_angle() -> None:
    assert run("handout", "ex3-1", "--stage", "problem", "--angle", "100", "-o", "at.html").exit_code == 0
    assert "100°" in Path("at.html").read_text("utf-8")


def test_tolerance_at_another_angle() -> None:
    found = json.loads(run("tolerance", "ex3-1", "--angle", "100", "--json").stdout)
    there = api.motion(library.load("ex3-1"), [100]).omega["3"].si
    assert found["quantities"]["omega 3"]["right"] == pytest.approx(there, rel=1e-9)


def test_a_measure_far_from_the_sketch_is_asked_for() -> None:
    """Where it leaves a gap; one that agrees is not doubted."""
    long = run("solve", "-", text=FILE.replace("DC = 60", "DC = 200")).stderr
    assert "stays open" in long
    assert "Is DC right? The sketch has 60 mm, the link 200 mm." in long
    apart = run("solve", "-", text=FILE.replace("D = [80, 0]", "D = [210, 0]").replace("[80, 60]", "[150, 5]")).stderr
    assert "stays open" in apart
    assert "right?" not in apart


def test_a_trains_ratios_are_no_trial() -> None:
    assert "fitted by trial" not in run("draw", "ex3-3", "--only", "position", "-o", "-").stdout
    assert "fitted by trial" in run("draw", "ex3-2", "--only", "position", "-o", "-").stdout
