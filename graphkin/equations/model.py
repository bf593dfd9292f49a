"""The mechanism as the analytic methods see it: polygons in the order of solution, rolling, unknowns, drivers."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.analytic import Motion
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.equations.bodies import Bodies
from graphkin.equations.expressions import Sum
from graphkin.equations.legend import Legend, values
from graphkin.equations.polygons import ClosedPolygon, LinkVectorMaker, closed
from graphkin.equations.rolling import RollingSum, rolling
from graphkin.equations.symbols import AngleSum, Symbol
from graphkin.model.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.equivalent import Contact
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.structure import Hinge
from graphkin.proof.roads import proved

_SI: Mapping[str, str] = {"mm": "m", "mm rad": "m", "deg": "rad"}


@frozen
class Task:
    """One stage of the solution: polygons and rolling contacts with their unknowns.

    known  bodies solved before
    """

    polygons: tuple[ClosedPolygon, ...]
    rollings: tuple[RollingSum, ...]
    unknowns: tuple[Symbol, ...]
    known: frozenset[str]

    @property
    def equations(self) -> tuple[Sum, ...]:
        """What is zero: x and y parts of the polygons, then the angle relations."""
        sums = [_unknowns_first(polygon.sum, self.unknowns) for polygon in self.polygons]
        parts = [part for each in sums for part in (each.real, each.imag)]
        return (*parts, *(rolling.sum for rolling in self.rollings))


@frozen
class Model:
    """Everything the two methods write about.

    drivers  the symbol of each driver, in their order
    drawn    the analytic solution at the drawn position
    plot     the construction replayed there
    """

    method: Method
    ledger: Legend
    bodies: Bodies
    arrows: LinkVectorMaker
    tasks: tuple[Task, ...]
    drivers: tuple[Symbol, ...]
    drawn: Motion
    plot: Plot

    @property
    def alias(self) -> Mapping[Symbol, AngleSum]:
        return self.ledger.alias

    @property
    def unknowns(self) -> tuple[Symbol, ...]:
        return tuple(symbol for task in self.tasks for symbol in task.unknowns)

    @property
    def values(self) -> dict[Symbol, Value]:
        """All letters at the drawn position [SI]; nothing that is but rounding."""
        cut, entries = self.drawn.mechanism.usual.cut, self.ledger.entries
        return {symbol: cut(value, _SI.get(entries[symbol].unit, entries[symbol].unit))
                for symbol, value in values(self.ledger, self.drawn).items()}  # fmt: skip


def model_of(method: Method) -> Model:
    """Write the loops of a planned mechanism. Raises where the drawn position is a dead point, or the roads differ."""
    ledger, found = Legend(), proved(method)
    drawn = found.exact
    bodies = Bodies(method.structure, ledger, drawn)
    arrows = LinkVectorMaker(bodies, ledger)
    drivers = tuple(_driver(bodies, arrows, number) for number in range(len(method.drivers)))
    tasks = tuple(_tasks(method, arrows, drawn))
    return Model(method, ledger, bodies, arrows, tasks, drivers, drawn, found.plot)


def _driver(bodies: Bodies, arrows: LinkVectorMaker, number: int) -> Symbol:
    driver = bodies.structure.mechanism.drivers[number]
    return arrows.displacement(driver.link) if driver.kind == "slide" else bodies.drivers[number]


def _tasks(method: Method, arrows: LinkVectorMaker, drawn: Motion) -> list[Task]:
    known, found = {FRAME}, list[Task]()
    for stage in method.stages:
        task = _task(stage, arrows, frozenset(known), drawn)
        if task is not None:
            found.append(task)
        known.update(_bodies(stage))
    return found


def _bodies(stage: Stage) -> tuple[str, ...]:
    match stage:
        case Carry() | Bridge():
            return (stage.body,)
        case Loop() | Group():
            return stage.bodies
        case Mesh():
            return ()


def _task(stage: Stage, arrows: LinkVectorMaker, known: frozenset[str], drawn: Motion) -> Task | None:
    polygons: tuple[ClosedPolygon, ...] = ()
    contacts: tuple[Contact, ...] = ()
    match stage:
        case Loop():
            polygons = (closed(arrows, known, stage.bodies, stage.joints),)
        case Bridge():
            polygons = (closed(arrows, known, (stage.body,), [Hinge(point) for point in stage.points]),)
        case Mesh():
            contacts = (stage.contact,)
        case Group():
            polygons = tuple(closed(arrows, known, loop.bodies, loop.joints) for loop in stage.loops)
            contacts = stage.contacts
        case Carry():
            return None
    rollings = tuple(rolling(arrows, contact, drawn) for contact in contacts)
    return Task(polygons, rollings, _unknowns(stage, arrows), known)


def _unknowns(stage: Loop | Bridge | Mesh | Group, arrows: LinkVectorMaker) -> tuple[Symbol, ...]:
    """Displacements along moving guides, then angles, then displacements on the frame, as the book lists them."""
    angles: tuple[str, ...] = ()
    slides: tuple[str, ...] = ()
    match stage:
        case Bridge():
            angles = (stage.body,)
        case Mesh():
            angles, slides = tuple(filter(None, (stage.angle,))), tuple(filter(None, (stage.slide,)))
        case _:
            angles, slides = stage.angles, stage.slides
    guides = {name: arrows.structure.slides[name].guide for name in slides}
    moving = [arrows.displacement(name) for name, guide in guides.items() if guide != FRAME]
    fixed = [arrows.displacement(name) for name, guide in guides.items() if guide == FRAME]
    thetas = [base for body in angles if (base := arrows.bodies.base[body]) is not None]
    return (*moving, *dict.fromkeys(thetas), *fixed)


def _unknowns_first(of: Sum, unknowns: tuple[Symbol, ...]) -> Sum:
    """A polygon with its sign turned where all its unknown vectors are walked backward."""
    return -of if all(term.factor < 0 for term in of.having(*unknowns).terms) else of
