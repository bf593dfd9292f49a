"""What a problem gives and asks, as tables of a sheet that shows nothing else."""

from __future__ import annotations

from typing import assert_never

from graphkin.model.quantities import (
    Centre,
    Component,
    Displacement,
    Moving,
    Place,
    Quantity,
    Quotient,
    Rotation,
    Track,
)
from graphkin.model.quantities.reading import read
from graphkin.say.catalogue import say
from graphkin.say.dimensions import dimensions
from graphkin.say.reading import Reading
from graphkin.sheet.formula import formula
from graphkin.sheet.lettering import Label, joined, plain, quantity_label
from graphkin.sheet.table import SIZE, Table
from graphkin.sheet.written_lines import WrittenLines

_WIDE = 62.0
"""Lines of what is given are no longer [mm]."""


def given_tables(reading: Reading) -> list[Table]:
    """Dimensions and driven rates; what is asked for. Empty ones left out."""
    given = WrittenLines.of([formula(text) for text in dimensions(reading)], _WIDE, SIZE).lines
    asked = WrittenLines.of([_asked(reading, text) for text in reading.mechanism.ask], _WIDE, SIZE).lines
    found = ((say("sheet.given", reading.lang), given), (say("sheet.find", reading.lang), asked))
    return [Table((plain(head),), tuple((line,) for line in lines)) for head, lines in found if lines]


def _asked(reading: Reading, text: str) -> Label:
    """A question as the field writes it; what is no quantity, as the file does."""
    quantity = read(reading.mechanism, text)
    return plain(text) if quantity is None else label_of(quantity)


def label_of(quantity: Quantity, over: str = " / ") -> Label:
    """A quantity as the field writes it: `theta 3` as θ₃, `a_k B3B2` as a with k above B3B2."""
    match quantity:
        case Quotient():
            return joined([label_of(half) for half in quantity.halves], over)
        case Rotation() | Displacement() | Place() | Track() | Moving() | Component():
            return quantity_label(quantity.letter, quantity.of.replace(",", ", ").replace("@", " "), quantity.part)
        case Centre():
            return quantity_label("P", quantity.text.removeprefix("P"))
        case _:
            assert_never(quantity)
