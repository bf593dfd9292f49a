"""Redundant (passive) constraints (虚约束): what repeats the constraints of other pairs, found by rank.

What repeats others is set aside, as a textbook does before it counts freedoms and solves: of several, the one that
comes last in the file; none that is driven or posed, and none that is asked for while another will do. A link that
hangs on hinges alone is left where it is. Few mechanisms have any: this module is loaded for those.

The equations of all pairs are ranked at places close to the drawn one, so that a dead point, where they repeat each
other for an instant only, is not taken for one. A constraint that all but repeats others, and contradicts them by the
rest, is refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from graphkin.base.tolerances import CLOSED, RANK
from graphkin.base.value import frozen
from graphkin.errors import NotRepeated
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.naming import PairName, named
from graphkin.planning.constraint_jacobian import Array, ConstraintRows, Restraints, over
from graphkin.planning.structure import ConstraintRow, SetAside, Topology

_NUDGE = 0.05  # bodies are moved as far to see the general rank [size, rad]
_NUDGES = 4
_MISSED = 1e-8  # a gap of more than this contradicts [size, rad]
_LEAST = 1e-6  # lines that diverge by less do not [deg]
_NEAR = 0.03  # a constraint that repeats others but for this [rad, share of a length] was meant to
_RIGID = 0.2  # the same where the pairs let nothing move: then it is no driver that is too much


def redundant_constraints(mechanism: Mechanism, structure: Topology) -> tuple[SetAside, ...]:
    """The constraints that repeat others, in the order in which they are set aside. Raises NotRepeated for a constraint
    that comes close to repeating others, but contradicts them."""
    if structure.surplus <= 0:
        return ()
    given = [driver for driver in mechanism.drivers if driver.value is not None and driver.kind != "spin"]
    given += [Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)
              for pose in mechanism.poses]  # fmt: skip
    restraints = Restraints(structure, tuple(given))
    drawn, _ = restraints.drawn_place()
    candidates = PairEquations(mechanism, structure, frozenset(restraints.rows(drawn).labels))
    # the pairs' equations where they are most independent: at the drawn position, or next to it
    asked = [ConstraintRow("given", str(k)) for k in range(len(given))]
    places = [restraints.rows(drawn).without(asked)]
    rng, free = np.random.default_rng(3), places[0].freedom
    for _ in range(_NUDGES if len(free) else 0):
        move = rng.normal(0, 1, len(free)) @ free
        q, settled = restraints.settled(drawn + _NUDGE * move / np.max(np.abs(move)), asked, drawn)
        if settled.gap < CLOSED:
            places.append(restraints.rows(q).without(asked))
    whole = rows = max(places, key=lambda place: place.rank)
    aside: list[SetAside] = []
    for each in candidates.all():
        if all(row in rows.labels for row in each.rows):
            fewer, freed = rows.without(each.rows), 3 if each.part == "link" else 0
            if fewer.rank + freed == rows.rank:  # nothing moves more freely without it
                aside.append(each)
                rows = fewer
    contradictions = Contradictions(candidates, restraints)
    contradictions.refuse(aside, contradictions.near(rows))
    return tuple(replace(each, held=tuple(candidates.holding(each, whole, rows))) for each in aside)


def still_redundant(structure: Topology, redundant: Sequence[SetAside]) -> tuple[SetAside, ...]:
    """Those that repeat others even where wheels may slip and the drawn position's drivers and poses hold."""
    restraints = Restraints(structure, tuple(d for d in structure.mechanism.drivers if d.kind != "spin"))
    return over(restraints.rows(restraints.drawn_place()[0]), redundant)


@frozen
class PairEquations:
    """The pairs of a mechanism, in file and structure; `labels` are the equations there are."""

    mechanism: Mechanism
    structure: Topology
    labels: frozenset[ConstraintRow]

    def all(self) -> list[SetAside]:
        """Links on hinges, whole pairs, parts of pairs; the last in the file first, what is asked for at the end. Those
        that drivers and poses need may not go."""
        wholes, lines, slips, angles = (list[SetAside]() for _ in range(4))
        m = self.mechanism
        needed = {driver.link for driver in m.drivers if driver.kind == "slide"}
        needed |= {pose.link for pose in m.poses if pose.kind == "slide"}
        questions = {word for question in m.ask for word in question.split()}
        ranked = sorted((pair.name not in questions, m.lines.get(m.path(pair), 0), k)
                        for k, pair in enumerate(m.pairs) if pair.name not in needed)  # fmt: skip
        for pair in (m.pairs[k] for *_, k in reversed(ranked)):
            possible = (ConstraintRow(kind, pair.name) for kind in ("line", "angle", "slip"))
            rows = tuple(row for row in possible if row in self.labels)
            name = m.path(pair)
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
                rows = []
                for point in joints:
                    hinged = [body for body in structure.owners[point] if not structure.is_pin(body)]
                    others = hinged[1:2] if hinged[0] == link.name else [link.name]
                    rows += [ConstraintRow("hinge", point, body) for body in others]
                yield SetAside(self._name_in_file(link.name), "link", tuple(rows), (), link.name)

    def _name_in_file(self, link: str) -> PairName:
        """A link of the file; one of the equivalent stands for its pair."""
        if link in self.mechanism.links:
            return "links", link
        pair = self.structure.mechanism.links[link].stands_for
        assert pair is not None
        return self.mechanism.path(pair)

    def holding(self, each: SetAside, whole: ConstraintRows, kept: ConstraintRows) -> list[PairName]:
        """The pairs whose equations add up to those of one."""
        shares = np.linalg.lstsq(kept.slopes.T, whole.only(each.rows).T, rcond=RANK)[0]
        rows = [row for row, share in zip(kept.labels, shares, strict=True) if np.max(np.abs(share)) > RANK]
        pairs, m = dict[PairName, None](), self.mechanism
        for row in (row for row in rows if row.kind != "given"):
            if row.kind != "hinge":
                pairs[m.path(m.pair(row.name))] = None
            else:
                pairs[("hinge", row.name) if row.body in m.links else self._name_in_file(row.body)] = None
        return [pair for pair in pairs if pair[0] not in ("hinge", "links")] or list(pairs)


