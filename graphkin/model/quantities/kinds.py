"""The kinds of quantities: each says its unit, its letters, its sign rule, and what it is in any motions."""

from __future__ import annotations

from typing import Literal, TypeAlias, cast

import numpy as np

from graphkin.base.geometry import Value
from graphkin.base.tolerances import STILL
from graphkin.base.value import frozen
from graphkin.model.kinematic_state import Motions
from graphkin.model.naming import Seen
from graphkin.model.quantities.relative import absolute, relative

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
        """What stands above the subscript: k of `a_k B3B2`, x of `v_x E`."""
        return ""

    @property
    def is_place(self) -> bool:
        """Whether it is where something lies, by two numbers and none."""
        return False

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
        """What it is there; every value a scalar or an array over positions."""
        raise NotImplementedError

    def shown(self, motions: Motions) -> Answer:
        """The same without rounding noise, for people and files: 0 is 0."""
        found, cut = self.answer(motions), motions.mechanism.usual.cut
        vector = None if found.vector is None else cut(found.vector, found.unit)
        return Answer(cut(found.value, found.unit) if vector is None else np.abs(vector), found.unit, vector)


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

    @property
    def unit(self) -> str:
        return "m"

    def answer(self, motions: Motions) -> Answer:
        return Answer(motions.s[self.slide], "m")


@frozen
class Place(QuantityBase):
    """`x E`, `y E`: where a point is, in the frame's axes."""

    axis: Axis
    site: Seen

    @property
    def unit(self) -> str:
        return "m"

    @property
    def sites(self) -> tuple[Seen, ...]:
        return (self.site,)

    def answer(self, motions: Motions) -> Answer:
        return Answer(on_axis(motions.position[self.site.point], self.axis), "m")


@frozen
class Track(QuantityBase):
    """`path E`: where a point is, in the frame's axes; over a motion, its path."""

    site: Seen

    @property
    def unit(self) -> str:
        return "m"

    @property
    def letter(self) -> str:
        return "r"

    @property
    def is_place(self) -> bool:
        return True

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
    which      the part: n, t, k or r
    guide      the direction of the frame's guide that leads the point: along it the size has a sign
    """

    site: Seen
    seen_from: Seen | None = None
    which: str = ""
    guide: complex | None = None

    @property
    def unit(self) -> str:
        return _MOVING[self.letter]

    @property
    def letter(self) -> str:
        return self.word[0]

    @property
    def part(self) -> str:
        return self.which

    @property
    def sites(self) -> tuple[Seen, ...]:
        return (self.site,) if self.seen_from is None else (self.site, self.seen_from)

    @property
    def along(self) -> complex | None:
        return self.guide

    def answer(self, motions: Motions) -> Answer:
        vector = self.vector(motions)
        return Answer(np.abs(vector), self.unit, vector)

    def vector(self, motions: Motions) -> Value:
        plane: Literal["velocity", "acceleration"] = "velocity" if self.letter == "v" else "acceleration"
        if self.seen_from is None:
            return absolute(motions, plane, self.site)
        return relative(motions, plane, self.which, self.site, self.seen_from)


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

    @property
    def unit(self) -> str:
        return "m"

    @property
    def is_place(self) -> bool:
        return True

    def answer(self, motions: Motions) -> Answer:
        place = self.place(motions)
        return Answer(np.abs(place), "m", place)

    def place(self, motions: Motions) -> Value:
        """Where both links have one velocity [m]."""
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

    @property
    def unit(self) -> str:
        return "1"

    @property
    def halves(self) -> tuple[Quantity, ...]:
        return self.top, self.bottom

    def answer(self, motions: Motions) -> Answer:
        return Answer(_divided(*(half.answer(motions).value for half in self.halves)), "1")


Quantity: TypeAlias = Rotation | Displacement | Place | Track | Moving | Component | Centre | Quotient
"""All quantities; whoever reads its kinds one by one ends in `assert_never`, so that the type checker lists them."""


def on_axis(vector: Value, axis: Axis) -> Value:
    return np.real(vector) if axis == "x" else np.imag(vector)


def _divided(top: Value, bottom: Value) -> Value:
    """top / bottom; a bottom that is 0 but for rounding counts as 0."""
    sizes = [float(np.max(np.abs(value), initial=0.0, where=np.isfinite(value))) for value in (top, bottom)]
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.divide(top, np.where(np.abs(bottom) <= 1e-12 * max(sizes), 0.0, bottom))[()]
