"""Instant centres against the velocities of the analysis, Kennedy's theorem, and what follows from centres alone."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
import pytest
import random_mechanisms
from click.testing import CliRunner
from random_mechanisms import DYADS, dyad

from graphkin.analytic import Motion, motion
from graphkin.api import plan
from graphkin.cli import main
from graphkin.construction.drafting import Board, DraftMeet, LineStep, drawn_through, ruled
from graphkin.construction.drafting.board import Homogeneous
from graphkin.errors import NOWHERE, GraphkinError
from graphkin.files import library, loads
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.quantities import centre_of, named
from graphkin.running import replay_all
from graphkin.studies.centres import Centres, centres
from graphkin.studies.centres.instant_centres import as_json, shortest
from graphkin.studies.centres.levers import Levers, carried_through
from graphkin.studies.sweeps import sweep

KINDS = (
    *DYADS, "cylinder", "relative_angle", "coupler_angle", "chain", "triad", "six_bar", "geared_five_bar", "epicyclic",
    "rolling", "cam", "circular_slot",
)  # fmt: skip


def found(mechanism: Mechanism) -> Centres:
    method = plan(mechanism)
    return centres(method, replay_all(method))


def moves(exact: Motion, link: str, place: complex) -> tuple[complex, float]:
    """Velocity of the place of a link, and its rotation, by the analysis."""
    if link == FRAME:
        return 0j, 0.0
    point, omega = next(iter(exact.mechanism.links[link].points)), float(exact.omega[link])
    return complex(exact.velocity[point]) + 1j * omega * (place - complex(exact.position[point])), omega


def hold(here: Centres, exact: Motion) -> int:
    """Every centre is where the two links have one velocity; at infinity, across their relative velocity."""
    mechanism = exact.mechanism
    origin = complex(exact.position[mechanism.points[0]])
    size = max(abs(complex(p) - origin) for p in exact.position.values())
    fastest = max(abs(float(w)) for w in exact.omega.values()) or 1.0
    speed = max(abs(complex(v)) for v in exact.velocity.values()) or 1.0
    for first, second in here.centring.links.values():
        (v, omega), (other, turn) = moves(exact, first, origin), moves(exact, second, origin)
        gap, turning = v - other, omega - turn
        if abs(turning) < 1e-10 * max(fastest, speed / size):
            if abs(gap) < 1e-10 * speed:
                continue  # at rest against each other just now: any place will do, and the lines give that of the limit
            assert np.isinf(here.place(first, second))
            assert abs(np.sin(np.angle(1j * gap) - here.direction(first, second))) < 1e-9
        else:
            right = origin + 1j * gap / turning
            far = max(size, abs(right - origin) ** 2 / size)
            assert abs(here.place(first, second) - right) < 1e-9 * far, (first, second)
    for first, second in here.centring.together:
        (v, omega), (other, turn) = moves(exact, first, origin), moves(exact, second, origin)
        assert abs(v - other) < 1e-9 * speed
        assert abs(omega - turn) < 1e-9 * max(fastest, speed / size)
    return len(here.centring.links)


@pytest.mark.parametrize("name", library.names())
def test_centres_of_the_library(name: str):
    mechanism = library.load(name)
    count = len(mechanism.links)
    here = found(mechanism)
    assert hold(here, motion(mechanism)) + len(here.centring.together) == count * (count - 1) // 2


@pytest.mark.many
@pytest.mark.parametrize("kind", KINDS)
def test_centres_of_random_mechanisms(kind: str):
    tried = 0
    for seed in range(40 if "GRAPHKIN_RANDOM" in os.environ else 25):
        mechanism = getattr(random_mechanisms, kind)(seed) if hasattr(random_mechanisms, kind) else dyad(kind, seed)
        try:
            here = found(mechanism)
        except GraphkinError:
            continue
        tried += 1
        hold(here, motion(mechanism))
    assert tried > 20


@pytest.mark.parametrize("name", ["fig3-4", "ex3-7", "ex3-2", "ex3-3", "p3-8", "p3-14", "p3-15", "p3-22", "s4-ex5"])
def test_three_centres_of_three_links_lie_on_a_line(name: str):
    here = found(library.load(name))
    for three in combinations(here.method.mechanism.links, 3):
        names = [here.name(*two) for two in combinations(three, 2)]
        points = here.board.points
        if all(one in points for one in names):
            matrix = np.array([points[one] / np.linalg.norm(points[one]) for one in names])
            assert abs(np.linalg.det(matrix)) < 1e-10, names


@pytest.mark.parametrize("name", library.names())
def test_each_centre_is_found_from_centres_found_before(name: str):
    known: set[str] = set()
    for stage in found(library.load(name)).centring.stages:
        assert {end for line in stage.lines for end in drawn_through(line)} <= known
        known.add(stage.last.name)


def test_one_freedom_needs_no_velocities():
    """Class III mechanisms of the source, too, are found by Kennedy's lines alone."""
    for name in ("ex3-2", "p3-15", "p3-17", "s3-sieve", "ex3-7", "p3-20"):
        assert not any(stage.say == "velocities" for stage in found(library.load(name)).centring.stages)


