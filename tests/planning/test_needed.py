"""A solution goes as far as the file asks: what it shows is enough to find that, and is all that it needs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from random_mechanisms import cam, circular_slot, epicyclic, geared_five_bar, rolling, triad

from graphkin.construction import Drawn, Equation, Given, LayOff, Measure, Plane
from graphkin.errors import GraphkinError
from graphkin.files import library, loads
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method, plan
from graphkin.planning.at_rest import at_rest, moving_parts
from graphkin.planning.needed import Fact, PartsReader, aids, needed, turning, without_aids
from graphkin.running import replay_all
from graphkin.say import explain

SCALES = {"length": 0.001, "velocity": 0.01, "acceleration": 0.1}
PLANES: tuple[Plane, Plane] = ("velocity", "acceleration")


def wants(method: Method) -> list[set[Fact]]:
    """Every point and every link by itself."""
    links = [{turning(method, word, link)} for word in ("omega", "alpha") for link in method.mechanism.moving]
    nodes = [{(plane, name)} for plane, c in zip(PLANES, method.constructions[1:], strict=True)
             for name, node in c.nodes.items() if node.site is not None]  # fmt: skip
    return links + nodes


def unfounded(method: Method, parts: dict[Plane, tuple]) -> set[Fact]:
    """What a polygon uses that nothing before it has given; driven motions and the mechanism itself are known."""
    missing: set[Fact] = set()
    known: set[Fact] = {(c.plane, c.pole) for c in method.constructions[1:]}
    known |= {(rate, slide) for rate in ("s_rate", "s_acceleration") for slide in method.structure.slides_driven}
    for plane, construction in zip(PLANES, method.constructions[1:], strict=True):
        reader = PartsReader(method, construction)
        for part in parts[plane]:
            needs = {fact for fact in reader.needs(part) if fact[0] not in ("position", "theta", "s")}
            missing |= {fact for fact in needs - known if not fact[0].startswith("driven")}
            known |= set(reader.gives(part))
    return missing


def check(method: Method) -> None:
    for wanted in wants(method):
        parts = needed(method, set(wanted))
        assert unfounded(method, parts) == set(), wanted


@pytest.mark.parametrize("name", library.names())
def test_each_part_rests_on_those_before(name: str) -> None:
    check(plan(library.load(name)))


@pytest.mark.parametrize("kind", [triad, geared_five_bar, epicyclic, rolling, cam, circular_slot])
@pytest.mark.parametrize("seed", range(4))
def test_each_part_of_any_mechanism_rests_on_those_before(kind: Callable[[int], Mechanism], seed: int) -> None:
    try:
        method = plan(kind(seed))
    except GraphkinError:
        pytest.skip("not solved")
    check(method)


def test_only_what_is_asked() -> None:
    mechanism = library.load("ex3-1")
    method = plan(replace(mechanism, ask=("omega 3",)))
    text = "\n".join(explain(method, replay_all(method), SCALES, "en"))
    assert "Accelerations" not in text
    assert "v_C" not in text
    assert text.endswith("Answer\n    ω3 = 3.919 rad/s (clockwise)")


@pytest.mark.parametrize(("name", "points", "also"), [
    ("p3-4a", "K", ""), ("p3-22", "NM", "BI"), ("ex3-1", "", ""), ("s2-1a", "Q", ""), ("p3-12", "", ""), ("p3-17", "", "B"),
])  # fmt: skip
def test_a_point_that_shows_a_direction_alone_is_in_no_polygon(name: str, points: str, also: str) -> None:
    """Nor is one that is taken on a link without it (B on a cylinder), where no other step needs it."""
    method = plan(library.load(name))
    drawn = without_aids(method)
    gone = {own.plane: {node.site.point for key, node in own.nodes.items() if node.site and key not in left.nodes}
            for own, left in zip(method.constructions[1:], drawn.constructions[1:], strict=True)}  # fmt: skip
    assert gone == {"velocity": set(points), "acceleration": set(points + also)}
    assert set(drawn.acceleration.steps) <= set(method.acceleration.steps)


def test_one_that_is_asked_for_is() -> None:
    cylinder = plan(replace(library.load("p3-17"), ask=("a B1", "omega 5")))
    assert "b1'" in without_aids(cylinder).acceleration.nodes
    mechanism = library.load("p3-4a")
    assert aids(mechanism) == {"K"}
    assert not aids(replace(mechanism, ask=("v K",)))


def test_as_far_as_one_wants() -> None:
    method = plan(library.load("ex3-1"))
    text = "\n".join(explain(method, replay_all(method), SCALES, "en", only="velocity"))
    assert "α3" not in text
    assert "ω3 = 3.919" in text


def test_a_driver_at_rest_holds_a_fixed_point() -> None:
    """The screw of an engine with adjustable stroke: its point D is on the pole, and nothing is said of 6, 7, 8."""
    method = plan(library.load("p3-21"))
    rested = at_rest(method, method.facts())
    assert {turning(method, "omega", link) for link in ("6", "7", "8")} <= rested
    assert not {turning(method, "omega", link) for link in ("1", "2", "3", "4")} & rested
    parts = moving_parts(method, "velocity", method.velocity.parts, rested)
    measured = [step.of for step in parts if isinstance(step, Measure) and step.quantity == "omega"]
    assert measured == ["2", "3", "4"]
    first = next(part for part in parts if isinstance(part, Equation))
    assert [term.name("velocity") for term in (*first.left, *first.right)] == ["v_B", "v_CB", "v_C"]


@pytest.mark.parametrize("name", library.names())
def test_what_is_known_comes_first(name: str) -> None:
    """On each side of an equation no known arrow follows an unknown one, but where the pole is found last."""
    method = plan(library.load(name))
    for construction in method.constructions[1:]:
        for part in construction.equations:
            if not any(isinstance(step, Given) for step in part.steps):
                for side in (part.left, part.right):
                    assert [term.unknowns > 0 for term in side] == sorted(term.unknowns > 0 for term in side)
            assert not any(isinstance(step, LayOff) and step.backwards for step in part.steps)


CYLINDER = """
[frame]
A = [0, 0]
D = [200, 0]
[links.1]
points = ["A"]
[links.2]
points = ["B"]
[links.3]
DB = 150
[[slide]]
name = "jack"
block = "2"
point = "B"
guide = "1"
through = "A"
[[driver]]
slide = "jack"
at = {stroke}
velocity = {speed}
[sketch]
B = [{x}, {y}]
"""


@pytest.mark.parametrize(("stroke", "speed", "x", "y"), [(160, 30, 90, 130), (240, -45, 190, -150)])
def test_a_carried_arrow_ends_at_its_point(stroke: float, speed: float, x: float, y: float) -> None:
    """The point behind the unknown arrow: drawn again from where it belongs, it is where analysis has it."""
    method = plan(loads(CYLINDER.format(stroke=stroke, speed=f'"{speed} mm/s"', x=x, y=y)))
    plot = replay_all(method)
    carried = [s for s in method.acceleration.steps if isinstance(s, LayOff) and isinstance(s.term.size, Drawn)]
    assert len(carried) == 1
    arm = plot.position["B"] - plot.position["A"]
    motion = (1j * plot.alpha["1"] - plot.omega["1"] ** 2) * arm
    assert plot.acceleration[carried[0].tip] == pytest.approx(motion, abs=1e-12)
