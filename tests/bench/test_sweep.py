"""How fast a sweep is: positions, velocities and accelerations of all links, beside the programs that do it too.

One run, one core, CPU time of the thread, the best of several rounds taken in turns, so that what else the machine does
hits all alike. The ratios are printed; asked for is only what no busy machine can take away. Before a clock is started,
every peer's numbers are compared with graphkin's: the comparison is of the same work. What is timed is read: places, velocities and accelerations of all points, theta, omega and alpha of all
links, as arrays. `positions a second` counts crank positions, each with all of that.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from functools import cache, partial
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

import graphkin
from graphkin.construction import Plot
from graphkin.model.readout import State
from graphkin.planning import Method
from graphkin.running import replay_all
from graphkin.running.other_positions import program_of

MECHANISMS = {"ex3-5": "four-bar", "p3-23a": "offset slider-crank", "ex3-7": "shaper"}
SEEN = {"ex3-5": "CE", "p3-23a": "C", "ex3-7": "DE"}
"""Points whose numbers are compared with the peers'."""
MANY, TURN = 100_000, 360
ROUNDS = {MANY: 3, TURN: 50}
TIMES, TIMES_C = 1.0, 2.0
"""Many positions are faster than pylinkage's (7 to 12 times on a quiet machine), and in C not twice as slow as a loop in C
for this very mechanism (0.27 to 0.35 of it)."""
CLASS_III, TIMES_FITTED, TIMES_WALKED = "p3-15", 20.0, 6.0
"""How many times as long as a four-bar's a position may take whose links are fitted; and how many times as long as many
positions, a turn of a mechanism that was only loaded. Three to four times less on a quiet machine."""
OF = {"ex3-5": ("theta 3", "omega 3", "alpha 3", "v E", "a E"), "ex3-7": ("theta 4", "omega 4", "alpha 4", "v E", "a E")}
TIMES_SWEPT = {MANY: 8.0, TURN: 30.0}
"""How many times as long as the replay a sweep of five quantities may take, once its mechanism is planned and proved."""
TIMES_HELD = 4.0
"""How many times as long a replay may take that is held, once its method is known, as one that is not."""
SHORT, LONG, LIMIT_MIB = 10**5, 3 * 10**5, 1024
OWN_BYTES = 30
"""What a position of a table may cost: the driver's value, where on the way it is, and what is made of them."""



def graphkin_pva(method: Method, angles: np.ndarray) -> Plot:
    """Everything of every position, read as arrays: all points of the mechanism in the three planes, all links."""
    plot = replay_all(method, [angles])
    planes = plot.position, plot.velocity, plot.acceleration
    for names, table in zip(points_of(method.mechanism.name), planes, strict=True):
        for name in names:
            table[name]
    for table in (plot.theta, plot.omega, plot.alpha):
        for name in table:
            table[name]
    return plot


def everything(method: Method, angles: np.ndarray, compiled: bool = False) -> State:
    """The same by the public names, with units."""
    state = graphkin.replay(method, [np.degrees(angles)], compiled=compiled)
    for table, names in ((state.position, method.mechanism.points), (state.v, method.mechanism.points),
                         (state.a, method.mechanism.points), (state.theta, method.mechanism.moving),
                         (state.omega, method.mechanism.moving), (state.alpha, method.mechanism.moving)):  # fmt: skip
        for name in names:
            table[name]
    return state


@cache
def compiles() -> bool:
    """Whether a program can be had in C."""
    program = program_of(planned("ex3-5"))
    assert program is not None
    inputs = [np.zeros(2), *(np.array(float(side)) for side in program.sides.values())]
    return program.part(program.usual).function(inputs) is not None


# --- what the tests share ---------------------------------------------------------------------


def needs(package: str) -> None:
    """Skip where a peer is not installed; its own module imports it, and keeps its warnings to itself."""
    if find_spec(package) is None:
        pytest.skip(f"{package} is not installed: pip install graphkin[bench]")


@cache
def planned(name: str) -> Method:
    return graphkin.plan(graphkin.load(name))


@cache
def points_of(name: str) -> tuple[tuple[str, ...], ...]:
    """In each plane what belongs to a point of the mechanism, and is no corner between two arrows."""
    planes = planned(name).constructions
    return tuple(tuple(node.name for node in plane.nodes.values() if node.site is not None) for plane in planes)


