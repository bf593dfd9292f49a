"""Mistakes with instant centres: ratios upside down, lines of the wrong pairs, and a = 0 where only v is."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from graphkin.base.geometry import Value, cross
from graphkin.construction import Meet
from graphkin.marking.rewrite import Edit, Rewrite, RewrittenValue, times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Centre, Moving, Quotient, Rotation

__all__: list[str] = []

REST = 1e-9
"""What counts as nothing, as part of the largest of its kind."""


@mistake("centre-ratio", "centre", "3-2.2")
def centre_ratio(scene: Scene) -> Iterator[Rewrite]:
    """omega_k = omega_i P0iPik / P0kPik upside down, or with the other sense; a centre from wrong pairs of lines."""
    for quantity in scene.quantities:
        if isinstance(quantity, Centre):
            yield from _wrong_pairs(scene, quantity)
        elif isinstance(quantity, Quotient) and _of_rotations(quantity):
            value = complex(quantity.answer(scene.motions).value)
            if value and np.isfinite(value):
                yield _ratio(quantity.text, "", RewrittenValue(quantity.text, instead=1 / value))
                yield _ratio(quantity.text, "", RewrittenValue(quantity.text, -1.0), "sense")
        elif isinstance(quantity, Rotation) and quantity.word == "omega":
            value = float(scene.motions.omega[quantity.link])
            fastest = max(abs(float(omega)) for omega in scene.motions.omega.values())
            if abs(value) <= REST * fastest:
                continue
            for crank in (link for link in scene.cranks if link != quantity.link):
                driven = float(scene.motions.omega[crank])
                text = f"ω{scene.method.mechanism.called(crank)}"
                yield _ratio(quantity.text, text, RewrittenValue(quantity.text, instead=driven**2 / value))
            yield _ratio(quantity.text, "", RewrittenValue(quantity.text, -1.0), "sense")


def _of_rotations(quantity: Quotient) -> bool:
    return all(isinstance(half, Rotation) and half.word == "omega" for half in quantity.halves)


def _ratio(of: str, form: str, written: RewrittenValue, way: str = "") -> Rewrite:
    return Rewrite("centre-ratio", of, form, asked=(written,), way=way)


def _wrong_pairs(scene: Scene, quantity: Centre) -> Iterator[Rewrite]:
    """P_ij where lines cross that do not both hold it: of each four links the two other pairs of lines."""
    links = [FRAME, *scene.method.mechanism.moving]
    i, j = quantity.links
    called = scene.method.mechanism.called
    for k, m in combinations([link for link in links if link not in (i, j)], 2):
        for first, second in ((((i, k), (j, m)), ((i, m), (j, k))), (((i, k), (i, m)), ((j, k), (j, m)))):
            place = _crossing(*(_place(scene, pair) for pair in (*first, *second)))
            if np.isfinite(place):
                form = " × ".join("".join(f"P{called(a)}{called(b)}" for a, b in lines) for lines in (first, second))
                yield _ratio(quantity.text, form, RewrittenValue(quantity.text, instead=place), "lines")


def _place(scene: Scene, links: tuple[str, str]) -> complex:
    return complex(Centre("P", "", links).place(scene.motions))


def _crossing(a: complex, b: complex, c: complex, d: complex) -> complex:
    """Where the lines ab and cd cross; infinite where that says nothing."""
    if not all(np.isfinite(place) for place in (a, b, c, d)):
        return complex(np.inf)
    u, w = b - a, d - c
    sine = cross(u, w)
    return complex(np.inf) if abs(sine) < REST * abs(u) * abs(w) or not sine else a + u * cross(c - a, w) / sine


@mistake("centre-acceleration-zero", "centre", "3-2.2")
def acceleration_zero(scene: Scene) -> Iterator[Rewrite]:
    """Points turned about the instant centre as if that were at rest; a contact or special point taken so."""
    for quantity in scene.quantities:
        if isinstance(quantity, Moving) and quantity.word == "a" and quantity.seen_from is None:
            for link in scene.links_of(quantity.site):
                place = _place(scene, (FRAME, link))
                vector = _about(scene.motions, quantity.site.point, link, place)
                if np.isfinite(vector):
                    form = f"P{scene.method.mechanism.frame}{scene.method.mechanism.called(link)}"
                    instead = (RewrittenValue(quantity.text, instead=vector),)
                    yield Rewrite("centre-acceleration-zero", quantity.text, form, asked=instead)
    for _, step in scene.steps("acceleration"):
        if isinstance(step, Meet) and _stands(scene, step.point):
            edits = (Edit(("met", "acceleration", step.point), times(0.0)),)
            of = f"a_{scene.method.acceleration.nodes[step.point].of}"
            yield Rewrite("centre-acceleration-zero", of, "", edits, way="point")


def _about(motions: Motions, point: str, link: str, place: complex) -> complex:
    """Acceleration of a point that turns with a link about a place at rest."""
    with np.errstate(invalid="ignore"):
        turned: Value = (1j * motions.alpha[link] - motions.omega[link] ** 2) * (motions.position[point] - place)
    return complex(turned)


def _stands(scene: Scene, node: str) -> bool:
    """Whether a corner is a point whose velocity is nothing."""
    site = scene.method.acceleration.nodes[node].site
    if site is None or site.link not in scene.motions.velocities or site.point not in scene.plot.position:
        return False
    fastest = max(abs(v) for v in scene.plot.velocity.values())
    return bool(abs(scene.motions.velocity_at(site.point, site.link)) < REST * fastest)
