"""A small Moodle of our own: it takes an XML file in, finds the fields of cloze, and grades an answer.

Written after Moodle's rules (qtype_multianswer, qtype_numerical), not after what graphkin writes: a field ends at its
first brace without a backslash; feedback is decoded from HTML once, then `\\}` and `\\#` lose their backslash; the first
alternative whose interval holds the number counts.
"""

from __future__ import annotations

import html
import re
from dataclasses import dataclass
from pathlib import Path

from defusedxml.ElementTree import parse

NUMBER = r"-?(?:(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][-+]?[0-9]+)?)"
ALTERNATIVE = r"(=|%-?[0-9]+(?:[.,][0-9]*)?%)?(.+?(?<!\\|&)(?=[~#}]|$))(?:#(.*?(?<!\\)(?=[~}]|$)))?"
PLAIN = re.sub(r"\((?!\?)", "(?:", ALTERNATIVE)
FIELD = re.compile(rf"\{{([0-9]*):(?:NUMERICAL|NM):({PLAIN}(?:~{PLAIN})*)\}}", re.S)
ANSWER = re.compile(rf"({NUMBER})(?::({NUMBER}))?")
PRECISION = 1e-14


@dataclass(frozen=True)
class Answer:
    number: float
    tolerance: float
    fraction: float
    feedback: str

    def holds(self, value: float) -> bool:
        reach = self.tolerance + PRECISION * max(1.0, abs(self.number))
        return self.number - reach <= value <= self.number + reach


@dataclass(frozen=True)
class Field:
    """One blank: its weight and its answers in order."""

    weight: float
    answers: tuple[Answer, ...]

    def grade(self, value: float) -> tuple[float, str]:
        """Fraction and feedback; the first answer that holds the value counts."""
        return next(((one.fraction, one.feedback) for one in self.answers if one.holds(value)), (0.0, ""))


@dataclass(frozen=True)
class Imported:
    """A question: its name, its text with `{#n}` for each blank, and the blanks."""

    kind: str
    name: str
    text: str
    fields: tuple[Field, ...]


def imported(path: Path) -> list[Imported]:
    """The questions of a file; the category is left out."""
    found = []
    for question in parse(path).getroot().findall("question"):
        kind = question.attrib["type"]
        if kind == "category":
            continue
        name, text = question.findtext("name/text") or "", question.findtext("questiontext/text") or ""
        if kind == "cloze":
            text, fields = _cloze(text)
        else:
            weight = float(question.findtext("defaultgrade") or 1)
            fields = [Field(weight, tuple(_numerical(each) for each in question.findall("answer")))]
        for field in fields:
            assert any(one.fraction == 1 for one in field.answers), "Moodle refuses a question without a full answer"
        found.append(Imported(kind, name, text, tuple(fields)))
    return found


def shown(feedback: str) -> str:
    """What a browser shows of a feedback."""
    return html.unescape(re.sub("<br ?/?>", "\n", feedback))


def _cloze(text: str) -> tuple[str, list[Field]]:
    fields: list[Field] = []
    while (found := FIELD.search(text)) is not None:
        fields.append(Field(float(found[1] or 1), tuple(_alternatives(found[2]))))
        text = text[: found.start()] + f"{{#{len(fields)}}}" + text[found.end() :]
    return text, fields


def _alternatives(rest: str) -> list[Answer]:
    found = []
    while (one := re.match("~?" + ALTERNATIVE, rest, re.S)) is not None:
        number = ANSWER.fullmatch(one[2])
        assert number is not None, one[2]
        share = {"=": 1.0, None: 0.0}.get(one[1]) if one[1] in ("=", None) else float(one[1].strip("%").replace(",", ".")) / 100
        told = html.unescape(one[3] or "").replace("\\}", "}").replace("\\#", "#")
        found.append(Answer(_float(number[1]), _float(number[2] or "0"), share, told))
        rest = rest[one.end() :]
    assert not rest, rest
    return found


def _numerical(answer) -> Answer:
    number, tolerance = answer.findtext("text"), answer.findtext("tolerance")
    assert re.fullmatch(NUMBER, number), number
    assert re.fullmatch(NUMBER, tolerance), tolerance
    fraction = float(answer.attrib["fraction"]) / 100
    return Answer(_float(number), _float(tolerance), fraction, answer.findtext("feedback/text") or "")


def _float(text: str) -> float:
    return float(text.replace(",", "."))
