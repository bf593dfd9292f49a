"""Students who draw polygons by rules of their own: no part of graphkin is used.

A student is a `Paper`: each operation of the drawing (a known arrow, two direction lines that cross, a rotation that
is read) has a name, errs as a pencil does, and can be done wrongly. Run once without errors it lists the mistakes that
can be made in it. Units are SI; planes are told apart by "s", "v" and "a".
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

Spot = tuple[str, str]
Edits = Mapping[Spot, tuple[str, object]]
TURN = {"rad/s": 1.0, "rpm": math.pi / 30}


@dataclass(frozen=True)
class Wrong:
    """A mistake at one place: the spots that are done otherwise, and what is written otherwise at the end."""

    id: str
    of: str
    edits: Edits = field(default_factory=dict)
    written: Callable[[dict[str, float]], dict[str, float]] | None = None

    @property
    def places(self) -> frozenset[Spot]:
        return frozenset(self.edits) or frozenset({("written", self.id)})


def unit(z: complex) -> complex:
    return z / abs(z) if z else 0j


def cross(a: complex, b: complex) -> float:
    return (a.conjugate() * b).imag


class Paper:
    """One student at work. edits: what is done wrongly, by spot; slips: factors of values by their text."""

    def __init__(
        self, scales: Mapping[str, float], edits: Edits | None = None, slips: Mapping[str, float] | None = None,
        rng: random.Random | None = None, pencil: tuple[float, float] = (0.3, 0.3),
    ) -> None:  # fmt: skip
        self.mm = {"s": scales["length"], "v": scales["velocity"], "a": scales["acceleration"]}
        self.edits, self.slips, self.rng, self.pencil = edits or {}, slips or {}, rng, pencil
        self.values: dict[str, float] = {}
        self.can: list[Wrong] = []
        self.unsure: set[str] = set()  # quantities whose sense the mistake leaves open

    # --- the pencil ---------------------------------------------------------------------------

    def err(self, plane: str) -> float:
        return self.rng.gauss(0, self.pencil[0] * self.mm[plane]) if self.rng else 0.0

    def turn(self) -> complex:
        return cmath.exp(1j * math.radians(self.rng.gauss(0, self.pencil[1]))) if self.rng else 1 + 0j

    def tag(self, op: str, name: str) -> tuple[str, object]:
        return self.edits.get((op, name), ("", None))

    def may(self, id: str, form: str, op: str, name: str, tag: str, arg: object = None) -> None:
        self.can.append(Wrong(id, f"{name} {form}".strip(), {(op, name): (tag, arg)}))

    def value(self, text: str, x: float) -> float:
        """A number the student writes down and goes on with."""
        x *= self.slips.get(text, 1.0)
        self.values[text] = x
        return x

    def size(self, text: str, plane: str, vector: complex) -> float:
        return self.value(text, abs(abs(vector) + self.err(plane)))

    # --- the mechanism on paper ---------------------------------------------------------------

    def pin(self, pivot: complex, length: float, degrees: float) -> complex:
        return pivot + (length + self.err("s")) * cmath.exp(1j * math.radians(degrees)) * self.turn()

    def arcs(self, p: complex, r: float, q: complex, s: float, near: complex) -> complex:
        r, s = r + self.err("s"), s + self.err("s")
        d = abs(q - p)
        x = (d * d + r * r - s * s) / (2 * d)
        y = math.sqrt(max(r * r - x * x, 0.0))
        return min((p + unit(q - p) * complex(x, side * y) for side in (1, -1)), key=lambda z: abs(z - near))

    def arc_line(self, p: complex, r: float, q: complex, along: complex, near: complex) -> complex:
        r, along = r + self.err("s"), unit(along)
        foot = q + along * ((p - q) * along.conjugate()).real
        h = math.sqrt(max(r * r - abs(p - foot) ** 2, 0.0))
        return min((foot + side * h * along for side in (1, -1)), key=lambda z: abs(z - near))

    def corner(self, plane: str, name: str, p: complex, q: complex, ratio: complex) -> complex:
        """The third corner of a link or of its image: p + (q - p) ratio."""
        if plane != "s":
            tag, _ = self.tag("image" + plane, name)
            if tag == "mirrored":
                ratio = ratio.conjugate()
            elif tag == "swapped":
                p, q = q, p
            if abs(ratio.imag) > 1e-6:
                for tag in ("mirrored", "swapped"):
                    self.may("image-mirrored", f"{tag} {plane}", "image" + plane, name, tag)
                    if plane == "a":
                        both = {("imagev", name): (tag, None), ("imagea", name): (tag, None)}
                        self.can.append(Wrong("image-mirrored", f"{name} {tag} v, a", both))
        return p + (q - p) * ratio + complex(self.err(plane), self.err(plane))

    # --- what is given ------------------------------------------------------------------------

    def rate(self, name: str, omega: float, given: str = "rad/s", of_many: bool = False) -> float:
        self.may("driver-reversed-one" if of_many else "driver-reversed", "", "rate", name, "times", -1.0)
        if given == "rpm":
            for form, factor in (("rpm as rad/s", 30 / math.pi), ("2 pi n", 60.0), ("n/60", 1 / (2 * math.pi))):
                self.may("conversion", f"given {form}", "rate", name, "times", factor)
        tag, factor = self.tag("rate", name)
        return omega * factor if tag else omega

    def alpha_given(self, name: str, alpha: float) -> float:
        if alpha:
            self.may("driver-acceleration-dropped", "", "alpha given", name, "times", 0.0)
            self.may("driver-acceleration-reversed", "", "alpha given", name, "times", -1.0)
        tag, factor = self.tag("alpha given", name)
        return alpha * factor if tag else alpha

    def half(self, id: str, op: str, name: str) -> None:
        """A length twice or half as long at this place."""
        for form, factor in (("twice", 2.0), ("half", 0.5)):
            self.may(id, form, op, name, "length", factor)

    # --- known arrows -------------------------------------------------------------------------

    def crank(self, name: str, omega: float, arm: complex, length: float, of_crank: bool = True) -> complex:
        """The velocity of a crank's pin, or of a rim seen from the wheel's centre."""
        if of_crank:
            self.may("driver-along-crank", "", "crank", name, "along")
        self.half("diameter-for-radius", "crank", name)
        tag, arg = self.tag("crank", name)
        if tag == "length":
            length *= arg
        return abs(omega) * length * unit(arm) if tag == "along" else 1j * omega * length * unit(arm)

    def normal(
        self, name: str, omega: float, arm: complex, length: float, sizes: Mapping[str, float] | None = None,
        driven: bool = False,
    ) -> complex:  # fmt: skip
        """a^n of the end of an arm seen from its beginning; sizes: what may be taken for omega^2 l."""
        for id, tag in (("normal-omitted", "omitted"), ("normal-outward", "outward"), ("normal-not-laid-off", "kept")):
            self.may(id, "", "normal", name, tag)
        self.may("normal-doubled", "", "normal", name, "length", 2.0)
        self.may("diameter-for-radius", "half", "normal", name, "length", 0.5)
        for form, size in {"omega l": abs(omega) * length, "omega^2": omega**2, **(sizes or {})}.items():
            self.may("normal-size", form, "normal", name, "form", form)
            if self.tag("normal", name) == ("form", form):
                length, omega = size, 1.0
        if driven:
            self.may("tangential-along", "crank", "normal", name, "across")
        tag, arg = self.tag("normal", name)
        length *= arg if tag == "length" else 0.0 if tag == "omitted" else 1.0
        size = self.value(f"a_n {name}", omega**2 * length)
        if tag == "across":
            return 1j * math.copysign(size, omega) * unit(arm)
        return (0.0 if tag == "kept" else size if tag == "outward" else -size) * unit(arm)

    def tangent(self, name: str, alpha: float, arm: complex, length: float) -> complex:
        """a^t of a driven crank's pin."""
        if alpha:
            self.may("tangential-along", "", "tangent", name, "along")
        along = self.tag("tangent", name)[0] == "along"
        return (1.0 if along else 1j) * alpha * length * unit(arm)

    def coriolis(
        self, name: str, omega: float, slip: float, along: complex, crank: float, absolute: Mapping[str, float],
    ) -> complex:  # fmt: skip
        """2 omega v_r, its direction that of v_r (`along`) turned in the sense of omega; slip: |v_r| as it was read."""
        for id, tag in (
            ("coriolis-omitted", "omitted"), ("coriolis-reversed", "reversed"), ("coriolis-half", "half"),
            ("coriolis-not-turned", "straight"), ("coriolis-not-laid-off", "kept"), ("coriolis-crank-omega", "crank"),
        ):  # fmt: skip
            self.may(id, "", "coriolis", name, tag)
        if crank * omega < 0:
            self.may("coriolis-crank-omega", "own sense", "coriolis", name, "crank's sense")
        tag, arg = self.tag("coriolis", name)
        for form, velocity in absolute.items():
            self.may("coriolis-absolute-velocity", form, "coriolis", name, "absolute", form)
            if (tag, arg) == ("absolute", form):
                slip = velocity
        sense = math.copysign(1.0, crank if tag == "crank's sense" else omega)
        rate = abs(crank if tag in ("crank", "crank's sense") else omega)
        factor = {"omitted": 0.0, "half": 0.5}.get(tag, 1.0)
        size = self.value(f"a_k {name}", factor * 2 * rate * slip)
        direction = unit(along) * (1.0 if tag == "straight" else 1j * sense)
        return (0.0 if tag == "kept" else -size if tag == "reversed" else size) * direction

    def lay(self, plane: str, name: str, start: complex, arrow: complex) -> complex:
        """The tip of a known arrow laid off from `start`."""
        if plane == "a" and abs(start) > 1e-12 and abs(arrow) > 1e-12:
            self.may("wrong-tail", "", "lay", name, "pole")
        if self.tag("lay", name)[0] == "pole":
            start = 0j
        return start + arrow + complex(self.err(plane), self.err(plane)) if arrow else start

    # --- what is sought -----------------------------------------------------------------------

    def meet(self, plane: str, p: complex, first: Line, q: complex, second: Line) -> complex:
        """The crossing of two direction lines, each from a tip."""
        one, two = self._direction(plane, first), self._direction(plane, second)
        sine = cross(one, two)
        if abs(sine) < 0.01:
            raise NoCrossing
        return p + one * cross(q - p, two) / sine

    def _direction(self, plane: str, line: Line) -> complex:
        op = "line" + plane
        if line.kind == "across":
            self.may("velocity-along-link" if plane == "v" else "tangential-along", "", op, line.name, "along")
        elif line.kind == "slide" and plane == "v":
            self.may("sliding-across", "", op, line.name, "across")
        tag, arg = self.tag(op, line.name)
        direction = unit(line.along)
        for (id, form), other in line.others.items():
            if abs(cross(unit(other), direction)) > 0.02:
                self.may(id, form, op, line.name, "other", (id, form))
            if (tag, arg) == ("other", (id, form)):
                direction = unit(other)
        if tag in ("along", "across"):
            direction *= 1j
            self.unsure.add(line.name)
        return direction * self.turn()

    def rotation(
        self, plane: str, link: str, arrow: complex, arm: complex, length: float, read: float | None = None,
        lengths: Mapping[str, float] | None = None, arrows: Mapping[tuple[str, str], complex] | None = None,
        unsure: str = "",
    ) -> float:  # fmt: skip
        """omega or alpha read off an arrow across an arm; read: its size, where that was read before.

        arrows: others that may be taken, by mistake and form; unsure: the line that gives the arrow its direction
        """
        word, op = ("omega", "omega") if plane == "v" else ("alpha", "alpha")
        text = f"{word} {link}"
        if plane == "v":
            self.may("omega-sense", "", op, text, "times", -1.0)
            self.may("conversion", "carried 10^-3", op, text, "times", 1e-3)
            for form, other in (lengths or {}).items():
                if abs(other / length - 1) > 0.02:
                    self.may("wrong-length", form, op, text, "times", length / other)
        self.half("diameter-for-radius", op, text)
        tag, arg = self.tag(op, text)
        size = abs(abs(arrow) + self.err(plane)) if read is None else read
        side = cross(arm, arrow)
        if unsure and unsure in self.unsure:  # nobody can tell its sense
            sense = self.rng.choice((-1.0, 1.0)) if self.rng else 1.0
        else:
            sense = math.copysign(1.0, side)
        for (id, form), other in (arrows or {}).items():
            self.may(id, form, op, text, "arrow", (id, form))
            if (tag, arg) == ("arrow", (id, form)):
                size = abs(abs(other) + self.err(plane))
        x = sense * size / (length * arg if tag == "length" else length)
        return self.value(text, x * arg if tag == "times" else x)

    def ratio(self, text: str, x: float, wrong: Mapping[tuple[str, str], float]) -> float:
        """A rotation by a ratio of radii; wrong: what it comes to otherwise, by mistake and form."""
        self.may("omega-sense", "", "ratio", text, "times", -1.0)
        tag, arg = self.tag("ratio", text)
        for (id, form), other in wrong.items():
            self.may(id, form, "ratio", text, "other", (id, form))
            if (tag, arg) == ("other", (id, form)):
                x = other
        return self.value(text, x * arg if tag == "times" else x)


