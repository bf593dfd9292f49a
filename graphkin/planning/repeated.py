"""Redundant (passive) constraints (虚约束): what repeats the constraints of other pairs, found by rank.

What repeats others is set aside, as a textbook does before it counts freedoms and solves: of several, the one that
comes last in the file; none that is driven or posed, and none that is asked for while another will do. A link that
hangs on hinges alone is left where it is (a `Bridge` is drawn last). Few mechanisms have any: the search for them is
loaded for those.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from graphkin.model.mechanism import Mechanism
from graphkin.planning.structure import Aside, Topology

if TYPE_CHECKING:
    from graphkin.planning.redundancy import SetAside


def repeated(mechanism: Mechanism, structure: Topology) -> tuple[SetAside, ...]:
    """What repeats others, in the order in which it is set aside.

    Raises NotRepeated for a constraint that comes close to repeating others, but contradicts them.
    """
    if structure.surplus <= 0:
        return ()
    from graphkin.planning.repeat_search import search

    return search(mechanism, structure)


def as_aside(found: Iterable[SetAside]) -> Aside:
    """What the planner leaves out; links on hinges stay where they are."""
    pairs = [each for each in found if each.part != "link"]
    gone = {row for each in pairs for row in each.rows}
    lines = {row.name for row in gone if row.kind == "line"}
    return Aside(
        slides=frozenset(lines),
        angles=frozenset(row.name for row in gone if row.kind == "angle" and row.name not in lines),
        contacts=frozenset(row.name for row in gone if row.kind == "slip"),
    )


def still_repeated(structure: Topology, found: Sequence[SetAside]) -> tuple[SetAside, ...]:
    """Those that repeat others even where wheels may slip and the drawn position's drivers and poses hold."""
    if not found:
        return ()
    from graphkin.planning.repeat_search import still_over

    return still_over(structure, found)
