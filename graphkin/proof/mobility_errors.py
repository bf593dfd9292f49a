"""Why a mechanism has no definite motion: drivers too few, too many, or two on one freedom."""

from __future__ import annotations

from graphkin.analytic import mobility
from graphkin.errors import GraphkinError, JoinedToNothing, RepeatedDriver, TooFewDrivers, TooManyDrivers
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Rod

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
        if loose := _loose(mechanism, found.free):
            (owner,) = mechanism.owners[loose[0]]
            where = mechanism.where(FRAME, loose[0]) if owner == FRAME else mechanism.where("links", owner)
            return JoinedToNothing(where, called, found.freedoms, count, loose)
        return TooFewDrivers(mechanism.where("driver", last), called, found.freedoms, count)
    if found.redundant:
        name = mechanism.drivers[which].name
        return RepeatedDriver(mechanism.where("driver", which), called, found.freedoms, name)
    return None


def _loose(mechanism: Mechanism, free: tuple[str, ...]) -> tuple[str, ...]:
    """Points that join nothing: of the frame those that no pair uses, of free links those that hang on one joint."""
    used = {point for pair in mechanism.pairs for _, point, _ in pair.circles}
    for pair in mechanism.pairs:
        used |= {point for line in pair.lines for point in (line.origin, *(line.base or ()))}
        used |= {*pair.equivalent.points} if isinstance(pair.equivalent, Rod) else set()
    alone = {point for point, owners in mechanism.owners.items() if len(owners) == 1}
    hanging = [link for link in free if _joints(mechanism, link) < 2]
    return tuple(point for link in (FRAME, *hanging) for point in mechanism.named(link)
                 if point in alone and (link != FRAME or point not in used))  # fmt: skip


def _joints(mechanism: Mechanism, link: str) -> int:
    """The number of hinges and pairs that join a link to others."""
    hinges = sum(link in hinge.links for hinge in mechanism.hinges)
    return hinges + sum(link in pair.joins for pair in mechanism.pairs)
