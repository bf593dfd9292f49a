"""Whole classes: by workers and executors, broken off and gone on with, nothing marked twice."""

from __future__ import annotations

import json
import multiprocessing
import signal
import subprocess
import sys
import time
import warnings
import zipfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from itertools import islice
from pathlib import Path

import pytest
from broken_submissions import broken
from click.testing import CliRunner, Result

from graphkin.cli import main
from graphkin.homework.grading import Journal, batch, grade, judge_from, key_from, resumed, running
from graphkin.homework.grading.batch import StoredRecord
from graphkin.outputs import marks_json
from graphkin.outputs.key_json import key_text
from graphkin.outputs.marks_json import record

VALUES = ("-3.92,62,2.5", "-5.65,68.7,3.62", "-3.7 m/s,,2.6", "-3.75,60,what", ",,", "3.92,12.5,0")


pytestmark = pytest.mark.usefixtures("own_folder")


def run(*words: str) -> Result:
    return CliRunner().invoke(main, ["grade", *words])


def table(count: int, name: str = "class.csv", **changed: str) -> str:
    rows = (f"s{k},{changed.get(f's{k}', VALUES[k % len(VALUES)])}\n" for k in range(count))
    Path(name).write_text("student,omega 3,alpha 3,a_k B3B2\n" + "".join(rows), encoding="utf-8")
    return name


def marks(path: str = "r.json") -> list[dict]:
    return json.loads(Path(path).read_text("utf-8"))["results"]


def bad_files(count: int) -> list[str]:
    found = []
    for seed in range(count):
        name, content = broken(seed)
        path = Path(f"bad{seed}") / name
        path.parent.mkdir()
        path.write_bytes(content)
        found.append(str(path))
    return found


# --- workers and executors --------------------------------------------------------------------


def told(judge, paths: list[str], **how) -> list:
    return [(one.student, one.file, one.place, one.marked, one.prints, str(one.reason), [*map(str, one.notes)])
            for one in grade(judge, paths, **how)]  # fmt: skip


def test_workers_give_the_same_in_the_same_order():
    paths = [table(100), "missing.toml", *bad_files(25), table(10, "again.csv")]
    assert told(key_from("ex3-1"), paths, workers=2) == told(key_from("ex3-1"), paths)


def test_workers_of_a_clone():
    """They import the file that was started."""
    clone = Path(__file__).parents[2] / "cli.py"
    done = subprocess.run([sys.executable, str(clone), "grade", "ex3-1", table(3), "--json", "--jobs", "1"], capture_output=True, timeout=60)
    assert done.returncode == 0
    assert [json.loads(line)["status"] for line in done.stdout.splitlines()] == ["marked"] * 3


@pytest.mark.parametrize("processes", [False, True])
def test_any_executor_will_do(processes: bool):
    paths, judge = [table(150)], judge_from("ex3-1")
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, mp_context=spawn) if processes else ThreadPoolExecutor(2) as pool:
        assert told(judge, paths, executor=pool) == told(judge, paths)


def test_a_cluster_gives_the_same():
    distributed = pytest.importorskip("distributed", reason="needs graphkin[dask]")
    paths, judge = [table(150)], judge_from("ex3-1")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with distributed.Client(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None) as client:
            found = told(judge, paths, executor=client.get_executor())
    assert found == told(judge, paths)


def test_few_are_in_flight(monkeypatch: pytest.MonkeyPatch):
    read = 0

    def counted(*given):
        nonlocal read
        for item in items(*given):
            read += 1
            yield item

    items = running.items
    monkeypatch.setattr(running, "items", counted)
    most, found = running._BATCH * (running._AHEAD + 1), 0
    with ThreadPoolExecutor(2) as pool:
        for found, _ in enumerate(grade(key_from("ex3-1"), [table(3000)], executor=pool), 1):
            assert read - found <= most
            if found > 1500:
                break
    assert found > 1500


def test_a_set_of_keys_goes_to_workers():
    for name, mechanism in (("a", "ex3-1"), ("b", "ex3-7")):
        Path(f"{name}.key.json").write_text(key_text(key_from(mechanism)), encoding="utf-8")
    keys = {"kind": "graphkin keys", "format": 1, "students": {"s0": "a.key.json", "s1": "b.key.json", "s2": "a.key.json"}}
    Path("key.json").write_text(json.dumps(keys))
    paths, judge = [table(4)], judge_from("key.json")
    found = told(judge, paths, workers=1)
    assert found == told(judge, paths)
    assert [one[3] is not None for one in found] == [True, True, True, False]


