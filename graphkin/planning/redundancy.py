"""Which constraints a textbook would set aside first, if they repeat others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from graphkin.base.tolerances import RANK
from graphkin.base.value import frozen
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import PairName
from graphkin.model.pairs import Pair
from graphkin.planning.constraint_jacobian import ConstraintRow, ConstraintRows
from graphkin.planning.ranks import rank
from graphkin.planning.structure import Topology


@frozen
class SetAside:
    """One constraint that repeats others.

    pair   as in the file
    part   "whole", or only what keeps a "line", an "angle", or rolling without slip ("slip"); a "link" on hinges
    rows   its equations
    held   the pairs that hold the same already
    body   of a link on hinges, in the planner's structure
    """

    pair: PairName
    part: str
    rows: tuple[ConstraintRow, ...]
    held: tuple[PairName, ...] = ()
    body: str = ""


@frozen
class PairEquations:
    """The pairs of a mechanism, in file and structure; `labels` are the equations there are."""

    mechanism: Mechanism
    structure: Topology
    labels: frozenset[ConstraintRow]

    def all(self) -> list[SetAside]:
        """Links on hinges, whole pairs, parts of pairs; the last in the file first, what is asked for at the end."""
        wholes, lines, slips, angles = (list[SetAside]() for _ in range(4))
        for pair in self._pairs():
            rows = tuple(
                row for kind in ("line", "angle", "slip") if (row := ConstraintRow(kind, pair.name)) in self.labels
            )
            name = self.mechanism.path(pair)
            wholes += [SetAside(name, "whole", rows)] if rows else []
            match [row.kind for row in rows]:
                case ["line", "slip"]:
                    lines.append(SetAside(name, "line", rows[:1]))
                    slips.append(SetAside(name, "slip", rows[1:]))
                case ["line", "angle"]:
                    angles.append(SetAside(name, "angle", rows[1:]))
                case _:
                    pass  # it goes whole, or not at all
        return [*self.links(), *wholes, *lines, *slips, *angles]

    def _pairs(self) -> list[Pair]:
        """The pairs that may go, the last in the file first; drivers and poses need theirs."""
        m = self.mechanism
        needed = {driver.link for driver in m.drivers if driver.kind == "slide"}
        needed |= {pose.link for pose in m.poses if pose.kind == "slide"}
        asked = {word for question in m.ask for word in question.split()}
        ranked = [
            (pair.name not in asked, m.lines.get(m.path(pair), 0), k)
            for k, pair in enumerate(m.pairs)
            if pair.name not in needed
        ]
        return [m.pairs[k] for *_, k in sorted(ranked, reverse=True)]

    def links(self) -> Iterator[SetAside]:
        """Links that only hang on hinges, undriven, the last first."""
        structure, m = self.structure, self.mechanism
        busy = {name for slide in structure.mechanism.slides for name in (slide.guide, slide.block)}
        busy |= {body for contact in structure.contacts for body, _ in contact.angles}
        busy |= {FRAME, *structure.followers}
        busy |= {name for driver in m.drivers for name in (driver.link, driver.from_link)}
        busy |= {name for pose in m.poses for name in (pose.link, pose.from_link)}
        pinned = {slide.point for slide in structure.mechanism.slides if slide.block is None}
        for link in reversed(tuple(structure.mechanism.links.values())):
            joints = [p for p in link.points if len(structure.owners[p]) > 1]
            carried = any(p in pinned and len(m.owners.get(p, ())) < 2 for p in link.points)
            hub = any(len(structure.owners[p]) > 2 and structure.owners[p][0] == link.name for p in joints)
            if link.name not in busy and len(joints) > 1 and not carried and not hub:
                yield SetAside(self._meant(link.name), "link", self._hinges(link.name, joints), (), link.name)

    def _meant(self, link: str) -> PairName:
        """A link of the file; one of the equivalent stands for its pair."""
        if link in self.mechanism.links:
            return "links", link
        pair = self.structure.mechanism.links[link].stands_for
        assert pair is not None
        return self.mechanism.path(pair)

    def _hinges(self, link: str, joints: Iterable[str]) -> tuple[ConstraintRow, ...]:
        rows = []
        for point in joints:
            hub, *others = [body for body in self.structure.owners[point] if not self.structure.is_pin(body)]
            rows += [ConstraintRow("hinge", point, body) for body in (others[:1] if hub == link else [link])]
        return tuple(rows)

    def pair_of(self, row: ConstraintRow) -> PairName:
        m = self.mechanism
        if row.kind == "hinge":
            return ("hinge", row.name) if row.body in m.links else self._meant(row.body)
        return m.path(m.pair(row.name))

    def holding(self, each: SetAside, whole: ConstraintRows, kept: ConstraintRows) -> list[PairName]:
        """The pairs whose equations add up to those of one."""
        shares = np.linalg.lstsq(kept.slopes.T, whole.only(each.rows).T, rcond=RANK)[0]
        rows = [row for row, share in zip(kept.labels, shares, strict=True) if np.max(np.abs(share)) > RANK]
        found = dict.fromkeys(self.pair_of(row) for row in rows if row.kind != "given")
        higher = [pair for pair in found if pair[0] not in ("hinge", "links")]
        return higher or list(found)


def over(rows: ConstraintRows, found: Iterable[SetAside]) -> tuple[SetAside, ...]:
    """Those of which some equations are left that say nothing more than the other rows do; one after another."""
    left: list[SetAside] = []
    for each in found:
        inside = [row for row in each.rows if row in rows.labels]
        fewer = rows.without(inside)
        if each.part != "link" and inside and rank(fewer.slopes) == rank(rows.slopes):
            rows = fewer
            left.append(each)
    return tuple(left)
