"""From a planned mechanism to the document: what is given, the equations, the legend."""

from __future__ import annotations

from functools import partial
from math import remainder

import numpy as np

from graphkin.base.geometry import Value
from graphkin.equations.complex_method import write_complex
from graphkin.equations.document import Block, By, Document, FigureNode
from graphkin.equations.driven import listed, motion_of
from graphkin.equations.expressions import Sum, SymbolProduct
from graphkin.equations.figure import figure
from graphkin.equations.layout import Call, Exp, Letter, Node, Op, Row, Word
from graphkin.equations.legend import LegendEntry
from graphkin.equations.matrix_method import write_matrix
from graphkin.equations.model import Model, model_of
from graphkin.equations.page import EquationPage
from graphkin.equations.pretty import Pretty
from graphkin.equations.symbols import AngleSum, Symbol
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import EDGE, Unit
from graphkin.model.units import significant
from graphkin.planning import Method
from graphkin.say.catalogue import say


def document(method: Method, by: By = "complex", lang: Lang = "en") -> Document:
    """The equations of a planned mechanism by one of the two methods.

    Raises a GraphkinError where the drawn position is a dead point: velocities are not determined there.
    """
    return written(model_of(method), by, lang)


def written(model: Model, by: By, lang: Lang) -> Document:
    """The document, filling the model's legend."""
    page = EquationPage(lang)
    page.say("equations.every vector", euler=_euler())
    page.add(FigureNode(partial(figure, model, say("equations.figure", lang), lang)))
    _given(model, page)
    before = len(page.blocks)
    if not model.tasks:
        page.say("equations.no loop")
    (write_complex if by == "complex" else write_matrix)(model, page)
    page.blocks[before:before] = _auxiliary(model, lang)
    page.head("equations.legend")
    page.table((say(f"equations.{head}", lang) for head in ("symbol", "meaning", "value")), _legend(model, lang))
    mechanism = model.method.mechanism
    title = f"{mechanism.headline(lang)}{say('common.colon', lang)}{say(f'equations.method {by}', lang)}"
    return Document(title, tuple(page.blocks), by, lang, mechanism.name)


def _euler() -> Node:
    """e^(iθ) = cos θ + i sin θ."""
    theta, turn = Letter(Symbol("θ", kind="angle")), Word("i")
    return Row((Exp(Row((turn, theta))), Op("="), Call("cos", (theta,)), Op("+"), turn, Call("sin", (theta,))))


def _given(model: Model, page: EquationPage) -> None:
    """The drivers, and the angles that follow others at once."""
    if model.drivers:
        page.say("equations.driver" if len(model.drivers) == 1 else "equations.drivers", drivers=_motions(model))
    if model.alias:
        pretty = Pretty({})
        page.say("equations.fixed angles")
        page.show(*((Letter(name), pretty.angle(angle)) for name, angle in model.alias.items()))
        page.say("equations.same rates")
        rates = [_rates(name, angle) for name, angle in model.alias.items()]
        page.show(*((Letter(name), pretty.sum(of)) for order in zip(*rates) for name, of in order))


def _motions(model: Model) -> Node:
    """θ1, ω1, α1 = 0: what is given of every driver."""
    return listed([node for driver in model.drivers for node in motion_of(driver)])


def _auxiliary(model: Model, lang: Lang) -> list[Block]:
    """The points that have a letter in the equations only: where a line that the file gives by coordinates begins."""
    page, bodies, shapes = EquationPage(lang), model.bodies, model.method.structure.shapes
    for letter, (point, body) in bodies.spots.items():
        if body == FRAME:
            place = shapes[FRAME][point]
            x, y = (_digits(1e3 * part) for part in (place.real, place.imag))
            page.say("equations.auxiliary fixed", letter=letter, x=x, y=y)
        else:
            slides = model.method.structure.slides.values()
            of = next(slide.point for slide in slides if slide.line.origin == point)
            page.say("equations.auxiliary", letter=letter, link=bodies.called(body), point=of)
    return page.blocks


def _rates(name: Symbol, angle: AngleSum) -> list[tuple[Symbol, Sum]]:
    """ω and α of a link whose angle is a sum."""
    turning = Sum.of(SymbolProduct(float(count), ((symbol, 1),)) for symbol, count in angle.moving)
    assert name.rate is not None
    assert name.rate.rate is not None
    return [(name.rate, turning.rate), (name.rate.rate, turning.rate.rate)]


def _legend(model: Model, lang: Lang) -> list[tuple[str | Node, ...]]:
    """Every letter, what it is, and its value at the drawn position."""
    values = model.values
    return [(Letter(symbol), entry.meaning.spoken(lang), _value(entry, values[symbol]))
            for symbol, entry in model.ledger.entries.items()]  # fmt: skip


_SHOWN = {unit.name: unit for unit in (*EDGE.values(), Unit("mm rad", "mm·rad", EDGE["m"].factor), Unit("1", ""))}
"""How the legend's units are shown, by their names; `mm rad` is what a wheel's radius makes of an angle."""


def _value(entry: LegendEntry, value: Value) -> str:
    """In the unit of the legend; an angle that came as a sum or a difference without its whole turns."""
    shown = _SHOWN[entry.unit]
    real, imag = (shown.factor * float(part) for part in (np.real(value), np.imag(value)))
    if np.iscomplexobj(value):
        return f"{_digits(real)} {'−' if imag < 0 else '+'} {_digits(abs(imag))} i{shown.after}"
    if entry.unit == "deg" and not -180 <= real < 360:
        real = remainder(real, 360)
    return _digits(real) + shown.after


def _digits(value: float) -> str:
    return significant(value, 6).replace("-", "−")
