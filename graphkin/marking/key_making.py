"""A key made of a mechanism: right values with what paper allows, and the outcomes of mistakes, one or two together."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import chain, combinations, islice, product

import numpy as np

from graphkin.construction import Measure, Plot
from graphkin.marking.answers import asked_of, on_the_way, sort_of
from graphkin.marking.consequences import combined, rewrites
from graphkin.marking.key import MOST, Hypotheses, Key, KeyEntry, KeyStep, Marking, Name, less_together, part_off
from graphkin.marking.rewrite import Rewrite
from graphkin.marking.synonyms import other_methods
from graphkin.marking.tolerances import DRAWINGS, drawings_of, spread
from graphkin.model.mechanism import Usual
from graphkin.model.quantities import EDGE, Quantity
from graphkin.planning import Method
from graphkin.running import replay_all

_FEW = 500  # drawings where many problems are compared
_FEWER = 250  # drawings of each mistake
_HARDLY = 1e-3  # so small a part of the pencil's errors makes everything scatter in proportion
_STEEP = 1.2
"""A scatter that is so many times larger or smaller than in proportion is said to be; near a dead point it is."""
_FAILED = 0.05  # where the links do not meet in a larger part of the drawings, too, paper cannot tell the value
_NOTHING = 1e-9  # a value that is a smaller part of the largest of its kind is 0


def make_key(method: Method, marking: Marking, quantities: Sequence[Quantity] = (), marks: bool = True) -> Key:
    """The key of a mechanism at its drawn position.

    quantities  further ones that may be handed in, beside what is asked and what is met on the way
    marks       it marks work; else it is read only, and of mistakes it has the values alone, not what a pencil adds
    """
    mechanism, plot = method.mechanism, replay_all(method)
    asked = asked_of(mechanism)
    words = {quantity.text: question for question, quantity in asked.items()}
    every = list({q.text: q for q in (*asked.values(), *on_the_way(method), *quantities)}.values())
    right = _right(method, plot, every)
    naturals = _naturals(method, every, right)
    kept = [k for k, q in enumerate(every) if right[k] or q.text in words or q in quantities]
    every, right = [every[k] for k in kept], right[kept]
    sorts = [sort_of(q) for q in every]
    sizes = np.array([sort == "size" for sort in sorts], dtype=bool)
    drawings = drawings_of(method, marking, DRAWINGS)
    drawn = drawings.values(every)[0]
    failed = drawings.failed + (1 - drawings.failed) * np.isnan(drawn).mean(axis=0)
    drawn = np.where(sizes, np.abs(drawn), drawn)
    hardly = drawings_of(method, marking, DRAWINGS, _HARDLY).values(every)[0]
    worth = {text: mechanism.worth.get(text, 1.0) for text in asked} or {q.text: 1.0 for q in every}
    entries = tuple(
        _doubted(
            _entry(words.get(q.text, q.text), q, value, deviation, naturals[q.unit], marking, worth),
            mechanism.usual.size(q.unit), deviation, proportional, part,
        )
        for q, value, deviation, proportional, part in zip(
            every, right, spread(drawn, right, sorts), spread(hardly, right, sorts) / _HARDLY, failed, strict=True
        )
    )  # fmt: skip
    singles = [(one,) for one in rewrites(method, plot, every, marking.scales)]
    title = {str(lang): text for lang, text in mechanism.title.items()}
    return Key(
        mechanism.name, mechanism.text, method.structure.coincident, marking, entries,
        _together(drawn), hypotheses_of(method, plot, every, entries, marking if marks else None, singles), title,
        steps_of(method),
    )  # fmt: skip


AskedAnswers = tuple[tuple[Quantity, ...], tuple[KeyEntry, ...], float]


def asked_alone(method: Method, plot: Plot, marking: Marking) -> AskedAnswers:
    """The quantities asked for, and what paper allows of them, without anything on the way; with the part of the
    drawings whose links do not meet."""
    asked = asked_of(method.mechanism)
    every = tuple({quantity.text: quantity for quantity in asked.values()}.values())
    words = {quantity.text: question for question, quantity in asked.items()}
    right = _right(method, plot, every)
    naturals, worth = _naturals(method, every, right), dict.fromkeys(asked, 1.0)
    drawings = drawings_of(method, marking, DRAWINGS)
    drawn = drawings.values(every)[0]
    scatters = spread(drawn, right, [sort_of(quantity) for quantity in every])
    entries = tuple(
        _entry(words[q.text], q, value, deviation, naturals[q.unit], marking, worth)
        for q, value, deviation in zip(every, right, scatters, strict=True)
    )
    return every, entries, drawings.failed + (1 - drawings.failed) * float(np.isnan(drawn).any(axis=1).mean())


def steps_of(method: Method) -> tuple[KeyStep, ...]:
    """The vector equations of both polygons with what is read off them."""
    steps = []
    for construction in (method.velocity, method.acceleration):
        for equation in construction.equations:
            left, right = (tuple(t.name(construction.plane) for t in side) for side in (equation.left, equation.right))
            measured = [step for step in equation.steps if isinstance(step, Measure)]
            gives = tuple(f"{step.quantity} {step.of}" for step in measured if step.quantity in ("omega", "alpha"))
            steps.append(KeyStep(construction.plane, left, right, gives))
    return tuple(steps)


def _right(method: Method, plot: Plot, quantities: Sequence[Quantity]) -> np.ndarray:
    """Right values; sizes without sign."""
    answers = combined(method, plot, quantities, [()]).values[0]
    return np.array([abs(v) if sort_of(q) == "size" else v for q, v in zip(quantities, answers, strict=True)])


def _naturals(method: Method, quantities: Sequence[Quantity], values: np.ndarray) -> dict[str, float]:
    """The largest value of each unit, or what is usual."""
    largest: dict[str, float] = {}
    for quantity, value in zip(quantities, values, strict=True):
        if np.isfinite(value):
            largest[quantity.unit] = max(largest.get(quantity.unit, 0.0), abs(float(value)))
    return {unit: size or method.mechanism.usual.size(unit) for unit, size in largest.items()}


# --- what may be off --------------------------------------------------------------------------


def half_digit(value: float, unit: str, natural: float = 0.0) -> float:
    """Half of the third digit that is printed of a value; of the largest of its kind, where it is 0."""
    factor = EDGE[unit].factor
    shown = abs(value or natural) * factor
    return 0.5 * 10.0 ** (math.floor(math.log10(shown)) - 2) / factor if shown > 0 else 0.0


def _entry(
    text: str, quantity: Quantity, right: float, deviation: float, natural: float, marking: Marking,
    worth: Mapping[str, float],
) -> KeyEntry:  # fmt: skip
    half = half_digit(float(right), quantity.unit, natural)
    deviation = float(deviation) if np.isfinite(deviation) else 0.0
    scatter, points = math.hypot(deviation, half / math.sqrt(3)), worth.get(text, 0.0)
    tolerance = _tolerance(right, scatter, half, marking)
    return KeyEntry(text, quantity.unit, sort_of(quantity), float(right), scatter, tolerance, points)


def _tolerance(right: float, scatter: float, half: float, marking: Marking) -> float:
    """Of a value, by its scatter or as a part of it; at least half of its last digit."""
    allowed = marking.relative * abs(right) if marking.relative and right else marking.sigmas * scatter
    return max(float(allowed), half)


def allowed_anew(entries: Sequence[KeyEntry], marking: Marking, usual: Usual) -> tuple[KeyEntry, ...]:
    """The entries of a key with what is allowed by another marking."""
    anew: list[KeyEntry] = []
    for entry in entries:
        natural = max(abs(other.right) for other in entries if other.unit == entry.unit) or usual.size(entry.unit)
        half = half_digit(entry.right, entry.unit, natural)
        one = replace(entry, tolerance=_tolerance(entry.right, entry.scatter, half, marking))
        told = "" if entry.doubt == "too small" else entry.doubt
        small = told != "dead point" and part_off(one, usual.size(entry.unit)) > MOST
        anew.append(replace(one, doubt="too small" if small else told))
    return tuple(anew)


def wider(key: Key, more: np.ndarray, usual: Usual) -> Key:
    """A key for values that scatter by so much more (n,), each by itself."""
    scatters = np.array([entry.scatter for entry in key.entries])
    whole = np.hypot(scatters, more)
    entries = [replace(entry, scatter=float(one)) for entry, one in zip(key.entries, whole, strict=True)]
    part = np.divide(scatters, whole, out=np.ones_like(whole), where=whole > 0)
    return replace(key, entries=allowed_anew(entries, key.marking, usual), singles=key.singles.wider(more),
                   together=less_together(key.together, part))  # fmt: skip


def _doubted(entry: KeyEntry, usual: float, deviation: float, proportional: float, failed: float) -> KeyEntry:
    """An entry with what is to be said against it.

    usual         size of quantities of its kind; that of places and angles, which have no zero of their own
    proportional  what it would scatter by, were that in proportion to the pencil's errors
    failed        part of the drawings in which it has no value
    """
    small = max(deviation, proportional) <= half_digit(entry.right, entry.unit, usual)
    steep = not (small or 1 / _STEEP <= deviation / proportional <= _STEEP)
    if steep and failed > _FAILED:
        return replace(entry, doubt="dead point")
    return replace(entry, doubt="too small" if part_off(entry, usual) > MOST else "steep" if steep else "")


def _together(drawn: np.ndarray) -> np.ndarray:
    """The correlation (n, n) of the quantities' scatters, of drawings (drawings, n)."""
    series = drawn[np.isfinite(drawn).all(axis=1)].T.copy()
    if series.shape[1] < 3:
        return np.eye(drawn.shape[1])
    return np.asarray(np.round(_correlated(_ranked(series)), 6))


