"""A marked submission: graphkin's own record as a value, with points that are rounded once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field
from decimal import Decimal
from typing import Any, Literal, get_args

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang, NotAResult, Where
from graphkin.homework.platforms.numbers import points
from graphkin.homework.platforms.question import Text
from graphkin.marking.diagnosis import Habit
from graphkin.marking.key import Name
from graphkin.marking.records import Verdict
from graphkin.outputs.marks_json import drawn_of

FORMAT = 1
Status = Literal["marked", "not marked"]


@frozen
class ResultLine:
    """One quantity of a submission; numbers in SI, `unit` the SI unit.

    carried     what follows from the student's own earlier values (`own`, by quantity), where it was judged by these
    sense       whether the sense was right, where it was judged by itself; `unit_right`: the same of its unit
    credit      what it is worth, of 1; points: of `most`
    """

    name: str
    given: float | None
    right: float
    carried: float | None
    tolerance: float
    verdict: Verdict
    sense: Literal["right", "wrong"] | None = None
    unit: str = ""
    unit_right: bool = True
    credit: float = 0.0
    own: Mapping[str, float] = field(default_factory=dict)
    points: Decimal = Decimal(0)
    most: Decimal = Decimal(0)


@frozen
class Suspicion:
    """Mistakes that the numbers are consistent with and that cannot be told apart.

    names  one mistake, or two made together, for each way in which they give the numbers
    """

    ids: tuple[str, ...]
    explains: tuple[str, ...]
    names: tuple[tuple[Name, ...], ...] = ()


@frozen
class ResultPicture:
    """A picture on a page or a platform: what is said of it, its kind ("image/svg+xml"), its bytes.

    Without bytes there is nothing to be seen, and `label` says why.
    """

    label: str
    kind: str
    data: bytes


@frozen
class Result:
    """One student's submission, marked or not.

    most      points there are; 0 where it was not marked and nobody has said
    notes     what was passed over in it
    override  the teacher's own points, which count instead
    drawn     points that were measured on a drawing, by plane and letter, SI, from any of them
    habits    mistakes that show in several problems of the student
    """

    student: str
    file: str
    status: Status
    reason: Text = field(default_factory=dict)
    lines: tuple[ResultLine, ...] = ()
    suspicions: tuple[Suspicion, ...] = ()
    most: Decimal = Decimal(0)
    notes: tuple[str, ...] = ()
    override: Decimal | None = None
    drawn: Mapping[Plane, Mapping[str, complex]] = field(default_factory=dict)
    habits: tuple[Habit, ...] = ()

    @property
    def earned(self) -> Decimal:
        """Points by the marking."""
        return sum((line.points for line in self.lines), Decimal(0))

    @property
    def total(self) -> Decimal | None:
        """Points that count; None where nobody has given any."""
        if self.override is not None:
            return self.override
        return self.earned if self.status == "marked" else None

    @property
    def score(self) -> Decimal | None:
        """Of 1, in six digits; None where there is none to give."""
        if self.total is None or not self.most:
            return None
        return min(Decimal(1), self.total / self.most).quantize(Decimal("0.000001"))


def texts_in(texts: Sequence[Text], lang: Lang) -> list[str]:
    """Texts in a language, or in the other where that is all there is; each once."""
    return list(dict.fromkeys(text.get(lang) or next(iter(text.values()), "") for text in texts))


# --- records ----------------------------------------------------------------------------------


def from_record(record: Mapping[str, Any], where: Where) -> Result:
    """A result from its record, as `outputs.marks_json` writes it. Raises NotAResult."""
    try:
        return _read(record)
    except (KeyError, TypeError, ValueError, ArithmeticError, AttributeError) as error:
        raise NotAResult(where, f"{type(error).__name__}: {error}"[:200]) from None


def _read(record: Mapping[str, Any]) -> Result:
    if record["format"] != FORMAT or record["status"] not in get_args(Status):
        raise ValueError(f"format {record['format']!r}, status {record['status']!r}")
    lines = tuple(_line(str(name), each) for name, each in record["quantities"].items())
    return Result(
        _string(record["student"]), _string(record["file"]), record["status"], _text(record.get("reason")), lines,
        tuple(_suspicion(each) for each in record["mistakes"]),
        sum((line.most for line in lines), Decimal(0)),
        tuple(_string(note) for note in record.get("notes", ())), drawn=drawn_of(record),
    )  # fmt: skip


def _line(name: str, each: Mapping[str, Any]) -> ResultLine:
    if each["verdict"] not in get_args(Verdict) or each["sense"] not in (None, "right", "wrong"):
        raise ValueError(f"{name}: verdict {each['verdict']!r}, sense {each['sense']!r}")
    worth, credit = _finite(each["points"]), _finite(each["credit"])
    if worth < 0 or not 0 <= credit <= 1:
        raise ValueError(f"{name}: points {worth}, credit {credit}")
    own = {str(text): _finite(value) for text, value in each["own"].items()}
    return ResultLine(
        name, _number(each["given"]), _finite(each["right"]), _number(each["carried"]), _finite(each["tolerance"]),
        each["verdict"], each["sense"], _string(each["unit"]), bool(each["unit_right"]), credit, own,
        points(worth * credit), points(worth),
    )  # fmt: skip


def _suspicion(each: Mapping[str, Any]) -> Suspicion:
    names = tuple(tuple(_name(name) for name in together) for together in each.get("names", ()))
    return Suspicion(tuple(map(_string, each["ids"])), tuple(map(_string, each["explains"])), names)


def _name(name: Mapping[str, Any]) -> Name:
    id, way, of, form = (_string(name[key]) for key in ("id", "way", "of", "form"))
    return id, way, of, form


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


def _text(value: object) -> Text:
    """A reason, which is written in one language."""
    return {} if value is None or value == "" else {"en": _string(value), "zh": _string(value)}
