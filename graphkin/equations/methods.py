"""The two methods written out: polygon by polygon with complex vectors, and all polygons as one system of matrices."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from graphkin.base.geometry import dot
from graphkin.equations.document import EquationPage, listed
from graphkin.equations.dyads import Solver, Split, quotients
from graphkin.equations.expressions import Sum, Symbol, SymbolProduct
from graphkin.equations.formulas import Letter, Node, Op, Row, Word
from graphkin.equations.legend import LegendEntry
from graphkin.equations.matrices import column, derivatives, grid, matrices, rates_of
from graphkin.equations.model import Model, PointChain, Task, point_chains, point_symbols
from graphkin.equations.polygons import ClosedPolygon, RollingSum
from graphkin.equations.pretty import Pretty, bracketed
from graphkin.model.mechanism import FRAME
from graphkin.say.catalogue import meaning


def _corners(model: Model, polygon: ClosedPolygon) -> str:
    """The polygon's corners in their order: ABCDA."""
    sites = [site for arrow in polygon.walk for site in (arrow.tail, arrow.head)[:: arrow.sign]]
    names = [model.bodies.spot(point) for point, _ in sites]
    return "".join(name for k, name in enumerate(names) if k == 0 or name != names[k - 1])


def _complex_sides(pretty: Pretty, polygon: ClosedPolygon, of: Sum) -> tuple[Node, Node]:
    """A polygon's sum or its derivative, each term on the side of its arrow; the right one walked from the start."""
    terms: tuple[list[SymbolProduct], list[SymbolProduct]] = [], []
    for k, arrows in enumerate(polygon.sides):
        for arrow in arrows:
            own = {arrow.length, arrow.length.rate, arrow.length.rate and arrow.length.rate.rate}
            terms[k].extend(term for term in of.terms if any(symbol in own for symbol, _ in term.symbols))
    return pretty.sum(Sum(tuple(terms[0])), ordered=True), pretty.sum(-Sum(tuple(terms[1])), ordered=True)


def write_complex(model: Model, page: EquationPage) -> None:
    """Each polygon closed, split, derived twice, solved in closed form; then the points asked for."""
    pretty = Pretty(model.legend.alias)
    polygons = sum(len(task.polygons) for task in model.tasks)
    number, values = 0, model.values
    for task in model.tasks:
        for polygon in task.polygons:
            number += 1
            page.head("equations.polygon", number=number, names=_corners(model, polygon))
            if len(task.polygons) == 1 and not task.rollings:
                _solve(Solver(page, pretty, model.legend, values, str(number) if polygons > 1 else ""), task, polygon)
            else:
                _close(page, pretty, polygon)
        for rolling in task.rollings:
            page.head("equations.rolling", names=", ".join(model.bodies.called(w) for w in rolling.contact.wheels))
            arm = rolling.contact.arm
            _roll(page, pretty, rolling, model.bodies.called(arm) if arm not in ("", FRAME) else "")
        if not task.polygons and len(task.unknowns) == 1:
            rows, of = [], task.rollings[0].sum
            for order, equation in enumerate((of, of.rate, of.rate.rate)):
                unknown = task.unknowns[0].derivative(order)
                rows.append((Letter(unknown), pretty.quotient(-equation.lacking(unknown), equation.partial(unknown))))
            page.say("equations.hence")
            page.show(*rows)
        elif not task.polygons and len(task.unknowns) == len(task.rollings) == 2:
            _head_group(model, page, task)
            _solve_two_rolling(page, pretty, task)
        elif len(task.polygons) + len(task.rollings) > 1:
            _head_group(model, page, task)
            page.say("equations.newton", count=len(task.equations))
            matrices(model, page, pretty, task.equations, task.unknowns, numbers=False)
    for chain in point_chains(model):  # (3-18) to (3-20)
        page.head("equations.point", name=chain.of)
        page.say("equations.point from", start=model.bodies.spot(chain.start), name=chain.of)
        place, velocity, acceleration = (Letter(symbol) for symbol in point_symbols(model, chain))
        page.show((place, pretty.sum(chain.sum)))
        page.say_derived([chain.sum])
        for letter, sum_ in ((velocity, chain.sum.rate), (acceleration, chain.sum.rate.rate)):
            real, imaginary = (bracketed(pretty.grouped(part)) for part in (sum_.real, sum_.imag))
            page.show((letter, Row((real, Op("+"), Row((Word("i"), imaginary))))))


def _close(page: EquationPage, pretty: Pretty, polygon: ClosedPolygon) -> None:
    """The closure in complex form and in components."""
    page.say("equations.closure")
    page.show(_complex_sides(pretty, polygon, polygon.sum))
    page.say("equations.parts")
    page.show(*(_complex_sides(pretty, polygon, part) for part in (polygon.sum.real, polygon.sum.imag)))


def _solve(solver: Solver, task: Task, polygon: ClosedPolygon) -> None:
    """A dyad: position, velocity, acceleration."""
    page, pretty = solver.page, solver.pretty
    split = Split(polygon.sum, task.unknowns)
    page.say("equations.unknown", unknowns=listed(task.unknowns))
    page.head("equations.position", 3)
    _close(page, pretty, polygon)
    solver.write(split)
    derived = polygon.sum
    for order in (1, 2):
        page.head("equations.velocity" if order == 1 else "equations.acceleration", 3)
        derived = derived.rate
        if order == 1:
            page.say("equations.derived")
            if not any(arrow.length.moves for arrow in polygon.arrows):
                derived = derived * Sum((SymbolProduct(-1.0, turns=1),))  # over i
        else:
            page.say_derived([polygon.sum], again=True)
        page.show(_complex_sides(pretty, polygon, derived))
        page.say("equations.rates")
        page.show(*((Letter(rate), pretty.quotient(top, bottom)) for rate, top, bottom in quotients(split, order)))


