"""The method of complex vectors written out: each polygon closed, split, derived twice, and solved in closed form."""

from __future__ import annotations

from collections.abc import Sequence

from graphkin.equations.chains import asked_points, chain, vectors
from graphkin.equations.driven import listed, say_derived
from graphkin.equations.dyads import Split
from graphkin.equations.expressions import Sum, SymbolProduct
from graphkin.equations.layout import Letter, Node, Op, Row, Word
from graphkin.equations.matrices import matrices
from graphkin.equations.model import Model, Task
from graphkin.equations.page import EquationPage
from graphkin.equations.polygons import ClosedPolygon
from graphkin.equations.positions import Solver
from graphkin.equations.pretty import Pretty, bracketed
from graphkin.equations.rates import quotients
from graphkin.equations.symbols import Symbol


def write_complex(model: Model, page: EquationPage) -> None:
    """All polygons in the order of solution, then the points asked for."""
    pretty = Pretty(model.alias)
    polygons = sum(len(task.polygons) for task in model.tasks)
    number, values = 0, model.values
    for task in model.tasks:
        for polygon in task.polygons:
            number += 1
            page.head("equations.polygon", number=number, names=ring(model, polygon))
            if len(task.polygons) == 1 and not task.rollings:
                solver = Solver(page, pretty, model.ledger, values, str(number) if polygons > 1 else "")
                _solved(solver, task, polygon)
            else:
                _closed(page, pretty, polygon)
        for rolling in task.rollings:
            page.head("equations.rolling", names=", ".join(model.bodies.called(w) for w in rolling.contact.wheels))
            _rolled(page, pretty, rolling.moving, Letter(rolling.constant))
        if not task.polygons and len(task.unknowns) == 1:
            _one_rolled(page, pretty, task)
        elif not task.polygons and len(task.unknowns) == len(task.rollings) == 2:
            _two_rolled(model, page, pretty, task)
        elif len(task.polygons) + len(task.rollings) > 1:
            _together(model, page, pretty, task)
    _points(model, page, pretty)


def ring(model: Model, polygon: ClosedPolygon) -> str:
    """The polygon's corners in their order: ABCDA."""
    ways = [(arrow.tail, arrow.head)[:: arrow.sign] for arrow in polygon.walk]
    sites = [site for way in ways for site in way]
    names = [model.bodies.spot(point) for point, _ in sites]
    return "".join(name for k, name in enumerate(names) if k == 0 or name != names[k - 1])


def sides(pretty: Pretty, of: Sum) -> tuple[Node, Node]:
    """What is zero, as an equation: positive terms left, the rest right with their signs turned."""
    left = Sum(tuple(term for term in of.terms if term.factor > 0))
    right = -Sum(tuple(term for term in of.terms if term.factor < 0))
    return pretty.sum(left), pretty.sum(right)


def complex_sides(pretty: Pretty, polygon: ClosedPolygon, of: Sum) -> tuple[Node, Node]:
    """A polygon's sum or its derivative, each term on the side of its arrow; the right one walked from the start."""
    found: tuple[list[SymbolProduct], list[SymbolProduct]] = [], []
    for k, arrows in enumerate(polygon.sides):
        for arrow in arrows:
            mine = {arrow.length, arrow.length.rate, arrow.length.rate and arrow.length.rate.rate}
            found[k].extend(term for term in of.terms if any(symbol in mine for symbol, _ in term.symbols))
    return pretty.sum(Sum(tuple(found[0])), ordered=True), pretty.sum(-Sum(tuple(found[1])), ordered=True)


def _closed(page: EquationPage, pretty: Pretty, polygon: ClosedPolygon) -> None:
    """The closure in complex form and in components, then its derivatives."""
    page.say("equations.closure")
    page.show(complex_sides(pretty, polygon, polygon.sum))
    page.say("equations.parts")
    page.show(*(complex_sides(pretty, polygon, part) for part in (polygon.sum.real, polygon.sum.imag)))


def _derived(page: EquationPage, pretty: Pretty, polygon: ClosedPolygon, order: int) -> None:
    derived = polygon.sum.rate
    if not any(arrow.length.moves for arrow in polygon.arrows):
        derived = derived.over_i
    derived = derived if order == 1 else derived.rate
    if order == 1:
        page.say("equations.derived")
    else:
        say_derived(page, [polygon.sum], again=True)
    page.show(complex_sides(pretty, polygon, derived))


