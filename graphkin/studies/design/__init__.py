"""Design of linkages from what they are to do, as drawn constructions.

    rocker, slider, guide_bar              from the time ratio K and the output's limits
    coupler_positions, angle_pairs         through given positions
    conditions -> drafting.Drafting -- drafting.replay --> Board -> Solution, judged by closed forms

Each returns a `Design`: all solutions, those that only seem to be some, and the family where a condition is free.
"""

from graphkin.studies.design.model import CentreArc, Design, Family, Reason, Solution, linkage_of
from graphkin.studies.design.positions import angle_pairs, coupler_positions, hinges
from graphkin.studies.design.quick_return import guide_bar, rocker, slider

__all__ = [
    "CentreArc", "Design", "Family", "Reason", "Solution", "angle_pairs", "coupler_positions", "guide_bar", "hinges",
    "linkage_of", "rocker", "slider",
]  # fmt: skip
