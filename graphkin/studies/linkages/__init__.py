"""Four-bar, slider-crank, guide bar: what they are and do, in closed form.

`report(linkage)` for lengths, `found_in(mechanism)` for the linkages that a mechanism holds.

    linkage               the contract of every kind, and the values it answers with
    four, slider, guide   a kind each, on `triangles`; `assembled` makes mechanisms of them
    family                all kinds, and every one that has a name of its own
    report                everything there is to say of one; `recognised`: those in a mechanism
    inversion             another link as frame; a mechanism as a file
"""

from graphkin.studies.linkages.family import FAMILY, KINDS, Linkage, from_lengths
from graphkin.studies.linkages.four import FourBar
from graphkin.studies.linkages.guide import GuideBar
from graphkin.studies.linkages.inversion import filed, inverted
from graphkin.studies.linkages.linkage import DriverScale
from graphkin.studies.linkages.recognised import FoundLinkage, found_in, some_found_in
from graphkin.studies.linkages.report import Advantage, Report, advantage, as_json, report, reported
from graphkin.studies.linkages.slider import SliderCrank

__all__ = [
    "FAMILY", "KINDS", "Advantage", "DriverScale", "FoundLinkage", "FourBar", "GuideBar", "Linkage", "Report",
    "SliderCrank", "advantage", "as_json", "filed", "found_in", "from_lengths", "inverted", "report", "reported",
    "some_found_in",
]  # fmt: skip
