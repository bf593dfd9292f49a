"""The velocity and the acceleration polygon: pole, points, arrows, images, and their letters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from itertools import chain

import numpy as np

from graphkin.base import geometry
from graphkin.base.boxes import free_about
from graphkin.base.geometry import place
from graphkin.base.lines import hull, in_line
from graphkin.base.value import frozen
from graphkin.construction import LETTER, Construction, Drawn, Plot, Site
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.planning.at_rest import relabelled
from graphkin.planning.images import imaged_gears
from graphkin.planning.method import rate_found
from graphkin.planning.polygon_arrows import Arrow, arrows
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import Label, Run, joined, number, plain, point_label, vector_label
from graphkin.sheet.marks import Disc, Mark, Place, PointMark, Shows, Stroke, VectorMark
from graphkin.sheet.window import Entry, Figure, Window

_UNITS = {"velocity": "m/s", "acceleration": "m/s²"}
_LEAST = 0.4  # a circle smaller than this is a point [mm]


@frozen
class GearImage:
    """One gear in the velocity plane: centre and radius [m/s], the polygon's point there, when it can be drawn."""

    label: Label
    at: complex
    radius: float
    centre: str
    step: int | None

    @property
    def corners(self) -> tuple[complex, complex]:
        return self.at + self.radius * (1 + 1j), self.at - self.radius * (1 + 1j)


def gear_images(method: Method, plot: Plot) -> Iterator[GearImage]:
    """Every gear that the polygon shows, once."""
    start = next((act.page for act in method.acts if act.plane == "velocity"), None)
    for wheel, name, centre in imaged_gears(method):
        if centre in plot.velocity:
            radius, at = abs(geometry.number(plot.omega[wheel.link])) * wheel.radius, plot.velocity[centre]
            step = rate_found(method, "velocity", wheel.link) or start
            yield GearImage(point_label(name), geometry.place(at), radius, centre, step)


def gear_circles(images: Sequence[GearImage], window: Window, others: Sequence[Sequence[Place]]) -> Iterator[Entry]:
    """Thin circles with their letters, each where it is far from other lines; circles that lie on one another are
    one."""
    drawn = dict[tuple[Place, float], list[GearImage]]()
    for image in sorted(images, key=lambda image: image.step or 0):
        at, radius = window(image.at), image.radius / window.scale
        same = (ring for ring in drawn if max(abs(ring[0] - at), abs(ring[1] - radius)) < _SAME)
        drawn.setdefault(next(same, (at, radius)), []).append(image)
    for (at, radius), own in drawn.items():
        if radius >= _LEAST:
            rim = at + radius * np.exp(1j * np.radians(np.arange(15, 360, 30)))
            rims = [abs(abs(rim - centre) - other) for centre, other in drawn if (centre, other) != (at, radius)]
            spot = complex(rim[np.min([*rims, free_about(rim, others, 9.0)], axis=0).argmax()])
            yield Disc(at, radius, "thin", step=own[0].step)
            names = dict.fromkeys((image.label, image.step) for image in own)
            yield _named_together([*names], spot, 0.4, (spot - at) / radius)


def _named_together(names: Sequence[tuple[Label, int | None]], at: Place, gap: float, away: complex) -> LabelRequest:
    """The label of what has several names, each of which joins at its own step."""
    parts = [names[0], *((joined([(), label]), step) for label, step in names[1:])]
    label, steps = tuple(run for part, _ in parts for run in part), {step for _, step in parts}
    return LabelRequest(label, at, gap=gap, away=away, step=parts[0][1], parts=tuple(parts) if len(steps) > 1 else ())


_SAME = 0.15  # closer than this two points are one on paper [mm]
_LETTERS = 8  # of the points in one place so many are lettered at most
_NAMES = 4  # so many names an arrow bears; others are read from the letters at its head
_NOTHING = 0.1  # shorter arrows are points [mm]
_EXACT = 5  # arrows whose ends are the same to so many digits of a millimetre are one


