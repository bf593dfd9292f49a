"""How a mechanism stands at the drawn position: its poses and its drivers' values, and where rolling counts from.

Nothing rolls there. What repeats what is known already is no error, as long as it says the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice
from typing import TYPE_CHECKING

import numpy as np

from graphkin.base.geometry import Value, wrapped
from graphkin.base.tolerances import ROUNDED
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plot, replay, slide_key
from graphkin.errors import CannotAssemble, DeadPoint, NotPlaced, PosesDiffer, Where
from graphkin.model.mechanism import FRAME, Driver, Mechanism, Pose
from graphkin.model.quantities import EDGE, driven
from graphkin.planning.assembly import assemble, extent, refuse_open
from graphkin.planning.position import position
from graphkin.planning.repeated import as_aside, still_repeated
from graphkin.planning.stages import stages
from graphkin.planning.starting_facts import facts_of, with_sides
from graphkin.planning.structure import Topology

if TYPE_CHECKING:
    from graphkin.planning.redundancy import SetAside

    Repeats = tuple[SetAside, ...]

TRIES = 64
"""So many choices of poses to leave out are tried."""


@frozen
class _Given:
    """A driver's value or a pose: what it fixes, as a driver, and which of its table it is."""

    fixes: Driver
    posed: bool
    number: int


@frozen
class DrawnPlacement:
    """The drawn position: the mechanism held there by poses and values alone, how it is drawn by these, and drawn."""

    structure: Topology
    construction: Construction
    plot: Plot


def as_drawn(
    mechanism: Mechanism, lower: Mechanism, repeats: Repeats = ()
) -> tuple[dict[str, float], Mechanism]:
    """Angles and displacements at the drawn position, from which rolling counts, and the drivers with all their values.

    repeats  what repeats other constraints when all moves; here only where it does so though nothing rolls

    Raises NotPlaced where values and poses leave something open, PosesDiffer where they do not fit together.
    """
    placed = placement(mechanism, lower, repeats)
    structure, plot = placed.structure, placed.plot
    drawn = {link: float(plot.theta[link]) if link in plot.theta else 0.0 for link in structure.bodies}
    drawn |= {slide_key(slide): float(value) for slide, value in plot.s.items()}
    sketch = {**lower.sketch, **{p: complex(z) for p, z in plot.position.items() if p in mechanism.points}}
    drivers = tuple(_valued(driver, plot, drawn) for driver in mechanism.drivers)
    driven = replace(lower, drivers=drivers, sketch=sketch)
    return _counted_on(replace(structure, mechanism=driven), drawn), driven


def _counted_on(structure: Topology, drawn: dict[str, float]) -> dict[str, float]:
    """The same with angles that count whole turns as the drivers' values do."""
    counted = dict(drawn)
    for body, turn in structure.turns.items():
        values = sum(sign * (structure.mechanism.drivers[k].value or 0.0) for k, sign in turn.drivers)
        turns = round((drawn[turn.base] + turn.constant + values - drawn[body]) / (2 * np.pi))
        counted[body] = drawn[body] + 2 * np.pi * turns
    return counted


def _valued(driver: Driver, plot: Plot, drawn: Mapping[str, float]) -> Driver:
    """A driver whose value a pose has fixed, with that value."""
    if driver.kind == "slide":
        return driver if driver.value is not None else replace(driver, value=drawn[slide_key(driver.link)])
    if driver.kind == "spin":
        return replace(driver, value=drawn[driver.link])
    return driver if driver.value is not None else replace(driver, value=float(value_of(plot, driver)))


# --- what is given ----------------------------------------------------------------------------


def placement(mechanism: Mechanism, lower: Mechanism, repeats: Repeats) -> DrawnPlacement:
    """All that is given taken together; where that does not do, without poses that the rest gives as well.

    Those must say the same as what is then found.
    """
    given, refusal, placed = given_at(mechanism), None, None
    for needed in _fewer_and_fewer(given):
        try:
            found = _placed(mechanism, lower, needed, repeats)
        except (CannotAssemble, DeadPoint, NotPlaced) as error:
            refusal = error if refusal is None or isinstance(refusal, NotPlaced) else refusal
            continue
        if all(_holds(found.plot, each) for each in needed):
            _refuse_other(mechanism, found, given, needed)
            return found
        placed = placed or found
    if placed is None:
        assert refusal is not None
        raise refusal
    return placed  # by drivers that contradict each other: there are too many of them


def _fewer_and_fewer(given: tuple[_Given, ...]) -> Iterator[tuple[_Given, ...]]:
    """All that is given, then without one pose, the last first, then without two, .."""
    poses = [each for each in reversed(given) if each.posed]
    leaving = (left for count in range(len(poses) + 1) for left in combinations(poses, count))
    for left in islice(leaving, TRIES):
        yield tuple(each for each in given if each not in left)


def _refuse_other(
    mechanism: Mechanism, placed: DrawnPlacement, given: tuple[_Given, ...], needed: tuple[_Given, ...]
) -> None:
    """A pose that was not needed must hold all the same."""
    for each in given:
        if each not in needed and not _holds(placed.plot, each):
            others = tuple(_where(mechanism, other) for other in _beside(placed.structure, each, needed))
            raise PosesDiffer(_where(mechanism, each), each.fixes.name, *_told(each, _off(placed.plot, each)), others)


