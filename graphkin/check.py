"""Proof: the drawing beside the analytic solution.

`compare` holds a replayed construction against the matrix method. `measure` takes a drawing file, lays a
ruler on its lines, solves the mechanism it carries anew by the matrix method, and compares; of the numbers
in the file it uses the scales and the drivers' values to know what the drawing claims, and nothing else.
"""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError

import numpy as np

from graphkin import loading
from graphkin.analytic import Motion, motion
from graphkin.errors import BadDrawing, NoDrawing, Where
from graphkin.geometry import Value, meet_lines
from graphkin.mechanism import FRAME, Mechanism
from graphkin.methods import Method, plan
from graphkin.naming import pair, seen
from graphkin.pairs import Line
from graphkin.readings import Readings, relative
from graphkin.seal import seal
from graphkin.steps import Across, AcrossGuide, Along, AlongGuide, Direction, Meet, Plane, Plot, Ray, Touch
from graphkin.value import frozen

__all__ = ["Fault", "Measured", "Report", "compare", "measure"]

LIMIT = 16 << 20
"""Larger drawings are not ours [bytes]."""


# --- a replay beside the analytic solution ----------------------------------------------------


def compare(method: Method, plot: Plot, exact: Motion) -> float:
    """The worst relative difference between a replay and the analytic solution.

    Each kind of quantity is measured by the largest of its kind in the mechanism, or by what the lengths and
    speeds make of it (an angular acceleration of 0 by omega^2); angles in radians.
    """
    readings, points = Readings(method, plot), method.mechanism.points
    links = {point: method.mechanism.owners[point][-1] for point in points}
    velocity = {point: readings.velocity_at(point, links[point]) for point in points}
    acceleration = {point: readings.acceleration_at(point, links[point]) for point in points}
    size, rate = _sizes(exact, points)
    pairs: list[tuple[Mapping[str, Value], Mapping[str, Value], float]] = [
        (readings.omega, exact.omega, rate),
        (readings.alpha, exact.alpha, rate**2),
        (readings.s, exact.s, size),
        (readings.s_rate, exact.s_rate, rate * size),
        (readings.s_acceleration, exact.s_acceleration, rate**2 * size),
        ({point: readings.position[point] for point in points}, exact.position, size),
        (velocity, exact.velocity, rate * size),
        (acceleration, exact.acceleration, rate**2 * size),
    ]
    turned = [np.abs(np.exp(1j * (readings.theta[link] - exact.theta[link])) - 1) for link in readings.theta]
    return max(float(np.max(turned, initial=0.0)), *(_worst(*entry) for entry in pairs))


def _sizes(exact: Motion, points: tuple[str, ...]) -> tuple[float, float]:
    """Extent of the mechanism [m] and its fastest rotation, or speed over extent [rad/s]."""
    places = np.array([exact.position[point] for point in points])
    size = float(np.max(np.abs(places - places[0]))) or 1.0
    speeds = [np.abs(v) / size for v in (*exact.velocity.values(), *exact.s_rate.values())]
    return size, float(np.max([*speeds, *(np.abs(w) for w in exact.omega.values())]))


def _worst(drawn: Mapping[str, Value], right: Mapping[str, Value], natural: float) -> float:
    if not drawn:
        return 0.0
    first = np.array([drawn[name] for name in drawn])
    second = np.array([right[name] for name in drawn])
    size = max(float(np.max(np.abs(second))), natural)
    off = float(np.max(np.abs(first - second)))
    return off / size if size > 0 else off


# --- a drawing file ---------------------------------------------------------------------------


@frozen
class Measured:
    """One vector or point of the drawing: what the ruler says, what it should be.

    drawn, exact  in mm on paper, x to the right and y up
    unit_per_mm   scale of its plane, in `unit` per mm
    """

    plane: Plane
    name: str
    kind: str
    drawn: complex
    exact: complex
    unit_per_mm: float
    unit: str

    @property
    def off_mm(self) -> float:
        return abs(self.drawn - self.exact)


@frozen
class Fault:
    """Something wrong with a drawing file that is no length.

    kind  "paper", "transform", "changed", "scale", "missing", "extra", "end", "loose"
    what  which element, and what about it
    """

    kind: str
    what: str


