"""The pole of a body from the velocities of two of its points: the three constructions of the textbook.

Source: course notes on instant centres; Sun Huan, 机械原理, section 3-2.2; velocity projection theorem.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Sequence
from typing import Literal

from graphkin.base.geometry import cross, dot, number
from graphkin.base.value import frozen
from graphkin.errors import Where
from graphkin.errors.studies import BadVelocities, NotOneBody, OnePlace
from graphkin.files.values import quantity_at

Case = Literal["meet", "infinity", "similar", "point", "rest"]

WHERE = Where("--velocities")
RIGID = 1e-3
"""Components along the joining line may differ by this part of the greater velocity: figures of four digits do."""
PARALLEL = 1e-6


@frozen
class TwoVelocities:
    """A body's pole, from two points [m] and their velocities [m/s].

    case   of the construction: perpendiculars "meet"; velocities equal and parallel: at "infinity"; parallel and
           unequal: "similar" triangles; one "point" stands still and is the pole; both are at "rest", no pole is seen
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
        """Direction of a pole at infinity [rad], in (-pi/2, pi/2]; None where it is not."""
        if self.case != "infinity":
            return None
        angle = cmath.phase(1j * self.velocities[0])
        half = cmath.pi / 2
        return angle - cmath.pi if angle > half else angle + cmath.pi if angle <= -half else angle

    @property
    def fastest(self) -> tuple[complex, complex]:
        """The point with the greater velocity, and that."""
        return max(zip(self.points, self.velocities, strict=True), key=lambda entry: abs(entry[1]))

    @property
    def arm(self) -> complex:
        """From the pole to that point [m]."""
        return self.fastest[0] - self.place


def pole_of(
    points: Sequence[complex], velocities: Sequence[complex], names: Sequence[str] = ("A", "B")
) -> TwoVelocities:
    """The pole of a rigid body from two points [m] and their velocities [m/s].

    Raises OnePlace where the points coincide, NotOneBody where the components along their line differ.
    """
    (a, b), (va, vb), (first, second) = points, velocities, names
    if abs(b - a) <= 1e-12 * max(abs(a), abs(b), 1e-9):
        raise OnePlace(WHERE, first, second)
    along, fastest = (b - a) / abs(b - a), max(abs(va), abs(vb))
    one, other = number(dot(along, va)), number(dot(along, vb))
    if abs(one - other) > RIGID * fastest:
        raise NotOneBody(WHERE, first, second, one, other)
    omega = number(cross(along, vb - va)) / abs(b - a)
    if abs(vb - va) <= PARALLEL * fastest:
        omega = 0.0
    place = a + 1j * va / omega if omega else complex(cmath.inf if fastest else cmath.nan)
    case: Case = "meet"
    if fastest == 0:
        case = "rest"
    elif omega == 0:
        case = "infinity"
    elif min(abs(va), abs(vb)) <= PARALLEL * fastest:
        case = "point"
    elif abs(number(cross(va, vb))) <= PARALLEL * abs(va) * abs(vb):
        case = "similar"
    return TwoVelocities((first, second), (a, b), (va, vb), case, place, omega)


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
    x, y = (quantity_at(WHERE, "length", word) for word in words.groups()[1:3])
    across, up = (quantity_at(WHERE, "velocity", word) for word in words.groups()[3:])
    return words[1], complex(x, y), complex(across, up)
