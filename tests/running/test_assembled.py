"""In words, in which assembly a mechanism is drawn: true of this one, and of no other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from random_mechanisms import DYADS, dyad

from graphkin import api
from graphkin.construction import Meet, Plot, Swing, replay
from graphkin.files import library
from graphkin.planning import Method
from graphkin.running.drawn_sides import drawn_sides
from graphkin.say.problems import assembly_sentence


def choices(method: Method) -> list[Meet | Swing]:
    return [step for step in method.position.steps if isinstance(step, Meet | Swing) and step.choice is not None]


def told_apart(method: Method) -> int:
    """How many choices are told, each of which is true here and not with its other crossing."""
    plot, found = api.replay(method), drawn_sides(method, api.replay(method)).lies
    others = [replay(method.position, Plot(plot.facts, method.near), {s.choice: -s.side}) for s in choices(method)]
    for lies in found:
        assert lies.holds(plot)
        assert lies.by_distance or not all(lies.holds(other) for other in others)
    return len(found)


@pytest.mark.parametrize("name", ["ex3-1", "ex3-7", "p3-3b", "p3-16", "p3-21", "p3-22", "s4-ex8"])
def test_every_choice_of_a_mechanism_is_told(name: str):
    method = api.plan(library.load(name))
    assert told_apart(method) == len(choices(method))


@pytest.mark.parametrize("kind", DYADS)
def test_random_mechanisms(kind: str):
    found = [api.plan(dyad(kind, seed)) for seed in range(5)]
    assert sum(map(told_apart, found)) >= sum(len(choices(method)) for method in found)


@pytest.mark.parametrize(
    ("name", "en", "zh"),
    [
        ("ex3-5", "Assembly: C above DB.", "装配位置：C 在 DB 的上方。"),
        ("ex3-7", "Assembly: D above AB, E to the left of BD.", "装配位置：D 在 AB 的上方，E 在 BD 的左侧。"),
        ("p3-6b", "Assembly: C above D.", "装配位置：C 在 D 的上方。"),
        ("p3-7", "Assembly: F at that of its two possible places which is farther from A, C below BD.", None),
        ("p3-15", "Assembly: C near (-40, 800), D near (20, -160).", "装配位置：C 在 (-40, 800) 附近，D 在 (20, -160) 附近。"),
        ("scotch-yoke", "", ""),
    ],
)  # fmt: skip
def test_in_words(name: str, en: str, zh: str | None):
    method = api.plan(library.load(name))
    found = drawn_sides(method, api.replay(method))
    assert assembly_sentence(found, "en") == en
    assert zh is None or assembly_sentence(found, "zh") == zh


def test_the_other_assembly_is_told_otherwise():
    mechanism = library.load("ex3-5")
    corner = mechanism.sketch["C"]
    mirrored = replace(mechanism, sketch={**mechanism.sketch, "C": np.conj(corner)})
    words = [assembly_sentence(drawn_sides(m, api.replay(m)), "en") for m in map(api.plan, (mechanism, mirrored))]
    assert words == ["Assembly: C above DB.", "Assembly: C below DB."]
