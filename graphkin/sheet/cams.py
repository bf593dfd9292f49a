"""Cam profiles, followers, and the lower-pair equivalent drawn over them in dashes."""

from __future__ import annotations

import math

from graphkin.mechanism import FRAME
from graphkin.pairs import Cam, Profile, Slide
from graphkin.sheet import symbols
from graphkin.sheet.marks import Disc, Mark, Shows, Stroke
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.wheels import straight
from graphkin.sheet.window import Figure

__all__ = ["cams", "equivalents", "follower"]

_REACH = 14.0
"""How far a slot of the equivalent goes to both sides of its block [mm]."""
_ROD, _BUSH = 34.0, (15.0, 27.0)
"""A follower's rod from its tip, and where it is guided [mm]."""


def cams(skeleton: Skeleton) -> Figure:
    """The profiles that touch."""
    figure = Figure()
    for number, cam in enumerate(skeleton.mechanism.cams):
        step = skeleton.step(*(p.centre for p in cam.profiles if p.centre is not None))
        others = (cam.profiles[1], cam.profiles[0])
        for link, profile, other in zip(cam.links, cam.profiles, others, strict=True):
            figure.marks += _profile(skeleton, (link, f"c{number}"), profile, other, step)
    return figure


def _profile(
    skeleton: Skeleton, of: tuple[str, str], profile: Profile, other: Profile, step: int | None
) -> list[Mark]:
    """A profile of a link in a cam pair (`of`: their names)."""
    scale = skeleton.window.scale
    if profile.centre is not None:
        radius = profile.radius / scale
        shows = Shows(of[0], "wheel", (profile.centre,))
        return [Disc(skeleton.at(profile.centre), radius, "outline", shows=shows, step=step)] if radius > 0 else []
    assert profile.line is not None
    near = other.centre or profile.line.origin
    return [straight(skeleton, profile.line, of[1], near, other.radius / scale + 8, step)]


def equivalents(skeleton: Skeleton) -> list[Mark]:
    """In dashes: the link between two centres, or the slot through a centre at a face's distance."""
    marks: list[Mark] = []
    for cam in skeleton.mechanism.cams:
        centres = [p.centre for p in cam.profiles if p.centre is not None]
        step = skeleton.step(*centres)
        if len(centres) == 2:
            edges = {p.centre for p in cam.profiles if p.radius == 0}
            marks += _joined(skeleton, centres, edges, step)
        else:
            marks += _slotted(skeleton, cam, centres[0], step)
    return marks


def _joined(skeleton: Skeleton, centres: list[str], edges: set[str | None], step: int | None) -> list[Mark]:
    start, end = (skeleton.at(p) for p in centres)
    hinges = [Disc(skeleton.at(p), symbols.HINGE, "thin", step=step) for p in centres if p not in edges]
    return [Stroke((start, end), "dashed", step=step), *hinges]


def _slotted(skeleton: Skeleton, cam: Cam, centre: str, step: int | None) -> list[Mark]:
    """The block's way is the face's line moved sideways to the centre; both belong to one link."""
    line = next(p.line for p in cam.profiles if p.line is not None)
    at, along = skeleton.at(centre), skeleton.direction(line)
    x, y = along * symbols.BLOCK.real / 2, 1j * along * symbols.BLOCK.imag / 2
    corners = (at + x + y, at + x - y, at - x - y, at - x + y)
    return [
        Stroke((at - along * _REACH, at + along * _REACH), "dashed", step=step),
        Stroke(corners, "dashed", closed=True, step=step),
        Disc(at, symbols.HINGE, "thin", step=step),
    ]


def follower(skeleton: Skeleton, slide: Slide) -> list[Mark] | None:
    """A fixed guide's block that a cam moves at its point: a rod with its tip or roller, guided above; else None."""
    if slide.guide != FRAME or slide.block is None or len(skeleton.named(slide.block)) > 1:
        return None
    for cam in skeleton.mechanism.cams:
        for profile, other in (cam.profiles, cam.profiles[::-1]):
            if profile.centre == slide.point and other.centre is not None:
                return _rod(skeleton, slide, profile.radius / skeleton.window.scale, other.centre)
    return None


def _rod(skeleton: Skeleton, slide: Slide, radius: float, cam_centre: str) -> list[Mark]:
    at, along = skeleton.at(slide.point), skeleton.along(slide)
    out = along * math.copysign(1, (along.conjugate() * (at - skeleton.at(cam_centre))).real)
    side, step = 1j * out, skeleton.step(slide.point)
    shows = Shows(slide.block or "", "guide", (), slide.name)
    near, far = (max(0.0, radius - 3) + reach for reach in _BUSH)
    foot = 2.6 if radius == 0 else 0.0
    rod = Stroke((at + out * foot, at + out * (far - _BUSH[1] + _ROD)), "visible", shows=shows, step=step)
    marks: list[Mark] = [rod]
    if radius == 0:
        tip = (at, at + out * 3.4 + side * 1.1, at + out * 3.4 - side * 1.1)
        marks.append(Stroke(tip, "outline", closed=True, fill="ink", step=step))
    for wall in (side, -side):
        marks += symbols.guide(at + out * near + wall * 1.1, at + out * far + wall * 1.1, wall, step)
    return marks
