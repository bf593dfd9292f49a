"""The runner: a method over driver values.

`replay_all` carries a method out, at the drawn position or at any others. How a mechanism gets there is `path`: driver
values along a line, with the dead points where it ends and the change points that it goes through. `tracing` finds
them: it looks along the whole path in small steps, or follows it where links are fitted (`continuation`);
`singularities` looks closely where two loci come to touch. `other_positions` takes a mechanism to other positions,
many of them at once by a program made of the steps: a `recorder` notes on a `tape` each real operation of one replay,
and a `replay_program` carries them out, as NumPy calls or as a C function.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.base.geometry import Real
from graphkin.construction import Plot, replay
from graphkin.errors import ValueForEach
from graphkin.planning import Method
from graphkin.planning.refusals import refuse_bad_positions, refuse_contacts_apart

__all__ = ["driver_values", "replay_all"]


def driver_values(method: Method) -> Iterator[tuple[float, ...]]:
    """The drawn position, then one for each value of `also`: drivers that list several move on together."""
    drivers = method.drivers
    for k in range(-1, max((len(driver.also) for driver in drivers), default=0)):
        yield tuple(d.also[k] if 0 <= k < len(d.also) else (d.value or 0.0) for d in drivers)


def replay_all(method: Method, values: Sequence[Real] | None = None, compiled: bool | None = None) -> Plot:
    """All three constructions at the drawn position, or at `values`: one entry a driver, scalar or (n,) [rad, m];
    `compiled`: as `ReplayProgram.run` has it. A single position that is a dead point, or that is not reached from the
    drawn one without passing a dead point, raises; in arrays such positions are what the crossings give, or NaN, and
    `Plot.sines` tells how near each position is to a dead point."""
    if values is None:
        return _with_polygons(method, replay(method.position, Plot(method.facts(), method.near)))
    drivers = method.drivers
    if len(values) != len(drivers):
        raise ValueForEach(method.mechanism.where("driver"), len(values), tuple(driver.name for driver in drivers))
    # loaded where a mechanism is moved: the sheet of the drawn position starts sooner without
    from graphkin.running import other_positions

    if (plot := other_positions.by_program(method, values, compiled=compiled)) is not None:
        return plot
    if (course := other_positions.on_one_path(method, values)) is not None:
        return other_positions.replay_along(method, *course, compiled=compiled)
    return _with_polygons(method, other_positions.moved_to(method, values))


def _with_polygons(method: Method, plot: Plot) -> Plot:
    """The polygons to positions, which must be fit to be drawn."""
    refuse_bad_positions(method.structure, method.position, plot)
    refuse_contacts_apart(method.mechanism, method.structure.contacts, plot)
    return replay(method.acceleration, replay(method.velocity, plot))