class NoCrossing(Exception):
    """Lines that hardly cross: the student begins again, or gives up."""


@dataclass(frozen=True)
class Line:
    """A direction line of an arrow: across a link, along a guide ("slide"), or neither ("fixed")."""

    name: str
    along: complex
    kind: str = "across"
    others: Mapping[tuple[str, str], complex] = field(default_factory=dict)


# --- written wrongly, though all was drawn rightly ---------------------------------------------


def written(units: Mapping[str, str], right: Mapping[str, float], scales: Mapping[str, float]) -> list[Wrong]:
    """Mistakes of the answer sheet; units of what is asked, by text."""
    found: list[Wrong] = []

    def times(id: str, of: str, factors: Mapping[str, float]) -> None:
        found.append(Wrong(id, of, written=lambda values: {t: x * factors.get(t, 1.0) for t, x in values.items()}))

    texts = list(units)
    kinds = {kind: [t for t in texts if units[t] == kind] for kind in dict.fromkeys(units.values())}
    signed = [t for t in texts if t.split()[0] in ("omega", "alpha")]
    if any(right[t] < 0 for t in signed):
        found.append(Wrong("sense-not-given", "", written=lambda values: {t: abs(x) for t, x in values.items()}))
    for kind in kinds.values():
        for k, one in enumerate(kind):
            for other in kind[k + 1 :]:
                swap = {one: other, other: one}
                found.append(Wrong("answers-swapped", f"{one}, {other}",
                                   written=lambda values, swap=swap: {t: values[swap.get(t, t)] for t in values}))  # fmt: skip
    for t in texts:
        times("decimal-slip", f"{t} x10", {t: 10.0})
        times("decimal-slip", f"{t} /10", {t: 0.1})
        if t.startswith("alpha"):
            times("conversion", f"{t} sense", {t: -1.0})
    for kind, some in kinds.items():
        if kind in ("m/s", "m/s^2"):
            scale = scales["velocity" if kind == "m/s" else "acceleration"]
            for form, factor in (("x1000", 1e3), ("as on paper", 1 / scale)):
                times("conversion", f"{kind} {form}", dict.fromkeys(some, factor))
                if len(some) > 1:
                    times("conversion", f"{some[0]} {form}", {some[0]: factor})
        elif kind == "rad/s":
            times("conversion", "rad/s in rpm", dict.fromkeys(some, 30 / math.pi))
    if "m/s" in kinds and "m/s^2" in kinds:
        times("conversion", "lengths x1000", dict.fromkeys((*kinds["m/s"], *kinds["m/s^2"]), 1e3))
    if signed:
        times("degrees-for-radians", "", dict.fromkeys(signed, 180 / math.pi))
        if len(signed) > 1:
            times("degrees-for-radians", signed[-1], {signed[-1]: 180 / math.pi})
    return found


