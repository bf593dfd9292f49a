"""Mistakes with ratios of rotations: instant centres upside down, from wrong pairs, or as at rest; wheels on an arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, product

import numpy as np

from graphkin.base.geometry import Value, cross, number, place
from graphkin.construction import Image, Meet, Plane, Simultaneous
from graphkin.marking.hand import Redrawing
from graphkin.marking.mistakes.link_motion import PLANES
from graphkin.marking.rewrite import Change, Edit, Rewrite, RewrittenValue, Times, each_and_all
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Centre, Moving, Quotient, Rotation
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import in_step
from graphkin.planning.stages import Group, Mesh

Law = Mapping[str, float]  # sum of coefficient * rate = 0
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
    yield from _ratios_of_radii(scene)


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


# --- wheels ------------------------------------------------------------------------------------


def _ratios_of_radii(scene: Scene) -> Iterator[Rewrite]:
    """Of two wheels upside down, or with the sense of wheels that touch from within where they do from without, or the
    other way round: at each contact that gives a rotation."""
    for contacts, bases in scene.rolling:
        for contact in contacts:
            wheels = contact.wheels
            if not contact.arm or contact.arm in wheels:
                continue
            moving = (wheel for wheel in wheels if any(scene.turns_with(wheel, base) for base in bases))
            of = ", ".join(scene.rotation_name("omega", wheel) for wheel in moving)
            form = ", ".join(map(scene.method.mechanism.called, wheels))
            one, other = (dict(contact.angles)[wheel] for wheel in wheels)
            ways = {"meshing": (one, -other), "radii": (np.copysign(other, one), np.copysign(one, other))}
            for way, (a, b) in ways.items():
                law = {wheels[0]: a, wheels[1]: b, contact.arm: -(a + b)}
                edits = _by_law(scene, contacts, bases, contact, law)
                if of and edits and abs(a - one) + abs(b - other) > REST * abs(one):
                    yield Rewrite("centre-ratio", of, form, edits, way=way)


def _by_law(
    scene: Scene, contacts: Sequence[Contact], bases: Sequence[str], contact: Contact, law: Law
) -> tuple[Edit, ...]:
    """Another law of one of some contacts: put into the equations that hold it; where none does, rotations as all laws
    together give them, and what is drawn of their links. Nothing where they do not."""
    turns, laws = scene.plot.facts.turns, [law if each is contact else dict(each.angles) for each in contacts]
    counts = np.array([[sum(c for w, c in one.items() if turns[w].base == base) for base in bases] for one in laws])
    given = len(laws) == len(bases) == np.linalg.matrix_rank(counts)
    edits: list[Edit] = []
    for plane, word in zip(PLANES, ("omega", "alpha"), strict=True):
        solved = (step for step in scene.steps(plane) if isinstance(step, Simultaneous))
        if any(in_step(contact) in step.contacts for step in solved):
            parts = ((link, Times(law.get(link, 0.0) / c)) for link, c in contact.angles)
            edits += (Edit(("rolling", plane, in_step(contact), link), change) for link, change in parts)
        elif not given:
            return ()
        else:
            shares = dict(zip(bases, np.linalg.inv(counts), strict=True))
            for link in (link for link, turn in turns.items() if turn.base in bases):
                change = _by_laws(laws, shares, link, word)
                edits.append(Edit(("settled", word, link), change))
                edits += (_as_it_turns(plane, step) for step in scene.images(plane).get(link, ()))
    return tuple(edits)


def _by_laws(laws: Sequence[Law], shares: Mapping[str, Sequence[float]], of: str, word: str) -> Change:
    """A rate as laws of contacts give it, which together give some unknown ones; shares: by the base of these, how much
    of what is known in each law counts."""

    def change(plot: Redrawing, right: Value) -> Value:
        table: dict[str, Value] = getattr(plot, word)
        turns, order = plot.facts.turns, 1 if word == "omega" else 2
        # of links that turn with unknown ones, by how much more is known
        known = {link: plot.facts.relative_rate(link, order) if turns[link].base in shares else table[link]
                 for law in (*laws, {of: 0.0}) for link in law}  # fmt: skip
        sums = (sum(c * known[link] for link, c in law.items()) for law in laws)
        each = zip(shares[turns[of].base], sums, strict=True)
        return known[of] - sum(share * total for share, total in each) + 0 * right

    return change


def _as_it_turns(plane: Plane, step: Image) -> Edit:
    """A point found by image where its link's own rotation puts it."""

    def change(plot: Redrawing, right: Value) -> Value:
        omega, (first, _, third) = plot.omega[step.link], step.corners
        turned = 1j * omega if plane == "velocity" else 1j * plot.alpha[step.link] - omega**2
        return plot.points(plane)[step.base[0]] + turned * plot.arm(first, third)

    return Edit(("image", plane, step.point), change)


@mistake("arm-ignored", "wheels", "11-2")
def arm_ignored(scene: Scene) -> Iterator[Rewrite]:
    """omega_a / omega_b = -r_b / r_a with the wheels' own rotations, though the arm that bears them turns. At one
    contact, or at all; the wheels after it turn as their own contacts then have it. Where wheels and arm are found
    together, the law of the contact is put into the equations without the arm."""
    alone = []
    for stage in scene.method.stages:
        if isinstance(stage, Mesh) and stage.angle and stage.contact.arm and _matters(scene, stage.contact):
            contact, borne = stage.contact, not scene.turns_with(stage.angle, stage.contact.arm)
            wheel = next((w for w in contact.wheels if scene.turns_with(w, stage.angle)), "")
            if wheel and borne:
                edits = _by_law(scene, (contact,), (stage.angle,), contact, _without_arm(contact))
                alone.append(Rewrite("arm-ignored", scene.rotation_name("omega", wheel), edits=edits))
    yield from each_and_all(alone)
    together = dict(_found_together(scene)).items()
    yield from each_and_all([Rewrite("arm-ignored", name, edits=edits) for name, edits in together])


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
                law = _without_arm(contact)
                for wheel, word in product(wheels, ("omega", "alpha")):
                    base = scene.plot.facts.turns[wheel].base
                    edits.append(Edit(("settled", word, wheel), _by_laws([law], {base: [1 / law[wheel]]}, wheel, word)))
            yield name, tuple(edits)


def _without_arm(contact: Contact) -> Law:
    return {link: c for link, c in contact.angles if link != contact.arm}


def _matters(scene: Scene, contact: Contact) -> bool:
    return bool(scene.plot.omega[contact.arm] or scene.plot.alpha[contact.arm])
