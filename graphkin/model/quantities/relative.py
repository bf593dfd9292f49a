"""The motion of one site seen from another, and its parts."""

from __future__ import annotations

from typing import Literal

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Value, dot
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import Seen, common_link
from graphkin.model.pairs import Rod, Slot

Plane = Literal["velocity", "acceleration"]


def absolute(motions: Motions, plane: Plane, site: Seen) -> Value:
    """Velocity or acceleration of a site [m/s, m/s^2]."""
    at = motions.velocity_at if plane == "velocity" else motions.acceleration_at
    return at(site.point, site.link)


def has_part(mechanism: Mechanism, part: str, of: Seen, seen_from: Seen) -> bool:
    """Whether there is such a part: n and t of points of one link, or of centres that profiles keep apart; k and r of
    coincident points."""
    if part in ("n", "t"):
        apart = (pair.equivalent for pair in mechanism.pairs)
        held = any(same is not None and not (isinstance(same, Rod) and same.follows) for same in apart)
        return held or common_link(mechanism, of, seen_from) is not None
    return part == "" or of.point == seen_from.point


def relative(motions: Motions, plane: Plane, part: str, of: Seen, seen_from: Seen) -> Value:
    """The motion of one site seen from another, or a part of it that there is: n, t, k or r.

    The Coriolis part takes the rotation of the link of `seen_from`; of a pin in a slot the slot's, either way round,
    as the pin's path is straight there and nowhere else.
    """
    whole = absolute(motions, plane, of) - absolute(motions, plane, seen_from)
    if part == "":
        return whole
    if part not in ("n", "t"):
        return _coincident(motions, part, of, seen_from, whole)
    arm = motions.position[of.point] - motions.position[seen_from.point]
    link = common_link(motions.mechanism, of, seen_from)
    if link is None:
        return _between_centres(part, arm, whole)
    return -(motions.omega[link] ** 2) * arm if part == "n" else 1j * motions.alpha[link] * arm


def _between_centres(part: str, arm: Value, whole: Value) -> Value:
    """Of two centres that profiles keep apart, as by a link: the acceleration along their line and across it."""
    along = arm * dot(arm, whole) / np.abs(arm) ** 2
    return along if part == "n" else whole - along


def _coincident(motions: Motions, part: str, of: Seen, seen_from: Seen, whole: Value) -> Value:
    slip = absolute(motions, "velocity", of) - absolute(motions, "velocity", seen_from)
    link = of.link if _slot_of_pin(motions.mechanism, of) else seen_from.link
    coriolis = 2j * motions.turning(link) * slip
    return coriolis if part == "k" else whole - coriolis


def _slot_of_pin(mechanism: Mechanism, site: Seen) -> bool:
    """Whether a site is of the link in whose slot its point is the pin; a wheel or a cam may stand for one."""
    return (site.link, site.point) in _slots(mechanism)


@kept(4)
def _slots(mechanism: Mechanism) -> frozenset[tuple[str, str]]:
    """The link of each slot, and the point of its pin."""
    slides = ((slide.line.link, slide.point) for slide in mechanism.slides if slide.block is None)
    slots = ((same.line.link, same.point) for pair in mechanism.pairs if isinstance(same := pair.equivalent, Slot))
    return frozenset((*slides, *slots))
