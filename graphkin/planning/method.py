"""`Method`: what planning gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Construction, Facts, Fit, Roll, Site
from graphkin.model.mechanism import Driver, Mechanism
from graphkin.planning.acts import Act, acts
from graphkin.planning.special import Ternary
from graphkin.planning.stages import Bridge, Group, Stage
from graphkin.planning.starting_facts import facts_of
from graphkin.planning.structure import Topology

if TYPE_CHECKING:
    from graphkin.planning.redundancy import SetAside


@frozen
class Method:
    """How a mechanism is solved on paper: three constructions, planned once from its topology.

    stages  the order of solution: bodies carried along, and loops with two unknown scalars
    coincident  points at which links move past each other, with the link whose point the hinge there is
    near, drawn angles by link and displacements by `slide_key` at the drawn position: where fitting starts,
                and from where rolling counts
    ternaries   the special point of each Class III group
    aside       the constraints that repeat others (虚约束)
    """

    mechanism: Mechanism
    structure: Topology
    stages: tuple[Stage, ...]
    position: Construction
    velocity: Construction
    acceleration: Construction
    coincident: Mapping[str, str]
    near: Mapping[str, float]
    drawn: Mapping[str, float]
    ternaries: Mapping[Group, Ternary]
    aside: tuple[SetAside, ...] = ()

    @property
    def drivers(self) -> tuple[Driver, ...]:
        """The drivers, each with its value at the drawn position."""
        return self.structure.mechanism.drivers

    @cached_property
    def moves_on(self) -> bool:
        """Whether positions hang on how they are reached from the drawn one: where links are fitted, or wheels roll."""
        return any(isinstance(step, Fit | Roll) for step in self.position.steps)

    @cached_property
    def fits(self) -> bool:
        """Whether links are fitted: each such position is found from one close by."""
        return any(isinstance(step, Fit) for step in self.position.steps)

    @cached_property
    def size(self) -> float:
        """The longest reach of a link from its first point [m]: what small parts are measured by."""
        shapes = (tuple(shape.values()) for shape in self.structure.shapes.values())
        return max(abs(z - shape[0]) for shape in shapes for z in shape) or 1.0

    @property
    def doubtful(self) -> bool:
        """Whether constraints and drivers, counted by the formula, do not add up: some repeat others, or clash."""
        bridged = any(isinstance(stage, Bridge) for stage in self.stages)
        return bridged or bool(self.aside) or self.structure.surplus != 0

    @property
    def special(self) -> frozenset[str]:
        """The special points, which no link of the file has."""
        return frozenset(found.name for found in self.ternaries.values())

    @cached_property
    def nodes_of_links(self) -> Mapping[str, Mapping[str, str]]:
        """By moving link: its points that the polygons show, with the velocity polygon's point."""
        found: dict[str, dict[str, str]] = {}
        owners = self.mechanism.owners
        for node in self.velocity.nodes.values():
            if node.site is not None and node.site.point in owners:
                links = owners[node.site.point] if node.site.link in owners[node.site.point] else (node.site.link,)
                for link in links:
                    found.setdefault(link, {}).setdefault(node.site.point, node.name)
        return found

    @property
    def constructions(self) -> tuple[Construction, Construction, Construction]:
        return self.position, self.velocity, self.acceleration

    @cached_property
    def acts(self) -> tuple[Act, ...]:
        """What each sentence of the solution tells the pencil to do, with its number."""
        return acts(self.constructions, self.mechanism.unnamed)

    @property
    def sites(self) -> Mapping[str, Site]:
        """Every point written in the polygons (`C`, `B3`) as a point of the mechanism on a link."""
        nodes = self.velocity.nodes.values()
        return {node.of: node.site for node in nodes if node.site is not None}

    def facts(self, values: Sequence[Value] | None = None) -> Facts:
        """Dimensions, and drivers at the drawn position or at other values [rad, m]."""
        return facts_of(self.structure, values, self.drawn)
