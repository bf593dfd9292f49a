"""Mistakes with directions of what is sought: along for across, across for along, across the wrong line."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.base.geometry import Value, cross, dot, number, place
from graphkin.construction import Across, AlongGuide, Measure, Meet, Normal, Plane, Ray, Tangential
from graphkin.marking.hand import Redrawing
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times, in_sense_of, turned_back
from graphkin.marking.scene import Scene, mistake

NOTHING = 1e-6  # sine of an angle under which two directions count as one


def rays(scene: Scene, plane: Plane) -> Iterator[tuple[Meet, Ray, str]]:
    """Every direction line of an equation's unknown arrow, with the arrow's name."""
    for meet, equation in scene.meets(plane):
        for ray in (meet.first, meet.second):
            if isinstance(ray, Ray):
                terms = () if equation is None else equation.left + equation.right
                names = (t.name(plane) for t in terms if t.size is None and t.direction == ray.direction)
                yield meet, ray, next(names, "") or f"{plane[0]} {meet.point}"


def measured_over(scene: Scene, plane: Plane, across: Across) -> Measure | None:
    """The reading off an arrow across a lever."""
    ends = {across.tail, across.head}
    return next((step for step in scene.measures(plane) if set(step.lever) == ends), None)


def _along(scene: Scene, plane: Plane) -> Iterator[Rewrite]:
    for meet, ray, name in rays(scene, plane):
        if isinstance(ray.direction, Across):
            line = Edit(("line", plane, meet, ray), Times(-1j))
            step = measured_over(scene, plane, ray.direction)
            if step is None:
                yield Rewrite((name,), edits=(line,))
                continue
            # the rotation over a lever has no sense to be read, where its arrow lies along that: none, or either
            readings: dict[str, Change] = {"": Times(np.nan), "ccw": _whole_arrow(plane, step, 1.0),
                                           "cw": _whole_arrow(plane, step, -1.0)}  # fmt: skip
            for way, change in readings.items():
                yield Rewrite((name,), edits=(line, Edit(("read", plane, step.quantity, step.of), change)), way=way)


def _whole_arrow(plane: Plane, step: Measure, sense: float) -> Change:
    """A rotation by the whole of an arrow, with a sense."""

    def change(plot: Redrawing, right: Value) -> Value:
        points = plot.points(plane)
        return sense * np.abs(points[step.head] - points[step.tail]) / np.abs(plot.arm(*step.lever))

    return change


@mistake("velocity-along-link", "velocity-direction", "3-2.1 (3-1)")
def velocity_along_link(scene: Scene) -> Iterator[Rewrite]:
    """The reading of that link's rotation has no sense, so that it and all that follows from it is not judged."""
    return _along(scene, "velocity")


@mistake("tangential-along", "acceleration", "3-2.1 (3-2)")
def tangential_along(scene: Scene) -> Iterator[Rewrite]:
    """Of unknown arrows; a crank's own laid along, and its normal one laid along its velocity."""
    yield from _along(scene, "acceleration")
    for swing, name in scene.sized("acceleration", Tangential).items():
        if scene.driven(swing.link) and np.any(scene.plot.alpha[swing.link]):
            edits = (Edit(("arrow", "acceleration", swing), Times(-1j)),)
            yield Rewrite((name or f"a^t_{swing.head}{swing.tail}",), edits=edits)
    for normal, name in scene.sized("acceleration", Normal).items():
        if scene.driven(normal.link) and np.any(scene.plot.omega[normal.link]):
            edits = (Edit(("arrow", "acceleration", normal), turned_back(normal.link)),)
            yield Rewrite((name or f"a^n_{normal.head}{normal.tail}",), edits=edits, way="crank")


@mistake("sliding-across", "velocity-direction", "3-2.1 (3-3)")
def sliding_across(scene: Scene) -> Iterator[Rewrite]:
    """A sliding velocity is drawn across its guide."""
    for meet, ray, name in rays(scene, "velocity"):
        if isinstance(ray.direction, AlongGuide):
            yield Rewrite((name,), edits=(Edit(("line", "velocity", meet, ray), Times(1j)),))


