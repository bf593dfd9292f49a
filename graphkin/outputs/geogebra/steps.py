"""Steps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import assert_never

import numpy as np

from graphkin.base.value import frozen
from graphkin.construction import (
    Arc,
    Arm,
    Chain,
    Closure,
    Construction,
    Fit,
    Given,
    Image,
    InStep,
    LayOff,
    Measure,
    Meet,
    Plane,
    Plot,
    Ray,
    Roll,
    Simultaneous,
    Swing,
    Touch,
    slide_key,
)
from graphkin.outputs.geogebra.protocol import (
    NOTHING,
    Colour,
    FormulaPair,
    Protocol,
    between,
    grouped,
    known,
    minus,
    plus,
    product,
    value,
)
from graphkin.outputs.geogebra.state import ORDERS, GeogebraState
from graphkin.planning import Method
from graphkin.running.path import along, turned
from graphkin.studies.sweeps import course

ROUNDS = 4
"""Steps of Newton's, from a place between two of the list: each doubles the digits that are right."""
_APART_DEG, _PARTS = 1.0, 360
"""How far the places of the list are apart: an angle of the driver's, or a part of a slide's way."""
_SHORT = 1e-6
"""How near to a dead point the list goes [of the way]."""

Row = tuple[str, Mapping[str, str]]
"""known + sum of coefficient * unknown = 0, as formulas."""


