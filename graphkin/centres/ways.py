"""The pole of a body from the velocities of two of its points: the three ways of the textbook.

Source: course notes on instant centres; Sun Huan, 机械原理, section 3-2.2; velocity projection theorem.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Sequence
from typing import Literal

from graphkin.errors import GraphkinError, Lang, Where
from graphkin.errors.centring import BadVelocities, NotOneBody, OnePlace
from graphkin.geometry import cross, dot
from graphkin.loading.units import read_quantity
from graphkin.value import frozen

__all__ = ["Case", "TwoVelocities", "from_text", "pole_of"]

Case = Literal["meet", "infinity", "similar", "point", "rest"]

WHERE = Where("--velocities")
RIGID = 1e-3
"""Components along the joining line may differ by this part of the greater velocity: figures of four digits do."""
PARALLEL = 1e-6


@frozen
class TwoVelocities:
    """A body's pole, from two points [m] and their velocities [m/s].

    case   how it is found: perpendiculars "meet"; equal and parallel velocities: at "infinity"; parallel and unequal
           ones: "similar" triangles; one "point" stands still and is the pole; both are at "rest", no pole is seen
    place  the pole [m]; infinite at infinity, NaN at rest
    omega  angular velocity [rad/s]
    """

    names: tuple[str, str]
    points: tuple[complex, complex]
    velocities: tuple[complex, complex]
    case: Case
    place: complex
    omega: float

    @property
    def direction(self) -> float | None:
        """Where the pole lies if it is at infinity [rad], in (-pi/2, pi/2]; None where it is not."""
        if self.case != "infinity":
            return None
        angle = cmath.phase(1j * self.velocities[0])
        half = cmath.pi / 2
        return angle - cmath.pi if angle > half else angle + cmath.pi if angle <= -half else angle

    def words(self, lang: Lang) -> list[str]:
        """What is drawn, and what is found, a sentence each."""
        (first, second), sense = self.names, "ccw" if self.omega > 0 else "cw"
        still, other = (first, second) if abs(self.velocities[0]) < abs(self.velocities[1]) else (second, first)
        known = {
            "a": first, "b": second, "still": still, "other": other, "x": 1e3 * self.place.real,
            "y": 1e3 * self.place.imag, "omega": abs(self.omega), "sense": SENSES[sense][lang],
            "at": (self.direction or 0.0) * 180 / cmath.pi,
        }  # fmt: skip
        along = cmath.phase(self.points[1] - self.points[0])
        component = (self.velocities[0] * cmath.rect(1, -along)).real
        component = component if abs(component) > 1e-12 * abs(self._fast[1]) else 0.0
        found = [WORDS["rigid"][lang].format(**known, component=component), WORDS[self.case][lang].format(**known)]
        if self.case in ("meet", "similar", "point"):
            found.append(WORDS["omega"][lang].format(**known, v=abs(self._fast[1]), arm=1e3 * abs(self._arm)))
        return found

    @property
    def _fast(self) -> tuple[complex, complex]:
        """The point with the greater velocity, and that."""
        return max(zip(self.points, self.velocities, strict=True), key=lambda entry: abs(entry[1]))

    @property
    def _arm(self) -> complex:
        return self._fast[0] - self.place


def pole_of(
    points: Sequence[complex], velocities: Sequence[complex], names: Sequence[str] = ("A", "B"), where: Where = WHERE
) -> TwoVelocities:
    """The pole of a rigid body from two points [m] and their velocities [m/s].

    Raises OnePlace where the points coincide, NotOneBody where the components along their line differ.
    """
    (a, b), (va, vb), (first, second) = points, velocities, names
    if abs(b - a) <= 1e-12 * max(abs(a), abs(b), 1e-9):
        raise OnePlace(where, first, second)
    along, fastest = (b - a) / abs(b - a), max(abs(va), abs(vb))
    one, other = float(dot(along, va)), float(dot(along, vb))
    if abs(one - other) > RIGID * fastest:
        raise NotOneBody(where, first, second, one, other)
    omega = float(cross(along, vb - va)) / abs(b - a)
    if abs(vb - va) <= PARALLEL * fastest:
        omega = 0.0
    place = a + 1j * va / omega if omega else complex(cmath.inf if fastest else cmath.nan)
    return TwoVelocities((first, second), (a, b), (va, vb), _case(va, vb, omega), place, omega)


def _case(va: complex, vb: complex, omega: float) -> Case:
    fastest = max(abs(va), abs(vb))
    if fastest == 0:
        return "rest"
    if omega == 0:
        return "infinity"
    if min(abs(va), abs(vb)) <= PARALLEL * fastest:
        return "point"
    return "similar" if abs(cross(va, vb)) <= PARALLEL * abs(va) * abs(vb) else "meet"


def from_text(text: str) -> TwoVelocities:
    """The pole from `A 0,0 1,0.5; B 100,0 1,-0.2`: names, places [mm] and velocities [m/s], units may be written.

    Raises BadVelocities, and what `pole_of` raises; errors of units at `--velocities`.
    """
    entries = [entry for entry in re.split("[;；]", text) if entry.strip()]
    if len(entries) != 2:
        raise BadVelocities(WHERE, text)
    (first, a, va), (second, b, vb) = (_entry(entry, text) for entry in entries)
    if first == second:
        raise BadVelocities(WHERE, text)
    return pole_of((a, b), (va, vb), (first, second))


def _entry(entry: str, text: str) -> tuple[str, complex, complex]:
    """One point: its name, place and velocity."""
    words = re.fullmatch(r"([^\W\d_][\w']*)[\s:：]+(\S+)\s*[,，]\s*(\S+)\s+(\S+)\s*[,，]\s*(\S+)", entry.strip())
    if words is None:
        raise BadVelocities(WHERE, text)
    try:
        x, y = (read_quantity(_number(word), "length") for word in words.groups()[1:3])
        across, up = (read_quantity(_number(word), "velocity") for word in words.groups()[3:])
    except GraphkinError as error:
        raise error.at(WHERE) from None
    return words[1], complex(x, y), complex(across, up)


def _number(word: str) -> float | str:
    try:
        return float(word)
    except ValueError:
        return word


SENSES: dict[str, dict[Lang, str]] = {
    "ccw": {"en": "counter-clockwise", "zh": "逆时针"},
    "cw": {"en": "clockwise", "zh": "顺时针"},
}
WORDS: dict[str, dict[Lang, str]] = {
    "rigid": {
        "en": "Along {a}{b} both velocities have the component {component:.4g} m/s: the points can belong to one "
        "rigid body.",
        "zh": "两点速度在 {a}{b} 连线上的投影相等，均为 {component:.4g} m/s，符合速度投影定理，属同一刚体。",
    },
    "meet": {
        "en": "The velocities are not parallel. The line through {a} across v_{a} and the line through {b} across "
        "v_{b} "
        "meet at the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "两速度不平行：过 {a} 作 v_{a} 的垂线，过 {b} 作 v_{b} 的垂线，两垂线的交点即为瞬心 P ({x:.4g}, "
        "{y:.4g}) mm。",
    },
    "infinity": {
        "en": "The velocities are parallel and equal. The perpendiculars are parallel: the instant centre lies at "
        "infinity, in "
        "the direction {at:.4g}°; omega = 0, the body is in translation at this instant.",
        "zh": "两速度平行且相等：两垂线互相平行，瞬心在无穷远处（方向 {at:.4g}°），ω = 0，刚体作瞬时平动。",
    },
    "similar": {
        "en": "The velocities are parallel, across {a}{b}, and unequal. By similar triangles the line through the "
        "tips of the "
        "two velocity arrows meets the line {a}{b} at the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "两速度平行（均垂直于 {a}{b}）但不相等：由相似三角形，两速度矢端的连线与 {a}{b} 连线的交点即为瞬心 "
        "P ({x:.4g}, {y:.4g}) mm。",
    },
    "point": {
        "en": "The velocity of {still} is 0: {still} itself is the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "点 {still} 的速度为零，{still} 即为瞬心 P ({x:.4g}, {y:.4g}) mm。",
    },
    "rest": {
        "en": "Both velocities are 0: the body stands still at this instant, and no instant centre is seen.",
        "zh": "两点速度均为零：刚体此刻静止，看不出瞬心。",
    },
    "omega": {
        "en": "omega = {v:.4g} m/s / {arm:.4g} mm = {omega:.4g} rad/s, {sense}.",
        "zh": "ω = {v:.4g} m/s / {arm:.4g} mm = {omega:.4g} rad/s（{sense}）。",
    },
}
