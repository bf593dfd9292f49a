"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once; `replay_all` carries them out, for the drawn
position or for any driver values, scalars or arrays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods.assembly import pick_sides, refuse_bad_positions
from graphkin.methods.hops import Slip, halves
from graphkin.methods.motion import Labels, motion
from graphkin.methods.position import position
from graphkin.methods.refusals import Unreached, refuse_unsolved
from graphkin.methods.stages import Carry, Loop, Stage, stages
from graphkin.methods.structure import Sliding, Structure
from graphkin.steps import Construction, Equation, Facts, Meet, Plot, Site, Swing, replay

__all__ = ["Method", "plan", "replay_all"]


@dataclass(frozen=True)
class Method:
    """How a mechanism is solved on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    sites   every point written in the polygons (`C`, `B3`) as a point of the mechanism on a link
    """

    mechanism: Mechanism
    structure: Structure
    stages: tuple[Stage, ...]
    position: Construction
    velocity: Construction
    acceleration: Construction

    @property
    def constructions(self) -> tuple[Construction, Construction, Construction]:
        return self.position, self.velocity, self.acceleration

    @property
    def sites(self) -> Mapping[str, Site]:
        nodes = self.velocity.nodes.values()
        return {node.of: node.site for node in nodes if node.site is not None}

    def facts(self, values: Sequence[Value] | None = None) -> Facts:
        """Dimensions, and drivers at the drawn position or at other values [rad, m]."""
        return _facts(self.structure, values)


def plan(mechanism: Mechanism) -> Method:
    """Plan the constructions of a mechanism, and pick its assembly by the sketch.

    Raises a `GraphkinError` where the mechanism holds groups or pairs that are not solved, cannot be
    assembled, or has a sketch that does not tell its assemblies apart.
    """
    refuse_unsolved(mechanism)
    structure = Structure(mechanism)
    order, left = stages(structure)
    if left:
        names = list(dict.fromkeys(structure.home(body) for body in left))
        raise Unreached(mechanism.where("links", names[0]), ", ".join(names))
    labels = Labels(structure, _coincident(structure, order))
    drawn, choices = position(structure, order)
    pole = _pole(mechanism)
    velocity, at = motion(structure, order, labels, "velocity", pole, lambda site: "")
    acceleration, _ = motion(structure, order, labels, "acceleration", pole, at)
    sides = pick_sides(structure, drawn, choices, _facts(structure, None))
    return Method(mechanism, structure, order, _with_sides(drawn, sides), velocity, acceleration)


def replay_all(method: Method, values: Sequence[Value] | None = None) -> Plot:
    """All three constructions at the drawn position, or at `values`: one entry a driver, scalar or (n,) [rad, m].

    A single position that cannot be reached, or that is a dead point, raises; in arrays it is NaN, and
    `Plot.sines` tells how near each position is to a dead point.
    """
    plot = Plot(method.facts(values))
    replay(method.position, plot)
    refuse_bad_positions(method.structure, method.position, plot)
    replay(method.velocity, plot)
    return replay(method.acceleration, plot)


def _facts(structure: Structure, values: Sequence[Value] | None) -> Facts:
    mechanism = structure.mechanism
    shapes = {name: dict(link.points) for name, link in mechanism.links.items()}
    shapes |= {body: {points[0]: 0j} for body, points in structure.bodies.items() if structure.is_pin(body)}
    drivers = mechanism.drivers
    return Facts(
        frame=FRAME,
        shapes=shapes,
        lines={s.name: (s.guide, s.line.origin, s.line.direction) for s in mechanism.slides},
        turns=structure.turns,
        slides_driven=structure.slides_driven,
        values=tuple(values) if values is not None else tuple(driver.value or 0.0 for driver in drivers),
        rates=tuple(driver.rate for driver in drivers),
        accelerations=tuple(driver.acceleration for driver in drivers),
    )


def _pole(mechanism: Mechanism) -> str:
    """p, or the next letter that no point of the mechanism takes."""
    return next(letter for letter in ("p", "o", "q", "z", "pole") if letter.upper() not in mechanism.owners)


def _coincident(structure: Structure, order: tuple[Stage, ...]) -> dict[str, str]:
    """Points at which links slide past a moving link, with the link of which the hinge there is a point."""
    found: dict[str, str] = {}
    for stage in order:
        slips: list[Slip] = []
        if isinstance(stage, Loop):
            _, left, _, right = halves(structure, stage)
            slips = [hop for hop in left + right if isinstance(hop, Slip)]
        elif isinstance(stage, Carry) and isinstance(stage.by, Sliding):
            pair = structure.slides[stage.by.slide]
            ends = (Site(pair.point, pair.guide), Site(pair.point, structure.block(pair)))
            slips = [Slip(ends[0], ends[1], True, pair.name)]
        for slip in slips:
            if FRAME not in (slip.seen_from.link, slip.of.link):
                block = structure.block(structure.slides[slip.slide])
                found.setdefault(slip.of.point, structure.home(block))
    return found


def _with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""

    def chosen(step: object) -> object:
        if isinstance(step, Meet | Swing) and step.choice is not None:
            return replace(step, side=sides[step.choice])
        return step

    parts = []
    for part in construction.parts:
        if isinstance(part, Equation):
            part = replace(part, steps=tuple(chosen(step) for step in part.steps))  # type: ignore[arg-type]
        parts.append(chosen(part))
    return replace(construction, parts=tuple(parts))  # type: ignore[arg-type]
