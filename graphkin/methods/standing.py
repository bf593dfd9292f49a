"""How a mechanism stands at the drawn position: its poses and its drivers' values, and where rolling counts from.

Nothing rolls there. What repeats what is known already is no error, as long as it says the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.errors import CannotAssemble, DeadPoint, NotPlaced, PosesDiffer, Where
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.methods.assembly import assemble, extent, refuse_open
from graphkin.methods.drawn import facts_of, with_sides
from graphkin.methods.position import position
from graphkin.methods.repeated import SetAside, as_aside, still_repeated
from graphkin.methods.stages import stages
from graphkin.methods.structure import Structure
from graphkin.steps import Plot, replay, slide_key
from graphkin.value import frozen

__all__ = ["as_drawn"]

Repeats = tuple[SetAside, ...]

SAME = 1e-6
"""Values that differ by less say the same [rad, mechanism's size]: figures in files are rounded."""


@frozen
class _Given:
    """A driver's value or a pose: what it fixes, as a driver, and where the file says so."""

    fixes: Driver
    posed: bool
    where: Where


def as_drawn(
    mechanism: Mechanism, lower: Mechanism, repeats: Repeats = ()
) -> tuple[dict[str, float], Mechanism]:
    """Angles and displacements at the drawn position, from which rolling counts, and the drivers with all their values.

    repeats  what repeats other constraints when all moves; here only where it does so though nothing rolls

    Raises NotPlaced where values and poses leave something open, PosesDiffer where they do not fit together.
    """
    structure, plot = _standing(mechanism, lower, repeats)
    drawn = {link: float(plot.theta[link]) if link in plot.theta else 0.0 for link in structure.bodies}
    drawn |= {slide_key(slide): float(value) for slide, value in plot.s.items()}
    sketch = {**lower.sketch, **{p: complex(z) for p, z in plot.position.items() if p[0].isupper()}}
    drivers = tuple(_valued(driver, plot, drawn) for driver in mechanism.drivers)
    return drawn, replace(lower, drivers=drivers, sketch=sketch)


def _valued(driver: Driver, plot: Plot, drawn: Mapping[str, float]) -> Driver:
    """A driver whose value a pose has fixed, with that value."""
    if driver.kind == "slide":
        return driver if driver.value is not None else replace(driver, value=drawn[slide_key(driver.link)])
    if driver.kind == "spin":
        return replace(driver, value=drawn[driver.link])
    return driver if driver.value is not None else replace(driver, value=_value(plot, driver))


# --- what is given ----------------------------------------------------------------------------


def _standing(mechanism: Mechanism, lower: Mechanism, repeats: Repeats) -> tuple[Structure, Plot]:
    """All that is given taken together; where that does not close, without the poses that the rest gives as well."""
    given = tuple(_given(mechanism))
    try:
        structure, plot = _placed(mechanism, lower, given, repeats)
    except (CannotAssemble, DeadPoint):
        return _without_repeats(mechanism, lower, given, repeats)
    if all(abs(_off(plot, each)) < _same(plot, each) for each in given):
        return structure, plot
    return _without_repeats(mechanism, lower, given, repeats)


def _given(mechanism: Mechanism) -> Iterator[_Given]:
    for k, driver in enumerate(mechanism.drivers):
        if driver.value is not None and driver.kind != "spin":
            yield _Given(driver, False, mechanism.where("driver", k))
    for k, pose in enumerate(mechanism.poses):
        fixes = Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)
        yield _Given(fixes, True, mechanism.where("pose", k))


def _without_repeats(
    mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats
) -> tuple[Structure, Plot]:
    """The mechanism placed by what is needed; the poses that repeat it must say the same."""
    needed = _needed(mechanism, lower, given, repeats)
    structure, plot = _placed(mechanism, lower, needed, repeats)
    for each in given:
        if each not in needed and abs(off := _off(plot, each)) >= _same(plot, each):
            others = tuple(other.where for other in _beside(structure, each, needed))
            raise PosesDiffer(each.where, each.fixes.name, *_told(each, off), others)
    return structure, plot


