"""The sheet of a mechanism: its figure and its polygons, drawn once to see how far they reach, laid out, lettered.

Labels that find no place choose paper and scales, too: a division is lettered near by before it is taken, unless its
figures are too small for so many labels.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Plane, Plot
from graphkin.errors import Lang
from graphkin.planning import Method
from graphkin.planning.acts import Act
from graphkin.planning.by_pose import shown
from graphkin.say.catalogue import say
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.say.numbers import circled
from graphkin.say.reading import Reading
from graphkin.sheet.composition import Composed, Composition, Planes, Style
from graphkin.sheet.layout import Layout, cut_to, papers_for
from graphkin.sheet.lettering import formula, plain
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import BODY, LARGE, Room, TooLargeForPaper
from graphkin.sheet.path_figure import NONE, Paths
from graphkin.sheet.results import tables
from graphkin.sheet.text_blocks import LINE, broken
from graphkin.sheet.titleblock import tables_room
from graphkin.sheet.window import PLANES

_CROWDED, _EASED = 10, 2 / 3
"""With more leaders than this a larger paper is tried, and taken where it leaves no more than such a part of them."""
_TRIALS = 4
"""How often equations are moved into the strip, whose height leaves figures less room."""


def mechanism_sheet(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    style: Style = "construction",
    upto: int | None = None,
    tight: bool = False,
    paths: Paths = NONE,
) -> Sheet:
    """Draw a mechanism and its polygons to scale.

    plot   the method replayed at one position
    paper  a key of `PAPERS`; the smallest that fits where left out, cut to a single figure
    tight  cut to the figures, without frame, table and title, for another document
    only   the plane or planes to draw; all three where left out
    style  "construction": how the polygons are drawn, too; "result": what comes of it; "given": the mechanism with
           what is known of it, and nothing that would have to be found
    paths  of points, drawn under the mechanism
    upto   draw the construction as far as this act of those planes, counted from 1, its newest marks emphasised

    Raises TooLargeForPaper where a scale of the mechanism file is too fine for A3.
    """
    if style == "given":
        return _given(Planes(method, plot, ("position",), style, lang), paper, tight)
    method, plot = shown(method, plot)
    drawing = Planes(method, plot, _planes(only), style, lang, paths)
    work = Composition(drawing, [] if tight else tables(method, plot, lang), tight)
    if upto is not None:
        return next(_staged(work, paper, [upto]))
    return _whole(work, paper).lettered.sheet


def _given(drawing: Planes, paper: str | None, tight: bool) -> Sheet:
    """The mechanism alone, with what the problem gives and asks."""
    from graphkin.sheet.results import given_tables

    work = Composition(drawing, [] if tight else given_tables(drawing.reading({})), tight)
    return replace(_whole(work, paper).lettered.sheet, given=True)


def _whole(work: Composition, paper: str | None) -> Composed:
    """Divided best, and lettered as well as can be; equations for which figures have no room go into the strip.

    Those that only a small paper had no room for come back where it turns out too small for the letters as well.
    """
    trials, large, every = 1 if work.tight else _TRIALS, None, work
    while True:
        whole = _cut(work, paper, large, trials > 1)
        larger = paper is None and _is_large(whole.layout)
        if larger and large is None and (work.apart or whole.homeless):
            work, large = every, True
        elif whole.homeless:
            work = work.without(whole.homeless)
        elif trials > 1 and (out := whole.left_out):
            work, large, trials = replace(work.without(out), hopeless=whole.hopeless), larger, trials - 1
        else:
            return whole


def mechanism_step_sheets(
    method: Method,
    plot: Plot,
    *,
    paper: str | None = None,
    lang: Lang = "en",
    only: Plane | Collection[Plane] | None = None,
    tight: bool = False,
) -> Iterator[Sheet]:
    """One sheet a step, as `mechanism_sheet(.., upto=step)` gives them."""
    method, plot = shown(method, plot)
    drawing = Planes(method, plot, _planes(only), "construction", lang)
    yield from _staged(Composition(drawing, [] if tight else tables(method, plot, lang), tight), paper)


def _planes(only: Plane | Collection[Plane] | None) -> tuple[Plane, ...]:
    wanted = PLANES if only is None else (only,) if isinstance(only, str) else only
    return tuple(plane for plane in PLANES if plane in wanted)


def scales_of(method: Method, plot: Plot, lang: Lang) -> Mapping[Plane, float]:
    """The scales of the sheet."""
    work = Composition(Planes(method, plot, PLANES, "construction", lang), tables(method, plot, lang))
    return _whole(work, None).layout.scales


def _staged(work: Composition, paper: str | None, numbers: Sequence[int] = ()) -> Iterator[Sheet]:
    """The drawing as far as each act, or as some: the pencil's own lines are there too, and a sentence for results."""
    from graphkin.sheet.mechanism_sheet import Captions  # all the words of a solution

    found, drawing = _whole(work, paper), work.drawing
    layout, whole = found.layout, replace(found, stages=True).lettered.sheet
    others = {} if work.planes == PLANES else scales_of(drawing.method, drawing.plot, work.lang)
    captions = Captions.of(drawing.reading({**others, **layout.scales}), work.planes)
    strip = None if work.tight else layout.strip
    return (captions.sheet(whole, number, strip) for number in numbers or range(1, len(captions.acts) + 1))


