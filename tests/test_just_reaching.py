"""Links that only just span their frame: what is said where a driver stands elsewhere."""

from __future__ import annotations

import pytest

import graphkin
from graphkin.errors import CannotAssemble


def test_freedoms_are_not_counted_where_the_links_just_touch():
    """24 + 6 + 48 = 78 mm: stretched out all lines are one, which is no second freedom at 60 deg."""
    text = """
[frame]
A = [0, 0]
D = [78, 0]
[links.1]
AB = 24
[links.2]
BC = 6
[links.3]
DC = 48
[[driver]]
vector = "AB"
angle = 60
[sketch]
C = [65, 46]
"""
    with pytest.raises(CannotAssemble):
        graphkin.plan(graphkin.loads(text))
