"""Sweeps: both roads over whole turns and reachable ranges, through change points, into tables."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from random_mechanisms import DYADS, chain, circular_slot, coupler_angle, cylinder, dyad, triad
from redriving import redriven

import graphkin
from graphkin.cli import main
from graphkin.errors import BadRange, GraphkinError, NoPosition, NoSuchDriver
from graphkin.files import library, loads
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.proof.roads import apart
from graphkin.running import singularities
from graphkin.studies.sweeps import course, quantities_at, sweep
from graphkin.studies.sweeps.roads import moving

LIMITED = ("fig3-6", "fig3-10", "p3-22", "s4-ex3", "ex3-2", "s4-ex8")


def run(*words: str) -> Result:
    return CliRunner().invoke(main, list(words))


def both(mechanism: Mechanism, count: int = 181, margin: float = 0.02) -> float:
    """How far the two roads are apart over everything that is reached, but for the neighbourhood of dead points."""
    drive = course(plan(mechanism))
    low, high = drive.path.first, drive.path.last
    trim = margin * (high - low)
    t = np.linspace(low + trim * (low != drive.path.low), high - trim * (high != drive.path.high), count)
    roads = [moving(drive.method, drive.path, t, by) for by in ("construction", "analysis")]
    assert all(np.isfinite(value).all() for value in roads[1].alpha.values()), mechanism.name
    return apart(mechanism, *roads)


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_both_roads_sweep_alike(name: str):
    assert both(library.load(name)) < 1e-9


@pytest.mark.many
@pytest.mark.parametrize("kind", [*DYADS, "cylinder", "coupler", "chain", "triad", "circular"])
def test_both_roads_sweep_random_mechanisms_alike(kind: str):
    make = {"cylinder": cylinder, "coupler": coupler_angle, "chain": chain, "triad": triad,
            "circular": circular_slot}.get(kind)
    tried = 0
    for seed in range(2 if kind == "triad" else 4):
        mechanism = make(seed) if make else dyad(kind, seed)
        try:
            plan(mechanism)
        except GraphkinError:
            continue
        tried += 1
        assert both(mechanism) < 1e-9, (kind, seed)
    assert tried


# --- the textbook's table -----------------------------------------------------------------------

TABLE_3_1 = """
0   65.55610 168.93822 0.10107 0.17123 0.28879 -0.10184 0.24770 0.29266  -0.13872
10  67.46688 172.02730 0.08138 0.20927 0.32391 -0.12272 0.19076 0.11719  -0.10264
20  69.71252 175.32660 0.05854 0.23859 0.33202 -0.13834 0.14715 -0.01853 -0.07795
360 65.55610 168.93822 0.10107 0.17123 0.28879 -0.10184 0.24770 0.29267  -0.13872
"""
"""As printed, but for theta4 of 0 and 360 degrees and the column of a_E, which are wrong in the book."""


def rows(text: str) -> list[list[float]]:
    return [[float(word.replace("−", "-")) for word in line.split()] for line in text.splitlines() if line[:1].isdigit()]


def test_table_3_1():
    printed, book = rows(run("sweep", "ex3-7", "--table").stdout), rows(TABLE_3_1)
    assert len(printed) == 37
    for right in book:
        found = next(row for row in printed if row[0] == right[0])
        assert np.allclose(found[1:3], right[1:3], rtol=0, atol=1.1e-4)
        assert np.allclose(found[3:], right[3:], rtol=0, atol=1.1e-5)


# --- change points and stops --------------------------------------------------------------------

CRANKS = """
[frame]
A = [0, 0]
D = [{d}, 0]
[links.1]
AB = {a}
[links.2]
BC = {b}
[links.3]
DC = {c}
[[driver]]
vector = "AB"
angle = 60
omega = 10
alpha = 3
[sketch]
C = {C}
"""


def four_bar(a: float, b: float, c: float, d: float, C: list[float]) -> Mechanism:  # noqa: N803
    return loads(CRANKS.format(a=a, b=b, c=c, d=d, C=C), name="bar", file="bar.toml")


def test_a_parallelogram_stays_one():
    """All links pass through one line twice a turn; the coupler never turns."""
    found = sweep(plan(four_bar(30, 80, 30, 80, [95, 26])), ["0:720:5"], ["theta 2", "omega 2", "omega 3", "alpha 3", "v C"])
    assert np.allclose(np.sin(found["theta 2"].values), 0, atol=1e-9)
    assert np.allclose(found["omega 2"].values, 0, atol=1e-9)
    assert np.allclose(found["omega 3"].values, 10, rtol=1e-9)
    assert np.allclose(found["alpha 3"].values, 3, rtol=0, atol=2e-7)
    assert np.allclose(found["v C"].values, 0.3, rtol=1e-9)


@pytest.mark.parametrize("by", ["construction", "analysis"])
@pytest.mark.parametrize(
    ("lengths", "sketch", "changes"),
    [((30, 80, 30, 80), [95, 26], 4), ((30, 80, 30, 80), [75, -28], 4), ((30, 30, 80, 80), [40, 60], 4), ((20, 60, 50, 30), [60, 45], 2)],
)
def test_change_points_are_gone_through_smoothly(lengths: tuple[float, ...], sketch: list[float], changes: int, by: str):
    """Speeds are the slopes of angles everywhere, also at the change point itself."""
    drive = course(plan(four_bar(*lengths, sketch)), ["0:360:1"])
    assert len(drive.path.changes) == changes  # a turn to either side
    step = 1e-3
    t = np.concatenate([[drive.at(v) + k * step for k in (-2, -1, 0, 1, 2)] for v in np.radians([0.0, 90, 180, 180.3, 270])])
    found = quantities_at(drive, ["theta 2", "theta 3", "omega 2", "omega 3"], t, by)
    for link in "23":
        angles = found[f"theta {link}"].values.reshape(-1, 5)
        slope = angles @ np.array([1, -8, 0, 8, -1]) / (12 * step)
        assert np.allclose(slope * 10, found[f"omega {link}"].values.reshape(-1, 5)[:, 2], rtol=1e-6, atol=1e-6)


def test_a_guide_through_its_own_pivot():
    """Crank and frame equally long: the block passes the pivot, and the bar turns at half the crank's speed."""
    text = """
[frame]
A = [0, 0]
C = [-50, 0]
[links.1]
AB = 50
[links.2]
points = ["B"]
[links.3]
CE = 120
[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
toward = "E"
[[driver]]
vector = "AB"
angle = 30
omega = 5
[sketch]
E = [60, 40]
"""
    found = sweep(plan(loads(text, name="g", file="g.toml")), ["0:720:4"], ["omega 3", "theta 3"])
    assert np.allclose(found["omega 3"].values, 2.5, rtol=1e-9)
    assert found["theta 3"].values[-1] - found["theta 3"].values[0] == pytest.approx(2 * math.pi)