# --- which paper, how divided -----------------------------------------------------------------


def _cut(work: Composition, paper: str | None, large: bool | None, trial: bool) -> Composed:
    """On the paper divided; cut to a single figure, where the paper was not asked for."""
    best = _divided(work, paper, large, trial)
    if len(work.planes) > 1 or not (work.tight or paper is None):
        return best
    return replace(best, layout=cut_to(best.layout, work.planes[0], work.extent(best.layout, work.planes[0])))


def _divided(work: Composition, paper: str | None, large: bool | None, trial: bool) -> Composed:
    """On the paper divided best: the smallest that holds all and leaves its letters room.

    large  whether a larger one was taken when this was tried before
    trial  equations may still be moved into the strip: not lettered where some must be
    """
    papers = LARGE if large else papers_for(paper)
    try:
        layout = work.layout(papers)
    except TooLargeForPaper as error:
        raise error.at(work.drawing.method.mechanism.where("scales", error.key)) from None
    small, best = paper is None and not _is_large(layout), Composed(work, layout, hopeless=work.hopeless)
    if trial and not best.full and (homeless := work.homeless(layout)):
        return replace(best, homeless=homeless)
    if best.crammed:
        return _divided(work, paper, True, trial) if small else replace(best, details=True, hopeless=True)
    best = work.roomier(best, papers)
    found = best.detailed
    if small and (found.near.lost or (found.near.crowded > _CROWDED and large is None)):
        larger = work.roomier(Composed(work, work.layout(LARGE)), LARGE).detailed
        eased = larger.near.crowded <= _EASED * found.near.crowded
        return larger if (larger.near.lost, not eased) < (found.near.lost, True) else found
    return found


def _is_large(layout: Layout) -> bool:
    """Whether its paper is a large one; one that is cut tight has no margin."""
    return layout.paper.name in [paper.name for paper in LARGE]


@frozen
class Captions:
    """What is told of each act, in a strip. acts: those that are drawn."""

    acts: Sequence[Act]
    texts: Mapping[Act, str]
    lang: Lang

    @classmethod
    def of(cls, reading: Reading, planes: Sequence[Plane]) -> Captions:
        entries = derivation(reading.method, reading.plot, reading.scales, reading.lang, as_planned=True)
        texts = {entry.act: entry.text for entry in entries if isinstance(entry, Sentence) and entry.act is not None}
        return cls([act for act in reading.method.acts if act.plane in planes], texts, reading.lang)

    def sheet(self, whole: Sheet, number: int, strip: Room | None) -> Sheet:
        """The drawing as far as one of the acts, counted from 1, with its sentence in the strip if there is one."""
        act, drawn = self.acts[number - 1], whole.upto(self.acts[number - 1].page)
        if strip is None:
            return drawn
        below, *others = drawn.layers
        marks = self._marks(act, number, strip, tables_room(whole.paper))
        return replace(drawn, layers=(replace(below, marks=(*below.marks, *marks)), *others))

    def _marks(self, act: Act, number: int, strip: Room, wide: float) -> Iterator[Mark]:
        head = say("sheet.step", self.lang, number=number, count=len(self.acts))
        at: Place = complex(strip.left + 3, strip.top + 6)
        yield Text(plain(head), at, BODY)
        sign = f"{circled(act.number)} " if act.numbered else ""
        for line in broken(sign + self.texts.get(act, ""), wide, BODY):
            at += 1j * LINE * BODY
            if at.imag < strip.bottom - 9:
                yield Text(formula(line), at, BODY)
