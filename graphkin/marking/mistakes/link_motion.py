"""Mistakes with the motion of a link: images the wrong way round or on the wrong point; normal accelerations (3-2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from graphkin.base.geometry import Value, unit
from graphkin.construction import LETTER, AlongGuide, Image, Normal, Plane, Ray, Relative, Tangential
from graphkin.marking.hand import Redrawing
from graphkin.marking.mistakes.directions import rays
from graphkin.marking.mistakes.driving import driven_velocities
from graphkin.marking.mistakes.readings import image_edit, measured, reading
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times, each_and_all, in_sense_of
from graphkin.marking.scene import Scene, drawn_by, mistake
from graphkin.model.quantities import Rotation

PLANES: tuple[Plane, Plane] = ("velocity", "acceleration")
RULE_OF_IMAGES = "3-2.1"


def _in_each_plane(scene: Scene, way: str, edits: dict[tuple[str, Plane], list[Edit]]) -> Iterator[Rewrite]:
    """One rewrite for both polygons of a link, and one for each of them alone."""
    for link in dict.fromkeys(link for link, _ in edits):
        name = scene.image_name(next(scene.images(plane)[link] for plane in PLANES if (link, plane) in edits))
        by_plane = {plane: edits[link, plane] for plane in PLANES if edits.get((link, plane))}
        if len(by_plane) > 1:
            yield Rewrite(name, "v, a", tuple(edit for found in by_plane.values() for edit in found), way=way)
        for plane, found in by_plane.items():
            yield Rewrite(name, LETTER[plane], tuple(found), way=way)


def _of_every_image(scene: Scene, swapped: bool) -> dict[tuple[str, Plane], list[Edit]]:
    """Mirrored in the line of its base, or with the base's ends taken for each other."""
    return {
        (link, plane): [image_edit(plane, s, *(s.base[::-1] if swapped else s.base), not swapped) for s in steps]
        for plane in PLANES for link, steps in scene.images(plane).items()
    }  # fmt: skip


@mistake("image-mirrored", "image", RULE_OF_IMAGES)
def image_mirrored(scene: Scene) -> Iterator[Rewrite]:
    """The image of a link is drawn with its corners the other way round."""
    yield from _in_each_plane(scene, "", _of_every_image(scene, False))
    yield from _in_each_plane(scene, "swapped", _of_every_image(scene, True))


@mistake("image-wrong-point", "image", RULE_OF_IMAGES)
def image_wrong_point(scene: Scene) -> Iterator[Rewrite]:
    """The image drawn on the coincident point of the other link."""
    edits: dict[tuple[str, Plane], list[Edit]] = {}
    for plane in PLANES:
        drawn: list[str] = []
        for step in scene.steps(plane):
            if isinstance(step, Image):
                tail, head = (_coincident(scene, plane, node, drawn) or node for node in step.base)
                if (tail, head) != step.base and tail != head:
                    edits.setdefault((step.link, plane), []).append(image_edit(plane, step, tail, head))
            drawn += drawn_by(step)
    yield from _in_each_plane(scene, "", edits)


def _coincident(scene: Scene, plane: Plane, node: str, drawn: list[str]) -> str | None:
    """Another corner, drawn before, that stands for the same point of the mechanism."""
    nodes = scene.construction(plane).nodes
    site = nodes[node].site
    if site is None or scene.fixed(site.point):
        return None
    others = ((name, nodes[name].site) for name in drawn if name != node)
    return next((name for name, other in others if other is not None and other.point == site.point), None)


# --- normal accelerations: a^n = omega^2 l, towards the point from which it is seen ------------


RULE_OF_NORMALS = "3-2.1 (3-2)"


def normals(scene: Scene) -> Iterator[tuple[Normal | Relative, str]]:
    """Every normal term, the crank's, those of driven rotations and of wheels' rims too."""
    for size, name in (scene.sized("acceleration", Normal) | dict.fromkeys(scene.rims, "")).items():
        yield size, name or f"a^n_{size.head}{size.tail}"
    for turn, name in scene.sized("acceleration", Relative).items():
        if turn.part == "n":
            yield turn, name or f"a^n_{turn.head}{turn.tail}"


def _each(scene: Scene, change: Change | None) -> Iterator[Rewrite]:
    """Every term alone; and those of all links that are not driven."""
    driven = [name for size, name in normals(scene) if isinstance(size, Normal) and scene.driven(size.link)]
    return each_and_all([scene.term(size, name, change) for size, name in normals(scene)], driven)


_CHANGES = {"omitted": Times(0.0), "outward": Times(-1.0), "doubled": Times(2.0), "not-laid-off": None}
for _id, _change in _CHANGES.items():
    mistake(f"normal-{_id}", "normal", RULE_OF_NORMALS)(partial(_each, change=_change))


@mistake("tangential-omitted", "acceleration", RULE_OF_NORMALS)
def tangential_omitted(scene: Scene) -> Iterator[Rewrite]:
    """alpha l of a known rotation left out; a driver's, where that is not all that its acceleration enters."""
    known = scene.sized("acceleration", Tangential)
    asked = any(isinstance(q, Rotation) and q.word == "alpha" and scene.driven(q.link) for q in scene.quantities)
    for size, name in known.items():
        if asked or scene.rolling or not scene.driven(size.link) or sum(scene.driven(each.link) for each in known) > 1:
            yield scene.term(size, name or f"a^t_{size.head}{size.tail}", Times(0.0))


