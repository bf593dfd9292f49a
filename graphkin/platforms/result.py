"""A marked submission: the contract's record as a value, with points that are rounded once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field
from decimal import Decimal
from typing import Any, Literal, get_args

from graphkin.errors import Lang, Where
from graphkin.platforms.complaints import NotAResult
from graphkin.platforms.numbers import points
from graphkin.platforms.question import Text
from graphkin.value import frozen

__all__ = ["FORMAT", "Line", "Picture", "Result", "Suspicion", "Verdict", "from_record", "to_record"]

FORMAT = 1
Verdict = Literal["right", "carried", "wrong", "missing", "not marked"]
Status = Literal["marked", "not marked"]


@frozen
class Line:
    """One quantity of a submission; numbers in SI, `unit` the SI unit.

    carried   what follows from the student's own earlier values, where it was judged by that
    sense     whether the sense was right, where it was judged by itself
    points    earned, of `most`
    feedback  what was written about it, where the marking wrote something
    """

    name: str
    given: float | None
    right: float | None
    carried: float | None
    tolerance: float | None
    verdict: Verdict
    sense: Literal["right", "wrong"] | None = None
    unit: str = ""
    points: Decimal = Decimal(0)
    most: Decimal = Decimal(0)
    feedback: Text = field(default_factory=dict)


@frozen
class Suspicion:
    """Mistakes that the numbers are consistent with and that cannot be told apart.

    sentences  one for each, as far as they are known
    """

    ids: tuple[str, ...]
    probability: float
    margin: float
    explains: tuple[str, ...]
    sentences: tuple[Text, ...] = ()


@frozen
class Picture:
    """A picture for a platform that shows one: PNG, JPEG or GIF as `kind` "image/png" says."""

    label: str
    kind: str
    data: bytes


@frozen
class Result:
    """One student's submission, marked or not.

    most      points there are
    override  the teacher's own points, which count instead
    extra     what else the record holds; it is kept
    """

    student: str
    file: str
    status: Status
    reason: Text = field(default_factory=dict)
    lines: tuple[Line, ...] = ()
    suspicions: tuple[Suspicion, ...] = ()
    most: Decimal = Decimal(0)
    override: Decimal | None = None
    extra: Mapping[str, Any] = field(default_factory=dict)

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


# --- records ----------------------------------------------------------------------------------


def from_record(record: Mapping[str, Any], where: Where) -> Result:
    """A result from its JSON object. Raises NotAResult."""
    try:
        return _read(record)
    except (KeyError, TypeError, ValueError, ArithmeticError, AttributeError) as error:
        raise NotAResult(where, f"{type(error).__name__}: {error}") from None


def to_record(result: Result) -> dict[str, Any]:
    """The JSON object: the contract's keys, then points, units and texts."""
    quantities = {line.name: _line_record(line) for line in result.lines}
    plain: dict[str, Any] = {
        "format": FORMAT, "student": result.student, "file": result.file, "status": result.status,
        "reason": texts_in([result.reason], "en")[0] or None, "score": _number(result.score),
        "points": _number(result.total), "max_points": _number(result.most), "override": _number(result.override),
        "quantities": quantities, "mistakes": [_suspicion_record(one) for one in result.suspicions],
    }  # fmt: skip
    if len(set(result.reason.values())) > 1:
        plain["reasons"] = dict(result.reason)
    return {**plain, **{key: value for key, value in result.extra.items() if key not in plain}}


_KNOWN = {
    "format", "student", "file", "status", "reason", "score", "points", "max_points", "override", "quantities",
    "mistakes", "reasons",
}  # fmt: skip


def _read(record: Mapping[str, Any]) -> Result:
    if record["format"] != FORMAT or record["status"] not in get_args(Status):
        raise ValueError(f"format {record['format']!r}, status {record['status']!r}")
    lines = tuple(_line(str(name), each) for name, each in (record.get("quantities") or {}).items())
    there = sum((line.most for line in lines), Decimal(0))
    override, reason = record.get("override"), record.get("reasons") or record.get("reason")
    return Result(
        str(record["student"]), str(record["file"]), record["status"], _text(reason), lines,
        tuple(_suspicion(each) for each in record.get("mistakes") or ()),
        there if lines else points(_finite(record.get("max_points")) or 0.0),
        None if override is None else points(_finite(override) or 0.0),
        {key: value for key, value in record.items() if key not in _KNOWN},
    )  # fmt: skip


def _line(name: str, each: Mapping[str, Any]) -> Line:
    if each["verdict"] not in get_args(Verdict) or each.get("sense") not in (None, "right", "wrong"):
        raise ValueError(f"{name}: verdict {each['verdict']!r}, sense {each.get('sense')!r}")
    given, right, carried, tolerance = (_finite(each.get(key)) for key in ("given", "right", "carried", "tolerance"))
    earned, most = (points(_finite(each.get(key)) or 0.0) for key in ("points", "max_points"))
    return Line(
        name, given, right, carried, tolerance, each["verdict"], each.get("sense"), str(each.get("unit") or ""),
        earned, most, _text(each.get("feedback")),
    )  # fmt: skip


def _suspicion(each: Mapping[str, Any]) -> Suspicion:
    return Suspicion(
        tuple(map(str, each["ids"])), float(each.get("probability") or 0.0), float(each.get("margin") or 0.0),
        tuple(map(str, each.get("explains") or ())), tuple(_text(one) for one in each.get("sentences") or ()),
    )  # fmt: skip


def _finite(value: object) -> float | None:
    """A number that is one. Raises ValueError."""
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise ValueError(f"{value!r} is no number")
    return float(value)


def _text(value: object) -> Text:
    """A text in both languages, or one that is the same in both."""
    if value is None or value == "":
        return {}
    if isinstance(value, str):
        return {"en": value, "zh": value}
    if not isinstance(value, Mapping):
        raise ValueError(f"{value!r} is no text")
    return {lang: str(value[lang]) for lang in get_args(Lang) if lang in value}


def _number(value: Decimal | None) -> float | None:
    return None if value is None else float(value)


def _line_record(line: Line) -> dict[str, Any]:
    told: dict[str, Any] = {
        "given": line.given, "right": line.right, "carried": line.carried, "tolerance": line.tolerance,
        "verdict": line.verdict, "sense": line.sense, "unit": line.unit, "points": float(line.points),
        "max_points": float(line.most),
    }  # fmt: skip
    return {**told, "feedback": dict(line.feedback)} if line.feedback else told


def _suspicion_record(one: Suspicion) -> dict[str, Any]:
    told: dict[str, Any] = {
        "ids": list(one.ids), "probability": one.probability, "margin": one.margin, "explains": list(one.explains)
    }  # fmt: skip
    return {**told, "sentences": [dict(text) for text in one.sentences]} if one.sentences else told


def texts_in(texts: Sequence[Text], lang: Lang) -> list[str]:
    """Texts in a language, or in the other where that is all there is; each once."""
    return list(dict.fromkeys(text.get(lang) or next(iter(text.values()), "") for text in texts))
