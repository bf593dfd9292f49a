"""A student who draws on a printed sheet with pencil and ruler, right or with a mistake or a slip: the page as a raster,
and where the corners truly are.

All is seeded. The student's ruler errs, too: what counts is where the drawn lines cross. Nothing of the reader of
photographs is used here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property, lru_cache
from itertools import pairwise

import cv2
import numpy as np
import resvg_py

import graphkin
from graphkin.base.geometry import Value
from graphkin.construction import Construction, Given, Image, LayOff, Meet, Plane, Ray
from graphkin.handouts.grid import markers_svg, room_svg
from graphkin.handouts.problem import HandoutProblem, drawn_problem
from graphkin.handouts.worksheet import room
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.pencil import Pencil, PencilHand, Slips, drawn_positions
from graphkin.marking.rewrite import Rewrite, Spot
from graphkin.photo.markers import MARKERS, SIZE, digits, edges
from graphkin.photo.sheets import SheetRoom

PER_MM = 16
_PAPER = 0.96  # how light it is
_PAGE = complex(210, 297)
_PLACES: Mapping[Plane, complex] = {"velocity": 25 + 24j, "acceleration": 25 + 152j}
_NUMBER = 31415
_SHORT = 0.3  # a shorter arrow is not drawn [mm]


@dataclass(frozen=True)
class Habits:
    """How a student draws. Lengths in mm.

    ruler, protractor  errors of lengths, of directions [deg]
    wobble   of the hand beside the ruler; width, dark: of strokes, least and most
    beyond   how far lines go on beyond where they cross, at the most; letters, erased, remarks: how many there are
    """

    ruler: float = 0.12
    protractor: float = 0.15
    wobble: float = 0.0
    width: tuple[float, float] = (0.3, 0.55)
    dark: tuple[float, float] = (0.45, 0.8)
    beyond: float = 15.0
    erased: int = 2
    remarks: int = 2
    sides: float = 0.85
    """How often a line between two points of a link's figure is drawn."""


NEAT, HAND = Habits(), Habits(wobble=0.1)


@dataclass(frozen=True)
class PrintedPaper:
    """A sheet with a room for each polygon, as it comes out of the printer."""

    problem: HandoutProblem

    @property
    def planes(self) -> tuple[Plane, ...]:
        return ("velocity", "acceleration")

    @cached_property
    def rooms(self) -> dict[Plane, SheetRoom]:
        rooms: dict[Plane, SheetRoom] = {}
        for plane, low in _PLACES.items():
            grid = room(self.problem, plane)
            assert grid.width <= 160
            assert grid.height <= 120
            high = low + complex(grid.width, grid.height)
            rooms[plane] = SheetRoom(plane, 1, low + grid.pole, low, high, grid.scale, grid.direction)
        return rooms

    @cached_property
    def light(self) -> np.ndarray:
        """The page (rows, columns), 0 to 255."""
        page = _without_rooms().copy()
        for plane, low in _PLACES.items():
            drawn = _rendered(room_svg(room(self.problem, plane)))
            rows, columns = (round(PER_MM * at) for at in (low.imag, low.real))
            there = page[rows : rows + drawn.shape[0], columns : columns + drawn.shape[1]]
            np.minimum(there, drawn, out=there)
        return page


@cache
def _without_rooms() -> np.ndarray:
    """The page with nothing but its markers, the same for every paper."""
    page = _rendered(markers_svg(_PAGE.real, _PAGE.imag))
    for at, id in zip(edges(_PAGE.real, _PAGE.imag), digits(_NUMBER)):
        side = round(SIZE * PER_MM)
        cells = np.zeros((6, 6), np.uint8)  # a black rim about four rows of four bits
        cells[1:5, 1:5] = [[255 * (MARKERS[id] >> (15 - 4 * row - k) & 1) for k in range(4)] for row in range(4)]
        rows, columns = (round(PER_MM * place) for place in (at.imag, at.real))
        page[rows : rows + side, columns : columns + side] = cv2.resize(cells, (side, side), interpolation=cv2.INTER_NEAREST)
    return page


@lru_cache(16)
def paper_of(mechanism: str) -> PrintedPaper:
    return PrintedPaper(drawn_problem(graphkin.load(mechanism), "en"))


_LIGHTS = np.arange(256, dtype=np.uint8)


def _printed(light: np.ndarray, left: np.ndarray | float = 1.0) -> np.ndarray:
    """What is printed on paper that is not quite white, `left` of it under a pencil."""
    return np.clip(light.astype(np.float32) * (_PAPER / 255) * left * 255, 0, 255).astype(np.uint8)


def _rendered(svg: str) -> np.ndarray:
    png = bytes(resvg_py.svg_to_bytes(svg_string=svg, background="white", dpi=25.4 * PER_MM))
    grey = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_GRAYSCALE)
    assert grey is not None
    return grey


