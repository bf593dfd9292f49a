"""Four-bar, slider-crank, guide bar: what they are and do, in closed form.

`report(linkage)` for lengths, `found_in(mechanism)` for the linkages that a mechanism holds.
"""

from graphkin.linkages.chain import reported
from graphkin.linkages.data import as_json
from graphkin.linkages.family import FAMILY, family_lines
from graphkin.linkages.finding import Found, found_in, some_found_in
from graphkin.linkages.inversion import inverted
from graphkin.linkages.model import FourBar, GuideBar, Linkage, Scale, SliderCrank
from graphkin.linkages.report import Advantage, Report, advantage, from_lengths, report
from graphkin.linkages.wording import found_lines, kind_name, lines
from graphkin.linkages.writing import as_mechanism

__all__ = [
    "FAMILY", "Advantage", "Found", "FourBar", "GuideBar", "Linkage", "Report", "Scale", "SliderCrank", "advantage",
    "as_json", "as_mechanism", "family_lines", "found_in", "found_lines", "from_lengths", "inverted", "kind_name",
    "lines", "report", "reported", "some_found_in",
]  # fmt: skip