@pytest.mark.many
@pytest.mark.parametrize("name", library.names())
def test_velocities_from_centres_alone(name: str):
    mechanism = library.load(name)
    by, exact = carried_through(found(mechanism)).motions, motion(mechanism)
    fastest = max(abs(float(exact.omega[link])) for link in mechanism.moving)
    speed = max(abs(complex(v)) for v in exact.velocity.values()) or 1.0
    for link in mechanism.moving:
        assert float(by.omega[link]) == pytest.approx(float(exact.omega[link]), rel=1e-9, abs=1e-9 * fastest)
    for point in mechanism.points:
        assert abs(by.velocity_at(point, mechanism.owners[point][-1]) - exact.velocity[point]) < 1e-9 * speed


@pytest.mark.parametrize(("name", "slide"), [
    ("p3-5", "s0"), ("p3-11c", "s0"), ("p3-4b", "s0"), ("p3-6a", "s0"), ("s4-ex8", "s0"),
])  # fmt: skip
def test_a_driven_slide_on_any_guide(name: str, slide: str):
    """Also where both links move along one line, and where neither turns."""
    mechanism = library.load(name)
    driver = Driver("slide", slide, value=float(replay_all(plan(mechanism)).s[slide]), rate=-0.13)
    mechanism = replace(mechanism, drivers=(driver,))
    levers, exact = Levers(found(mechanism), 0.001), motion(mechanism)
    levers.start(driver)
    by = carried_through(found(mechanism)).motions
    for link in mechanism.moving:
        assert float(by.omega[link]) == pytest.approx(float(exact.omega[link]), rel=1e-9, abs=1e-9)
        if (way := levers.path(link)) is not None:
            levers.along(way)
            if levers.turning[link]:
                assert levers.omega(link) == pytest.approx(float(exact.omega[link]), rel=5e-3)
            else:
                velocity = complex(exact.velocity_at(next(iter(mechanism.links[link].points)), link))
                assert levers.value(link) == pytest.approx(abs(velocity), rel=5e-3, abs=1e-9)


@pytest.mark.parametrize("name", library.names())
def test_figures_on_paper_come_from_the_exact_steps(name: str):
    """A board that rounds and one that does not take the same steps."""
    over = found(library.load(name))
    paper, exact = (carried_through(over, scale) for scale in (0.001, 0.0))
    assert paper.stages == exact.stages
    for number, value in exact.board.numbers.items():
        if number.startswith("omega "):
            assert float(paper.board.numbers[number]) == pytest.approx(float(value), rel=2e-2, abs=1e-4)


ANSWERS = [
    ("fig3-4", "omega 4", 4.281881), ("fig3-4", "v E", 0.27782), ("p3-12", "omega 1 / omega 3", 0.534962),
    ("p3-13", "v C", 0.40098), ("p3-14", "v F / v A", 3.0), ("p3-15", "v C", 1.22039), ("s3-1-17", "v C", 0.91562),
    ("s3-1-18a", "omega 2", -2.0), ("s3-1-18b", "omega 2", 1.428571), ("s3-cam", "v B", 0.09616),
    ("fig3-5", "v K", 0.16576), ("ex3-2", "v C", 0.35460), ("s4-ex8", "v D", 0.5),
]  # fmt: skip