def _solved(solver: Solver, task: Task, polygon: ClosedPolygon) -> None:
    """A dyad: position, velocity, acceleration."""
    page, pretty = solver.page, solver.pretty
    split = Split(polygon.sum, task.unknowns)
    page.say("equations.unknown", unknowns=listed(task.unknowns))
    page.head("equations.position", 3)
    _closed(page, pretty, polygon)
    solver.write(split)
    for order in (1, 2):
        page.head("equations.velocity" if order == 1 else "equations.acceleration", 3)
        _derived(page, pretty, polygon, order)
        page.say("equations.rates")
        found = quotients(split, order)
        page.show(*((Letter(each.symbol), pretty.quotient(each.top, each.bottom)) for each in found))


def _rolled(page: EquationPage, pretty: Pretty, moving: Sum, constant: Node) -> None:
    """The angle relation and its derivatives."""
    page.say("equations.rolling relation")
    page.show((pretty.sum(moving), constant))
    say_derived(page, [moving])
    page.show(sides(pretty, moving.rate), sides(pretty, moving.rate.rate))


def _one_rolled(page: EquationPage, pretty: Pretty, task: Task) -> None:
    """The last unknown of a rolling contact."""
    symbol, moving = task.unknowns[0], task.rollings[0].sum
    rows = []
    wanted: Symbol | None = symbol
    for of in (moving, moving.rate, moving.rate.rate):
        assert wanted is not None
        bottom = of.partial(wanted)
        rest = Sum(tuple(term for term in of.terms if not term.has(wanted)))
        rows.append((Letter(wanted), pretty.quotient(-rest, bottom)))
        wanted = wanted.rate if wanted.kind != "push" else None
    page.say("equations.hence")
    page.show(*rows)


def _two_rolled(model: Model, page: EquationPage, pretty: Pretty, task: Task) -> None:
    """Two wheels that hang on each other: linear in their angles, and in the same way in their rates."""
    page.head("equations.group", names=", ".join(model.bodies.called(body) for body in _group_bodies(model, task)))
    page.say("equations.unknown", unknowns=listed(task.unknowns))
    page.say("equations.linear", count=2)
    unknowns, sums = list(task.unknowns), [rolling.sum for rolling in task.rollings]
    for order in range(3):
        if order:
            unknowns, sums = [_rate(each) for each in unknowns], [each.rate for each in sums]
        one, other = unknowns
        found = [_eliminated(sums, wanted, away) for wanted, away in ((one, other), (other, one))]
        names = (Letter(one), Letter(other))
        page.show(*((name, pretty.quotient(*parts)) for name, parts in zip(names, found, strict=True)))

def _rate(of: Symbol) -> Symbol:
    assert of.rate is not None
    return of.rate


def _eliminated(sums: Sequence[Sum], wanted: Symbol, away: Symbol) -> tuple[Sum, Sum]:
    """The unknown wanted as a quotient: the first sum times the other unknown's factor in the second, less the same
    the other way round."""
    factors = [each.partial(away) for each in sums]
    whole = sums[0] * factors[1] - sums[1] * factors[0]
    rest = Sum(tuple(term for term in whole.terms if not term.has(wanted) and not term.has(away)))
    return -rest, whole.partial(wanted)


def _together(model: Model, page: EquationPage, pretty: Pretty, task: Task) -> None:
    """A group that no dyad leads through."""
    names = [model.bodies.called(body) for body in _group_bodies(model, task)]
    page.head("equations.group", names=", ".join(names))
    page.say("equations.unknown", unknowns=listed(task.unknowns))
    page.say("equations.newton", count=len(task.equations))
    matrices(model, page, pretty, task.equations, task.unknowns, numbers=False)


def _group_bodies(model: Model, task: Task) -> list[str]:
    bases = [body for body, base in model.bodies.base.items() if base in task.unknowns]
    return [body for body in bases if not model.method.structure.is_pin(body)]


def _points(model: Model, page: EquationPage, pretty: Pretty) -> None:
    """(3-18) to (3-20) for every point asked for."""
    points = asked_points(model)
    for number, point in enumerate(points, start=1):
        found = chain(model, point, "" if len(points) == 1 else str(number))
        page.head("equations.point", name=point)
        page.say("equations.point from", start=model.bodies.spot(found.start), name=point)
        place, velocity, acceleration = (Letter(symbol) for symbol in vectors(model, found))
        page.show((place, pretty.sum(found.sum)))
        say_derived(page, [found.sum])
        page.show((velocity, _whole(pretty, found.sum.rate)))
        page.show((acceleration, _whole(pretty, found.sum.rate.rate)))


def _whole(pretty: Pretty, of: Sum) -> Node:
    """Real part + i imaginary part."""
    return Row((bracketed(pretty.grouped(of.real)), Op("+"), Row((Word("i"), bracketed(pretty.grouped(of.imag))))))
