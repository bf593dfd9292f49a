"""The drawn position: the crossings taken there, and where contacts and drivers count from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.errors import GearsApart, NotPlaced
from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.methods.assembly import assemble
from graphkin.methods.equivalent import Contact
from graphkin.methods.position import position
from graphkin.methods.repeated import SetAside, as_aside, still_repeated
from graphkin.methods.stages import stages
from graphkin.methods.structure import Structure
from graphkin.steps import Construction, Equation, Facts, Meet, Plot, Step, Swing, replay

__all__ = ["as_drawn", "facts_of", "refuse_gears_apart", "with_sides"]


def as_drawn(
    mechanism: Mechanism, lower: Mechanism, aside: tuple[SetAside, ...] = ()
) -> tuple[dict[str, float], Mechanism]:
    """Angles and displacements at the drawn position, from which rolling counts, and the drivers with all their values.

    There the poses hold, and nothing rolls; a wheel that no pose and no other link turns stands at 0.
    """
    structure, plot = _standing(mechanism, lower, aside)
    drawn = {link: float(plot.theta[link]) if link in plot.theta else 0.0 for link in structure.bodies}
    drawn |= {slide: float(value) for slide, value in plot.s.items()}
    sketch = {**lower.sketch, **{p: complex(z) for p, z in plot.position.items() if p[0].isupper()}}
    drivers = tuple(_valued(driver, plot, drawn) for driver in mechanism.drivers)
    return drawn, replace(lower, drivers=drivers, sketch=sketch)


def _standing(mechanism: Mechanism, lower: Mechanism, aside: tuple[SetAside, ...]) -> tuple[Structure, Plot]:
    """The mechanism with its poses for drivers, beside those drivers whose values are given."""
    posed = tuple(
        Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)
        for pose in mechanism.poses
    )
    given = tuple(driver for driver in mechanism.drivers if driver.value is not None and driver.kind != "spin")
    structure = Structure(replace(lower, drivers=(*given, *posed)))
    repeating = as_aside(still_repeated(mechanism, structure, aside))
    structure = replace(structure, aside=repeating)
    left = stages(structure)[1]
    wheels = {wheel for gear in mechanism.gears for wheel in gear.joins}
    wheels |= {wheel for roll in mechanism.rolls for wheel in roll.joins}
    marked = tuple(Driver("spin", body, value=0.0) for body in left if body in wheels and body != FRAME)
    structure = Structure(replace(lower, drivers=(*given, *posed, *marked)), aside=repeating)
    order, left = stages(structure)
    names = tuple(dict.fromkeys(structure.home(body) for body in left))
    if names:
        raise NotPlaced(mechanism.where("links", names[0]), names)
    construction, choices = position(structure, order)
    facts = facts_of(structure, None, {})
    found = assemble(structure, construction, choices, facts, {})
    return structure, replay(with_sides(construction, found.sides), Plot(facts, found.near))


def _valued(driver: Driver, plot: Plot, drawn: Mapping[str, float]) -> Driver:
    """A driver whose value a pose has fixed, with that value."""
    if driver.kind == "slide":
        return driver if driver.value is not None else replace(driver, value=drawn[driver.link])
    if driver.kind == "spin":
        return replace(driver, value=drawn[driver.link])
    if driver.value is not None or driver.vector is None:
        return driver
    value = np.angle(plot.arm(*driver.vector))
    if driver.from_vector is not None:
        value -= np.angle(plot.arm(*driver.from_vector))
    return replace(driver, value=float(value))


def refuse_gears_apart(mechanism: Mechanism, ties: tuple[Contact, ...], plot: Plot) -> None:
    """The centres of a gear pair stand where the other links put them; their radii must fit that."""
    for k, tie in enumerate(ties[: len(mechanism.gears)]):
        distance, wanted = float(abs(plot.arm(*tie.centres))), abs(sum(tie.radii))
        if abs(distance - wanted) > 1e-6 * max(distance, wanted):
            where = mechanism.where("gear", k, "radii")
            raise GearsApart(where, tie.centres, distance * 1000, wanted * 1000)


def facts_of(structure: Structure, values: Sequence[Value] | None, drawn: Mapping[str, float]) -> Facts:
    """What is known before the pencil moves; drivers at the drawn position, or at other values [rad, m]."""
    mechanism = structure.mechanism
    drivers = mechanism.drivers
    return Facts(
        frame=FRAME,
        shapes=structure.shapes,
        lines={s.name: (s.guide, s.line.origin, s.line.direction) for s in mechanism.slides},
        turns=structure.turns,
        slides_driven=structure.slides_driven,
        values=tuple(values) if values is not None else tuple(driver.value or 0.0 for driver in drivers),
        rates=tuple(driver.rate for driver in drivers),
        accelerations=tuple(driver.acceleration for driver in drivers),
        drawn=drawn,
    )


def with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""
    parts: list[Step | Equation] = []
    for part in construction.parts:
        if isinstance(part, Equation):
            parts.append(replace(part, steps=tuple(_chosen(step, sides) for step in part.steps)))
        else:
            parts.append(_chosen(part, sides))
    return replace(construction, parts=tuple(parts))


def _chosen(step: Step, sides: tuple[int, ...]) -> Step:
    if isinstance(step, Meet | Swing) and step.choice is not None:
        return replace(step, side=sides[step.choice])
    return step
