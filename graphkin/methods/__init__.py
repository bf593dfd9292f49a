"""The planner: which equation next. Everything here reads topology; numbers enter only to pick the assembly.

`plan` makes the three constructions of a mechanism once; `replay_all` carries them out, for the drawn
position or for any driver values, scalars or arrays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from graphkin.errors import HigherClass
from graphkin.geometry import Value
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods.assembly import pick_sides, refuse_bad_positions
from graphkin.methods.equivalent import lower_pairs
from graphkin.methods.hops import Slip, Twist, halves
from graphkin.methods.motion import Labels, motion
from graphkin.methods.position import position
from graphkin.methods.refusals import refuse_unsolved
from graphkin.methods.stages import Bridge, Carry, Group, Loop, Stage, stages
from graphkin.methods.structure import Sliding, Structure
from graphkin.steps import Construction, Equation, Facts, Meet, Plot, Site, Step, Swing, replay
from graphkin.value import frozen

__all__ = ["Method", "plan", "replay_all"]


@frozen
class Method:
    """How a mechanism is solved on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    coincident  points at which links move past each other, with the link whose point the hinge there is
    """

    mechanism: Mechanism
    structure: Structure
    stages: tuple[Stage, ...]
    position: Construction
    velocity: Construction
    acceleration: Construction
    coincident: Mapping[str, str]

    @property
    def doubtful(self) -> bool:
        """Whether constraints and drivers, counted by the formula, do not add up: some repeat others, or clash."""
        return any(isinstance(stage, Bridge) for stage in self.stages) or self.structure.surplus != 0

    @property
    def constructions(self) -> tuple[Construction, Construction, Construction]:
        return self.position, self.velocity, self.acceleration

    @property
    def sites(self) -> Mapping[str, Site]:
        """Every point written in the polygons (`C`, `B3`) as a point of the mechanism on a link."""
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
    structure = Structure(lower_pairs(mechanism))
    order, left = stages(structure)
    left += tuple(body for stage in order if isinstance(stage, Group) for body in stage.bodies)
    if left:
        names = list(dict.fromkeys(structure.home(body) for body in left))
        raise HigherClass(mechanism.where("links", names[0]), tuple(names))
    coincident = _coincident(structure, order)
    labels = Labels(structure, coincident)
    drawn, choices = position(structure, order)
    pole = _pole(mechanism)
    velocity, at = motion(structure, order, labels, "velocity", pole, lambda site: "")
    acceleration, _ = motion(structure, order, labels, "acceleration", pole, at)
    sides = pick_sides(structure, drawn, choices, _facts(structure, None))
    drawn = _with_sides(drawn, sides)
    return Method(mechanism, structure, order, drawn, velocity, acceleration, coincident)


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
    drivers = mechanism.drivers
    return Facts(
        frame=FRAME,
        shapes=structure.shapes,
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
    """Points at which links move past a moving link, with the link of which the hinge there is a point."""
    found: dict[str, str] = {}
    for stage in order:
        for hop in _jumps(structure, stage):
            if FRAME not in (hop.seen_from.link, hop.of.link) or isinstance(hop, Twist):
                owners = structure.owners[hop.of.point]
                homes = [site.link for site in (hop.of, hop.seen_from) if site.link in owners]
                if homes:
                    found.setdefault(hop.of.point, structure.home(homes[0]))
    return found


def _jumps(structure: Structure, stage: Stage) -> list[Slip | Twist]:
    """The coincident points of one stage."""
    if isinstance(stage, Loop):
        _, left, _, right = halves(structure, stage)
        return [hop for hop in left + right if isinstance(hop, Slip | Twist)]
    if isinstance(stage, Carry) and isinstance(stage.by, Sliding):
        pair = structure.slides[stage.by.slide]
        ends = (Site(pair.point, pair.guide), Site(pair.point, structure.block(pair)))
        return [Slip(ends[0], ends[1], True, pair.name)]
    return []


def _with_sides(construction: Construction, sides: tuple[int, ...]) -> Construction:
    """The construction with the crossings that the sketch asks for."""
    parts: list[Step | Equation] = []
    for part in construction.parts:
        if isinstance(part, Equation):
            parts.append(replace(part, steps=tuple(_chosen(step, sides) for step in part.steps)))
        else:
            parts.append(_chosen(part, sides))
    return replace(construction, parts=tuple(parts))


def _chosen(step: Step, sides: tuple[int, ...]) -> Step:
    if isinstance(step, Meet | Swing) and step.choice is not None:
        return replace(step, side=sides[step.choice])
    return step
