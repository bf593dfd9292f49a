"""A marked submission: graphkin's own record as a value, with points that are rounded once; and files of these."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field, fields
from decimal import Decimal
from pathlib import Path
from typing import Literal, get_args

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NotAResult, Where
from graphkin.homework import opening
from graphkin.homework.platforms.tables import points
from graphkin.marking.diagnosis import Explanation, Habit, Trace
from graphkin.marking.records import Departure, EquationFault, Judged, StepDeparture, Verdict
from graphkin.model.mechanism import EQUATIONS
from graphkin.outputs.marks_json import END, HEAD, Record, drawn_of, record_of

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
        lines = tuple(_line(str(name), each) for name, each in record["quantities"].items())
        left_at = record.get("departure")
        sides = [] if left_at is None else [tuple(map(_string, left_at[side])) for side in ("left", "right")]
        return Result(
            _string(record["student"]), _string(record["file"]), record["status"], _string(record.get("reason") or ""),
            lines, tuple(map(_suspicion, record["mistakes"])), sum((most_of(line) for line in lines), Decimal(0)),
            tuple(map(_string, record.get("notes", ()))), drawn=drawn_of(record),
            departure=None if left_at is None else Departure(_string(left_at["quantity"]), *sides),
            remarks=tuple(_string(each["text"]) for each in record.get("remarks", ())),
            evidence={str(id): _finite(weight) for id, weight in record.get("evidence", {}).items()},
            faults=tuple(EquationFault(**_typed(EquationFault, each)) for each in record.get("equations", ())),
            step=None if record.get("step") is None else StepDeparture(**_typed(StepDeparture, record["step"])),
        )  # fmt: skip
    except (KeyError, TypeError, ValueError, ArithmeticError, AttributeError) as error:
        raise NotAResult(where, f"{type(error).__name__}: {error}"[:200]) from None


def _line(name: str, each: Record) -> Judged:
    if each["verdict"] not in get_args(Verdict) or each["sense"] not in (None, "right", "wrong"):
        raise ValueError(f"{name}: verdict {each['verdict']!r}, sense {each['sense']!r}")
    worth, credit = _finite(each["points"]), _finite(each["credit"])
    if worth < 0 or not 0 <= credit <= 1:
        raise ValueError(f"{name}: points {worth}, credit {credit}")
    return Judged(
        name, _string(each["unit"]), _number(each["given"]), _finite(each["right"]), _finite(each["tolerance"]),
        each["verdict"], each["sense"], bool(each["unit_right"]), _number(each["carried"]),
        {str(text): _finite(value) for text, value in each["own"].items()}, credit=credit, points=worth,
        written=_string(each.get("written", "")), of_mistake=bool(each.get("of_mistake")),
        reversed=bool(each.get("reversed")), other=_string(each.get("other", "")),
    )  # fmt: skip


def _suspicion(each: Record) -> Explanation:
    names = tuple(
        tuple((_string(name["id"]), _string(name["way"]), _string(name["of"]), _string(name["form"])) for name in some)
        for some in each.get("names", ())
    )
    probability, margin = (_finite(each.get(key, 0.0)) for key in ("probability", "margin"))
    return Explanation(names, probability, margin, tuple(map(_string, each["explains"])))


_TYPES = {"int": int, "bool": bool}  # of fields that are no texts


def _typed(kind: type[EquationFault | StepDeparture], data: Record) -> Record:
    """The fields of a record; raises ValueError where one is of another type."""
    wrong = [each.name for each in fields(kind) if type(data[each.name]) is not _TYPES.get(str(each.type), str)]
    if wrong or data["plane"] not in EQUATIONS:
        raise ValueError(f"{kind.__name__}: {wrong}")
    return {each.name: data[each.name] for each in fields(kind)}


def _number(value: object) -> float | None:
    return None if value is None else _finite(value)


def _finite(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError(f"{value!r} is no number")
    return float(value)


def _string(value: object) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{value!r} is no text")
    return value


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
