"""The steps of a construction as objects of GeoGebra, so that everything hangs on the drivers' sliders.

Links that are tried until they fit have a list of where they lie nearly, read off the whole motion, position by
position, so that every group stays on its own side; Newton's steps find the place itself, from what the construction
has by then. Past a dead point the list ends, and nothing is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import assert_never

import numpy as np

from graphkin import construction as kinds
from graphkin.base.geometry import number, place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Fit, InStep, Measure, Plot, slide_key
from graphkin.outputs.geogebra.protocol import Colour, FormulaPair, Protocol, grouped, minus, plus, product, value
from graphkin.outputs.geogebra.state import ORDERS, GeogebraState
from graphkin.planning import Method
from graphkin.running.path import along, turned
from graphkin.studies.sweeps import course

ROUNDS = 4  # steps of Newton's, from a place between two of the list: each doubles the digits that are right
_APART_DEG, _PARTS = 1.0, 360
"""Distance of the places of the list: an angle of the driver's, or a part of a slide's path."""
_SHORT = 1e-6  # distance from a dead point at which the list ends, as a part of the path

Row = tuple[str, Mapping[str, str]]  # known + sum of coefficient * unknown = 0, as formulas


@frozen
class Nearly:
    """The places where the fitted links lie nearly, by the driver's value.

    at     how many places of the list the driver has gone, and the part of the next (labels of two numbers)
    lists  labels, by what is fitted
    """

    protocol: Protocol
    at: tuple[str, str]
    lists: Mapping[str, str]

    @classmethod
    def of(cls, method: Method, protocol: Protocol, driven: str) -> Nearly:
        """The lists over the whole motion; driven: the label of the driver's value [rad, m]."""
        path = course(method).path
        short = _SHORT * (path.last - path.first)
        low, high = path.first + short, path.last - short
        is_angle = method.drivers[0].kind != "slide"
        apart = math.radians(_APART_DEG) if is_angle else (high - low) / _PARTS
        t = np.linspace(low, high, 1 + math.ceil((high - low) / apart))
        if path.stops and is_angle and not method.structure.contacts:
            middle = value(path.start[0] + (low + high) / 2)  # whole turns away the mechanism stands alike
            driven = protocol.number(f"{driven} - 2 * pi * round(({driven} - {middle}) / (2 * pi))")
        gone = protocol.number(f"({driven} - {value(path.start[0] + low)}) / {value(float(t[1] - t[0]))} + 1")
        whole = protocol.number(f"floor({gone})")
        values = turned(method, along(method, path, t))
        names = {name for step in method.position.steps if isinstance(step, Fit) for name in _unknowns(step)}
        lists = {}
        for name in sorted(names):  # to nine digits
            numbers = (value(float(f"{each:.9g}")) for each in np.broadcast_to(values[name], t.shape))
            lists[name] = protocol.matrix("{" + ", ".join(numbers) + "}")
        return cls(protocol, (whole, protocol.number(f"{gone} - {whole}")), lists)

    def value(self, name: str) -> str:
        """Between two places of the list."""
        (whole, part), places = self.at, self.lists[name]
        one, next_ = f"Element[{places}, {whole}]", f"Element[{places}, {whole} + 1]"
        return self.protocol.number(f"{one} + {part} * ({next_} - {one})")


def _unknowns(step: Fit | kinds.Simultaneous) -> tuple[str, ...]:
    return (*step.angles, *map(slide_key, step.slides))


