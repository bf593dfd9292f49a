"""Instant centres: where they are, how they are found, what follows from them.

    Plot -- underlay -> Board over the mechanism          its points, guides, common normals
    Board -- search --> Centring (a drafting stage each)  by definition, on two lines, from velocities
    Centres, and the names of some of them -- shortest --> Centring with the fewest lines
    Centres -- over --> Centres at many positions --> Centrodes
    Centres -- levers --> Levers (a drafting stage each)  velocities, in millimetres of paper or in metres; advantages
    Centres -- about --> About: pole, circles, curvature; about_bobillier: the same by construction

Words are in `say.centre_*`, sheets in `sheet.centre_*` and `sheet.about_*`: they read the same stages.
"""

from graphkin.studies.centres.instant_centres import Centres, as_json, centres, over, place
from graphkin.studies.centres.levers import advantages

__all__ = ["Centres", "advantages", "as_json", "centres", "over", "place"]
