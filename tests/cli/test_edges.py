"""Where graphkin meets the world: streams in every encoding, closed or full; files in the way; what is absurd."""

from __future__ import annotations

import json
import os
import re
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import replace
from functools import partial
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner, Result

from graphkin import Drawing
from graphkin.cli import main, streams
from graphkin.cli.shared import json_line
from graphkin.errors import AlongOwnAxis, JoinedToNothing
from graphkin.files import library, loads
from graphkin.model.mechanism import FRAME
from graphkin.proof.roads import wrong_drivers

COLLAR = """
[frame]
O1 = [0, 0]
O2 = [250, 0]
[links.1]
O1A = 100
[links.2]
AB = 250
[links.3]
O2B = 100
[[driver]]
vector = "O1A"
angle = 60
omega = 2
[sketch]
A = [50, 87]
B = [300, 87]
"""


pytestmark = pytest.mark.usefixtures("own_folder")


def run(*words: str) -> Result:
    return CliRunner().invoke(main, list(words))


def process(line: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    """A command line of a shell, in which `graphkin` is the program."""
    start = f'graphkin() {{ "{sys.executable}" -c "from graphkin.cli import main; main(prog_name=\'graphkin\')" "$@"; }}; '
    return subprocess.run(["bash", "-c", start + line], capture_output=True, env={**os.environ, **environment})


# --- streams ----------------------------------------------------------------------------------


@pytest.mark.skipif(os.name != "posix", reason="needs a shell")
@pytest.mark.parametrize("encoding", ["gbk", "cp1252", "ascii"])
def test_a_file_gets_utf_8(encoding: str) -> None:
    done = process("graphkin solve ex3-1 --lang zh; graphkin draw no.toml --lang zh", PYTHONIOENCODING=encoding)
    assert done.returncode == 3
    assert "含移动副的四杆机构" in done.stdout.decode("utf-8")
    assert "没有这个文件" in done.stderr.decode("utf-8")


@pytest.mark.skipif(os.name != "posix", reason="needs a shell")
@pytest.mark.parametrize(
    ("line", "status", "said"),
    [
        ("graphkin sweep ex3-1 --driver 0:360:0.01 | head -1; exit ${PIPESTATUS[0]}", 0, ""),
        ("graphkin solve ex3-1 >&-", 0, ""),
        ("graphkin solve ex3-1 --json >/dev/full", 3, "<stdout>: cannot be written"),
        ("graphkin schema >/dev/full", 3, "<stdout>: cannot be written"),
        ("graphkin draw - <&-", 3, "<stdin>: the file is empty"),
        ("graphkin draw ex3-1 -o a.svg >&- 2>&- && graphkin check a.svg", 0, ""),
    ],
)
def test_streams_closed_or_full(line: str, status: int, said: str) -> None:
    done = process(line)
    assert (done.returncode, b"Traceback" in done.stderr) == (status, False)
    assert said in done.stderr.decode()
    assert bool(said) == bool(done.stderr)


@pytest.mark.parametrize(
    ("said", "threads"),
    [({}, "1"), ({"OPENBLAS_NUM_THREADS": "2"}, "2"), ({"OMP_NUM_THREADS": "2"}, "")],
    ids=["nothing", "threads", "threads of all"],
)
def test_a_command_computes_with_one_thread(said: dict[str, str], threads: str) -> None:
    """Where its user says nothing else; it is known before NumPy is loaded."""
    code = (
        "import os, sys; from graphkin.cli import main\n"
        "assert 'numpy' not in sys.modules\n"
        "end = os._exit\n"
        'os._exit = lambda status: (os.write(2, os.environ.get("OPENBLAS_NUM_THREADS", "").encode()), end(status))\n'
        "main(['solve', 'ex3-1'], prog_name='graphkin')"
    )
    own = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={**own, **said})
    assert (found.returncode, found.stderr) == (0, threads)


def test_one_line_is_one_line() -> None:
    odd = "a\u2028b\u2029c\x85d\x7f"
    assert json.loads(json_line({"x": odd})) == {"x": odd}
    assert len(json_line({"x": odd}).splitlines()) == 1


