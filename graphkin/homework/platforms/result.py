"""A marked submission: graphkin's own record as a value, with points that are rounded once; and files of these."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from pathlib import Path
from typing import Literal, get_args

from graphkin.base.plain import built
from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NotAResult, Where
from graphkin.homework import opening
from graphkin.homework.platforms.tables import points
from graphkin.marking.diagnosis import Explanation, Habit, Trace
from graphkin.marking.records import Departure, EquationFault, Judged, StepDeparture
from graphkin.outputs.marks_json import END, HEAD, NAME, Record, drawn_of, judged_of, record_of

FORMAT = 1
Status = Literal["marked", "not marked"]


def most_of(line: Judged) -> Decimal:
    """The points there are for a quantity."""
    return points(line.points)


def points_of(line: Judged) -> Decimal:
    """The points that a quantity earns."""
    return points(line.points * line.credit)


@frozen
class ResultPicture:
    """A picture on a page or a platform: its label, its kind ("image/svg+xml"), its bytes. Without bytes there is
    nothing to be seen, and `label` says why; `note` stands under it."""

    label: str
    kind: str
    data: bytes
    note: str = ""


@frozen
class Result:
    """One student's submission, marked or not.

    most      points there are; 0 where it was not marked and nobody has said
    notes     what was passed over in it
    override  the teacher's own points, which count instead; comment: words to this student
    drawn     points that were measured on a drawing, by plane and letter, SI, from any of them
    habits    mistakes that show in several problems of the student
    departure  where the numbers leave the right way, if no mistake explains them
    remarks    for the teacher alone: no student's page or platform shows them
    evidence   of each mistake in these numbers
    faults, step   of a drawing board: choices that are not right, and the step that leaves the right way
    """

    student: str
    file: str
    status: Status
    reason: str = ""
    lines: tuple[Judged, ...] = ()
    suspicions: tuple[Explanation, ...] = ()
    most: Decimal = Decimal(0)
    notes: tuple[str, ...] = ()
    override: Decimal | None = None
    drawn: Mapping[Plane, Mapping[str, complex]] = field(default_factory=dict)
    habits: tuple[Habit, ...] = ()
    departure: Departure | None = None
    remarks: tuple[str, ...] = ()
    comment: str = ""
    evidence: Mapping[str, float] = field(default_factory=dict)
    faults: tuple[EquationFault, ...] = ()
    step: StepDeparture | None = None

    @property
    def trace(self) -> Trace:
        """The evidence of the mistakes, and those that are named."""
        return Trace(tuple(dict.fromkeys(id for one in self.suspicions[:1] for id in one.ids)), self.evidence)

    @property
    def earned(self) -> Decimal:
        """Points by the marking."""
        return sum((points_of(line) for line in self.lines), Decimal(0))

    @property
    def total(self) -> Decimal | None:
        """Points that count; None where nobody has given any, or an answer that was not read is to be looked at."""
        if self.override is not None or self.status != "marked":
            return self.override
        return None if any(line.written for line in self.lines) else self.earned

    @property
    def score(self) -> Decimal | None:
        """Of 1, in six digits; None where there is none to give."""
        if self.total is None or not self.most:
            return None
        return min(Decimal(1), self.total / self.most).quantize(Decimal("0.000001"))


def from_record(record: Record, where: Where) -> Result:
    """A result from its record, as `outputs.marks_json` writes it. Raises NotAResult."""
    try:
        if record["format"] != FORMAT or record["status"] not in get_args(Status):
            raise ValueError(f"format {record['format']!r}, status {record['status']!r}")
        lines, left_at = tuple(judged_of(record)), record.get("departure")
        return Result(
            built(str, record["student"]), built(str, record["file"]), record["status"],
            built(str, record.get("reason") or ""), lines, tuple(map(_suspicion, record["mistakes"])),
            sum((most_of(line) for line in lines), Decimal(0)), built(tuple[str, ...], record.get("notes", ())),
            drawn=drawn_of(record),
            departure=built(Departure | None, left_at and {**left_at, "text": left_at["quantity"]}),
            remarks=tuple(built(str, each["text"]) for each in record.get("remarks", ())),
            evidence=built(Mapping[str, float], record.get("evidence", {})),
            faults=built(tuple[EquationFault, ...], record.get("equations", ())),
            step=built(StepDeparture | None, record.get("step")),
        )  # fmt: skip
    except (KeyError, TypeError, ValueError, ArithmeticError, AttributeError) as error:
        raise NotAResult(where, f"{type(error).__name__}: {error}"[:200]) from None


def _suspicion(each: Record) -> Explanation:
    names = [[[name[key] for key in NAME] for name in some] for some in each.get("names", ())]
    explanation: Explanation = built(Explanation, {"probability": 0.0, "margin": 0.0, **each, "names": names})
    return explanation


def read_results(path: Path) -> tuple[Result, ...]:
    """The results in a file of marks: after its head, a record a line. Raises NoFile, Unreadable, NotAResult."""
    with opening(path):
        text = path.read_text(encoding="utf-8")
    head, begins, rest = text.partition(HEAD)
    if head or not begins:
        raise NotAResult(Where(str(path), 1), text[:80])
    records, ends, _ = rest.rpartition(f"\n{END}")
    if not ends:
        raise NotAResult(Where(str(path)), END)
    results: list[Result] = []
    for number, line in enumerate(records.split("\n")[1:], HEAD.count("\n") + 2):
        record = record_of(line)
        if record is None:
            raise NotAResult(Where(str(path), number), "JSON")
        results.append(from_record(record, Where(str(path), number)))
    return tuple(results)