@frozen
class Report:
    """What a ruler finds in one drawing file.

    faults  what is wrong with it beyond lengths: a point that is not where its vector ends, a transform
    """

    file: str
    measured: tuple[Measured, ...]
    faults: tuple[Fault, ...]

    def passed(self, tolerance_mm: float) -> bool:
        return not self.faults and all(entry.off_mm <= tolerance_mm for entry in self.measured)

    def wrong(self, tolerance_mm: float) -> int:
        """How many things are wrong; a length that is no number is."""
        return sum(not entry.off_mm <= tolerance_mm for entry in self.measured) + len(self.faults)


@frozen
class _Widened:
    """The analytic solution, at points too that a construction adds: special points, rolling contacts."""

    mechanism: Mechanism
    motion: Motion
    added: Mapping[str, complex]

    @property
    def theta(self) -> Mapping[str, Value]:
        return self.motion.theta

    @property
    def omega(self) -> Mapping[str, Value]:
        return self.motion.omega

    @property
    def alpha(self) -> Mapping[str, Value]:
        return self.motion.alpha

    @property
    def s(self) -> Mapping[str, Value]:
        return self.motion.s

    @property
    def s_rate(self) -> Mapping[str, Value]:
        return self.motion.s_rate

    @property
    def s_acceleration(self) -> Mapping[str, Value]:
        return self.motion.s_acceleration

    @property
    def position(self) -> Mapping[str, Value]:
        return {**self.motion.position, **self.added}

    def velocity_at(self, point: str, link: str) -> Value:
        if point not in self.added or link == FRAME:
            return 0j if link == FRAME else self.motion.velocity_at(point, link)
        start = next(iter(self.mechanism.links[link].points))
        arm = self.added[point] - self.motion.position[start]
        return self.motion.velocity_at(start, link) + 1j * self.motion.omega[link] * arm

    def acceleration_at(self, point: str, link: str) -> Value:
        if point not in self.added or link == FRAME:
            return 0j if link == FRAME else self.motion.acceleration_at(point, link)
        start = next(iter(self.mechanism.links[link].points))
        arm = self.added[point] - self.motion.position[start]
        turn = 1j * self.motion.alpha[link] - self.motion.omega[link] ** 2
        return self.motion.acceleration_at(start, link) + turn * arm


def _added(mechanism: Mechanism, exact: Motion, drawing: _Drawing) -> Mapping[str, complex]:
    """Where the added points of a drawing lie by the analytic solution. What they are, the planner says."""
    named = [attributes.get("data-of", "") for attributes, _ in drawing.points]
    if all(name == "pole" or "^" in name or seen(mechanism, name) for name in named):
        return {}
    steps = [step for step in plan(mechanism).position.steps if isinstance(step, Touch | Meet)]
    places = {step.point: added_point(step, mechanism, exact) for step in steps}
    return {point: place for point, place in places.items() if place is not None}


def added_point(step: Touch | Meet, mechanism: Mechanism, exact: Motion) -> complex | None:
    """The special point or the rolling contact that a step gives, from positions of the analytic solution."""
    if isinstance(step, Touch):
        centre = complex(exact.position[step.centre])
        if step.slide:
            return centre + 1j * step.offset * _along(step.slide, mechanism, exact)
        return centre + step.ratio * (complex(exact.position[step.other]) - centre)
    rays = [ray for ray in (step.first, step.second) if isinstance(ray, Ray)]
    if step.point in mechanism.points or not step.point[0].isupper() or len(rays) != 2:
        return None
    first, second = ((exact.position[ray.through], _line(ray.direction, mechanism, exact)) for ray in rays)
    return complex(meet_lines(*first, *second)[0])


def _line(direction: Direction, mechanism: Mechanism, exact: Motion) -> complex:
    if isinstance(direction, AcrossGuide | AlongGuide):
        along = _along(direction.slide, mechanism, exact)
        return 1j * along if isinstance(direction, AcrossGuide) else along
    assert isinstance(direction, Along | Across)
    arm = complex(exact.position[direction.head] - exact.position[direction.tail])
    return arm / abs(arm) * (1j if isinstance(direction, Across) else 1)


