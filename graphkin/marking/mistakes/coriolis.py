"""Mistakes with the Coriolis acceleration: a^k = 2 omega v_r, v_r turned by 90 deg in the sense of omega; (3-4)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from graphkin.base.geometry import Value
from graphkin.construction import Coriolis
from graphkin.marking.hand import Redrawing
from graphkin.marking.rewrite import Change, Edit, Rewrite, Times, each_and_all, in_sense_of, turned_back
from graphkin.marking.scene import Scene, mistake

RULE = "3-2.1 (3-4)"


def terms(scene: Scene) -> Iterator[tuple[Coriolis, str]]:
    """Each Coriolis term with its name."""
    for size, name in scene.sized("acceleration", Coriolis).items():
        nodes = scene.method.velocity.nodes
        yield size, name or f"a^k_{nodes[size.head].of}{nodes[size.tail].of}"


def _each(scene: Scene, change: Change | None) -> Iterator[Rewrite]:
    """Every term alone; and all, as by one who does not know better."""
    return each_and_all([scene.term(size, name, change) for size, name in terms(scene)])


_CHANGES = {"omitted": Times(0.0), "reversed": Times(-1.0), "half": Times(0.5), "not-laid-off": None}
for _id, _change in _CHANGES.items():
    mistake(f"coriolis-{_id}", "coriolis", RULE)(partial(_each, change=_change))


@mistake("coriolis-not-turned", "coriolis", RULE)
def not_turned(scene: Scene) -> Iterator[Rewrite]:
    """In the direction of v_r."""
    change = [(size, name, turned_back(size.link)) for size, name in terms(scene)]
    return each_and_all([scene.term(*each) for each in change])


@mistake("coriolis-crank-omega", "coriolis", RULE)
def crank_omega(scene: Scene) -> Iterator[Rewrite]:
    """With a driver's omega, in the sense of the right one or in its own."""
    for size, name in terms(scene):
        for link in (link for link in scene.cranks if link != size.link):
            opposite = scene.plot.omega[link] * scene.plot.omega.get(size.link, 0.0) < 0
            for way in ("sense", "") if opposite else ("sense",):

                def change(plot: Redrawing, _: Value, size: Coriolis = size, link: str = link, way: str = way) -> Value:
                    own, slip = plot.omega[link], plot.velocity[size.head] - plot.velocity[size.tail]
                    return 2j * (in_sense_of(plot, own, plot.omega[size.link], "rad/s") if way else own) * slip

                form = scene.omega_sign(link)
                yield scene.term(size, name, change, form, way)


@mistake("coriolis-absolute-velocity", "coriolis", RULE)
def absolute_velocity(scene: Scene) -> Iterator[Rewrite]:
    """With the velocity of either coincident point for that of the one against the other."""
    for size, name in terms(scene):
        for end in (end for end in (size.tail, size.head) if end != scene.method.velocity.pole):

            def change(plot: Redrawing, right: Value, size: Coriolis = size, end: str = end) -> Value:
                return in_sense_of(plot, 2 * plot.omega[size.link] * plot.velocity[end], right, "m/s^2")

            yield scene.term(size, name, change, scene.velocity_name(end))


@mistake("block-omega", "coriolis", RULE)
def block_omega(scene: Scene) -> Iterator[Rewrite]:
    """The block taken as not turning, as turning with a driver, or about the guide's pivot with its own velocity."""
    slides = scene.method.structure.slides.values()
    blocks = {scene.method.structure.block(slide) for slide in slides} - {slide.guide for slide in slides}
    for size, name in terms(scene):
        if size.link in blocks:
            rates: dict[str, Change] = {"0": Times(0.0)}  # by how it is written; ± where only its size is taken
            for link in scene.cranks:
                text = scene.omega_sign(link)
                rates |= {text: _crank(link, False), f"±{text}": _crank(link, True)}
            for step in scene.measures("velocity"):
                if step.head in (size.tail, size.head) and scene.turns_with(step.of, size.link):
                    text = f"{scene.velocity_name(size.tail)}/{scene.length_name(*step.lever)}"
                    rates[text] = _about(size.tail, scene.length(*step.lever))
            for form, change in rates.items():
                yield Rewrite((name,), form, (Edit(("settled", "omega", size.link), change),))


def _crank(link: str, in_right_sense: bool) -> Change:
    def change(plot: Redrawing, right: Value) -> Value:
        own = plot.omega[link]
        return in_sense_of(plot, own, right, "rad/s") if in_right_sense else own

    return change


def _about(node: str, length: float) -> Change:
    """The velocity of the block's point over a length, in the right sense."""
    return lambda plot, right: in_sense_of(plot, np.abs(plot.velocity[node]) / length, right, "rad/s")
