"""Mistakes with wheels: the arm's rotation left out of the ratio."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, product

from graphkin.base.geometry import Value
from graphkin.construction import Simultaneous
from graphkin.marking.hand import Redrawing
from graphkin.marking.rewrite import Change, Edit, Rewrite, times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import in_step
from graphkin.planning.stages import Group, Mesh

__all__: list[str] = []


@mistake("arm-ignored", "wheels", "11-2")
def arm_ignored(scene: Scene) -> Iterator[Rewrite]:
    """omega_a / omega_b = -r_b / r_a with the wheels' own rotations, though the arm that bears them turns.

    At one contact, or at all; the wheels after it turn as their own contacts then have it. Where wheels and arm are
    found together, the law of the contact is put into the equations without the arm.
    """
    contacts = list(_contacts(scene))
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
    contacts = [c for stage in scene.method.stages if isinstance(stage, Group) for c in stage.contacts]
    for contact in sorted(contacts, key=lambda contact: _driven_wheel(scene, contact) is not None):
        wheels = [wheel for wheel in contact.wheels if not scene.driven(wheel)]
        borne = contact.arm and not any(scene.turns_with(wheel, contact.arm) for wheel in wheels)
        if wheels and borne and _matters(scene, contact):
            spots = (("rolling", plane, in_step(contact), contact.arm) for plane in ("velocity", "acceleration"))
            name = ", ".join(scene.rotation_name("omega", wheel) for wheel in wheels)
            yield name, (*(Edit(spot, times(0.0)) for spot in spots), *_at_once(scene, contact, wheels))


def _at_once(scene: Scene, contact: Contact, wheels: list[str]) -> Iterator[Edit]:
    """The ratio to a driven wheel, where velocities are drawn by the points of contact, which know no arm."""
    solved = (step for _, step in scene.steps("velocity") if isinstance(step, Simultaneous))
    if _driven_wheel(scene, contact) is not None and all(in_step(contact) not in step.contacts for step in solved):
        for wheel, quantity in product(wheels, ("omega", "alpha")):
            yield Edit(("settled", quantity, wheel), _turned(contact, wheel, quantity, contact.arm))


def _driven_wheel(scene: Scene, contact: Contact) -> str | None:
    return next((wheel for wheel in contact.wheels if wheel != FRAME and scene.driven(wheel)), None)


def _contacts(scene: Scene) -> Iterator[tuple[str, Contact]]:
    """Every contact on an arm that gives the rotation of a wheel, after that wheel."""
    for stage in scene.method.stages:
        if isinstance(stage, Mesh) and stage.angle and stage.contact.arm:
            wheel = next((w for w in stage.contact.wheels if scene.turns_with(w, stage.angle)), "")
            if wheel and not scene.turns_with(wheel, stage.contact.arm):
                yield wheel, stage.contact


def _matters(scene: Scene, contact: Contact) -> bool:
    return bool(scene.plot.omega[contact.arm] or scene.plot.alpha[contact.arm])


def _ignoring(scene: Scene, contacts: list[tuple[str, Contact]], wrong: set[int]) -> Rewrite:
    edits = tuple(
        Edit(("settled", quantity, wheel), _turned(contact, wheel, quantity, contact.arm if k in wrong else ""))
        for k, (wheel, contact) in enumerate(contacts)
        if k >= min(wrong)
        for quantity in ("omega", "alpha")
    )
    wheels = (contacts[k][0] for k in sorted(wrong))
    return Rewrite("arm-ignored", ", ".join(scene.rotation_name("omega", wheel) for wheel in wheels), edits=edits)


def _turned(contact: Contact, wheel: str, quantity: str, without: str) -> Change:
    """What a contact gives a wheel, from the rotations of all others of its links but one."""
    own = sum(c for link, c in contact.angles if link == wheel)

    def change(plot: Redrawing, right: Value) -> Value:
        table: dict[str, Value] = getattr(plot, quantity)
        return -sum(c * table[link] for link, c in contact.angles if link not in (wheel, without)) / own + 0 * right

    return change
