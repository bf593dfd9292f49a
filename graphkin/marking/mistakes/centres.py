"""Mistakes with ratios of rotations: instant centres upside down, from wrong pairs, or as at rest; wheels on an arm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

import numpy as np

from graphkin.base.geometry import Value, meet_lines, place, unit
from graphkin.construction import Meet, Plane, Simultaneous
from graphkin.marking.hand import Redrawing
from graphkin.marking.mistakes.link_motion import PLANES
from graphkin.marking.rewrite import Change, Edit, Rewrite, RewrittenValue, Times, each_and_all
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Centre, Moving, Quotient, Rotation
from graphkin.planning.equivalent import Contact
from graphkin.planning.position import in_step

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
            cranks = scene.cranks_beside(quantity.link)
            for crank in cranks:
                driven = float(scene.motions.omega[crank])
                text = scene.omega_sign(crank)
                yield _ratio(quantity.text, text, RewrittenValue(quantity.text, instead=driven**2 / value))
            if cranks:
                yield _ratio(quantity.text, "", RewrittenValue(quantity.text, -1.0), "sense")
    yield from _ratios_of_radii(scene)


def _ratio(of: str, form: str, written: RewrittenValue, way: str = "") -> Rewrite:
    return Rewrite((of,), form, asked=(written,), way=way)


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
    at, sine = meet_lines(a, unit(b - a), c, unit(d - c))
    return place(at) if sine >= REST else complex(np.inf)


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
                    yield Rewrite((quantity.text,), form, asked=instead)
    for step in scene.steps("acceleration"):
        if not isinstance(step, Meet):
            continue
        node = scene.method.acceleration.nodes[step.point]
        site, fastest = node.site, max(abs(place(v)) for v in scene.plot.velocity.values())
        if site is None or site.link not in scene.motions.velocities or site.point not in scene.plot.position:
            continue
        if abs(place(scene.motions.velocity_at(site.point, site.link))) < REST * fastest:
            edits = (Edit(("met", "acceleration", step.point), Times(0.0)),)
            yield Rewrite((f"a_{node.of}",), "", edits, way="point")


# --- wheels ------------------------------------------------------------------------------------


def _ratios_of_radii(scene: Scene) -> Iterator[Rewrite]:
    """Ratios of radii upside down, or of the other sense, at each contact that gives a rotation."""
    for contacts, bases in scene.rolling:
        for contact in contacts:
            of, form = _moving(scene, contact, bases), ", ".join(map(scene.method.mechanism.called, contact.wheels))
            if not of or not contact.arm or contact.arm in contact.wheels:
                continue
            one, other = (dict(contact.angles)[wheel] for wheel in contact.wheels)
            ways = {"meshing": (one, -other), "radii": (np.copysign(other, one), np.copysign(one, other))}
            for way, (a, b) in ways.items():
                law = dict(zip((*contact.wheels, contact.arm), (a, b, -(a + b)), strict=True))
                edits = _by_law(scene, contacts, bases, contact, law)
                if edits and abs(a - one) + abs(b - other) > REST * abs(one):
                    yield Rewrite((*of.values(),), form, tuple(edits), way=way)


def _moving(scene: Scene, contact: Contact, bases: Sequence[str]) -> dict[str, str]:
    """The wheels of a contact that turn with some links, with the names of their rotations."""
    wheels = (wheel for wheel in contact.wheels if any(scene.turns_with(wheel, base) for base in bases))
    return {wheel: scene.rotation_name("omega", wheel) for wheel in wheels}


def _by_law(scene: Scene, contacts: Sequence[Contact], bases: Sequence[str], contact: Contact, law: Law) -> list[Edit]:
    """Another law of a contact in the equations that hold it, or for the rotations that all laws together give."""
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
            return []
        else:
            shares = dict(zip(bases, np.linalg.inv(counts), strict=True))
            rates = {link: _by_laws(laws, shares, link, word) for link, turn in turns.items() if turn.base in bases}
            edits += (Edit(("settled", word, link), rate) for link, rate in rates.items())
            edits += (edit for each in contacts for edit in _on_wheels(scene, plane, each, rates))
    return edits


def _by_laws(laws: Sequence[Law], shares: Mapping[str, Sequence[float]], of: str, word: str) -> Change:
    """A rate as laws of contacts give it; shares: by unknown base, how much of the known each law counts."""

    def change(plot: Redrawing, right: Value) -> Value:
        facts, order = plot.facts, 1 if word == "omega" else 2
        beyond = {link: facts.relative_rate(link, order) for link, turn in facts.turns.items() if turn.base in shares}
        known: dict[str, Value] = getattr(plot, word) | beyond
        sums = (sum(c * known[link] for link, c in law.items()) for law in laws)
        each = zip(shares[facts.turns[of].base], sums, strict=True)
        return known[of] - sum(share * total for share, total in each) + 0 * right

    return change


def _on_wheels(scene: Scene, plane: Plane, contact: Contact, rates: Mapping[str, Change]) -> Iterator[Edit]:
    """Centres of wheels found by image, where the arm's rotation about the other centre puts them."""
    arm, rate = contact.arm, rates.get(contact.arm)
    for wheel, centre, other in zip(contact.wheels, contact.centres, contact.centres[::-1], strict=True):
        node = scene.construction(plane).pole if scene.fixed(other) else scene.node(other, arm, plane)
        for step in scene.images(plane).get(wheel, ()) if wheel in rates else ():
            if step.corners[2] == centre and rate is not None and node is not None:
                yield Edit(("image", plane, step.point), _turned(plane, node, (other, centre), arm, rate))