@pytest.mark.parametrize(("name", "question", "value"), ANSWERS)
def test_exercises_from_centres_alone(name: str, question: str, value: float):
    mechanism = library.load(name)
    told = named(mechanism, question, NOWHERE).answer(carried_through(found(mechanism)).motions)
    assert float(told.value) == pytest.approx(value, rel=1e-6, abs=6e-6)


def test_names_of_centres():
    mechanism = library.load("p3-14")
    assert centre_of(mechanism, "P31") == ("3", "1")
    assert centre_of(mechanism, "P37") == ("3", FRAME)
    assert centre_of(mechanism, "P3,7") == ("3", FRAME)
    for text in ("P", "P3", "P33", "P39", "Q13", "omega 3", "P134"):
        assert centre_of(mechanism, text) is None


@pytest.mark.parametrize("name", ["fig3-4", "fig3-10", "ex3-7", "p3-15", "p3-12", "p3-8"])
def test_centres_over_a_sweep_by_both_roads(name: str):
    """Also where the two lines that were chosen at the drawn position come to coincide."""
    method = plan(library.load(name))
    names = [f"P{a},{b}" for a, b in combinations(map(method.mechanism.called, method.mechanism.links), 2)]
    one, other = (sweep(method, of=names, by=by) for by in ("construction", "analysis"))
    size = method.size
    for first, second in zip(one.series, other.series, strict=True):
        near = np.isfinite(second.vectors) & (np.abs(second.vectors) < 20 * size)
        assert np.allclose(first.vectors[near], second.vectors[near], rtol=0, atol=1e-7 * size), first.name


# --- with few lines -----------------------------------------------------------------------------


@pytest.mark.parametrize("name", library.names()[::7])
def test_the_shortest_way_to_a_centre_is_a_way_to_it(name: str) -> None:
    """Every line joins what is there, both meet in the centre, and there are no more than the search draws."""
    here = found(library.load(name))
    for wanted in here.centring.links:
        way, known = shortest(here, [wanted]), set[str]()
        for stage in way.stages:
            for line in stage.lines if isinstance(stage.last, DraftMeet) else ():
                assert set(drawn_through(line)) <= known
                point, place = here.board.points[stage.last.name], ruled(line, here.board)
                assert abs(np.dot(point, place)) < 1e-9 * np.linalg.norm(point) * np.linalg.norm(place)
            known.add(stage.last.name)
        assert wanted in known
        assert way.stages[-1].last.name == wanted
        assert len(way.stages) <= len(here.centring.stages)


def train_of(count: int) -> str:
    """Wheels side by side, each in mesh with the next: all centres lie on one line."""
    names = "ABCDEFGHJKLMNQ"[:count]
    frame = ["[frame]", *(f"{name} = [{40 * k}, 0]" for k, name in enumerate(names))]
    links = [f'[links.{k}]\npoints = ["{name}"]' for k, name in enumerate(names, 1)]
    gears = [
        f'[[gear]]\nlinks = ["{k}", "{k + 1}"]\ncentres = ["{one}", "{other}"]\nradii = [20, 20]'
        for k, (one, other) in enumerate(pairwise(names), 1)
    ]
    return "\n".join([*frame, *links, *gears, '[[driver]]\nlink = "1"\nomega = 1\n'])