def _along(slide: str, mechanism: Mechanism, exact: Motion) -> complex:
    """Direction of a sliding pair's line, a track, or the flat face of a cam."""
    lines: dict[str, Line | None] = {pair.name: pair.line for pair in mechanism.slides}
    lines |= {roll.name: roll.line for roll in mechanism.rolls}
    lines |= {f"c{k}": face.line for k, cam in enumerate(mechanism.cams) for face in cam.profiles if face.line}
    line = lines[slide]
    assert line is not None
    return complex(line.direction * np.exp(1j * exact.theta[line.link]))


UNITS: Mapping[Plane, str] = {"position": "m", "velocity": "m/s", "acceleration": "m/s^2"}
WRITTEN = re.compile(r"μ\s*([lva])\s*=\s*([0-9.]+(?:\s*[×·]\s*10[−+-]?[0-9]+)?)")
"""A scale as it is printed on the sheet: μ_v = 0.01 (m/s)/mm, or 2×10⁻⁵ with its exponent raised."""
SCALES: Mapping[Plane, str] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}


@frozen
class _Drawing:
    """A parsed drawing file: lines and circles in mm, y up, scales as written, and what the file claims to be."""

    file: str
    vectors: tuple[tuple[Mapping[str, str], complex, complex], ...]
    points: tuple[tuple[Mapping[str, str], complex], ...]
    written: tuple[tuple[str, str], ...]
    claims: Mapping[str, object]
    faults: tuple[Fault, ...]


def measure(path: str | Path, tolerance_mm: float = 0.01) -> Report:
    """Measure a drawing file against the analytic solution of the mechanism in it.

    Raises `BadDrawing` where the file is no drawing of graphkin's, and the errors of `loading` and
    `analytic` where the mechanism in it is none.
    """
    drawing = _read(Path(path))
    mechanism = _mechanism(drawing)
    solved = motion(mechanism, _numbers(drawing, "drivers", len(mechanism.drivers)))
    exact = _Widened(mechanism, solved, _added(mechanism, solved, drawing))
    scales = _scales(drawing)
    entries = [*_vectors(drawing, mechanism, exact, scales), *_points(drawing, mechanism, exact, scales)]
    faults = (*drawing.faults, *_changed(drawing, scales), *_loose_ends(drawing, tolerance_mm))
    return Report(drawing.file, tuple(entries), faults)


def _read(path: Path) -> _Drawing:
    from defusedxml.common import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    file = str(path)
    try:
        if path.stat().st_size > LIMIT:
            raise BadDrawing(Where(file), "large")
        root = fromstring(path.read_bytes())
    except FileNotFoundError:
        raise NoDrawing(Where(file)) from None
    except OSError as error:
        raise BadDrawing(Where(file), "unreadable", error.strerror or "") from error
    except (ParseError, DefusedXmlException, ValueError, LookupError, RecursionError) as error:
        raise BadDrawing(Where(file), "xml") from error
    if not root.tag.endswith("}svg"):
        raise BadDrawing(Where(file), "svg")
    return _parse(file, root)


def _parse(file: str, root: Element) -> _Drawing:
    vectors, points, written = [], [], list[tuple[str, str]]()
    faults = _paper(root)
    try:
        for element, moved in _walk(root):
            tag, kind = element.tag.rpartition("}")[2], element.get("class", "").split()
            if tag == "line" and "vector" in kind:
                vectors.append((element.attrib, _place(element, "x1", "y1"), _place(element, "x2", "y2")))
            elif tag == "circle" and "point" in kind:
                points.append((element.attrib, _place(element, "cx", "cy")))
            elif tag == "text" and (found := WRITTEN.search("".join(element.itertext()))):
                written.append((found[1], found[2]))
                continue
            else:
                continue
            if moved:
                faults.append(Fault("transform", str(element.get("data-name"))))
    except (KeyError, ValueError) as error:
        raise BadDrawing(Where(file), "element", str(error)) from error
    if not points:
        raise BadDrawing(Where(file), "points")
    return _Drawing(file, tuple(vectors), tuple(points), tuple(written), _claims(file, root), tuple(faults))


