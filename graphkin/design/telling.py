"""A design told: numbered sentences with their numbers, lines for a terminal, plain data for programs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from graphkin.design.model import Design, Family, Reason, Solution
from graphkin.design.proof import proof
from graphkin.design.sentences import HEADINGS, NAMES, REASONS, SENTENCES, WORDS
from graphkin.drafting import Board, Drafting
from graphkin.errors import GraphkinError, Lang, NoDesign
from graphkin.words.linkages import kind_name

__all__ = ["as_json", "error", "lines", "said", "sentences"]

_DIGITS = 5


class _Said(float):
    """A number in a sentence: `mm` a length, `deg` an angle, `n` as it is; five figures."""

    def __format__(self, spec: str) -> str:
        if spec == "mm":
            return f"{_figure(self * 1e3)} mm"
        if spec == "deg":
            return f"{_figure(math.degrees(self))}°"
        return _figure(self) if spec == "n" else format(round(self) if spec == "d" else float(self), spec)


def _figure(value: float) -> str:
    size = abs(value)
    text = f"{value:.{_DIGITS}g}" if size >= 1e-9 else "0"
    return (f"{value:.0f}" if "e" in text and size >= 1 else text).replace("-", "−")


def sentences(construction: Drafting, board: Board, lang: Lang) -> list[str]:
    """One sentence a stage, with the numbers of the board."""
    numbers: dict[str, Any] = {name: _Said(value) for name, value in board.numbers.items()}
    for name, place in board.places.items():
        numbers |= {f"{name}_x": _Said(place.real * 1e3), f"{name}_y": _Said(place.imag * 1e3)}
    if "K" in board.numbers:
        numbers |= {"less": _Said(board.numbers["K"] - 1), "more": _Said(board.numbers["K"] + 1)}
    return [SENTENCES[stage.say][lang].format(**numbers) for stage in construction.stages]


def said(reason: Reason, lang: Lang) -> str:
    """A reason as a sentence."""
    data: dict[str, Any] = {k: v if isinstance(v, str) else _Said(v) for k, v in reason.data}
    if "name" in data:
        data["name"] = NAMES[data["name"]][lang]
    return REASONS[reason.key][lang].format(**data)


def error(design: Design) -> NoDesign | None:
    """The error to raise where nothing was found; None where something was."""
    if design.solutions:
        return None
    return NoDesign(" ".join(_no_solution(design, "en")), " ".join(_no_solution(design, "zh")))


def _no_solution(design: Design, lang: Lang) -> Iterator[str]:
    for one in design.rejected:
        yield from (said(reason, lang) for reason in one.why)
    yield from (said(reason, lang) for reason in design.why)


# --- lines -------------------------------------------------------------------------------------------


def lines(design: Design, lang: Lang = "en") -> list[str]:
    """The solution as a book writes it, then all solutions, what is none, and the family."""
    return list(_lines(design, lang))


def _lines(design: Design, lang: Lang) -> Iterator[str]:
    yield HEADINGS[design.kind][lang]
    best = design.best
    if best is not None:
        numbered = enumerate(sentences(best.construction, best.board(), lang), start=1)
        yield from (f"({number}) {text}" for number, text in numbered)
    for number, one in enumerate(design.solutions, start=1):
        yield WORDS["solution" if one.valid else "useless"][lang].format(number=number) + _lengths(one, lang)
        yield from _judged(one, lang)
    for one in design.rejected:
        yield WORDS["refused"][lang] + _lengths(one, lang)
        yield from (f"  {said(reason, lang)}" for reason in one.why)
    if not design.solutions:
        yield WORDS["none"][lang]
    yield from (said(reason, lang) for reason in design.why)
    yield from (_family(one, lang) for one in design.families if len(one.angle))


def _lengths(one: Solution, lang: Lang) -> str:
    """a = 20.773 mm, b = .. of those it has."""
    sizes = {"a": one.a, "b": one.b, "c": one.c, "d": one.d, "e": one.e}
    return ", ".join(f"{name} = {_Said(size):mm}" for name, size in sizes.items() if size is not None)


def _judged(one: Solution, lang: Lang) -> Iterator[str]:
    yield from (f"  {WORDS['invalid'][lang]}{said(reason, lang)}" for reason in one.why)
    try:
        found = proof(one)
    except GraphkinError as wrong:
        yield f"  {wrong.message(lang)}"
        return
    values = {"ψ": found.swing, "θ": found.theta, "γmin": found.gamma_min}
    told = [kind_name(found, lang)]
    told += [f"{name} = {_Said(value):deg}" for name, value in values.items() if value is not None]
    told += [f"H = {_Said(found.stroke):mm}"] if found.stroke is not None else []
    told += [f"K = {_Said(found.k):n}"] if found.k is not None else []
    if one.pace is not None:
        told.append(WORDS["slow ccw" if one.pace > 0 else "slow cw"][lang])
    yield f"  {WORDS['proof'][lang]}{', '.join(told)}"
    yield from (f"  {said(reason, lang)}" for reason in one.notes if reason.key != "kind")


def _family(one: Family, lang: Lang) -> str:
    arcs = [
        WORDS["arcs"][lang].format(start=_Said(arc.start % math.tau), end=_Said(arc.end % math.tau))
        for arc in one.arcs if arc.name == "admissible"
    ]  # fmt: skip
    data = {"x": one.centre.real * 1e3, "y": one.centre.imag * 1e3, "radius": one.radius, "best": one.best[1]}
    numbers: Mapping[str, Any] = {name: _Said(value) for name, value in data.items()}
    return WORDS["family"][lang].format(arcs=", ".join(arcs), **numbers)


# --- data --------------------------------------------------------------------------------------------


def as_json(design: Design) -> dict[str, Any]:
    """`{"format": 1, "solutions": [{"a": .., "b": .., ..}]}` in metres and radians; null where there is no such size.

    solutions   what meets the wishes; "valid" is false where it does not move through its positions, "why" says so
    rejected    points of the construction that look like solutions and are none
    bisectors   of two coupler positions: lines on which A and D are free (a point [m], a direction [rad])
    family      circles of crank centres: a, b, d, e, gamma_min along the admissible arcs, and the best point
    """
    return {
        "format": 1,
        "kind": design.kind,
        "given": dict(design.given),
        "solutions": [_data(one) for one in design.solutions],
        "rejected": [_data(one) for one in design.rejected],
        "why": [said(reason, "en") for reason in design.why],
        "bisectors": _bisectors(design),
        "family": [_family_data(one) for one in design.families],
    }


def _data(one: Solution) -> dict[str, Any]:
    return {
        "a": one.a, "b": one.b, "c": one.c, "d": one.d, "e": one.e, "gamma_min": one.gamma_min, "K": one.k,
        "swing": one.swing, "stroke": one.stroke, "theta": one.theta, "valid": one.valid,
        "why": [said(reason, "en") for reason in one.why], "notes": [said(reason, "en") for reason in one.notes],
        "points": {name: [place.real, place.imag] for name, place in one.places.items()},
        "positions": [{name: [z.real, z.imag] for name, z in places.items()} for places in one.limits],
        "slow": None if one.pace is None else ("ccw" if one.pace > 0 else "cw"),
    }  # fmt: skip


def _bisectors(design: Design) -> dict[str, Any] | None:
    if design.kind != "coupler" or design.best is None or len(design.best.limits) != 2:
        return None
    board = design.best.board()
    found: dict[str, Any] = {}
    for pivot, hinge in (("A", "B"), ("D", "C")):
        middle, (_, along) = (board.at(f"{hinge}1") + board.at(f"{hinge}2")) / 2, board.line(f"{hinge}12")
        found[pivot] = {"through": [middle.real, middle.imag], "direction": math.atan2(along.imag, along.real)}
    return found


def _family_data(one: Family) -> dict[str, Any]:
    """Every twentieth point; the arrays themselves have them all."""
    part = slice(None, None, 20)
    sizes = {"a": one.a, "b": one.b, "d": one.d, "e": one.e, "gamma_min": one.gamma_min}
    data: dict[str, Any] = {name: None if v is None else [float(x) for x in v[part]] for name, v in sizes.items()}
    data["A"] = [[float(z.real), float(z.imag)] for z in one.at[part]]
    data["arcs"] = [{"from": arc.start, "to": arc.end, "name": arc.name} for arc in one.arcs]
    known = math.isfinite(one.best[1])
    best = {"angle": one.best[0], "gamma_min": one.best[1]} if known else None
    return {"centre": [one.centre.real, one.centre.imag], "radius": one.radius, "best": best, **data}