def _needed(mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats) -> tuple[_Given, ...]:
    """What is given, less the poses (the last first) without which all links are placed as well."""
    needed = given
    for each in reversed([each for each in given if each.posed]):
        fewer = tuple(other for other in needed if other is not each)
        if not _left(_with(mechanism, lower, fewer, repeats)):
            needed = fewer
    return needed


def _beside(structure: Structure, given: _Given, needed: Sequence[_Given]) -> list[_Given]:
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


def _placed(
    mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats
) -> tuple[Structure, Plot]:
    """The mechanism put together by these values."""
    structure = _with(mechanism, lower, given, repeats)
    if names := _left(structure):
        raise NotPlaced(mechanism.where("links", names[0]), tuple(mechanism.called(name) for name in names))
    construction, choices = position(structure, stages(structure)[0])
    facts = facts_of(structure, None, {})
    found = assemble(structure, construction, choices, facts, {})
    plot = replay(with_sides(construction, found.sides), Plot(facts, found.near))
    refuse_open(structure, plot, SAME)
    return structure, plot


def _with(mechanism: Mechanism, lower: Mechanism, given: tuple[_Given, ...], repeats: Repeats) -> Structure:
    """The mechanism with these values; wheels that nothing turns and that show no direction stand at 0."""
    drivers = tuple(each.fixes for each in given)
    structure = Structure(replace(lower, drivers=drivers))
    structure = replace(structure, aside=as_aside(still_repeated(structure, repeats)))
    plain: dict[str, str] = {}
    for body in structure.bodies:
        if structure.base(body) != FRAME and _shows_nothing(mechanism, structure, body):
            plain.setdefault(structure.base(body), body)
    marked = tuple(Driver("spin", body, value=0.0) for body in plain.values())
    return replace(structure, mechanism=replace(lower, drivers=(*drivers, *marked)))


def _shows_nothing(mechanism: Mechanism, structure: Structure, body: str) -> bool:
    """Whether one cannot see how a wheel stands: it hangs on its centre alone, and has no other point."""
    wheels = {wheel for gear in mechanism.gears for wheel in gear.joins}
    wheels |= {wheel for roll in mechanism.rolls for wheel in roll.joins}
    spun = {driver.link for driver in mechanism.drivers if driver.kind == "spin"}
    joints = list(structure.joints(body))
    if body not in wheels | spun or len(joints) > 1:
        return False
    places = set(structure.shapes[body].values())
    return len(places) == 1 or body in spun


def _left(structure: Structure) -> tuple[str, ...]:
    """The links that nothing places, those first whose direction is open."""
    left = stages(structure)[1]
    turning = [body for body in left if structure.base(body) != FRAME]
    homes = dict.fromkeys(structure.home(body) for body in turning or left)
    return tuple(name for name in homes if " " not in name)


# --- comparing --------------------------------------------------------------------------------


def _value(plot: Plot, fixes: Driver) -> float:
    """What a driver's value is in a plot [rad or m]."""
    if fixes.kind == "slide":
        return float(plot.s[fixes.link])
    assert fixes.vector is not None
    value = float(np.angle(plot.arm(*fixes.vector)))
    return value - (float(np.angle(plot.arm(*fixes.from_vector))) if fixes.from_vector is not None else 0.0)


def _off(plot: Plot, given: _Given) -> float:
    """How far a plot is beyond what is given [rad or m]."""
    wanted = given.fixes.value
    assert wanted is not None
    off = _value(plot, given.fixes) - wanted
    return off if given.fixes.kind == "slide" else float(np.angle(np.exp(1j * off)))


def _same(plot: Plot, given: _Given) -> float:
    return SAME * extent(plot) if given.fixes.kind == "slide" else SAME


def _told(given: _Given, off: float) -> tuple[str, str, str]:
    """What is said, what holds, and how far they are apart, with units."""
    said, unit, scale = given.fixes.value or 0.0, "°", 180 / np.pi
    if given.fixes.kind == "slide":
        unit, scale = " mm", 1000.0
    said_text, holds, apart = (f"{value * scale:.6g}{unit}" for value in (said, said + off, abs(off)))
    return said_text, holds, apart