@frozen
class PolygonFigure:
    """One plane's polygon through a window.

    born    the act in which each of its points is found; gears: images
    solving whether arrows that the construction finds are told from those it starts from
    held    how points that drivers at rest hold are written, and their letters: they are fixed points
    left_out  the head of an arrow that is drawn broken, and the piece that is not drawn [SI]
    """

    mechanism: Mechanism
    construction: Construction
    plot: Plot
    window: Window
    born: Mapping[str, int]
    gears: list[GearImage] = field(default_factory=list)
    solving: bool = False
    held: Mapping[str, str] = field(default_factory=dict)
    left_out: Mapping[str, complex] = field(default_factory=dict)

    @cached_property
    def points(self) -> dict[str, Place]:
        """Every point of the polygon on paper, the pole first."""
        values = self.plot.points(self.construction.plane)
        names = dict.fromkeys((self.construction.pole, *self.construction.nodes))
        return {name: self.window(place(values[name]) - self.left_out.get(name, 0)) for name in names if name in values}

    @property
    def named(self) -> dict[str, Place]:
        """The points that are somebody's."""
        return {name: at for name, at in self.points.items() if self.of(name)}

    def of(self, name: str) -> str:
        return "pole" if name == self.construction.pole else self.construction.nodes[name].of

    def step(self, *names: str) -> int | None:
        return max((self.born[name] for name in names if name in self.born), default=None)

    def vectors(self) -> Iterator[VectorMark]:
        """Its arrows on paper; those with the same ends are one, which bears all their names."""
        for one, *others in self._shared.values():
            start, end, step = self.points[one.tail], self.points[one.head], self.step(one.tail, one.head)
            sizes = [arrow.size for arrow in (one, *others) if arrow.of_equation] if self.solving else []
            thin = bool(sizes) and None not in sizes and not isinstance(sizes[0], Drawn)
            named = {arrow.name.replace("^", "_") for arrow in (one, *others) if self.solving}
            yield VectorMark(
                self.construction.plane, one.name, one.tail, one.head, start, end, step,
                sites=tuple(map(named_site, one.sites)), also=tuple(other.name for other in others), part=one.part,
                solved=None in sizes, pen="asked" if named & self._asked else "laid" if thin else "vector",
                broken=abs(self.left_out.get(one.head, 0)) / self.window.scale,
            )  # fmt: skip

    @cached_property
    def _asked(self) -> set[str]:
        """The arrows that the problem asks for, as `v_C`, `a_k_B3B2`."""
        asked = {text.replace(" ", "_") for text in self.mechanism.ask}
        return asked | {name.replace("v_r_", "v_") for name in asked}

    @cached_property
    def _shared(self) -> dict[tuple[str, str], list[Arrow]]:
        """Arrows that have the same ends, as of points that move alike, by tail and head of the one found first."""
        groups: dict[tuple[object, ...], list[Arrow]] = {}
        every = list(arrows(self.mechanism, self.construction, self.points))
        named = {(self.written(arrow.name), arrow.head) for arrow in every if arrow.of_equation}
        for arrow in every:
            if not arrow.of_equation and (arrow.name, arrow.head) in named:
                continue  # an absolute motion that bears the name of an equation's arrow, seen from a held point
            start, end = self.points[arrow.tail], self.points[arrow.head]
            ends = tuple(round(side, _EXACT) for place in (start, end) for side in (place.real, place.imag))
            groups.setdefault(ends if abs(end - start) >= _NOTHING else (arrow.tail, arrow.head), []).append(arrow)
        alike = (sorted(group, key=lambda arrow: self.step(arrow.tail, arrow.head) or 0) for group in groups.values())
        return {(group[0].tail, group[0].head): group for group in alike}

    def names(self, vector: VectorMark) -> list[tuple[Label, int | None]]:
        """The names that are written at an arrow, and the step with which each comes."""
        first, *others = self._shared[vector.tail, vector.head]
        ranked = sorted(others, key=lambda one: one.name not in self._carried)
        ranked.sort(key=lambda one: one.name.replace("^", "_") not in self._asked)
        most = [first, *ranked[: _NAMES - 1]]
        names = [(vector_label(self.written(one.name)), self.step(one.tail, one.head)) for one in (first, *others)
                 if one in most]  # fmt: skip
        more = [(plain("\u2026"), names[-1][1])] if len(others) >= _NAMES else []
        if vector.broken:
            unit, size = _UNITS[self.construction.plane], (vector.length + vector.broken) * self.window.scale
            more.append(((*number(size), Run(f" {unit}")), names[-1][1]))
        return [names[0], *(((Run(" = "), *label), step) for label, step in names[1:] + more)]

    @cached_property
    def _carried(self) -> set[str]:
        """The motions from which equations find those of other points."""
        plane, equations = self.construction.plane, self.construction.equations
        terms = ((equation.of, term) for equation in equations for term in equation.left + equation.right)
        return {term.name(plane) for of, term in terms if term.of != of and not term.seen_from}

    def letters(self, name: str) -> str:
        """The name of a point on paper: `d` of `d7` where a driver at rest holds D."""
        of = self.of(name)
        return self.held[of].lower() + name[len(of) :] if of in self.held else name

    def written(self, name: str) -> str:
        """The name of an arrow on paper."""
        plane, term = self.construction.plane, self.construction.vectors().get(name) if self.held else None
        return relabelled(term, plane, self.held).name(plane) if term is not None else name

    def images(self) -> Iterator[tuple[str, list[str]]]:
        """Points of the polygon that are the image of a link of three or more points."""
        pole = self.construction.pole
        sites = {n.site: name for name, n in self.construction.nodes.items() if n.site is not None}
        for link in self.mechanism.moving:
            names: list[str] = []
            for point in self.mechanism.named(link):
                owners = self.mechanism.owners[point]
                own = (name for site, name in sites.items() if site.point == point and site.link in owners)
                names += [name for name in ([pole] if FRAME in owners else own) if name in self.points][:1]
            if len(set(names)) > 2:
                yield link, list(dict.fromkeys(names))


