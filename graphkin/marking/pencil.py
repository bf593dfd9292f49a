"""The construction drawn with a pencil that errs: many times at once, as arrays.

A mechanism drawn on paper is a slightly different mechanism: its pivots, lengths and guides are off by what ruler and
protractor allow (`drawn_positions`). The polygons are drawn on it by a hand that errs again at each arrow, line and
reading (`PencilHand`). Lengths that the problem gives are used as they are given.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, reduce
from typing import Never, assert_never, cast
from zlib import crc32

import numpy as np

from graphkin.base.geometry import Real, Value
from graphkin.base.value import frozen
from graphkin.construction import Facts, Image, Measure, Meet, Plane, Plot, Ray, replay, terms
from graphkin.marking.hand import Redrawing
from graphkin.marking.rewrite import Mistaken, Rewrite
from graphkin.model.mechanism import Mechanism
from graphkin.planning import Method
from graphkin.running.path import turned

_STAGES = 3  # links are fitted anew while errors grow by this part of what they come to
_NO_ARROW = 1e-6  # an arrow shorter than this part of what the pencil errs by is not drawn


@frozen
class Pencil:
    """Standard deviations of what is drawn or read.

    lengths  of a length, by plane, in its units [m, m/s, m/s^2]: the paper's errors at the plane's scale
    angle    of a direction [rad]
    """

    lengths: Mapping[Plane, float]
    angle: float

    def times(self, part: float) -> Pencil:
        """One that errs by so many times as much."""
        return Pencil({plane: part * length for plane, length in self.lengths.items()}, part * self.angle)


@frozen
class Mark:
    """One thing that a pencil or a ruler does: where a slip may be.

    plane, what   the plane, and the kind: "point", "link", "guide", "driver", "arrow", "line", "image", "reading"
    of            what it is done to, as the plane names it
    """

    plane: Plane
    what: str
    of: tuple[str, ...]


class Slips:
    """The errors of one pencil in `count` drawings: standard normal, (count,) for each mark.

    A mark's errors depend on the seed and on the mark alone, so that two drawings in which something else differs are
    made by one and the same hand. `allowed` says which marks have any; `seen` are those that were asked for.
    """

    def __init__(self, seed: int, count: int, allowed: Callable[[Mark], bool] | None = None) -> None:
        self.seed, self.count, self.allowed = seed, count, allowed
        self.seen: dict[Mark, None] = {}
        self._drawn = count
        self._kept: np.ndarray | slice = slice(None)

    def more(self, count: int) -> Slips:
        """The same pencil, which goes on to more drawings."""
        return Slips(self.seed, count, self.allowed)

    def only(self, kept: np.ndarray) -> Slips:
        """Some of its drawings (numbers,), the others thrown away."""
        one = self.more(self.count)
        one.count, one._kept, one._drawn = len(kept), kept, self._drawn
        return one

    def of(self, mark: Mark, which: int = 0) -> np.ndarray | float:
        """The errors of a mark in units of the pencil's; `which` tells several of one mark apart."""
        self.seen[mark] = None
        if self.allowed is not None and not self.allowed(mark):
            return 0.0
        number = crc32(repr((mark.plane, mark.what, mark.of, which)).encode())
        return _normal(self.seed, number, self._drawn)[self._kept]


@lru_cache(512)
def _normal(seed: int, number: int, count: int) -> np.ndarray:
    """Normal errors (count,), for all who ask for the same."""
    drawn = np.random.default_rng([seed, number]).standard_normal(count)
    drawn.flags.writeable = False
    return drawn


def seed_of(mechanism: Mechanism) -> int:
    """A number that depends on the mechanism alone."""
    return crc32((mechanism.text or repr((mechanism.name, mechanism.links, mechanism.drivers))).encode())


# --- the mechanism on paper -------------------------------------------------------------------


def drawn_positions(method: Method, pencil: Pencil, slips: Slips) -> Plot:
    """The mechanism drawn `slips.count` times: positions (n,), NaN in those drawings whose links do not meet. Where
    links are fitted the errors grow little by little, so that each drawing stays on the assembly it is one of; it does
    not close where it comes to a dead point on its way."""
    near: Mapping[str, Value] = method.near
    senses = replay(method.position, Plot(method.facts(), near)).senses if method.fits else {}
    for part in np.linspace(0, 1, _STAGES + 1)[1:] if method.fits else (1.0,):
        plot = replay(method.position, Plot(_on_paper(method, pencil.times(float(part)), slips), near))
        astray = reduce(np.logical_or, (plot.senses[name] != sense for name, sense in senses.items()), np.False_)
        for table in (plot.position, plot.theta, plot.s) if np.any(astray) else ():
            table.update({name: np.where(astray, np.nan, value) for name, value in table.items()})
        near = turned(method, plot)
    return plot


