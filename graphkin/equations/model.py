"""The mechanism as the analytic methods see it: polygons in the order of solution, unknowns, points asked for."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping
from dataclasses import replace

from graphkin.analytic import Motion
from graphkin.base.geometry import Value
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.equations.bodies import Bodies, quarters
from graphkin.equations.expressions import AngleSum, Sum, Symbol, Wave, one, phasor
from graphkin.equations.legend import Legend, LegendEntry, point_place, values
from graphkin.equations.polygons import ClosedPolygon, LinkVectorMaker, RollingSum, closed, rolling, shortest_path
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import parts
from graphkin.planning import Method
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh, Stage
from graphkin.planning.structure import Hinge, Sliding
from graphkin.proof.roads import proved
from graphkin.say.catalogue import meaning

_SI: Mapping[str, str] = {"mm": "m", "mm rad": "m", "deg": "rad"}


@frozen
class Task:
    """One stage of the solution: polygons and rolling contacts with their unknowns."""

    polygons: tuple[ClosedPolygon, ...]
    rollings: tuple[RollingSum, ...]
    unknowns: tuple[Symbol, ...]

    @property
    def equations(self) -> tuple[Sum, ...]:
        """Sums that are zero: x and y parts of the polygons, then the angle relations."""
        sums = [polygon.sum for polygon in self.polygons]
        sums = [  # turned where all the unknown vectors are walked backward
            -of if all(term.factor < 0 for term in of.having(*self.unknowns).terms) else of for of in sums
        ]
        return (*(part for each in sums for part in (each.real, each.imag)), *(each.sum for each in self.rollings))


@frozen
class Model:
    """Everything the two methods write about.

    drivers  the symbol of each driver, in their order
    motion   the analytic solution at the drawn position
    plot     the construction replayed there
    """

    method: Method
    legend: Legend
    bodies: Bodies
    arrows: LinkVectorMaker
    tasks: tuple[Task, ...]
    drivers: tuple[Symbol, ...]
    motion: Motion
    plot: Plot

    @property
    def unknowns(self) -> tuple[Symbol, ...]:
        return tuple(symbol for task in self.tasks for symbol in task.unknowns)

    @property
    def values(self) -> dict[Symbol, Value]:
        """All letters at the drawn position [SI]; 0 for what is only rounding."""
        cut, entries = self.motion.mechanism.usual.cut, self.legend.entries
        return {symbol: cut(value, _SI.get(entries[symbol].unit, entries[symbol].unit))
                for symbol, value in values(self.legend, self.motion).items()}  # fmt: skip


def model_of(method: Method) -> Model:
    """Write the loops of a planned mechanism. Raises where the drawn position is a dead point, or the roads differ."""
    legend, roads = Legend(), proved(method)
    bodies = Bodies(method.structure, legend, roads.exact)
    arrows = LinkVectorMaker(bodies, legend)
    drivers = tuple(
        arrows.displacement(driver.link) if driver.kind == "slide" else bodies.drivers[number]
        for number, driver in enumerate(method.drivers)
    )
    known, tasks = {FRAME}, list[Task]()
    for stage in method.stages:
        if (task := _task(stage, arrows, frozenset(known), roads.exact)) is not None:
            tasks.append(task)
        if not isinstance(stage, Mesh):
            known.update((stage.body,) if isinstance(stage, Carry | Bridge) else stage.bodies)
    return Model(method, legend, bodies, arrows, tuple(tasks), drivers, roads.exact, roads.plot)


def _task(stage: Stage, arrows: LinkVectorMaker, known: frozenset[str], motion: Motion) -> Task | None:
    """A stage; its unknowns as the book lists them: displacements along moving guides, angles, those on the frame."""
    polygons: tuple[ClosedPolygon, ...] = ()
    rollings: tuple[RollingSum, ...] = ()
    angles: tuple[str, ...]
    slides: tuple[str, ...] = ()
    match stage:
        case Loop():
            polygons = (closed(arrows, known, stage.bodies, stage.joints),)
            angles, slides = stage.angles, stage.slides
        case Bridge():
            polygons = (closed(arrows, known, (stage.body,), [Hinge(point) for point in stage.points]),)
            angles = (stage.body,)
        case Mesh():
            rollings = (rolling(arrows, stage.contact, motion),)
            angles, slides = tuple(filter(None, (stage.angle,))), tuple(filter(None, (stage.slide,)))
        case Group():
            polygons = tuple(closed(arrows, known, loop.bodies, loop.joints) for loop in stage.loops)
            rollings = tuple(rolling(arrows, contact, motion) for contact in stage.contacts)
            angles, slides = stage.angles, stage.slides
        case Carry():
            return None
    guides = {name: arrows.structure.slides[name].guide for name in slides}
    moving = [arrows.displacement(name) for name, guide in guides.items() if guide != FRAME]
    fixed = [arrows.displacement(name) for name, guide in guides.items() if guide == FRAME]
    thetas = [base for body in angles if (base := arrows.bodies.base[body]) is not None]
    return Task(polygons, rollings, (*moving, *dict.fromkeys(thetas), *fixed))


@frozen
class PointChain:
    """The vector from the fixed point `start` to the point `of`, as in (3-18):
    l1 e^(iθ1) + a e^(iθ2) + b e^(i(θ2 + 90°))."""

    start: str
    of: str
    sum: Sum


def point_chains(model: Model) -> Iterator[PointChain]:
    """The chains to the moving points whose velocity or acceleration the problem asks for, in its order."""
    mechanism, names = model.method.mechanism, dict[str, None]()
    for question in mechanism.ask:
        for quantity in parts(mechanism, question):
            if quantity.word in ("v", "a"):
                names |= dict.fromkeys(site.point for site in quantity.sites if not site.explicit)
    points = [point for point in names if FRAME not in mechanism.owners[point]]
    yield from (_chain(model, point, "" if len(points) == 1 else str(k)) for k, point in enumerate(points, start=1))


def _chain(model: Model, point: str, low: str) -> PointChain:
    """The shortest path from the frame to a point; `low` is the subscript of its a and b."""
    structure, arrows = model.method.structure, model.arrows
    owners = [body for body in structure.owners[point] if not structure.is_pin(body)]
    bodies, joints = shortest_path(structure, structure.bodies, owners, (FRAME,))
    total = Sum()
    for k in range(len(joints) - 1, -1, -1):
        joint, inner = joints[k], bodies[k]
        if isinstance(joint, Sliding):
            slid = arrows.sliding(joint.slide).sum
            total += -slid if structure.slides[joint.slide].guide == inner else slid
        goal = point if k == 0 else arrows.point_of(joints[k - 1], inner)
        total += _arm(model, inner, arrows.point_of(joint, inner), goal, low)
    # links' own angles where these follow from several others: θ3 turns at ω3, not at ω1 + ω21 + ω32
    names = model.legend.alias.items()
    own = {angle.parts: (symbol, angle.quarters) for symbol, angle in names if len(angle.moving) > 1}

    def renamed(wave: Wave) -> Wave:
        if (name := own.get(wave.angle.parts)) is None:
            return wave
        return replace(wave, angle=AngleSum.of(name[0], (wave.angle.quarters - name[1]) % 4))

    by_links = Sum.of(replace(term, waves=tuple(map(renamed, term.waves))) for term in total.terms)
    return PointChain(arrows.point_of(joints[-1], FRAME), point, by_links)


def _arm(model: Model, body: str, start: str, end: str, low: str) -> Sum:
    """The vector between two points of a body: a known link vector, or a along the link and b across it."""
    arrows, shape = model.arrows, model.method.structure.shapes[body]
    arm = shape[end] - shape[start]
    if start == end or (body, frozenset((start, end))) in arrows.arms or quarters(cmath.phase(arm)) is not None:
        return Sum.of(term for arrow in arrows.along(body, start, end) for term in arrow.sum.terms)
    words, theta = {"ends": start + end, "link": model.bodies.called(body)}, model.bodies.angles[body]
    a = model.legend.constant("a", low, meaning("equations.part along", **words), "mm", arm.real)
    b = model.legend.constant("b", low, meaning("equations.part across", **words), "mm", arm.imag)
    return phasor(one(a), theta) + phasor(one(b), theta.turned(1))


def point_symbols(model: Model, of: PointChain) -> list[Symbol]:
    """Letters for the point's position from the chain's start, its velocity, its acceleration: complex numbers."""

    def position(motion: Motion) -> Value:
        return motion.position[of.of] - point_place(model.method.structure, of.start, FRAME, motion)

    start = model.bodies.spot(of.start)
    texts = [meaning(f"equations.point {rate}", point=of.of) for rate in ("velocity", "acceleration")]
    entries = {
        "l": LegendEntry(meaning("equations.point position", start=start, point=of.of), "mm", position),
        "v": LegendEntry(texts[0], "m/s", lambda motion: motion.velocity[of.of]),
        "a": LegendEntry(texts[1], "m/s^2", lambda motion: motion.acceleration[of.of]),
    }
    symbols = []
    for letter, entry in entries.items():
        symbols.append(model.legend.fresh(letter, of.of))
        model.legend.entries[symbols[-1]] = entry
    return symbols