def _turned(plane: Plane, node: str, arm: tuple[str, str], link: str, rate: Change) -> Change:
    """The motion of the end of an arm about its other one."""

    def change(plot: Redrawing, right: Value) -> Value:
        turning = 1j * rate(plot, 0.0) - (0 if plane == "velocity" else plot.omega[link] ** 2)
        return plot.points(plane)[node] + turning * plot.arm(*arm) if node in plot.points(plane) else right

    return change


@mistake("arm-ignored", "wheels", "11-2")
def arm_ignored(scene: Scene) -> Iterator[Rewrite]:
    """omega_a / omega_b = -r_b / r_a with the wheels' own rotations, though the arm that bears them turns. At one
    contact, or at all; the wheels after it turn as their own contacts then have it. A wheel that rolls on what is fixed
    turns as it does on the arm, or as if the axes were fixed, with the arm's rotation for that of what is fixed. Where
    wheels and arm are found together, this law is put into the equations."""
    alone: dict[str, dict[tuple[str, ...], Rewrite]] = {"": {}, "fixed": {}}
    for contacts, bases in scene.rolling:
        # those with a driven wheel last, which alone give the other one
        for contact in sorted(contacts, key=lambda one: any(w != FRAME and scene.driven(w) for w in one.wheels)):
            wheels, arm = _moving(scene, contact, bases), contact.arm
            if not arm or not wheels or any(scene.turns_with(wheel, arm) for wheel in wheels):
                continue
            law = {link: c for link, c in contact.angles if link != arm}
            rolls_on = law.pop(FRAME, 0.0)
            own, name = [scene.plot.facts.turns[wheel].base for wheel in wheels], tuple(wheels.values())
            alone["fixed"].pop(name, None)
            for way, share in {"": -rolls_on, "fixed": rolls_on}.items() if rolls_on else (("", 0.0),):
                edits = _by_law(scene, (contact,), own, contact, law | ({arm: share} if share else {}))
                if edits and (scene.plot.omega[arm] or scene.plot.alpha[arm]):
                    alone[way][name] = Rewrite(name, edits=tuple(edits), way=way)
    for each in alone.values():
        yield from each_and_all([*each.values()])


@mistake("moves-as-centre", "wheels", "11-2")
def moves_as_centre(scene: Scene) -> Iterator[Rewrite]:
    """A rack moves as the centre of the wheel that rolls on it, which moves, too: without the wheel's turning."""
    for contact in (contact for contacts, bases in scene.rolling if not bases for contact in contacts):
        law, wheels = in_step(contact), tuple(map(scene.method.mechanism.called, contact.wheels))
        if len(law.way) > 1 and FRAME not in contact.wheels:
            edits = (Edit(("rolling", plane, law, link), Times(0.0)) for plane in PLANES for link, _ in law.angles)
            yield Rewrite(wheels[:1], wheels[1], tuple(edits))