def _on_paper(method: Method, pencil: Pencil, slips: Slips) -> Facts:
    """Dimensions and drivers as they get onto the paper."""
    facts, length = method.facts(), pencil.lengths["position"]
    lines: dict[str, tuple[str, str, Value]] = {}
    for slide, (guide, origin, direction) in facts.lines.items():
        turned = pencil.angle * slips.of(Mark("position", "guide", (slide,)))
        lines[slide] = guide, origin, direction * np.exp(1j * turned)
    values = []
    for driver, value in zip(method.drivers, facts.values, strict=True):
        error = length if driver.kind == "slide" else pencil.angle
        values.append(value + error * slips.of(Mark("position", "driver", (driver.name,))))
    shapes: dict[str, dict[str, Value]] = {}
    for link in facts.shapes:  # in its axes: from its first point the second at a length, every other at two
        shape: dict[str, Value] = dict(facts.shapes[link])
        points = list(shape)
        on_axis = points[1] if link != facts.frame and len(points) > 1 else ""
        for point in points[1:]:
            mark = Mark("position", "point", (link, point))
            across = 0.0 if point == on_axis else slips.of(mark, 1)
            shape[point] = shape[point] + length * (slips.of(mark) + 1j * across)
        shapes[link] = shape
    # a replay takes arrays over drawings where facts have single numbers
    drawn = {"shapes": shapes, "lines": lines, "values": tuple(values)}
    return replace(facts, **cast(Mapping[str, Never], drawn))


class PencilHand(Mistaken):
    """Draws and reads with a pencil, whatever is drawn, right or with mistakes.

    given  the dimensions as the problem has them
    """

    def __init__(self, pencil: Pencil, slips: Slips, given: Facts, columns: Sequence[Sequence[Rewrite]]) -> None:
        super().__init__(columns, (slips.count,))
        self.pencil, self.slips, self.given = pencil, slips, given

    def arrow(self, plot: Redrawing, plane: Plane, size: terms.Size, right: Value) -> Value:
        """Calculated from what was read, then laid off in a length and a direction."""
        right = super().arrow(plot, plane, size, right)
        match size:
            case terms.Drawn():
                return right
            case terms.Coriolis(_, tail, head):  # by a length of the velocity polygon that is read wrong
                length, error = np.abs(plot.velocity[head] - plot.velocity[tail]), self.pencil.lengths["velocity"]
                if np.any(length > _NO_ARROW * error):
                    slip = self.slips.of(Mark("velocity", "reading", (tail, head)))
                    right = right * (1 + error * slip / np.where(length > _NO_ARROW * error, length, np.inf))
            case terms.Turning() | terms.Normal() | terms.Tangential() | terms.Relative():
                right = right * self._given_part(plot, size.link, size.tail, size.head)
            case terms.Driven() | terms.Span():
                pass
            case _:
                assert_never(size)
        return self._with_slips(plane, "arrow", called(size), right)

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        right = super().line(plot, plane, step, ray, right)
        mark = Mark(plane, "line", (ray.through, *called(ray.direction)))
        return right * np.exp(1j * self.pencil.angle * self.slips.of(mark))

    def corner(self, plot: Redrawing, plane: Plane, step: Image, right: Value) -> Value:
        """The similar figure, its new point at an angle and a length from one of the old."""
        right = super().corner(plot, plane, step, right)
        base = plot.points(plane)[step.base[0]]
        return base + self._with_slips(plane, "image", (step.point,), right - base)

    def read(self, plot: Redrawing, plane: Plane, step: Measure, right: Real) -> Real:
        right = super().read(plot, plane, step, right)
        slip = self.pencil.lengths[plane] * self.slips.of(Mark(plane, "reading", (step.tail, step.head)))
        if step.quantity not in ("omega", "alpha"):
            return right + slip
        arm = np.abs(plot.arm(*step.lever))
        return (right + slip / arm) / self._given_part(plot, step.of, *step.lever)

    def _with_slips(self, plane: Plane, what: str, of: tuple[str, ...], right: Value) -> Value:
        """An arrow with errors in its length and its direction; one of no length is not drawn."""
        mark, error = Mark(plane, what, of), self.pencil.lengths[plane]
        length = np.abs(right)
        if not np.any(length > _NO_ARROW * error):
            return right
        longer = error * self.slips.of(mark) / np.where(length > _NO_ARROW * error, length, np.inf)
        return right * (1 + longer) * np.exp(1j * self.pencil.angle * self.slips.of(mark, 1))

    def _given_part(self, plot: Redrawing, link: str, tail: str, head: str) -> Real:
        """The length as the problem gives it to that on the paper; 1 where it is read off the paper."""
        shape = self.given.shapes.get(link, {})
        if tail not in shape or head not in shape:
            return 1.0
        part: Real = abs(shape[head] - shape[tail]) / np.abs(plot.arm(tail, head))
        return part


def called(of: terms.Size | terms.Direction) -> tuple[str, ...]:
    """An arrow or a direction as marks name it: its kind with the points or slides it is made of."""
    kind = type(of).__name__
    match of:
        case terms.Span(parts):
            return kind, *(str(part) for part in parts)
        case terms.Driven(slide, _) | terms.AlongGuide(slide) | terms.AcrossGuide(slide):
            return kind, slide
        case terms.Drawn(tail, head) | terms.Along(tail, head) | terms.Across(tail, head):
            return kind, tail, head
        case terms.Turning() | terms.Normal() | terms.Tangential() | terms.Coriolis() | terms.Quarter():
            return kind, of.link, of.tail, of.head
        case terms.Relative(link, seen_from, tail, head, part):
            return kind, link, seen_from, tail, head, part
        case _:
            assert_never(of)
