"""Mechanisms of one topology at their drawn positions, drawn at once by one method."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from graphkin.construction import Facts, Plot, replay
from graphkin.geometry import Value
from graphkin.mechanism import Mechanism
from graphkin.planning.equivalent import Contact, lower_pairs
from graphkin.planning.method import Method
from graphkin.planning.starting_facts import facts_of, with_sides
from graphkin.running.assemblies import Told, assembled_by_sketch, few_ways
from graphkin.running.contacts_at_once import (
    Standing,
    contacts_of,
    in_touch,
    side_by_side,
    standing,
    with_contacts,
)
from graphkin.running.program import TABLES
from graphkin.stacking import coincidences, cut, stacked
from graphkin.value import frozen


def goes_together(method: Method) -> bool:
    """Whether `at_once` may draw such mechanisms."""
    return few_ways(method)


@frozen
class AtOnce:
    """Mechanisms drawn by one method: values (n,), or (positions, n); which are sure, and each one's own crossings.

    near    angles and displacements at the drawn position, as `Method` has them, (n,) each
    lower, contacts, standing   their lower pairs, their wheels' contacts, and how they stand if poses say so
    """

    plot: Plot
    sides: Mapping[int, np.ndarray]
    near: Mapping[str, Value]
    sure: np.ndarray
    lower: tuple[Mechanism, ...] = ()
    contacts: tuple[tuple[Contact, ...], ...] = ()
    standing: Standing | None = None

    def method(self, template: Method, row: int, mechanism: Mechanism) -> Method:
        """One mechanism's own method."""
        sides = tuple(int(self.sides[choice][row]) for choice in sorted(self.sides))
        lower, ties, drawn = self.lower[row], self.contacts[row], dict[str, float]()
        if self.standing is not None:
            lower, drawn = self.standing.of(row, lower)
        structure = replace(template.structure, mechanism=lower, contacts=ties)
        own = with_contacts(template, structure) if ties else replace(template, structure=structure)
        return replace(
            own, mechanism=mechanism, position=with_sides(own.position, sides), drawn=drawn,
            near={name: float(value[row]) for name, value in self.near.items()},
        )  # fmt: skip

    def drawing(self, method: Method, row: int) -> Plot:
        """One mechanism's own drawing, at the drawn position."""
        plot = Plot(method.facts(), method.near)
        for name in TABLES:
            table = getattr(self.plot, name)
            setattr(plot, name, {key: value[row] if np.ndim(value) else value for key, value in table.items()})
        return plot


def at_once(method: Method, mechanisms: Sequence[Mechanism]) -> AtOnce | None:
    """Mechanisms of a method's topology at their drawn positions; None where they do not go together."""
    lower = tuple(map(lower_pairs, mechanisms))
    of_each = contacts_of(mechanisms, lower)
    many, ties = stacked(lower), side_by_side(of_each)
    if ties is None:
        return None
    sure, placed = alike(method, many, len(lower)), None
    if ties or many.poses:
        if (placed := standing(method, many)) is None:
            return None
        many, sure = placed.lower, sure & placed.sure
    structure = replace(method.structure, mechanism=many, contacts=ties)
    drawn: Mapping[str, Value] = {} if placed is None else placed.drawn
    facts = facts_of(structure, None, drawn)
    told = Told.by_sketch(method, structure, facts) if placed is None else Told.known(method, structure, drawn)
    found = drawn_at_once(with_contacts(method, structure) if ties else method, facts, many.sketch, None, told)
    sure = sure & found.sure & in_touch(of_each, ties, bool(method.mechanism.slides), found.plot)
    return replace(found, lower=lower, contacts=tuple(of_each), standing=placed, sure=sure)


def drawn_at_once(
    method: Method, facts: Facts, sketch: Mapping[str, Value], values: Sequence[Value] | None,
    told: Told | None = None,
) -> AtOnce:  # fmt: skip
    """`values` as `replay_many` has them; `told`: where links that are fitted start."""
    found = assembled_by_sketch(method, facts, sketch, told)
    if values is not None:
        facts = replace(facts, values=tuple(values))
    plot = Plot(facts, found.near)
    for construction in method.constructions:
        replay(construction, plot, found.sides)
    return AtOnce(plot, found.sides, found.near, found.sure)


def alike(method: Method, mechanism: Mechanism, count: int) -> np.ndarray:
    """In which mechanisms the points that lie in one place are those of the method's own: (count,)."""
    wanted, found = coincidences(method.structure.mechanism), coincidences(mechanism)
    same = (found.reshape(len(wanted), -1) == wanted[:, None]).all(axis=0)
    return np.array(np.broadcast_to(same, (count,)))


def facts_in(facts: Facts, part: slice) -> Facts:
    return replace(
        facts,
        shapes={link: {point: cut(z, part) for point, z in shape.items()} for link, shape in facts.shapes.items()},
        lines={slide: (guide, origin, cut(z, part)) for slide, (guide, origin, z) in facts.lines.items()},
        turns={body: replace(turn, constant=cut(turn.constant, part)) for body, turn in facts.turns.items()},
        values=tuple(cut(value, part) for value in facts.values),
        rates=tuple(cut(value, part) for value in facts.rates),
        accelerations=tuple(cut(value, part) for value in facts.accelerations),
    )
