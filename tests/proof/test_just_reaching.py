"""Links that only just span their frame: what is said where a driver stands elsewhere."""

from __future__ import annotations

import pytest
from just_reaching import TOUCHING

import graphkin
from graphkin.errors import CannotAssemble


def test_freedoms_are_not_counted_where_the_links_just_touch():
    """24 + 6 + 48 = 78 mm: stretched out all lines are one, which is no second freedom at 60 deg."""
    with pytest.raises(CannotAssemble):
        graphkin.plan(graphkin.loads(TOUCHING))
