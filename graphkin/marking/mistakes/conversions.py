"""Mistakes of units and scales: factors of one value, of a kind, of all lengths, of what is given, or carried on; and
of writing answers down: exchanged, without their sense, with the decimal point elsewhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from math import pi

from graphkin.base.geometry import number
from graphkin.construction import Plane
from graphkin.files.values import UNITS
from graphkin.marking.answers import asked_of, sort_of
from graphkin.marking.mistakes.readings import measured, reading
from graphkin.marking.rewrite import Edit, Rewrite, RewrittenValue, Times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.quantities import Moving, Quantity, Quotient, Rotation

TURNS = {"30/π": 30 / pi, "60": 60.0, "1/60": 1 / 60, "2π": 2 * pi, "1/2π": 1 / (2 * pi)}
DEGREES = {"180/π": 180 / pi, "π/180": pi / 180}
PLACES = {"10": 10.0, "1/10": 0.1}
THOUSANDS = {"10³": 1e3, "10⁻³": 1e-3}
HUNDREDS = {"100": 100.0, "1/100": 0.01}
GIVEN = {"30/π": 30 / pi, "60": 60.0, "1/2π": 1 / (2 * pi)}
"""Turns per minute taken for rad/s; made into rad with the minute left; turns per second taken for rad/s."""


def factors(unit: str, scales: Mapping[str, float]) -> dict[str, float]:
    """The factors of a unit, by how they are written."""
    found = THOUSANDS | (TURNS if unit in ("rad/s", "rad/s^2") else {})
    length, velocity, acceleration = (scales.get(key) for key in ("length", "velocity", "acceleration"))
    own, other = (acceleration, velocity) if unit.endswith("^2") else (velocity, acceleration)
    mine, its = ("μ_a", "μ_v") if unit.endswith("^2") else ("μ_v", "μ_a")
    if own:
        found[f"1/{mine}"] = 1 / own
        if other:
            found[f"{its}/{mine}"] = other / own
    if length and unit.startswith("rad"):
        found |= {"μ_l": length, "1/μ_l": 1 / length}
        if own:
            found[f"μ_l/{mine}"] = length / own
    return {text: factor for text, factor in found.items() if abs(factor - 1) > 1e-9}


@mistake("conversion", "unit", "3-2.1")
def conversion(scene: Scene) -> Iterator[Rewrite]:
    """A unit or a scale is converted wrongly: rpm as rad/s, a thousand times."""
    asked = [q for q in scene.quantities if isinstance(q, Moving) or (isinstance(q, Rotation) and q.word != "theta")]
    yield from _written(scene, asked)
    yield from _throughout(scene)
    yield from _carried(scene, factors("rad/s", scene.scales))
    # the speed that drives: revolutions per minute taken for rad/s, and the like
    for k, driver in enumerate(scene.method.drivers):
        for form, factor in (THOUSANDS if driver.kind == "slide" else GIVEN).items():
            if driver.rate:
                yield Rewrite((driver.name,), form, (Edit(("rate", k), Times(factor)),), way="given")


def _written(scene: Scene, asked: Sequence[Quantity]) -> Iterator[Rewrite]:
    """Handed-in values alone; all of one unit, each of them, and rotations with the other sense."""
    for unit in dict.fromkeys(quantity.unit for quantity in asked):
        kind = [quantity.text for quantity in asked if quantity.unit == unit]
        times = factors(unit, scene.scales) | ({} if unit.startswith("rad") else _lengths(scene))
        if len(kind) > 1:
            yield from _times({tuple(kind): (unit,)}, times, "kind")
        yield from _times({(text,): (text,) for text in kind}, times)
    turning = [quantity for quantity in asked if isinstance(quantity, Rotation)]
    alone = [q.text for q in turning if q.word == "alpha" or not scene.cranks_beside(q.link)]  # not by centres
    yield from _times({(text,): (text,) for text in alone}, {"": -1.0}, "sense")


def _lengths(scene: Scene) -> dict[str, float]:
    """mm and cm for m, or m for these, and the units of the file's lengths."""
    given = (one for one in scene.method.mechanism.given.values() if one.dimension == "length")
    written = {str(one.written).lstrip("+-.0123456789eE ") for one in given} - {"m", "mm", "cm"}
    own = (below / above for unit, (above, below) in UNITS["length"].items() if unit in written)
    return THOUSANDS | HUNDREDS | {f"{factor:.4g}": factor for factor in own}


