"""Redundant (passive) constraints (虚约束): what repeats the constraints of other pairs, found by rank.

The equations of all pairs are ranked at places close to the drawn one, so that a dead point, where they repeat each
other for an instant only, is not taken for one. What repeats others is set aside, as a textbook does before it counts
freedoms and solves: of several, the one that comes last in the file; none that is driven or posed, and none that is
asked for while another will do. A link that hangs on hinges alone is left where it is (a `Bridge` is drawn last).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from graphkin.errors import NotRepeated
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.methods.restraints import Array, Restraints, Row, Rows, settled
from graphkin.methods.structure import Aside, Structure
from graphkin.naming import PairName, named
from graphkin.value import frozen

__all__ = ["SetAside", "as_aside", "repeated", "still_repeated"]

_RANK = 1e-6
"""Singular values below this count as zero."""
_CLOSED = 1e-9
"""Equations that are open by less hold [size, rad]."""
_MISSED = 1e-8
"""A gap of more than this contradicts [size, rad]."""
_NUDGE = 0.05
"""How far bodies are moved to see the general rank [size, rad]."""
_NUDGES = 4
_STARTS = 12
_NEAR = 0.1
"""A constraint that repeats others but for this [rad, share of a length] was meant to."""


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
    rows: tuple[Row, ...]
    held: tuple[PairName, ...] = ()
    body: str = ""


def repeated(mechanism: Mechanism, structure: Structure) -> tuple[SetAside, ...]:
    """What repeats others, in the order in which it is set aside.

    Raises NotRepeated for a constraint that comes close to repeating others, but contradicts them.
    """
    if structure.surplus + _idle(structure) <= 0:
        return ()
    return _Search(mechanism, Restraints(structure, tuple(_given(mechanism)))).found()


def as_aside(found: Iterable[SetAside]) -> Aside:
    """What the planner leaves out; links on hinges stay where they are."""
    pairs = [each for each in found if each.part != "link"]
    gone = {row for each in pairs for row in each.rows}
    return Aside(
        slides=frozenset(row.name for row in gone if row.kind == "line"),
        cams=frozenset(row.name for each in pairs if each.pair[0] == "cam" for row in each.rows),
        angles=frozenset(row.name for row in gone if row.kind == "angle" and Row("line", row.name) not in gone),
        contacts=frozenset(row.name for row in gone if row.kind == "slip"),
    )


def still_repeated(structure: Structure, found: Sequence[SetAside]) -> tuple[SetAside, ...]:
    """Those that repeat others even where wheels may slip and the drawn position's drivers and poses hold."""
    if not found:
        return ()
    restraints = Restraints(structure, tuple(d for d in structure.mechanism.drivers if d.kind != "spin"))
    return _over(restraints.rows(_drawn(restraints)[0]), found)


def _over(rows: Rows, found: Iterable[SetAside]) -> tuple[SetAside, ...]:
    """Those of which some equations are left that say nothing more than the other rows do; one after another."""
    left: list[SetAside] = []
    for each in found:
        inside = [row for row in each.rows if row in rows.labels]
        fewer = rows.without(inside)
        if each.part != "link" and inside and _rank(fewer.slopes) == _rank(rows.slopes):
            rows = fewer
            left.append(each)
    return tuple(left)


def _idle(structure: Structure) -> int:
    """Bodies of one point that nothing keeps from turning, and whose turning moves nothing: rollers."""
    tied = {name for slide in structure.mechanism.slides for name in (slide.guide, slide.block)}
    tied |= {body for contact in structure.contacts for body, _ in contact.angles}
    tied |= {name for driver in structure.mechanism.drivers for name in (driver.link, driver.from_link)}
    return sum(len(points) == 1 and body not in tied and not structure.is_pin(body)
               for body, points in structure.bodies.items() if body != FRAME)  # fmt: skip


