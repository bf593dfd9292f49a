"""What paper allows, and how well mistakes are told apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphkin.errors import Lang
from graphkin.marking.discriminability import WELL
from graphkin.marking.key import Marking
from graphkin.marking.power import MistakePower, Power
from graphkin.marking.tolerances import Cost, Tolerances
from graphkin.model.quantities import EDGE
from graphkin.say.catalogue import is_phrase, say
from graphkin.say.marks import shown, table
from graphkin.say.names import in_signs
from graphkin.say.numbers import number

_TOLD = 10
"""Steps that are told."""
_SCALES = {"length": "μ_l = {} m/mm", "velocity": "μ_v = {} (m/s)/mm", "acceleration": "μ_a = {} (m/s²)/mm"}


# --- tolerances -------------------------------------------------------------------------------


def tolerance_lines(found: Tolerances, lang: Lang) -> Iterator[str]:
    """The pencil, a row a quantity, and the steps that cost most."""
    marking = found.key.marking
    yield found.key.title.get(lang) or next(iter(found.key.title.values()), found.key.name)
    yield from _pencil(marking, found.drawings, lang)
    heads = (
        "marks.column quantity", "marks.column right value", "tolerances.column scatter", "verdicts.tolerance",
        "tolerances.column part", "marks.column unit", "tolerances.column worst step",
    )  # fmt: skip
    yield from table([[say(name, lang) for name in heads], *_rows(found, lang)])
    yield say("tolerances.asked", lang)
    yield ""
    yield say("tolerances.costs", lang)
    yield from (f"  {cost.over_all:6.1%}  {_step(cost, lang)}" for cost in found.costs[:_TOLD])


def _pencil(marking: Marking, drawings: int, lang: Lang) -> Iterator[str]:
    length, angle = marking.on_paper
    yield say("tolerances.pencil", lang, length=f"{length:g}", angle=f"{angle:g}", count=drawings)
    scales = say("common.and", lang).join(_SCALES[key].format(f"{x:g}") for key, x in marking.scales.items())
    yield say("tolerances.scales", lang, scales=scales)
    allowed = "tolerances.allowed part" if marking.relative else "tolerances.allowed"
    yield say(allowed, lang, sigmas=f"{marking.sigmas:g}", part=f"{marking.relative:.3g}")


def _rows(found: Tolerances, lang: Lang) -> Iterator[list[str]]:
    for entry in sorted(found.entries, key=lambda entry: entry.points == 0):
        name = f"{in_signs(entry.text, lang)}{' *' if entry.points else ''}"
        right, scatter, unit = shown(entry.right, entry.unit), shown(entry.scatter, entry.unit), EDGE[entry.unit].sign
        if entry.doubt in ("dead point", "too small"):
            yield [name, right, scatter, "", "", unit, say(f"verdicts.verdict {entry.doubt}", lang)]
            continue
        part, worst = f"{entry.tolerance / abs(entry.right):.1%}" if entry.right else "", found.worst(entry.text)
        cost = "" if worst is None else f"{_step(worst, lang)} ({worst.parts[entry.text]:.0%})"
        steep = say("tolerances.steep", lang) if entry.doubt else ""
        yield [name, right, scatter, f"±{shown(entry.tolerance, entry.unit)}", part, unit, f"{cost}{steep}"]


def _step(cost: Cost, lang: Lang) -> str:
    """A step in words."""
    mark = cost.mark
    what = "frame" if mark.what == "point" and mark.of[0] == "frame" else mark.what
    of = (cost.name or mark.of[0], *mark.of[1:], "")
    words = {f"of{k}": name for k, name in enumerate(of)}
    step = f"tolerances.step {mark.plane} {what}"
    return say(step if is_phrase(step) else f"tolerances.step {mark.plane} reading", lang, **words)


# --- power ------------------------------------------------------------------------------------


def power_lines(power: Power, lang: Lang) -> Iterator[str]:
    """A row a mistake: at how many places it can be made, and what came of those who make it."""
    yield say("tolerances.power", lang, trials=power.trials)
    heads = ("mistake", "places", "applicable", "tellable", "seen", "named", "alone", "least")
    ids = list(dict.fromkeys(one.name[0] for one in power.found))
    rows = [_power_row(id, [one for one in power.found if one.name[0] == id]) for id in ids]
    head = [*(say(f"tolerances.column {key}", lang) for key in heads), ""]
    yield from table([head, *rows, _power_row(say("tolerances.all", lang), power.found)])
    yield from _told(power, lang)
    out = [one for one in power.found if not one.applicable]
    names = dict.fromkeys(one.name[0] for one in out)
    share = f"{len(out) / max(len(power.found), 1):.0%}"
    if out:
        yield say("tolerances.not applicable", lang, share=share, what=say("common.list", lang).join(names))
    wrong, named = (f"{part:.2%}" for part in power.alarms)
    yield say("tolerances.false alarms", lang, wrong=wrong, named=named)
    yield say("tolerances.random", lang, named=f"{power.random:.2%}")


def _told(power: Power, lang: Lang) -> Iterator[str]:
    """How many mistakes are named as they should be; and those that paper cannot tell."""
    some = [one for one in power.found if one.applicable]
    told, rest = ([one for one in some if one.tellable is tellable] for tellable in (True, False))
    part, missed = f"{WELL:.0%}", f"{1 - WELL:.0%}"
    if told:
        yield say("tolerances.well named", lang, count=_well(told), all=len(told), part=part)
    if rest:
        hidden = sum(one.observed is not None and one.observed.beyond < WELL for one in rest)
        yield say(
            "tolerances.not tellable", lang, count=len(rest), all=len(some), share=f"{len(rest) / len(some):.0%}",
            missed=missed, hidden=hidden, named=_well(rest), part=part,
        )  # fmt: skip


def _well(found: Sequence[MistakePower]) -> int:
    return sum(one.named >= WELL for one in found)


def _power_row(name: str, found: Sequence[MistakePower]) -> list[str]:
    """Parts and the least of those that paper can tell."""
    some, told = [one for one in found if one.applicable], [one for one in found if one.tellable]
    counts = [str(len(one)) for one in (found, some, told)]
    if not told:
        return [name, *counts, "", "", "", "", ""]
    parts = [float(np.mean([getattr(one, what) for one in told])) for what in ("wrong", "named", "alone")]
    return [name, *counts, *(f"{part:.1%}" for part in parts), number(min(one.named for one in told)), ""]
