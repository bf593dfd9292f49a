"""Marking: what a student's own values, and mistakes, lead to.

A `Hand` draws the polygons (`redraw`): `replay_with` with a student's own values in their place, `consequences` with
every mistake that can be made, each a `Rewrite` of one place of the construction, all at once on arrays.
"""

from __future__ import annotations

from graphkin.marking.asked import ArrowPlaces, arrows_of, asked
from graphkin.marking.consequences import Consequences, combined, consequences, rewrites, rewritten
from graphkin.marking.follow_through import Followed, Own, replay_with
from graphkin.marking.hand import Hand, Hands, Redrawing
from graphkin.marking.redrawing import redraw
from graphkin.marking.rewrite import Edit, Mistaken, Rewrite, RewrittenValue
from graphkin.marking.right_ways import OtherWay, other_methods, other_ways
from graphkin.marking.scene import MISTAKES, Mistake

__all__ = [
    "MISTAKES", "ArrowPlaces", "Consequences", "Edit", "Followed", "Hand", "Hands", "Mistake",
    "Mistaken", "OtherWay", "Own", "Redrawing", "Rewrite", "RewrittenValue", "arrows_of", "asked", "combined",
    "consequences", "other_methods", "other_ways", "redraw", "replay_with", "rewrites",
    "rewritten",
]  # fmt: skip
