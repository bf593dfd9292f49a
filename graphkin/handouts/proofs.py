"""What stands after a solution: results beside the analysis with what a pencil allows, and the commonest mistakes."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from graphkin.analytic import motion
from graphkin.errors import Lang
from graphkin.handouts.document import Block, HandoutHeading, HandoutTable, Paragraph
from graphkin.handouts.told import HandoutProblem
from graphkin.marking.key import Key, KeyEntry, columns, upright
from graphkin.marking.weights import shifts
from graphkin.model.quantities import EDGE, Centre
from graphkin.model.quantities.typed import rewritten
from graphkin.proof.readings import readings
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.mistakes import mistake
from graphkin.say.numbers import number
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import Label, plain

_SHOWN = 3


def beside(told: HandoutProblem) -> Iterator[Block]:
    """A row an answer: drawn, analysed, and how far a careful pencil may be off."""
    key = _key(told)
    entries = {entry.text: entry for entry in key.entries} if key is not None else {}
    drawn, exact = readings(told.drawing.method, told.drawing.plot), motion(told.drawing.mechanism)
    rows: list[tuple[Label, ...]] = []
    for text, quantity in zip(told.goal.texts, told.goal.wanted, strict=False):
        if quantity is None or isinstance(quantity, Centre):
            continue
        unit = EDGE[quantity.unit]
        values = [quantity.shown(road) for road in (drawn, exact)]
        sizes = [abs(v.vector) if v.vector is not None else float(v.value) for v in values]
        shown = [plain(number(size * unit.factor)) for size in sizes]
        off = plain(_off(entries[text], unit.factor, told.lang) if text in entries else "")
        rows.append((formula(told.goal.symbol(quantity)), *shown, off, plain(unit.sign)))
    if rows:
        heads = ("quantity", "drawn", "analysed", "allowed", "unit")
        yield HandoutHeading(plain(say("handouts.beside", told.lang)))
        yield HandoutTable(tuple(plain(say(f"handouts.{head}", told.lang)) for head in heads), tuple(rows))


def _off(entry: KeyEntry, factor: float, lang: Lang) -> str:
    """`± 0.012`, or that paper cannot tell the value."""
    if entry.doubt in ("dead point", "too small"):
        return say(f"verdicts.verdict {entry.doubt}", lang)
    return f"± {entry.tolerance * factor:.2g}"


def mistakes(told: HandoutProblem) -> Iterator[Block]:
    """The mistakes that move most of what is asked, of different kinds, with the numbers they give."""
    key = _key(told)
    if key is None:
        return
    wanted = [k for k, entry in enumerate(key.entries) if entry.points]
    moved = _moved(key)
    shown = {made[0][0] for made, row in zip(key.singles.names, moved, strict=True) if any(row[wanted])}
    common = [id for id in _COMMON if id in shown][:_SHOWN]
    if common:
        yield HandoutHeading(plain(say("handouts.common", told.lang)))
    for id in common:
        yield Paragraph(_given_by(told, key, id, wanted, moved))


def _moved(key: Key) -> np.ndarray:
    """Which quantities each mistake moves by more than a pencil may: (mistakes, quantities)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        moved: np.ndarray = shifts(columns(key.entries), key.singles.values) > 3
    return moved


def _given_by(told: HandoutProblem, key: Key, id: str, wanted: list[int], moved: np.ndarray) -> Label:
    row = next(k for k, made in enumerate(key.singles.names) if made[0][0] == id and any(moved[k][wanted]))
    symbols = {text: q for text, q in zip(told.goal.texts, told.goal.wanted, strict=False) if q is not None}
    given = upright(columns(key.entries), key.singles.values[row])
    shown = []
    for k in wanted:
        entry, value = key.entries[k], given[k]
        if moved[row][k] and np.isfinite(value) and entry.text in symbols:
            unit = EDGE[symbols[entry.text].unit]
            shown.append(f"{told.goal.symbol(symbols[entry.text])} = {number(value * unit.factor)} {unit.sign}".strip())
    name = mistake(key.singles.names[row][0], told.lang)
    known = {entry.text for entry in key.entries}
    signs = rewritten(name, lambda text: names.asked(text) if text in known else text)
    raised = re.sub(r"([va])\^([nktr]+)_", lambda found: names.vector(found[0] + "X")[:-1], signs)
    return formula(say("handouts.gives", told.lang, mistake=raised, values=", ".join(shown)))


_COMMON = (
    "coriolis-omitted", "coriolis-reversed", "normal-omitted", "image-mirrored", "image-wrong-point", "wrong-radius",
    "absolute-for-relative", "normal-outward", "omega-sense", "coriolis-half", "wrong-length", "sliding-across",
    "centre-ratio", "arm-ignored", "velocity-along-link", "tangential-along", "driver-along-crank", "conversion",
)  # fmt: skip
"""What students do, the most frequent first."""


def _key(told: HandoutProblem) -> Key | None:
    """The key of the problem; None where nothing is asked that is marked."""
    from graphkin.errors import GraphkinError
    from graphkin.homework.grading.keys import key_drawn

    try:
        return key_drawn(told.drawing.method)
    except GraphkinError:
        return None
