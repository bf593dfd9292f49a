"""Wheels that roll on each other, of many mechanisms at once: how each stands, and what its contacts count, as arrays.

What a contact counts (radii, on which side) stands in the steps themselves; the steps of one method are rewritten with
the numbers of all, or of one. Drivers and poses place the mechanisms all together, as far as nothing repeats another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import (
    Construction,
    Equation,
    Fit,
    InStep,
    Plot,
    Roll,
    Simultaneous,
    Step,
    Touch,
    replay,
    slide_key,
)
from graphkin.geometry import Value, cross
from graphkin.mechanism import Driver, Mechanism
from graphkin.planning.drawn_position import given_at, left_open, placed_by, value_of
from graphkin.planning.equivalent import Contact, contacts, lower_pairs
from graphkin.planning.method import Method
from graphkin.planning.position import in_step, position, touching
from graphkin.planning.stages import Group, Mesh, Stage, stages
from graphkin.planning.starting_facts import facts_of
from graphkin.planning.structure import Structure
from graphkin.running.assemblies import Told, assembled_by_sketch
from graphkin.tolerances import ROUNDED
from graphkin.value import frozen


@frozen
class Standing:
    """How many mechanisms stand, (n,) each.

    lower   their lower pairs, with the value of each driver and all points where they stand
    drawn   angles and displacements, as `Method` has them
    """

    lower: Mechanism
    drawn: Mapping[str, Value]
    sure: np.ndarray

    def of(self, row: int, lower: Mechanism) -> tuple[Mechanism, dict[str, float]]:
        """One mechanism's own lower pairs, as they stand, and its angles and displacements."""
        drivers = tuple(
            replace(driver, value=float(_at(many.value, row)))
            for driver, many in zip(lower.drivers, self.lower.drivers, strict=True)
        )
        sketch = {point: complex(_at(place, row)) for point, place in self.lower.sketch.items()}
        drawn = {name: float(_at(value, row)) for name, value in self.drawn.items()}
        return replace(lower, drivers=drivers, sketch=sketch), drawn


def _at(value: Value, row: int) -> Value:
    return value[row] if np.ndim(value) else value


# --- how they stand ---------------------------------------------------------------------------


def standing(method: Method, many: Mechanism) -> Standing | None:
    """By all drivers' values and poses; `many`: lower pairs side by side. None where some of these repeat others."""
    mechanism = method.mechanism
    placed = placed_by(mechanism, lower_pairs(mechanism), given_at(mechanism), ())
    if placed.surplus != 0 or left_open(placed):
        return None
    construction, _ = position(placed, stages(placed)[0])
    alone = replace(method, structure=placed, position=construction)
    structure = replace(placed, mechanism=replace(many, drivers=_fixing(placed, many)))
    facts = facts_of(structure, None, {})
    found = assembled_by_sketch(alone, facts, many.sketch, Told.by_sketch(alone, structure, facts))
    plot = replay(construction, Plot(facts, found.near), found.sides)
    drawn = {link: plot.theta.get(link, 0.0) for link in placed.bodies}
    drawn |= {slide_key(slide): value for slide, value in plot.s.items()}
    sketch = {**many.sketch, **{p: z for p, z in plot.position.items() if p in mechanism.points}}
    lower = replace(many, drivers=tuple(_valued(driver, plot, drawn) for driver in many.drivers), sketch=sketch)
    return Standing(lower, _counted(replace(method.structure, mechanism=lower), drawn), found.sure)


def _fixing(placed: Structure, many: Mechanism) -> tuple[Driver, ...]:
    """What places one mechanism, with the values of all."""
    values = [driver.value for driver in many.drivers if driver.value is not None and driver.kind != "spin"]
    values += [pose.value for pose in many.poses]
    fixing, marked = placed.mechanism.drivers[: len(values)], placed.mechanism.drivers[len(values) :]
    return (*(replace(driver, value=value) for driver, value in zip(fixing, values, strict=True)), *marked)


def _valued(driver: Driver, plot: Plot, drawn: Mapping[str, Value]) -> Driver:
    """A driver with its value, be it that a pose has fixed it."""
    if driver.kind == "spin":
        return replace(driver, value=drawn[driver.link])
    return driver if driver.value is not None else replace(driver, value=value_of(plot, driver))