def turn(name: str, count: int) -> np.ndarray:
    """Crank angles over a whole turn from the drawn position [rad]."""
    found: np.ndarray = float(planned(name).facts(None).values[0]) + np.linspace(0, 2 * np.pi, count)
    return found


def motion_of(method: Method, plot: Plot, point: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Place, velocity and acceleration of a point [m, m/s, m/s^2]."""
    nodes = method.velocity.nodes.values()
    node = next(node.name for node in nodes if node.site is not None and node.site.point == point)
    return plot.position[point], plot.velocity[node], plot.acceleration[f"{node}'"]


def drawn(name: str) -> dict[str, complex]:
    """Places of all points at the drawn position."""
    return {point: complex(place) for point, place in graphkin.replay(planned(name)).position.items()}


def agree(found: np.ndarray, other: np.ndarray, part: float = 1e-9) -> bool:
    """Whether two motions are one, to a part of the largest value: what a peer that adds up its steps can say."""
    return bool(np.max(np.abs(found - other)) <= part * np.max(np.abs(found)))


def seconds(work: Callable[[], object], before: Callable[[], object] = lambda: None) -> float:
    """CPU time of one call [s]; `before` is not timed."""
    before()
    start = time.thread_time()
    work()
    return time.thread_time() - start


def raced(count: int, works: Mapping[str, tuple[Callable[[], object], Callable[[], object]]]) -> dict[str, float]:
    """The best time of each work, each with what is to be done before; in turns."""
    best = dict.fromkeys(works, float("inf"))
    for _ in range(ROUNDS[count]):
        for name, (work, before) in works.items():
            best[name] = min(best[name], seconds(work, before))
    return best


def nothing() -> None:
    """What is done before a work that needs nothing done."""


def told(count: int, took: float) -> str:
    """The time of one call, and crank positions a second."""
    return f"{took * 1e3:9.3f} ms {count / took:12,.0f}/s"


# --- beside pylinkage -------------------------------------------------------------------------


@pytest.mark.bench
@pytest.mark.parametrize("name", MECHANISMS)
@pytest.mark.parametrize("count", [MANY, TURN])
def test_sweep_beside_pylinkage(name: str, count: int, capsys: pytest.CaptureFixture[str]) -> None:
    """Many times its rate for everything; of a single turn it is reported."""
    for needed in ("numba", "pylinkage"):
        needs(needed)
    from peers.linkage import Peer

    method, angles = planned(name), turn(name, count)
    peer = Peer(name, method, count, drawn(name))
    found, (places, velocities, accelerations) = graphkin_pva(method, angles), peer.everything()
    for point in SEEN[name]:
        for drawing, table in zip(motion_of(method, found, point), (places, velocities, accelerations), strict=True):
            assert agree(drawing, peer.of(point, table)), point

    ways = {"NumPy": False} | ({"C": True} if compiles() else {})
    works = {way: (partial(everything, method, angles, compiled), nothing) for way, compiled in ways.items()}
    works |= {"all": (peer.everything, peer.back), "positions": (peer.positions, peer.back)}
    best = raced(count, works)
    with capsys.disabled():
        print(f"\n{MECHANISMS[name]}, {count} positions:")
        for way in ways:
            print(f"  graphkin, {way:9}  {told(count, best[way])}")
        for kind in ("all", "positions"):
            times = ", ".join(f"{best[kind] / best[way]:5.2f} times as fast by {way}" for way in ways)
            print(f"  pylinkage, {kind:9} {told(count, best[kind])}  graphkin {times}")
    assert count != MANY or all(best["all"] >= TIMES * best[way] for way in ways), best


# --- beside a C loop --------------------------------------------------------------------------


@pytest.mark.bench
@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc to build the C loop with")
@pytest.mark.parametrize("name", MECHANISMS)
def test_sweep_beside_a_c_loop(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """How far a sweep is from a loop written in C for this very mechanism; of a single turn it is reported."""
    from peers.plain import Loop, built

    method, places = planned(name), drawn(name)
    library = built(tmp_path)
    for count in (MANY, TURN):
        angles = turn(name, count)
        loop = Loop(library, name, method, angles, side(name, places))
        out, found = loop.run(), graphkin_pva(method, angles)
        for point in SEEN[name]:
            for drawing, column in zip(motion_of(method, found, point), loop.of(point, out), strict=True):
                assert agree(drawing, column), point
        for link in loop.links:
            for table, column in zip(("omega", "alpha"), loop.rates(link, out), strict=True):
                assert agree(getattr(found, table)[link], column), link
        works = {"C": (loop.run, nothing), "graphkin": (partial(everything, method, angles, True), nothing)}
        best = raced(count, works)
        times = best["graphkin"] / best["C"]
        with capsys.disabled():
            print(f"\n{MECHANISMS[name]}, {count} positions: C {told(count, best['C'])}, graphkin {times:.2f} times as long")
        assert count != MANY or not compiles() or times <= TIMES_C


def side(name: str, places: Mapping[str, complex]) -> int:
    """Which assembly the C loop is to take: C left of the way B to D, or the rod's end farther along the guide."""
    if name == "ex3-5":
        way, rod = places["D"] - places["B"], places["C"] - places["B"]
        return 1 if (way.conjugate() * rod).imag > 0 else -1
    rod = places["C"] - places["B"] if name == "p3-23a" else places["E"] - places["D"]
    return 1 if rod.real > 0 else -1


# --- reported ---------------------------------------------------------------------------------


@pytest.mark.bench
def test_four_bar_beside_mechanism(capsys: pytest.CaptureFixture[str]) -> None:
    """Reported: vector loops solved by fsolve, position by position."""
    needs("mechanism")
    from peers.loops import four_bar

    method, angles = planned("ex3-5"), turn("ex3-5", TURN)
    found = graphkin_pva(method, angles)
    near = float(found.theta["2"][0]), float(found.theta["3"][0])
    solved, joint = four_bar(method, TURN, near)
    theirs, mine = seconds(solved.iterate), seconds(lambda: graphkin_pva(method, angles))
    place, velocity, acceleration = motion_of(method, found, "C")
    origin = drawn("ex3-5")["A"]
    assert agree(place, joint.x_positions + 1j * joint.y_positions + origin, 1e-7)
    assert agree(velocity, joint.x_velocities + 1j * joint.y_velocities, 1e-7)
    assert agree(acceleration, joint.x_accelerations + 1j * joint.y_accelerations, 1e-7)
    with capsys.disabled():
        print(f"\nfour-bar, {TURN} positions: mechanism {told(TURN, theirs)}, graphkin {theirs / mine:.0f} times as fast")


@pytest.mark.bench
def test_four_bar_beside_kinepy(capsys: pytest.CaptureFixture[str]) -> None:
    """Reported: kinepy gives positions; its velocities are differences, found with the forces."""
    needs("kinepy")
    from peers import solids

    method, angles = planned("ex3-5"), turn("ex3-5", MANY // 5)
    system, joint = solids.four_bar(method, -side("ex3-5", drawn("ex3-5")))
    theirs = seconds(lambda: solids.turn(system, angles))
    place = graphkin_pva(method, angles).position["C"]
    assert agree(place, joint.point[0] + 1j * joint.point[1])
    mine = min(seconds(lambda: graphkin_pva(method, angles)) for _ in range(5))
    with capsys.disabled():
        print(f"\nfour-bar, {angles.size} positions: kinepy, positions {told(angles.size, theirs)}, graphkin, all {theirs / mine:.1f} times as fast")


@pytest.mark.bench
def test_class_iii(capsys: pytest.CaptureFixture[str]) -> None:
    """A group that no ruler places, fitted at every position: a few times what a four-bar takes."""
    works = {}
    for name in (CLASS_III, "ex3-5"):
        found = graphkin_pva(planned(name), turn(name, MANY))
        assert all(np.isfinite(value).all() for value in found.acceleration.values())
        works[name] = (partial(graphkin_pva, planned(name), turn(name, MANY)), nothing)
    best = raced(MANY, works)
    anew = min(seconds(lambda: graphkin_pva(graphkin.plan(graphkin.load(CLASS_III)), turn(CLASS_III, TURN))) for _ in range(3))
    again = min(seconds(lambda: graphkin_pva(planned(CLASS_III), turn(CLASS_III, TURN))) for _ in range(3))
    with capsys.disabled():
        print(f"\nClass III shaper, {MANY} positions: graphkin {told(MANY, best[CLASS_III])}", end="")
        print(f", {best[CLASS_III] / best['ex3-5']:.1f} times as long as a four-bar")
        print(f"  {TURN} positions, its way found first {told(TURN, anew)}, again {told(TURN, again)}")
    assert best[CLASS_III] <= TIMES_FITTED * best["ex3-5"], best
    assert anew <= TIMES_WALKED * best[CLASS_III], (anew, best)


@pytest.mark.bench
@pytest.mark.parametrize("name", OF)
def test_sweep_beside_its_replay(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Five quantities of a mechanism that was swept before, with all that a sweep does beside: not much more."""
    mechanism = graphkin.load(name)
    method, driver = graphkin.plan(mechanism), mechanism.drivers[0].name
    for count in (MANY, TURN):
        degrees = {driver: np.linspace(0, 360, count)}
        swept = partial(graphkin.sweep, mechanism, degrees, OF[name])
        assert np.allclose(swept()["omega " + OF[name][0][-1]], graphkin_pva(method, np.radians(degrees[driver])).omega[OF[name][0][-1]])
        works = {"sweep": (swept, nothing), "replay": (partial(graphkin_pva, method, np.radians(degrees[driver])), nothing)}
        best = raced(count, works)
        with capsys.disabled():
            print(f"\n{MECHANISMS[name]}, {count} positions: sweep {told(count, best['sweep'])}", end="")
            print(f", {best['sweep'] / best['replay']:.1f} times as long as its replay")
        assert best["sweep"] <= TIMES_SWEPT[count] * best["replay"], best


@pytest.mark.bench
@pytest.mark.parametrize("name", MECHANISMS)
def test_held_beside_unproved(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """A turn as a program reads it, of a method that was held before: hardly more than without."""
    method, angles = planned(name), turn(name, TURN)
    mechanism = method.mechanism

    def read(held: bool) -> None:
        state = graphkin.replay(method, [np.degrees(angles)], held=held)
        for table, names in ((state.position, mechanism.points), (state.v, mechanism.points), (state.a, mechanism.points),
                             (state.theta, mechanism.moving), (state.omega, mechanism.moving), (state.alpha, mechanism.moving)):  # fmt: skip
            for each in names:
                table[each]

    works = {"held": (partial(read, True), nothing), "unproved": (partial(read, False), nothing)}
    best = raced(TURN, works)
    with capsys.disabled():
        print(f"\n{MECHANISMS[name]}, {TURN} positions by `replay`: {told(TURN, best['held'])}", end="")
        print(f", {best['held'] / best['unproved']:.2f} times as long as unproved")
    assert best["held"] <= TIMES_HELD * best["unproved"], best


# --- memory -----------------------------------------------------------------------------------

LONG_SWEEP = """
import resource, sys
from pathlib import Path
import graphkin
from graphkin.outputs import tables
from graphkin.studies.sweeps import course

count, path = int(sys.argv[1]), Path(sys.argv[2])
way = course(graphkin.plan(graphkin.load("ex3-5")), [f"0:360:{360 / (count - 1)!r}"])
assert way.t.size == count
tables.write(path, way, ("theta 3", "omega 3", "alpha 3", "v E", "a E"), "construction")
status = Path("/proc/self/status")  # ru_maxrss alone counts what the parent held when it started this process
if status.exists():
    print(next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM")))
else:
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


@pytest.mark.bench
@pytest.mark.skipif(sys.platform == "win32", reason="no resource module to ask for the peak of memory")
@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_memory_stays_flat(suffix: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A table of any length is written part by part: per position only the driver's own values are held.

    So ten million positions, as extended from two sizes, stay under 1 GiB.
    """
    if suffix == ".parquet":
        needs("pyarrow")
    short, long = (peak_mib(count, tmp_path / f"{count}{suffix}") for count in (SHORT, LONG))
    per_position = (long - short) / (LONG - SHORT)
    ten_million = short + per_position * (10**7 - SHORT)
    with capsys.disabled():
        print(f"\nfour-bar as {suffix}: peak {short:.0f} MiB at {SHORT} positions, {long:.0f} MiB at {LONG}", end="")
        print(f"; {per_position * 2**20:.0f} bytes a position, so {ten_million:.0f} MiB at 10 million")
    assert per_position * 2**20 < OWN_BYTES
    assert ten_million < LIMIT_MIB


def peak_mib(count: int, path: Path) -> float:
    """The most memory that writing a table of so many positions takes [MiB]; counted in KiB, on a Mac in bytes."""
    command = [sys.executable, "-c", LONG_SWEEP, str(count), str(path)]
    peak = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return int(peak) / (2**20 if sys.platform == "darwin" else 2**10)