# --- texts ------------------------------------------------------------------------------------


@pytest.mark.parametrize("title", [" ", "\u3000\\t", "\\u200b", "² &lt;<b> \\\\write18 x\\ny"])
def test_any_title_is_drawn(title: str) -> None:
    """Those of nothing to be seen, and one of all that a drawing, a browser or TeX may take for something else."""
    Path("mine.toml").write_text(f'title = "{title}"\n{COLLAR}', encoding="utf-8")
    for words in (("draw", "mine.toml", "--only", "position", "--paper", "A3"), ("sweep", "mine.toml", "-o", "sweep.svg")):
        assert run(*words).exit_code == 0
    for path in Path().glob("*.svg"):
        ElementTree.parse(path)


def test_names_of_files_steer_nothing() -> None:
    Path("a\x1b[31m\nb.toml").write_text(library.text("ex3-1"), encoding="utf-8")
    assert run("draw", "a\x1b[31m\nb.toml").exit_code == 0
    assert Path("a_[31m_b.svg").exists()
    missing = run("draw", "c\x1b[31m\nd.toml")
    assert missing.exit_code == 3
    assert "\x1b" not in missing.stderr
    assert missing.stderr.startswith("c\\x1b[31m\\nd.toml: there is no such file")


def test_links_named_by_odd_digits() -> None:
    Path("mine.toml").write_text(COLLAR.replace("[links.2]", '[links."²"]').replace("[links.3]", '[links."٣"]'), encoding="utf-8")
    assert run("centres", "mine.toml").exit_code == 0


# --- files ------------------------------------------------------------------------------------


def test_what_ends_a_command_from_outside_is_no_file_that_cannot_be_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """A time limit set by whoever runs it, or Ctrl-C."""
    for ending in (TimeoutError("that is enough"), KeyboardInterrupt()):

        def end(*_: object, ending: BaseException = ending) -> None:
            raise ending

        monkeypatch.setattr("graphkin.outputs.tables.shown_parts", end)
        for output in ("a.csv", "-"):
            found = run("sweep", "ex3-1", "-o", output)
            assert "cannot be written" not in found.output
            assert found.exception is ending if isinstance(ending, TimeoutError) else found.exit_code == 130


def test_a_link_to_a_file_stays_one() -> None:
    Path("real.svg").touch()
    Path("link.svg").symlink_to("real.svg")
    assert run("draw", "ex3-1", "-o", "link.svg").exit_code == 0
    assert Path("link.svg").is_symlink()
    assert run("check", "real.svg").exit_code == 0


@pytest.mark.parametrize("name", ["a.svg", "other.html", "marks.json"])
def test_drafts_of_the_dead_are_cleared_away(name: str) -> None:
    """Of whatever file in the folder; also of one that nobody waits for, and no file that is not a draft."""
    ended, unwaited = (subprocess.Popen([sys.executable, "-c", ""]) for _ in range(2))
    ended.wait()
    os.waitid(os.P_PID, unwaited.pid, os.WEXITED | os.WNOWAIT)
    left = [Path(f".{name}.{process.pid}.draft") for process in (ended, unwaited)]
    stay = [Path(f".{name}.{os.getppid()}.draft"), Path(f".{name}.{ended.pid}"), Path(".my.draft")]
    for path in (*left, *stay):
        path.touch()
    assert run("draw", "ex3-1", "-o", "a.svg").exit_code == 0
    assert [path.exists() for path in (*left, *stay)] == [False, False, True, True, True]
    unwaited.wait()


# --- what is absurd ---------------------------------------------------------------------------

