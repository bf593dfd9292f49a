"""What paper allows, and how well mistakes are told apart: plain text and JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from graphkin.errors import Lang
from graphkin.marking.key import Marking
from graphkin.marking.power import Found, Power
from graphkin.marking.slips import Mark
from graphkin.marking.tolerances import Cost, Tolerances
from graphkin.outputs.marks_phrases import PHRASES, say
from graphkin.outputs.marks_text import shown, table
from graphkin.quantities import EDGE
from graphkin.words.figures import number

__all__ = ["power_data", "power_lines", "tolerance_data", "tolerance_lines"]

Json = dict[str, Any]
_TOLD = 10
"""Steps that are told."""
_SCALES = {"length": "μ_l = {} m/mm", "velocity": "μ_v = {} (m/s)/mm", "acceleration": "μ_a = {} (m/s²)/mm"}


# --- tolerances -------------------------------------------------------------------------------


def tolerance_lines(found: Tolerances, lang: Lang) -> Iterator[str]:
    """The pencil, a row a quantity, and the steps that cost most."""
    marking = found.key.marking
    yield found.key.title.get(lang) or next(iter(found.key.title.values()), found.key.name)
    yield from _pencil(marking, found.drawings, lang)
    heads = ("quantity", "right value", "scatter", "tolerance", "part", "unit", "worst step")
    yield from table([[say(key, lang) for key in heads], *_rows(found, lang)])
    yield ""
    yield say("costs", lang)
    yield from (f"  {cost.over_all:6.1%}  {_step(cost, lang)}" for cost in found.costs[:_TOLD])


def _pencil(marking: Marking, drawings: int, lang: Lang) -> Iterator[str]:
    length, angle = _paper(marking)
    yield say("pencil", lang, length=f"{length:g}", angle=f"{angle:g}", count=drawings)
    yield say("scales", lang, scales=", ".join(_SCALES[key].format(f"{x:g}") for key, x in marking.scales.items()))
    key = "allowed part" if marking.relative else "allowed"
    yield say(key, lang, sigmas=f"{marking.sigmas:g}", part=f"{marking.relative:.3g}")


def _paper(marking: Marking) -> tuple[float, float]:
    """What the pencil errs by on paper [mm, deg]."""
    return marking.lengths["position"] / marking.scales["length"], math.degrees(marking.angle)


def _rows(found: Tolerances, lang: Lang) -> Iterator[list[str]]:
    for entry in sorted(found.entries, key=lambda entry: entry.points == 0):
        part = entry.tolerance / abs(entry.right) if entry.right else math.inf
        worst = found.worst(entry.text)
        yield [
            f"{entry.text}{' *' if entry.points else ''}", shown(entry.right, entry.unit),
            shown(entry.scatter, entry.unit), f"±{shown(entry.tolerance, entry.unit)}",
            f"{part:.1%}" if part < math.inf else "", EDGE[entry.unit].sign,
            "" if worst is None else f"{_step(worst, lang)} ({worst.parts[entry.text]:.0%})",
        ]  # fmt: skip


def _step(cost: Cost, lang: Lang) -> str:
    """A step in words."""
    mark = cost.mark
    fixed = mark.what == "point" and mark.of[0] == "frame"
    key = f"{mark.plane} {'frame' if fixed else mark.what}"
    of = (cost.name or mark.of[0], *mark.of[1:], "")
    key = key if key in PHRASES else f"{mark.plane} reading"
    return say(key, lang, **{f"of{k}": name for k, name in enumerate(of)})


def tolerance_data(found: Tolerances) -> Json:
    """For programs; SI units, radians."""
    marking = found.key.marking
    length, angle = _paper(marking)
    return {
        "format": 1,
        "name": found.key.name,
        "pencil": {"length_mm": length, "angle_deg": angle},
        "sigmas": marking.sigmas,
        "relative": marking.relative,
        "scales": dict(marking.scales),
        "drawings": found.drawings,
        "failed": found.failed,
        "quantities": {
            entry.text: {
                "unit": entry.unit, "right": entry.right, "scatter": entry.scatter, "tolerance": entry.tolerance,
                "asked": entry.points > 0,
            }
            for entry in found.entries
        },
        "steps": [
            {**_mark(cost.mark), "name": cost.name, "part": cost.over_all, "parts": dict(cost.parts)}
            for cost in found.costs
        ],
    }  # fmt: skip


def _mark(mark: Mark) -> Json:
    return {"plane": mark.plane, "what": mark.what, "of": list(mark.of)}


# --- power ------------------------------------------------------------------------------------


def power_lines(power: Power, lang: Lang) -> Iterator[str]:
    """A row a mistake: at how many places it can be made, and what came of those who make it."""
    yield say("power", lang, trials=power.trials)
    heads = ("mistake", "places", "applicable", "seen", "named", "alone", "least")
    ids = list(dict.fromkeys(one.name[0] for one in power.found))
    rows = [_power_row(id, [one for one in power.found if one.name[0] == id]) for id in ids]
    yield from table([[*(say(key, lang) for key in heads), ""], *rows, _power_row(say("all", lang), power.found)])
    out = [one for one in power.found if not one.applicable]
    names = dict.fromkeys(one.name[0] for one in out)
    share = f"{len(out) / max(len(power.found), 1):.0%}"
    if out:
        yield say("not applicable", lang, share=share, what=say("comma", lang).join(names))
    wrong, named = (f"{part:.2%}" for part in power.alarms)
    yield say("false alarms", lang, wrong=wrong, named=named)
    yield say("random", lang, named=f"{power.random:.2%}")


def _power_row(name: str, found: Sequence[Found]) -> list[str]:
    some = [one for one in found if one.applicable]
    if not some:
        return [name, str(len(found)), "0", "", "", "", "", ""]
    parts = [float(np.mean([getattr(one, what) for one in some])) for what in ("wrong", "named", "alone")]
    least = min(one.named for one in some)
    return [name, str(len(found)), str(len(some)), *(f"{part:.1%}" for part in parts), number(least), ""]


def power_data(power: Power) -> Json:
    """For programs: an object a mistake at a place, and the rates of false alarms."""
    return {
        "handed in": list(power.texts),
        "trials": power.trials,
        "mistakes": [
            {
                **dict(zip(("id", "way", "of", "form"), one.name, strict=True)), "moved": one.moved,
                "applicable": one.applicable, "wrong": _part(one.wrong), "named": _part(one.named),
                "alone": _part(one.alone),
            }
            for one in power.found
        ],
        "right work": {"judged wrong": power.alarms[0], "mistake named": power.alarms[1]},
        "random numbers": {"mistake named": power.random},
    }  # fmt: skip


def _part(value: float) -> float | None:
    return value if math.isfinite(value) else None