@frozen
class Nearly:
    """Where the fitted links lie nearly, by the driver's value.

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
        apart = math.radians(_APART_DEG) if method.drivers[0].kind != "slide" else (high - low) / _PARTS
        t = np.linspace(low, high, 1 + math.ceil((high - low) / apart))
        start = path.start[0] + low
        if path.stops and method.drivers[0].kind != "slide" and not method.structure.contacts:
            middle = value(path.start[0] + (low + high) / 2)  # whole turns away the mechanism stands alike
            driven = protocol.number(f"{driven} - 2 * pi * round(({driven} - {middle}) / (2 * pi))")
        gone = protocol.number(f"({driven} - {value(start)}) / {value(float(t[1] - t[0]))} + 1")
        whole = protocol.number(f"floor({gone})")
        found = turned(method, along(method, path, t))
        names = {name for step in method.position.steps if isinstance(step, Fit) for name in unknowns_of(step)}
        lists = {name: protocol.list_of(np.broadcast_to(found[name], t.shape)) for name in sorted(names)}
        return cls(protocol, (whole, protocol.number(f"{gone} - {whole}")), lists)

    def value(self, name: str) -> str:
        """Between two places of the list."""
        (whole, part), places = self.at, self.lists[name]
        one, next_ = f"Element[{places}, {whole}]", f"Element[{places}, {whole} + 1]"
        return self.protocol.number(f"{one} + {part} * ({next_} - {one})")


def unknowns_of(step: Fit) -> tuple[str, ...]:
    return (*step.angles, *map(slide_key, step.slides))


def settle(step: Fit, state: GeogebraState, trial: Mapping[str, str]) -> None:
    """Take the links as they lie at a trial, by label."""
    for base in step.angles:
        state.settle(0, base, trial[base], counted=True)
    for slide in step.slides:
        state.displace(0, slide, trial[slide_key(slide)])


def closure_rows(closure: Closure, state: GeogebraState) -> Iterator[Row]:
    """What is left open of a way round, along x and along y, and what each unknown does to it [m]."""
    points = state.points["position"]
    gap = known(0j)
    if not closure.floats:
        gap = between(points[closure.end], points[closure.start]).times(value(state.scales["position"]))
    slopes: dict[str, FormulaPair] = {}
    for part in closure.parts:
        if isinstance(part, Arm):
            shape, link = state.facts.shapes[part.link], part.link
            arrow = known(shape[part.head] - shape[part.tail]).by(state.direction_of(link))
        else:
            link = state.facts.lines[part.slide][0]
            way = state.guide(part.slide).times(str(part.sign))
            arrow = way.times(state.slides[0][part.slide])
            slopes[slide_key(part.slide)] = state.bound(way)
        arrow, base = state.bound(arrow), state.facts.turns[link].base
        gap += arrow
        slopes[base] = slopes[base] + arrow.turned if base in slopes else arrow.turned
    yield gap.x, {name: slope.x for name, slope in slopes.items()}
    yield gap.y, {name: slope.y for name, slope in slopes.items()}


@frozen
class Draughtsman:
    """Draws one plane.

    captions  what is written at its points; origin: in units of the drawing
    nearly    where links that are fitted lie
    """

    construction: Construction
    plot: Plot
    state: GeogebraState
    captions: Mapping[str, str]
    colour: Colour
    origin: complex
    nearly: Nearly | None = None

    @property
    def plane(self) -> Plane:
        return self.construction.plane

    @property
    def order(self) -> int:
        return ORDERS[self.plane]

    @property
    def scale(self) -> float:
        return self.state.scales[self.plane]

    @property
    def points(self) -> dict[str, str]:
        return self.state.points[self.plane]

    @property
    def protocol(self) -> Protocol:
        return self.state.protocol

    def draw(self) -> None:
        """Every step in order."""
        for step in self.construction.steps:
            match step:
                case Given():
                    self._given(step)
                case LayOff():
                    assert step.term.size is not None
                    arrow = self.state.arrow(step.term.size, self.plane).times(value(1 / self.scale))
                    self._point(step.tip, f"{self.points[step.start]} {'-' if step.backwards else '+'} {arrow.point}")
                case Ray() | Arc():
                    pass  # alone it fixes no point
                case Meet():
                    self._meet(step)
                case Swing():
                    way = self.state.bound(self.state.arm(step.pivot, step.through))
                    angle = self.state.swing(step.span, step.slide, way, step.side)
                    self.state.settle(0, self.state.facts.turns[step.link].base, angle)
                case Image():
                    self._image(step)
                case Measure():
                    self._measure(step)
                case Roll():
                    self._roll(step)
                case Touch():
                    self._touch(step)
                case Simultaneous():
                    self._together(step)
                case Fit():
                    self._fit(step)
                case _:
                    assert_never(step)

    # --- points ---

    def _at(self, name: str) -> complex:
        """Where a point lies now."""
        return self.origin + complex(self.plot.points(self.plane)[name]) / self.scale

    def _point(self, name: str, formula: str) -> None:
        caption = self.captions.get(name, "")
        self.points[name] = self.protocol.point(caption, formula, self._at(name), self.colour)

    def _given(self, step: Given) -> None:
        if step.point == self.construction.pole and any(
            isinstance(later, Meet) and later.point == step.point for later in self.construction.steps
        ):
            return  # a pole found last
        self.points[step.point] = self.protocol.free_point(
            self.captions.get(step.point, ""), self._at(step.point), self.colour
        )
        if step.point == self.construction.pole:
            self._fixed()

    def _fixed(self) -> None:
        """What never moves is on the pole."""
        given = [step for step in self.construction.steps if isinstance(step, Given)]
        self.points.update({name: self.points[self.construction.pole] for step in given for name in step.also})

    def _meet(self, step: Meet) -> None:
        first, second = self._place(step.first), self._place(step.second)
        if isinstance(step.second, Ray):
            self._point(step.point, self.protocol.crossing(first, second))
        else:
            one, other = (self.protocol.crossing(first, second, k) for k in (1, 2))
            self._point(step.point, f"If[{self._ahead(step, one, other)} > 0, {one}, {other}]")
        if step.point == self.construction.pole:
            self._fixed()

    def _ahead(self, step: Meet, one: str, other: str) -> str:
        """Positive where `one` is the crossing that is meant."""
        assert isinstance(step.second, Arc)
        if isinstance(step.first, Ray):
            along, across = self.state.direction(step.first.direction)
            return product(str(step.side), (along.turned if across else along).dot(between(other, one)))
        centres = between(self.points[step.first.about], self.points[step.second.about])
        return product(str(step.side), centres.cross(between(self.points[step.first.about], one)))

    def _place(self, line: Ray | Arc) -> str:
        """A line or a circle on which a point must lie."""
        if isinstance(line, Ray):
            along, across = self.state.direction(line.direction)
            return self.protocol.line(self.points[line.through], self.protocol.direction(along.point), across=across)
        radius = self.state.bound(self.state.span(line.reach))
        return self.protocol.circle(self.points[line.about], f"sqrt({radius.square}) / {value(self.scale)}")

    def _image(self, step: Image) -> None:
        """The first point, and the known side turned and stretched as the link has it."""
        first, second, third = step.corners
        start, end = (self.points[name] for name in step.base)
        shape = self.state.facts.shapes[step.link]
        if all(corner in shape for corner in step.corners):
            ratio = (shape[third] - shape[first]) / (shape[second] - shape[first])
            new = between(start, end).by(FormulaPair(value(ratio.real), value(ratio.imag)))
        else:
            side, arm = (self.state.bound(self.state.arm(first, other)) for other in (second, third))
            turned = FormulaPair(side.dot(arm), side.cross(arm)).times(f"1 / {grouped(side.square)}")
            new = between(start, end).by(self.state.bound(turned))
        self._point(step.point, f"{start} + {new.point}")

    def _touch(self, step: Touch) -> None:
        centre = self.points[step.centre]
        if step.slide:
            offset = self.state.guide(step.slide).turned.times(value(step.offset / self.scale))
        else:
            offset = between(centre, self.points[step.other]).times(value(step.ratio))
        self._point(step.point, f"{centre} + {offset.point}")

    # --- what is read off ---

    def _measure(self, step: Measure) -> None:
        arrow = self.state.bound(between(self.points[step.tail], self.points[step.head]))
        if step.quantity == "theta":
            assert step.span is not None
            span = self.state.bound(self.state.span(step.span))
            base = self.state.facts.turns[step.of].base
            self.state.settle(0, base, minus(arrow.angle, span.angle))
        elif step.quantity in ("omega", "alpha"):
            arm = self.state.bound(self.state.arm(*step.lever))
            rate = f"{product(value(self.scale), arm.cross(arrow))} / {grouped(arm.square)}"
            base = self.state.facts.turns[step.of].base
            self.state.settle(self.order, base, minus(rate, self.state.relative(step.of, self.order)))
        else:
            along = self.state.guide(step.of).dot(arrow)
            self.state.displace(self.order, step.of, product(value(step.sign * self.scale), along))

    def _roll(self, step: Roll) -> None:
        unknown = {step.angle, slide_key(step.slide) if step.slide else ""} - {""}
        rest, coefficients = self._in_step(step.contact, unknown)
        formula = f"-{grouped(rest)} / {grouped(' + '.join(coefficients.values()))}"
        if step.angle:
            self.state.settle(self.order, step.angle, formula, counted=True)
        else:
            self.state.displace(self.order, step.slide, formula)

    def _in_step(self, contact: InStep, unknown: set[str]) -> Row:
        """What a rolling contact asks for: turns since the drawn position, or rates, that add up to nothing."""
        coefficients: dict[str, float] = {}
        rest, facts = "0", self.state.facts
        for link, coefficient in contact.angles:
            base = facts.turns[link].base
            drawn = facts.drawn.get(link, 0.0) if self.order == 0 else 0.0
            if base in unknown:
                coefficients[base] = coefficients.get(base, 0.0) + coefficient
            turned = self.state.relative(link, self.order) if base in unknown else self.state.turn(link, self.order)
            rest = plus(rest, product(value(coefficient), minus(turned, value(drawn))))
        for slide, share in contact.way or ((contact.slide, 1.0),) * bool(contact.slide):
            coefficient, key = contact.on_slide * share, slide_key(slide)
            drawn = facts.drawn[key] if self.order == 0 else 0.0
            if key in unknown:
                coefficients[key] = coefficients.get(key, 0.0) + coefficient
                rest = plus(rest, value(-coefficient * drawn))
            else:
                moved = minus(self.state.slides[self.order][slide], value(drawn))
                rest = plus(rest, product(value(coefficient), moved))
        return rest, {name: value(number) for name, number in coefficients.items()}

    # --- what is solved together ---

    def _together(self, step: Simultaneous) -> None:
        names = (*step.angles, *map(slide_key, step.slides))
        rows = [row for chain in step.chains for row in self._chain(chain)]
        rows += [self._in_step(contact, set(names)) for contact in step.contacts]
        found = self._solved(rows, names)
        for k, base in enumerate(step.angles, 1):
            self.state.settle(self.order, base, f"Element[{found}, {k}, 1]")
        for k, slide in enumerate(step.slides, len(step.angles) + 1):
            self.state.displace(self.order, slide, f"Element[{found}, {k}, 1]")

    def _solved(self, rows: Sequence[Row], names: Sequence[str]) -> str:
        """The unknowns as a column."""
        matrix = "{" + ", ".join("{" + ", ".join(row.get(n, "0") for n in names) + "}" for _, row in rows) + "}"
        right = "{" + ", ".join("{" + minus("0", rest) + "}" for rest, _ in rows) + "}"
        left, known = self.protocol.matrix(matrix), self.protocol.matrix(right)
        if len(rows) != len(names):
            left, known = (self.protocol.matrix(f"Transpose[{left}] * {side}") for side in (left, known))
        return self.protocol.matrix(f"Invert[{left}] * {known}")

    def _fit(self, step: Fit) -> None:
        """From where the links lie nearly, by Newton's steps."""
        assert self.nearly is not None
        names = unknowns_of(step)
        trial = {name: self.nearly.value(name) for name in names}
        settle(step, self.state, trial)
        for _ in range(ROUNDS):
            rows = [row for closure in step.closures for row in closure_rows(closure, self.state)]
            gaps = ((self._in_step(contact, set())[0], contact) for contact in step.contacts)
            rows += [(gap, self._in_step(contact, set(names))[1]) for gap, contact in gaps]
            found = self._solved(rows, names)
            trial = {n: self.protocol.number(f"{trial[n]} + Element[{found}, {k}, 1]") for k, n in enumerate(names, 1)}
            settle(step, self.state, trial)

    def _chain(self, chain: Chain) -> Iterator[Row]:
        """A closed chain of arrows along x and along y."""
        known, arrows = NOTHING, dict[str, FormulaPair]()
        for size, sign in chain.known:
            known += self.state.arrow(size, self.plane).times(str(sign))
        for unknown in chain.unknown:
            if unknown.slide:
                name, arrow = slide_key(unknown.slide), self.state.guide(unknown.slide).times(str(unknown.sign))
            else:
                name = self.state.facts.turns[unknown.link].base
                arrow = self.state.arm(unknown.tail, unknown.head).turned.times(str(unknown.sign))
                known += arrow.times(self.state.relative(unknown.link, self.order))
            arrows[name] = arrows.get(name, NOTHING) + arrow
        yield known.x, {name: arrow.x for name, arrow in arrows.items()}
        yield known.y, {name: arrow.y for name, arrow in arrows.items()}
