"""Marking measured from outside: problems kept aside, students who draw by rules of their own, and a judge.

    python tests/marking/assess.py [--problems cam,wheel] [--students 10] [--json] [--table] [--second] [--cli]

Nothing is asserted here; test_aside.py holds a part of it against goals. PYTHONPATH decides which graphkin is measured.
Students of three kinds in four write three digits, the fourth two. They draw with a pencil of 0.3 mm and 0.3 deg.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import random
import subprocess
import sys
import tempfile
import time
import tomllib
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from zlib import crc32

import numpy as np
from aside_solutions import SOLUTIONS
from by_hand import Given, NoCrossing, Paper, Wrong, printed, written

from graphkin import api
from graphkin.homework.grading import Pencils, key_for
from graphkin.marking import MISTAKES
from graphkin.marking.marker import Marker
from graphkin.marking.records import HandedNumber, Marked, StudentWork

HERE = Path(__file__).parent / "aside"
ALL_NORMALS = ("normal-omitted", "normal-outward", "normal-not-laid-off")
APPLICABLE = 1.5  # a mistake that moves no asked value by so many tolerances is no matter for marking
MOST = 6  # places and forms of one kind of mistake in one problem

AS = {  # other ids that mean the same, beside a mistake's own: of trees that lack it, or by another way to the same
    "driver-reversed-one": {"driver-reversed"},
    "degrees-for-radians": {"conversion"},
    "normal-doubled": {"diameter-for-radius"},
}
AS_OF = {("diameter-for-radius", "normal"): {"normal-doubled", "normal-size"}, ("omega-sense", "ratio"): {"centre-ratio"}}
"""By the operation, too: half a length in omega^2 l is a wrong size of it; a wheel's sense is that of the ratio."""
SLIP = "slip"


def accepted(wrong: Wrong) -> set[str]:
    ids = {wrong.id} | AS.get(wrong.id, set())
    for op, _ in wrong.edits:
        ids |= AS_OF.get((wrong.id, op), set())
    return ids


# --- students ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Submission:
    """What one student hands in. kind: "right", "mistake", "slip", "slip hidden", "slip last", "random", "pair", "stranger"."""

    kind: str
    values: Mapping[str, float]
    wrongs: tuple[Wrong, ...] = ()
    digits: int = 3
    of: str = ""


