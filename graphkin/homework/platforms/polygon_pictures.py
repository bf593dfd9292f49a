"""Pictures for a page of feedback: the figure of the problem, the polygons that a mistake changes, and a drawing that
was handed in over them.

How much is shown goes with what is told. A hint has no polygon. With the mistake there is the drawing that it leads to
alone, without a scale: what the student has drawn, if the mistake is the one, and no value to copy. With the answer
it lies over the right drawing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from graphkin.errors import Lang, OwnFault, Where
from graphkin.homework.grading import SetMarker
from graphkin.homework.platforms.feedback import Reveal, as_on_sheets
from graphkin.homework.platforms.result import Result, ResultPicture
from graphkin.homework.problems.posed import shown_at
from graphkin.marking import Rewrite, rewrites
from graphkin.marking.consequences import DrawingComparison, compare_drawings
from graphkin.marking.diagnosis import Explanation
from graphkin.marking.key import Name
from graphkin.marking.marker import Marker
from graphkin.model.quantities import position_of
from graphkin.outputs.svg import inline
from graphkin.planning.asked import plane_of
from graphkin.running import replay_all
from graphkin.say.catalogue import say
from graphkin.say.marks import distinct_mistakes, mistakes_together
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Text
from graphkin.sheet.mistake_sheet import mistake_sheets
from graphkin.sheet.page import Sheet
from graphkin.sheet.single_figure import problem_picture
from graphkin.sheet.window import PLANES

_FIGURE = complex(80.0, 60.0)  # of the problem, at most [mm]
_KEPT = 64  # pictures that are held ready: many students of one key make one mistake
_SAME = 8  # so many mistakes that cannot be told apart are tried, for one that draws something otherwise


class PolygonPictures:
    """Makes the pictures of each result, by the key it was marked with."""

    def __init__(self, judge: SetMarker) -> None:
        self._judge = judge
        self._marker: Marker | None = None
        self._ready: dict[tuple[object, ...], list[ResultPicture]] = {}
        self._rewrites: dict[int, Mapping[Name, Rewrite]] = {}
        self._figures: dict[tuple[str, ...], ResultPicture] = {}

    def __call__(self, result: Result, lang: Lang, reveal: Reveal) -> Sequence[ResultPicture]:
        if reveal == "hint" or result.status != "marked" or not (result.suspicions or result.drawn):
            return ()
        marker = self._judge.marker(result.student)
        if marker is None:
            return ()
        if marker is not self._marker:
            self._marker, self._ready, self._rewrites = marker, {}, {}
        if result.drawn:
            return self._pictures(marker, result, lang, reveal)
        answers = tuple(line.text for line in result.lines)
        key = (lang, reveal, answers, *((one.names[:_SAME], _position(one)) for one in result.suspicions))
        if key not in self._ready:
            if len(self._ready) >= _KEPT:
                self._ready.pop(next(iter(self._ready)))
            self._ready[key] = self._pictures(marker, result, lang, reveal)
        return self._ready[key]

    def problem(self, result: Result, lang: Lang, reveal: Reveal = "mistake") -> ResultPicture | None:
        """The figure that the problem shows, under the problem's title; beside answers, the position they are of. The
        title alone where there is none."""
        marker = self._judge.marker(result.student) if result.lines else None
        if marker is None:
            return None
        name = (marker.method.mechanism.headline(lang), marker.method.mechanism.text, lang, reveal)
        if name not in self._figures:
            plot = replay_all(marker.method)
            shown = (plot, True) if reveal == "answer" else shown_at(marker.method, plot)
            drawn = None if shown is None else problem_picture(marker.method, shown[0], _FIGURE, lang)
            note = "" if shown is None or shown[1] else say("problems.figure elsewhere", lang)
            data = b"" if drawn is None else inline(drawn).encode()
            self._figures = {name: ResultPicture(name[0], _SVG, data, note)}
        return self._figures[name]

    def _pictures(self, marker: Marker, result: Result, lang: Lang, reveal: Reveal) -> list[ResultPicture]:
        """One for each explanation, or the student's drawing over the right one; an error of ours costs no more."""
        explanations = [(one.names, _position(one)) for one in result.suspicions] or [((), 1)]
        try:
            return [
                picture for names, at in explanations
                for picture in self._explained(marker, at, names, result, lang, reveal)
            ]  # fmt: skip
        except Exception as problem:
            reason = OwnFault(Where(result.file), type(problem).__name__).message(lang)
            return [ResultPicture(say("pictures.none", lang, reason=reason), "", b"")]

    def _explained(
        self, marker: Marker, at: int, names: Sequence[tuple[Name, ...]], result: Result, lang: Lang, reveal: Reveal
    ) -> list[ResultPicture]:
        """The drawings at a position, after a sentence that says what they show; the student's own is of the first."""
        here = marker.positions[at - 1]
        mistake, changed = self._otherwise(here, at, names)
        answer, own = reveal == "answer", result.drawn if at == 1 else {}
        answers = {position_of(line.text)[0] for line in result.lines}
        each = zip(here.key.entries, here.quantities, strict=True)
        last = max((PLANES.index(plane_of(quantity)) for one, quantity in each if one.text in answers), default=0)
        if changed is not None:  # nothing of a polygon that no answer is of
            changed = replace(changed, planes=tuple(p for p in changed.planes if PLANES.index(p) <= last))
        sheets = mistake_sheets(here.method, here.plot, found=changed, own=own, answer=answer, lang=lang)
        if not sheets:
            return [ResultPicture(say("pictures.nothing", lang), "", b"")] if mistake else []
        label = [say("pictures.position", lang, at=at)] if at > 1 else []
        if changed is not None:
            shows = as_on_sheets(result, mistakes_together(mistake, lang))
            alone = len(distinct_mistakes(mistakes_together(each, lang) for each in names)) == 1
            label.append(say("pictures.shows", lang, which=alone, mistake=shows))
            red = any(mark.new for sheet in sheets for mark in sheet.marks)
            label += [say("pictures.red", lang)] if red else []
        bracketed = any(isinstance(mark, Text) and mark.label[:1] == plain("(") for one in sheets for mark in one.marks)
        label += [say("pictures.brackets", lang)] if bracketed else []
        label += [] if answer else [say("pictures.no scale", lang)]
        sentence = say("pictures.between", lang).join(label)
        return [ResultPicture(sentence, "", b""), *(_drawn(sheet, sentence, lang) for sheet in sheets)]

    def _otherwise(
        self, here: Marker, at: int, names: Sequence[tuple[Name, ...]]
    ) -> tuple[tuple[Name, ...], DrawingComparison | None]:
        """The likeliest of the mistakes that is known, and its drawing; nothing where only others draw otherwise."""
        if at not in self._rewrites:
            every = rewrites(here.method, here.plot, here.quantities, here.key.marking.scales)
            self._rewrites[at] = {one.name: one for one in every}
        own = self._rewrites[at]
        known = [mistake for mistake in names[:_SAME] if mistake and all(name in own for name in mistake)]
        for k, mistake in enumerate(known):
            changed = compare_drawings(here.method, here.plot, [own[name] for name in mistake])
            if changed.planes:  # where the likeliest draws nothing otherwise, no other's drawing is the student's
                return ((), None) if k else (mistake, changed)
        return next(iter(known), ()), None


_SVG = "image/svg+xml"


def _drawn(sheet: Sheet, sentence: str, lang: Lang) -> ResultPicture:
    label = sheet.title + (say("common.colon", lang) + sentence if sentence else "")
    return ResultPicture(label, _SVG, inline(sheet).encode())


def _position(one: Explanation) -> int:
    """The first at which it explains something."""
    return position_of(one.explains[0])[1] if one.explains else 1