REFUSED = [
    (("draw", ""), 2, "MECHANISM is empty"),
    (("draw", "ex3-1", "--angle", "1e8"), 3, "is followed"),
    (("draw", "ex3-1", "--angle", "1e300"), 3, "is followed"),
    (("draw", "s4-ex2", "--at", "1e9"), 3, "is followed"),
    (("find", "ex3-1", "v B = 0", "-o", "x.png"), 2, "must end in .svg"),
    (("sweep", "ex3-1", "--driver", "0:360:0.001"), 3, "360001 rows"),
    (("sweep", "ex3-1", "--driver", "0:360:0.0001", "-o", "a.json"), 3, "rows"),
    (("sweep", "ex3-1", "--driver", "0:360:1e-9"), 3, "is no range"),
    (("sweep", "ex3-1", "--driver", "0:90:10", "--driver", "AB=0:20:1"), 3, "AB is given twice"),
    (("find", "ex3-1", "slowest DC", "--driver", "AB=30", "--driver", "AB=40"), 3, "AB is given twice"),
    (("sweep", "ex3-1", "-o", "a.csv", "--limit", "v B 3 kg"), 3, "kg is not a unit"),
    (("sweep", "ex3-1", "-o", "a.csv", "--limit", "v X 3"), 3, "no point X"),
    (("find", "ex3-1", "a_k B = 0"), 3, "Write `a_k B2B3`"),
    (("find", "ex3-1", "a_n B = 0"), 3, "Write `a_n BA`"),
    (("linkage", "ex3-5", "--fix", "2", "--json"), 2, "leave out --json"),
    (("draw", "ex3-1", "-o", "/dev/full"), 3, "/dev/full: cannot be written (not a folder)"),
    (("handout", "ex3-1", "-o", "/dev/full"), 3, "/dev/full: cannot be written (not a folder)"),
    (("linkage", "--guide", "1e-12", "1e9", "0"), 3, "--guide: 1e-12"),
]


RAM = """frame = { A = [0, 0] }
links = { 1.AB = 30, 2.BC = 80, 3.points = ["C"] }
slide = [{ name = "ram", block = "3", point = "C", guide = "frame", through = "A" }]
driver = [{ slide = "ram", at = 110, velocity = 0.1 }]
"""


@pytest.mark.parametrize("at", ["110", "50", "-110"])
def test_a_slide_driven_at_a_dead_centre_is_told_so(at: str) -> None:
    """There the two assemblies are one, but for rounding, and no sketch can tell them apart; a little off it must."""
    Path("mine.toml").write_text(RAM.replace("110", at), encoding="utf-8")
    result = run("solve", "mine.toml", "--lang", "en")
    assert (result.exit_code, "dead point: the lines for links 1 and 2 meet under 0.000 deg" in result.stderr) == (3, True)
    Path("mine.toml").write_text(RAM.replace("110", "109.99"), encoding="utf-8")
    assert "the sketch fits two assemblies equally well" in run("solve", "mine.toml", "--lang", "en").stderr


FACE = """frame = { A = [0, 0], D = [110, 30] }
links = { 2.AB = 22, 3 = { points = ["D"] } }
cam = [{ links = ["2", "3"], profiles = [{ centre = "B", radius = 45 }, { through = "D", side = "left" }] }]
driver = [{ vector = "AB", angle = 50, omega = 10 }]
"""
"""A face that touches a circle from either side of its pivot, without a point that tells which."""


def test_a_link_that_may_stand_in_two_directions_is_named() -> None:
    Path("mine.toml").write_text(FACE, encoding="utf-8")
    result = run("solve", "mine.toml", "--lang", "en")
    assert (result.exit_code, result.stderr[:44]) == (3, "mine.toml:2, links.3: two assemblies are pos")
    assert "link 3 stands in one of two directions" in result.stderr
    with_point = FACE.replace('3 = { points = ["D"] }', "3.DE = 80").replace('side = "left"', 'toward = "E"')
    Path("mine.toml").write_text(with_point + "sketch = { E = [50, 80] }\n", encoding="utf-8")
    assert run("solve", "mine.toml").exit_code == 0


@pytest.mark.parametrize(("text", "line"), [(RAM.replace("110", "100"), 2), (library.text("ex3-1"), 13)])
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_a_length_beside_which_others_have_no_digits_is_named(text: str, line: int, lang: str) -> None:
    Path("mine.toml").write_text(re.sub(r"AB = \d+", "AB = 1e9", text, count=1) + '\n[sketch]\nB = [25, 15]\n' * (line == 2), encoding="utf-8")
    result = run("solve", "mine.toml", "--lang", lang)
    assert result.exit_code == 3
    assert f"mine.toml:{line}, links.1" in result.stderr
    assert "1e+09 mm" in result.stderr