def with_its_sense(step: Measure, length: float | None = None) -> Change:
    """A rotation as a ruler reads it: the whole arrow over a length, in the sense of its part across the lever."""

    def change(plot: Redrawing, right: Value) -> Value:
        arrow, arm = plot.velocity[step.head] - plot.velocity[step.tail], plot.arm(*step.lever)
        size = np.abs(arrow) / (np.abs(arm) if length is None else length)
        return in_sense_of(plot, size, cross(arm, arrow) / np.abs(arm) ** 2, "rad/s")

    return change


@mistake("wrong-radius", "velocity-direction", "3-2.1 (3-1)")
def wrong_radius(scene: Scene) -> Iterator[Rewrite]:
    """A rocker's point drawn across another line through it or through the pivot."""
    for meet, ray, name in rays(scene, "velocity"):
        if not isinstance(ray.direction, Across):
            continue
        step = measured_over(scene, "velocity", ray.direction)
        if step is None or not any(map(scene.fixed, step.lever)):
            continue
        for tail, head in _radii(scene, step, ray.direction):

            def change(plot: Redrawing, right: Value, tail: str = tail, head: str = head) -> Value:
                return plot.direction(Across(tail, head))

            edits = (
                Edit(("line", "velocity", meet, ray), change),
                Edit(("read", "velocity", "omega", step.of), with_its_sense(step)),
            )
            yield Rewrite((name,), "⊥" + "".join(sorted((tail, head))), edits)


def _radii(scene: Scene, step: Measure, right: Across) -> Iterator[tuple[str, str]]:
    """Other lines of the link through either end of the lever, each direction once."""
    known = [place(scene.plot.direction(right))]
    for end in (right.head, right.tail):
        for point in scene.points(step.of):
            if point in (right.head, right.tail) or scene.length(end, point) == 0:
                continue
            direction = place(scene.plot.direction(Across(end, point)))
            if all(abs(number(cross(direction, other))) > NOTHING for other in known):
                known.append(direction)
                yield end, point


@mistake("orthogonal-split", "velocity-direction", "3-2.1 (3-3)")
def orthogonal_split(scene: Scene) -> Iterator[Rewrite]:
    """The known velocity split along a guide and across it, though the guide passes beside the pivot."""
    for meet, ray, name in rays(scene, "velocity"):
        slide = next((r.direction for r in (meet.first, meet.second)
                      if isinstance(r, Ray) and isinstance(r.direction, AlongGuide)), None)  # fmt: skip
        if slide is None or not isinstance(ray.direction, Across):
            continue
        step = measured_over(scene, "velocity", ray.direction)
        across, along = (place(scene.plot.direction(direction)) for direction in (ray.direction, slide))
        if step is None or not any(map(scene.fixed, step.lever)) or abs(number(dot(across, along))) < NOTHING:
            continue
        for form, length in {"": None, **guide_lengths(scene, slide.slide, step.lever)}.items():

            def change(plot: Redrawing, right: Value, slide: AlongGuide = slide) -> Value:
                return 1j * plot.direction(slide)

            edits = (
                Edit(("line", "velocity", meet, ray), change),
                Edit(("read", "velocity", "omega", step.of), with_its_sense(step, length)),
            )
            yield Rewrite((name,), form, edits, way="length" if form else "")


def guide_lengths(scene: Scene, slide: str, lever: tuple[str, str]) -> dict[str, float]:
    """Distances of named points of a guide's line from the sliding point [m], by name."""
    guide = scene.plot.facts.lines[slide][0]
    point, along = scene.method.structure.slides[slide].point, place(scene.plot.guide_direction(slide))
    lengths: dict[str, float] = {}
    for other in scene.points(guide):
        arm = place(scene.plot.arm(other, point))
        on_it = abs(number(cross(along, arm))) <= NOTHING * abs(arm)
        if on_it and abs(arm) > 0 and {other, point} != set(lever):
            lengths[scene.length_name(other, point)] = abs(arm)
    return lengths
