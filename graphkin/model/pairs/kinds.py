"""The kinds of kinematic pair. Lengths are in metres, angles in radians; what a kind has not, `Pair` says."""

from __future__ import annotations

from typing import ClassVar

from graphkin.base.geometry import phase
from graphkin.base.value import frozen
from graphkin.model.pairs.pair import Circle, Line, Pair, Rod, Rolling, Slot, centre_distance


@frozen
class Revolute(Pair):
    """A hinge: `links` (the frame may be one) all turn about `point`; three or more make a multiple hinge."""

    table: ClassVar[str] = ""

    point: str
    links: tuple[str, ...]

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def lower(self) -> bool:
        return True



@frozen
class Slide(Pair):
    """One `[[slide]]` with a line: a sliding (prismatic) pair, or a pin in a slot. A block does not turn against its
    guide; displacement s is measured along the line from its origin to the point.

    name    as the file gives it, else `s0`, `s1`, .. by the order of the slides in the file
    named   whether the file gave the name
    line    the path, fixed in the guide `line.link`
    point   the point that stays on the line
    block   the link that slides without turning; None for a pin in a slot
    tilt    angle from the line to the block's axis (its first two points) [rad]; 0 for one point
    stands_for  the pair that it replaces, in a lower-pair equivalent
    """

    table: ClassVar[str] = "slide"

    name: str
    named: bool
    line: Line
    point: str
    block: str | None
    tilt: float
    stands_for: Pair | None = None

    @property
    def guide(self) -> str:
        return self.line.link

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.guide,) if self.block is None else (self.guide, self.block)

    @property
    def given(self) -> str:
        return self.name if self.named else ""

    @property
    def known_by(self) -> tuple[str, str]:
        return "guide", self.point

    @property
    def pin(self) -> str:
        return self.point if self.block is None else ""

    @property
    def lower(self) -> bool:
        return self.block is not None

    @property
    def path(self) -> Slot:
        return Slot(self.line, self.point)

    @property
    def slipping(self) -> Slot | None:
        return None if self.lower else self.path

    @property
    def lines(self) -> tuple[Line, ...]:
        return (self.line,)

    @property
    def turn(self) -> float:
        """Angle from the guide's axis to the block's axis, fixed while the block slides [rad]."""
        return phase(self.line.direction) + self.tilt



@frozen
class CircularSlot(Pair):
    """One `[[slide]]` with a circle: a pin, `point` of `link`, at `radius` [m] from `centre`, a point of the guide."""

    table: ClassVar[str] = "slide"

    name: str
    guide: str
    centre: str
    radius: float
    link: str
    point: str

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.guide, self.link)

    @property
    def known_by(self) -> tuple[str, str]:
        return "circular slot", self.point

    @property
    def pin(self) -> str:
        return self.point

    @property
    def equivalent(self) -> Rod:
        """A bar from the slot's centre to the pin, for the whole motion."""
        return Rod((self.guide, self.link), (self.centre, self.point), self.radius)



@frozen
class Gear(Pair):
    """One `[[gear]]`: two links whose pitch circles roll on each other, their centres and radii [m]; `internal` if one
    rim encloses the other. Other links keep the distance of the centres."""

    table: ClassVar[str] = "gear"

    name: str
    links: tuple[str, str]
    centres: tuple[str, str]
    radii: tuple[float, float]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def equivalent(self) -> Rod:
        """The line of centres; other links keep their distance."""
        return Rod(self.links, self.centres, centre_distance(self.radii, self.internal), carried=True, follows=True)

    @property
    def rolling(self) -> Rolling:
        return Rolling(self.links, self.centres, self.radii, self.internal)

    @property
    def circles(self) -> tuple[Circle, ...]:
        return tuple(zip(self.links, self.centres, self.radii, strict=True))



@frozen
class RollingContact(Pair):
    """One `[[roll]]`: a wheel rolls without slip on a line or a circle of another link and stays in contact.

    line                            the track, for a wheel on a line (`left`: its centre lies left of it), else None
    track, track_centre, track_radius  the circle rolled on, for a wheel on a circle (`internal`: inside it)
    """

    table: ClassVar[str] = "roll"

    name: str
    named: bool
    wheel: str
    centre: str
    radius: float
    track: str
    line: Line | None
    left: bool
    track_centre: str | None
    track_radius: float
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return (self.track, self.wheel)

    @property
    def given(self) -> str:
        return self.name if self.named else ""

    @property
    def lower(self) -> bool:
        return True

    @property
    def equivalent(self) -> Rod | Slot:
        """The wheel's centre stays beside a line, or at one distance from a circle's centre."""
        if (path := self.path) is not None:
            return path
        assert self.track_centre is not None
        length = centre_distance((self.track_radius, self.radius), self.internal)
        return Rod((self.track, self.wheel), (self.track_centre, self.centre), length, carried=True)

    @property
    def rolling(self) -> Rolling:
        centres, radii = (self.track_centre or "", self.centre), (self.track_radius, self.radius)
        return Rolling((self.track, self.wheel), centres, radii, self.internal, self.line, self.left)

    @property
    def path(self) -> Slot | None:
        """On a line, the slot in which the wheel's centre moves."""
        return None if self.line is None else Slot(self.line, self.centre, self.radius if self.left else -self.radius)

    @property
    def circles(self) -> tuple[Circle, ...]:
        rim = ((self.track, self.track_centre, self.track_radius),) if self.track_centre is not None else ()
        return (*rim, (self.wheel, self.centre, self.radius))

    @property
    def lines(self) -> tuple[Line, ...]:
        return () if self.line is None else (self.line,)



@frozen
class Profile:
    """A circle about `centre` with `radius` [m], or a `line` (`left`: the other profile lies left of it)."""

    centre: str | None
    radius: float
    line: Line | None
    left: bool


@frozen
class Cam(Pair):
    """One `[[cam]]`: two links whose profiles touch and slide; circles touch outside unless `internal`."""

    table: ClassVar[str] = "cam"

    name: str
    links: tuple[str, str]
    profiles: tuple[Profile, Profile]
    internal: bool

    @property
    def joins(self) -> tuple[str, ...]:
        return self.links

    @property
    def equivalent(self) -> Rod | Slot:
        """Two circles keep the distance of their centres, a circle's centre its distance from a line. Profiles are
        circles and straight lines, so this holds for the whole motion. Source: Sun Huan, Theory of Machines, section
        2-6 (replacement of higher pairs)."""
        (_, centre, radius), *others = self.circles
        for face in self.profiles:
            if face.line is not None:
                return Slot(face.line, centre, radius if face.left else -radius)
        ((_, other, more),) = others
        return Rod(self.links, (centre, other), centre_distance((radius, more), self.internal))

    @property
    def circles(self) -> tuple[Circle, ...]:
        both = zip(self.links, self.profiles, strict=True)
        return tuple((link, each.centre, each.radius) for link, each in both if each.centre is not None)

    @property
    def lines(self) -> tuple[Line, ...]:
        return tuple(profile.line for profile in self.profiles if profile.line is not None)