def test_each_of_kennedys_lines_is_drawn_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Though no two of them ever meet, and all wait for one centre after another."""
    drawn: list[LineStep] = []

    def once(line: LineStep, board: Board) -> Homogeneous:
        drawn.append(line)
        return ruled(line, board)

    monkeypatch.setattr("graphkin.studies.centres.search.ruled", once)
    method = plan(loads(train_of(8)))
    found = centres(method, replay_all(method))
    assert len(found.names) == 9 * 8 // 2
    assert len(drawn) <= len(found.names) * 7


ROLLER = """
ask = ["P13", "P24"]
frame = { name = "1", O = [0, 0], D = [97, 18] }
links = { 2.OC = 22, 3.points = ["B"], 4.DB = 84 }
cam = [{ links = ["2", "4"], profiles = [{ centre = "C", radius = 46 }, { centre = "B", radius = 13 }] }]
driver = [{ vector = "OC", angle = 64, omega = 9.3 }]
sketch = { B = [40, 80] }
"""


def test_centres_of_an_idle_roller_are_undetermined():
    """But for its hinge: it may turn as it likes. The others are found without them."""
    these = found(loads(ROLLER))
    data = as_json(these)["centres"]
    assert {name for name, entry in data.items() if entry["by"] == "undetermined"} == {"P13", "P23"}
    assert not any("at" in data[name] or "direction" in data[name] for name in ("P13", "P23"))
    assert data["P34"]["by"] == "hinge"
    assert set(these.centring.links) == {"P12", "P14", "P24", "P34"}
    by_lines = [by for entry in data.values() if isinstance(by := entry["by"], list)]
    assert not any({"P13", "P23"} & set(line) for lines in by_lines for line in lines)


@pytest.mark.parametrize(("lang", "said"), [("en", "P13, P23: undetermined, as link 3 turns idly; without it N = 3, K = 3."),
                                            ("zh", "P13、P23：不确定，因构件 3 的转动为局部自由度；不计该构件时 N = 3，K = 3。")])  # fmt: skip
def test_an_undetermined_centre_is_said_to_be(lang, said):
    printed = CliRunner().invoke(main, ["centres", "-", "--lang", lang], input=ROLLER).output
    assert said in printed
    assert CliRunner().invoke(main, ["explain", "-", "--lang", lang], input=ROLLER).exit_code == 0


LIFTED = """
ask = ["v C"]
frame = {{ name = "4", A = [0, 0] }}
links = {{ 1.AB = 20, 2.points = ["C"], 3.points = ["C"] }}
cam = [{{ links = {links}, profiles = {profiles} }}]
slide = [{{ name = "lift", block = "2", point = "C", guide = "frame", through = [{offset}, 0], angle = 90 }}]
driver = [{{ vector = "AB", angle = {angle}, omega = {omega} }}]
sketch = {{ C = [{offset}, 58] }}
"""
CAM, WHEEL = '{ centre = "B", radius = 40 }', '{ centre = "C", radius = 12 }'


@pytest.mark.parametrize(("offset", "angle", "omega"), [(15, 20, 12.57), (-11, 200, -4), (0, 310, 7)])
@pytest.mark.parametrize("turned", [False, True])
def test_a_roller_pushes_the_link_that_it_turns_on(offset, angle, omega, turned):
    """The follower moves as its point of the common normal, and counts as one link with its roller."""
    links, profiles = (["3", "1"], f"[{WHEEL}, {CAM}]") if turned else (["1", "3"], f"[{CAM}, {WHEEL}]")
    text = LIFTED.format(links=links, profiles=profiles, offset=offset, angle=angle, omega=omega)
    mechanism = loads(text)
    levers, exact = Levers(found(mechanism)), motion(mechanism)
    levers.start(mechanism.drivers[0])
    assert levers.path("3") is None
    levers.along(levers.path("2") or [])
    assert levers.value("2") == pytest.approx(abs(complex(exact.velocity["C"])), rel=1e-9)
    printed = CliRunner().invoke(main, ["explain", "-"], input=text).output
    assert "N = 3 links" in printed
    assert f"at the contact of links {' and '.join(links)}, which runs through C of link 2" in printed
    assert re.search(rf"v_2 = v_P12 = ω1 P14P12 .* = {abs(complex(exact.velocity['C'])):.4g}\d* m/s", printed)


WORDS = """
ask = ["P连杆,机架"]
frame = { name = "机架", A = [0, 0], D = [88, -6] }
links = { 曲柄.AB = 26, 连杆.BC = 83, 摇杆.DC = 54 }
driver = [{ vector = "AB", angle = 113, omega = 9 }]
sketch = { B = [-10, 24], C = [70, 45] }
"""


def test_a_centre_is_spelled_as_it_is_asked_and_names_do_not_run_together():
    words = re.sub(r'(曲柄|连杆|摇杆)(?=\.)', r'"\1"', WORDS)
    for command in ("centres", "explain", "solve"):
        printed = CliRunner().invoke(main, [command, "-", "--lang", "zh"], input=words).output
        assert "P连杆,机架" in printed
        assert "P机架,连杆" not in printed
        assert "架P" not in printed
        assert "杆P" not in printed