def _where(mechanism: Mechanism, given: _Given) -> Where:
    """Where the file says so."""
    return mechanism.where("pose" if given.posed else "driver", given.number)


def given_at(mechanism: Mechanism) -> tuple[_Given, ...]:
    """What the drivers' values and the poses fix."""
    return tuple(_fixed(mechanism))


def _fixed(mechanism: Mechanism) -> Iterator[_Given]:
    for k, driver in enumerate(mechanism.drivers):
        if driver.value is not None and driver.kind != "spin":
            yield _Given(driver, False, k)
    for k, pose in enumerate(mechanism.poses):
        fixes = Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)
        yield _Given(fixes, True, k)


def _beside(structure: Topology, given: _Given, needed: Sequence[_Given]) -> list[_Given]:
    """What fixes the same: the values that turn one of the two links against the other, else all that is needed."""
    fixes, turns = given.fixes, structure.turns
    if fixes.kind == "slide":
        return [other for other in needed if other.fixes.link == fixes.link] or list(needed)
    one, other = turns[fixes.link], turns[fixes.from_link]
    if one.base != other.base:
        return list(needed)
    path = {k for k, _ in one.drivers} ^ {k for k, _ in other.drivers}
    return [each for k, each in enumerate(needed) if k in path]


# --- placing ----------------------------------------------------------------------------------


def _placed(mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats) -> DrawnPlacement:
    """The mechanism put together by these values."""
    structure = placed_by(mechanism, lower, given, repeats)
    if names := left_open(structure):
        raise NotPlaced(mechanism.where("links", names[0]), tuple(mechanism.called(name) for name in names))
    construction, choices = position(structure, stages(structure)[0])
    facts = facts_of(structure, None, {})
    found = assemble(structure, construction, choices, facts, {})
    construction = with_sides(construction, found.sides)
    plot = replay(construction, Plot(facts, found.near))
    refuse_open(structure, plot, ROUNDED)
    return DrawnPlacement(structure, construction, plot)


def placed_by(mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats) -> Topology:
    """The mechanism with these values; wheels that nothing turns and that show no direction stand at 0."""
    drivers = tuple(each.fixes for each in given)
    structure = Topology(replace(lower, drivers=drivers))
    structure = replace(structure, aside=as_aside(still_repeated(structure, repeats)))
    plain: dict[str, str] = {}
    for body in structure.bodies:
        if structure.base(body) != FRAME and _shows_nothing(mechanism, structure, body):
            plain.setdefault(structure.base(body), body)
    marked = tuple(Driver("spin", body, value=0.0) for body in plain.values())
    return replace(structure, mechanism=replace(lower, drivers=(*drivers, *marked)))


def _shows_nothing(mechanism: Mechanism, structure: Topology, body: str) -> bool:
    """Whether one cannot see how a wheel stands: it hangs on its centre alone, and has no other point."""
    wheels = {wheel for pair in mechanism.pairs if pair.rolling is not None for wheel in pair.joins}
    wheels |= {driver.link for driver in mechanism.drivers if driver.kind == "spin"}
    hinges = list(structure.joints(body))
    return body in wheels and len(hinges) < 2 and len(set(structure.shapes[body].values())) == 1


def left_open(structure: Topology) -> tuple[str, ...]:
    """The links that nothing places, those first whose direction is open."""
    left = [body for body in stages(structure)[1] if not structure.is_pin(body)]
    turning = [body for body in left if structure.base(body) != FRAME]
    return tuple(name for name in turning or left if structure.is_link(name))


# --- comparing --------------------------------------------------------------------------------


def value_of(plot: Plot, fixes: Driver | Pose) -> Value:
    """The value of a driver, or of a pose, in a plot [rad or m]; of many mechanisms side by side (n,)."""
    if fixes.kind == "slide":
        return plot.s[fixes.link]
    assert fixes.vector is not None
    value = np.angle(plot.arm(*fixes.vector))
    return wrapped(value - (np.angle(plot.arm(*fixes.from_vector)) if fixes.from_vector is not None else 0.0))


def _off(plot: Plot, given: _Given) -> float:
    """How far a plot is beyond what is given [rad or m]."""
    wanted = given.fixes.value
    assert wanted is not None
    off = float(value_of(plot, given.fixes)) - wanted
    return off if given.fixes.kind == "slide" else float(wrapped(off))


def _holds(plot: Plot, given: _Given) -> bool:
    return abs(_off(plot, given)) < (ROUNDED * extent(plot) if given.fixes.kind == "slide" else ROUNDED)


def _told(given: _Given, off: float) -> tuple[str, str, str]:
    """What is said, what holds, and how far they are apart, with units."""
    said, unit = given.fixes.value or 0.0, EDGE[driven(given.fixes.kind == "slide")]
    return unit.shown(said), unit.shown(said + off), unit.shown(abs(off))
