"""What the instant centres alone tell of all links: exact motions, ratios, mechanical advantage."""

from __future__ import annotations

from math import isfinite

from graphkin.model.mechanism import FRAME
from graphkin.studies.centres.instant_centres import Centres
from graphkin.studies.centres.levers import Levers


def carried_through(found: Centres, scale: float = 0.0) -> Levers:
    """The motions of all links that levers reach, from the first driver that moves. scale: as of `Levers`."""
    levers = Levers(found, scale)
    drivers = levers.mechanism.drivers
    levers.start(next((driver for driver in drivers if driver.rate), drivers[0]))
    for link in levers.mechanism.moving:
        levers.along(levers.path(link) or [])
    return levers


def advantages(found: Centres) -> dict[str, float]:
    """Mechanical advantage of each link that turns with a frame hinge: its torque by the driver's, without losses.

    Power in is power out, so it is omega of the driver by omega of the link: P1j Pij / P1i Pij turned over. Empty
    where the driver does not turn.
    """
    levers, mechanism = carried_through(found), found.method.mechanism
    driver = next((d for d in mechanism.drivers if d.rate), mechanism.drivers[0])
    if driver.kind == "slide" or driver.from_link != FRAME or not isfinite(levers.omega(driver.link)):
        return {}
    hinged = {link for hinge in mechanism.hinges if FRAME in hinge.links for link in hinge.links} - {FRAME, driver.link}
    omega = {link: levers.omega(link) for link in mechanism.moving if link in hinged}
    least = 1e-9 * abs(driver.rate or 1.0)
    return {link: levers.omega(driver.link) / rate for link, rate in omega.items() if abs(rate) > least}
