"""The strip at the foot of the sheet: results on the left, title, source and scales on the right, a check bar."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from itertools import accumulate

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism
from graphkin.sheet.equation_rows import EquationBlock, flowed, head_of, laid_out
from graphkin.sheet.lettering import Label, plain, width
from graphkin.sheet.marks import Mark, Place, Shows, Stroke, Text
from graphkin.sheet.paper import BODY, LEAST, TITLE, Paper, Room
from graphkin.sheet.paragraphs import Paragraphs
from graphkin.sheet.scales import written
from graphkin.sheet.table import Table, arranged, drawn_tables, height_of

_WIDE = 64.0
"""Width of the title block [mm]."""
_LEAST_HEIGHT = 33.0
_SHARE = 0.3
"""So much of a paper's height equations may take at most."""
_BAR = 9.0
"""Room for the check bar under the tables [mm]."""
_SENTENCE = 2.8
"""Letters of sentences [mm]."""
_CHECK: dict[Lang, str] = {"en": "100 mm when printed to scale", "zh": "按实际尺寸打印时为 100 mm"}


def strip_height(
    paper: Paper, found: Sequence[Table] = (), equations: Sequence[EquationBlock] = (), told: Sequence[str] = ()
) -> float:
    """What the strip needs on a paper [mm]."""
    lines = sum(head_of(line)[0].imag for line in _lines(equations, paper))
    words = _written(told, paper).height
    return max(_LEAST_HEIGHT, height_of(arranged([*found], tables_room(paper))) + words + lines + 1 + _BAR)


def _lines(equations: Sequence[EquationBlock], paper: Paper) -> list[list[EquationBlock]]:
    """Line by line the equations for which there is room; the others are in the written solution alone."""
    lines = flowed(equations, tables_room(paper))
    reach = accumulate(head_of(line)[0].imag for line in lines)
    return [line for line, end in zip(lines, reach, strict=True) if end <= _SHARE * paper.height]


def _written(told: Sequence[str], paper: Paper) -> Paragraphs:
    return Paragraphs.of(told, tables_room(paper), _SENTENCE)


def tables_room(paper: Paper) -> float:
    """Width that the strip leaves beside the title [mm]."""
    return paper.frame.size.real - _WIDE - 6


@frozen
class Strip:
    """What stands at the foot of a sheet beside title, source and scales.

    found  tables of results; notes: what stands beside a plane's scale; further: scales that no figure tells
    told   sentences under the tables
    equations  those that have no room over their polygons
    """

    room: Room
    found: Sequence[Table] = ()
    notes: Mapping[Plane, Label] = field(default_factory=dict)
    further: Mapping[Plane, float] = field(default_factory=dict)
    equations: Sequence[EquationBlock] = ()
    told: Sequence[str] = ()


def strip(asked: Strip, machine: Mechanism, paper: Paper, scales: Mapping[Plane, float], lang: Lang) -> list[Mark]:
    """The whole strip and the drawing frame."""
    room, edge = asked.room, asked.room.right - _WIDE
    marks: list[Mark] = [
        frame(paper),
        Stroke((complex(room.left, room.top), complex(room.right, room.top)), "outline"),
        Stroke((complex(edge, room.top), complex(edge, room.bottom)), "outline"),
    ]
    tiers, corner = arranged([*asked.found], tables_room(paper)), complex(room.left + 3, room.top + 1.5)
    marks += drawn_tables(tiers, corner)
    corner += 1j * height_of(tiers)
    words = _written(asked.told, paper)
    marks += words.marks(corner)
    corner += 1j * words.height
    for line in _lines(asked.equations, paper):
        marks += laid_out(line, corner, tables_room(paper))
        corner += 1j * head_of(line)[0].imag
    marks += _check_bar(complex(room.left + 3, room.bottom - 3.2), lang)
    block = Room(edge + 3, room.top, room.right - 3, room.bottom - 3)
    marks += _words(machine, block, {**scales, **asked.further}, asked.notes, lang)
    return marks


def frame(paper: Paper) -> Mark:
    """The drawing frame."""
    room = paper.frame
    low, high = complex(room.left, room.top), complex(room.right, room.bottom)
    return Stroke((low, complex(high.real, low.imag), high, complex(low.real, high.imag)), "visible", closed=True)


def _check_bar(at: Place, lang: Lang) -> list[Mark]:
    """A line of 100 mm to lay a ruler on."""
    marks: list[Mark] = [Stroke((at, at + 100), "thin", shows=Shows("", "ruler", plane="position"))]
    marks += [Stroke((at + x - 1j, at + x + 1j), "thin") for x in (0, 100)]
    marks += [Stroke((at + x - 0.5j, at + x), "hatch") for x in range(10, 100, 10)]
    marks.append(Text(plain(_CHECK[lang]), at + 2 - 1.3j, LEAST))
    return marks


def _words(
    machine: Mechanism, room: Room, scales: Mapping[Plane, float], notes: Mapping[Plane, Label], lang: Lang
) -> list[Mark]:
    """Title, source, scales, and what drew it; each line shrunk or broken to the block."""
    marks: list[Mark] = []
    pen = complex(room.left, room.top) + 1.2j
    title = machine.headline(lang)
    large = TITLE if width(plain(title), TITLE) <= _WIDE - 6 else 0.85 * TITLE
    for text, size in ((title, large), (machine.credit(lang), LEAST + 0.2)):
        for line in broken(text, size, _WIDE - 6):
            pen += 1j * (size * 1.25)
            marks.append(Text(plain(line), pen, size))
    pen += 1.2j
    for plane, scale in scales.items():
        pen += 1j * (BODY * 1.45)
        marks.append(Text(written(plane, scale), pen, BODY))
        if plane in notes:
            marks.append(Text(notes[plane], pen + width(written(plane, scale), BODY) + 2.5, LEAST))
    made: Label = plain("graphkin")
    marks.append(Text(made, complex(room.right - width(made, LEAST), room.bottom), LEAST))
    return marks


def broken(text: str, size: float, room: float) -> list[str]:
    """At most two lines that fit the room; what is longer ends in dots."""
    if width(plain(text), size) <= room:
        return [text] if text else []
    head = _fitting(text, size, room)
    rest = text[len(head) :].strip()
    if width(plain(rest), size) > room:
        rest = _fitting(rest, size, room - width(plain("..."), size)).rstrip() + "..."
    return [head.strip(), rest]


def _fitting(text: str, size: float, room: float) -> str:
    """The longest beginning that fits, to a space if there is one."""
    end = len(text)
    while end > 1 and width(plain(text[:end]), size) > room:
        end -= 1
    space = text.rfind(" ", 0, end + 1)
    return text[:end] if space < end // 2 else text[: space + 1]
