"""Constraints that all but repeat others, and contradict them by the rest: refused, with how much that is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphkin.base.tolerances import CLOSED, RANK
from graphkin.base.value import frozen
from graphkin.errors import NotRepeated
from graphkin.model.naming import named
from graphkin.planning.constraint_jacobian import Array, ConstraintRow, ConstraintRows, Restraints, settled
from graphkin.planning.ranks import beside, drawn_place, open_by, rank
from graphkin.planning.redundancy import PairEquations, SetAside, over

_MISSED = 1e-8
"""A gap of more than this contradicts [size, rad]."""
_LEAST = 1e-6
"""Lines that diverge by less do not [deg]."""
_NEAR = 0.03
"""A constraint that repeats others but for this [rad, share of a length] was meant to."""
_RIGID = 0.2
"""The same where the pairs let nothing move: then it is no driver that is too much."""


@frozen
class Contradictions:
    """What of some constraints does not agree with the others."""

    candidates: PairEquations
    restraints: Restraints

    def near(self, rows: ConstraintRows) -> list[SetAside]:
        """The constraint that leaves the drivers no freedom though it all but repeats others."""
        freedoms = rows.slopes.shape[1] - rank(rows.slopes) - len(self.restraints.structure.idle)
        if freedoms >= len(self.restraints.structure.mechanism.drivers):
            return []
        most = _RIGID if freedoms <= 0 else _NEAR
        left = [each for each in self.candidates.all() if all(row in rows.labels for row in each.rows)]
        near = [(beside(rows, each.rows), each) for each in left if each.part != "link"]
        close = [entry for entry in near if entry[0] < most]
        if close:
            return [min(close, key=lambda entry: (entry[1].part != "whole", entry[0]))[1]]
        links = [each for each in left if each.part == "link" and freedoms <= 0 and self._almost_fits(each)]
        return sorted(links, key=lambda each: len(each.rows))[:1]

    def _almost_fits(self, link: SetAside) -> bool:
        """Whether the other pairs by themselves all but keep the distance of its first two hinges."""
        gap, q = self._gap(link)
        if gap >= _RIGID:
            return False
        structure, every = self.restraints.structure, self.restraints.rows(q)
        first, second = list(dict.fromkeys(row.name for row in link.rows))[:2]
        ends = [next(b for b in structure.owners[point] if b != link.body and not structure.is_pin(b))
                for point in (first, second)]  # fmt: skip
        (one, slope), (other, more) = (self.restraints.place(body, point, q)
                                       for body, point in zip(ends, (first, second), strict=True))  # fmt: skip
        length = ((more - slope) * (other - one).conjugate()).real
        others = every.without([*link.rows, *_driving(every)]).slopes
        rest = length - length @ (np.linalg.pinv(others, rcond=RANK) @ others)
        return float(np.linalg.norm(rest)) < _RIGID * float(np.linalg.norm(length))

    def _gap(self, link: SetAside) -> tuple[float, Array]:
        """How much too long or too short a link is for its hinges at the drawn position [size], and all rows there."""
        structure = self.restraints.structure
        first, *rest = dict.fromkeys(row.name for row in link.rows)
        loose = [row for row in link.rows if row.name != first]
        q, rows = drawn_place(self.restraints, loose)
        if open_by(rows) > CLOSED:
            return np.inf, q
        slips = [row for row in self.restraints.rows(q).labels if row.kind == "slip"]
        if slips and open_by(settled(self.restraints, q, slips)[1]) < CLOSED:
            return 0.0, q  # wheels that roll may stand as they must for it
        start, gaps = self.restraints.place(link.body, first, q)[0], []
        for point in rest:
            other = next(b for b in structure.owners[point] if b != link.body and not structure.is_pin(b))
            here, there = (self.restraints.place(b, point, q)[0] - start for b in (link.body, other))
            gaps.append(abs(abs(here) - abs(there)))
        return max(gaps), q

    def refuse(self, aside: Sequence[SetAside], near: Sequence[SetAside]) -> None:
        """Refuses what the others do not meet at the drawn position, or do not let be when they move."""
        for each in (*aside, *near):
            if each.part == "link":
                self._refuse_misfit(each)
        if all(each.part == "link" for each in (*aside, *near)):
            return
        drawn = self.restraints.rows(drawn_place(self.restraints)[0])
        pairs = over(drawn.without([row for row in drawn.labels if row.kind == "slip"]), (*aside, *near))
        q, kept = drawn_place(self.restraints, [row for each in pairs for row in each.rows])
        if open_by(kept) > CLOSED:
            return  # something else does not close
        rows = self.restraints.rows(q)
        for each in pairs:
            for row in each.rows:
                gap = abs(float(rows.open[rows.labels.index(row)]))
                if gap > _MISSED:
                    angle = row.kind == "angle"
                    off = float(np.degrees(gap)) if angle else gap * self.restraints.size * 1e3
                    raise self._refusal(each, off, "deg" if angle else "mm", rows)
        for each in near:
            if each.part != "link" and (off := self._astray(each, q, rows)) > _LEAST:
                raise self._refusal(each, off, "deg", rows)

    def _refuse_misfit(self, link: SetAside) -> None:
        gap, q = self._gap(link)
        if _MISSED < gap < np.inf:
            raise self._refusal(link, gap * self.restraints.size * 1e3, "mm", self.restraints.rows(q))

    def _astray(self, each: SetAside, q: Array, rows: ConstraintRows) -> float:
        """The angle between a line and the way of its point; of anything else, how far it is from following [deg]."""
        slide, rows = self.restraints.structure.slides.get(each.rows[0].name), rows.without(_driving(rows))
        if slide is None or each.rows[0].kind != "line":
            return float(np.degrees(np.arcsin(min(1.0, beside(rows, each.rows)))))
        kept = rows.without(each.rows).slopes
        free = np.linalg.svd(kept)[2][rank(kept) :]
        across = self.restraints.along(slide, q)[1].imag @ free.T
        move = across @ free  # the motion that leads farthest off the line
        ends = (slide.guide, slide.line.origin), (self.restraints.carrier(slide), slide.point)
        speed = max(abs(self.restraints.place(*end, q)[1] @ move) for end in ends)
        return float(np.degrees(np.arcsin(min(1.0, across @ across / speed))))

    def _refusal(self, each: SetAside, off: float, unit: str, rows: ConstraintRows) -> NotRepeated:
        m, others = self.candidates.mechanism, self.candidates.holding(each, rows, rows.without(each.rows))
        held = tuple(named(m, pair) for pair in others if pair != each.pair)
        return NotRepeated(m.where(*each.pair), named(m, each.pair), held, off, unit)


def _driving(rows: ConstraintRows) -> list[ConstraintRow]:
    return [row for row in rows.labels if row.kind == "given"]
