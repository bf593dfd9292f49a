"""Instant centres: where they are, how they are found, what they tell."""

from graphkin.centres.found import Centres, centre_of, centres, over
from graphkin.centres.uses import ByCentres

__all__ = ["ByCentres", "Centres", "centre_of", "centres", "over"]
