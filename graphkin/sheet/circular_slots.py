"""Circular slots: an arc of their link with the slot cut into it, to scale about its centre."""

from __future__ import annotations

from itertools import product

from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import CircularSlot
from graphkin.sheet import symbols
from graphkin.sheet.marks import Mark, Place, Shows, Stroke
from graphkin.sheet.skeleton import OVERRUN, Skeleton

_REACH = 15.0
"""How far a slot goes on to both sides of its pin, along the arc [mm]."""
_MOST = 2.4
"""Half of the widest slot there is room for on a small circle [rad]."""


def circular_slot(skeleton: Skeleton, slot: CircularSlot) -> list[Mark]:
    """Over its link's arc, or on the ground; the centre line is what a ruler holds against the radius."""
    centre, pin = skeleton.at(slot.centre), skeleton.at(slot.point)
    step, radius = skeleton.step(slot.centre, slot.point), slot.radius / skeleton.window.scale
    way, half = (pin - centre) / abs(pin - centre), min(_REACH / radius, _MOST)
    cut = symbols.arc_places(centre, radius * way, -half, half)
    fixed = slot.guide == FRAME
    marks = symbols.arc_ground(centre, cut, step) if fixed else _plate(skeleton, slot, centre, radius * way, half)
    shows = Shows(slot.guide, "arc", (slot.centre, slot.point), slot.name)
    marks += symbols.arc_slot(centre, cut, shows, step)
    return [*marks, Stroke(tuple(cut), "centre", shows=shows, step=step)]


def _plate(skeleton: Skeleton, slot: CircularSlot, centre: Place, start: complex, half: float) -> list[Mark]:
    """The arc of a moving link that carries the slot, joined to the nearest of the link's points."""
    step, more = skeleton.step(slot.centre, slot.point), half + min(OVERRUN / abs(start), 0.4)
    arc = symbols.arc_places(centre, start, -more, more)
    points = [skeleton.at(point) for point in skeleton.named(slot.guide)]
    arm = min(product((arc[0], arc[-1]), points), key=lambda ends: abs(ends[1] - ends[0]))
    return [Stroke(tuple(arc), "visible", step=step), Stroke(arm, "visible", step=step)]
