"""Mistakes with the velocity and the acceleration image: lettered the wrong way round, or on the wrong point."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.construction import LETTER, Image, Plane
from graphkin.marking.mistakes.rotations import image_edit
from graphkin.marking.rewrite import Edit, Rewrite
from graphkin.marking.scene import Scene, drawn_by, mistake

__all__: list[str] = []

PLANES: tuple[Plane, Plane] = ("velocity", "acceleration")
RULE = "3-2.1"


def _in_each_plane(scene: Scene, id: str, way: str, edits: dict[tuple[str, Plane], list[Edit]]) -> Iterator[Rewrite]:
    """One rewrite for both polygons of a link, and one for each of them alone."""
    for link in dict.fromkeys(link for link, _ in edits):
        name = scene.image_name(next(scene.images(plane)[link] for plane in PLANES if (link, plane) in edits))
        by_plane = {plane: edits[link, plane] for plane in PLANES if edits.get((link, plane))}
        if len(by_plane) > 1:
            yield Rewrite(id, name, "v, a", tuple(edit for found in by_plane.values() for edit in found), way=way)
        for plane, found in by_plane.items():
            yield Rewrite(id, name, LETTER[plane], tuple(found), way=way)


def _of_every_image(scene: Scene, swapped: bool) -> dict[tuple[str, Plane], list[Edit]]:
    return {
        (link, plane): [_turned(plane, step, swapped) for step in steps]
        for plane in PLANES for link, steps in scene.images(plane).items()
    }  # fmt: skip


def _turned(plane: Plane, step: Image, swapped: bool) -> Edit:
    """Mirrored in the line of its base, or with the base's ends taken for each other."""
    first, second = step.base
    return image_edit(plane, step, second, first) if swapped else image_edit(plane, step, first, second, mirrored=True)


@mistake("image-mirrored", "image", RULE)
def mirrored(scene: Scene) -> Iterator[Rewrite]:
    yield from _in_each_plane(scene, "image-mirrored", "", _of_every_image(scene, False))
    yield from _in_each_plane(scene, "image-mirrored", "swapped", _of_every_image(scene, True))


@mistake("image-wrong-point", "image", RULE)
def wrong_point(scene: Scene) -> Iterator[Rewrite]:
    """The image drawn on the coincident point of the other link."""
    edits: dict[tuple[str, Plane], list[Edit]] = {}
    for plane in PLANES:
        drawn: list[str] = []
        for _, step in scene.steps(plane):
            if isinstance(step, Image):
                tail, head = (_coincident(scene, plane, node, drawn) or node for node in step.base)
                if (tail, head) != step.base and tail != head:
                    edits.setdefault((step.link, plane), []).append(image_edit(plane, step, tail, head))
            drawn += drawn_by(step)
    yield from _in_each_plane(scene, "image-wrong-point", "", edits)


def _coincident(scene: Scene, plane: Plane, node: str, drawn: list[str]) -> str | None:
    """Another corner, drawn before, that stands for the same point of the mechanism."""
    nodes = scene.construction(plane).nodes
    site = nodes[node].site
    if site is None or scene.fixed(site.point):
        return None
    others = ((name, nodes[name].site) for name in drawn if name != node)
    return next((name for name, other in others if other is not None and other.point == site.point), None)