# --- gone on with -----------------------------------------------------------------------------


@pytest.fixture
def marked() -> Iterator[list[str]]:
    """What was marked, as it is: nothing that the package does is changed."""
    seen: list[str] = []
    work = running.marked

    def watched(some, **how):
        seen.extend(one.owner.student if hasattr(one, "owner") else one.work.student for one in some if not isinstance(one, StoredRecord))
        return work(some, **how)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(running, "marked", watched)
        yield seen


def test_nothing_is_marked_twice(marked: list[str]):
    words = ("ex3-1", table(50), "-o", "r.json")
    assert run(*words).exit_code == 0
    assert len(marked) == 50
    first = Path("r.json").read_bytes()
    marked.clear()
    assert run(*words).exit_code == 0
    assert marked == []
    assert Path("r.json").read_bytes() == first
    assert [path.name for path in Path().iterdir() if "journal" in path.name or path.name.startswith(".")] == []


def test_what_is_changed_or_new_is_marked(marked: list[str]):
    run("ex3-1", table(50), "-o", "r.json")
    marked.clear()
    table(52, s7="-3.92,62.1,2.5")
    assert run("ex3-1", "class.csv", "-o", "r.json").exit_code == 0
    fresh = [one for one in marks() if one["student"] in marked]
    assert [one["student"] for one in fresh] == ["s7", "s50", "s51"]
    run("ex3-1", "class.csv", "-o", "whole.json")
    assert marks() == marks("whole.json")


@pytest.mark.parametrize("option", [["--relative", "0.001"], ["--sigmas", "2"], ["--pencil", "0.5,0.5"]])
def test_another_tolerance_marks_the_stored_numbers(option: list[str], monkeypatch: pytest.MonkeyPatch):
    words = ("ex3-1", table(20), "-o", "r.json")
    run(*words)
    unmarked = {one["student"] for one in marks() if one["status"] != "marked"}
    read, read_one = set(), batch.read_one
    monkeypatch.setattr(batch, "read_one", lambda one, *given: read.add(one.owner.student) or read_one(one, *given))
    assert run(*words, *option).exit_code == 0
    assert read == unmarked != set()
    run(*words[:-1], "whole.json", *option)
    assert marks() == marks("whole.json")


@pytest.mark.parametrize("option", [["--lang", "zh"], ["--turned"], ["--letters", "p,b2"]])
def test_another_way_of_reading_reads_anew(option: list[str], marked: list[str]):
    words = ("ex3-1", table(20), "-o", "r.json")
    run(*words)
    marked.clear()
    assert run(*words, *option).exit_code == 0
    assert len(marked) == 20


def broken_off(path: Path, paths: list[str], after: int) -> None:
    """As `grade` does it, interrupted after so many."""
    with Journal(path) as journal:
        records = resumed(judge_from("ex3-1"), paths, journal, running.MarkingOptions(words="en"), record)

        def interrupted():
            yield from islice(records, after)
            raise KeyboardInterrupt

        marks_json.write(path, interrupted())


def test_a_broken_off_marking_goes_on(marked: list[str]):
    path, paths = Path("r.json"), [table(240)]
    with pytest.raises(KeyboardInterrupt):
        broken_off(path, paths, 120)
    assert not path.exists()
    left = Path("r.json.journal")
    assert all(json.loads(line) for line in left.read_text("utf-8").splitlines())
    for cut in ('{"format": 1, "student": "s6', '{"format": 1, "fingerprints": 3}', "学".encode()[:2]):
        with left.open("ab") as file:  # as a loss of power leaves it, or a hand
            file.write(cut if isinstance(cut, bytes) else cut.encode())
        with pytest.raises(KeyboardInterrupt):
            broken_off(path, paths, 120)
    marked.clear()
    done = run("ex3-1", *paths, "-o", "r.json")
    assert done.exit_code == 0
    assert len(marked) == 240 - 120
    assert [one["student"] for one in marks()] == [f"s{k}" for k in range(240)]
    assert not left.exists()
    run("ex3-1", *paths, "-o", "whole.json")
    assert marks() == marks("whole.json")