@mistake("normal-size", "normal", RULE_OF_NORMALS)
def normal_size(scene: Scene) -> Iterator[Rewrite]:
    """In the right direction: omega l; omega^2; v^2 / l with an absolute v, or that of sliding; another l."""
    for normal, name in normals(scene):
        if not isinstance(normal, Normal):
            continue
        length = scene.length(normal.tail, normal.head)
        if scene.method.mechanism.usual.cut(length * scene.plot.omega[normal.link] ** 2, "m/s^2"):
            for form, change in _sizes(scene, normal, length):
                yield scene.term(normal, name, change, form)


def _sizes(scene: Scene, normal: Normal, length: float) -> Iterator[tuple[str, Change]]:
    link, ends = normal.link, (normal.tail, normal.head)
    omega = scene.omega_sign(scene.method.structure.home(link))
    yield f"{omega} {scene.length_name(*ends)}", lambda p, right: in_sense_of(p, p.omega[link] * length, right, "m/s^2")
    yield f"{omega}²", Times(1.0 / length)
    pole = scene.method.velocity.pole
    for point in ends:
        node = scene.node(point, link, "velocity")
        other = ends[0] if point == ends[1] else ends[1]
        if node is not None and not scene.fixed(point) and not scene.fixed(other):
            yield f"{scene.velocity_name(node)}²/{scene.length_name(*ends)}", _squared(pole, node, length)
    nodes = {scene.node(point, link, "velocity") for point in ends}
    for term in () if scene.driven(link) else scene.terms("velocity"):  # velocities of sliding at either end
        if term.seen_from and isinstance(term.direction, AlongGuide) and {term.tail, term.head} & nodes:
            yield f"{term.name('velocity')}²/{scene.length_name(*ends)}", _squared(term.tail, term.head, length)
    for other, l_other in scene.other_lengths(link, ends).items():
        yield f"{omega}² {other}", Times(l_other / length)


def _squared(tail: str, head: str, length: float) -> Change:
    """v^2 / l of an arrow of the velocity polygon."""

    def change(plot: Redrawing, right: Value) -> Value:
        return in_sense_of(plot, np.abs(plot.velocity[head] - plot.velocity[tail]) ** 2 / length, right, "m/s^2")

    return change


@mistake("diameter-for-radius", "length", "3-2.1")
def diameter_for_radius(scene: Scene) -> Iterator[Rewrite]:
    """One length twice or half as long: in omega = v / l, in alpha = a^t / l or both, carried on; in the velocity of a
    crank's point, alone or with its acceleration; in one normal acceleration."""
    made: dict[tuple[str, ...], list[Rewrite]] = {}
    for plane in PLANES:
        for step, name in measured(scene, plane):
            for form, times in _twice_or_half(scene, *step.lever):
                one = Rewrite((name,), form, reading(plane, step, Times(1 / times)))
                made.setdefault((step.of, *step.lever, form), []).append(one)
    for both in made.values():
        yield from each_and_all(both)
    own: dict[Normal | Tangential | Relative, str] = {**scene.sized("acceleration", Tangential), **dict(normals(scene))}
    for crank, name in driven_velocities(scene):
        same = {size: called for size, called in own.items()
                if (size.link, size.tail, size.head) == (crank.link, crank.tail, crank.head)}  # fmt: skip
        for form, times in _twice_or_half(scene, crank.tail, crank.head):
            edits = [Edit(("arrow", "velocity", crank), Times(times))]
            yield Rewrite((name,), form, tuple(edits))
            edits += [Edit(("arrow", "acceleration", size), Times(times)) for size in same]
            if same:
                yield Rewrite((name, *same.values()), form, tuple(edits))
    for size, name in normals(scene):
        for form, times in _twice_or_half(scene, size.tail, size.head):
            yield scene.term(size, name, Times(times), form)


def _twice_or_half(scene: Scene, tail: str, head: str) -> tuple[tuple[str, float], ...]:
    """Both wrong lengths as they are written, and how many times the right one each is."""
    name = scene.length_name(tail, head)
    return (f"2 {name}", 2.0), (f"{name}/2", 0.5)


@mistake("slider-normal-term", "normal", RULE_OF_NORMALS)
def slider_normal_term(scene: Scene) -> Iterator[Rewrite]:
    """The connecting rod's omega^2 l laid off at the slider, towards the crank's pivot, as if it turned about that."""
    for meet, ray, name in rays(scene, "acceleration"):
        others = {meet.first, meet.second} - {ray}
        facts, slide = scene.plot.facts, ray.direction
        on_frame = isinstance(slide, AlongGuide) and facts.lines[slide.slide][0] == facts.frame
        if not on_frame or any(not isinstance(other, Ray) for other in others):
            continue
        for rod, point, pivot in _rods(scene, ray):

            def shifted(plot: Redrawing, right: Value, rod: Normal = rod, to: Sequence[str] = (point, pivot)) -> Value:
                size = plot.omega[rod.link] ** 2 * np.abs(plot.arm(rod.tail, rod.head))
                return right + size * unit(plot.arm(*to))

            edits = (Edit(("through", "acceleration", meet, ray), shifted),)
            yield Rewrite((name,), scene.length_name(rod.tail, rod.head), edits)


def _rods(scene: Scene, ray: Ray) -> Iterator[tuple[Normal, str, str]]:
    """The normal term of a rod that ends at the sliding point of a ray's guide, that point, and the crank's pivot."""
    assert isinstance(ray.direction, AlongGuide)
    point = scene.method.structure.slides[ray.direction.slide].point
    for rod in scene.sized("acceleration", Normal):
        ends = (rod.tail, rod.head)
        if point in ends and not any(map(scene.fixed, ends)):
            carried = ends[0] if point == ends[1] else ends[1]
            links = [link for link in scene.method.structure.owners.get(carried, ()) if link != rod.link]
            others = (other for link in links for other in scene.points(link) if other != carried)
            if (pivot := next(filter(scene.fixed, others), None)) is not None:
                yield rod, point, pivot