def _counted(structure: Structure, drawn: Mapping[str, Value]) -> dict[str, Value]:
    """The same with angles that count whole turns as the drivers' values do."""
    counted, given = dict(drawn), list[Value](driver.value for driver in structure.mechanism.drivers)
    for body, turn in structure.turns.items():
        values = sum(sign * given[k] for k, sign in turn.drivers)
        turns = np.rint((drawn[turn.base] + turn.constant + values - drawn[body]) / (2 * np.pi))
        counted[body] = drawn[body] + 2 * np.pi * turns
    return counted


# --- what their contacts count ----------------------------------------------------------------


def contacts_of(mechanisms: Sequence[Mechanism], lower: Sequence[Mechanism]) -> list[tuple[Contact, ...]]:
    """Of each mechanism."""
    return [tuple(contacts(one, low)) for one, low in zip(mechanisms, lower, strict=True)]


def side_by_side(of_each: Sequence[tuple[Contact, ...]]) -> tuple[Contact, ...] | None:
    """Contacts whose numbers are arrays (n,); None where they are not alike."""
    if any(_without_numbers(ties) != _without_numbers(of_each[0]) for ties in of_each):
        return None
    return tuple(_stacked(ties) for ties in zip(*of_each, strict=True))


def _without_numbers(ties: Sequence[Contact]) -> list[object]:
    return [(tie.name, tie.wheels, tie.centres, tie.arm, [link for link, _ in tie.angles], tie.slide) for tie in ties]


def _stacked(ties: Sequence[Contact]) -> Contact:
    angles = tuple(
        (link, np.array([tie.angles[k][1] for tie in ties])) for k, (link, _) in enumerate(ties[0].angles)
    )
    radii: Value = tuple(np.array([tie.radii[k] for tie in ties]) for k in (0, 1))
    return replace(ties[0], radii=radii, angles=angles, on_slide=np.array([tie.on_slide for tie in ties]))


def with_contacts(method: Method, structure: Structure) -> Method:
    """A method of the same topology with the contacts, and all else, of a structure; its steps count what these do."""
    own = {tie.name: tie for tie in structure.contacts}
    letters = dict(touching(structure))
    return replace(
        method, structure=structure, stages=tuple(_stage(stage, own) for stage in method.stages),
        position=_rewritten(method.position, own, letters), velocity=_rewritten(method.velocity, own, letters),
        acceleration=_rewritten(method.acceleration, own, letters),
    )  # fmt: skip


def _stage(stage: Stage, own: Mapping[str, Contact]) -> Stage:
    match stage:
        case Mesh():
            return replace(stage, contact=own[stage.contact.name])
        case Group():
            return replace(stage, contacts=tuple(own[tie.name] for tie in stage.contacts))
        case _:
            return stage


def _rewritten(construction: Construction, own: Mapping[str, Contact], letters: Mapping[str, Contact]) -> Construction:
    def counts(contact: InStep) -> InStep:
        return in_step(own[contact.name])

    parts = tuple(
        replace(part, steps=tuple(_step(step, counts, letters) for step in part.steps))
        if isinstance(part, Equation)
        else _step(part, counts, letters)
        for part in construction.parts
    )
    return replace(construction, parts=parts)


def _step(step: Step, counts: Callable[[InStep], InStep], letters: Mapping[str, Contact]) -> Step:
    match step:
        case Roll():
            return replace(step, contact=counts(step.contact))
        case Fit() | Simultaneous():
            return replace(step, contacts=tuple(map(counts, step.contacts)))
        case Touch(slide=slide):
            first, second = letters[step.point].radii
            return replace(step, offset=-second) if slide else replace(step, ratio=first / (first + second))
        case _:
            return step


def in_touch(of_each: Sequence[tuple[Contact, ...]], ties: Sequence[Contact], sliding: bool, plot: Plot) -> np.ndarray:
    """Where all centres stand as the radii want, as `refuse_contacts_apart` asks of one mechanism: (n,)."""
    good = np.ones(len(of_each), dtype=bool)
    for k, tie in enumerate(ties):
        if not tie.slide:
            distance, wanted = np.abs(plot.arm(*tie.centres)), np.abs(tie.radii[0] + tie.radii[1])
        elif sliding and (path := tie.pair.path) is not None:
            paths = [each[k].pair.path for each in of_each]
            direction = np.array([each.line.direction for each in paths if each is not None])
            along = direction * np.exp(1j * plot.theta[path.line.link])
            distance = cross(along, plot.arm(path.line.origin, path.point))
            wanted = np.array([each.offset for each in paths if each is not None])
        else:
            continue
        good &= np.abs(distance - wanted) <= ROUNDED * np.maximum(np.abs(distance), np.abs(wanted))
    return good