@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
@pytest.mark.parametrize("jobs", ["0", "1"])
def test_an_interruption_leaves_whole_files(jobs: str):
    """Ctrl-C in the middle of it, as a process."""
    graphkin = str(Path(sys.executable).with_name("graphkin"))
    command = [graphkin, "grade", "ex3-1", table(4000), "-o", "out", "--format", "csv", "--jobs", jobs]
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # where the tests run in the background, too
    process = subprocess.Popen(command, stderr=subprocess.PIPE, start_new_session=True, preexec_fn=heard)
    journal = Path("out/marks.json.journal")
    for _ in range(600):
        if journal.is_file() and journal.stat().st_size > 100_000:
            break
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    stderr = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 130
    assert "Traceback" not in stderr
    assert "goes on from there" in stderr
    assert [path.name for path in Path("out").iterdir()] == ["marks.json.journal"]
    assert all(json.loads(line) for line in journal.read_text("utf-8").splitlines())


def test_a_foreign_file_is_no_journal():
    Path("r.json.journal").write_text("mine\n")
    done = run("ex3-1", table(3), "-o", "r.json")
    assert done.exit_code == 3
    assert Path("r.json.journal").read_text() == "mine\n"
    assert not Path("r.json").exists()


# --- twice, missing, turned -------------------------------------------------------------------


def test_a_second_submission_of_a_student_says_why_it_is_not_marked():
    Path("a.toml").write_text('student = "s1"\n[answers]\n"omega 3" = -3.92\n')
    Path("b.toml").write_text('student = "s1"\n[answers]\n"omega 3" = -5.65\n')
    found = run("ex3-1", "a.toml", "b.toml", "a.toml", table(3), "gone.toml", "--json")
    assert found.exit_code == 0
    rows = [json.loads(line) for line in found.stdout.splitlines()]
    assert [one["status"] == "marked" for one in rows] == [True, False, False, True, False, True, False]
    assert all("'s1' handed in a.toml before, which is marked" in rows[k]["reason"] for k in (1, 2, 4))
    assert "class.csv:3" in rows[4]["reason"]
    assert "gone.toml" in rows[6]["reason"]


def test_who_left_the_first_is_marked_by_the_second(marked: list[str]):
    Path("a.toml").write_text('student = "s1"\n[answers]\n"omega 3" = -3.92\n')
    Path("b.toml").write_text('student = "s1"\n[answers]\n"omega 3" = -5.65\n')
    run("ex3-1", "a.toml", "b.toml", "-o", "r.json")
    run("ex3-1", "b.toml", "-o", "r.json")
    assert [one["status"] for one in marks()] == ["marked"]


# --- tables that are handed in with others ----------------------------------------------------


def test_a_class_table_alone_in_a_folder_or_an_archive_is_the_class():
    Path("class").mkdir()
    table(3, "class/all.csv")
    with zipfile.ZipFile("class.zip", "w") as archive:
        archive.write("class/all.csv", "homework 3/all.csv")
    for given, file in (("class", "class/all.csv"), ("class.zip", "class.zip!homework 3/all.csv")):
        lines = [json.loads(line) for line in run("ex3-1", given, "--json").output.splitlines()]
        assert [(line["student"], line["file"]) for line in lines] == [(f"s{k}", file) for k in range(3)]


def test_a_class_table_among_others_is_not_taken_for_one_student_s():
    """Nor are its rows anybody's: the table may be one student's, with the ids of others."""
    Path("class").mkdir()
    table(3, "class/s7.csv")
    table(1, "class/s8.csv")
    lines = [json.loads(line) for line in run("ex3-1", "class", "--json").output.splitlines()]
    assert [(line["student"], line["status"]) for line in lines] == [("s7", "not marked"), ("s0", "marked")]
    assert "rows of 's0' and of 's1'" in lines[0]["reason"]


def test_a_folder_with_nothing_in_it_says_so():
    Path("nobody").mkdir()
    result = run("ex3-1", "nobody", "--json")
    assert json.loads(result.stdout)["reason"].startswith("nobody: no answer is found here")


def test_a_row_without_an_id_is_nobody_s():
    Path("class.csv").write_text("student,omega 3\ns1,-3.92\n,-3.92\ns2,-3.92\n", encoding="utf-8")
    lines = [json.loads(line) for line in run("ex3-1", "class.csv", "--json").output.splitlines()]
    assert [line["status"] for line in lines] == ["marked", "not marked", "marked"]
    assert lines[1]["reason"] == "class.csv:3: this row names no student. Write the id in its column."
