"""Mistakes with what is given: the drivers' senses, directions, rates and accelerations, and where they stand."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphkin.construction import Meet, Relative, Swing, Turning
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times
from graphkin.marking.scene import Scene, mistake
from graphkin.model.mechanism import FRAME


@mistake("driver-reversed", "driver", "3-2.1 (3-1)")
def reversed_(scene: Scene) -> Iterator[Rewrite]:
    """Every driver alone, and all together."""
    edits = {k: Edit(("rate", k), Times(-1.0)) for k, driver in enumerate(scene.method.drivers) if driver.rate}
    for k, edit in edits.items():
        yield Rewrite("driver-reversed", scene.method.drivers[k].name, edits=(edit,))
    if len(edits) > 1:
        yield Rewrite("driver-reversed", "", edits=tuple(edits.values()), way="all")


@mistake("driver-along-crank", "driver", "3-2.1 (3-1)")
def along_crank(scene: Scene) -> Iterator[Rewrite]:
    """The velocity of a crank pin is drawn along the crank."""
    turning = [(size, name) for size, name in scene.sized("velocity", Turning).items() if scene.driven(size.link)]
    relative = [(size, name) for size, name in scene.sized("velocity", Relative).items() if size.part == ""]
    for size, name in (*turning, *relative):
        if name:
            yield Rewrite("driver-along-crank", name, edits=(Edit(("arrow", "velocity", size), Times(-1j)),))


@mistake("driver-acceleration-dropped", "driver", "3-2.1 (3-2)")
def acceleration_dropped(scene: Scene) -> Iterator[Rewrite]:
    """The angular acceleration of a driver is taken for 0."""
    for k, driver in enumerate(scene.method.drivers):
        if driver.acceleration:
            yield Rewrite("driver-acceleration-dropped", driver.name, edits=(Edit(("acceleration", k), Times(0.0)),))


@mistake("relative-as-absolute", "driver", "3-2.1 (3-3)")
def relative_as_absolute(scene: Scene) -> Iterator[Rewrite]:
    """The rotation of a link against a moving one taken for its rotation."""
    for k, driver in enumerate(scene.method.drivers):
        if driver.kind != "angle" or driver.from_link == FRAME:
            continue
        edits = tuple(Edit(("settled", word, driver.link), _alone(word, k)) for word in ("omega", "alpha"))
        yield Rewrite("relative-as-absolute", driver.name, edits=edits)


def _alone(word: str, k: int) -> Change:
    """The rate that a driver alone gives its link."""
    return lambda plot, right: (plot.facts.rates if word == "omega" else plot.facts.accelerations)[k]


# --- where the mechanism stands ---------------------------------------------------------------


@mistake("angle-clockwise", "position", "3-2.1")
def angle_clockwise(scene: Scene) -> Iterator[Rewrite]:
    """The angle of a driver is laid off clockwise."""
    if scene.method.fits:
        return
    for k, driver in enumerate(scene.method.drivers):
        if driver.kind == "angle" and abs(np.sin(scene.plot.facts.values[k])) > 1e-9:
            yield Rewrite("angle-clockwise", driver.name, edits=(Edit(("value", k), Times(-1.0)),))


@mistake("other-assembly", "position", "3-2.1")
def other_assembly(scene: Scene) -> Iterator[Rewrite]:
    """The mechanism is drawn in its other assembly."""
    if scene.method.fits:
        return
    for step in scene.method.position.steps:
        if isinstance(step, Meet | Swing) and step.choice is not None:
            of = step.point if isinstance(step, Meet) else step.link
            yield Rewrite("other-assembly", of, edits=(Edit(("side", step.choice), Times(-1.0)),))
