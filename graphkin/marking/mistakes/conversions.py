"""Mistakes of units and scales: factors of one value, of a kind, of all lengths, of what is given, or carried on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import pi

from graphkin.marking.mistakes.readings import measured, reading
from graphkin.marking.rewrite import Edit, Rewrite, RewrittenValue, Times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.quantities import Moving, Quantity, Rotation

TURNS = {"30/π": 30 / pi, "60": 60.0, "1/60": 1 / 60, "2π": 2 * pi, "1/2π": 1 / (2 * pi), "180/π": 180 / pi}
THOUSANDS = {"10³": 1e3, "10⁻³": 1e-3}
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
    """A unit or a scale is converted wrongly: rpm as rad/s, deg as rad, a thousand times."""
    asked = [q for q in scene.quantities if isinstance(q, Moving) or (isinstance(q, Rotation) and q.word != "theta")]
    yield from _written(scene, asked)
    yield from _throughout(scene)
    # a rotation read so, and all that follows from it
    for step, name in measured(scene, "velocity"):
        for form, factor in factors("rad/s", scene.scales).items():
            yield Rewrite("conversion", name, form, reading("velocity", step, Times(factor)), way="carried")
    # the speed that drives: revolutions per minute taken for rad/s, and the like
    for k, driver in enumerate(scene.method.drivers):
        for form, factor in (THOUSANDS if driver.kind == "slide" else GIVEN).items():
            if driver.rate:
                yield Rewrite("conversion", driver.name, form, (Edit(("rate", k), Times(factor)),), way="given")


def _written(scene: Scene, asked: Sequence[Quantity]) -> Iterator[Rewrite]:
    """Handed-in values alone; all of one unit, each of them, and rotations with the other sense."""
    for unit in dict.fromkeys(quantity.unit for quantity in asked):
        kind = [quantity.text for quantity in asked if quantity.unit == unit]
        for form, factor in factors(unit, scene.scales).items():
            if len(kind) > 1:
                values = tuple(RewrittenValue(text, factor) for text in kind)
                yield Rewrite("conversion", unit, form, asked=values, way="kind")
            for text in kind:
                yield Rewrite("conversion", text, form, asked=(RewrittenValue(text, factor),))
    for quantity in asked:
        if isinstance(quantity, Rotation) and quantity.word == "alpha":
            yield Rewrite("conversion", quantity.text, asked=(RewrittenValue(quantity.text, -1.0),), way="sense")


def _throughout(scene: Scene) -> Iterator[Rewrite]:
    """Velocities and accelerations alike: all lengths in another unit, or as they are on paper. Rotations are right."""
    kinds = {unit: [q.text for q in scene.quantities if q.unit == unit] for unit in ("m/s", "m/s^2")}
    if not all(kinds.values()):
        return
    ways = {("lengths", form): (factor, factor) for form, factor in THOUSANDS.items()}
    velocity, acceleration = (scene.scales.get(plane) for plane in ("velocity", "acceleration"))
    if velocity and acceleration:
        ways["paper", "1/μ_v, 1/μ_a"] = 1 / velocity, 1 / acceleration
    for (way, form), each in ways.items():
        values = (
            RewrittenValue(text, factor) for texts, factor in zip(kinds.values(), each, strict=True) for text in texts
        )
        yield Rewrite("conversion", ", ".join(kinds), form, asked=tuple(values), way=way)
