"""How well photographs are measured: synthetic ones over mechanisms of the library, by hand, as it takes half an hour.

    python tests/photo/assess_photos.py [--count 300] [--aside] [--flat] [--jobs 2]

--aside  mechanisms and cameras that the reader was not tuned on; --flat: pages themselves, without any camera
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from cameras import ASIDE as CAMERAS_ASIDE
from cameras import CAMERAS, photograph
from pencil import HAND, NEAT, PER_MM, FlatPage, Work, paper_of

from graphkin.construction import LayOff, Meet, Plane, Ray
from graphkin.errors import NOWHERE
from graphkin.homework.grading.batch import marked
from graphkin.homework.grading.keys import key_from
from graphkin.homework.grading.sets import OneKey
from graphkin.marking.consequences import rewrites
from graphkin.marking.marker import Marker
from graphkin.marking.records import Graded
from graphkin.marking.rewrite import Rewrite
from graphkin.photo.measuring import PageReading, measured
from graphkin.photo.pictures import pictures_in
from graphkin.photo.predicted import own_velocities, predicted
from graphkin.photo.readings import RoomReading, SheetReading, as_drawing
from graphkin.photo.registering import RegisteredPage, registered
from graphkin.photo.sheets import PrintedSheet
from graphkin.submissions import Handed, Limits
from graphkin.submissions.students import Owner

TUNED = ("ex3-1", "ex3-5", "ex3-7", "fig3-1", "p3-15", "p3-12", "fig2-32", "s4-ex5", "p3-3a", "p3-19", "s4-ex7", "p3-11b")
ASIDE = ("p3-24a", "p3-20", "s3-cam", "s4-ex2", "p3-7", "ex3-4")
FLAT = "flat page"
_WRONG = {"wrong", "carried"}  # verdicts of what is not as it should be
WRONG, MOVED = 0.5, 1.5  # a corner off by more is wrong; a mistake is there to be seen that moves one by so much [mm]


@lru_cache(16)
def _mistakes(mechanism: str) -> tuple[Rewrite, ...]:
    drawing = paper_of(mechanism).problem.drawing
    return tuple(one for one in rewrites(drawing.method, drawing.plot) if one.edits)


def work_of(mechanism: str, kind: str, seed: int, wobble: bool) -> Work:
    """A student's work: "right", or with a "mistake" or a "slip" that is there to be seen and has room."""
    paper, rng, habits = paper_of(mechanism), np.random.default_rng([seed, 3]), HAND if wobble else NEAT
    some = (Work(paper, seed + 100_000 * k, habits=habits) for k in range(60))
    right = next(work for work in some if work.closes())
    for _ in range(60):
        if kind == "mistake":
            known = _mistakes(mechanism)
            work = Work(paper, seed, (known[rng.integers(len(known))],), habits=habits)
        elif kind == "slip":
            method = paper.problem.drawing.method
            steps = [(c.plane, step) for c in (method.velocity, method.acceleration) for step in c.steps
                     if isinstance(step, LayOff | Meet)]  # fmt: skip
            plane, step = steps[rng.integers(len(steps))]
            if isinstance(step, LayOff):
                work = Work(paper, seed, slips={("laid", plane, step.tip): rng.choice([-1.0, 0.5, 0.7, 1.3, 1.6, 2.0])}, habits=habits)
            else:
                rays = [ray for ray in (step.first, step.second) if isinstance(ray, Ray)]
                turn = np.exp(1j * np.radians(rng.choice([-1, 1]) * rng.uniform(8, 60)))
                work = Work(paper, seed, slips={("line", plane, step, rays[rng.integers(len(rays))]): turn}, habits=habits)
        else:
            return right
        moved = max((abs(at - right.corners[plane][name]) for plane, points in work.corners.items() for name, at in points.items()),
                    default=0.0)  # fmt: skip
        if moved > MOVED and work.fits():
            return work
    return right


@dataclass(frozen=True)
class Case:
    mechanism: str
    kind: str
    seed: int
    wobble: bool
    camera: str = FLAT


@dataclass
class Outcome:
    """What came of a picture: errors of the corners that are sure, those of others, the worst that goes unsaid [mm]; if it is named as it
    should be, None where a mistake does not show in what is asked."""

    case: Case
    sure: list[float] = field(default_factory=list)
    unsure: list[float] = field(default_factory=list)
    silent: float = 0.0
    named: bool | None = False
    refused: str = ""
    reasons: list[str] = field(default_factory=list)
    seconds: float = 0.0
    where: str = ""
    truth: str = ""
    rms: float = 0.0


def assessed(case: Case) -> Outcome:
    """One picture drawn, taken, and measured."""
    work = work_of(case.mechanism, case.kind, case.seed, case.wobble)
    outcome = Outcome(case, truth=_truth(work))
    page = _page(case, work, outcome)
    if page is None:
        return outcome
    drawing, velocity, readings = work.paper.problem.drawing, {}, dict[Plane, PageReading]()
    start = time.process_time()
    for plane, room in work.paper.rooms.items():
        reading = readings[plane] = measured(page, room, predicted(drawing.method, drawing.plot, room, velocity))
        left = {letter for one in reading.unsure for letter in one.letters or reading.vertices}
        velocity = own_velocities(RoomReading(room, reading.vertices, error=reading.error, unsure=reading.unsure))
        outcome.reasons += [f"{plane[0]}:{one.reason}{','.join(one.letters)}" for one in reading.unsure]
        for letter, at in reading.vertices.items():
            off = abs(at - work.corners[plane][letter])
            if letter != next(iter(reading.vertices)):
                (outcome.unsure if letter in left else outcome.sure).append(off)
            if letter not in left and off > outcome.silent:
                outcome.silent, outcome.where = off, f"{plane[0]}:{letter}"
    outcome.seconds += time.process_time() - start
    outcome.named = _is_named(work, readings)
    return outcome


