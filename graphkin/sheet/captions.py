"""The sentence that tells of one step, under its drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.planning.method import Act
from graphkin.say.catalogue import say
from graphkin.say.entry import Sentence
from graphkin.say.explained import derivation
from graphkin.say.numbers import circled
from graphkin.say.reading import Reading
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import plain
from graphkin.sheet.marks import Mark, Place, Text
from graphkin.sheet.page import Sheet
from graphkin.sheet.paper import BODY, Room
from graphkin.sheet.paragraphs import LINE, broken
from graphkin.sheet.titleblock import tables_room


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