def _given(mechanism: Mechanism) -> Iterator[Driver]:
    """The drivers and poses that hold at the drawn position."""
    for driver in mechanism.drivers:
        if driver.value is not None and driver.kind != "spin":
            yield driver
    for pose in mechanism.poses:
        yield Driver(pose.kind, pose.link, pose.vector, pose.from_link, pose.from_vector, pose.value)


def _rank(slopes: Array) -> int:
    return int(np.linalg.matrix_rank(slopes, tol=_RANK)) if slopes.size else 0


def _drawn(restraints: Restraints, aside: Sequence[Row] = ()) -> tuple[Array, Rows]:
    """The drawn position, as near to the sketch as it can be closed; nothing has rolled yet."""
    rng, best = np.random.default_rng(7), None
    for _ in range(_STARTS):
        q = restraints.sketched(rng)
        slips = [row for row in restraints.rows(q).labels if row.kind == "slip"]
        found = settled(restraints, q, [*slips, *aside])
        if best is None or np.sum(found[1].open**2) < np.sum(best[1].open**2):
            best = found
        if np.max(np.abs(best[1].open), initial=0.0) < _CLOSED:
            break
    assert best is not None
    return best


@dataclass(frozen=True)
class _Search:
    """The search for what repeats others in one mechanism."""

    mechanism: Mechanism
    restraints: Restraints

    @property
    def structure(self) -> Structure:
        return self.restraints.structure

    @cached_property
    def drawn(self) -> Array:
        return _drawn(self.restraints)[0]

    def found(self) -> tuple[SetAside, ...]:
        whole = rows = self._general()
        aside: list[SetAside] = []
        for candidate in self.candidates():
            if all(row in rows.labels for row in candidate.rows) and self._repeats(rows, candidate):
                aside.append(candidate)
                rows = rows.without(candidate.rows)
        self._refuse_contradictions(aside, self._contradicting(rows))
        return tuple(replace(each, held=tuple(self._held(each, whole, rows))) for each in aside)

    def _general(self) -> Rows:
        """The pairs' equations where they are most independent: at the drawn position, or next to it."""
        given = [Row("given", str(k)) for k in range(len(self.restraints.given))]
        start = self.restraints.rows(self.drawn).without(given)
        free = np.linalg.svd(start.slopes)[2][_rank(start.slopes) :]
        rng, places = np.random.default_rng(3), [start]
        for _ in range(_NUDGES if len(free) else 0):
            move = rng.normal(0, 1, len(free)) @ free
            moved = self.drawn + _NUDGE * move / np.max(np.abs(move))
            q, rows = settled(self.restraints, moved, given, self.drawn)
            if np.max(np.abs(rows.open), initial=0.0) < _CLOSED:
                places.append(self.restraints.rows(q).without(given))
        return max(places, key=lambda rows: _rank(rows.slopes))

    @staticmethod
    def _repeats(rows: Rows, candidate: SetAside) -> bool:
        """Whether nothing moves more freely without it."""
        fewer = rows.without(candidate.rows).slopes
        if candidate.part == "link":
            return _rank(fewer) + 3 == _rank(rows.slopes)
        return _rank(fewer) == _rank(rows.slopes)

    # --- what may be set aside ------------------------------------------------------------------

    def candidates(self) -> list[SetAside]:
        """Links on hinges, whole pairs, parts of pairs; the last in the file first, what is asked for at the end."""
        wholes, lines, slips, angles = (list[SetAside]() for _ in range(4))
        for pair in self._pairs():
            rows = self._rows_of(pair)
            wholes += [SetAside(pair, "whole", rows)] if rows else []
            if pair[0] == "roll" and len(rows) == 2:
                lines.append(SetAside(pair, "line", rows[:1]))
                slips.append(SetAside(pair, "slip", rows[1:]))
            elif pair[0] == "slide" and len(rows) == 2:
                angles.append(SetAside(pair, "angle", rows[1:]))
        return [*self._links(), *wholes, *lines, *slips, *angles]

    def _pairs(self) -> list[PairName]:
        """The pairs that may go, the last in the file first; drivers and poses need theirs."""
        m = self.mechanism
        needed = {driver.link for driver in m.drivers if driver.kind == "slide"}
        needed |= {pose.link for pose in m.poses if pose.kind == "slide"}
        asked = {word for question in m.ask for word in question.split()}
        tables = (("slide", m.slides), ("gear", m.gears), ("roll", m.rolls), ("cam", m.cams))
        ranked = []
        for order, (table, pairs) in enumerate(tables):
            for k, pair in enumerate(pairs):
                name = getattr(pair, "name", "")
                if name not in needed:
                    line = m.lines.get((table, k), 0)
                    ranked.append((name not in asked, line, order, k, (table, k)))
        return [pair for *_, pair in sorted(ranked, reverse=True)]

    def _rows_of(self, pair: PairName) -> tuple[Row, ...]:
        table, k = pair
        assert isinstance(k, int)
        names = {
            "slide": lambda: self.mechanism.slides[k].name,
            "gear": lambda: f"g{k}",
            "roll": lambda: self.mechanism.rolls[k].name,
            "cam": lambda: f"c{k}",
        }
        name = names[table]()
        kinds = {"slide": ("line", "angle"), "gear": ("slip",), "roll": ("line", "slip"), "cam": ("line",)}[table]
        return tuple(Row(kind, name) for kind in kinds if Row(kind, name) in self._labels)

    @cached_property
    def _labels(self) -> set[Row]:
        return set(self.restraints.rows(self.drawn).labels)

    def _links(self) -> Iterator[SetAside]:
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
        name = link.removeprefix("e ")
        for k, roll in enumerate(self.mechanism.rolls):
            if roll.name == name:
                return "roll", k
        return ("gear" if name[0] == "g" else "cam"), int(name[1:])

    def _hinges(self, link: str, joints: Iterable[str]) -> tuple[Row, ...]:
        rows = []
        for point in joints:
            hub, *others = [body for body in self.structure.owners[point] if not self.structure.is_pin(body)]
            rows += [Row("hinge", point, body) for body in (others[:1] if hub == link else [link])]
        return tuple(rows)

    # --- what only comes close ------------------------------------------------------------------

    def _contradicting(self, rows: Rows) -> list[SetAside]:
        """The constraint that leaves the drivers no freedom though it all but repeats others."""
        freedoms = rows.slopes.shape[1] - _rank(rows.slopes) - _idle(self.structure)
        if freedoms >= len(self.structure.mechanism.drivers):
            return []
        left = [each for each in self.candidates() if all(row in rows.labels for row in each.rows)]
        near = [(self._beside(rows, each), each) for each in left if each.part != "link"]
        close = [entry for entry in near if entry[0] < _NEAR]
        if close:
            return [min(close, key=lambda entry: (entry[1].part != "whole", entry[0]))[1]]
        return self._misfits([each for each in left if each.part == "link"])

    def _misfits(self, links: Sequence[SetAside]) -> list[SetAside]:
        """Of the links on hinges that all but fit one with the fewest hinges, the last in the file."""
        return sorted((each for each in links if self._gap(each)[0] < _NEAR), key=lambda each: len(each.rows))[:1]

    def _gap(self, link: SetAside) -> tuple[float, Array]:
        """How much too long or too short a link is for its hinges at the drawn position [size], and all rows there."""
        first, *rest = dict.fromkeys(row.name for row in link.rows)
        loose = [row for row in link.rows if row.name != first]
        q, rows = _drawn(self.restraints, loose)
        if np.max(np.abs(rows.open), initial=0.0) > _CLOSED:
            return np.inf, q
        start, gaps = self.restraints.place(link.body, first, q)[0], []
        for point in rest:
            other = next(b for b in self.structure.owners[point] if b != link.body and not self.structure.is_pin(b))
            here, there = (self.restraints.place(b, point, q)[0] - start for b in (link.body, other))
            gaps.append(abs(abs(here) - abs(there)))
        return max(gaps), q

    @staticmethod
    def _beside(rows: Rows, candidate: SetAside) -> float:
        """How far a constraint is from following from the others, 0 to 1."""
        others, own = rows.without(candidate.rows).slopes, rows.only(candidate.rows)
        back = np.linalg.pinv(others, rcond=_RANK) @ others
        return float(np.max(np.linalg.norm(own - own @ back, axis=1) / np.linalg.norm(own, axis=1)))

    def _refuse_contradictions(self, aside: Sequence[SetAside], near: Sequence[SetAside]) -> None:
        """Refuses what the others do not meet at the drawn position, or do not let be when they move."""
        for each in (*aside, *near):
            if each.part == "link":
                self._refuse_misfit(each)
        if all(each.part == "link" for each in (*aside, *near)):
            return
        drawn = self.restraints.rows(self.drawn)
        pairs = _over(drawn.without([row for row in drawn.labels if row.kind == "slip"]), (*aside, *near))
        q, kept = _drawn(self.restraints, [row for each in pairs for row in each.rows])
        if np.max(np.abs(kept.open), initial=0.0) > _CLOSED:
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
            raise self._refusal(each, self._astray(each, q, rows), "deg", rows)

    def _refuse_misfit(self, link: SetAside) -> None:
        gap, q = self._gap(link)
        if _MISSED < gap < np.inf:
            raise self._refusal(link, gap * self.restraints.size * 1e3, "mm", self.restraints.rows(q))

    def _astray(self, each: SetAside, q: Array, rows: Rows) -> float:
        """The angle between a line and the way of its point; of anything else, how far it is from following [deg]."""
        slide = self.structure.slides.get(each.rows[0].name)
        if slide is None or each.rows[0].kind != "line":
            return float(np.degrees(np.arcsin(min(1.0, self._beside(rows, each)))))
        kept = rows.without([*each.rows, *(row for row in rows.labels if row.kind == "given")]).slopes
        free = np.linalg.svd(kept)[2][_rank(kept) :]
        across = self.restraints.along(slide, q)[1].imag @ free.T
        move = across @ free  # the motion that leads farthest off the line
        ends = (slide.guide, slide.line.origin), (self.restraints.carrier(slide), slide.point)
        speed = max(abs(self.restraints.place(*end, q)[1] @ move) for end in ends)
        return float(np.degrees(np.arcsin(min(1.0, across @ across / speed))))

    def _refusal(self, each: SetAside, off: float, unit: str, rows: Rows) -> NotRepeated:
        m, held = self.mechanism, self._held(each, rows, rows.without(each.rows))
        held = [pair for pair in held if pair != each.pair]
        return NotRepeated(m.where(*each.pair), named(m, each.pair), tuple(named(m, pair) for pair in held), off, unit)

    # --- why --------------------------------------------------------------------------------------

    def _held(self, each: SetAside, whole: Rows, kept: Rows) -> list[PairName]:
        """The pairs whose equations add up to this one's."""
        own = whole.only(each.rows)
        shares = np.linalg.lstsq(kept.slopes.T, own.T, rcond=_RANK)[0]
        rows = [row for row, share in zip(kept.labels, shares, strict=True) if np.max(np.abs(share)) > _RANK]
        found = dict.fromkeys(self._pair_of(row) for row in rows if row.kind != "given")
        higher = [pair for pair in found if pair[0] not in ("hinge", "links")]
        return higher or list(found)

    def _pair_of(self, row: Row) -> PairName:
        m = self.mechanism
        if row.kind == "hinge":
            return ("hinge", row.name) if row.body in m.links else self._meant(row.body)
        for k, slide in enumerate(m.slides):
            if slide.name == row.name:
                return "slide", k
        for k, roll in enumerate(m.rolls):
            if roll.name == row.name:
                return "roll", k
        return ("gear" if row.kind == "slip" else "cam"), int(row.name[1:])