def _walk(root: Element) -> Iterator[tuple[Element, bool]]:
    """Every element, and whether a transform stands on it or above it."""
    stack = [(root, False)]
    while stack:
        element, moved = stack.pop()
        moved = moved or "transform" in element.attrib or "transform" in element.get("style", "")
        yield element, moved
        stack.extend((child, moved) for child in reversed(element))


def _place(element: Element, x: str, y: str) -> complex:
    place = complex(float(element.attrib[x]), -float(element.attrib[y]))
    if not (math.isfinite(place.real) and math.isfinite(place.imag)):
        raise ValueError("finite coordinates")
    return place


def _paper(root: Element) -> list[Fault]:
    """Whether one unit of the drawing is one millimetre on paper."""
    size = f"{root.get('width', '')} {root.get('height', '')}".split()
    box = root.get("viewBox", "").split()
    try:
        true = len(box) == 4 and [float(v) for v in box] == [0, 0, *(float(v.removesuffix("mm")) for v in size)]
    except ValueError:
        true = False
    return [] if true and all(v.endswith("mm") for v in size) else [Fault("paper", "")]


def _claims(file: str, root: Element) -> Mapping[str, object]:
    for element in root.iter():
        if element.tag.rpartition("}")[2] == "sheet" and element.text:
            try:
                claims = json.loads(element.text)
            except ValueError as error:
                raise BadDrawing(Where(file), "json") from error
            if isinstance(claims, dict) and claims.get("program") == "graphkin":
                return claims
    raise BadDrawing(Where(file), "metadata")


def _mechanism(drawing: _Drawing) -> Mechanism:
    text = drawing.claims.get("mechanism")
    if not isinstance(text, str):
        raise BadDrawing(Where(drawing.file), "mechanism")
    return loading.loads(text, name=Path(drawing.file).stem, file=f"{drawing.file} (mechanism)")


def _numbers(drawing: _Drawing, key: str, count: int) -> list[float]:
    given = drawing.claims.get(key)
    if not isinstance(given, list) or len(given) != count or not all(_is_number(v) for v in given):
        raise BadDrawing(Where(drawing.file), "value", key)
    return [float(v) for v in given]


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _scales(drawing: _Drawing) -> Mapping[Plane, float]:
    given = drawing.claims.get("scales")
    scales: dict[Plane, float] = {}
    for plane, key in SCALES.items():
        value = given.get(key) if isinstance(given, dict) else None
        if value is None and not any(attributes.get("data-plane") == plane for attributes, *_ in drawing.points):
            continue
        if not (_is_number(value) and isinstance(value, int | float) and value > 0):
            raise BadDrawing(Where(drawing.file), "value", f"scales.{key}")
        scales[plane] = float(value)
    return scales


def _plane(drawing: _Drawing, attributes: Mapping[str, str]) -> Plane:
    plane = attributes.get("data-plane", "")
    for known in UNITS:
        if plane == known:
            return known
    raise BadDrawing(Where(drawing.file), "value", f"data-plane={plane}")


def _vectors(
    drawing: _Drawing, mechanism: Mechanism, exact: _Widened, scales: Mapping[Plane, float]
) -> Iterator[Measured]:
    for attributes, tail, head in drawing.vectors:
        plane, name = _plane(drawing, attributes), attributes.get("data-name", "")
        value = _exact(mechanism, exact, plane, name)
        if value is None:
            raise BadDrawing(Where(drawing.file), "value", f"data-name={name}")
        yield Measured(plane, name, "vector", head - tail, value / scales[plane], scales[plane], UNITS[plane])


def _exact(mechanism: Mechanism, exact: _Widened, plane: Plane, name: str) -> complex | None:
    """What a vector called `v_CB`, `a^k_B3B2` or `v_DG+v_S4D` should be, from the analytic solution."""
    if "+" in name:
        parts = [_exact(mechanism, exact, plane, part) for part in name.split("+")]
        return sum((part for part in parts if part is not None), 0j) if None not in parts else None
    head, _, sites = name.partition("_")
    letter, _, part = head.partition("^")
    if letter != {"velocity": "v", "acceleration": "a"}.get(plane):
        return None
    if (site := seen(mechanism, sites, exact.added)) is not None and not part:
        at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
        return complex(at(site.point, site.link))
    if (both := pair(mechanism, sites, exact.added)) is None:
        return None
    value = relative(mechanism, exact, plane, part, *both)
    return None if value is None else complex(value)


