"""The sentences of a solution, step by step, at knots along the drivers: templates, and tracks of their numbers.

An entry says something else at some knots, as where a sense turns round: it has a template for each of these.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cached_property
from typing import assert_never

import numpy as np

from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.handouts.stages import rows
from graphkin.outputs.letters import lettered
from graphkin.outputs.typesetting import signs
from graphkin.page.elements import signs_of
from graphkin.page.tracks import Tracks
from graphkin.planning import Method
from graphkin.planning.drawn_position import shown
from graphkin.say import names
from graphkin.say.catalogue import LANGUAGES, say
from graphkin.say.entry import Calculation, Entry, Heading, Sentence, VectorEquation
from graphkin.say.explained import drawn_acts
from graphkin.say.numbers import noted, noted_letter
from graphkin.say.numbers import number as printed
from graphkin.say.reading import Reading
from graphkin.say.solution_goal import solution_goal
from graphkin.sheet.lettering import Label, formula

_ANY = re.compile("[\ue100-\uf8ff]")
_HALF_TURN = 180.0  # an angle that changes by less does not begin anew [deg]
Signs = list[list[Plain]]
Words = list[Signs]  # the words of a block: one line, or the cells of an equation's three lines one after another


@frozen
class Spoken:
    """One entry at one knot: what it is, its words with letters for its numbers, and these."""

    kind: str
    words: Words
    numbers: tuple[float, ...]


@bulky
class StepWords:
    """The words of all steps of a method at the scales of the page."""

    method: Method
    scales: Mapping[str, float]

    @cached_property
    def vectors(self) -> dict[str, str]:
        """The name of each arrow by the text of its sign."""
        found: dict[str, str] = {}
        for construction in (self.method.velocity, self.method.acceleration):
            for name in construction.vectors():
                found.setdefault(_text(formula(names.vector(name))), name)
            letter = construction.plane[0]
            for node in construction.nodes.values():
                if node.site is not None:
                    found.setdefault(_text(formula(names.vector(f"{letter}_{node.of}"))), f"{letter}_{node.of}")
        return found

    def at(self, plot: Plot, lang: Lang) -> dict[int, list[Spoken]]:
        """The entries of each step at a position."""
        with noted() as numbers:
            reading = Reading(*shown(self.method, plot), self.scales, lang)
            entries = drawn_acts(solution_goal(reading, True), as_planned=True)
            return {step: [self._spoken(each, lang, numbers) for each in own] for step, own in by_step(entries)}

    def _spoken(self, entry: Entry, lang: Lang, numbers: Sequence[float]) -> Spoken:
        """An entry with letters of its own for its numbers; what is said at many knots is set once."""
        own = list[float]()

        def letter(match: re.Match[str]) -> str:
            own.append(numbers[ord(match[0]) - ord(noted_letter(0))])
            return noted_letter(len(own) - 1)

        texts = [_ANY.sub(letter, text) for text in _texts(entry, lang)]
        key = _kind(entry), lang, *texts
        if key not in self._set:
            points = self.method.mechanism.points
            labels = _cells(entry, lang, points) if isinstance(entry, VectorEquation) else [lettered(texts[0], points)]
            self._set[key] = [self._signs(label) for label in labels]
        return Spoken(key[0], self._set[key], tuple(own))

    @cached_property
    def _set(self) -> dict[tuple[str, ...], Words]:
        return {}

    def _signs(self, label: Label) -> Signs:
        found: Signs = []
        for sign in signs_of(label):
            base, _, low, high = [*sign, "", "", ""][:4]
            vector = self.vectors.get(f"{base}_{low}^{high}") if low else None
            found.append([*sign, vector] if vector else sign)
        return found


def _each_text(words: Words, change: Callable[[str], str]) -> Words:
    return [[[change(part) if isinstance(part, str) else part for part in sign] for sign in line] for line in words]


def _text(label: Label) -> str:
    """The text of a letter with its scripts, as one."""
    sign = next(signs(label))
    base, low, high = ("".join(run.text for run in runs) for runs in sign.runs)
    return f"{base}_{low}^{high}"


def _kind(entry: Entry) -> str:
    match entry:
        case Heading():
            return "heading"
        case Sentence():
            return "said" if entry.act is None else "step"
        case Calculation():
            return "formula"
        case VectorEquation():
            return "equation"
        case _:
            assert_never(entry)


def _texts(entry: Entry, lang: Lang) -> list[str]:
    """The words of an entry; of an equation, which has no numbers, those of its cells."""
    match entry:
        case Heading(text=text) | Sentence(text=text):
            return [text]
        case Calculation():
            note = say("common.note", lang, note=entry.note) if entry.note else ""
            return [entry.text + note]
        case VectorEquation():
            return [cell for column in entry.columns for cell in column]
        case _:
            assert_never(entry)


def _cells(entry: VectorEquation, lang: Lang, points: Collection[str]) -> list[Label]:
    """The cells of an equation's three lines, one after another."""
    return [label or () for line in rows(entry, lang, points).lines for label in line]