class StudentHand(PencilHand):
    """Makes mistakes with a pencil that errs; and slips: an arrow or a direction times a factor."""

    slips_at: Mapping[Spot, complex] = {}

    def tip(self, plot: Redrawing, plane: Plane, step: LayOff, right: Value) -> Value:
        right, start = super().tip(plot, plane, step, right), plot.points(plane)[step.start]
        return start + (right - start) * self.slips_at.get(("laid", plane, step.tip), 1.0)

    def line(self, plot: Redrawing, plane: Plane, step: Meet, ray: Ray, right: Value) -> Value:
        return super().line(plot, plane, step, ray, right) * self.slips_at.get(("line", plane, step, ray), 1.0)


@dataclass(frozen=True)
class Work:
    """A student's drawing of one sheet.

    mistakes  made together; slips: factors of arrows and directions
    """

    paper: PrintedPaper
    seed: int
    mistakes: tuple[Rewrite, ...] = ()
    slips: Mapping[Spot, complex] = field(default_factory=dict)
    habits: Habits = NEAT

    @cached_property
    def corners(self) -> dict[Plane, dict[str, complex]]:
        """Where they truly are, by letter [mm from the pole, y up]."""
        method, scales = self.paper.problem.drawing.method, self.paper.problem.scales
        pencil = Pencil({plane: self.habits.ruler * scale for plane, scale in scales.items()},
                        float(np.radians(self.habits.protractor)))  # fmt: skip
        slips = Slips(self.seed, 1)
        hand = StudentHand(pencil, slips, method.facts(), [self.mistakes])
        hand.slips_at = self.slips
        with np.errstate(all="ignore"):
            plot = redraw(method, hand.placed(method, drawn_positions(method, pencil, slips)), hand, hand.shape)
        return {plane: {name: complex(np.ravel(place_)[0]) / scales[plane] for name, place_ in plot.points(plane).items()}
                for plane in self.paper.planes}  # fmt: skip

    def closes(self) -> bool:
        """True if its lines meet, as not every hand's do."""
        return all(np.isfinite(at) for points in self.corners.values() for at in points.values())

    def fits(self, edge: float = 2.0) -> bool:
        """True if all of it lies in its rooms."""
        for plane, points in self.corners.items():
            one = self.paper.rooms[plane]
            for at in points.values():
                there = one.pole + at.conjugate()
                inside = min((there - one.low).real, (there - one.low).imag, (one.high - there).real, (one.high - there).imag)
                if not inside > edge:
                    return False
        return True

    def page(self) -> np.ndarray:
        """The sheet with all that was drawn (rows, columns), 0 to 255."""
        page = cv2.LUT(self.paper.light, _printed(_LIGHTS))
        rng = np.random.default_rng([self.seed, 7])
        for plane in self.paper.planes:
            one, sheet = self.paper.rooms[plane], _Graphite(self.paper.rooms[plane], rng)
            self._draw(plane, sheet, rng)
            rows, columns = (round(PER_MM * at) for at in (one.low.imag, one.low.real))
            there = page[rows : rows + sheet.dark.shape[0], columns : columns + sheet.dark.shape[1]]
            printed = self.paper.light[rows : rows + sheet.dark.shape[0], columns : columns + sheet.dark.shape[1]]
            there[:] = _printed(printed, 1 - sheet.dark)
        return page

    def _draw(self, plane: Plane, sheet: _Graphite, rng: np.random.Generator) -> None:
        habits, at = self.habits, self.corners[plane]
        drawing = self.paper.problem.drawing.method
        construction = drawing.velocity if plane == "velocity" else drawing.acceleration
        dark, width = rng.uniform(*habits.dark), rng.uniform(*habits.width)
        reach = max(abs(place_) for place_ in at.values())

        def line(tail: complex, head: complex, darker: float = 1.0, wider: float = 1.0) -> None:
            sheet.stroke(tail, head, dark * darker * rng.uniform(0.85, 1.1), width * wider, habits.wobble)

        for _ in range(rng.integers(habits.erased + 1)):  # rubbed out: traces
            one, other = (reach * (rng.uniform(-1, 1) + 1j * rng.uniform(-1, 1)) for _ in range(2))
            line(one, other, 0.15)
        for tail, head, is_line in strokes(construction, rng, habits.sides):
            one, other = at[tail], at[head]
            if abs(other - one) < _SHORT:
                continue
            along = (other - one) / abs(other - one)
            if is_line:
                before, after = rng.uniform(0.0, 1.0) * habits.beyond * 0.4, rng.uniform(0.1, 1.0) * habits.beyond
                line(one - along * before, other + along * after, 0.75, 0.8)
            line(one, other)
            size = min(rng.uniform(2.0, 3.2), abs(other - one) / 2)
            for side in (-1, 1):
                line(other, other - size * along * np.exp(1j * side * np.radians(rng.uniform(14, 22))), 0.9)
        for place_ in {round(z.real, 2) + 1j * round(z.imag, 2) for z in at.values()}:
            sheet.scribble(place_ + rng.uniform(2.5, 4.5) * np.exp(2j * np.pi * rng.uniform()), dark)
        for _ in range(rng.integers(habits.remarks + 1)):  # a number of an intermediate result
            start = reach * (rng.uniform(-1, 1) + 1j * rng.uniform(-1, 1))
            for k in range(rng.integers(3, 7)):
                sheet.scribble(start + 3.0 * k, dark)


