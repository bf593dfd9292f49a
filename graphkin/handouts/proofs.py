"""The end of a solution: results beside the analysis with what a pencil allows, and the commonest mistakes."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from graphkin.analytic import motion
from graphkin.base import geometry
from graphkin.errors import GraphkinError
from graphkin.handouts.document import Block, HandoutHeading, HandoutTable, Paragraph
from graphkin.handouts.problem import HandoutProblem
from graphkin.homework.grading.keys import key_drawn
from graphkin.marking.key import Key, columns, upright
from graphkin.marking.weights import shifts
from graphkin.model.quantities import EDGE, Centre
from graphkin.model.quantities.reading import respelled
from graphkin.proof.readings import readings
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.marks import mistake
from graphkin.say.numbers import number
from graphkin.sheet.lettering import Label, formula, plain

_SHOWN = 3


def beside(problem: HandoutProblem) -> Iterator[Block]:
    """A row an answer: drawn, analysed, and how far a careful pencil may be off."""
    key = _key(problem)
    entries = {entry.text: entry for entry in key.entries} if key is not None else {}
    roads = readings(problem.drawing.method, problem.drawing.plot), motion(problem.drawing.mechanism)
    rows: list[tuple[Label, ...]] = []
    for text, quantity in zip(problem.goal.texts, problem.goal.wanted, strict=False):
        if quantity is None or isinstance(quantity, Centre):
            continue
        unit = EDGE[quantity.unit]
        values = (quantity.shown(road) for road in roads)
        sizes = (geometry.number(v.value) if v.vector is None else abs(geometry.place(v.vector)) for v in values)
        entry, off = entries.get(text), ""
        if entry is not None and entry.doubt in ("dead point", "too small"):
            off = say(f"verdicts.verdict {entry.doubt}", problem.lang)
        elif entry is not None:
            off = f"± {entry.tolerance * unit.factor:.2g}"
        shown = [plain(number(size * unit.factor)) for size in sizes]
        rows.append((formula(problem.goal.symbol(quantity)), *shown, plain(off), plain(unit.sign)))
    if rows:
        heads = ("quantity", "drawn", "analysed", "allowed", "unit")
        yield HandoutHeading(plain(say("handouts.beside", problem.lang)))
        yield HandoutTable(tuple(plain(say(f"handouts.{head}", problem.lang)) for head in heads), tuple(rows))


def mistakes(problem: HandoutProblem) -> Iterator[Block]:
    """The mistakes that move most of what is asked, of different kinds, with the numbers they give."""
    key = _key(problem)
    if key is None:
        return
    moved = _moved(key)
    asked = [k for k, entry in enumerate(key.entries) if entry.points]
    first: dict[str, int] = {}
    for row, made in enumerate(key.singles.names):
        if any(moved[row][asked]):
            first.setdefault(made[0][0], row)
    common = [first[id] for id in _COMMON if id in first][:_SHOWN]
    if common:
        yield HandoutHeading(plain(say("handouts.common", problem.lang)))
    for row in common:
        yield Paragraph(_given_by(problem, key, row, [k for k in asked if moved[row][k]]))


def _moved(key: Key) -> np.ndarray:
    """Flags (mistakes, quantities): what each mistake moves by more than a pencil may."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(shifts(columns(key.entries), key.singles.values) > 3)


def _given_by(problem: HandoutProblem, key: Key, row: int, moved: list[int]) -> Label:
    """A mistake in words, and the values it gives of those quantities that it moves."""
    symbols = {text: q for text, q in zip(problem.goal.texts, problem.goal.wanted, strict=False) if q is not None}
    values = upright(columns(key.entries), key.singles.values[row])
    shown = []
    for k in moved:
        quantity, value = symbols.get(key.entries[k].text), values[k]
        if quantity is not None and np.isfinite(value):
            unit = EDGE[quantity.unit]
            shown.append(f"{problem.goal.symbol(quantity)} = {number(value * unit.factor)} {unit.sign}".strip())
    name = mistake(key.singles.names[row][0], problem.lang)
    texts = {entry.text for entry in key.entries}
    signs = respelled(name, lambda text: names.symbols(text) if text in texts else text)
    raised = re.sub(r"([va])\^([nktr]+)_", lambda part: names.vector(part[0] + "X")[:-1], signs)
    return formula(say("handouts.gives", problem.lang, mistake=raised, values=", ".join(shown)))


_COMMON = (
    "coriolis-omitted", "coriolis-reversed", "normal-omitted", "image-mirrored", "image-wrong-point", "wrong-radius",
    "absolute-for-relative", "normal-outward", "omega-sense", "coriolis-half", "wrong-length", "sliding-across",
    "centre-ratio", "arm-ignored", "velocity-along-link", "tangential-along", "driver-along-crank", "conversion",
)  # fmt: skip
"""Mistakes of students, the most frequent first."""


def _key(problem: HandoutProblem) -> Key | None:
    """The key of the problem; None where nothing is asked that is marked."""
    try:
        return key_drawn(problem.drawing.method)
    except GraphkinError:
        return None