def _points(
    drawing: _Drawing, mechanism: Mechanism, exact: _Widened, scales: Mapping[Plane, float]
) -> Iterator[Measured]:
    """Points of the mechanism against each other; points of a polygon against its pole."""
    for plane in dict.fromkeys(_plane(drawing, attributes) for attributes, _ in drawing.points):
        placed = [(a, place) for a, place in drawing.points if a.get("data-plane") == plane]
        wanted = {}
        for attributes, place in placed:
            value = _exact_point(mechanism, exact, plane, attributes.get("data-of", ""))
            if value is not None:
                wanted[attributes.get("data-name", "")] = (place, value / scales[plane])
        origin = _origin(list(wanted.values()))
        for name, (place, right) in wanted.items():
            yield Measured(plane, name, "point", place - origin, right, scales[plane], UNITS[plane])


def _exact_point(mechanism: Mechanism, exact: _Widened, plane: Plane, of: str) -> complex | None:
    if of == "pole":
        return 0j
    site = seen(mechanism, of, exact.added)
    if site is None:
        return None
    if plane == "position":
        return complex(exact.position[site.point])
    at = exact.velocity_at if plane == "velocity" else exact.acceleration_at
    return complex(at(site.point, site.link))


def _origin(pairs: list[tuple[complex, complex]]) -> complex:
    """Where zero lies on the paper, as the point with which most of the others agree has it."""
    origins = [place - right for place, right in pairs]
    return min(origins, key=lambda origin: sorted(abs(other - origin) for other in origins)[len(origins) // 2])


def _changed(drawing: _Drawing, scales: Mapping[Plane, float]) -> Iterator[Fault]:
    """What the file says of itself must be as it was when it was drawn, and the printed scales the same."""
    if drawing.claims.get("seal") != seal(drawing.claims):
        yield Fault("changed", "")
    letters: Mapping[str, Plane] = {"l": "position", "v": "velocity", "a": "acceleration"}
    for letter, text in dict.fromkeys(drawing.written):
        plane = letters[letter]
        if plane in scales and not _as_written(text, scales[plane]):
            yield Fault("scale", f"μ_{letter} = {text}")
    yield from _missing(drawing)


def _missing(drawing: _Drawing) -> Iterator[Fault]:
    """Every vector and point that was drawn must be there, once."""
    given = drawing.claims.get("drawn")
    told = given if isinstance(given, list) else []
    wanted = Counter(tuple(entry) for entry in told if isinstance(entry, list))
    kinds = (("vector", drawing.vectors), ("point", drawing.points))
    found = Counter((a.get("data-plane"), kind, a.get("data-name")) for kind, every in kinds for a, *_ in every)
    for plane, _, name in (wanted - found).elements():
        yield Fault("missing", f"{name} ({plane})")
    for plane, _, name in (found - wanted).elements():
        yield Fault("extra", f"{name} ({plane})")


def _as_written(text: str, scale: float) -> bool:
    mantissa, *power = re.split(r"\s*[×·]\s*10", text.replace("−", "-"))
    try:
        return math.isclose(float(mantissa) * 10.0 ** int(power[0] if power else 0), scale, rel_tol=1e-3)
    except ValueError:
        return False


def _loose_ends(drawing: _Drawing, tolerance_mm: float) -> Iterator[Fault]:
    """Vectors must start and end at the points they name."""
    places = {(a.get("data-plane"), a.get("data-name")): place for a, place in drawing.points}
    for attributes, tail, head in drawing.vectors:
        for key, end in (("data-tail", tail), ("data-head", head)):
            point, name = (attributes.get("data-plane"), attributes.get(key)), attributes.get("data-name")
            if point not in places:
                yield Fault("loose", f"{name}: {point[1]}")
            elif not abs(places[point] - end) <= tolerance_mm:
                yield Fault("end", f"{name} - {point[1]}: {abs(places[point] - end):.4f} mm")