class Problem:
    """One of the twelve, with its key, and the students who solve it."""

    def __init__(self, name: str, students: int = 10, others: int | None = None) -> None:
        """students: of each mistake; others: by which the number of all others grows, as many where left out."""
        self.name, self.students, self.others = name, students, others or students
        self.path = HERE / f"{name}.toml"
        self.given, self.solve = Given(tomllib.loads(self.path.read_text("utf-8"))), SOLUTIONS[name]
        mechanism = api.load(str(self.path))
        self.key = key_for(mechanism, Pencils(0.3, 0.3))
        self.marker = Marker(self.key)
        self.asked = {entry.text: entry for entry in self.key.entries if entry.points}
        self.rng = random.Random(crc32(name.encode()))
        self.right = self.drawn()
        self.unseen = 0  # mistakes that can be made and move nothing that is asked
        self.number = {entry.text: k for k, entry in enumerate(self.key.entries)}
        assert all(abs(self.right[t] - e.right) < 1e-6 * abs(e.right) for t, e in self.asked.items()), name

    def drawn(
        self, wrongs: Sequence[Wrong] = (), slips: Mapping[str, float] | None = None, rng: random.Random | None = None,
        given: Given | None = None,
    ) -> dict[str, float]:  # fmt: skip
        """What a student gets: what is asked, and what is on the way."""
        edits = {spot: change for wrong in wrongs for spot, change in wrong.edits.items()}
        paper = Paper(self.key.marking.scales, edits, slips, rng)
        self.solve(paper, given or self.given)
        values = paper.values
        for wrong in wrongs:
            if wrong.written:
                values = {**values, **wrong.written({t: values[t] for t in self.asked})}
        return values

    def moved(self, values: Mapping[str, float], from_: Mapping[str, float] | None = None) -> dict[str, float]:
        """By how many tolerances each asked value differs from the right one, or from another."""
        base = from_ or self.right
        return {t: abs(values[t] - base[t]) / e.tolerance for t, e in self.asked.items()}

    @cached_property
    def wrongs(self) -> list[Wrong]:
        """The mistakes that can be made and matter."""
        paper = Paper(self.key.marking.scales)
        self.solve(paper, self.given)
        found = list(paper.can)
        for id in ALL_NORMALS:
            some = [w for w in found if w.id == id and not self._driven(w)]
            if len(some) > 1:
                edits = {spot: change for wrong in some for spot, change in wrong.edits.items()}
                found.append(Wrong(id, "all", edits))
        reversed_ = [w for w in found if w.id == "driver-reversed-one"]
        if reversed_:
            found.append(Wrong("driver-reversed", "all", {s: c for w in reversed_ for s, c in w.edits.items()}))
        found += written({t: e.unit.replace("rad/s^2", "rad/s2") for t, e in self.asked.items()}, self.right, self.key.marking.scales)
        matter = []
        for wrong in found:
            try:
                values = self.drawn([wrong])
            except (NoCrossing, ValueError):
                continue
            if max(self.moved(values).values()) > APPLICABLE:
                matter.append(wrong)
            else:
                self.unseen += 1
        by_id: dict[str, list[Wrong]] = defaultdict(list)
        for wrong in matter:
            by_id[wrong.id].append(wrong)
        pick = random.Random(7)
        return [w for some in by_id.values() for w in (some if len(some) <= MOST else pick.sample(some, MOST))]

    @staticmethod
    def _driven(wrong: Wrong) -> bool:
        return any(name in ("BA", "AO", "DE", "PB", "PO") for _, name in wrong.edits)

    def _student(
        self, kind: str, wrongs: Sequence[Wrong] = (), slips: Mapping[str, float] | None = None, of: str = "",
        given: Given | None = None,
    ) -> Submission | None:  # fmt: skip
        for _ in range(20):
            try:
                values = self.drawn(wrongs, slips, self.rng, given)
                break
            except (NoCrossing, ValueError):
                continue
        else:
            return None
        return self._submission(kind, values, tuple(wrongs), of)

    def _submission(self, kind: str, values: Mapping[str, float], wrongs: tuple[Wrong, ...] = (), of: str = "") -> Submission:
        digits = 2 if self.rng.random() < 0.25 else 3
        return Submission(kind, {t: printed(values[t], digits) for t in self.asked}, wrongs, digits, of)

    def class_(self) -> list[Submission]:
        """Everybody."""
        n = self.others
        students: list[Submission | None] = [self._student("right") for _ in range(max(40, 4 * n))]
        for wrong in self.wrongs:
            students += [self._student("mistake", [wrong]) for _ in range(self.students)]
        students += [self._slip("slip") for _ in range(5 * n)]
        students += [self._slip("slip hidden") for _ in range(2 * n)]
        students += [self._slip("slip last") for _ in range(2 * n)]
        students += [self._random() for _ in range(6 * n)]
        students += [self._pair() for _ in range(4 * n)]
        students += [self._stranger() for _ in range(2 * n)]
        return [one for one in students if one is not None]

    @cached_property
    def _slippery(self) -> dict[str, list[str]]:
        """By kind of slip, the values that may slip: asked and others follow, not asked, asked and nothing follows."""
        kinds: dict[str, list[str]] = {"slip": [], "slip hidden": [], "slip last": []}
        for text in self.right:
            moved = self.moved(self.drawn(slips={text: 1.5}))
            follow = any(x > 0.3 for t, x in moved.items() if t != text)
            if text in self.asked:
                kinds["slip" if follow else "slip last"].append(text)
            elif follow:
                kinds["slip hidden"].append(text)
        return kinds

    def _slip(self, kind: str) -> Submission | None:
        texts = self._slippery[kind]
        if not texts:
            return None
        for _ in range(50):
            text = self.rng.choice(texts)
            factor = 5.0 ** self.rng.uniform(-1, 1)
            if abs(factor - 1) < 0.15:
                continue
            if text.startswith(("omega", "alpha")) and self.rng.random() < 0.2:
                factor = -factor
            try:
                if max(self.moved(self.drawn(slips={text: factor})).values()) > APPLICABLE:
                    return self._student(kind, (), {text: factor}, text)
            except (NoCrossing, ValueError):
                continue
        return None

    def _random(self) -> Submission:
        rng = self.rng
        values = {t: self.right[t] * 5.0 ** rng.uniform(-1, 1) * rng.choice((-1, 1)) for t in self.asked}
        sized = {t: abs(x) if t[0] in "va" and not t.startswith("alpha") else x for t, x in values.items()}
        return self._submission("random", sized)

    def _pair(self) -> Submission | None:
        for _ in range(50):
            two = self.rng.sample(self.wrongs, 2)
            if two[0].places & two[1].places or two[0].id == two[1].id or all(one.written for one in two):
                continue
            two.sort(key=lambda one: one.written is not None)
            try:
                both, singles = self.drawn(two), [self.drawn([one]) for one in two]
            except (NoCrossing, ValueError):
                continue
            if all(max(self.moved(both, other).values()) > APPLICABLE for other in (self.right, *singles)):
                return self._student("pair", two)
        return None

    def _stranger(self) -> Submission | None:
        """Another student's numbers: the crank stood elsewhere."""
        other = Given(self.given.document, self.rng.choice((-1, 1)) * self.rng.uniform(12, 35), self.rng.uniform(0.7, 1.4))
        return self._student("stranger", given=other)

    def same(self, wrongs: Sequence[Wrong], names: Iterable[tuple]) -> bool:
        """Whether one of the named mistakes has the consequences of these, to a standard deviation of the pencil."""
        try:
            values = self.drawn(wrongs)
        except (NoCrossing, ValueError):
            return False
        singles = self.key.singles
        rows = [k for k, row in enumerate(singles.names) if tuple(row) in {tuple(name) for name in names}]
        return any(self._near(values, singles.values[row]) for row in rows)

    def _near(self, values: Mapping[str, float], row: np.ndarray) -> bool:
        judged = False
        for text, entry in self.asked.items():
            other = row[self.number[text]]
            if np.isfinite(other):
                judged = True
                mine = values[text]
                if entry.sort == "size":
                    mine, other = abs(mine), abs(other)
                # what is larger than the right value errs by so much more
                scatter = entry.tolerance / 3 * max(1.0, abs(other / entry.right))
                if abs(mine - other) > max(scatter, 0.005 * abs(other)):
                    return False
        return judged


