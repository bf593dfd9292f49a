"""Instant centres: where they are, how they are found, what they tell."""

from graphkin.centres.centrode_places import over
from graphkin.centres.found import Centres, centres
from graphkin.centres.telling import advantage_lines, as_json, place, rows, told
from graphkin.centres.uses import ByCentres, advantages

__all__ = [
    "ByCentres", "Centres", "advantage_lines", "advantages", "as_json", "centres", "over", "place", "rows",
    "told",
]  # fmt: skip
