"""The wheels of a mechanism: the circles that roll, whatever pairs say so."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Gear, Pair, RollingContact


@frozen
class Wheel:
    """A circle that rolls: its link, centre and radius [m]; gear: its pitch circle is drawn, not its outline; ring: the
    others run inside it."""

    link: str
    centre: str
    radius: float
    gear: bool
    ring: bool = False


def wheels_of(machine: Mechanism) -> list[Wheel]:
    """Every wheel once: gears, then what rolls and what it rolls on. A ring stays a ring."""
    every: dict[tuple[str, str, float], Wheel] = {}
    for kind, rims_of in UNDER_LINKS.items():
        for wheel in (wheel for pair in machine.of(kind) for wheel in rims_of(machine, pair)):
            key = wheel.link, wheel.centre, round(wheel.radius, 12)
            same = every.get(key, wheel)
            every[key] = replace(wheel, gear=wheel.gear or same.gear, ring=wheel.ring or same.ring)
    return list(every.values())


def _gears(_: Mechanism, gear: Gear) -> Iterator[Wheel]:
    for link, centre, radius in gear.circles:
        yield Wheel(link, centre, radius, gear=True, ring=gear.internal and radius == max(gear.radii))


def _rolling(machine: Mechanism, roll: RollingContact) -> Iterator[Wheel]:
    """A wheel on a moving line is a pinion, unless it does nothing but roll there."""
    turning_inside = roll.internal and roll.track_radius < roll.radius
    held = len(machine.owners[roll.centre]) + sum(roll.wheel in pair.joins for pair in machine.of(RollingContact)) > 2
    rack = roll.line is not None and roll.track != FRAME and held
    yield Wheel(roll.wheel, roll.centre, roll.radius, gear=rack, ring=turning_inside)
    if roll.track_centre is not None:
        ring = roll.internal and not turning_inside
        yield Wheel(roll.track, roll.track_centre, roll.track_radius, gear=False, ring=ring)


UNDER_LINKS: Mapping[type[Pair], Callable[..., Iterator[Wheel]]] = {Gear: _gears, RollingContact: _rolling}
"""The wheels of the pairs whose signs stand under the links; see `sheet.mechanism_figure.OVER_LINKS`."""
