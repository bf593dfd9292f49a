"""Velocity images of gears: circles about the points of the polygon that are their centres."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.model.mechanism import FRAME
from graphkin.model.wheels import Wheel, wheels_of
from graphkin.planning.method import Method


def imaged_gears(method: Method) -> Iterator[tuple[Wheel, str, str]]:
    """Every gear once, with its circle's name, and the polygon's point of its centre; wheels that only roll have none.
    `g` is another letter where the mechanism has a point G."""
    letter = next((c for c in "gwzu" if c.upper() not in method.mechanism.points), "g")
    for wheel in wheels_of(method.mechanism):
        if wheel.gear and (centre := _centre(method, wheel)) is not None:
            called = method.mechanism.called(wheel.link)
            yield wheel, letter + ("" if called.isdigit() else "@") + called, centre


def _centre(method: Method, wheel: Wheel) -> str | None:
    """The polygon's point of a gear's centre; those of fixed points are the pole's."""
    owners = method.mechanism.owners.get(wheel.centre, ())
    if FRAME in owners or wheel.link == FRAME:
        return method.velocity.pole
    nodes = method.velocity.nodes.items()
    at_centre = [(name, node.site) for name, node in nodes if node.site and node.site.point == wheel.centre]
    at_centre.sort(key=lambda entry: entry[1] is None or entry[1].link != wheel.link)
    return next((name for name, site in at_centre if site is not None and site.link in owners), None)
