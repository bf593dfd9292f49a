"""The column of equations of a polygon: each with the steps that it needs, and a row for each other motion."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import pairwise

from graphkin.base.value import frozen
from graphkin.construction import Image, Plane
from graphkin.planning.method import Act, Method
from graphkin.planning.needed import acts_of_equations
from graphkin.say.entry import Calculation, Entry, Sentence, VectorEquation


@frozen
class Rung:
    """An equation, or the relation of another motion; page: the first act that draws it; numbers: of its steps."""

    equation: VectorEquation | str
    page: int | None = None
    numbers: tuple[int, ...] = ()


def rungs(entries: Iterable[Entry], plane: Plane, method: Method) -> Iterator[Rung]:
    """Every equation that the words print, in the order of solving; a relation whose step an equation counts as its own
    has no rung."""
    equations: list[tuple[VectorEquation | str, Act | None]] = []
    for entry in entries:
        if isinstance(entry, VectorEquation):
            equations.append((entry, None))
        elif isinstance(entry, Sentence) and entry.act is not None:  # of several that are solved together, of all
            equations = [(equation, first if isinstance(equation, str) else first or entry.act)
                         for equation, first in equations]  # fmt: skip
        if isinstance(entry, Sentence) and entry.row:
            equations.append((entry.row, entry.act))
        elif isinstance(entry, Calculation) and entry.relation:
            equations.append((f"{entry.name} = {entry.formulas[0]}", None))
    acts = [act for equation, act in equations if act is not None and not isinstance(equation, str)]
    told = {act for equation, act in equations if isinstance(equation, str)}
    needs = [[*_at_once(own, told)] for own in acts_of_equations(method, plane, acts)]
    known, steps = {act for each in needs for act in each if not isinstance(act.done, Image)}, iter(needs)
    for k, (equation, act) in enumerate(equations):
        page = next((later.page for _, later in equations[k:] if later is not None), None)
        if not isinstance(equation, str):
            own = () if act is None else next(steps)
            yield Rung(equation, page, tuple(each.number for each in own if each in known))
        elif act not in known:
            yield Rung(equation, page, () if act is None else (act.number,))


def _at_once(acts: Sequence[Act], told: Collection[Act | None]) -> Iterator[Act]:
    """The steps of an equation but for those with a row of their own that are not followed at once by the others; an
    image has its row between them."""
    own = [act for act in acts if not (isinstance(act.done, Image) and act in told)]
    gaps = [act.number for act, other in pairwise(own) if other.number > act.number + 1]
    first = max(gaps, default=0)
    yield from (act for act in acts if act.number > first or act not in told)
