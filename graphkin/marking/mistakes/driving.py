"""Mistakes with what is given: the drivers' senses, directions, rates and accelerations, and where they stand."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial

import numpy as np

from graphkin.construction import Meet, Relative, Swing, Turning
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME


@mistake("driver-reversed", "driver", "3-2.1 (3-1)")
def reversed_(scene: Scene) -> Iterable[Rewrite]:
    """The only driver, or all together."""
    alone = _of_drivers(scene, "rate", -1.0)
    edits = tuple(edit for one in alone for edit in one.edits)
    return alone if len(alone) < 2 else [Rewrite((), edits=edits, way="all")]


@mistake("driver-reversed-one", "driver", "3-2.1 (3-1)")
def one_reversed(scene: Scene) -> Iterable[Rewrite]:
    """One of several drivers."""
    alone = _of_drivers(scene, "rate", -1.0)
    return alone if len(alone) > 1 else ()


def _of_drivers(scene: Scene, word: str, factor: float) -> list[Rewrite]:
    """Every driver's rate or acceleration so many times."""
    return [Rewrite((driver.name,), edits=(Edit((word, k), Times(factor)),))
            for k, driver in enumerate(scene.method.drivers) if getattr(driver, word)]  # fmt: skip


@mistake("driver-along-crank", "driver", "3-2.1 (3-1)")
def along_crank(scene: Scene) -> Iterator[Rewrite]:
    """The velocity of a crank pin is drawn along the crank, outward for omega > 0 or inward."""
    for size, name in driven_velocities(scene):
        for way, turn in (("", -1j), ("back", 1j)):
            yield Rewrite((name,), edits=(Edit(("arrow", "velocity", size), Times(turn)),), way=way)


def driven_velocities(scene: Scene) -> Iterator[tuple[Turning | Relative, str]]:
    """Velocities of crank pins, with their names."""
    yield from ((size, n) for size, n in scene.sized("velocity", Turning).items() if n and scene.driven(size.link))
    yield from ((size, n) for size, n in scene.sized("velocity", Relative).items() if n and size.part == "")


for _id, _factor in {"driver-acceleration-dropped": 0.0, "driver-acceleration-reversed": -1.0}.items():
    mistake(_id, "driver", "3-2.1 (3-2)")(partial(_of_drivers, word="acceleration", factor=_factor))


@mistake("relative-as-absolute", "driver", "3-2.1 (3-3)")
def relative_as_absolute(scene: Scene) -> Iterator[Rewrite]:
    """The rotation of a link against a moving one taken for its rotation, or that of the moving one subtracted from it,
    not added; links that turn against these follow."""
    facts = scene.plot.facts
    for k, driver in enumerate(scene.method.drivers):
        if driver.kind != "angle" or driver.from_link == FRAME:
            continue
        beyond = [link for link in facts.groups[facts.turns[driver.link].base]
                  if k in facts.drivers_between(link, driver.from_link)]  # fmt: skip
        for way, times in {"": 1.0, "difference": 2.0}.items() if facts.frame not in beyond else ():
            if not way or scene.driven(driver.link):
                edits = (Edit(("settled", word, link), _without(word, driver.from_link, times))
                         for word in ("omega", "alpha") for link in beyond)  # fmt: skip
                yield Rewrite((driver.name,), edits=tuple(edits), way=way)


def _without(word: str, link: str, times: float) -> Change:
    """A rate less so many times that of a link."""
    return lambda plot, right: right - times * getattr(plot, word)[link]


# --- where the mechanism stands ---------------------------------------------------------------


@mistake("angle-clockwise", "position", "3-2.1")
def angle_clockwise(scene: Scene) -> Iterator[Rewrite]:
    """The angle of a driver is laid off clockwise."""
    if scene.method.fits:
        return
    for k, driver in enumerate(scene.method.drivers):
        if driver.kind == "angle" and abs(np.sin(scene.plot.facts.values[k])) > 1e-9:
            yield Rewrite((driver.name,), edits=(Edit(("value", k), Times(-1.0)),))


@mistake("other-assembly", "position", "3-2.1")
def other_assembly(scene: Scene) -> Iterator[Rewrite]:
    """The mechanism is drawn in its other assembly."""
    if scene.method.fits:
        return
    for step in scene.method.position.steps:
        if isinstance(step, Meet | Swing) and step.choice is not None:
            of = step.point if isinstance(step, Meet) else step.link
            yield Rewrite((of,), edits=(Edit(("side", step.choice), Times(-1.0)),))
