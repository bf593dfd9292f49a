"""Pitch circles of gears, rolling wheels and their tracks, cam profiles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.mechanism import FRAME, Mechanism
from graphkin.pairs import Cam, Gear, Line, Roll
from graphkin.sheet.marks import Disc, Mark, Stroke
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.symbols import hatch
from graphkin.sheet.window import Figure

__all__ = ["rims", "wheels"]


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
        track = _straight(skeleton, roll.line, roll.centre, roll.radius / skeleton.window.scale + 12)
        marks.append(track)
        if roll.line.link == FRAME:
            under = (1j if roll.left else -1j) * skeleton.direction(roll.line)
            marks += hatch(track.places[0], track.places[1], under)
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


def _straight(skeleton: Skeleton, line: Line, near: str, reach: float) -> Stroke:
    """A line of a link, around the foot of a point on it."""
    along, foot = skeleton.direction(line), skeleton.at(line.origin)
    t = (along.conjugate() * (skeleton.at(near) - foot)).real
    return Stroke((foot + along * (t - reach), foot + along * (t + reach)), "visible", link=line.link)


def rims(machine: Mechanism, position: Mapping[str, complex]) -> Iterator[complex]:
    """Corners of the squares around all circles, in the mechanism's plane [m]: how far they reach."""
    circles = [(c, r) for gear in machine.gears for c, r in zip(gear.centres, gear.radii, strict=True)]
    circles += [(roll.centre, roll.radius) for roll in machine.rolls]
    circles += [(roll.track_centre, roll.track_radius) for roll in machine.rolls if roll.track_centre is not None]
    profiles = (profile for cam in machine.cams for profile in cam.profiles)
    circles += [(profile.centre, profile.radius) for profile in profiles if profile.centre is not None]
    for centre, radius in circles:
        at = complex(position[centre])
        yield from (at - complex(radius, radius), at + complex(radius, radius))
