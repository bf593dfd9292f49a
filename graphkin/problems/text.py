"""A problem in words: what is given, off the student's own mechanism file, what is asked, and how to hand it in."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from typing import Any

from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.problems.draws import Variant
from graphkin.problems.phrases import KEYS, PHRASES, TABLES
from graphkin.problems.template import Template
from graphkin.quantities import EDGE, Centre, Quantity, Quotient, read
from graphkin.words import names



def problem(template: Template, variant: Variant, lang: Lang) -> str:
    """The text of one student's problem."""
    mechanism = variant.mechanism
    own = variant.student
    called = " ".join((own.id, *(name for _, name in own.names)))
    lines = [_say("student", lang, student=called), *statement(mechanism, lang), "", _say("find", lang)]
    asked = [(question, read(mechanism, question)) for question in mechanism.ask]
    for question, quantity in asked:
        worth = _say("points", lang, points=template.points.get(question, 1.0)) if quantity is not None else ""
        lines.append(f"  {_asked(question, quantity)}{worth}")
    lines += ["", _say("hand in", lang), "", f"  student = {_quoted(own.id)}", "  [answers]"]
    lines += [f'  "{question}" = ' for question, quantity in asked if quantity is not None]
    return "\n".join(lines) + f"\n\n{_MADE}\n"


def statement(mechanism: Mechanism, lang: Lang) -> Iterator[str]:
    """The mechanism and what is given of it, in lines."""
    yield from (mechanism.headline(lang), "", _say("given", lang))
    yield from (f"  {line}" for line in _given(tomllib.loads(mechanism.text), lang))


def remark(shared: Sequence[str], lang: Lang) -> str:
    """That students have problems much alike."""
    few = _say("between", lang).join(shared[:10]) + (" .." if len(shared) > 10 else "")
    return _say("shared", lang, count=len(shared), students=few)


_MADE = "-- graphkin problems"


def _say(key: str, lang: Lang, **words: object) -> str:
    return PHRASES[key][lang].format(**words)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _asked(question: str, quantity: Quantity | None) -> str:
    """`ω3 [rad/s]`, `aᵏ_B3B2 [m/s²]`."""
    if quantity is None:
        return question
    sign = EDGE[quantity.unit].sign
    unit = f" [{sign}]" if sign else ""
    if isinstance(quantity, Quotient):
        return f"{_symbol(quantity.top)} / {_symbol(quantity.bottom)}{unit}"
    return _symbol(quantity) + unit


def _symbol(quantity: Quantity) -> str:
    if isinstance(quantity, Centre):
        return quantity.text
    if not quantity.sites:
        return names.of_link(quantity.letter, quantity.of)
    part = f"^{quantity.part}" if quantity.part else ""
    return names.vector(f"{quantity.letter}{part}_{quantity.of}")


# --- what is given ----------------------------------------------------------------------------


def _given(document: dict[str, Any], lang: Lang) -> Iterator[str]:
    """A line a link, pair and driver, in the file's order."""
    for table, content in document.items():
        if table not in TABLES:
            continue
        rows = content.items() if table == "links" else [("", row) for row in _rows(content)]
        for name, row in rows:
            head = TABLES[table][lang] + (f" {name}" if name else "")
            told = _say("between", lang).join(_told(key, value, lang) for key, value in row.items())
            yield f"{head}{_say('colon', lang)}{told}"


def _rows(content: Any) -> list[Any]:
    return content if isinstance(content, list) else [content]


def _told(key: str, value: object, lang: Lang) -> str:
    known = KEYS[key][lang] if key in KEYS else names.point(key)
    return f"{known} = {_shown(value, lang)}"


def _shown(value: object, lang: Lang) -> str:
    match value:
        case bool():
            return str(value).lower()
        case dict():
            return "(" + _say("between", lang).join(_told(key, inner, lang) for key, inner in value.items()) + ")"
        case list():
            return "(" + ", ".join(_shown(inner, lang) for inner in value) + ")"
        case _:
            return str(value)