def _truth(work: Work) -> str:
    return " ".join([*("/".join(one.name) for one in work.mistakes), *(str(spot[:3])[:60] for spot in work.slips)])


def _page(case: Case, work: Work, outcome: Outcome) -> FlatPage | RegisteredPage | None:
    """As it is registered on the picture; None where it is refused."""
    if case.camera == FLAT:
        return FlatPage(work.page())
    picture = photograph(work.page(), PER_MM, CAMERAS.get(case.camera) or CAMERAS_ASIDE[case.camera], case.seed)
    start = time.process_time()
    (read,) = pictures_in("a.jpg", picture.content, NOWHERE)
    (page,) = registered(read)
    outcome.seconds += time.process_time() - start
    if isinstance(page, RegisteredPage):
        return page
    outcome.refused = page.message("en")
    return None


@lru_cache(16)
def _judge(mechanism: str) -> OneKey:
    return OneKey(Marker(key_from(mechanism)))


def verdicts(work: Work, rooms: Mapping[Plane, PageReading]) -> tuple[bool, set[str]]:
    """What the judge says of what was measured: that something is wrong, and the mistakes that would explain it best."""
    problem, printed = work.paper.problem, PrintedSheet(1, "", "", 0.0, 0.0)
    poles: dict[Plane, str] = {"velocity": problem.drawing.method.velocity.pole, "acceleration": problem.drawing.method.acceleration.pole}
    each = (RoomReading(work.paper.rooms[plane], {poles[plane]: 0j, **one.vertices}, (), (), one.error, one.unsure, one.shifts)
            for plane, one in rooms.items())  # fmt: skip
    drawing = as_drawing([SheetReading(printed, "s", "a.jpg", (*each,))], [], lost=False)
    (record,) = marked([Handed(Owner("s", "s"), "a.jpg", drawing=drawing)], _judge(problem.drawing.method.mechanism.name), Limits(), "")
    if not isinstance(record, Graded) or record.marked is None:
        return False, set()
    best = record.marked.diagnosis.explanations[:1]
    return any(one.verdict in _WRONG for one in record.marked.judged), {id for one in best for id in one.ids}


def _is_named(work: Work, readings: Mapping[Plane, PageReading]) -> bool | None:
    """The judge finds nothing wrong in right work, and something in a slip; it names a mistake. None where it would not by the true corners."""
    truth = {plane: PageReading(corners, 0.0) for plane, corners in work.corners.items()}
    (wrong, names), (there, named) = verdicts(work, readings), verdicts(work, truth)
    if not work.mistakes:
        return (wrong if there else None) if work.slips else not wrong
    id = work.mistakes[0].name[0]
    return id in names if id in named else None


def cases(mechanisms: Sequence[str], cameras: Sequence[str], count: int) -> Iterator[Case]:
    """So many pictures, all kinds of them in turn."""
    rng = np.random.default_rng(5)
    for k in range(count):
        kind = str(rng.choice(["right", "mistake", "slip"], p=[0.35, 0.5, 0.15]))
        yield Case(mechanisms[k % len(mechanisms)], kind, 1000 + k, bool(k // len(mechanisms) % 2), cameras[k % len(cameras)])


def report(outcomes: Sequence[Outcome]) -> None:
    """The figures, and every picture that is wrong unsaid."""
    for wobble in (False, True):
        some = [one for one in outcomes if one.case.wobble == wobble]
        sure = np.array([off for one in some for off in one.sure] or [np.nan])
        unsure = [off for one in some for off in one.unsure]
        print(f"{'with' if wobble else 'without'} wobble: {len(some)} pictures, {sum(bool(o.refused) for o in some)} refused; corners: "
              f"median {np.median(sure):.3f}, 95 % {np.quantile(sure, 0.95):.3f}, 99 % {np.quantile(sure, 0.99):.3f} mm; "
              f"{len(unsure)} of {len(sure) + len(unsure)} unsure, {sum(off < WRONG for off in unsure)} of these right")  # fmt: skip
    for kind in ("right", "mistake", "slip"):
        some = [one for one in outcomes if one.case.kind == kind and not one.refused and one.named is not None]
        print(f"{kind}: {sum(bool(one.named) for one in some)} of {len(some)} named, {sum(bool(one.reasons) for one in some)} unsure somewhere")
    silent = [one for one in outcomes if one.silent > WRONG]
    print(f"wrong and unsaid: {len(silent)} of {len(outcomes)}")
    for one in silent:
        print("  ", one.case, one.truth, f"{one.where} {one.silent:.2f} mm", one.reasons)
    print("not named:")
    for one in outcomes:
        if one.named is False and not one.refused:
            print("  ", one.case, one.truth, f"{one.silent:.2f} mm", one.reasons)
    print("reasons:", Counter(text.split(":")[1][:6] for one in outcomes for text in one.reasons))
    print("refused:", Counter(one.refused for one in outcomes if one.refused))
    print(f"seconds: {np.mean([o.seconds for o in outcomes]):.2f}, at most {max(o.seconds for o in outcomes):.2f}")


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--aside", action="store_true")
    parser.add_argument("--flat", action="store_true")
    given = parser.parse_args()
    taken_by = [FLAT] if given.flat else [*(CAMERAS_ASIDE if given.aside else CAMERAS)]
    some = list(cases(ASIDE if given.aside else TUNED, taken_by, given.count))
    with ProcessPoolExecutor(given.jobs) as pool:
        report(list(pool.map(assessed, some, chunksize=1)))


if __name__ == "__main__":
    main()
