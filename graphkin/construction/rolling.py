"""Rolling contacts: wheels that turn in step, as one linear condition each."""

from __future__ import annotations

from graphkin.base.geometry import Value
from graphkin.construction.kinds import InStep, Roll
from graphkin.construction.linear import Row
from graphkin.construction.plot import Plot, slide_key
from graphkin.construction.terms import Plane


def roll(step: Roll, plot: Plot, plane: Plane) -> None:
    """The one unknown of a contact: coefficients times turns add up to nothing."""
    known, coefficients = in_step(step.contact, plot, plane, {step.angle} - {""}, {step.slide} - {""})
    value = -known / sum(coefficients.values())
    if step.angle:
        plot.settle(("theta", "omega", "alpha")[order_of(plane)], step.angle, value, counted=True)
    else:
        displacements(plot, plane)[step.slide] = value


def order_of(plane: Plane) -> int:
    return ("position", "velocity", "acceleration").index(plane)


def displacements(plot: Plot, plane: Plane) -> dict[str, Value]:
    """s of each slide, or its rate, or the rate of that."""
    return (plot.s, plot.s_rate, plot.s_acceleration)[order_of(plane)]


def in_step(contact: InStep, plot: Plot, plane: Plane, angles: set[str], slides: set[str]) -> Row:
    """A contact's coefficient for each unknown, by base link or `slide_key`, and the sum of the rest."""
    coefficients: dict[str, Value] = {}
    known: Value = 0.0
    for link, coefficient in contact.angles:
        base = plot.facts.turns[link].base
        if base in angles:
            coefficients[base] = coefficients.get(base, 0.0) + coefficient
        known = known + coefficient * _turned(link, plot, plane, base in angles)
    for slide, share in contact.way or ((contact.slide, 1.0),) * bool(contact.slide):
        coefficient = contact.on_slide * share
        drawn = plot.facts.drawn[slide_key(slide)] if plane == "position" else 0.0
        if slide in slides:
            coefficients[slide_key(slide)] = coefficients.get(slide_key(slide), 0.0) + coefficient
            known = known - coefficient * drawn
        else:
            known = known + coefficient * (displacements(plot, plane)[slide] - drawn)
    return known, coefficients


def _turned(link: str, plot: Plot, plane: Plane, beside_base: bool) -> Value:
    """What a link has turned since the drawn position, or its rate; `beside_base`: what its base link leaves."""
    order, facts = order_of(plane), plot.facts
    drawn = facts.drawn.get(link, 0.0) if order == 0 else 0.0
    if not beside_base:
        return (plot.theta, plot.omega, plot.alpha)[order][link] - drawn
    return (facts.relative_angle(link) if order == 0 else facts.relative_rate(link, order)) - drawn