class Draughtsman:
    """Draws one plane.

    captions  names written at its points; origin: in units of the drawing
    nearly    where links that are fitted lie
    """

    def __init__(
        self, construction: Construction, plot: Plot, state: GeogebraState, captions: Mapping[str, str],
        colour: Colour, origin: complex, nearly: Nearly | None = None,
    ) -> None:  # fmt: skip
        self.construction, self.plot, self.state, self.captions = construction, plot, state, captions
        self.colour, self.origin, self.nearly = colour, origin, nearly
        self.plane, self.protocol = construction.plane, state.protocol
        self.order, self.scale, self.points = ORDERS[self.plane], state.scales[self.plane], state.points[self.plane]

    def draw(self) -> None:
        """Every step in order; a line or an arc alone fixes no point."""
        state = self.state
        for step in self.construction.steps:
            match step:
                case kinds.Given():  # a point that can be dragged; a pole that is found last is none
                    meets = (later.point for later in self.construction.steps if isinstance(later, kinds.Meet))
                    if step.point != self.construction.pole or step.point not in meets:
                        caption, at = self.captions.get(step.point, ""), self._at(step.point)
                        self.points[step.point] = self.protocol.free_point(caption, at, self.colour)
                        self._put_fixed_on(step.point)
                case kinds.LayOff():
                    assert step.term.size is not None
                    arrow = state.arrow(step.term.size, self.plane).times(value(1 / self.scale))
                    self._point(step.tip, f"{self.points[step.start]} {'-' if step.backwards else '+'} {arrow.point}")
                case kinds.Ray() | kinds.Arc():
                    pass
                case kinds.Meet():
                    self._meet(step)
                case kinds.Swing():
                    arm = state.bound(state.arm(step.pivot, step.through))
                    state.settle(0, state.base(step.link), state.swing(step.span, step.slide, arm, step.side))
                case kinds.Image():
                    self._image(step)
                case Measure():
                    self._measure(step)
                case kinds.Roll():
                    self._roll(step)
                case kinds.Touch():
                    self._touch(step)
                case kinds.Simultaneous():
                    rows = [row for chain in step.chains for row in self._chain(chain)]
                    rows += [self._in_step(contact, set(_unknowns(step))) for contact in step.contacts]
                    self._settle_all(step, self._solved(rows, _unknowns(step)), counted=False)
                case Fit():
                    self._fit(step)
                case _:
                    assert_never(step)

    def _at(self, name: str) -> complex:
        """The place of a point now."""
        return self.origin + place(self.plot.points(self.plane)[name]) / self.scale

    def _point(self, name: str, formula: str) -> None:
        self.points[name] = self.protocol.point(self.captions.get(name, ""), formula, self._at(name), self.colour)

    def _put_fixed_on(self, point: str) -> None:
        """All that never moves is on the pole, once that is there."""
        if point == self.construction.pole:
            fixed = (name for s in self.construction.steps if isinstance(s, kinds.Given) for name in s.also)
            self.points.update(dict.fromkeys(fixed, self.points[point]))

    def _meet(self, step: kinds.Meet) -> None:
        first, second = self._line(step.first), self._line(step.second)
        if isinstance(step.second, kinds.Ray):
            self._point(step.point, self.protocol.crossing(first, second))
        else:
            one, other = (self.protocol.crossing(first, second, k) for k in (1, 2))
            if isinstance(step.first, kinds.Ray):
                along, across = self.state.direction(step.first.direction)
                ahead = (along.turned if across else along).dot(FormulaPair.between(other, one))
            else:
                about, other_centre = self.points[step.first.about], self.points[step.second.about]
                ahead = FormulaPair.between(about, other_centre).cross(FormulaPair.between(about, one))
            self._point(step.point, f"If[{product(str(step.side), ahead)} > 0, {one}, {other}]")
        self._put_fixed_on(step.point)

    def _line(self, line: kinds.Ray | kinds.Arc) -> str:
        """A line or a circle on which a point must lie."""
        if isinstance(line, kinds.Ray):
            along, across = self.state.direction(line.direction)
            return self.protocol.line(self.points[line.through], self.protocol.direction(along.point), across=across)
        radius = self.state.bound(self.state.span(line.reach))
        return self.protocol.circle(self.points[line.about], f"sqrt({radius.dot(radius)}) / {value(self.scale)}")

    def _image(self, step: kinds.Image) -> None:
        """The first point, and the known side turned and stretched as the link has it."""
        first, second, third = step.corners
        start, end = (self.points[name] for name in step.base)
        shape = self.state.facts.shapes[step.link]
        if all(corner in shape for corner in step.corners):
            ratio = FormulaPair.of((shape[third] - shape[first]) / (shape[second] - shape[first]))
        else:
            side, arm = (self.state.bound(self.state.arm(first, other)) for other in (second, third))
            turn = FormulaPair(side.dot(arm), side.cross(arm))
            ratio = self.state.bound(turn.times(f"1 / {grouped(side.dot(side))}"))
        self._point(step.point, f"{start} + {FormulaPair.between(start, end).by(ratio).point}")

    def _touch(self, step: kinds.Touch) -> None:
        centre = self.points[step.centre]
        if step.slide:
            offset = self.state.guide(step.slide).turned.times(value(step.offset / self.scale))
        else:
            offset = FormulaPair.between(centre, self.points[step.other]).times(value(step.ratio))
        self._point(step.point, f"{centre} + {offset.point}")

    def _measure(self, step: Measure) -> None:
        state = self.state
        arrow = state.bound(FormulaPair.between(self.points[step.tail], self.points[step.head]))
        if step.quantity == "theta":
            assert step.span is not None
            state.settle(0, state.base(step.of), minus(arrow.angle, state.bound(state.span(step.span)).angle))
        elif step.quantity in ("omega", "alpha"):
            arm = state.bound(state.arm(*step.lever))
            rate = f"{product(value(self.scale), arm.cross(arrow))} / {grouped(arm.dot(arm))}"
            state.settle(self.order, state.base(step.of), minus(rate, state.relative(step.of, self.order)))
        else:
            along = state.guide(step.of).dot(arrow)
            state.displace(self.order, step.of, product(value(step.sign * self.scale), along))

    def _roll(self, step: kinds.Roll) -> None:
        unknown = {step.angle, slide_key(step.slide) if step.slide else ""} - {""}
        rest, coefficients = self._in_step(step.contact, unknown)
        formula = f"-{grouped(rest)} / {grouped(' + '.join(coefficients.values()))}"
        if step.angle:
            self.state.settle(self.order, step.angle, formula, counted=True)
        else:
            self.state.displace(self.order, step.slide, formula)

    def _in_step(self, contact: InStep, unknown: set[str]) -> Row:
        """The sum that a rolling contact makes nothing: turns since the drawn position, or rates."""
        coefficients: dict[str, float] = {}
        rest, facts = "0", self.state.facts
        for link, arm in contact.angles:
            base, coefficient = self.state.base(link), number(arm)
            drawn = number(facts.drawn.get(link, 0.0)) if self.order == 0 else 0.0
            if base in unknown:
                coefficients[base] = coefficients.get(base, 0.0) + coefficient
            turned = self.state.relative(link, self.order) if base in unknown else self.state.turn(link, self.order)
            rest = plus(rest, product(value(coefficient), minus(turned, value(drawn))))
        for slide, share in contact.way or ((contact.slide, 1.0),) * bool(contact.slide):
            coefficient, key = contact.on_slide * share, slide_key(slide)
            drawn = number(facts.drawn[key]) if self.order == 0 else 0.0
            if key in unknown:
                coefficients[key] = coefficients.get(key, 0.0) + coefficient
                rest = plus(rest, value(-coefficient * drawn))
            else:
                moved = minus(self.state.slides[self.order][slide], value(drawn))
                rest = plus(rest, product(value(coefficient), moved))
        return rest, {name: value(coefficient) for name, coefficient in coefficients.items()}

    def _solved(self, rows: Sequence[Row], names: Sequence[str]) -> list[str]:
        """The unknowns, each by its element of a column."""
        matrix = "{" + ", ".join("{" + ", ".join(row.get(n, "0") for n in names) + "}" for _, row in rows) + "}"
        right = "{" + ", ".join("{" + minus("0", rest) + "}" for rest, _ in rows) + "}"
        left, known = self.protocol.matrix(matrix), self.protocol.matrix(right)
        if len(rows) != len(names):
            left, known = (self.protocol.matrix(f"Transpose[{left}] * {side}") for side in (left, known))
        column = self.protocol.matrix(f"Invert[{left}] * {known}")
        return [f"Element[{column}, {k}, 1]" for k in range(1, len(names) + 1)]

    def _settle_all(self, step: Fit | kinds.Simultaneous, formulas: Sequence[str], counted: bool) -> None:
        """The angles, then the displacements of a step."""
        for base, formula in zip(step.angles, formulas):
            self.state.settle(self.order, base, formula, counted=counted)
        for slide, formula in zip(step.slides, formulas[len(step.angles) :]):
            self.state.displace(self.order, slide, formula)

    def _fit(self, step: Fit) -> None:
        """From where the links lie nearly, by Newton's steps."""
        assert self.nearly is not None
        names = _unknowns(step)
        trial = [self.nearly.value(name) for name in names]
        self._settle_all(step, trial, counted=True)
        for _ in range(ROUNDS):
            rows = [row for closure in step.closures for row in self._closure(closure)]
            gaps = ((self._in_step(contact, set())[0], contact) for contact in step.contacts)
            rows += [(gap, self._in_step(contact, set(names))[1]) for gap, contact in gaps]
            changes = self._solved(rows, names)
            trial = [self.protocol.number(f"{old} + {change}") for old, change in zip(trial, changes, strict=True)]
            self._settle_all(step, trial, counted=True)

    def _closure(self, closure: kinds.Closure) -> Iterator[Row]:
        """The gap left open by a loop of links, along x and along y, and what each unknown does to it [m]."""
        state, points = self.state, self.points
        gap = FormulaPair()
        if not closure.floats:
            gap = FormulaPair.between(points[closure.end], points[closure.start]).times(value(self.scale))
        slopes: dict[str, FormulaPair] = {}
        for part in closure.parts:
            if isinstance(part, kinds.Arm):
                link = part.link
                arrow = state.own_arm(part).by(state.bound(FormulaPair.along(state.turn(link, 0))))
            else:
                link = state.facts.lines[part.slide][0]
                guide = state.guide(part.slide).times(str(part.sign))
                arrow = guide.times(state.slides[0][part.slide])
                slopes[slide_key(part.slide)] = state.bound(guide)
            arrow, base = state.bound(arrow), state.base(link)
            gap += arrow
            slopes[base] = slopes[base] + arrow.turned if base in slopes else arrow.turned
        yield from _rows(gap, slopes)

    def _chain(self, chain: kinds.Chain) -> Iterator[Row]:
        """A closed chain of arrows along x and along y."""
        known, arrows = FormulaPair(), dict[str, FormulaPair]()
        for size, sign in chain.known:
            known += self.state.arrow(size, self.plane).times(str(sign))
        for unknown in chain.unknown:
            if unknown.slide:
                name, arrow = slide_key(unknown.slide), self.state.guide(unknown.slide).times(str(unknown.sign))
            else:
                name = self.state.base(unknown.link)
                arrow = self.state.arm(unknown.tail, unknown.head).turned.times(str(unknown.sign))
                known += arrow.times(self.state.relative(unknown.link, self.order))
            arrows[name] = arrows.get(name, FormulaPair()) + arrow
        yield from _rows(known, arrows)


def _rows(known: FormulaPair, arrows: Mapping[str, FormulaPair]) -> Iterator[Row]:
    yield known.x, {name: arrow.x for name, arrow in arrows.items()}
    yield known.y, {name: arrow.y for name, arrow in arrows.items()}
