"""Quantities over many positions: what `ask` can name, as one series each."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

import numpy as np

from graphkin.centres import centre_of
from graphkin.errors import UnknownQuantity, Where
from graphkin.geometry import Value, dot
from graphkin.loading.questions import refuse_misnamed
from graphkin.mechanism import FRAME, Mechanism
from graphkin.motions import Motions
from graphkin.naming import seen
from graphkin.readings import answer
from graphkin.value import frozen

__all__ = ["Series", "asked", "series", "split"]


@frozen
class Series:
    """One quantity over positions.

    name    as `ask` writes it
    unit    SI: "rad", "rad/s", "rad/s^2", "m", "m/s", "m/s^2", "1"
    values  sizes or signed scalars (n,)
    vectors for velocities and accelerations, and the place of an instant centre: (n,) complex, else None
    along   for a point that a guide of the frame leads: the direction along which it counts as positive
    """

    name: str
    unit: str
    values: np.ndarray
    vectors: np.ndarray | None = None
    along: complex | None = None

    @property
    def is_place(self) -> bool:
        """Whether this is where an instant centre lies; at infinity that is infinite."""
        return self.unit == "m" and self.vectors is not None

    @property
    def signed(self) -> np.ndarray:
        """Along its guide for a point that a guide of the frame leads; else the values."""
        if self.along is None or self.vectors is None:
            return self.values
        return np.asarray(dot(self.along, self.vectors))


def split(text: str) -> list[str]:
    """The quantities of `--of`: between commas that a new one follows; `v B@guide,B@block` is one."""
    return [part.strip() for part in re.split(r",\s*(?=[a-z]\w* |P[\w@']+\s*(?:,|$))", text) if part.strip()]


def series(mechanism: Mechanism, motions: Motions, name: str, count: int) -> Series | None:
    """One quantity; None for a text that names none."""
    with np.errstate(divide="ignore", invalid="ignore"):
        found = answer(mechanism, motions, name)
    if found is None:
        return None
    vectors = None if found.vector is None else _row(found.vector, count)
    return Series(name, found.unit, _row(found.value, count), vectors, _guided(mechanism, name))


def _row(value: Value, count: int) -> np.ndarray:
    return np.array(np.broadcast_to(value, (count,)))


def _guided(mechanism: Mechanism, name: str) -> complex | None:
    """The direction of the frame's guide on which the point of `v C` or `a C` stays."""
    quantity, _, of = name.partition(" ")
    site = seen(mechanism, of.strip()) if quantity in ("v", "a") and "/" not in name else None
    if site is None:
        return None
    for slide in mechanism.slides:
        block = () if slide.block is None else mechanism.links[slide.block].points
        if slide.guide == FRAME and not site.explicit and (site.point == slide.point or site.point in block):
            return slide.line.direction
    return None


def asked(mechanism: Mechanism, names: Sequence[str] = ()) -> tuple[str, ...]:
    """The quantities of a sweep: those named, else what the file asks, else of every link and every named slide.

    Raises UnknownQuantity, UnknownLink, UnknownPoint, UnknownSlide for names that mean nothing.
    """
    from graphkin.analytic import motion

    still = motion(mechanism)
    for name in names:
        _refuse_unknown(mechanism, still, name)
    usual = names or [
        name for name in mechanism.ask
        if answer(mechanism, still, name) is not None or centre_of(mechanism, name) is not None
    ]  # fmt: skip
    return tuple(dict.fromkeys(usual or _everything(mechanism)))


def _refuse_unknown(mechanism: Mechanism, still: Motions, name: str) -> None:
    where = Where("--of")
    refuse_misnamed(mechanism, name, where)
    if answer(mechanism, still, name) is None and centre_of(mechanism, name) is None:
        raise UnknownQuantity(where, name, ())


def _everything(mechanism: Mechanism) -> Iterable[str]:
    driven = {driver.link for driver in mechanism.drivers if driver.kind != "slide" and driver.from_vector is None}
    links = [link for link in mechanism.moving if link not in driven] or list(mechanism.moving)
    for quantity in ("theta", "omega", "alpha"):
        yield from (f"{quantity} {link}" for link in links)
