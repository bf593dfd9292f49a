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
from graphkin.design.proof import as_toml, linkage_of, mechanism_of, proof
from graphkin.design.rocker import rocker
from graphkin.design.slider import slider
from graphkin.design.telling import as_json, error, lines, said, sentences

__all__ = [
    "Arc", "Design", "Family", "Reason", "Solution", "angle_pairs", "as_json", "as_toml", "coupler_positions", "error",
    "guide_bar", "hinges", "lines", "linkage_of", "mechanism_of", "proof", "rocker", "said", "sentences", "slider",
]  # fmt: skip
