"""Instant centres: where they are, how they are found, what they tell.

    Plot -- underlay -> Board over the mechanism          its points, guides, common normals
    Board -- search --> Centring (a drafting stage each)  by definition, on two lines, from velocities
    Centres, and which of them are wanted -- shortest --> Centring with the fewest lines
    Centring over a path - centrode_places.over --> Centres at many positions -> centrodes
    Centres -- levers --> Levers (a drafting stage each)  velocities, in millimetres of paper or in metres; advantages
    Centres -- about --> About: pole, circles, curvature; about_bobillier: the same by construction

Words are in `say.centre_*`, sheets in `sheet.centre_*` and `sheet.about_*`: they read the same stages.
"""

from graphkin.studies.centres.advantages import advantages
from graphkin.studies.centres.centrode_places import over
from graphkin.studies.centres.data import as_json, place
from graphkin.studies.centres.instant_centres import Centres, centres

__all__ = ["Centres", "advantages", "as_json", "centres", "over", "place"]
