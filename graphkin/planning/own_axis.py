"""A link of one point whose own axis is the way it slides, and that is to be pushed along that very axis.

Two such slides in a row extend a telescope; where something else than a driver is to move the link, they say the same
twice, and the drawing is dead in every position: a yoke whose slot was to lie across its guide, a follower's flat face.
"""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.errors import AlongOwnAxis
from graphkin.model.mechanism import Mechanism


def along_own_axis(mechanism: Mechanism, links: Sequence[str], angle_deg: float) -> AlongOwnAxis | None:
    """The error that says so of one of these links; None where it is another dead point."""
    called = tuple(mechanism.called(link) for link in links)
    for link in links:
        points = [point for point in mechanism.links[link].points if point in mechanism.points]
        own = next((k for k, slide in enumerate(mechanism.slides) if slide.block == link), None)
        along = any(slide.guide == link and slide.line.on_axis for slide in mechanism.slides)
        if len(points) == 1 and own is not None and along:
            where = mechanism.where("links", link)
            return AlongOwnAxis(where, called, angle_deg, link, points[0], f"slide.{own}")
    return None

