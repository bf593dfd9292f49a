"""What a construction starts from: the facts of the drawn position, and the crossings taken there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.geometry import Value, cross
from graphkin.base.tolerances import ROUNDED
from graphkin.construction import Construction, Equation, Facts, Meet, Plot, Step, Swing
from graphkin.errors import GearsApart, OffTrack, Where
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Gear, Line
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import Topology


def refuse_contacts_apart(mechanism: Mechanism, ties: tuple[Contact, ...], plot: Plot) -> None:
    """Centres that other pairs hold must stand as the radii want: apart as far, or as far beside the track.

    At a single position; those of arrays pass.
    """
    if any(np.ndim(value) for value in plot.position.values()):
        return
    for tie in ties:
        if not tie.slide:
            distance, wanted = float(abs(plot.arm(*tie.centres))), abs(sum(tie.radii))
            if abs(distance - wanted) > ROUNDED * max(distance, wanted):
                raise GearsApart(_where(mechanism, tie), tie.centres, distance * 1000, wanted * 1000)
        elif mechanism.slides and (path := tie.pair.path) is not None:
            distance, wanted = _beside(path.line, path.point, plot), path.offset
            if abs(distance - wanted) > ROUNDED * abs(wanted):
                track = mechanism.called(path.line.link)
                raise OffTrack(_where(mechanism, tie), path.point, track, distance * 1000, wanted * 1000)


def _where(mechanism: Mechanism, tie: Contact) -> Where:
    """Where the file gives the radii of a contact."""
    return mechanism.where(*mechanism.path(tie.pair), "radii" if isinstance(tie.pair, Gear) else "radius")


def _beside(line: Line, point: str, plot: Plot) -> float:
    """How far a point lies to the left of a line [m]."""
    along = line.direction * np.exp(1j * plot.theta[line.link])
    return float(cross(along, plot.arm(line.origin, point)))


def facts_of(structure: Topology, values: Sequence[Value] | None, drawn: Mapping[str, float]) -> Facts:
    """What is known before the pencil moves; drivers at the drawn position, or at other values [rad, m]."""
    mechanism = structure.mechanism
    drivers = mechanism.drivers
    drawn_values = (0.0 if driver.value is None else driver.value for driver in drivers)
    return Facts(
        frame=FRAME,
        shapes=structure.shapes,
        lines={s.name: (s.guide, s.line.origin, s.line.direction) for s in mechanism.slides},
        turns=structure.turns,
        slides_driven=structure.slides_driven,
        values=tuple(drawn_values if values is None else values),
        rates=tuple(driver.rate for driver in drivers),
        accelerations=tuple(driver.acceleration for driver in drivers),
        drawn=drawn,
    )


def with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""
    if not sides:
        return construction
    parts: list[Step | Equation] = []
    for part in construction.parts:
        if not isinstance(part, Equation):
            parts.append(_chosen(part, sides))
        elif any(map(_choice, part.steps)):
            parts.append(replace(part, steps=tuple(_chosen(step, sides) for step in part.steps)))
        else:
            parts.append(part)
    return replace(construction, parts=tuple(parts))


def _choice(step: Step) -> bool:
    return isinstance(step, Meet | Swing) and step.choice is not None


def _chosen(step: Step, sides: tuple[int, ...]) -> Step:
    if isinstance(step, Meet | Swing) and step.choice is not None:
        return replace(step, side=sides[step.choice])
    return step
