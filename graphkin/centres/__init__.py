"""Instant centres: where they are, how they are found, what they tell.

    Plot -- beneath --> Board over the mechanism          its points, guides, common normals
    Board -- search --> Centring (a drafting stage each)  by definition, on two lines, from velocities
    Centring over a way -- centrode_places.over --> Centres at many positions -> centrodes
    Centres -- velocities by centre and weight --> ByCentres; by ruler and printed figures --> Levers
    Centres -- about --> About: pole, circles, curvature; about_bobillier: the same by construction

Words are in `say.centre_*`, sheets in `sheet.centre_*` and `sheet.about_*`: they read the same stages.
"""

from graphkin.centres.centrode_places import over
from graphkin.centres.data import as_json, place
from graphkin.centres.found import Centres, centres
from graphkin.centres.uses import ByCentres, advantages

__all__ = ["ByCentres", "Centres", "advantages", "as_json", "centres", "over", "place"]
