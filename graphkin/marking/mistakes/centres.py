"""Mistakes with ratios of rotations: instant centres upside down, from wrong pairs, or as at rest; wheels on an arm."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, combinations, product

import numpy as np

from graphkin.base.geometry import Value, cross, number, place
from graphkin.construction import Meet, Simultaneous
from graphkin.marking.hand import Redrawing
from graphkin.marking.rewrite import Change, Edit, Rewrite, RewrittenValue, Times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Centre, Moving, Quotient, Rotation
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import in_step
from graphkin.planning.stages import Group, Mesh

REST = 1e-9  # what counts as nothing, as part of the largest of its kind


@mistake("centre-ratio", "centre", "3-2.2")
def centre_ratio(scene: Scene) -> Iterator[Rewrite]:
    """omega_k = omega_i P0iPik / P0kPik upside down, or with the other sense; a centre from wrong pairs of lines."""
    for quantity in scene.quantities:
        if isinstance(quantity, Centre):
            yield from _wrong_pairs(scene, quantity)
        elif isinstance(quantity, Quotient):
            if not all(isinstance(half, Rotation) and half.word == "omega" for half in quantity.halves):
                continue
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


def _ratio(of: str, form: str, written: RewrittenValue, way: str = "") -> Rewrite:
    return Rewrite("centre-ratio", of, form, asked=(written,), way=way)


def _wrong_pairs(scene: Scene, quantity: Centre) -> Iterator[Rewrite]:
    """P_ij where lines cross that do not both hold it: of each four links the two other pairs of lines."""
    links = [FRAME, *scene.method.mechanism.moving]
    i, j = quantity.links
    called = scene.method.mechanism.called
    for k, m in combinations([link for link in links if link not in (i, j)], 2):
        for first, second in ((((i, k), (j, m)), ((i, m), (j, k))), (((i, k), (i, m)), ((j, k), (j, m)))):
            crossing = _crossing(*(_place(scene, pair) for pair in (*first, *second)))
            if np.isfinite(crossing):
                form = " × ".join("".join(f"P{called(a)}{called(b)}" for a, b in lines) for lines in (first, second))
                yield _ratio(quantity.text, form, RewrittenValue(quantity.text, instead=crossing), "lines")


def _place(scene: Scene, links: tuple[str, str]) -> complex:
    return complex(Centre("P", "", links).place(scene.motions))


def _crossing(a: complex, b: complex, c: complex, d: complex) -> complex:
    """The crossing of the lines ab and cd; infinite where that says nothing."""
    if not all(np.isfinite(corner) for corner in (a, b, c, d)):
        return complex(np.inf)
    u, w = b - a, d - c
    sine = number(cross(u, w))
    if abs(sine) < REST * abs(u) * abs(w) or not sine:
        return complex(np.inf)
    return a + u * number(cross(c - a, w)) / sine


@mistake("centre-acceleration-zero", "centre", "3-2.2")
def acceleration_zero(scene: Scene) -> Iterator[Rewrite]:
    """Points turned about the instant centre as if that were at rest; a contact or special point taken so."""
    for quantity in scene.quantities:
        if isinstance(quantity, Moving) and quantity.word == "a" and quantity.seen_from is None:
            for link in scene.links_of(quantity.site):
                centre = _place(scene, (FRAME, link))
                motions = scene.motions
                with np.errstate(invalid="ignore"):
                    arm = motions.position[quantity.site.point] - centre
                    vector = complex((1j * motions.alpha[link] - motions.omega[link] ** 2) * arm)
                if np.isfinite(vector):
                    form = f"P{scene.method.mechanism.frame}{scene.method.mechanism.called(link)}"
                    instead = (RewrittenValue(quantity.text, instead=vector),)
                    yield Rewrite("centre-acceleration-zero", quantity.text, form, asked=instead)
    for step in scene.steps("acceleration"):
        if not isinstance(step, Meet):
            continue
        node = scene.method.acceleration.nodes[step.point]
        site, fastest = node.site, max(abs(place(v)) for v in scene.plot.velocity.values())
        if site is None or site.link not in scene.motions.velocities or site.point not in scene.plot.position:
            continue
        if abs(place(scene.motions.velocity_at(site.point, site.link))) < REST * fastest:
            edits = (Edit(("met", "acceleration", step.point), Times(0.0)),)
            yield Rewrite("centre-acceleration-zero", f"a_{node.of}", "", edits, way="point")


# --- wheels on an arm --------------------------------------------------------------------------


@mistake("arm-ignored", "wheels", "11-2")
def arm_ignored(scene: Scene) -> Iterator[Rewrite]:
    """omega_a / omega_b = -r_b / r_a with the wheels' own rotations, though the arm that bears them turns. At one
    contact, or at all; the wheels after it turn as their own contacts then have it. Where wheels and arm are found
    together, the law of the contact is put into the equations without the arm."""
    contacts = []  # those on an arm that give the rotation of a wheel, after that wheel
    for stage in scene.method.stages:
        if isinstance(stage, Mesh) and stage.angle and stage.contact.arm:
            wheel = next((w for w in stage.contact.wheels if scene.turns_with(w, stage.angle)), "")
            if wheel and not scene.turns_with(wheel, stage.contact.arm):
                contacts.append((wheel, stage.contact))
    wrong = [k for k, (_, contact) in enumerate(contacts) if _matters(scene, contact)]
    for k in wrong:
        yield _ignoring(scene, contacts, {k})
    if len(wrong) > 1:
        yield _ignoring(scene, contacts, set(wrong))
    together = dict(_found_together(scene))
    for name, edits in together.items():
        yield Rewrite("arm-ignored", name, edits=edits)
    if len(together) > 1:
        yield Rewrite("arm-ignored", ", ".join(together), edits=tuple(chain(*together.values())))


def _found_together(scene: Scene) -> Iterator[tuple[str, tuple[Edit, ...]]]:
    """Contacts on an arm in groups whose rotations several equations give, by the wheels that these give; those with a
    driven wheel last, which alone give the other one."""

    def driven_wheel(contact: Contact) -> str | None:
        return next((wheel for wheel in contact.wheels if wheel != FRAME and scene.driven(wheel)), None)

    contacts = [c for stage in scene.method.stages if isinstance(stage, Group) for c in stage.contacts]
    for contact in sorted(contacts, key=lambda contact: driven_wheel(contact) is not None):
        wheels = [wheel for wheel in contact.wheels if not scene.driven(wheel)]
        borne = contact.arm and not any(scene.turns_with(wheel, contact.arm) for wheel in wheels)
        if wheels and borne and _matters(scene, contact):
            spots = (("rolling", plane, in_step(contact), contact.arm) for plane in ("velocity", "acceleration"))
            name = ", ".join(scene.rotation_name("omega", wheel) for wheel in wheels)
            edits = [Edit(spot, Times(0.0)) for spot in spots]
            # the ratio to a driven wheel, where velocities are drawn by the points of contact, which know no arm
            solved = (step for step in scene.steps("velocity") if isinstance(step, Simultaneous))
            if driven_wheel(contact) is not None and all(in_step(contact) not in step.contacts for step in solved):
                for wheel, quantity in product(wheels, ("omega", "alpha")):
                    edits.append(Edit(("settled", quantity, wheel), _by_contact(contact, wheel, quantity, contact.arm)))
            yield name, tuple(edits)


def _matters(scene: Scene, contact: Contact) -> bool:
    return bool(scene.plot.omega[contact.arm] or scene.plot.alpha[contact.arm])


def _ignoring(scene: Scene, contacts: list[tuple[str, Contact]], wrong: set[int]) -> Rewrite:
    edits = tuple(
        Edit(("settled", quantity, wheel), _by_contact(contact, wheel, quantity, contact.arm if k in wrong else ""))
        for k, (wheel, contact) in enumerate(contacts)
        if k >= min(wrong)
        for quantity in ("omega", "alpha")
    )
    wheels = (contacts[k][0] for k in sorted(wrong))
    return Rewrite("arm-ignored", ", ".join(scene.rotation_name("omega", wheel) for wheel in wheels), edits=edits)


def _by_contact(contact: Contact, wheel: str, quantity: str, without: str) -> Change:
    """A wheel's rate as a contact gives it, from the rotations of all others of its links but one."""
    own = sum(c for link, c in contact.angles if link == wheel)

    def change(plot: Redrawing, right: Value) -> Value:
        table: dict[str, Value] = getattr(plot, quantity)
        return -sum(c * table[link] for link, c in contact.angles if link not in (wheel, without)) / own + 0 * right

    return change