def _ranked(series: np.ndarray) -> np.ndarray:
    """Ranks (k, count), from their middle: by these a few drawings far off say nothing of the others."""
    count = series.shape[1]
    ranks = np.empty(series.shape)
    np.put_along_axis(ranks, np.argsort(series, axis=1), np.arange(count)[None] - (count - 1) / 2, axis=1)
    still = np.ptp(series, axis=1) <= 1e-9 * np.max(np.abs(series), axis=1, initial=0.0)
    ranks[still] = 0.0
    return ranks


def _correlated(ranks: np.ndarray) -> np.ndarray:
    """The correlation (.., n, n) of ranks (.., n, count)."""
    n, count = ranks.shape[-2:]
    correlation = ranks @ ranks.swapaxes(-1, -2) * 12 / (count * (count**2 - 1))
    correlation[..., range(n), range(n)] = 1.0
    return np.asarray(correlation)


def hypotheses_of(
    method: Method, plot: Plot, quantities: Sequence[Quantity], entries: Sequence[KeyEntry], marking: Marking | None,
    columns: Sequence[tuple[Rewrite, ...]],
) -> Hypotheses:  # fmt: skip
    """The outcomes of mistakes, those of a column made together. Rows that say the same are kept: they are one set."""
    if not columns:
        return Hypotheses((), np.empty((0, len(entries))), np.empty((0, len(entries))))
    values = combined(method, plot, quantities, columns).values
    names = tuple(tuple(rewrite.name for rewrite in column) for column in columns)
    if marking is None:
        return Hypotheses(names, values, np.full(values.shape, np.nan))
    drawings = drawings_of(method, marking, _FEWER)
    sorts = [entry.sort for entry in entries]
    sizes = np.array([sort == "size" for sort in sorts], dtype=bool)
    scatters, untouched = np.zeros(values.shape), np.empty(values.shape, dtype=bool)
    together = np.empty((*values.shape, len(entries)))
    right, *_ = drawings.values(quantities)
    straight, row = _ranked(np.where(sizes, np.abs(right), right).T.copy()), 0
    for drawn in drawings.parts(quantities, columns):
        some = slice(row, row := row + len(drawn))
        same = np.all((np.abs(drawn - right) <= _NOTHING * np.abs(right)) | np.isnan(right), axis=1)
        untouched[some] = same
        judged = np.where(np.isfinite(values[some, None]), np.where(sizes, np.abs(drawn), drawn), 0.0)
        changed = np.nonzero(~same)
        scatters[some][changed] = spread(
            drawn.swapaxes(1, 2)[changed].T, values[some][changed], [sorts[k] for k in changed[1]]
        )
        ranks = np.where(np.isfinite(values[some, :, None]), straight, 0.0)  # what is left as it is has its ranks
        ranks[changed] = _ranked(judged.swapaxes(1, 2)[changed])
        together[some] = np.round(_correlated(ranks), 2)
        for k in np.flatnonzero(~np.isfinite(judged).all(axis=(1, 2)) | ~np.isfinite(right).all()):
            together[some][k] = np.round(_together(judged[k]), 2)  # without the drawings that fail
    scatters = np.hypot(scatters, least_of(values, entries))
    # what a mistake leaves as it is scatters as it does: few drawings say little of that near a dead point
    scatters = np.where(untouched, [entry.scatter for entry in entries], scatters)
    scatters = np.where(np.isfinite(values), scatters, np.nan)
    return Hypotheses(names, values, scatters, together)