def _roll(page: EquationPage, pretty: Pretty, rolling: RollingSum, carrier: str) -> None:
    """The angle relation and its derivatives, positive terms left, the rest right with their signs turned; `carrier`:
    the moving link from which it is seen."""
    moving = rolling.moving
    page.say("equations.rolling relation", which=int(bool(carrier)), carrier=carrier)
    page.show((pretty.sum(moving), Letter(rolling.constant)))
    page.say_derived([moving])
    rows = []
    for of in (moving.rate, moving.rate.rate):
        left = Sum(tuple(term for term in of.terms if term.factor > 0))
        rows.append((pretty.sum(left), pretty.sum(left - of)))
    page.show(*rows)


def _solve_two_rolling(page: EquationPage, pretty: Pretty, task: Task) -> None:
    """Two wheels that hang on each other: linear in their angles, and in the same way in their rates."""
    page.say("equations.linear", count=2)
    sums = [rolling.sum for rolling in task.rollings]
    for order in range(3):
        sums = [each.rate for each in sums] if order else sums
        first, second = (unknown.derivative(order) for unknown in task.unknowns)
        rows = []
        for unknown, other in ((first, second), (second, first)):
            eliminated = sums[0] * sums[1].partial(other) - sums[1] * sums[0].partial(other)
            top, bottom = -eliminated.lacking(unknown, other), eliminated.partial(unknown)
            rows.append((Letter(unknown), pretty.quotient(top, bottom)))
        page.show(*rows)


def _head_group(model: Model, page: EquationPage, task: Task) -> None:
    """The heading of a group that no dyad leads through."""
    bodies = [body for body, base in model.bodies.base.items() if base in task.unknowns]
    names = [model.bodies.called(body) for body in bodies if not model.method.structure.is_pin(body)]
    page.head("equations.group", names=", ".join(names))
    page.say("equations.unknown", unknowns=listed(task.unknowns))


def write_matrix(model: Model, page: EquationPage) -> None:
    """The polygons in complex form, their components with the unknowns left, the matrices, the points asked for."""
    pretty = Pretty(model.legend.alias)
    if model.unknowns:
        page.head("equations.position", 3)
        page.say("equations.unknown", unknowns=listed(model.unknowns))
        for number, polygon in enumerate((p for task in model.tasks for p in task.polygons), start=1):
            page.head("equations.polygon", 3, number=number, names=_corners(model, polygon))
            page.show(_complex_sides(pretty, polygon, polygon.sum))
        page.say("equations.all unknowns")
        equations = [each for task in model.tasks for each in task.equations]
        page.show(*(_unknown_left(pretty, each, model.unknowns) for each in equations))
        page.say("equations.derived")  # (3-22): unknown rates left
        rates = [rate for rate in derivatives(model.unknowns, 1) if rate is not None]
        page.show(*(_unknown_left(pretty, each.rate, rates) for each in equations))
        matrices(model, page, pretty, equations, model.unknowns)
    for chain in point_chains(model):
        page.head("equations.point", name=chain.of)
        page.say("equations.point from", start=model.bodies.spot(chain.start), name=chain.of)
        _write_components(model, page, pretty, chain)


def _unknown_left(pretty: Pretty, of: Sum, unknowns: Sequence[Symbol]) -> tuple[Node, Node]:
    left = of.having(*unknowns)
    return pretty.sum(left), pretty.sum(left - of)


def _write_components(model: Model, page: EquationPage, pretty: Pretty, chain: PointChain) -> None:
    """(3-25) to (3-27)."""
    whole = point_symbols(model, chain)
    letters: list[list[Symbol]] = []  # x_E, y_E; v_Ex, v_Ey; a_Ex, a_Ey
    for symbol, axis in zip(whole, ("", "v", "a"), strict=True):
        entry, pair = model.legend.entries[symbol], list[Symbol]()
        for name, turn in (("x", 1.0), ("y", -1j)):
            letter, low = (axis, f"{symbol.low}{name}") if axis else (name, symbol.low)
            pair.append(model.legend.fresh(letter, low + "'" * symbol.primes))
            text = meaning("equations.component", of=entry.meaning, axis=name)
            read = partial(lambda motion, entry, turn: dot(np.conj(turn), entry.read(motion)), entry=entry, turn=turn)
            model.legend.entries[pair[-1]] = LegendEntry(text, entry.unit, read)
        letters.append(pair)
    for symbol in whole:  # the vectors are written by their components here
        del model.legend.entries[symbol]
    parts, moving = (chain.sum.real, chain.sum.imag), chain.sum.moving
    page.show(*((Letter(letter), pretty.sum(part)) for letter, part in zip(letters[0], parts, strict=True)))
    slope = [[part.partial(symbol) for symbol in moving] for part in parts]
    matrix, first, second = grid(pretty, slope), column(derivatives(moving, 1)), column(derivatives(moving, 2))
    page.show((column(letters[1]), Row((matrix, first))))
    page.show((column(letters[2]), Row((matrix, second, Op("+"), grid(pretty, rates_of(slope)), first))))
