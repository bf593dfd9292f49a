"""Tolerances that paper allows, and mistakes that can be told apart: in trials, and by the answers to a set."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.errors import Lang
from graphkin.marking.discriminability import LOOKED_AT, WELL, SetDiscriminability
from graphkin.marking.key import TELLS
from graphkin.marking.power import MistakePower, Power
from graphkin.marking.tolerances import Cost, Tolerances, Untold
from graphkin.model.quantities import EDGE
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.marks import edge_value, marks_table, mistake_kind
from graphkin.say.numbers import number
from graphkin.say.text_table import aligned, unbraced

_MOST_STEPS = 10  # steps that are printed
_READ = ("reading", "link")  # lengths and angles of the mechanism
_MOST_PAIRS = 10  # pairs of mistakes that are printed
_SCALES = {"length": "μ_l = {} m/mm", "velocity": "μ_v = {} (m/s)/mm", "acceleration": "μ_a = {} (m/s²)/mm"}


def tolerance_lines(tolerances: Tolerances, lang: Lang) -> Iterator[str]:
    """The pencil, a row a quantity, and the steps that cost most."""
    key, marking = tolerances.key, tolerances.key.marking
    yield key.title.get(lang) or next(iter(key.title.values()), key.name)
    length, angle = marking.on_paper
    yield say("tolerances.pencil", lang, length=f"{length:g}", angle=f"{angle:g}", count=tolerances.drawings)
    yield say("tolerances.scales", lang, scales=_scales(marking.scales, lang))
    allowed = "tolerances.allowed part" if marking.relative else "tolerances.allowed"
    yield say(allowed, lang, sigmas=f"{marking.sigmas:g}", part=f"{marking.relative:.3g}")
    heads = ("marks.column quantity", "marks.column right value", "tolerances.column scatter", "verdicts.tolerance",
             "tolerances.column part", "marks.column unit", "tolerances.column worst step")  # fmt: skip
    rows = [[say(name, lang) for name in heads]]
    for entry in sorted(tolerances.entries, key=lambda entry: entry.points == 0):
        name = f"{names.in_signs(entry.text)}{' *' if entry.points else ''}"
        right, scatter = edge_value(entry.right, entry.unit), edge_value(entry.scatter, entry.unit)
        unit = EDGE[entry.unit].sign
        if entry.doubt in ("dead point", "too small"):
            rows.append([name, right, scatter, "", "", unit, say(f"verdicts.verdict {entry.doubt}", lang)])
            continue
        part, worst = f"{entry.tolerance / abs(entry.right):.1%}" if entry.right else "", tolerances.worst(entry.text)
        cost = "" if worst is None else f"{_step(worst, lang)} ({worst.parts[entry.text]:.0%})"
        steep = say("tolerances.steep", lang) if entry.doubt else ""
        tolerance = f"±{edge_value(entry.tolerance, entry.unit)}"
        rows.append([name, right, scatter, tolerance, part, unit, f"{cost}{steep}"])
    yield from marks_table(rows)
    yield say("tolerances.asked", lang)
    yield from untold_lines(tolerances.untold, lang)
    yield ""
    yield say("tolerances.costs", lang)
    yield from (f"  {cost.over_all:6.1%}  {_step(cost, lang)}" for cost in tolerances.costs[:_MOST_STEPS])


def untold_lines(untold: Untold, lang: Lang) -> Iterator[str]:
    """A sentence an answer that paper does not tell."""
    for text, (off, scales) in untold.items():
        larger = scales and say("tolerances.larger", lang, scales=_scales(scales, lang))
        quantity = unbraced(names.in_signs(text))
        words = {"quantity": quantity, "part": f"{off:.1%}", "most": f"{TELLS:.0%}"}
        yield say("tolerances.untold", lang, **words, advice=larger or say("tolerances.no larger", lang))


def _scales(scales: Mapping[str, float], lang: Lang) -> str:
    return say("common.and", lang).join(_SCALES[key].format(f"{x:.3g}") for key, x in scales.items())


def _step(cost: Cost, lang: Lang) -> str:
    """A step in words."""
    mark = cost.mark
    point = "start" if cost.name else "frame" if mark.of[0] == "frame" else "point"
    what = point if mark.what == "point" else mark.what
    of = (cost.name or mark.of[0], *mark.of[1:], "")
    signs = (names.in_signs(name) if re.match(r"[va](\^\w+)?_|\w+ ", name) else names.point(name) for name in of)
    words = {f"of{k}": sign for k, sign in enumerate(signs)}
    if what == "reading" and mark.plane != "position":
        words["of0"] = names.stretch(*mark.of)
    key = "tolerances.step length" if mark.plane == "position" and what in _READ else f"tolerances.step {what}"
    return unbraced(say(key, lang, which=mark.plane == "acceleration", **words))


def power_lines(power: Power, lang: Lang) -> Iterator[str]:
    """A row a mistake: at how many places it can be made, and what came of those who make it."""
    yield say("tolerances.power", lang, trials=power.trials)
    heads = ("places", "applicable", "tellable", "seen", "named", "alone", "least", "mistake")
    ids = list(dict.fromkeys(one.name[0] for one in power.found))
    rows = [_power_row(mistake_kind(id, lang), [one for one in power.found if one.name[0] == id]) for id in ids]
    head = [say(f"tolerances.column {key}", lang) for key in heads]
    yield from _table([head, *rows, _power_row(say("tolerances.all", lang), power.found)])
    # the number of mistakes that are named as they should be; and of those that paper cannot tell
    some = [one for one in power.found if one.applicable]
    tellable, rest = ([one for one in some if one.tellable is expected] for expected in (True, False))
    part, missed = f"{WELL:.0%}", f"{1 - WELL:.0%}"
    well, well_of_rest = (sum(one.named >= WELL for one in group) for group in (tellable, rest))
    if tellable:
        yield say("tolerances.well named", lang, count=well, all=len(tellable), part=part)
    if rest:
        hidden = sum(one.observed is not None and one.observed.beyond < WELL for one in rest)
        yield say("tolerances.not tellable", lang, count=len(rest), all=len(some), missed=missed, hidden=hidden,
                  share=f"{len(rest) / len(some):.0%}", named=well_of_rest, part=part)  # fmt: skip
    out = [one for one in power.found if not one.applicable]
    called = dict.fromkeys(mistake_kind(one.name[0], lang) for one in out)
    share = f"{len(out) / max(len(power.found), 1):.0%}"
    if out:
        yield say("tolerances.not applicable", lang, share=share, what=say("common.list", lang).join(called))
    wrong, named = (f"{part:.2%}" for part in power.alarms)
    yield say("tolerances.false alarms", lang, wrong=wrong, named=named)
    yield say("tolerances.random", lang, named=f"{power.random:.2%}")


def _power_row(name: str, powers: Sequence[MistakePower]) -> list[str]:
    """Parts and the least of those that paper can tell, before the mistake in words."""
    some, tellable = [one for one in powers if one.applicable], [one for one in powers if one.tellable]
    counts = [str(len(one)) for one in (powers, some, tellable)]
    if not tellable:
        return [*counts, "", "", "", "", name]
    parts = [float(np.mean([getattr(one, what) for one in tellable])) for what in ("wrong", "named", "alone")]
    return [*counts, *(f"{part:.1%}" for part in parts), number(min(one.named for one in tellable)), name]


def _table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Numbers in columns, before words."""
    return (line.rstrip() for line in aligned(rows, ">" * (len(rows[0]) - 1) + "<"))