def by_step(entries: Sequence[Entry]) -> Iterator[tuple[int, list[Entry]]]:
    """The entries of each act's page: what leads to its sentence, the sentence, and what is measured after it."""
    begun: list[Entry] = []
    step, plane = 0, None
    for k, entry in enumerate(entries):
        after = entries[k + 1] if k + 1 < len(entries) else None
        if isinstance(entry, Heading):
            if step:
                yield step, begun
            begun, step, plane = [], 0, entry.plane
        leads = isinstance(entry, VectorEquation) or (isinstance(entry, Sentence) and isinstance(after, VectorEquation))
        if step and (leads or (isinstance(entry, Sentence) and entry.act is not None)):
            yield step, begun
            begun, step = [], 0
        if plane is not None or isinstance(entry, Heading | Sentence | Calculation | VectorEquation):
            begun.append(entry)
        if isinstance(entry, Sentence) and entry.act is not None:
            step = entry.act.page
    if step:
        yield step, begun


def spoken_steps(
    words: StepWords, plots: Sequence[Plot | None], tracks: Tracks, in_a_row: bool
) -> list[dict[str, object]]:
    """The steps with their entries in both languages, each with its templates, as the page has them."""
    told = {lang: [words.at(plot, lang) if plot is not None else {} for plot in plots] for lang in LANGUAGES}
    every = sorted({step for at in told["en"] for step in at})
    planes: dict[int, Plane] = {act.page: act.plane for act in words.method.acts}
    steps: list[dict[str, object]] = []
    for step in every:
        own: dict[str, object] = {"step": step, "plane": planes[step]}
        for lang in LANGUAGES:
            knots = [at.get(step, []) for at in told[lang]]
            most = max(map(len, knots))
            own[lang] = [_entry([each[k] if k < len(each) else None for each in knots], tracks, in_a_row)
                         for k in range(most)]  # fmt: skip
        steps.append(own)
    return steps


def _entry(knots: Sequence[Spoken | None], tracks: Tracks, in_a_row: bool) -> list[dict[str, object]]:
    """One entry: its templates, each with the knots at which it is said."""
    templates: dict[str, dict[int, Spoken]] = {}
    for k, spoken in enumerate(knots):
        if spoken is not None:
            templates.setdefault(repr((spoken.kind, spoken.words)), {})[k] = spoken
    entries: list[dict[str, object]] = []
    for own in templates.values():
        first = next(iter(own.values()))
        table = np.full((len(knots), len(first.numbers)), np.nan)
        table[[*own]] = [spoken.numbers for spoken in own.values()]
        there = np.zeros(len(knots), dtype=bool)
        there[[*own]] = True
        turns = [_turns(first, n, table[:, n]) for n in range(table.shape[1])]
        columns = [unfolded(table[:, n]) if in_a_row and not turns[n] else table[:, n] for n in range(len(turns))]
        numbers = [tracks.fine(column) for column in columns]
        fixed = [printed(each) if isinstance(each, float) else None for each in numbers]
        left = [each for each in numbers if not isinstance(each, float)]
        entry: dict[str, object] = {"kind": first.kind, "words": _filled(first.words, fixed)}
        entry |= {"numbers": [each[0] for each in left]} if left else {}
        moved = [n for n, each in enumerate(numbers) if not isinstance(each, float)]
        sizes = [k for k, n in enumerate(moved) if np.nanmin(columns[n]) < 0 <= np.nanmin(table[:, n])]
        entry |= {"sizes": sizes} if sizes else {}
        entry |= {"turns": some} if (some := [k for k, n in enumerate(moved) if turns[n]]) else {}
        entry |= {"mask": mask} if (mask := tracks.mask(there)) is not None else {}
        entries.append(entry)
    return entries


def unfolded(column: np.ndarray) -> np.ndarray:
    """A size that goes down to nothing and up again goes on below it: the page shows it without its sign."""
    held = ~np.isnan(column)
    sizes = column[held]
    if len(sizes) < 8 or sizes.min() < 0:
        return column
    signed = sizes.copy()
    for k in range(3, len(sizes)):
        ahead = 3 * signed[k - 1] - 3 * signed[k - 2] + signed[k - 3]
        if abs(ahead + sizes[k]) < abs(ahead - sizes[k]):
            signed[k] = -sizes[k]
    rough = [np.abs(np.diff(each, 3)).max() for each in (signed, sizes)]
    unfolded = column.copy()
    unfolded[held] = signed if rough[0] < rough[1] / 2 else sizes
    return unfolded


def _turns(spoken: Spoken, number: int, column: np.ndarray) -> bool:
    """True of an angle that begins anew after a full turn: the page goes on past it."""
    is_angle = any(f"{noted_letter(number)}°" in str(sign[0]) for line in spoken.words for sign in line)
    return is_angle and bool(np.nanmin(column) >= 0) and bool(np.ptp(column[~np.isnan(column)]) > _HALF_TURN)


def _filled(words: Words, fixed: Sequence[str | None]) -> Words:
    """The words with numbers that never change; the others are numbered anew."""
    left = {k: n for n, k in enumerate(k for k, text in enumerate(fixed) if text is None)}

    def letter(match: re.Match[str]) -> str:
        k = ord(match[0]) - ord(noted_letter(0))
        return fixed[k] or noted_letter(left[k])

    return _each_text(words, lambda text: _ANY.sub(letter, text))
