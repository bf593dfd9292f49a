"""What is given of the drivers: θ1, ω1, and α1, or α1 = 0 of one at constant speed, which is said where it is used."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from graphkin.equations.expressions import Sum
from graphkin.equations.layout import Letter, Node, Num, Op, Row
from graphkin.equations.page import EquationPage
from graphkin.equations.symbols import Symbol


def motion_of(driver: Symbol) -> list[Node]:
    """θ1, ω1, α1 = 0."""
    steady = _without_push(driver)
    moving = replace(driver, steady=False)
    assert moving.rate is not None
    push = moving.rate.rate
    assert push is not None
    last = Letter(push) if steady is None else nothing(steady)
    return [Letter(driver), Letter(moving.rate), last]


def say_derived(page: EquationPage, sums: Iterable[Sum], again: bool = False) -> None:
    """The sentence before a second derivative, with what is zero in it: `.., with α1 = 0`."""
    found = dict.fromkeys(push for of in sums for symbol in of.moving if (push := _without_push(symbol)) is not None)
    if found:
        zero = listed([nothing(push) for push in found])
        page.say("equations.derived again steady" if again else "equations.derived steady", zero=zero)
    else:
        page.say("equations.derived again" if again else "equations.derived")


def nothing(symbol: Symbol) -> Node:
    return Row((Letter(symbol), Op("="), Num("0")))


def listed(items: Sequence[Symbol | Node]) -> Node:
    """θ2, θ3."""
    found: list[Node] = []
    for k, item in enumerate(items):
        node = Letter(item) if isinstance(item, Symbol) else item
        found += [Op(","), node] if k else [node]
    return Row(tuple(found))


def _without_push(symbol: Symbol) -> Symbol | None:
    """α1 of a driver at constant speed; None of what may speed up."""
    rate = symbol if symbol.kind == "rate" else symbol.rate
    return replace(rate, steady=False).rate if rate is not None and rate.kind == "rate" and rate.steady else None
