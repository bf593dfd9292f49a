"""Every library mechanism with each of its links held in turn: the same motion seen from another link, by both roads."""

from __future__ import annotations

import pytest

from graphkin.analytic import motion
from graphkin.api import plan
from graphkin.errors import DeadPoint, NoFixing
from graphkin.files import library, loads
from graphkin.proof.roads import compare
from graphkin.running import replay_all
from graphkin.say import linkages as words


@pytest.mark.parametrize("name", library.names())
def test_inversions_are_solved(name: str):
    mechanism = library.load(name)
    for link in mechanism.moving:
        try:
            text = words.held(mechanism, link).text
        except NoFixing:
            continue
        held = loads(text, name=f"{name}-{link}", file=f"{name}-{link}.toml")
        method = plan(held)
        try:
            plot = replay_all(method)
        except DeadPoint as error:
            assert error.angle_deg < 0.5
            continue
        assert compare(method, plot, motion(held)) < 1e-9, link