def least_of(values: np.ndarray, entries: Sequence[KeyEntry]) -> np.ndarray:
    """Rounding in print (.., n): of mistaken values (.., n), or what the right one has where that is 0."""
    factors = np.array([EDGE[entry.unit].factor for entry in entries])
    right, scatters = np.array([(abs(entry.right), entry.scatter) for entry in entries]).T
    shown = np.abs(np.where(values == 0, right, values)) * factors
    with np.errstate(divide="ignore"):
        least = 0.5 * 10.0 ** (np.floor(np.log10(shown)) - 2) / factors / math.sqrt(3)
    return np.where(np.isfinite(values), np.where(least > 0, least, scatters), np.nan)


def by_other_methods(method: Method, key: Key, quantities: Sequence[Quantity]) -> Hypotheses:
    """Right values, a row for each other method that gives them all, with what a pencil makes of them by that method.
    Whoever takes it reads off what another has drawn, and the other way round: the same values err by more there, by
    less here, and otherwise together."""
    right, sorts = np.array([entry.right for entry in key.entries]), [entry.sort for entry in key.entries]
    least = least_of(right, key.entries)
    scatters, together = [], []
    for other in other_methods(method):
        drawn = drawings_of(other, key.marking, _FEW).values(quantities)[0]
        drawn = np.where([sort == "size" for sort in sorts], np.abs(drawn), drawn)
        off = spread(drawn, right, sorts)
        if np.isfinite(off).all():
            scatters.append(np.hypot(off, least))
            together.append(_together(drawn))
    count, size = len(scatters), len(right)
    return Hypotheses(
        ((),) * count, np.tile(right, (count, 1)), np.reshape(scatters, (count, size)),
        np.reshape(together, (count, size, size)),
    )  # fmt: skip


