"""Pictures for a page of feedback: the polygons that a mistake changes, and a drawing that was handed in over them.

How much is shown goes with what is told. A hint has no picture. With the mistake there is the drawing that it leads to
alone, without a scale: what the student has drawn, if the mistake is the one, and no value to copy. With the answer
the right drawing stands beside it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from graphkin.construction import Plot
from graphkin.errors import Lang, OwnFault, Where
from graphkin.homework.grading import SetMarker
from graphkin.homework.platforms.feedback import Reveal
from graphkin.homework.platforms.result import Result, ResultPicture, Suspicion
from graphkin.marking import Rewrite, rewrites
from graphkin.marking.consequences import DrawingComparison, compare_drawings
from graphkin.marking.key import Name
from graphkin.marking.marker import Marker
from graphkin.model.quantities import position_of
from graphkin.outputs.svg import inline
from graphkin.planning import Method
from graphkin.say.catalogue import say
from graphkin.say.mistakes import together
from graphkin.sheet.mistake_sheet import mistake_sheet

_KEPT = 64
"""Pictures that are held ready: many students of one key make one mistake."""
_SAME = 8
"""So many mistakes that cannot be told apart are tried, for one that draws something otherwise."""


class PolygonPictures:
    """Makes the pictures of each result, by whoever's key it was marked."""

    def __init__(self, judge: SetMarker) -> None:
        self._judge = judge
        self._marker: Marker | None = None
        self._ready: dict[tuple[object, ...], list[ResultPicture]] = {}

    def __call__(self, result: Result, lang: Lang, reveal: Reveal) -> Sequence[ResultPicture]:
        if reveal == "hint" or result.status != "marked" or not (result.suspicions or result.drawn):
            return ()
        marker = self._judge.marker(result.student)
        if marker is None:
            return ()
        if marker is not self._marker:
            self._marker, self._ready = marker, {}
            self._problem = _Problem([_Position(each, at) for at, each in enumerate(marker.positions, 1)])
        if result.drawn:
            return self._drawn(result, lang, reveal)
        asked = (lang, reveal, *((one.names[:_SAME], _position(one)) for one in result.suspicions))
        if asked not in self._ready:
            if len(self._ready) >= _KEPT:
                self._ready.pop(next(iter(self._ready)))
            self._ready[asked] = self._drawn(result, lang, reveal)
        return self._ready[asked]

    def _drawn(self, result: Result, lang: Lang, reveal: Reveal) -> list[ResultPicture]:
        """An error of ours costs the picture, not the page, and is said there."""
        try:
            return self._problem.pictures(result, lang, reveal)
        except Exception as problem:
            reason = OwnFault(Where(result.file), type(problem).__name__).message(lang)
            return [ResultPicture(say("pictures.none", lang, reason=reason), "", b"")]


def _position(one: Suspicion) -> int:
    """The first at which it explains something."""
    return position_of(one.explains[0])[1] if one.explains else 1


class _Problem:
    """One key's positions; what a student has drawn is of the first."""

    def __init__(self, positions: Sequence[_Position]) -> None:
        self.positions = positions

    def pictures(self, result: Result, lang: Lang, reveal: Reveal) -> list[ResultPicture]:
        """One for each explanation; where there is none, the student's drawing over the right one."""
        told = [(one.names, _position(one)) for one in result.suspicions] or [((), 1)]
        found = (self.positions[at - 1].picture(names, result, lang, reveal) for names, at in told)
        return [picture for picture in found if picture is not None]


class _Position:
    """One position, and what can go wrong at it."""

    def __init__(self, marker: Marker, at: int) -> None:
        self.marker, self.at = marker, at

    @property
    def method(self) -> Method:
        return self.marker.method

    @property
    def plot(self) -> Plot:
        return self.marker.plot

    @cached_property
    def rewrites(self) -> Mapping[Name, Rewrite]:
        marker = self.marker
        every = rewrites(self.method, self.plot, marker.quantities, marker.key.marking.scales)
        return {one.name: one for one in every}

    def picture(
        self, names: Sequence[tuple[Name, ...]], result: Result, lang: Lang, reveal: Reveal
    ) -> ResultPicture | None:
        made, found = self._otherwise(names)
        answer, own = reveal == "answer", result.drawn if self.at == 1 else {}
        sheet = mistake_sheet(self.method, self.plot, found=found, own=own, answer=answer, lang=lang)
        if sheet is None:
            return ResultPicture(say("pictures.nothing", lang), "", b"") if made else None
        told = [say("pictures.position", lang, at=self.at)] if self.at > 1 else []
        told += [] if found is None else _of_mistake(made, found, answer, lang)
        told += [say("pictures.dashed", lang)] if own else []
        return ResultPicture(say("pictures.between", lang).join(told), "image/svg+xml", inline(sheet).encode())

    def _otherwise(self, names: Sequence[tuple[Name, ...]]) -> tuple[tuple[Name, ...], DrawingComparison | None]:
        """The first of the mistakes that draws something otherwise, and what; where none does, the first known."""
        known = [made for made in names[:_SAME] if made and all(name in self.rewrites for name in made)]
        for made in known:
            found = compare_drawings(self.method, self.plot, [self.rewrites[name] for name in made])
            if found.planes:
                return made, found
        return next(iter(known), ()), None


def _of_mistake(made: tuple[Name, ...], found: DrawingComparison, answer: bool, lang: Lang) -> list[str]:
    told = [say("pictures.shows", lang, mistake=together(made, lang))]
    if any(found.arrows.values()) or any(found.images.values()):
        told.append(say("pictures.thick", lang))
    return told if answer else [*told, say("pictures.no scale", lang)]
