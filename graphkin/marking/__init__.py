"""Marking: what a student's own values, and mistakes, lead to.

A `PolygonHand` draws the polygons (`redraw`): `replay_with` with a student's own values in their place, `consequences`
with every mistake that can be made, each a `Rewrite` of one place of the construction, all at once on arrays.

`key_making` makes a `Key`, `marker` marks by it: `key` compares values, `follow_through` draws on from own values and
`carried` judges what follows, `diagnosis` finds the mistake by the likelihoods of `weights`. `tolerances`, `power` and
`discriminability` say what paper allows.
"""

from __future__ import annotations

from graphkin.marking.answers import ArrowPlaces, arrows_of, drawn_answer
from graphkin.marking.consequences import Consequences, combined, consequences, rewrites, rewritten
from graphkin.marking.follow_through import Followed, Own, replay_with
from graphkin.marking.hand import PolygonHand, Redrawing, redraw
from graphkin.marking.rewrite import Edit, Mistaken, Rewrite, RewrittenValue
from graphkin.marking.scene import MISTAKES, Mistake
from graphkin.marking.synonyms import OtherWay, other_methods, other_ways

__all__ = [
    "MISTAKES", "ArrowPlaces", "Consequences", "Edit", "Followed", "Mistake", "Mistaken", "OtherWay", "Own",
    "PolygonHand", "Redrawing", "Rewrite", "RewrittenValue", "arrows_of", "combined", "consequences", "drawn_answer",
    "other_methods", "other_ways", "redraw", "replay_with", "rewrites", "rewritten",
]  # fmt: skip