def discriminability_lines(told: SetDiscriminability, lang: Lang) -> Iterator[str]:
    """A row a mistake, then what is always one set, what the numbers make one, and false alarms."""

    def problems(count: int) -> str:
        return say("discriminability.problems", lang, which=count > 1, count=count)

    length, angle = (f"{error:g}" for error in told.pencil)
    yield say("discriminability.head", lang, problems=problems(told.problems), length=length, angle=angle)
    heads = [say("tolerances.column places", lang)]
    heads += [say(f"discriminability.column {told_by}", lang) for told_by in ("seen", "apart")]
    heads += [say("tolerances.column mistake", lang)]
    kinds = {mistake_kind(id, lang): each for id, each in told.kinds.items()}
    counts = {**kinds, say("tolerances.all", lang): (told.places, told.seen, told.apart)}
    rows = [[number(places), f"{seen:.0%}", f"{apart:.0%}", name] for name, (places, seen, apart) in counts.items()]
    yield from _table([heads, *rows])
    yield say("discriminability.not applicable", lang, share=f"{1 - told.seen:.0%}")
    yield from _pairs("sets", told.sets, lang)
    yield from _pairs("rivals", told.rivals, lang)
    lost = "discriminability.lost" if told.lost else "discriminability.nothing lost"
    yield say(lost, lang, share=f"{told.lost:.0%}", looked=LOOKED_AT)
    if told.tried:
        wrong, named = (f"{part:.2%}" for part in told.alarms)
        yield say("discriminability.false alarms", lang, problems=problems(told.tried), wrong=wrong, named=named)


def _pairs(what: str, pairs: Mapping[tuple[str, str], float], lang: Lang) -> Iterator[str]:
    if not pairs:
        return
    yield say(f"discriminability.pairs {what}", lang)
    for (first, second), share in list(pairs.items())[:_MOST_PAIRS]:
        words = {"first": mistake_kind(first, lang), "second": mistake_kind(second, lang)}
        yield "  " + say("discriminability.pair", lang, share=f"{share:.0%}", **words)
    if len(pairs) > _MOST_PAIRS:
        yield "  " + say("discriminability.more", lang, count=len(pairs) - _MOST_PAIRS)
