"""Why a mechanism has no definite motion: drivers too few, too many, or two on one freedom."""

from __future__ import annotations

from graphkin.analytic import mobility
from graphkin.errors import GraphkinError, RepeatedDriver, TooFewDrivers, TooManyDrivers
from graphkin.mechanism import Mechanism

__all__ = ["wrong_drivers"]


def wrong_drivers(mechanism: Mechanism) -> GraphkinError | None:
    """The error that names the freedoms and the driver at fault; None where the drivers are right.

    Freedoms are counted by rank, so a constraint that repeats others and is met is no error.
    """
    found = mobility(mechanism)
    if found.freedoms is None:
        return None
    called = tuple(mechanism.called(link) for link in found.free)
    count, last = len(mechanism.drivers), len(mechanism.drivers) - 1
    which = found.redundant[0] if found.redundant else last
    if count > found.freedoms:
        name = mechanism.drivers[which].name
        return TooManyDrivers(mechanism.where("driver", which), found.freedoms, count, name)
    if count < found.freedoms and found.gap_mm is None:
        return TooFewDrivers(mechanism.where("driver", last), called, found.freedoms, count)
    if found.redundant:
        name = mechanism.drivers[which].name
        return RepeatedDriver(mechanism.where("driver", which), called, found.freedoms, name)
    return None