@pytest.mark.parametrize("name", LIMITED)
def test_the_way_ends_where_the_analysis_ends(name: str):
    """Just before a stop both roads have a position, just beyond it neither has."""
    drive = course(plan(library.load(name)))
    assert drive.stops
    for stop in drive.stops:
        out = math.copysign(1e-4 * (drive.path.last - drive.path.first), stop.at)
        before, beyond = moving(drive.method, drive.path, np.array([stop.at - out, stop.at + out]), "analysis").theta.values(), None
        for angles in before:
            angles = np.broadcast_to(angles, 2)
            beyond = bool(np.isnan(angles[1])) if beyond is None else beyond or bool(np.isnan(angles[1]))
            assert np.isfinite(angles[0])
        assert beyond


def test_angles_go_on_beyond_a_turn_and_never_jump():
    found = sweep(plan(library.load("p3-23a")), ["0:1080:90"], ["theta 1", "theta 2"])
    assert np.allclose(np.degrees(found["theta 1"].values), np.arange(0, 1081, 90))
    assert np.ptp(found["theta 2"].values) < 1


def test_positions_whole_turns_away_are_the_same():
    first = sweep(plan(library.load("fig3-10")), ["-40:200:20"], ["v O'"])
    later = sweep(plan(library.load("fig3-10")), ["320:560:20"], ["v O'"])
    assert np.allclose(first["v O'"].values, later["v O'"].values, rtol=1e-9)
    assert np.allclose(later.driven, np.radians(np.arange(320, 561, 20)))


# --- several drivers ----------------------------------------------------------------------------


def test_drivers_keep_pace():
    """Scissors: both slides move on together, so that F moves three times as fast along the whole way."""
    found = sweep(plan(library.load("p3-14")), of=["v F", "v A", "v B"])
    assert np.allclose(found["v A"].values, 0.002)
    assert np.allclose(found["v B"].values, 0.002)
    assert len(found.driven) > 10


