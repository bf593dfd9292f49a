"""A drawing board marked, in words: choices in vector equations, and the first step that leaves the right way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphkin.errors import Lang
from graphkin.marking.records import EquationFault, StepDeparture
from graphkin.model.mechanism import EQUATIONS
from graphkin.say import names
from graphkin.say.catalogue import say

_SHOWN = 8  # choices that are written out; of more the number is said
_GREEK = {"omega": "ω", "alpha": "α"}


def line_name(text: str, lang: Lang) -> str:
    """The name of a line of marks: a quantity as it is read, the equations of a plane in words."""
    plane = next((plane for plane, own in EQUATIONS.items() if own == text), None)
    return text if plane is None else say(f"marks.equations {plane}", lang)


def choice_words(token: str, lang: Lang) -> str:
    """A choice as it is printed: `⊥AB`, `B→A`, `ω3² l_BD`, `√`."""
    if token in ("", "?", "0", "given"):
        return "√" if token == "given" else token
    word, _, rest = token.partition(" ")
    if word in ("parallel", "perpendicular"):
        guide = rest.removeprefix("guide ")
        line = names.point(rest) if guide == rest else say("marks.guide", lang, name=names.point(guide))
        return ("∥" if word == "parallel" else "⊥") + line
    if rest.startswith("to "):
        return names.arrow(word, rest.removeprefix("to "))
    return " ".join(map(_factor, token.split("*")))


def _factor(factor: str) -> str:
    word, _, low = factor.partition("_")
    if word in _GREEK:
        return names.of_link(_GREEK[word], low.removesuffix("^2")) + ("²" if low.endswith("^2") else "")
    return names.vector(factor) if word == "v" and low else factor


def fault_lines(faults: Sequence[EquationFault], lang: Lang, in_full: bool = True) -> Iterator[str]:
    """The choices that are not right, each with the right one; else where to look, by equation."""
    by_equation: dict[str, list[str]] = {}
    for one in faults[: _SHOWN if in_full else None]:
        where = say(f"marks.in equation {one.plane}", lang, number=one.equation)
        choice = say(f"marks.the {one.row}", lang, term=names.vector(one.term))
        by_equation.setdefault(where, []).append(choice)
        if in_full:
            words = {"written": choice_words(one.written, lang), "right": choice_words(one.right, lang)}
            key = "marks.choice" if one.written else "marks.no choice"
            yield say(key, lang, which=int(one.sense), where=where, choice=choice, **words)
    if not in_full:
        for where, choices in by_equation.items():
            yield say("marks.look at choices", lang, where=where, choices=say("common.list", lang).join(choices))
    elif len(faults) > _SHOWN:
        yield say("marks.more choices", lang, count=len(faults) - _SHOWN)


def step_line(one: StepDeparture, lang: Lang, in_full: bool = True) -> str:
    """The first step of a drawing that leaves the right way; in full with what is right."""
    if not in_full:
        return say("marks.look at step", lang, step=one.step)
    words = {"drawn": one.drawn, "right": one.right, "line": one.line, "what": one.what}
    match one.kind:
        case "length" | "turned":
            words["what"] = names.vector(one.what)
        case "reversed":
            words |= {"what": names.vector(one.what), "right": choice_words(one.right, lang)}
        case "tail":
            words |= {"what": names.vector(one.what), "drawn": names.point(one.drawn), "right": names.point(one.right)}
        case "ends":
            tail, _, head = one.right.partition(" ")
            words |= {"what": names.vector(one.what), "drawn": names.point(tail), "right": names.point(head)}
        case "through":
            words = {"what": _line(one.what, lang), "drawn": names.point(one.drawn), "right": names.point(one.right)}
        case "direction":
            words = {"what": names.point(one.what), "drawn": _line(one.drawn, lang), "right": _line(one.right, lang)}
        case "line":
            words = {"what": _line(one.what, lang), "drawn": names.point(one.drawn), "right": names.point(one.right),
                     "line": _line(one.line, lang)}  # fmt: skip
        case _:
            words["what"] = names.point(one.what)
    unknown = one.kind in ("through", "direction", "tail") and not one.drawn
    unknown = unknown or (one.kind == "reversed" and " to " not in one.right)
    text = say(f"marks.step {one.kind}", lang, which=unknown, **words)
    return say("marks.step", lang, step=one.step, text=" ".join(text.split()))


def _line(token: str, lang: Lang) -> str:
    """A line by its direction: `across BC`; nothing of one that has no name."""
    word, _, line = token.partition(" ")
    if word not in ("parallel", "perpendicular"):
        return choice_words(token, lang) if token else ""
    guide = line.removeprefix("guide ")
    shown = names.point(line) if guide == line else say("marks.guide", lang, name=names.point(guide))
    return say(f"marks.line {word}", lang, line=shown)
