"""Design of linkages from what they are to do, as drawn constructions.

    rocker, slider, guide_bar              from the time ratio K and the output's limits
    coupler_positions, angle_pairs         through given positions
    wanted values -> drafting.Construction -- drafting.replay --> Board -> Solution, judged by closed forms

Each returns a `Design`: all solutions, those that only seem to be some, and the family where a condition is free.
"""

from graphkin.design.guide import guide_bar
from graphkin.design.model import Arc, Design, Family, Reason, Solution
from graphkin.design.pairs import angle_pairs
from graphkin.design.poses import coupler_positions, hinges
from graphkin.design.proof import linkage_of, proof
from graphkin.design.rocker import rocker
from graphkin.design.slider import slider

__all__ = [
    "Arc", "Design", "Family", "Reason", "Solution", "angle_pairs", "coupler_positions", "guide_bar", "hinges",
    "linkage_of", "proof", "rocker", "slider",
]  # fmt: skip
