"""Mistakes with wheels: the arm's rotation left out of the ratio."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.geometry import Value
from graphkin.marking.redrawing import Redrawing
from graphkin.marking.rewrite import Change, Edit, Rewrite
from graphkin.marking.scene import Scene, mistake
from graphkin.planning.stages import Mesh

__all__: list[str] = []


@mistake("arm-ignored", "wheels", "11-2")
def arm_ignored(scene: Scene) -> Iterator[Rewrite]:
    """omega_a / omega_b = -r_b / r_a with the wheels' own rotations, though the arm that bears them turns."""
    found = list(_on_arms(scene))
    yield from found
    if len(found) > 1:
        names, edits = ", ".join(one.of for one in found), tuple(edit for one in found for edit in one.edits)
        yield Rewrite("arm-ignored", names, edits=edits)


def _on_arms(scene: Scene) -> Iterator[Rewrite]:
    """Each contact that gives the rotation of a wheel, on an arm that turns."""
    for stage in scene.method.stages:
        if not isinstance(stage, Mesh) or not stage.angle or not stage.contact.arm:
            continue
        coefficients, arm = stage.contact.angles, stage.contact.arm
        wheel = next((link for link, _ in coefficients if scene.turns_with(link, stage.angle)), None)
        if wheel is None or scene.turns_with(wheel, arm) or not _turns(scene, arm):
            continue
        edits = tuple(
            Edit(("settled", quantity, wheel), _without(coefficients, wheel, arm, quantity))
            for quantity in ("omega", "alpha")
        )
        yield Rewrite("arm-ignored", scene.rotation_name("omega", wheel), edits=edits)


def _turns(scene: Scene, arm: str) -> bool:
    return bool(scene.plot.omega[arm])


def _without(coefficients: tuple[tuple[str, float], ...], wheel: str, arm: str, quantity: str) -> Change:
    own = dict(coefficients)[wheel]

    def change(plot: Redrawing, right: Value) -> Value:
        table: dict[str, Value] = getattr(plot, quantity)
        others = [(link, c) for link, c in coefficients if link not in (wheel, arm)]
        return -sum(c * table[link] for link, c in others) / own + 0 * right

    return change