def _times(
    of: Mapping[tuple[str, ...], tuple[str, ...]], times: Mapping[str, float], way: str = ""
) -> Iterator[Rewrite]:
    """Handed-in values, some together under names, each of the factors times what they are."""
    for form, factor in times.items():
        for texts, called in of.items():
            yield Rewrite(called, form, asked=tuple(RewrittenValue(text, factor) for text in texts), way=way)


def _carried(scene: Scene, factors: Mapping[str, float], plane: Plane = "velocity") -> Iterator[Rewrite]:
    """A rotation read so, and all that follows from it."""
    for step, name in measured(scene, plane):
        for form, factor in factors.items():
            yield Rewrite((name,), form, reading(plane, step, Times(factor)), way="carried")


def _throughout(scene: Scene) -> Iterator[Rewrite]:
    """Velocities and accelerations alike: all lengths in another unit, or as they are on paper. Rotations are right."""
    kinds = {unit: [q.text for q in scene.quantities if q.unit == unit] for unit in ("m/s", "m/s^2")}
    if not all(kinds.values()):
        return
    ways = {("lengths", form): (factor, factor) for form, factor in _lengths(scene).items()}
    velocity, acceleration = (scene.scales.get(plane) for plane in ("velocity", "acceleration"))
    if velocity and acceleration:
        ways["paper", "1/μ_v, 1/μ_a"] = 1 / velocity, 1 / acceleration
    for (way, form), each in ways.items():
        values = (
            RewrittenValue(text, factor) for texts, factor in zip(kinds.values(), each, strict=True) for text in texts
        )
        yield Rewrite((*kinds,), form, asked=tuple(values), way=way)


# --- answers as they are written down ---------------------------------------------------------


@mistake("degrees-for-radians", "unit", "3-2.1")
def degrees(scene: Scene) -> Iterator[Rewrite]:
    """Rotations in degrees: all of them, those of one word, one alone, or one that is carried on."""
    turning = [quantity for quantity in scene.quantities if isinstance(quantity, Rotation)]
    omegas, alphas = ([q.text for q in turning if q.word == word] for word in ("omega", "alpha"))
    every = omegas + alphas
    groups = [(("ω", "α"), every), (("ω",), omegas), (("α",), alphas), *(((text,), [text]) for text in every)]
    # of several that are the same rotations, the last one's name says most
    yield from _times({tuple(texts): called for called, texts in groups if texts}, DEGREES)
    yield from _carried(scene, DEGREES)


def _asked(scene: Scene) -> list[Quantity]:
    """The quantities that the problem asks for, of those that are handed in."""
    texts = {quantity.text for quantity in asked_of(scene.method.mechanism).values()}
    return [quantity for quantity in scene.quantities if quantity.text in texts]


@mistake("decimal-slip", "unit", "3-2.1")
def decimal_slip(scene: Scene) -> Iterator[Rewrite]:
    """One answer ten times too large or too small; or a rotation, and all that follows from it."""
    yield from _times({(q.text,): (q.text,) for q in _asked(scene) if sort_of(q) != "angle"}, PLACES)
    yield from _carried(scene, PLACES)
    yield from _carried(scene, PLACES, "acceleration")


@mistake("answers-swapped", "answers", "3-2.1")
def answers_swapped(scene: Scene) -> Iterator[Rewrite]:
    """Each of two answers of one unit written in the other's place."""
    for one, other in combinations(_asked(scene), 2):
        if one.unit == other.unit:
            asked = RewrittenValue(one.text, other=other.text), RewrittenValue(other.text, other=one.text)
            yield Rewrite((one.text,), other.text, asked=asked)


@mistake("sense-not-given", "unit", "3-2.1 (3-1)")
def sense_not_given(scene: Scene) -> Iterator[Rewrite]:
    """All rotations and their ratios as magnitudes."""
    signed = [q for q in scene.quantities if isinstance(q, Rotation | Quotient) and sort_of(q) == "sense"]
    negative = tuple(q.text for q in signed if number(q.answer(scene.motions).value) < 0)
    yield from _times({negative: negative} if negative else {}, {"": -1.0})
