"""Rolling contacts as angle relations: r1 θ1 + r2 θ2 − (r1 + r2) θH = c, from the motion seen from the arm."""

from __future__ import annotations

from graphkin.analytic import Motion
from graphkin.base.value import frozen
from graphkin.equations.expressions import Sum, SymbolProduct, number, one
from graphkin.equations.polygons import LinkVectorMaker
from graphkin.equations.symbols import AngleSum, Symbol
from graphkin.planning.equivalent import Contact
from graphkin.say.catalogue import meaning


@frozen
class RollingSum:
    """sum = 0: what turns and slides, less the constant of the drawn position. `contact` is what rolls."""

    contact: Contact
    moving: Sum
    constant: Symbol

    @property
    def sum(self) -> Sum:
        return self.moving - one(self.constant)


def rolling(arrows: LinkVectorMaker, contact: Contact, drawn: Motion) -> RollingSum:
    """The relation of one contact; its constant is what the drawn position gives."""
    moving = _on_circles(arrows, contact) if contact.arm else _on_line(arrows, contact)
    entries = arrows.ledger.entries
    value = float(moving.at({symbol: entries[symbol].read(drawn) for symbol in moving.symbols}))
    names = [arrows.bodies.called(wheel) for wheel in contact.wheels]
    what = meaning("equations.rolling constant", first=names[0], second=names[1])
    constant = arrows.ledger.constant("c", "".join(names) if all(map(str.isdigit, names)) else names[1],
                                      what, "mm rad", value)  # fmt: skip
    return RollingSum(contact, moving, constant)


def _radius(arrows: LinkVectorMaker, wheel: str, radius: float) -> Symbol:
    """The radius of a wheel's circle, one letter for each size."""
    name, size = arrows.bodies.called(wheel), f"{radius * 1000:.12g}"
    if (name, size) not in arrows.radii:
        what = meaning("equations.radius", radius=size, wheel=name)
        arrows.radii[name, size] = arrows.ledger.constant("r", name, what, "mm", radius)
    return arrows.radii[name, size]


def _turning(angle: AngleSum) -> Sum:
    """What changes of an angle."""
    return Sum.of(SymbolProduct(float(count), ((symbol, 1),)) for symbol, count in angle.moving)


def _on_circles(arrows: LinkVectorMaker, contact: Contact) -> Sum:
    angles = [arrows.bodies.angles[wheel] for wheel in contact.wheels]
    arm = _turning(arrows.bodies.angles[contact.arm])
    total = Sum()
    for wheel, radius, angle in zip(contact.wheels, contact.radii, angles, strict=True):
        share = number(1.0 if radius > 0 else -1.0) * one(_radius(arrows, wheel, abs(radius)))
        total += share * (_turning(angle) - arm)
    return total


def _on_line(arrows: LinkVectorMaker, contact: Contact) -> Sum:
    """s + r (θ_wheel − θ_track) where the centre lies left of the line, s − r (..) where right.

    Where other pairs keep the centre on its way, s is made up of their displacements.
    """
    track, wheel = (_turning(arrows.bodies.angles[body]) for body in contact.wheels)
    radius = next(share for body, share in contact.angles if body == contact.wheels[1])
    turned = one(_radius(arrows, contact.wheels[1], radius)) * (wheel - track)
    gone = Sum()
    for slide, share in contact.way or ((contact.slide, 1.0),):
        gone += one(arrows.displacement(slide)).times(share * contact.on_slide)
    return gone + turned
