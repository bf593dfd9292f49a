"""Mistakes in reading rotations: of omega = v / l the wrong v, the wrong l, the wrong sense; alpha alike."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction import AlongGuide, Image, LayOff, Measure, Plane, Roll, Simultaneous
from graphkin.marking.hand import Redrawing
from graphkin.marking.mistakes.directions import guide_lengths
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times, in_sense_of
from graphkin.marking.scene import Scene, mistake


def measured(scene: Scene, plane: Plane) -> Iterator[tuple[Measure, str]]:
    """Every rotation read off a polygon, with its name."""
    for step in scene.measures(plane):
        yield step, scene.rotation_name(step.quantity, step.of)


def reading(plane: Plane, step: Measure, change: Change) -> tuple[Edit, ...]:
    """Another reading of a measured quantity."""
    return (Edit(("read", plane, step.quantity, step.of), change),)


def over(plane: Plane, tail: str, head: str, length: float) -> Change:
    """Another arrow over a length, in the sense that is right."""

    def change(plot: Redrawing, right: Value) -> Value:
        points = plot.points(plane)
        what = "rad/s" if plane == "velocity" else "rad/s^2"
        return in_sense_of(plot, np.abs(points[head] - points[tail]) / length, right, what)

    return change


@mistake("omega-sense", "rotation", "3-2.1 (3-1)")
def omega_sense(scene: Scene) -> Iterator[Rewrite]:
    """Read the wrong way round, and carried on."""
    for step, name in measured(scene, "velocity"):
        yield Rewrite((name,), edits=reading("velocity", step, Times(-1.0)))
    for calculation in scene.steps("velocity"):  # rotations that a rolling contact or several equations give
        rolled = (calculation.angle,) if isinstance(calculation, Roll) and calculation.angle else ()
        for base in calculation.angles if isinstance(calculation, Simultaneous) else rolled:
            links = [link for link, turn in scene.plot.facts.turns.items() if turn.base == base]
            edits = tuple(Edit(("settled", "omega", link), Times(-1.0)) for link in links)
            yield Rewrite((scene.rotation_name("omega", base),), edits=edits)


@mistake("absolute-for-relative", "rotation", "3-2.1 (3-1)")
def absolute_for_relative(scene: Scene) -> Iterator[Rewrite]:
    """omega = v_C / l_BC of a link whose other point moves too; not with a point that is just at rest."""
    pole, points = scene.method.velocity.pole, scene.plot.points("velocity")
    for step, name in measured(scene, "velocity"):
        sites = (scene.method.velocity.nodes[node].site for node in (step.tail, step.head) if node != pole)
        if pole in (step.tail, step.head) or any(site is not None and scene.fixed(site.point) for site in sites):
            continue
        for node in (node for node in (step.head, step.tail) if points[node] != points[pole]):
            form = f"{scene.velocity_name(node)}/{scene.length_name(*step.lever)}"
            change = over("velocity", pole, node, scene.length(*step.lever))
            yield Rewrite((name,), form, reading("velocity", step, change))


@mistake("wrong-length", "rotation", "3-2.1 (3-1)")
def wrong_length(scene: Scene) -> Iterator[Rewrite]:
    """A rotation is read off with another length of the link."""
    for step, name in measured(scene, "velocity"):
        for form, length in scene.other_lengths(step.of, step.lever).items():
            edits = reading("velocity", step, Times(scene.length(*step.lever) / length))
            yield Rewrite((name,), form, edits)


@mistake("sliding-as-turning", "rotation", "3-2.1 (3-3)")
def sliding_as_turning(scene: Scene) -> Iterator[Rewrite]:
    """omega = v_B3B2 / l: the velocity of sliding over a length of the guide, or over the lever."""
    for _, equation in scene.meets("velocity"):
        for term in () if equation is None else equation.left + equation.right:
            if term.size is not None or not isinstance(term.direction, AlongGuide) or not term.seen_from:
                continue
            ends = {term.tail, term.head}  # rotations read off arrows that meet this arrow of sliding
            for step, name in measured(scene, "velocity"):
                if ends & {step.tail, step.head} and ends <= scene.drawn_before(step, "velocity"):
                    lever = {scene.length_name(*step.lever): scene.length(*step.lever)}
                    for text, length in (guide_lengths(scene, term.direction.slide, ("", "")) or lever).items():
                        edits = reading("velocity", step, over("velocity", term.tail, term.head, length))
                        yield Rewrite((name,), f"{term.name('velocity')}/{text}", edits)


# --- segments of the acceleration polygon -----------------------------------------------------


@mistake("wrong-tail", "acceleration", "3-2.1 (3-2)")
def wrong_tail(scene: Scene) -> Iterator[Rewrite]:
    """A known arrow laid off from the pole, so that those before it are lost; alpha or an image from other corners."""
    for construction in scene.polygons:
        plane = construction.plane
        sites = ((name, node.site) for name, node in construction.nodes.items())
        resting = {construction.pole, *(name for name, site in sites if site is not None and scene.fixed(site.point))}
        for step in scene.steps(plane):
            if isinstance(step, LayOff) and step.start not in resting and "*" not in step.start + step.tip:
                edits = (Edit(("laid", plane, step.tip), _back_to_pole(plane, step.start)),)
                yield Rewrite((step.term.name(plane),), construction.pole, edits)
    yield from _whole_arrow(scene)
    yield from _image_on_normal(scene)


def _back_to_pole(plane: Plane, start: str) -> Change:
    return lambda plot, right: right - plot.points(plane)[start]


def _whole_arrow(scene: Scene) -> Iterator[Rewrite]:
    """alpha = a_B3 / l or a_CB / l for a^t / l."""
    pole = scene.method.acceleration.pole
    for step, name in measured(scene, "acceleration"):
        ends = scene.ends(step)
        if ends is None:
            continue
        tail, head = ends
        length = scene.length(*step.lever)
        for start in dict.fromkeys((pole if scene.fixed(step.lever[0]) else tail, pole)):
            if {start, head} == {step.tail, step.head}:
                continue
            edits = reading("acceleration", step, over("acceleration", start, head, length))
            yield Rewrite((name,), start + head, edits, way="segment")


def _image_on_normal(scene: Scene) -> Iterator[Rewrite]:
    """The image of a link on n'c' for b'c'."""
    corners: dict[tuple[str | None, str | None], str] = {}
    for term in scene.terms("acceleration"):
        if term.part == "t" and len(term.sites) == 2:
            head, tail = (scene.arrows.node(site, "acceleration") for site in term.sites)
            corners[tail, head] = term.tail
    for images in scene.images("acceleration").values():
        for base in dict.fromkeys(step.base for step in images):
            first, second = base  # the end of the normal arrow for the point from which the other is seen
            others = (corners.get((first, second), first), second), (first, corners.get((second, first), second))
            for other in others:
                edits = tuple(image_edit("acceleration", step, *other) for step in images if step.base == base)
                if other != base:
                    yield Rewrite(scene.image_name(images), "".join(other), edits, way="image")


def image_edit(plane: Plane, step: Image, tail: str, head: str, mirrored: bool = False) -> Edit:
    """An image on other corners, or lettered the other way round."""

    def change(plot: Redrawing, right: Value) -> Value:
        points = plot.points(plane)
        first, second, third = step.corners
        ratio = plot.arm(first, third) / plot.arm(first, second)
        return points[tail] + (points[head] - points[tail]) * (np.conj(ratio) if mirrored else ratio)

    return Edit(("image", plane, step.point), change)