@pytest.mark.parametrize("name", ["graphkin.cli", "click", "graphkin.errors"])
def test_breaking_off_while_it_is_loaded_is_quiet(name: str) -> None:
    """As if Ctrl-C were pressed while a module is imported, by either way to start."""
    finder = f"""import sys
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r}:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Finder())
sys.argv = ["graphkin", "list"]
import runpy
runpy."""
    root = Path(__file__).parents[2]
    for start in ("run_module('graphkin', run_name='__main__')", f"run_path({str(root / 'cli.py')!r}, run_name='__main__')"):
        done = subprocess.run([sys.executable, "-c", finder + start], capture_output=True, env={**os.environ, "PYTHONPATH": str(root)})
        assert (done.returncode, done.stdout, done.stderr) == (130, b"", b"")


@pytest.mark.parametrize(("words", "status", "said"), REFUSED, ids=[" ".join(words) for words, _, _ in REFUSED])
def test_refused_before_any_work(words: tuple[str, ...], status: int, said: str) -> None:
    result = run(*words)
    assert (result.exit_code, result.stdout) == (status, "")
    assert said in result.stderr
    assert not list(Path().iterdir())


def test_a_direction_of_a_million_turns_is_none() -> None:
    Path("mine.toml").write_text(COLLAR.replace("angle = 60", "angle = 1e8"), encoding="utf-8")
    result = run("solve", "mine.toml")
    assert result.exit_code == 3
    assert "is not a finite number of reasonable size" in result.stderr


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [("O2 = [250, 0]", "O2 = [250, 1e15]", "frame.O2"), ("O2B = 100", "O2B = 1e14", "links.3")],
)
def test_lengths_that_leave_each_other_no_digit(old: str, new: str, key: str) -> None:
    Path("mine.toml").write_text(COLLAR.replace(old, new), encoding="utf-8")
    result = run("solve", "mine.toml")
    assert result.exit_code == 3
    assert f", {key}: " in result.stderr


# --- questions --------------------------------------------------------------------------------


def test_nothing_is_searched_in_what_is_level() -> None:
    Path("mine.toml").write_text(COLLAR, encoding="utf-8")
    result = run("find", "mine.toml", "v A = 0", "--by", "analysis")
    assert "not met in this range; it comes nearest at φ_O1A = 0°: v_A = 0.2 m/s" in result.stdout


@pytest.mark.parametrize("question", ["omega 2 = 0", "max omega 2", "range alpha 2", "theta 2 = 0", "a_n AO1 = a_n AO1"])
def test_zero_throughout(question: str) -> None:
    Path("mine.toml").write_text(COLLAR, encoding="utf-8")
    lines = run("find", "mine.toml", question).stdout.splitlines()
    assert [line.strip() for line in lines[1:]] == ["met at every position" if "a_n" in question else "zero throughout"]


def test_one_set_of_quantities() -> None:
    """What can be asked can be swept and found, and the other way round."""
    names = ("x C", "y C", "v_x C", "v_y C", "a_x C", "a_y C", "v_x C/v_y C")
    Path("mine.toml").write_text(f"ask = {list(names)}\n" + COLLAR.replace("O1A", "O1C").replace("AB", "CB")
                                 .replace("\nA =", "\nC ="), encoding="utf-8")  # fmt: skip
    answers = json.loads(run("solve", "--json", "mine.toml").stdout)["positions"][0]["ask"]
    swept = run("sweep", "mine.toml", "--driver", "60:70:20", "--of", ", ".join(names), "-o", "-").stdout.splitlines()
    for name, cell in zip(names, swept[1].split(",")[1:], strict=True):
        factor = 1000.0 if name[0] in "xy" else 1.0
        assert answers[name]["value"] * factor == pytest.approx(float(cell), rel=1e-9)
        assert run("find", "mine.toml", f"max {name}").exit_code == 0
    assert run("sweep", "mine.toml", "--of", ", ".join(names), "-o", "a.svg").exit_code == 0
    assert run("draw", "mine.toml", "--paper", "A3").exit_code == 0