# --- the judge ---------------------------------------------------------------------------------


@dataclass
class Told:
    """One submission with what marking made of it."""

    problem: str
    submission: Submission
    ids: tuple[str, ...]
    wrong_items: int  # asked values that do not earn full credit
    judged_wrong: bool
    outcome: str
    moved: int = 0

    @property
    def named(self) -> bool:
        return self.outcome in ("named", "alone")


def outcome_of(problem: Problem, one: Submission, marked: Marked) -> str:
    """alone, named; equal: another mistake with the same consequences; slip; wrong; nothing."""
    explanations = marked.diagnosis.explanations
    if not explanations:
        return "nothing"
    first = explanations[0]
    ids = set(first.ids)
    if len(one.wrongs) == 2:
        both = [bool(accepted(w) & ids) for w in one.wrongs]
        if any(both):
            return "both" if all(both) else "one"
        return "slip" if SLIP in ids else "wrong"
    true = accepted(one.wrongs[0]) if one.wrongs else set()
    if true & ids:
        return "alone" if ids <= true else "named"
    if SLIP in ids:
        return "slip"
    return "equal" if one.wrongs and problem.same(one.wrongs, first.names) else "wrong"


def told(problem: Problem, one: Submission, marked: Marked) -> Told:
    items = [j for j in marked.judged if j.points > 0 and j.text in problem.asked]
    ids = marked.diagnosis.explanations[0].ids if marked.diagnosis.explanations else ()
    moved = 0
    if len(one.wrongs) == 1:
        moved = sum(x > APPLICABLE for x in _moved(problem, one.wrongs[0]).values())
    lost = sum(j.credit < 1 - 1e-9 for j in items)
    wrong = any(j.verdict not in ("right", "dead point", "too small") for j in items)
    return Told(problem.name, one, tuple(ids), lost, wrong, outcome_of(problem, one, marked), moved)