@pytest.mark.parametrize("kind", ["RPP", "PPR", "RPR"])
def test_an_angle_that_keeps_its_size_is_not_looked_at_closely(kind: str, monkeypatch: pytest.MonkeyPatch):
    """Two drivers, one of them fifty times as fast: of thousands of lows of rounding none is looked at."""
    looked: list[float] = []
    closer = singularities._closer
    monkeypatch.setattr(singularities, "_closer", lambda *given: looked.append(given[-1]) or closer(*given))
    swept = 0
    for seed in range(8):
        if (found := redriven(kind, "posed by a slide", seed)) is not None and len(found[0].drivers) == 2:
            slow, fast = (replace(driver, acceleration=0.0) for driver in found[0].drivers)
            course(plan(replace(found[0], drivers=(replace(slow, rate=1.0), replace(fast, rate=50.0)))))
            swept += 1
    assert swept
    assert len(looked) < 8 * swept


def test_a_driver_can_be_held_elsewhere():
    free = sweep(plan(library.load("p3-21")), ["0:360:30"], ["s piston"])
    held = sweep(plan(library.load("p3-21")), ["0:360:30", "DH=70"], ["s piston"])
    assert np.ptp(held["s piston"].values) > np.ptp(free["s piston"].values)


def test_drivers_can_go_together():
    found = sweep(plan(library.load("p3-22")), ["lift=350:400:10", "tilt=260:290:6"], ["s lift", "s tilt"])
    assert np.allclose(found["s lift"].values, np.linspace(0.35, 0.40, 6))
    assert np.allclose(found["s tilt"].values, np.linspace(0.26, 0.29, 6))


# --- what is wrong ------------------------------------------------------------------------------


@pytest.mark.parametrize("span", ["0:0:1", "0:10:-1", "1:2:3:4", "nonsense", "0:1e9:1", "0:360:1e-9", "nan:1:1", "5 kg:9 kg:1", ""])
def test_ranges_that_are_none(span: str):
    refused = run("sweep", "ex3-1", "--driver", span)
    assert refused.exit_code == 3
    assert refused.stderr.startswith("--driver")
    assert "Traceback" not in refused.stderr


def test_a_range_beyond_reach_says_how_far_it_goes():
    with pytest.raises(NoPosition, match=r"-59\.07"):
        course(plan(library.load("fig3-10")), ["230:290:10"])


def test_a_driver_that_is_not_there():
    with pytest.raises(NoSuchDriver, match="AB"):
        course(plan(library.load("ex3-1")), ["XY=0:10:1"])
    with pytest.raises(BadRange):
        course(plan(library.load("p3-22")), ["lift=350:400:10", "tilt=260:290:10"])


@pytest.mark.parametrize("of", ["omega 9", "v Q", "s nothing", "speed of C", "omega 1 / v C"])
def test_quantities_that_are_none(of: str):
    refused = run("sweep", "ex3-1", "--of", of)
    assert refused.exit_code == 3
    assert refused.stderr.startswith("--of")


# --- tables -------------------------------------------------------------------------------------


def test_tables_hold_the_same(tmp_path: Path):
    """CSV, JSON and Parquet of one sweep; CSV read back by the standard reader."""
    parquet = pytest.importorskip("pyarrow.parquet", reason="needs graphkin[parquet]")
    names = ["theta 3", "omega 3", "v E", "a_k B3B2", "s ram", "P13"]
    found = sweep(plan(library.load("ex3-7")), ["0:360:15"], names)
    for suffix in (".csv", ".json", ".jsonl", ".parquet"):
        done = run("sweep", "ex3-7", "--driver", "0:360:15", "--of", ", ".join(names), "-o", str(tmp_path / f"t{suffix}"))
        assert done.exit_code == 0, done.stderr
    text = (tmp_path / "t.csv").read_text("utf-8")
    head, *lines = csv.reader(io.StringIO(text))
    table = dict(zip(head, np.array(lines, dtype=float).T, strict=True))
    assert head[:2] == ["AB [deg]", "theta 3 [deg]"]
    assert np.allclose(table["AB [deg]"], np.arange(0, 361, 15))
    assert np.allclose(table["theta 3 [deg]"], np.degrees(found["theta 3"].values))
    assert np.allclose(table["s ram [mm]"], found["s ram"].values * 1000)
    assert np.allclose(table["v E x [m/s]"] + 1j * table["v E y [m/s]"], found["v E"].vectors)
    assert np.allclose(table["P13 x [mm]"], found["P13"].vectors.real * 1000)
    columns = parquet.read_table(tmp_path / "t.parquet").to_pydict()
    assert list(columns) == head
    assert all(np.allclose(columns[name], table[name]) for name in head)
    data = json.loads((tmp_path / "t.json").read_text("utf-8"))
    assert data["range"]["full_turn"]
    assert data["quantities"]["omega 3"]["unit"] == "rad/s"
    assert np.allclose(data["quantities"]["omega 3"]["values"], found["omega 3"].values)
    assert np.allclose(data["driver"]["values"], found.driven)
    lines = [json.loads(line) for line in (tmp_path / "t.jsonl").read_text("utf-8").splitlines()]
    assert [name.split(" [")[0] for name in lines[0]] == [name.split(" [")[0] for name in head]
    assert [line["theta 3 [rad]"] for line in lines] == list(found["theta 3"].values)
    assert [line["s ram [m]"] for line in lines] == list(found["s ram"].values)
    assert [complex(line["v E x [m/s]"], line["v E y [m/s]"]) for line in lines] == list(found["v E"].vectors)


