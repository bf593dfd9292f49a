"""The first step of a student's drawing that leaves the right way, by replaying the steps against the construction.

On the mechanism's own paper each lettered point is held against where it belongs. In a polygon each point of the
mechanism is held against what follows from the student's own points before it. Where one lies
elsewhere, the steps that led there are looked at in their order: the arrows of its equation, the lines that cross in
it. Lines that lead nowhere, and corners drawn in another order that close the polygon all the same, are right.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from graphkin.base.geometry import cross, meet_lines, place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Drawn, Equation, Given, Image, LayOff, Meet, Plot, Ray, Term
from graphkin.marking.answers import ArrowPlaces, on_the_way
from graphkin.marking.equation_choices import EquationChoices
from graphkin.marking.follow_through import replay_with
from graphkin.marking.hand import Redrawing
from graphkin.marking.read_off import OwnPoints
from graphkin.marking.records import StepDeparture
from graphkin.model.mechanism import FRAME
from graphkin.model.quantities import Centre, Moving, Quantity, Rotation, centre_of
from graphkin.planning import Method
from graphkin.proof.readings import readings
from graphkin.submissions.submission import BoardStep, BoardWork

_NEAR, _PART = 1.0, 0.015  # a point may be off by so many millimetres and by this part of the arrows behind it
_STEEP = 0.1  # lines that cross at a smaller sine say no more of a point
_ON_LINE = 0.3  # a line passes through a point within so many millimetres
_ALIKE, _ASTRAY = math.radians(1.5), math.radians(3)  # of lines that are parallel, of arrows that point as they should
_LINES = ("line", "parallel", "perpendicular", "protractor")
_LETTERED = 0.1  # a letter so near an arrow's end is that end's [mm]


def first_wrong_step(
    method: Method, plot: Plot, arrows: ArrowPlaces, board: BoardWork, written: Mapping[Quantity, float],
    choices: Sequence[EquationChoices],
) -> StepDeparture | None:  # fmt: skip
    """The first wrong step, in the student's order; None where all that is drawn is right.

    written   own rotations as they stand beside the drawing; choices: the equations, for the words of directions
    """
    planes = [c for c in (method.velocity, method.acceleration) if board.scales.get(c.plane)]
    drawn = {c.plane: {name: at * board.scales[c.plane] for name, at in _points(c, board).items()} for c in planes}
    own = OwnPoints(method, plot, drawn)
    quantities = [q for q in on_the_way(method) if isinstance(q, Moving) and q.letter == "v"]
    vectors: dict[Quantity, complex] = {q: vector for q in quantities if (vector := own.vector(q, arrows)) is not None}
    read: dict[Quantity, float] = {}
    by_link = {(q.word, q.link): q for q in on_the_way(method) if isinstance(q, Rotation)}
    for rate, value in own.rates():
        if math.isfinite(value) and rate in by_link:
            read[by_link[rate]] = value
    faults = [next(_misplaced(method, plot, board), None)]
    for construction in planes:
        before = vectors if construction.plane == "acceleration" else {}
        ways: list[dict[Quantity, complex | float]] = [{}, {**before, **read}, {**before, **read, **written}]
        plots = [replay_with(method, plot, way, arrows).plot for way in ways]
        faults += [_Paper(construction, board, plots, choices).first_fault()]
    return min((fault for fault in faults if fault is not None), key=lambda fault: fault.step, default=None)


def _misplaced(method: Method, plot: Plot, board: BoardWork) -> Iterator[StepDeparture]:
    """The points and instant centres that lie elsewhere on the mechanism's paper, whose 0 is its first fixed point."""
    scale, mechanism = board.scales.get("position"), method.mechanism
    first = next(iter(mechanism.named(FRAME)), None)
    if not scale or first is None:
        return
    motions, origin = readings(method, plot), place(plot.position[first])
    for step in board.steps:
        if step.plane != "position" or step.tool != "point" or not step.at:
            continue
        links = centre_of(mechanism, step.name)
        if step.name in plot.position:
            there = plot.position[step.name]
        elif links is not None:
            there = Centre("P", step.name[1:], links).place(motions)
        else:
            continue
        right = (place(there) - origin) / scale
        if cmath.isfinite(right) and abs(step.at[0] - right) > _NEAR + 2 * _PART * abs(right):
            yield StepDeparture(step.number, "position", "place", step.name)