@pytest.mark.parametrize(
    ("text", "meant"), [("omega2", "`omega 2`"), ("v_A", "`v A`"), ("how fast", "`omega 3`"), ("max v A", "`v C`")]
)
def test_what_asks_nothing_is_refused(text: str, meant: str) -> None:
    Path("mine.toml").write_text(f'ask = ["v A", "{text}"]\n' + COLLAR, encoding="utf-8")
    result = run("solve", "mine.toml")
    assert (result.exit_code, result.stdout) == (3, "")
    assert result.stderr.startswith("mine.toml:1, ask.1: ")
    assert meant in result.stderr


def test_a_question_in_words_is_shown() -> None:
    Path("mine.toml").write_text('ask = ["v A / omega 2", "how fast?", "多快？"]\n' + COLLAR, encoding="utf-8")
    result = run("solve", "mine.toml")
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.count("not answered") == 3


def test_a_driver_without_a_rate_is_remarked_on() -> None:
    Path("mine.toml").write_text(re.sub("(?m)^omega.*\n", "", COLLAR), encoding="utf-8")
    result = run("solve", "mine.toml")
    assert result.exit_code == 0
    assert "note: driver O1A has no omega" in result.stderr


@pytest.mark.parametrize(("place", "said"), [("[8, 60]", False), ("[60, 8]", True), ("[60, 55]", False)])
def test_a_link_that_the_sketch_shows_the_other_way_round_is_remarked_on(place: str, said: bool) -> None:
    """The sketch only picks the assembly: a wrong ccw draws the link mirrored. Near the line AB it shows neither."""
    own = """
    frame = { A = [0, 0] }
    [links]
    1 = { AB = 85, AE = 60, BE = 50, ccw = ["A", "B", "E"] }
    [[driver]]
    vector = "AB"
    angle = 45
    omega = 1
    """
    Path("mine.toml").write_text(f"{own}\n[sketch]\nB = [60, 60]\nE = {place}\n", encoding="utf-8")
    assert ("the sketch shows A, B, E the other way round than link 1 has them" in run("solve", "mine.toml").stderr) is said


def test_a_unit_in_place_of_its_key() -> None:
    Path("mine.toml").write_text(re.sub("(?m)^omega.*", "rpm = 95", COLLAR), encoding="utf-8")
    result = run("solve", "mine.toml")
    assert result.exit_code == 3
    assert 'rpm is a unit, not a key. Write omega = "95 rpm".' in result.stderr


ACROSS = """
[frame]
A = [0, 0]
[links.1]
AB = 50
[links.2]
points = ["C"]
{pair}
[[slide]]
block = "2"
point = "C"
guide = "frame"
through = [0, 0]
angle = 90
[[driver]]
vector = "AB"
angle = 30
omega = 10
[sketch]
C = [0, 90]
"""


@pytest.mark.parametrize(
    "pair",
    ['[[slide]]\npin = "B"\nguide = "2"',
     '[links.3]\npoints = ["B"]\n[[slide]]\nblock = "3"\npoint = "B"\nguide = "2"',
     '[[cam]]\nlinks = ["1", "2"]\nprofiles = [{ centre = "B", radius = 60 }, { through = "C" }]'],
)  # fmt: skip
def test_a_line_meant_to_lie_across_its_links_way(pair: str) -> None:
    """A link of one point is its own axis: what to write for a slot or a face across its guide."""
    with pytest.raises(AlongOwnAxis) as refused:
        Drawing.of(loads(ACROSS.format(pair=pair)))
    assert refused.value.link == "2"
    right = pair.replace('{ through = "C" }', '{ through = "C", angle = 0 }') if "cam" in pair else pair + "\nangle = 0"
    mended = ACROSS.format(pair=right)
    assert Drawing.of(loads(mended)).plot.omega["2"] == pytest.approx(0)


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_a_pivot_that_no_link_has_is_named(name: str) -> None:
    """A hinge of the frame gets another letter in the frame alone: that letter is joined to nothing."""
    mechanism = library.load(name)
    used = {point for pair in mechanism.pairs for _, point, _ in pair.circles}
    used |= {point for driver in mechanism.drivers for point in driver.from_vector or ()}
    used |= {p for pair in mechanism.pairs for line in pair.lines for p in (line.origin, *(line.base or ()))}
    for hinge in mechanism.hinges:
        if FRAME in hinge.links and hinge.point not in used:
            points = {"Z9" if p == hinge.point else p: place for p, place in mechanism.links[FRAME].points.items()}
            links = {**mechanism.links, FRAME: replace(mechanism.links[FRAME], points=points)}
            error = wrong_drivers(replace(mechanism, links=links))
            assert isinstance(error, JoinedToNothing)
            assert "Z9" in error.points
            assert all("Z9" in error.message(lang) for lang in ("en", "zh"))