@frozen
class Contradictions:
    """The search for constraints that do not agree with the others."""

    candidates: PairEquations
    restraints: Restraints

    def near(self, rows: ConstraintRows) -> list[SetAside]:
        """The constraint that leaves the drivers no freedom though it all but repeats others."""
        freedoms = rows.slopes.shape[1] - rows.rank - len(self.restraints.structure.mechanism.idle)
        if freedoms >= len(self.restraints.structure.mechanism.drivers):
            return []
        most = _RIGID if freedoms <= 0 else _NEAR
        left = [each for each in self.candidates.all() if all(row in rows.labels for row in each.rows)]
        distances = [(rows.distance_of(each.rows), each) for each in left if each.part != "link"]
        close = [entry for entry in distances if entry[0] < most]
        if close:
            return [min(close, key=lambda entry: (entry[1].part != "whole", entry[0]))[1]]
        links = [each for each in left if each.part == "link" and freedoms <= 0 and self._almost_fits(each)]
        return sorted(links, key=lambda each: len(each.rows))[:1]

    def _almost_fits(self, link: SetAside) -> bool:
        """True if the other pairs by themselves all but keep the distance of its first two hinges."""
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
        others = every.without([*link.rows, *every.of_kind("given")]).slopes
        rest = length - length @ (np.linalg.pinv(others, rcond=RANK) @ others)
        return float(np.linalg.norm(rest)) < _RIGID * float(np.linalg.norm(length))

    def _gap(self, link: SetAside) -> tuple[float, Array]:
        """The length by which a link misses its hinges at the drawn position [size], and that position."""
        structure = self.restraints.structure
        first, *rest = dict.fromkeys(row.name for row in link.rows)
        loose = [row for row in link.rows if row.name != first]
        q, rows = self.restraints.drawn_place(loose)
        if rows.gap > CLOSED:
            return np.inf, q
        slips = self.restraints.rows(q).of_kind("slip")
        if slips and self.restraints.settled(q, slips)[1].gap < CLOSED:
            return 0.0, q  # wheels that roll may stand as they must for it
        start, gaps = self.restraints.place(link.body, first, q)[0], []
        for point in rest:
            other = next(b for b in structure.owners[point] if b != link.body and not structure.is_pin(b))
            here, there = (self.restraints.place(b, point, q)[0] - start for b in (link.body, other))
            gaps.append(abs(abs(here) - abs(there)))
        return max(gaps), q

    def refuse(self, aside: Sequence[SetAside], near: Sequence[SetAside]) -> None:
        """Refuses what the others do not meet at the drawn position, or do not let be when they move."""
        for link in (each for each in (*aside, *near) if each.part == "link"):
            gap, q = self._gap(link)
            if _MISSED < gap < np.inf:
                raise self._refusal(link, gap * self.restraints.size * 1e3, "mm", self.restraints.rows(q))
        if all(each.part == "link" for each in (*aside, *near)):
            return
        drawn = self.restraints.rows(self.restraints.drawn_place()[0])
        pairs = over(drawn.without(drawn.of_kind("slip")), (*aside, *near))
        q, kept = self.restraints.drawn_place([row for each in pairs for row in each.rows])
        if kept.gap > CLOSED:
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

    def _astray(self, each: SetAside, q: Array, rows: ConstraintRows) -> float:
        """The angle between a line and the path of its point; of anything else, how far it is from following [deg]."""
        slide, rows = self.restraints.structure.slides.get(each.rows[0].name), rows.without(rows.of_kind("given"))
        if slide is None or each.rows[0].kind != "line":
            return float(np.degrees(np.arcsin(min(1.0, rows.distance_of(each.rows)))))
        free = rows.without(each.rows).freedom
        across = self.restraints.along(slide, q)[1].imag @ free.T
        move = across @ free  # the motion that leads farthest off the line
        ends = (slide.guide, slide.line.origin), (self.restraints.carrier(slide), slide.point)
        speed = max(float(abs(self.restraints.place(*end, q)[1] @ move)) for end in ends)
        return float(np.degrees(np.arcsin(min(1.0, float(across @ across) / speed))))

    def _refusal(self, each: SetAside, off: float, unit: str, rows: ConstraintRows) -> NotRepeated:
        m, others = self.candidates.mechanism, self.candidates.holding(each, rows, rows.without(each.rows))
        held = tuple(named(m, pair) for pair in others if pair != each.pair)
        return NotRepeated(m.where(*each.pair), named(m, each.pair), held, off, unit)
