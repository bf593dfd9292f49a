"""Marking: many students' numbers at once, against one key."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from threading import Lock
from typing import Literal

import numpy as np

from graphkin import files as loading
from graphkin import planning
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.marking.after_mistake import aftermath
from graphkin.marking.answers import readable
from graphkin.marking.board_marks import board_marks
from graphkin.marking.carried import Carried, CarriedProblem
from graphkin.marking.consequences import rewrites
from graphkin.marking.diagnosis import SLIP, Diagnosis, Diagnostician
from graphkin.marking.directions import WrittenDirections
from graphkin.marking.drawing_order import DrawnAt, drawing_order
from graphkin.marking.hand import redraw
from graphkin.marking.key import Hypotheses, Key, KeyEntry, Name, agrees, columns, sense_only
from graphkin.marking.key_making import by_other_methods, make_key, pairs_of, wider
from graphkin.marking.read_off import OffDrawing, as_handed_in, pointing, read_off
from graphkin.marking.records import Departure, Drawn, Judged, Marked, StudentWork, Verdict, as_one, by_position
from graphkin.marking.rewrite import Rewrite
from graphkin.marking.synonyms import called_as_asked, other_ways, same_answers
from graphkin.marking.weights import shifts
from graphkin.model.quantities import Moving, Quantity, Rotation
from graphkin.planning import Method
from graphkin.planning.asked import PLANES, all_motions
from graphkin.running import replay_all

_HALF = 0.5  # what a value is worth whose sense or whose unit alone is wrong
_LARGE = 1e30
_FIRSTS = 200  # the pairs of so many first mistakes are kept
_STEP = 0.05  # errors of photographs are rounded up to a multiple [mm]
_FURTHER = 40  # so many quantities of a student beyond those of the key are marked at most


class Marker:
    """A key at work. The mechanism is planned anew from the key's text, where no method is given."""

    def __init__(self, key: Key, method: Method | None = None) -> None:
        self.key, self.table = key, columns(key.entries)
        self._method = method
        self._further: dict[str, Quantity | None] = {}
        self._wider: Marker | None = None
        self._pairs: dict[Name | None, Hypotheses] = {}
        self._blurred: dict[tuple[int, frozenset[tuple[str, float]]], Marker] = {}
        self._lock = Lock()

    @cached_property
    def method(self) -> Method:
        return self._method or planning.plan(loading.loads(self.key.text, name=self.key.name), self.key.coincident)

    @cached_property
    def plot(self) -> Plot:
        return replay_all(self.method)

    @cached_property
    def quantities(self) -> tuple[Quantity, ...]:
        """Of the key's entries."""
        quantities = (readable(self.method.mechanism, entry.text) for entry in self.key.entries)
        return tuple(quantity for quantity in quantities if quantity is not None)

    @cached_property
    def problem(self) -> CarriedProblem:
        return CarriedProblem(self.key, self.method, self.plot, self.quantities)

    @cached_property
    def directions(self) -> WrittenDirections:
        return WrittenDirections(self.problem)

    def off_drawing(
        self, drawn: Drawn, vectors: Mapping[str, complex], written: Mapping[str, float]
    ) -> tuple[OffDrawing, dict[str, bool]]:
        """The asked values that a drawing at this position determines, and whether its known arrows point as they must.

        drawn    as in `Graded`; vectors: those that were measured, by quantity; written: numbers beside it
        """
        arrows, entries = self.problem.arrows, dict(zip(self.quantities, self.key.entries, strict=True))
        moving = {q: vectors[e.text] for q, e in entries.items() if isinstance(q, Moving) and e.text in vectors}
        turning = {q: written[e.text] for q, e in entries.items() if isinstance(q, Rotation) and e.text in written}
        asked = [quantity for quantity, entry in entries.items() if entry.points]
        off = read_off(self.method, self.plot, arrows, drawn, asked)
        good = pointing(self.method, self.plot, arrows, drawn, moving, turning)
        texts = {quantity.text: entry.text for quantity, entry in entries.items()}
        renamed = OffDrawing({texts[q]: x for q, x in off.values.items()}, tuple(texts[q] for q in off.no_sense))
        return renamed, {texts[quantity]: points for quantity, points in good.items()}

    def pairs(self, first: Name | None) -> Hypotheses:
        """The outcomes of two mistakes."""
        if first not in self._pairs:
            if len(self._pairs) > _FIRSTS:
                self._pairs.clear()
            self._pairs[first] = pairs_of(self.method, self.plot, self.key, self.quantities, self.known, first)
        return self._pairs[first]

    @cached_property
    def other_methods(self) -> Hypotheses:
        return by_other_methods(self.method, self.key, self.quantities)

    @cached_property
    def positions(self) -> tuple[Marker, ...]:
        """One for each position that is asked for, this one for the first."""
        return self, *(Marker(key) for key in self.key.further)

    @cached_property
    def of_board(self) -> Marker:
        """For work at a drawing board, which has boxes for all motions where the file asks for nothing: these count."""
        if self.method.mechanism.ask:
            return self
        boxes = all_motions(self.method.mechanism, PLANES[1:])
        key, texts = _widened(self.key, self.method, boxes), {quantity.text for quantity in boxes}
        entries = (replace(entry, points=float(entry.text in texts)) for entry in key.entries)
        return Marker(replace(key, entries=tuple(entries)), self.method)

    def mark(self, works: Sequence[StudentWork]) -> list[Marked]:
        """The marks of some students, in their order; they hang on nobody else's work."""
        if self.key.further:
            parts = zip(*(by_position(work, len(self.positions)) for work in works), strict=True)
            marks = (marker._mark_here(list(part)) for marker, part in zip(self.positions, parts, strict=bool(works)))
            return [as_one(work.student, some) for work, *some in zip(works, *marks, strict=True)]
        return self._mark_here(works)

    def _mark_here(self, works: Sequence[StudentWork]) -> list[Marked]:
        """At the drawn position."""
        renamed = []
        for work in works:  # the key's names for what was handed in under others
            same = sum(entry.text in work.numbers for entry in self._asked)
            as_asked = same in (len(self._asked), len(work.numbers))
            renamed.append(work if as_asked else called_as_asked(work, self._asked, self._same))
        works, asked = renamed, {entry.text for entry in self.key.entries}
        further = list(dict.fromkeys(text for work in works for text in work.numbers if text not in asked))
        if len(further) > _FURTHER and len(works) > 1:
            half = len(works) // 2
            return [*self._mark_here(works[:half]), *self._mark_here(works[half:])]
        with self._lock:  # threads that mark at once
            marker = self._widened(further[:_FURTHER])
        if any(work.error for work in works):  # each as exactly as its photograph is
            return [marker._of_photograph(work)._marks([work])[0] for work in works]
        return marker._marks(works)

    def _of_photograph(self, work: StudentWork) -> Marker:
        """A marker that allows for the error of what was measured on a photograph, too: it adds to the pencil's."""
        steps = math.ceil(work.error / _STEP)
        blur = frozenset((text, one.off) for text, one in work.numbers.items() if one.measured)
        if (steps, blur) not in self._blurred:
            if len(self._blurred) > _FIRSTS:
                self._blurred.clear()
            key, part, off = self.key, steps * _STEP / (self.key.marking.on_paper[0] or _STEP), dict(blur)
            more = [math.hypot(entry.scatter * part, off[entry.text]) if entry.text in off else 0.0
                    for entry in key.entries]  # fmt: skip
            self._blurred[steps, blur] = Marker(wider(key, np.array(more), self.method.mechanism.usual), self.method)
        return self._blurred[steps, blur]

    @cached_property
    def _asked(self) -> tuple[KeyEntry, ...]:
        return tuple(entry for entry in self.key.entries if entry.points)

    @cached_property
    def _same(self) -> dict[str, tuple[str, ...]]:
        """Other names of what is asked."""
        quantities = ((entry.text, readable(self.method.mechanism, entry.text)) for entry in self._asked)
        return {text: same_answers(self.method, self.plot, q) if q is not None else () for text, q in quantities}

    def _widened(self, texts: Sequence[str]) -> Marker:
        """A marker whose key has these quantities, too, as far as they are any, and others that it was asked before."""
        new = [text for text in texts if text not in self._further]
        if len(self._further) + len(new) > _FURTHER:
            self._further, new, self._wider = {}, list(texts), None
        known = self._further | {text: readable(self.method.mechanism, text) for text in new}
        if any(known[text] is not None for text in new):
            further = [quantity for quantity in known.values() if quantity is not None]
            self._wider = Marker(_widened(self.key, self.method, further), self.method)
        self._further = known  # last: an alarm may have ended it before
        return self._wider or self

    def _marks(self, works: Sequence[StudentWork]) -> list[Marked]:
        shape = (len(works), len(self.key.entries))
        numbers = [work.numbers.get(entry.text) for work in works for entry in self.key.entries]
        # numbers beyond all sizes are only large
        values = [np.nan if number is None else min(max(number.value, -_LARGE), _LARGE) for number in numbers]
        given = np.array(values, dtype=float).reshape(shape)
        # a number with a unit of another kind is judged by itself, and nothing is made of it
        strange = np.array([one is not None and not one.unit_right for one in numbers], dtype=bool).reshape(shape)
        right, wrong = self.judged(given)
        off = np.array([0.0 if one is None else one.off for one in numbers]).reshape(shape)
        doubtful = off > self.table.scatter / np.sqrt(2)  # less exact than what a pencil draws
        untold = np.isfinite(given) & ~right & ~wrong & ~strange & ~doubtful
        own = wrong & ~strange & ~doubtful
        carried = self.problem.carried(given, own, wrong)
        measured = np.array([one is not None and one.measured for one in numbers], dtype=bool).reshape(shape)
        if measured.any():
            # what is measured on a drawing follows from all that was drawn before it: only own values that are asked
            # for, and so have cost something, are carried on to it
            asked = np.array([entry.points > 0 for entry in self.key.entries])
            of_asked = self.problem.carried(given, own & (asked | ~measured), wrong)
            carried = carried.instead(of_asked, measured)
        if any(one is not None and one.vector is not None for one in numbers):
            used = own & ~carried.unused
            near = self.problem.near(given, np.where(np.isnan(carried.values), self.table.right, carried.values))
            works = [self.directions.judged(work, given[k], used[k], near[k]) for k, work in enumerate(works)]
            numbers = [work.numbers.get(entry.text) for work in works for entry in self.key.entries]
            follows = {divmod(at, shape[1]): one.follows for at, one in enumerate(numbers) if one and one.follows}
            carried = carried.pointing(follows, self.table.right)
            wrong = wrong | carried.agrees
        diagnosed = self.diagnoses(np.where(strange, np.nan, given), wrong & ~strange)
        diagnosed = [self._as_handed_in(work, one) for work, one in zip(works, diagnosed, strict=True)]
        astray = np.array([one is not None and one.points is False for one in numbers], dtype=bool).reshape(shape)
        costs = self._costs(diagnosed)
        carried = carried.rooted(wrong, costs)
        after = self._after(given, wrong & ~strange, carried, astray, diagnosed, costs)
        given = np.where(doubtful & ~wrong, np.nan, given)
        return [
            self._marked(work, k, given[k], right[k], untold[k], carried, after, diagnosed[k])
            for k, work in enumerate(works)
        ]

    def _costs(self, diagnosed: Sequence[Diagnosis]) -> np.ndarray:
        """Flags (students, n) of the values that cost something: of a slip that was named, then of what is asked."""
        costs = np.where(self.table.points > 0, self._ranks, self._ranks + self._ranks.max() + 1)
        costs = np.repeat(costs[None], len(diagnosed), axis=0)
        for k, one in enumerate(diagnosed):
            for id, _, texts, _ in one.likeliest:
                if id == SLIP:
                    costs[k, [self._numbers[text] for text in texts]] = -1.0
        return costs

    @cached_property
    def _numbers(self) -> dict[str, int]:
        return {entry.text: n for n, entry in enumerate(self.key.entries)}

    def _after(
        self, given: np.ndarray, wrong: np.ndarray, carried: Carried, astray: np.ndarray,
        diagnosed: Sequence[Diagnosis], costs: np.ndarray,
    ) -> AfterMistake:  # fmt: skip
        """Of the values that a student's named mistakes explain all follow but the first that each moves."""
        explains, left = np.zeros_like(wrong), (wrong & ~carried.agrees) | astray
        values = np.full(given.shape, np.nan)
        named = [k for k, one in enumerate(diagnosed) if one.explanations]
        for k in named:
            explains[k, [self._numbers[text] for text in diagnosed[k].explanations[0].explains]] = True
        drawn = [k for k in named if all(name in self.known for name in diagnosed[k].likeliest)]
        if drawn:
            columns = [tuple(self.known[name] for name in diagnosed[k].likeliest) for k in drawn]
            outcomes = aftermath(self.problem, columns, given[drawn], wrong[drawn] & ~explains[drawn])
            values[drawn] = outcomes.values
            explains[drawn] |= self.problem.near(given[drawn], outcomes.values) & wrong[drawn]
            explains[drawn] |= outcomes.turned & astray[drawn]
        with np.errstate(invalid="ignore"):
            off = np.abs(given - carried.values)
            nearer = carried.agrees & (off > self.table.tolerance) & (np.abs(given - values) < off)
        both, explains = explains & nearer, explains & left
        # an arrow of the right size that was found by lines only follows: it costs where nothing else does
        costs = np.where(astray & ~wrong & ~self._laid, costs + costs.max(initial=0.0), costs)
        first = np.zeros_like(wrong)
        for k in named:
            for name in diagnosed[k].likeliest:
                own = explains[k] & ~first[k] & (self._moved_by.get(name, True) | astray[k])
                if own.any():
                    first[k, np.where(own, costs[k], np.inf).argmin()] = True
        explains |= both
        return AfterMistake(values, explains, explains & (given != 0) & ~first)  # nothing is gained by nought

    @cached_property
    def _laid(self) -> np.ndarray:
        """The vectors that are laid off where they are drawn (n,), as booleans."""
        laid = redraw(self.method, self.plot).laid
        arrows = (self.problem.arrows.of(q) if isinstance(q, Moving) else None for q in self.quantities)
        return np.array([arrow is not None and arrow[0] in laid for arrow in arrows], dtype=bool)

    @cached_property
    def _moved_by(self) -> dict[Name, np.ndarray]:
        """The values that each mistake moves (n,), as booleans."""
        moved = shifts(self.table, self.key.singles.values) > 1
        return {names[0]: row for names, row in zip(self.key.singles.names, moved, strict=True)}

    @cached_property
    def _order(self) -> list[DrawnAt]:
        return drawing_order(self.method, self.quantities, self.problem.arrows)

    @cached_property
    def _ranks(self) -> np.ndarray:
        """By which the quantities are in the order of the drawing, each its own number."""
        order = sorted(range(len(self._order)), key=lambda n: (self._order[n].rank, n))
        ranks = np.empty(len(order))
        ranks[order] = np.arange(len(order))
        return ranks

    def judged(self, given: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The values (students, n) that are right, and those that are wrong; neither where paper cannot tell."""
        table, dead = self.table, [entry.doubt == "dead point" for entry in self.key.entries]
        right, near = (agrees(table, given, table.right, allowed) for allowed in (table.allowed, table.tolerance))
        return right, np.isfinite(given) & ~right & ~near & ~np.array(dead, dtype=bool)

    def diagnoses(self, given: np.ndarray, wrong: np.ndarray) -> list[Diagnosis]:
        """Of those who have something wrong, together where they have handed in the same quantities."""
        every = [Diagnosis()] * len(given)
        off = np.flatnonzero(wrong.any(axis=1))
        if not off.size:
            return every
        patterns, number = np.unique(np.isfinite(given[off]), axis=0, return_inverse=True)
        for k in range(len(patterns)):
            some = off[number.reshape(-1) == k]
            each = self._diagnostician.diagnoses(given[some], wrong[some])
            for row, one in zip(some, each, strict=True):
                every[row] = one
        return every

    @cached_property
    def _diagnostician(self) -> Diagnostician:
        return Diagnostician(self.key, self.table, self.pairs, lambda: self.other_methods, self.problem.slips)

    def _as_handed_in(self, work: StudentWork, diagnosis: Diagnosis) -> Diagnosis:
        each = zip(self.key.entries, self.quantities, strict=True)
        numbers = {entry.text: (q, work.numbers[entry.text]) for entry, q in each if entry.text in work.numbers}
        telling = {text: (q, one) for text, (q, one) in numbers.items()
                   if one.worded or one.points is False or (one.points and one.vector is not None)}  # fmt: skip
        if not telling or not diagnosis.explanations:
            return diagnosis
        return as_handed_in(diagnosis, telling, self.method, self.plot, self.known)

    @cached_property
    def known(self) -> dict[Name, Rewrite]:
        """Every mistake's rewrite, by its name."""
        return {one.name: one for one in rewrites(self.method, self.plot, self.quantities, self.key.marking.scales)}

    def _marked(
        self, work: StudentWork, k: int, given: np.ndarray, right: np.ndarray, untold: np.ndarray, carried: Carried,
        after: AfterMistake, diagnosis: Diagnosis,
    ) -> Marked:  # fmt: skip
        senses = sense_only(self.table, given, self.table.right, self.table.tolerance) | carried.sense_only[k]
        judged = {
            n: Judged(entry.text, entry.unit, work.numbers[entry.text].value, entry.right, entry.tolerance,
                      "dead point" if entry.doubt == "dead point" else "too small")
            if untold[n]  # paper cannot tell it
            else self._judged(work, entry, n, given[n], bool(right[n]), bool(senses[n]), carried, after, k)
            for n, entry in enumerate(self.key.entries)
            if entry.points or entry.text in work.numbers or entry.text in work.unread
        }
        astray = [n for n, one in judged.items() if one.verdict == "wrong" and one.unit_right]
        departure = None
        if astray and not diagnosis.explanations:
            first = min(astray, key=lambda n: self._ranks[n])
            departure = Departure(self.key.entries[first].text, *self._order[first].names())
        board = board_marks(self.method, self.plot, self.problem.arrows, work)
        lines = (*judged.values(), *board.lines)
        return Marked(work.student, lines, diagnosis, departure, board.faults, board.step)

    def _judged(
        self, work: StudentWork, entry: KeyEntry, n: int, given: float, right: bool, sense_only: bool, carried: Carried,
        after: AfterMistake, k: int,
    ) -> Judged:  # fmt: skip
        """One quantity; the better of all verdicts counts."""
        if not np.isfinite(given) and (entry.text in work.unread or entry.text in work.numbers):
            return Judged(entry.text, entry.unit, None, entry.right, entry.tolerance, "not read", points=entry.points,
                          written=work.unread.get(entry.text, "?"))  # fmt: skip
        if not np.isfinite(given):
            return Judged(entry.text, entry.unit, None, entry.right, entry.tolerance, "missing", points=entry.points)
        number, explained, follows = work.numbers[entry.text], bool(after.explains[k, n]), bool(after.follows[k, n])
        unit_right, points = number.unit_right, number.points if entry.sort == "size" else None
        judged_by = after.values[k, n] if explained else carried.values[k, n]
        agrees = bool(carried.agrees[k, n]) or follows
        half = _HALF if right or sense_only else 0.0
        right = right and not number.follows and not (points is False and follows)  # a vector that points as they do
        verdict: Verdict = "right" if right else "carried" if agrees else "wrong"
        credit = 1.0 if right else max(self.key.marking.follows if agrees else 0.0, half)
        if not unit_right or (points is False and not follows):
            verdict, credit = "wrong", min(credit, _HALF)
        by = judged_by if verdict == "carried" and np.isfinite(judged_by) else entry.right
        sense: Literal["right", "wrong"] | None = None if points is None else "right" if points or follows else "wrong"
        if entry.sort == "sense" and by != 0:
            sense = "wrong" if (sense_only and not agrees) or np.sign(given) != np.sign(by) else "right"
        follows_from = np.isfinite(judged_by) and not right and (verdict == "carried" or not explained)
        turned = number.reversed and verdict == "wrong"
        ways = other_ways(self.method, self.plot, self.quantities[n]) if turned else ()
        return Judged(
            entry.text, entry.unit, number.value, entry.right, entry.tolerance, verdict, sense, unit_right,
            float(judged_by) if follows_from else None,
            carried.own(k, n) if not right and not explained else {}, carried.refused(k, n) if not right else (),
            credit, entry.points, number.measured, of_mistake=follows and verdict == "carried",
            reversed=turned, other=next((one.quantity.text for one in ways if one.kind == "reversed"), ""),
        )  # fmt: skip


@frozen
class AfterMistake:
    """The values of students (students, n) and the mistakes that were named for them.

    values    as the mistakes have them, with the students' own values beside; NaN where nothing is named
    explains  those that are wrong or astray and as they have it; follows: these but the first of each student
    """

    values: np.ndarray
    explains: np.ndarray
    follows: np.ndarray


def _widened(key: Key, method: Method, further: Sequence[Quantity]) -> Key:
    """The key with further quantities, which are worth nothing; what it says of its own stays."""
    own = [q for entry in key.entries if (q := readable(method.mechanism, entry.text)) is not None]
    wider = make_key(method, key.marking, (*own, *further))
    stored = {entry.text: entry for entry in key.entries}
    entries = tuple(stored.get(entry.text, replace(entry, points=0.0)) for entry in wider.entries)
    return replace(wider, entries=entries, name=key.name, text=key.text, title=key.title)
