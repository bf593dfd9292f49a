"""Cam profiles, followers, and the lower-pair equivalent drawn over them in dashes."""

from __future__ import annotations

import math

from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam, Line, Profile, Rod, Slide, Slot
from graphkin.sheet import symbols
from graphkin.sheet.marks import Disc, Mark, Shows, Stroke
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.wheels import straight

_REACH = 14.0
"""How far a slot of the equivalent goes to both sides of its block [mm]."""
_ROD, _BUSH = 34.0, (15.0, 27.0)
"""A follower's rod from its tip, and where it is guided [mm]."""


def profiles(skeleton: Skeleton, cam: Cam) -> list[Mark]:
    """The profiles that touch."""
    step, marks = skeleton.step(*(centre for _, centre, _ in cam.circles)), list[Mark]()
    for link, profile, other in zip(cam.links, cam.profiles, cam.profiles[::-1], strict=True):
        marks += _profile(skeleton, (link, cam.name), profile, other, step)
    return marks


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
    for pair in skeleton.mechanism.pairs:
        match pair.equivalent:
            case Rod(_, centres) if pair.rolling is None:
                edges = {centre for _, centre, radius in pair.circles if radius == 0}
                marks += _joined(skeleton, centres, edges, skeleton.step(*centres))
            case Slot(line, centre) if pair.rolling is None:
                marks += _slotted(skeleton, line, centre, skeleton.step(centre))
    return marks


def _joined(skeleton: Skeleton, centres: tuple[str, str], edges: set[str], step: int | None) -> list[Mark]:
    start, end = (skeleton.at(p) for p in centres)
    hinges = [Disc(skeleton.at(p), symbols.HINGE, "thin", step=step) for p in centres if p not in edges]
    return [Stroke((start, end), "dashed", step=step), *hinges]


def _slotted(skeleton: Skeleton, line: Line, centre: str, step: int | None) -> list[Mark]:
    """The block's way is the face's line moved sideways to the centre; both belong to one link."""
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
    for cam in skeleton.mechanism.of(Cam):
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