def printed(x: float, digits: int) -> float:
    return float(f"{x:.{digits - 1}e}") if math.isfinite(x) else x


Solve = Callable[["Paper", "Given"], None]


@dataclass(frozen=True)
class Given:
    """The numbers of a problem, mm and degrees made SI where they are read."""

    document: Mapping[str, object]
    turned: float = 0.0  # another student's drawing: the crank stands so many degrees further
    faster: float = 1.0

    def point(self, name: str) -> complex:
        x, y = self.document["frame"][name]
        return complex(x, y) / 1000

    def near(self, name: str) -> complex:
        x, y = self.document["sketch"][name]
        return complex(x, y) / 1000

    def length(self, name: str) -> float:
        for link in self.document["links"].values():
            for key, x in link.items():
                if key in (name, name[::-1]):
                    return x / 1000
                if key == "shape" and set(name) <= set(x):
                    return abs(complex(*x[name[0]]) - complex(*x[name[1]])) / 1000
        raise KeyError(name)

    def ratio(self, link: str, p: str, q: str, r: str) -> complex:
        """(r - p) / (q - p) of a link given by coordinates."""
        at = {name: complex(*xy) for name, xy in self.document["links"][link]["shape"].items()}
        return (at[r] - at[p]) / (at[q] - at[p])

    def driver(self, k: int = 0) -> tuple[float, float, float, str]:
        """Angle [deg], omega, alpha, and the unit in which omega is given."""
        driver = self.document["driver"][k]
        omega, kind = driver.get("omega", 0.0), "rad/s"
        if isinstance(omega, str):
            number, kind = omega.split()
            omega = float(number) * TURN[kind]
        return driver.get("angle", 0.0) + self.turned, omega * self.faster, driver.get("alpha", 0.0), kind


def triangle(pq: float, pr: float, qr: float, left: bool) -> complex:
    """(r - p) / (q - p) of a triangle with r on the left of p -> q, or on the right."""
    x = (pq * pq + pr * pr - qr * qr) / (2 * pq)
    return complex(x, (1 if left else -1) * math.sqrt(pr * pr - x * x)) / pq