def strokes(construction: Construction, rng: np.random.Generator, sides: float) -> Iterator[tuple[str, str, bool]]:
    """Tail and head of what is drawn; True where the arrow is found on a line that goes on."""
    pole, drawn = construction.pole, set[frozenset[str]]()
    resting = {name for step in construction.steps if isinstance(step, Given) for name in step.also}
    laid = [step.term for step in construction.steps if isinstance(step, LayOff)]
    for term in construction.vectors().values():
        pair = frozenset(pole if name in resting else name for name in (term.tail, term.head))
        if len(pair) == 2 and pair not in drawn and (term.size is None or term in laid):
            drawn.add(pair)
            tail, head = (pole if name in resting else name for name in (term.tail, term.head))
            yield tail, head, term.size is None
    for step in construction.steps:
        if isinstance(step, Image):
            pairs = [(pole, step.point), (step.base[0], step.point), (step.base[1], step.point)]
            for k, (tail, head) in enumerate(pairs):
                tail = pole if tail in resting else tail
                pair = frozenset((tail, head))
                if pair not in drawn and (k == 0 or rng.uniform() < sides):
                    drawn.add(pair)
                    yield tail, head, False
    for name, node in construction.nodes.items():
        pair = frozenset((pole, name))
        if node.site is not None and name not in resting and pair not in drawn and name != pole and rng.uniform() < 0.5:
            yield pole, name, False


class _Graphite:
    """What a pencil leaves in a room; places in mm from the pole, y up."""

    def __init__(self, one: SheetRoom, rng: np.random.Generator) -> None:
        self.off, self.rng = one.pole - one.low, rng
        size = one.high - one.low
        self.dark = np.zeros((round(size.imag * PER_MM), round(size.real * PER_MM)), np.float32)
        grain = rng.normal(1.0, 0.35, (self.dark.shape[0] // 2 + 1, self.dark.shape[1] // 2 + 1)).astype(np.float32)
        grain = cv2.GaussianBlur(grain, (0, 0), 0.7)
        self.grain = np.clip(cv2.resize(grain, self.dark.shape[::-1]), 0.2, 1.6)

    def stroke(self, tail: complex, head: complex, dark: float, width: float, wobble: float) -> None:
        """A line along a ruler; its middle is a straight line but for the wobble."""
        length = abs(head - tail)
        if length < 0.05:
            return
        one, other = (self.off + at.conjugate() for at in (tail, head))
        ends = [(round(at.real * PER_MM), round(at.imag * PER_MM)) for at in (one, other)]
        thick = round((width + 6 * wobble + 0.4) * PER_MM)
        x0, y0 = (max(0, min(both) - thick) for both in zip(*ends))
        x1, y1 = (min(most, max(both) + thick) for most, both in zip(self.dark.shape[::-1], zip(*ends)))
        if x1 <= x0 or y1 <= y0:
            return
        band = np.zeros((y1 - y0, x1 - x0), np.uint8)
        cv2.line(band, *((x - x0, y - y0) for x, y in ends), 1, thick)
        found = cv2.findNonZero(band)
        if found is None:
            return
        x, y = found.reshape(-1, 2).T
        x, y = x + x0, y + y0
        own = ((x + 0.5) / PER_MM + 1j * (y + 0.5) / PER_MM - one) * ((other - one) / length).conjugate()
        knots = np.arange(-1, int(length / 12) + 4)
        sway = np.interp(own.real, knots * 12.0, wobble * self.rng.normal(size=len(knots)))
        press = np.interp(own.real, knots * 12.0, self.rng.uniform(0.75, 1.1, len(knots)))
        across = np.clip((width / 2 - np.abs(own.imag - sway)) * PER_MM / 2 + 0.5, 0, 1)
        ends_at = np.clip((own.real + width / 2) * PER_MM + 0.5, 0, 1) * np.clip((length + width / 2 - own.real) * PER_MM + 0.5, 0, 1)
        new = np.clip(dark * press * across * ends_at * self.grain[y, x], 0, 0.95).astype(np.float32)
        self.dark[y, x] = 1 - (1 - self.dark[y, x]) * (1 - new)

    def scribble(self, at: complex, dark: float) -> None:
        """A letter."""
        places = [at + complex(*self.rng.uniform(-1.3, 1.3, 2)) for _ in range(self.rng.integers(3, 6))]
        for one, other in pairwise(places):
            self.stroke(one, other, dark, 0.35, 0.0)


@dataclass(frozen=True)
class FlatPage:
    """A raster that is measured without any camera."""

    light: np.ndarray
    rms: float = 0.0
    per_mm: float = PER_MM

    @cached_property
    def soft(self) -> np.ndarray:
        return cv2.GaussianBlur(self.light, (0, 0), 0.05 * self.per_mm)

    def darkness(self, places: np.ndarray) -> np.ndarray:
        at = places * self.per_mm - (0.5 + 0.5j)
        found = cv2.remap(self.soft, at.real.astype(np.float32), at.imag.astype(np.float32), cv2.INTER_LINEAR,
                          borderValue=255)  # fmt: skip
        return np.asarray(1 - found.astype(np.float32) / (255 * _PAPER))
