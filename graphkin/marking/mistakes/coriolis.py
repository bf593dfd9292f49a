"""Mistakes with the Coriolis acceleration: a^k = 2 omega v_r, v_r turned by 90 deg in the sense of omega; (3-4)."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.construction import Coriolis
from graphkin.marking.rewrite import Change, Edit, Rewrite, times
from graphkin.marking.scene import Scene, mistake

__all__: list[str] = []

RULE = "3-2.1 (3-4)"


def terms(scene: Scene) -> Iterator[tuple[Coriolis, str]]:
    """Each Coriolis term with its name."""
    for size, name in scene.sized("acceleration", Coriolis).items():
        yield size, name or f"a^k {size.link}"


def _each(scene: Scene, id: str, change: Change) -> Iterator[Rewrite]:
    for size, name in terms(scene):
        yield Rewrite(id, name, edits=(Edit(("arrow", "acceleration", size), change),))


@mistake("coriolis-omitted", RULE)
def omitted(scene: Scene) -> Iterator[Rewrite]:
    return _each(scene, "coriolis-omitted", times(0.0))


@mistake("coriolis-reversed", RULE)
def reversed_(scene: Scene) -> Iterator[Rewrite]:
    return _each(scene, "coriolis-reversed", times(-1.0))


@mistake("coriolis-half", RULE)
def half(scene: Scene) -> Iterator[Rewrite]:
    return _each(scene, "coriolis-half", times(0.5))
