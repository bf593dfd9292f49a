"""A method carried out: all three constructions, at the drawn position or at driver values."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.base.geometry import Value
from graphkin.construction import Plot, replay
from graphkin.errors import ValueForEach
from graphkin.planning.method import Method
from graphkin.planning.refusals import refuse_bad_positions, refuse_contacts_apart


def replay_all(method: Method, values: Sequence[Value] | None = None, compiled: bool | None = None) -> Plot:
    """All three constructions at the drawn position, or at `values`: one entry a driver, scalar or (n,) [rad, m];
    `compiled`: as `ReplayProgram.run` has it.

    A single position that is a dead point, or that is not reached from the drawn one without passing a dead
    point, raises; in arrays such positions are what the crossings give, or NaN, and `Plot.sines` tells how near
    each position is to a dead point.
    """
    if values is None:
        return _finished(method, replay(method.position, Plot(method.facts(), method.near)))
    drivers = method.drivers
    if len(values) != len(drivers):
        raise ValueForEach(method.mechanism.where("driver"), len(values), tuple(driver.name for driver in drivers))
    # loaded where a mechanism is moved: the sheet of the drawn position starts sooner without
    from graphkin.running.many_positions import by_program, replay_along
    from graphkin.running.reaching import moved_to, on_one_way

    if (found := by_program(method, values, compiled=compiled)) is not None:
        return found
    way = on_one_way(method, values)
    return _finished(method, moved_to(method, values)) if way is None else replay_along(method, *way, compiled=compiled)


def _finished(method: Method, plot: Plot) -> Plot:
    """The polygons to positions, which must be fit to be drawn."""
    refuse_bad_positions(method.structure, method.position, plot)
    refuse_contacts_apart(method.mechanism, method.structure.contacts, plot)
    return replay(method.acceleration, replay(method.velocity, plot))