def named_site(site: Site) -> str:
    """`B@3`: no point has an `@` in its name."""
    return f"{site.point}@{site.link}"


def polygon_figure(polygon: PolygonFigure) -> Figure:
    """Images as thin lines, then arrows, then points."""
    vectors, plane = list(polygon.vectors()), polygon.construction.plane
    ends = [*((vector.start, vector.end) for vector in vectors), *((at, at) for at in polygon.named.values())]
    rims = Figure.of(gear_circles(polygon.gears, polygon.window, ends))
    marks = [*_image_lines(polygon, vectors), *rims.marks, *vectors]
    sites = {name: named_site(node.site) for name, node in polygon.construction.nodes.items() if node.site is not None}
    for name, at in polygon.named.items():  # no site has the pole, or a corner between arrows
        of, step = polygon.of(name), polygon.step(name)
        marks.append(PointMark(plane, name, of, at, step=step, site=sites.get(name, "")))
    return Figure(marks, [*_point_names(polygon), *_vector_names(polygon, vectors), *rims.wanted])


def _image_lines(polygon: PolygonFigure, vectors: list[VectorMark]) -> Iterator[Mark]:
    """Sides of the images along which no arrow lies."""
    drawn = {frozenset((v.tail, v.head)) for v in vectors}
    for link, names in polygon.images():
        places = [polygon.points[name] for name in names]
        around, ends = hull(places), in_line(places)  # ends: of points on one line
        for a, b in [ends] if ends is not None else zip(around, (*around[1:], around[0]), strict=True):
            pair = frozenset((names[a], names[b]))
            if pair not in drawn and abs(places[a] - places[b]) > _SAME:
                drawn.add(pair)
                shows = Shows(link, "bar", (names[a], names[b]), plane=polygon.construction.plane)
                yield Stroke((places[a], places[b]), "thin", shows=shows, step=polygon.step(*names))


def _point_names(polygon: PolygonFigure) -> Iterator[LabelRequest]:
    """A label for each place: points that lie on one another share it, the pole first; each joins at its own step."""
    places = dict[Place, list[str]]()
    for name, at in polygon.named.items():
        same = (there for there in places if abs(there - at) < _SAME)
        places.setdefault(next(same, at), []).append(name)
    middle = sum(polygon.points.values()) / max(1, len(polygon.points))
    points = [image for image in polygon.gears if image.radius / polygon.window.scale < _LEAST]
    pole, nodes = polygon.construction.pole, polygon.construction.nodes
    for at, names in places.items():
        labels = dict[Label, int | None]()
        if pole in names:  # no corners that are the pole
            off = {name for name in names if round(abs(polygon.points[name] - at), _EXACT)}
            names = [name for name in names if name == pole or name in off or nodes[name].site]
        for name in sorted(names, key=lambda name: polygon.step(name) or 0):
            labels.setdefault(point_label(polygon.letters(name)), polygon.step(name))
        gears = ((image.label, image.step) for name in names for image in points if image.centre == name)
        every = [*labels.items(), *dict.fromkeys(gears)]
        every = every if len(every) <= _LETTERS else [*every[: _LETTERS - 1], (plain("…"), every[_LETTERS - 1][1])]
        yield _named_together(every, at, 0.5, at - middle)


def _vector_names(polygon: PolygonFigure, vectors: list[VectorMark]) -> Iterator[LabelRequest]:
    """A label for each arrow that has a length: the ends of others share their letters."""
    middle = sum(polygon.points.values()) / max(1, len(polygon.points))
    names = {vector.name: polygon.written(vector.name) for vector in vectors}
    twice = {name for name, written in names.items() if written != name and written in names}
    letter, construction = LETTER[polygon.construction.plane], polygon.construction
    terms = {*construction.vectors(), *(f"{letter}_{equation.of}" for equation in construction.equations)}
    for vector in vectors:
        if vector.length < _SAME or vector.name in twice:
            continue
        absolute = vector.tail == polygon.construction.pole and vector.head in polygon.named
        spare = absolute and vector.name == f"{letter}_{polygon.of(vector.head)}"  # the letter at its head says as much
        rank = 1 + (vector.name in terms) if spare and not vector.broken and vector.pen != "asked" else 0
        own, away = polygon.names(vector), (vector.start + vector.end) / 2 - middle
        label, parts = tuple(chain.from_iterable(name for name, _ in own)), tuple(own) if own[1:] else ()
        yield LabelRequest(label, vector.start, vector.end, away=away, step=vector.step, spare=rank, of=vector.name,
                           parts=parts)  # fmt: skip
