"""What a construction starts from: the facts of the drawn position, and the crossings taken there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from graphkin.errors import GearsApart
from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods.equivalent import Contact
from graphkin.methods.structure import Structure
from graphkin.steps import Construction, Equation, Facts, Meet, Plot, Step, Swing

__all__ = ["facts_of", "refuse_gears_apart", "with_sides"]


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