def _points(construction: Construction, board: BoardWork) -> dict[str, complex]:
    """The lettered points of a polygon, the pole at 0; ends of arrows that begin at one and are named after a term."""
    terms = construction.vectors()
    steps = [step for step in board.steps if step.plane == construction.plane and step.at]
    points = {step.name: step.at[0] for step in steps if step.tool == "point" and step.name}
    givens = (step for step in construction.steps if isinstance(step, Given) and step.point == construction.pole)
    points.update({point: 0j for given in givens for point in (given.point, *given.also)})
    for step in (step for step in steps if _is_arrow(step) and step.name in terms):
        term = terms[step.name]
        if abs(points.get(term.tail, math.inf) - step.at[0]) < _ON_LINE:
            points.setdefault(term.head, step.at[1])
    return points


def _is_arrow(step: BoardStep) -> bool:
    return step.tool == "vector" and len(step.at) > 1


@frozen
class _Paper:
    """One polygon of a student, in millimetres; plots: the right one, and those with own values before."""

    construction: Construction
    board: BoardWork
    plots: Sequence[Redrawing]
    choices: Sequence[EquationChoices]

    @cached_property
    def steps(self) -> list[BoardStep]:
        return [step for step in self.board.steps if step.plane == self.construction.plane]

    @cached_property
    def points(self) -> dict[str, complex]:
        return _points(self.construction, self.board)

    @cached_property
    def made(self) -> dict[str, LayOff | Meet | Image]:
        """The step of the construction that gives each point."""
        made: dict[str, LayOff | Meet | Image] = {}
        for step in self.construction.steps:
            match step:
                case LayOff(tip=point) | Meet(point=point) | Image(point=point):
                    made.setdefault(point, step)
                case _:
                    pass
        return made

    @cached_property
    def loose(self) -> Equation | None:
        """The equation that finds the pole at last: on paper the pole is there, and whoever draws begins elsewhere."""
        every = self.construction.equations
        return next((part for part in every if self.made.get(self.construction.pole) in part.steps), None)

    @property
    def scale(self) -> float:
        return self.board.scales[self.construction.plane]

    def is_site(self, name: str) -> bool:
        """True of a point of the mechanism; others are corners between."""
        return self.construction.nodes[name].site is not None

    def arrow(self, term: Term, plot: Redrawing) -> complex:
        """A known arrow on paper, as it follows; one that is drawn already, as the student has it."""
        if isinstance(term.size, Drawn) and {term.size.tail, term.size.head} <= self.points.keys():
            return self.points[term.size.head] - self.points[term.size.tail]
        return place(plot.laid[self.construction.plane, term.tail, term.head]) / self.scale

    def there(self, name: str, plot: Redrawing, corners: bool) -> complex:
        """A point: the student's own, else where it should be; corners: these as the student has them, too."""
        if name in self.points and (corners or name not in self.made or self.is_site(name)):
            return self.points[name]
        return self.expected(name, plot, corners)[0]

    def expected(self, name: str, plot: Redrawing, corners: bool = False) -> tuple[complex, float]:
        """The place that follows for a point from those before it, and by how much it may be off."""
        if self.loose is not None and self.made.get(name) in self.loose.steps:
            at = place(plot.points(self.construction.plane)[name]) / self.scale
            return at, _NEAR + 2 * _PART * abs(at)
        match self.made.get(name):
            case LayOff(term, start, _, backwards):
                arrow = self.arrow(term, plot)
                at = self.there(start, plot, corners)
                return (at - arrow if backwards else at + arrow), _NEAR + _PART * abs(arrow)
            case Meet(Ray() as first, Ray() as second, point):
                (p, u), (q, w) = (self.ray(ray, plot, corners) for ray in (first, second))
                at, sine = map(complex, meet_lines(p, u, q, w))
                if abs(sine) < _STEEP:
                    return complex("nan"), 0.0
                return at, (_NEAR + _PART * max(abs(at - p), abs(at - q))) / abs(sine)
            case Image(base=(tail, head), point=point):
                points = plot.points(self.construction.plane)
                base = [self.there(each, plot, corners) for each in (tail, head)]
                right = [place(points[each]) for each in (tail, head, point)]
                if right[0] == right[1]:
                    return complex("nan"), 0.0
                ratio = (right[2] - right[0]) / (right[1] - right[0])
                return base[0] + (base[1] - base[0]) * ratio, _NEAR * (1 + abs(ratio))
            case _:
                return complex("nan"), 0.0

    def ray(self, ray: Ray, plot: Redrawing, corners: bool) -> tuple[complex, complex]:
        """A point of a line, and its direction."""
        return self.there(ray.through, plot, corners), place(plot.direction(ray.direction))

    # --- what is wrong --------------------------------------------------------------------------

    def first_fault(self) -> StepDeparture | None:
        """The first wrong step by the student's order of points; of arrows beside them the first with other ends."""
        own = (name for name in self.made if name in self.points and self.is_site(name))
        for number, name in sorted((self.step_of(name), name) for name in own):
            if not any(self._lies_there(name, plot) for plot in self.plots):
                fault = min(self._behind(name, number), key=lambda one: one.step, default=None)
                made = {Image: "image", Meet: "crossing", LayOff: "tip"}[type(self.made[name])]
                return fault or StepDeparture(number, self.construction.plane, made, name)
        return next(self._other_ends(), None)

    def _lies_there(self, name: str, plot: Redrawing) -> bool:
        at, off = self.expected(name, plot)
        return not cmath.isfinite(at) or abs(self.points[name] - at) <= off

    def step_of(self, name: str) -> int:
        """The step that gave the student a point: the arrow or the lines may be there before its letter."""
        ends = ((step, step.at[1 if _is_arrow(step) else 0]) for step in self.steps
                if _is_arrow(step) or (step.tool == "point" and step.name == name and step.at))  # fmt: skip
        return next(step.number for step, at in ends if abs(at - self.points[name]) < _LETTERED)

    def _behind(self, name: str, number: int) -> Iterator[StepDeparture]:
        """The wrong steps that led to a point: known arrows, then lines."""
        made = self.made[name]
        part = next((part for part in self.construction.equations if made in part.steps), None)
        if part is not None and part is self.loose:  # its lines cross at the pole, drawn after its points
            name, number = self.construction.pole, self.board.steps[-1].number
            made = self.made[name]
        laid = [made] if isinstance(made, LayOff) else []
        laid += [step for step in part.steps if isinstance(step, LayOff)] if part is not None else []
        for step in laid:
            yield from self._laid(step, number)
        if isinstance(made, Meet) and part is not None:
            yield from self._lines(name, made, part, number)

    def _laid(self, step: LayOff, number: int) -> Iterator[StepDeparture]:
        """The fault of a known arrow, by its name or by the point at its tip."""
        term, plane = step.term, self.construction.plane
        name = term.name(plane)
        start = [self.there(step.start, plot, True) for plot in self.plots]
        some = {min(abs(one.at[1 if step.backwards else 0] - at) for at in start): one
                for one in self.steps if _is_arrow(one) and one.name == name and one.number <= number}  # fmt: skip
        if not some:
            return
        off, own = min(some.items())  # an arrow may be drawn at two places
        drawn = own.at[1] - own.at[0]
        expected = [self.arrow(term, plot) for plot in self.plots]
        if not any(self._alike(drawn, each) for each in expected):
            yield self._arrow_fault(own, drawn, min(expected, key=lambda each: abs(each - drawn)), term)
        if off > _NEAR and not (self.loose is not None and step in self.loose.steps):
            end = own.at[1 if step.backwards else 0]
            letter = next((name for name, there in self.points.items() if abs(there - end) < _ON_LINE), "")
            yield StepDeparture(own.number, plane, "tail", name, letter, step.start)

    @staticmethod
    def _alike(drawn: complex, right: complex) -> bool:
        return abs(drawn - right) <= _NEAR + 2 * _PART * abs(right)

    def _arrow_fault(self, own: BoardStep, drawn: complex, right: complex, term: Term) -> StepDeparture:
        plane, name = self.construction.plane, own.name
        turned = abs(cmath.phase(drawn / right)) if abs(right) > _NEAR and drawn else 0.0
        if turned > math.pi - _ASTRAY:
            way = self._direction(term)
            way = way if " to " in way else f"{math.degrees(cmath.phase(right)) % 360:.1f}"
            return StepDeparture(own.number, plane, "reversed", name, right=way)
        if turned > _ASTRAY:
            angles = (f"{math.degrees(cmath.phase(each)) % 360:.1f}" for each in (drawn, right))
            return StepDeparture(own.number, plane, "turned", name, *angles)
        return StepDeparture(own.number, plane, "length", name, *(f"{abs(each):.1f}" for each in (drawn, right)))

    def _lines(self, name: str, made: Meet, part: Equation, number: int) -> Iterator[StepDeparture]:
        """The lines through a point that are none of the two that should cross there."""
        at, rays = self.points[name], [ray for ray in (made.first, made.second) if isinstance(ray, Ray)]
        lines = [line for line in self.steps if line.tool in _LINES and len(line.at) > 1
                 and line.number <= number and _off(line, at) < _ON_LINE]  # fmt: skip
        fits = {line.number: [ray for ray in rays if self._is_parallel(line, ray) and self._passes(line, ray)]
                for line in lines}  # fmt: skip
        left = [ray for ray in rays if not any(ray in some for some in fits.values())] or rays
        for line in (line for line in lines if not fits[line.number]):
            parallel = [ray for ray in left if self._is_parallel(line, ray)]
            meant = (parallel or [ray for ray in left if self._passes(line, ray)] or left)[0]
            own, right = _token(line), self._line_token(part, meant)
            own = own if own != right or parallel else ""
            through = line.through or self._through(line, name)
            if parallel:
                yield StepDeparture(line.number, line.plane, "through", own or right, through, meant.through)
            elif self._passes(line, meant):
                yield StepDeparture(line.number, line.plane, "direction", meant.through, own, right)
            else:
                yield StepDeparture(line.number, line.plane, "line", own, through, meant.through, right)

    def _is_parallel(self, line: BoardStep, ray: Ray) -> bool:
        along = line.at[1] - line.at[0]
        ways = (place(plot.direction(ray.direction)) for plot in self.plots)
        return any(abs(float(cross(along, way))) < math.sin(_ALIKE) * abs(along) for way in ways)

    def _passes(self, line: BoardStep, ray: Ray) -> bool:
        ends = (step for step in self.made.values() if isinstance(step, Meet) and ray in (step.first, step.second))
        if self.loose is not None and any(step in self.loose.steps for step in ends):
            return True  # through which point depends on where one begins
        return any(_off(line, self.there(ray.through, plot, True)) < _NEAR for plot in self.plots)

    def _through(self, line: BoardStep, but: str) -> str:
        """The letter of another point that a line passes through, the latest first; "" of none."""
        near = [name for name, at in self.points.items() if name != but and _off(line, at) < _ON_LINE]
        return near[-1] if near else ""

    def _line_token(self, part: Equation, ray: Ray) -> str:
        terms = (term for term in part.left + part.right if term.direction == ray.direction and term.size is None)
        return next((token for term in terms if (token := self._direction(term))), "")

    def _direction(self, term: Term) -> str:
        """The direction of a term as its equation has it."""
        name = term.name(self.construction.plane)
        every = (each for one in self.choices if one.plane == self.construction.plane for each in one.terms)
        return next((each.directions[0] for each in every if each.name == name and each.directions), "")

    def _other_ends(self) -> Iterator[StepDeparture]:
        """Named arrows that are not those between their points; they may be drawn elsewhere."""
        terms = self.construction.vectors()
        for own in (step for step in self.steps if _is_arrow(step) and step.name in terms):
            term = terms[own.name]
            if term.size is None and {term.tail, term.head} <= self.points.keys():
                drawn, head = own.at[1] - own.at[0], self.points[term.head]
                tails = [self.points[term.tail], *(self.there(term.tail, plot, False) for plot in self.plots)]
                if not any(self._alike(drawn, head - tail) for tail in tails if cmath.isfinite(tail)):
                    yield StepDeparture(own.number, own.plane, "ends", own.name, right=f"{term.tail} {term.head}")


def _off(line: BoardStep, at: complex) -> float:
    """The distance of a point from a line."""
    along = line.at[1] - line.at[0]
    return abs(float(cross(along, at - line.at[0]))) / (abs(along) or 1.0)


def _token(line: BoardStep) -> str:
    """The direction of a line as a token; "" of one that was drawn by its two ends."""
    return f"{line.tool} {line.line}" if line.tool in ("parallel", "perpendicular") and line.line else ""
