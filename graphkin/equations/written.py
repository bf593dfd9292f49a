"""From a planned mechanism to the document: the drivers, the equations, the legend."""

from __future__ import annotations

from functools import partial
from math import remainder
from typing import TYPE_CHECKING

import numpy as np

from graphkin.base.geometry import Value, place
from graphkin.equations.document import Block, By, Document, DocumentTable, EquationPage, FigureNode, listed, motion_of
from graphkin.equations.expressions import Symbol
from graphkin.equations.formulas import Call, Exp, Letter, Op, Row, Word
from graphkin.equations.legend import LegendEntry
from graphkin.equations.methods import write_complex, write_matrix
from graphkin.equations.model import Model, model_of
from graphkin.equations.polygons import turning_part
from graphkin.equations.pretty import Pretty
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import EDGE, Unit
from graphkin.model.units import significant
from graphkin.planning import Method
from graphkin.say.catalogue import say

if TYPE_CHECKING:
    from graphkin.sheet import Sheet

_THETA, _I = Letter(Symbol("θ", kind="angle")), Word("i")
_EULER = Row((Exp(Row((_I, _THETA))), Op("="), Call("cos", (_THETA,)), Op("+"), _I, Call("sin", (_THETA,))))
"""e^(iθ) = cos θ + i sin θ."""


def document(method: Method, by: By = "complex", lang: Lang = "en") -> Document:
    """The equations of a planned mechanism by one of the two methods. Raises a GraphkinError where the drawn position
    is a dead point: velocities are not determined there."""
    return written(model_of(method), by, lang)


def written(model: Model, by: By, lang: Lang) -> Document:
    """The document, filling the model's legend."""
    page = EquationPage(lang)
    page.say("equations.every vector", euler=_EULER)
    page.blocks.append(FigureNode(partial(_figure, model, lang)))
    _write_drivers(model, page)
    before = len(page.blocks)
    if not model.tasks:
        page.say("equations.no loop")
    (write_complex if by == "complex" else write_matrix)(model, page)
    page.blocks[before:before] = _auxiliary(model, lang)
    page.head("equations.legend")
    values = model.values
    rows = [(Letter(symbol), entry.meaning.spoken(lang), _value(entry, values[symbol]))
            for symbol, entry in model.legend.entries.items()]  # fmt: skip
    heads = tuple(say(f"equations.{head}", lang) for head in ("symbol", "meaning", "value"))
    page.blocks.append(DocumentTable(heads, tuple(rows)))
    mechanism = model.method.mechanism
    title = f"{mechanism.headline(lang)}{say('common.colon', lang)}{say(f'equations.method {by}', lang)}"
    return Document(title, tuple(page.blocks), lang, mechanism.name)


def _figure(model: Model, lang: Lang) -> Sheet:
    from graphkin.equations.figure import figure

    return figure(model, say("equations.figure", lang), lang)


def _write_drivers(model: Model, page: EquationPage) -> None:
    """The drivers, and the angles that follow others at once, with ω and α of links whose angle is a sum."""
    if model.drivers:
        motions = listed([node for driver in model.drivers for node in motion_of(driver)])
        page.say("equations.drivers", len(model.drivers) > 1, drivers=motions)
    if model.legend.alias:
        pretty = Pretty({})
        page.say("equations.fixed angles")
        page.show(*((Letter(name), pretty.angle(angle)) for name, angle in model.legend.alias.items()))
        page.say("equations.same rates")
        rates = {name: turning_part(angle).rate for name, angle in model.legend.alias.items()}
        velocities = [(Letter(name.derivative(1)), pretty.sum(rate)) for name, rate in rates.items()]
        accelerations = [(Letter(name.derivative(2)), pretty.sum(rate.rate)) for name, rate in rates.items()]
        page.show(*velocities, *accelerations)


def _auxiliary(model: Model, lang: Lang) -> list[Block]:
    """The points that have a letter in the equations only: where a line that the file gives by coordinates begins."""
    page, bodies, structure = EquationPage(lang), model.bodies, model.method.structure
    for letter, (point, body) in bodies.spots.items():
        if body == FRAME:
            at = structure.shapes[FRAME][point]
            x, y = (_digits(1e3 * part) for part in (at.real, at.imag))
            page.say("equations.auxiliary fixed", letter=letter, x=x, y=y)
        else:
            of = next(slide.point for slide in structure.slides.values() if slide.line.origin == point)
            page.say("equations.auxiliary", letter=letter, link=bodies.called(body), point=of)
    return page.blocks


_SHOWN = {unit.name: unit for unit in (*EDGE.values(), Unit("mm rad", "mm·rad", EDGE["m"].factor), Unit("1", ""))}
"""The legend's units as they are shown, by their names; `mm rad` is what a wheel's radius makes of an angle."""


def _value(entry: LegendEntry, value: Value) -> str:
    """In the unit of the legend; an angle that came as a sum or a difference without its whole turns."""
    shown = _SHOWN[entry.unit]
    real, imag = shown.factor * place(value).real, shown.factor * place(value).imag
    if np.iscomplexobj(value):
        return f"{_digits(real)} {'−' if imag < 0 else '+'} {_digits(abs(imag))} i{shown.after}"
    if entry.unit == "deg" and not -180 <= real < 360:
        real = remainder(real, 360)
    return _digits(real) + shown.after


def _digits(value: float) -> str:
    return significant(value, 6).replace("-", "−")
