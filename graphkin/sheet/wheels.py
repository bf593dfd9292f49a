"""Pitch circles of gears, rolling wheels and their tracks, cam profiles."""

from __future__ import annotations

from graphkin.pairs import Cam, Gear, Line, Roll
from graphkin.sheet.marks import Disc, Mark, Stroke
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure

__all__ = ["wheels"]


def wheels(skeleton: Skeleton) -> Figure:
    """Circles and lines of all higher pairs."""
    figure = Figure()
    machine = skeleton.mechanism
    for gear in machine.gears:
        figure.marks += _gear(skeleton, gear)
    for roll in machine.rolls:
        figure.marks += _roll(skeleton, roll)
    for cam in machine.cams:
        figure.marks += _cam(skeleton, cam)
    return figure


def _circle(skeleton: Skeleton, centre: str, radius: float, link: str, pitch: bool = False) -> Mark:
    return Disc(
        skeleton.at(centre), radius / skeleton.window.scale, "centre" if pitch else "outline", link=link,
        step=skeleton.step(centre),
    )  # fmt: skip


def _gear(skeleton: Skeleton, gear: Gear) -> list[Mark]:
    return [
        _circle(skeleton, centre, radius, link, pitch=True)
        for link, centre, radius in zip(gear.links, gear.centres, gear.radii, strict=True)
    ]


def _roll(skeleton: Skeleton, roll: Roll) -> list[Mark]:
    marks = [_circle(skeleton, roll.centre, roll.radius, roll.wheel)]
    if roll.track_centre is not None:
        marks.append(_circle(skeleton, roll.track_centre, roll.track_radius, roll.track))
    elif roll.line is not None:
        foot = roll.radius / skeleton.window.scale
        marks.append(_straight(skeleton, roll.line, roll.centre, foot + 12))
    return marks


def _cam(skeleton: Skeleton, cam: Cam) -> list[Mark]:
    marks: list[Mark] = []
    others = (cam.profiles[1], cam.profiles[0])
    for link, profile, other in zip(cam.links, cam.profiles, others, strict=True):
        if profile.centre is not None:
            marks.append(_circle(skeleton, profile.centre, profile.radius, link))
        elif profile.line is not None:
            near = other.centre or profile.line.origin
            marks.append(_straight(skeleton, profile.line, near, other.radius / skeleton.window.scale + 8))
    return marks


def _straight(skeleton: Skeleton, line: Line, near: str, reach: float) -> Mark:
    """A line of a link, around the foot of a point on it."""
    theta = complex(skeleton.plot.theta.get(line.link, 0.0))
    along = skeleton.window.turned(line.direction * complex(1, 0) * _turn(theta.real))
    foot = skeleton.at(line.origin)
    t = (along.conjugate() * (skeleton.at(near) - foot)).real
    return Stroke((foot + along * (t - reach), foot + along * (t + reach)), "visible", link=line.link)


def _turn(theta: float) -> complex:
    import cmath

    return cmath.rect(1, theta)
