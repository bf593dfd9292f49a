"""Points that only show a direction are in no polygon, unless they are asked for or joined to something."""

from __future__ import annotations

from dataclasses import replace

import pytest

import graphkin
from graphkin.planning.needed import aids, without_aids


@pytest.mark.parametrize(("name", "points"), [("p3-4a", "K"), ("p3-22", "NM"), ("ex3-1", ""), ("s2-1a", "Q"), ("p3-12", "")])
def test_a_point_that_shows_a_direction_alone_is_in_no_polygon(name: str, points: str) -> None:
    method = graphkin.plan(graphkin.load(name))
    drawn = without_aids(method)
    gone = {polygon.plane: polygon.nodes.keys() - own.nodes.keys()
            for polygon, own in ((method.velocity, drawn.velocity), (method.acceleration, drawn.acceleration))}  # fmt: skip
    assert gone["velocity"] == {p.lower() for p in points}
    assert {n for n in gone["acceleration"] if n[0] != "n" or n in ("n'",)} == {p.lower() + "'" for p in points}
    steps = {step for part in method.acceleration.parts for step in (getattr(part, "steps", (part,)))}
    assert {step for part in drawn.acceleration.parts for step in getattr(part, "steps", (part,))} <= steps


def test_one_that_is_asked_for_is() -> None:
    mechanism = graphkin.load("p3-4a")
    assert aids(mechanism) == {"K"}
    assert not aids(replace(mechanism, ask=("v K",)))