@cache
def _moved(problem: Problem, wrong: Wrong) -> dict[str, float]:
    return problem.moved(problem.drawn([wrong]))


Wrong.__hash__ = lambda self: id(self)  # type: ignore[method-assign]


@dataclass
class Measure:
    """Everybody's outcomes, and the time that marking took [s]."""

    told: list[Told] = field(default_factory=list)
    seconds: float = 0.0
    alone_seconds: float = 0.0
    problems: list[Problem] = field(default_factory=list)

    def of(self, *kinds: str) -> list[Told]:
        return [one for one in self.told if one.submission.kind in kinds]


def works(problem: Problem, class_: Sequence[Submission]) -> list[StudentWork]:
    return [StudentWork(f"s{k}", {t: HandedNumber(x) for t, x in one.values.items()}) for k, one in enumerate(class_)]


def measure(
    names: Sequence[str], students: int, class_of: Mapping[str, Sequence[Submission]] | None = None, others: int | None = None,
) -> Measure:  # fmt: skip
    """All problems; class_of: students drawn up before, by problem."""
    found = Measure()
    for name in names:
        problem = Problem(name, students, others)
        class_ = list(class_of[name]) if class_of else problem.class_()
        handed = works(problem, class_)
        problem.marker.mark(handed[:1])  # what is made once a problem is no student's time
        start = time.process_time()
        marks = problem.marker.mark(handed)
        found.seconds += time.process_time() - start
        some = handed[:: max(1, len(handed) // 20)]
        start = time.process_time()
        for work in some:
            problem.marker.mark([work])
        found.alone_seconds += (time.process_time() - start) / len(some) / len(names)
        found.told += [told(problem, one, mark) for one, mark in zip(class_, marks, strict=True)]
        found.problems.append(problem)
    return found


# --- the report --------------------------------------------------------------------------------


def share(some: Sequence[Told], test) -> float:
    return sum(map(test, some)) / len(some) if some else math.nan


def summary(found: Measure) -> dict[str, float]:
    """The figures that have goals, as parts of 1; costs in items, times in milliseconds."""
    right, single, slips = found.of("right"), found.of("mistake"), found.of("slip")
    pairs, known = found.of("pair"), [one for one in single if accepted(one.submission.wrongs[0]) & set(MISTAKES)]
    three = [one for one in single if one.submission.digits == 3]
    by_id: dict[str, list[Told]] = defaultdict(list)
    for one in single:
        by_id[one.submission.wrongs[0].id].append(one)
    costs = {id: float(np.mean([one.wrong_items for one in some])) for id, some in by_id.items()}
    blamed = lambda one: bool(one.ids) and SLIP not in one.ids  # noqa: E731
    return {
        "students": len(found.told),
        "named first": share(single, lambda one: one.named),
        "named first or an equal": share(single, lambda one: one.named or one.outcome == "equal"),
        "items: ids in the set named, mean": float(np.mean([len(one.ids) for one in single if one.named] or [math.nan])),
        "named alone": share(single, lambda one: one.outcome == "alone"),
        "named first, ids this tree knows": share(known, lambda one: one.named),
        "named first, three digits": share(three, lambda one: one.named),
        "named first, mean of kinds": float(np.mean([share(some, lambda one: one.named) for some in by_id.values()])),
        "wrong mistake named": share(single, lambda one: one.outcome == "wrong"),
        "mistake told as a slip": share(single, lambda one: one.outcome == "slip"),
        "carried slips blamed": share(slips, blamed),
        "carried slips, first id no slip": share(slips, lambda one: bool(one.ids) and one.ids[0] != SLIP),
        "carried slips told as slips": share(slips, lambda one: SLIP in one.ids),
        "hidden slips blamed": share(found.of("slip hidden"), blamed),
        "last slips blamed": share(found.of("slip last"), blamed),
        "right, a value judged wrong": share(right, lambda one: one.judged_wrong),
        "right, same, three digits": share([o for o in right if o.submission.digits == 3], lambda one: one.judged_wrong),
        "right, a mistake named": share(right, lambda one: bool(one.ids)),
        "random diagnosed": share(found.of("random"), lambda one: bool(one.ids)),
        "stranger diagnosed": share(found.of("stranger"), lambda one: bool(one.ids)),
        "pairs, both": share(pairs, lambda one: one.outcome == "both"),
        "pairs, one": share(pairs, lambda one: one.outcome == "one"),
        "pairs, wrong": share(pairs, lambda one: one.outcome == "wrong"),
        "items a mistake, mean": float(np.mean([one.wrong_items for one in single])) if single else math.nan,
        "items a mistake, largest kind": max(costs.values(), default=math.nan),
        "items a carried slip": float(np.mean([one.wrong_items for one in slips])) if slips else math.nan,
        "ms a submission, in a class": 1e3 * found.seconds / max(len(found.told), 1),
        "ms a submission, alone": 1e3 * found.alone_seconds,
    }


def table(found: Measure, by) -> list[tuple[str, int, int, float, float, float, float, float]]:
    """Rows by kind of mistake (or another grouping): places, students, named, equal, slip, wrong, items."""
    groups: dict[str, list[Told]] = defaultdict(list)
    for one in found.of("mistake"):
        groups[by(one)].append(one)
    rows = []
    for name, some in sorted(groups.items()):
        places = len({(one.problem, one.submission.wrongs[0].of) for one in some})
        parts = [share(some, lambda one, k=k: one.outcome in k) for k in (("named", "alone"), ("equal",), (SLIP,), ("wrong",))]
        rows.append((name, places, len(some), *parts, float(np.mean([one.wrong_items for one in some]))))
    return rows


def confusions(found: Measure, kinds: Sequence[str] = ("mistake", "slip", "right", "random")) -> list[tuple[int, str]]:
    """Wrong mistakes that were named, by problem, most frequent first."""
    seen: Counter[str] = Counter()
    for one in found.of(*kinds):
        if one.outcome == "wrong":
            wrongs = one.submission.wrongs
            what = f"{wrongs[0].id} [{wrongs[0].of}]" if wrongs else f"{one.submission.kind} {one.submission.of}"
            seen[f"{one.problem}: {what} -> {', '.join(one.ids)}"] += 1
    return [(count, text) for text, count in seen.most_common(40)]


def report(found: Measure, full: bool) -> Iterator[str]:
    for name, x in summary(found).items():
        yield f"{name:36} {x:8.1f}" if name == "students" or name.startswith(("items", "ms")) else f"{name:36} {100 * x:8.2f} %"
    heads = f"{'':30} places students  named  equal   slip  wrong  items"
    for title, by in (
        ("by mistake", lambda one: one.submission.wrongs[0].id), ("by problem", lambda one: one.problem),
        ("by values moved", lambda one: str(min(one.moved, 4))), ("by digits", lambda one: str(one.submission.digits)),
    ):  # fmt: skip
        yield f"\n{title}\n{heads}"
        for name, places, count, named, equal, slip, wrong, items in table(found, by):
            mark = " " if title != "by mistake" or name in MISTAKES else "*"
            yield f"{name + mark:30} {places:6} {count:8} {named:6.0%} {equal:6.0%} {slip:6.0%} {wrong:6.1%} {items:6.2f}"
    yield "* an id that this tree does not have"
    yield "\nother students by problem: right wrong/named, slips blamed, random diagnosed, pairs both/one/wrong, unseen mistakes"
    for problem in found.problems:
        mine = Measure([one for one in found.told if one.problem == problem.name])
        s = summary(mine)
        yield (f"{problem.name:14} {s['right, a value judged wrong']:6.1%} {s['right, a mistake named']:6.1%} "
               f"{s['carried slips blamed']:6.1%} {s['random diagnosed']:6.1%}  {s['pairs, both']:5.0%} {s['pairs, one']:5.0%} "
               f"{s['pairs, wrong']:5.0%} {problem.unseen:5}")  # fmt: skip
    parts = [e.tolerance / abs(e.right) for p in found.problems for e in p.asked.values() if e.right]
    yield f"\nasked {len(parts)}; tolerance of the value: median {np.median(parts):.1%}, over 15 %: {np.mean(np.array(parts) > 0.15):.1%}"
    if full:
        yield "\nwrong ones named"
        for count, text in confusions(found):
            yield f"{count:4} {text}"
        yield "\nnot named, by place (students of all)"
        groups: dict[str, list[Told]] = defaultdict(list)
        for one in found.of("mistake"):
            groups[f"{one.submission.wrongs[0].id} [{one.submission.wrongs[0].of}] {one.problem}, moves {one.moved}"].append(one)
        for name, some in sorted(groups.items()):
            if (missed := sum(not one.named for one in some)) > len(some) / 4:
                outcomes = Counter(one.outcome for one in some if not one.named)
                yield f"{missed:3}/{len(some)} {name}: {dict(outcomes)}"


# --- a second road: students drawn up by graphkin itself ----------------------------------------


def second_road(names: Sequence[str], students: int) -> Measure:
    """Single mistakes alone, drawn by graphkin's own hand with the mistake's rewrite."""
    from graphkin.marking.consequences import rewrites
    from graphkin.marking.pencil import Slips
    from graphkin.marking.tolerances import Drawings, pencil_of

    classes: dict[str, list[Submission]] = {}
    for name in names:
        problem, pick = Problem(name), random.Random(3)
        marker = problem.marker
        known = rewrites(marker.method, marker.plot, marker.quantities, problem.key.marking.scales)
        by_id: dict[str, list] = defaultdict(list)
        for one in known:
            by_id[one.id].append(one)
        some = [w for each in by_id.values() for w in (each if len(each) <= MOST else pick.sample(each, MOST))]
        drawings = Drawings.of(marker.method, pencil_of(problem.key.marking), Slips(11, students))
        drawn = drawings.values(marker.quantities, [(one,) for one in some])
        columns = [problem.number[t] for t in problem.asked]
        class_ = classes[name] = []
        for rewrite, values in zip(some, drawn[:, :, columns], strict=True):
            middle = dict(zip(problem.asked, np.median(values, axis=0), strict=True))
            if not np.isfinite(values).all() or max(problem.moved(middle).values()) < APPLICABLE:
                continue
            wrong = Wrong(rewrite.id, " ".join((rewrite.of, rewrite.form, rewrite.way)))
            class_ += [problem._submission("mistake", dict(zip(problem.asked, row, strict=True)), (wrong,)) for row in values.tolist()]
    return measure(names, students, classes)


# --- by the command line -----------------------------------------------------------------------


def by_command(name: str) -> str:
    """A class in one CSV file through `graphkin grade`: are its marks those of `Marker`?"""
    problem = Problem(name, 2)
    class_ = problem.class_()
    marks = problem.marker.mark(works(problem, class_))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "class.csv"
        with path.open("w", newline="") as stream:
            rows = csv.writer(stream)
            rows.writerow(["student", *problem.asked])
            rows.writerows([f"s{k}", *one.values.values()] for k, one in enumerate(class_))
        main = "from graphkin.cli import main; main()"
        run = [sys.executable, "-c", main, "grade", str(problem.path), str(path), "--pencil", "0.3,0.3", "--json"]
        done = subprocess.run(run, capture_output=True, text=True, check=False)
    lines = {record["student"]: record for record in map(json.loads, done.stdout.splitlines())}
    same = sum(abs(lines[one.student]["score"] - one.score) < 1e-6 for one in marks if one.student in lines)
    return f"{name}: exit {done.returncode}, {len(class_)} students, {len(lines)} records, {same} scores alike; {done.stderr.strip()[-300:]}"


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--problems", default=",".join(SOLUTIONS))
    options.add_argument("--students", type=int, default=10)
    options.add_argument("--json", action="store_true", help="the figures alone, as one JSON object")
    options.add_argument("--table", action="store_true", help="with what was confused, and the places that are not named")
    options.add_argument("--second", action="store_true", help="students drawn up by graphkin's own hand, single mistakes only")
    options.add_argument("--cli", action="store_true", help="a class through the command line")
    chosen = options.parse_args()
    names = chosen.problems.split(",")
    if chosen.cli:
        print(*(by_command(name) for name in names), sep="\n")
        return
    found = (second_road if chosen.second else measure)(names, chosen.students)
    if chosen.json:
        print(json.dumps(summary(found), indent=1))
    else:
        print(*report(found, chosen.table), sep="\n")


if __name__ == "__main__":
    main()