def test_a_link_that_hangs_on_one_joint_is_named() -> None:
    error = wrong_drivers(loads(COLLAR.replace("O2B = 100", "O2C = 100").replace("B = [300", "C = [300")))
    assert isinstance(error, JoinedToNothing)
    assert error.points == ("B", "C")


@pytest.mark.skipif(sys.platform == "win32", reason="no such terminal")
def test_a_bar_where_one_waits(monkeypatch: pytest.MonkeyPatch):
    """At a terminal, and not before a while; with the time, and gone on when it is done."""
    import pty

    main_end, terminal = pty.openpty()
    with os.fdopen(terminal, "w") as stderr:
        monkeypatch.setattr(sys, "stderr", stderr)
        with streams.waiting():
            pass
        stderr.write("nothing yet\n")
        monkeypatch.setattr(streams, "_PATIENCE", 0.0)
        monkeypatch.setattr(streams, "_TICK", 0.01)
        with streams.waiting():
            time.sleep(0.1)
        stderr.write("done")
        stderr.flush()
        shown = b""
        while not shown.endswith(b"done"):
            shown += os.read(main_end, 4096)
        before, _, after = shown.decode().partition("nothing yet")
        assert not before
        assert "0 s" in after
        assert after.endswith("\ndone")
    os.close(main_end)


@pytest.mark.skipif(sys.platform == "win32", reason="no such terminal")
@pytest.mark.parametrize("words", ["draw ex3-1 --animate -o a.svg", "draw ex3-1 --steps st", "explain ex3-1", "sweep ex3-1",
                                   "sweep ex3-1 -o a.svg", "find ex3-1 'max v C'", "handout s2-2 --stage problem -o a.html",
                                   "page s2-1a -o a.html", "solve ex3-1", "tolerance ex3-1", "centres fig3-4"])  # fmt: skip
def test_whatever_takes_long_has_a_bar(words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Each of them, as if it took long."""
    import pty

    main_end, terminal = pty.openpty()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(streams, "_PATIENCE", 0.0)
    monkeypatch.setattr("graphkin.page.player._TOLD", 12)
    with os.fdopen(terminal, "w") as stderr, os.fdopen(main_end, "rb", 0) as shown:
        monkeypatch.setattr(sys, "stderr", stderr)
        main.main(shlex.split(words), standalone_mode=False)
        stderr.write("done")
        stderr.flush()
        assert re.search(rb"\[-+\] +\d+ s", shown.read(65536))


@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
def test_an_interruption_while_workers_start(tmp_path: Path):
    """Ctrl-C goes to all processes of a terminal, those, too, that load Python just then."""
    (tmp_path / "a.csv").write_text("student,omega 3\n" + "".join(f"s{k},-3.9\n" for k in range(5000)))
    command = [str(Path(sys.executable).with_name("graphkin")), "grade", "ex3-1", "a.csv", "-o", "a.json", "--jobs", "2"]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
    process = subprocess.Popen(
        command, cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True, preexec_fn=heard
    )
    while not (tmp_path / "a.json.journal").exists() and process.poll() is None:
        time.sleep(0.01)
    time.sleep(0.1)
    os.killpg(process.pid, signal.SIGINT)
    said = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 130
    assert len(said.split("\n")) == 3, said
    assert "goes on from there" in said
    assert not (tmp_path / "a.json").exists()
