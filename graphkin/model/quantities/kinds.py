"""The kinds of quantities: each says its unit, its letters, its sign rule, and its value in any motions."""

from __future__ import annotations

from typing import Literal, TypeAlias, cast

import numpy as np

from graphkin.base.cache import kept
from graphkin.base.geometry import Real, Value, dot
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import Mechanism
from graphkin.model.naming import Seen, common_link
from graphkin.model.pairs import Rod, Slot

Axis = Literal["x", "y"]

_TURNING = {"theta": ("rad", "θ"), "omega": ("rad/s", "ω"), "alpha": ("rad/s^2", "α")}
_MOVING = {"v": "m/s", "a": "m/s^2"}


@frozen
class Answer:
    """The answer to a question: a scalar with its unit, and the vector it is the length of."""

    value: Value
    unit: str
    vector: Value | None = None


@frozen
class QuantityBase:
    """The base of all quantities: each can be asked of any motions.

    word, of   as they are written: `a_k` and `B3B2`
    """

    word: str
    of: str

    is_place = False  # true of a place, which is given by two numbers

    @property
    def text(self) -> str:
        """As it is read again."""
        return f"{self.word} {self.of}"

    @property
    def unit(self) -> str:
        """In SI: "rad", "rad/s", "rad/s^2", "m", "m/s", "m/s^2", "1"."""
        raise NotImplementedError

    @property
    def letter(self) -> str:
        """As the field writes it: θ, s, v, .."""
        return self.word

    @property
    def part(self) -> str:
        """The letter above the subscript: k of `a_k B3B2`, x of `v_x E`."""
        return ""

    @property
    def halves(self) -> tuple[Quantity, ...]:
        """The two of a quotient, else itself."""
        return (cast("Quantity", self),)

    @property
    def sites(self) -> tuple[Seen, ...]:
        """The point, or the point and the one it is seen from."""
        return ()

    @property
    def along(self) -> complex | None:
        """The direction along which it counts as positive, where the size of a vector has a sign."""
        return None

    def answer(self, motions: Motions) -> Answer:
        """Its value there; a scalar or an array over positions."""
        raise NotImplementedError

    def shown(self, motions: Motions) -> Answer:
        """The same without rounding noise, for people and files: 0 is 0."""
        answer, cut = self.answer(motions), motions.mechanism.usual.cut
        if answer.vector is None:
            return Answer(cut(answer.value, answer.unit), answer.unit)
        vector = cut(answer.vector, answer.unit)
        return Answer(np.abs(vector), answer.unit, vector)


@frozen
class Rotation(QuantityBase):
    """`theta 3`, `omega 3`, `alpha 3`."""

    link: str

    @property
    def unit(self) -> str:
        return _TURNING[self.word][0]

    @property
    def letter(self) -> str:
        return _TURNING[self.word][1]

    def answer(self, motions: Motions) -> Answer:
        return Answer(getattr(motions, self.word)[self.link], self.unit)


@frozen
class Displacement(QuantityBase):
    """`s ram`: of a sliding pair, or of the centre of a wheel that rolls on a line."""

    slide: str

    unit = "m"

    def answer(self, motions: Motions) -> Answer:
        return Answer(motions.s[self.slide], "m")


@frozen
class Place(QuantityBase):
    """`x E`, `y E`: where a point is, in the frame's axes."""

    axis: Axis
    site: Seen

    unit = "m"

    @property
    def sites(self) -> tuple[Seen, ...]:
        return (self.site,)

    def answer(self, motions: Motions) -> Answer:
        return Answer(on_axis(motions.position[self.site.point], self.axis), "m")


@frozen
class Track(QuantityBase):
    """`path E`: where a point is, in the frame's axes; over a motion, its path."""

    site: Seen

    unit, letter, is_place = "m", "r", True

    @property
    def sites(self) -> tuple[Seen, ...]:
        return (self.site,)

    def answer(self, motions: Motions) -> Answer:
        place = motions.position[self.site.point]
        return Answer(np.abs(place), "m", place)


@frozen
class Moving(QuantityBase):
    """`v E`, `a CB`, `a_k B3B2`: a vector; of a point, or of one seen from another, or a part of that.

    seen_from  the other point
    part       n, t, k or r
    along      the direction of the frame's guide that leads the point: along it the size has a sign
    """

    site: Seen
    seen_from: Seen | None = None
    part: str = ""
    along: complex | None = None

    @property
    def unit(self) -> str:
        return _MOVING[self.letter]

    @property
    def letter(self) -> str:
        return self.word[0]

    @property
    def sites(self) -> tuple[Seen, ...]:
        return (self.site,) if self.seen_from is None else (self.site, self.seen_from)

    def answer(self, motions: Motions) -> Answer:
        vector = self.vector(motions)
        return Answer(np.abs(vector), self.unit, vector)

    def vector(self, motions: Motions) -> Value:
        plane: Plane = "velocity" if self.letter == "v" else "acceleration"
        if self.seen_from is None:
            return absolute(motions, plane, self.site)
        return relative(motions, plane, self.part, self.site, self.seen_from)


@frozen
class Component(QuantityBase):
    """`v_x E`, `a_y CB`: of a vector along one of the frame's axes."""

    axis: Axis
    whole: Moving

    @property
    def unit(self) -> str:
        return self.whole.unit

    @property
    def letter(self) -> str:
        return self.whole.letter

    @property
    def part(self) -> str:
        return self.axis

    @property
    def sites(self) -> tuple[Seen, ...]:
        return self.whole.sites

    def answer(self, motions: Motions) -> Answer:
        return Answer(on_axis(self.whole.vector(motions), self.axis), self.unit)


