"""Bobillier's sheet where the centre of curvature is too far off for the paper."""

from __future__ import annotations

import cmath
import math
import re

import pytest
from library_sheets import loaded, plain_text

import graphkin
from graphkin.sheet.about_sheet import bobillier_sheet
from graphkin.sheet.marks import ArcMark, Text
from graphkin.studies.centres import centres
from graphkin.studies.centres.about import Circle, about
from graphkin.studies.centres.about_bobillier import bobillier


@pytest.mark.parametrize("name", ["ex3-5", "s3-four"])
def test_a_centre_of_curvature_beyond_the_paper_has_an_arrow_with_its_distance(name):
    """Of a place near the inflection circle; both equal angles are bare arcs on the paper, each with its letter."""
    drawing = graphkin.Drawing.of(loaded(name))
    link = about(centres(drawing.method, drawing.plot), "2")
    assert isinstance(link.inflection, Circle)
    ring = (link.inflection.centre + 0.99 * link.inflection.radius * cmath.exp(1j * k / 10) for k in range(63))
    place = min(ring, key=abs)
    radius = 1000 * link.carried(place).radius
    sheet = bobillier_sheet(bobillier(link, place))
    texts = [plain_text(mark.label) for mark in sheet.marks if isinstance(mark, Text)]
    (far,) = (text for text in texts if "ρ" in text)
    told = re.search(r"= ([\d.]+) mm", far)
    assert told
    assert float(told[1]) == pytest.approx(radius, rel=1e-3)
    assert radius > 500
    assert texts.count("δ") == 2
    arcs = [mark for mark in sheet.marks if isinstance(mark, ArcMark) and mark.pen == "thin"]
    assert len([arc for arc in arcs if math.isclose(abs(arc.sweep), abs(arcs[-1].sweep))]) == 2
