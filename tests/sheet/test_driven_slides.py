"""Arrows of what is driven along a line: one for the velocity, one for the acceleration, each in its own direction."""

from __future__ import annotations

import pytest
from driven_cylinder import cylinder

from graphkin.files import loads
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import Sheet, sheet
from graphkin.sheet.marks import Disc, Stroke, Text

WHEEL = """
[frame]
[links.wheel]
CA = 150
[[roll]]
name = "roll"
wheel = "wheel"
centre = "C"
radius = RADIUS
on = "frame"
through = [0, 0]
angle = 0
[[driver]]
slide = "roll"
at = 100
velocity = 0.2
acceleration = -0.3
[[pose]]
vector = "CA"
angle = 60
"""


def drawn(text: str) -> dict[str, Sheet]:
    """Its sheets: all of it, and what is given."""
    method = plan(loads(text))
    return {"all": sheet(method, replay_all(method)), "given": sheet(method, replay_all(method), style="given")}


def heads(page: Sheet) -> dict[str, tuple[complex, complex]]:
    """The tips of the arrows, and where they point."""
    found = dict[str, tuple[complex, complex]]()
    for mark in page.marks:
        if isinstance(mark, Stroke) and mark.shows is not None and mark.shows.form in ("push", "thrust"):
            tip, one, other = mark.places
            found[mark.shows.form] = tip, (2 * tip - one - other) / abs(2 * tip - one - other)
    return found


@pytest.mark.parametrize(("velocity", "acceleration"), [(-0.08, 0.1), (0.08, 0.1), (0.08, -0.1), (0.08, 0), (0, -0.1)])
def test_a_driven_cylinder_has_an_arrow_for_each_of_its_motions(velocity: float, acceleration: float) -> None:
    names = {"vB3B2": velocity, "aB3B2r": acceleration}
    for style, page in drawn(cylinder(velocity, acceleration)).items():
        out = complex(-600, -670.8) / 900  # from C to B on paper
        wanted = {"push": velocity, "thrust": acceleration}
        found = heads(page)
        assert found.keys() == {form for form, value in wanted.items() if value}, style
        for form, (_, way) in found.items():
            assert (way / out).real * wanted[form] > 0, (style, form)
    written = {"".join(run.text for run in mark.label) for mark in page.marks if isinstance(mark, Text)}
    assert written & {"vB3B2", "aB3B2r"} == {name for name, value in names.items() if value}


@pytest.mark.parametrize("radius", [40, 225, 800])
def test_the_arrows_of_a_driven_wheel_are_at_its_centre_or_over_it(radius: float) -> None:
    """Not in the ground under the wheel, nor over the top of a large one."""
    for style, page in drawn(WHEEL.replace("RADIUS", f"{radius}")).items():
        (rim,) = (mark for mark in page.marks if isinstance(mark, Disc) and mark.shows and mark.shows.form == "wheel")
        found = heads(page)
        assert found["push"][1].real == pytest.approx(1), style
        assert found["thrust"][1].real == pytest.approx(-1), style
        for tip, _ in found.values():
            assert tip.imag < rim.centre.imag + rim.radius, style
            assert abs(tip - rim.centre) < max(20, rim.radius), style
            assert abs(tip.real - rim.centre.real) < 8, style