def test_json_lines_hold_no_nan(tmp_path: Path):
    """A quotient by 0 is null; and an own file is written over."""
    for _ in range(2):
        path, of = str(tmp_path / "t.jsonl"), "omega 1/omega 4, omega 4"
        done = run("sweep", "ex3-7", "--driver", "0:360:90", "--of", of, "-o", path)
        assert done.exit_code == 0, done.stderr
    text = (tmp_path / "t.jsonl").read_text("utf-8")
    lines = [json.loads(line, parse_constant=pytest.fail) for line in text.splitlines()]
    assert [line["omega 1/omega 4 [1]"] is None for line in lines] == [False, True, False, True, False]
    assert all(isinstance(line["omega 4 [rad/s]"], float) for line in lines)


def test_csv_on_stdout_and_over_an_own_file(tmp_path: Path):
    out = run("sweep", "ex3-1", "--driver", "0:90:30", "--of", "omega 3", "-o", "-")
    assert out.stdout.splitlines()[0].startswith("AB [deg],omega 3 [rad/s]")
    mine = tmp_path / "mine.csv"
    mine.write_text("my own numbers\n")
    assert run("sweep", "ex3-1", "-o", str(mine)).exit_code == 3
    assert mine.read_text() == "my own numbers\n"
    assert run("sweep", "ex3-1", "-o", str(mine), "--force").exit_code == 0
    assert run("sweep", "ex3-1", "-o", str(mine)).exit_code == 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes that are files")
def test_a_device_is_not_replaced_by_a_file(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "t.csv").symlink_to(tmp_path / "pipe")
    done = run("sweep", "ex3-1", "-o", str(tmp_path / "t.csv"), "--force")
    assert (done.exit_code, "t.csv" in done.stderr) == (3, True)
    assert (tmp_path / "pipe").is_fifo()


def test_a_limited_sweep_says_where_and_why():
    told = run("sweep", "fig3-10", "--lang", "en").stdout
    assert "AB moves from −59.0717° to 215.294°" in told
    assert "links 3 and 4 lie in line" in told
    assert "构件 3、4 共线" in run("sweep", "fig3-10", "--lang", "zh").stdout


def test_by_analysis_prints_the_same():
    first, second = (run("sweep", "ex3-7", "--table", "--by", by).stdout for by in ("construction", "analysis"))
    assert first == second


FOUR_BAR = """
frame = { A = [0, 0], D = [80, 0] }
links.1 = { AB = %g }
links.2 = { BC = 70 }
links.3 = { DC = 60 }
driver = [{ vector = "AB", angle = 60, omega = 10 }]
sketch = { C = [80, 60] }
"""


def test_a_position_that_is_a_dead_point_has_no_speeds():
    """At 120 degrees links 2 and 3 lie in line, to the last digit of the angle: only rounding would tell how fast."""
    method = graphkin.plan(graphkin.loads(FOUR_BAR % 70))
    for by in ("construction", "analysis"):
        found = sweep(method, "60:300:60", ["omega 3"], by)
        assert np.degrees(found.driven) == pytest.approx([60, 300])
        assert found.series[0].signed == pytest.approx([11.204573771702743] * 2)
    several = graphkin.replay(method, [[60, 119.999, 120, 240]]).omega["3"].si
    assert several[1] == pytest.approx(983.9, abs=0.1)
    assert np.isnan(several[2:]).all()


def test_the_analysis_goes_the_other_way_round_too():
    """An angle and one a turn from it are the same position, and only one way leads there."""
    mechanism = graphkin.loads(FOUR_BAR % 65)
    assert graphkin.motion(mechanism, [280]).omega["3"].si == pytest.approx(graphkin.replay(mechanism, [280]).omega["3"].si)
    several = graphkin.motion(mechanism, [[180, 280, 360]]).omega["3"].si
    assert several == pytest.approx([np.nan, -3.2332677, -43.3333333], nan_ok=True, rel=1e-6)