_MOST = 6000  # pairs beyond so many are not tried: among so many, chance hits outweigh hints


def pairs_of(
    method: Method, plot: Plot, key: Key, quantities: Sequence[Quantity], known: Mapping[Name, Rewrite],
    first: Name | None = None,
) -> Hypotheses:  # fmt: skip
    """The outcomes of pairs of mistakes, `known` by name, or of those with one `first`. Each of two scatters as much as
    the one that scatters more, in proportion."""
    rows = {row[0]: k for k, row in enumerate(key.singles.names) if row[0] in known}
    # made at different places; what was drawn right and written otherwise only beside what was drawn wrong
    drawn, written = ([known[name] for name in rows if bool(known[name].edits) is edits] for edits in (True, False))
    pairs: Iterable[tuple[Rewrite, Rewrite]] = chain(combinations(drawn, 2), product(drawn, written))
    one = None if first is None else known.get(first)
    if one is not None:
        pairs = ((one, other) for other in (*drawn, *written)) if one.edits else ((other, one) for other in drawn)
    spots = {name: {edit.spot for edit in one.edits} for name, one in known.items()}
    apart = (pair for pair in pairs if spots[pair[0].name].isdisjoint(spots[pair[1].name]) and pair[0] is not pair[1])
    both = list(islice(apart, _MOST))
    if not both:
        return Hypotheses((), np.empty((0, len(quantities))), np.empty((0, len(quantities))))
    values = combined(method, plot, quantities, both).values
    scatters = []
    for k in (0, 1):  # of either mistake, larger where the pair's values are
        single = np.array([rows[pair[k].name] for pair in both])
        with np.errstate(divide="ignore", invalid="ignore"):
            larger = np.abs(values) / np.abs(key.singles.values[single])
        times = np.where(np.isfinite(larger), np.maximum(larger, 1.0), 1.0)
        scatters.append(np.where(np.isfinite(values), key.singles.scatters[single] * times, np.nan))
    return Hypotheses(tuple((one.name, other.name) for one, other in both), values, np.fmax(*scatters))
