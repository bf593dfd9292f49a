"""A mechanism with other names for its links: words, and names that points have too."""

from __future__ import annotations

import random
from dataclasses import replace

from graphkin.model.mechanism import FRAME, Driver, Link, Mechanism, Pose
from graphkin.model.pairs import Cam, CircularSlot, Gear, Line, Pair, Profile, RollingContact, Slide

WORDS = ("crank", "coupler", "rocker", "guide", "ram", "连杆", "arm_2", "b3", "x'", "slider", "disc", "s0", "r0", "kite")


def renamed(mechanism: Mechanism, seed: int) -> Mechanism:
    """Each moving link called by a word, by a point's name, or by such a name with a number after it."""
    rng = random.Random(seed)
    points = [*mechanism.points, *(f"{point}{k}" for point in mechanism.points for k in (1, 2))]
    several = [*rng.sample(WORDS, len(WORDS)), *rng.sample(points, len(points))]
    rng.shuffle(several)
    names = {FRAME: FRAME, **{link: several.pop() for link in mechanism.moving}}
    frame = rng.choice((mechanism.frame, several.pop()))
    return called(mechanism, names, frame)


def called(mechanism: Mechanism, names: dict[str, str], frame: str) -> Mechanism:
    """The same mechanism; names: new by old."""

    def line(old: Line | None) -> Line | None:
        return None if old is None else replace(old, link=names[old.link])

    def profile(old: Profile) -> Profile:
        return replace(old, line=line(old.line))

    def paired(old: Pair) -> Pair:
        match old:
            case Slide():
                return replace(old, line=line(old.line), block=old.block and names[old.block])
            case RollingContact():
                return replace(old, wheel=names[old.wheel], track=names[old.track], line=line(old.line))
            case CircularSlot():
                return replace(old, guide=names[old.guide], link=names[old.link])
            case Gear():
                return replace(old, links=tuple(names[link] for link in old.links))
            case Cam():
                links = tuple(names[link] for link in old.links)
                return replace(old, links=links, profiles=tuple(map(profile, old.profiles)))
        raise AssertionError(f"no names for {old}")

    def turned(old: Driver | Pose) -> Driver | Pose:
        link = old.link if old.kind == "slide" else names.get(old.link, old.link)
        return replace(old, link=link, from_link=names[old.from_link])

    return replace(
        mechanism,
        frame=frame,
        links={names[name]: Link(names[name], link.points) for name, link in mechanism.links.items()},
        pairs=tuple(map(paired, mechanism.pairs)),
        drivers=tuple(map(turned, mechanism.drivers)),
        poses=tuple(map(turned, mechanism.poses)),
    )