@frozen
class Centre(QuantityBase):
    """`P13`: where the instant centre of two links is; at infinity that is infinite."""

    links: tuple[str, str]

    @property
    def text(self) -> str:
        return self.word + self.of

    unit, is_place = "m", True

    def answer(self, motions: Motions) -> Answer:
        place = self.place(motions)
        return Answer(np.abs(place), "m", place)

    def place(self, motions: Motions) -> Value:
        """The place at which both links have one velocity [m]."""
        point = motions.mechanism.points[0]
        one, other = (motions.velocity_at(point, link) for link in self.links)
        turning = motions.turning(self.links[0]) - motions.turning(self.links[1])
        fastest = max(float(np.max(np.abs(motions.omega[link]))) for link in motions.mechanism.moving)
        with np.errstate(divide="ignore", invalid="ignore"):
            place = motions.position[point] + np.divide(1j * (one - other), turning)
        return np.where(np.abs(turning) > STILL * fastest, place, np.inf)


@frozen
class Quotient(QuantityBase):
    """`omega 3/omega 1`: of two quantities of one unit; `word` and `of` are their texts."""

    top: Quantity
    bottom: Quantity

    @property
    def text(self) -> str:
        return f"{self.word}/{self.of}"

    unit = "1"

    @property
    def halves(self) -> tuple[Quantity, ...]:
        return self.top, self.bottom

    def answer(self, motions: Motions) -> Answer:
        """The top by the bottom; a bottom that is 0 but for rounding counts as 0."""
        top, bottom = (half.answer(motions).value for half in self.halves)
        sizes = [float(np.max(np.abs(value), initial=0.0, where=np.isfinite(value))) for value in (top, bottom)]
        with np.errstate(divide="ignore", invalid="ignore"):
            quotient: Value = np.divide(top, np.where(np.abs(bottom) <= 1e-12 * max(sizes), 0.0, bottom))[()]
        return Answer(quotient, "1")


Quantity: TypeAlias = Rotation | Displacement | Place | Track | Moving | Component | Centre | Quotient
"""All quantities; whoever reads its kinds one by one ends in `assert_never`, so that the type checker lists them."""


def on_axis(vector: Value, axis: Axis) -> Real:
    """The component of a vector along one of the frame's axes."""
    return vector.real if axis == "x" else vector.imag


def absolute(motions: Motions, plane: Plane, site: Seen) -> Value:
    """Velocity or acceleration of a site [m/s, m/s^2]."""
    motion_at = motions.velocity_at if plane == "velocity" else motions.acceleration_at
    return motion_at(site.point, site.link)


def has_part(mechanism: Mechanism, part: str, of: Seen, seen_from: Seen) -> bool:
    """True of a part that there is: n and t of points of one link, or of centres that profiles keep apart; k and r of
    coincident points."""
    if part in ("n", "t"):
        apart = (pair.equivalent for pair in mechanism.pairs)
        held = any(same is not None and not (isinstance(same, Rod) and same.follows) for same in apart)
        return held or common_link(mechanism, of, seen_from) is not None
    return part == "" or of.point == seen_from.point


def relative(motions: Motions, plane: Plane, part: str, of: Seen, seen_from: Seen) -> Value:
    """The motion of one site seen from another, or a part of it that there is: n, t, k or r."""
    whole = absolute(motions, plane, of) - absolute(motions, plane, seen_from)
    if part == "":
        return whole
    if part in ("k", "r"):
        slip = absolute(motions, "velocity", of) - absolute(motions, "velocity", seen_from)
        coriolis = 2j * motions.turning(turning_link(motions.mechanism, of, seen_from)) * slip
        return coriolis if part == "k" else whole - coriolis
    arm = motions.position[of.point] - motions.position[seen_from.point]
    link = common_link(motions.mechanism, of, seen_from)
    if link is None:  # centres that profiles keep apart, as by a link: along their line and across it
        along = arm * dot(arm, whole) / np.abs(arm) ** 2
        return along if part == "n" else whole - along
    return -(motions.omega[link] ** 2) * arm if part == "n" else 1j * motions.alpha[link] * arm


def turning_link(mechanism: Mechanism, of: Seen, seen_from: Seen) -> str:
    """The link whose rotation the Coriolis part takes: that of `seen_from`; but where a point of that link has a
    straight path in the other, as the pin of a slot or of a block has, the other."""
    carried = seen_from.link in mechanism.owners.get(of.point, ())
    return of.link if carried and (of.link, of.point) in _straight(mechanism) else seen_from.link


@kept(4)
def _straight(mechanism: Mechanism) -> frozenset[tuple[str, str]]:
    """Each link with the points whose path in it is straight: those of a block in its guide and of the guide in the
    block, a pin in its slot; a wheel or a cam may stand for one."""
    blocks = [(slide.guide, slide.block) for slide in mechanism.slides if slide.block is not None]
    either_way = (way for pair in blocks for way in (pair, pair[::-1]))
    points = ((link, point) for link, other in either_way for point in mechanism.links[other].points)
    slots = ((same.line.link, same.point) for pair in mechanism.pairs if isinstance(same := pair.equivalent, Slot))
    return frozenset((*points, *slots, *((slide.guide, slide.point) for slide in mechanism.slides)))
