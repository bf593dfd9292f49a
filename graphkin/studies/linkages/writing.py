"""A mechanism of links, slides and drivers as a file for people: text that `loading` reads and `draw` draws."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.model.pairs import Slide
from graphkin.studies.linkages.assembled import ahead_on


def filed(machine: Mechanism, notes: Sequence[str] = ()) -> Mechanism:
    """The mechanism with its file as its text; notes: lines at the head of the file."""
    return replace(machine, text="\n".join(_lines(machine, notes)) + "\n")


def _lines(machine: Mechanism, notes: Sequence[str]) -> Iterator[str]:
    named, fixed = set(machine.points), machine.links[FRAME].points
    titles = ", ".join(f"{lang} = {_quoted(title)}" for lang, title in machine.title.items())
    yield from (f"# {note}" for note in notes)
    yield from (f"title = {{ {titles} }}", "", "[frame]", f"name = {_quoted(machine.frame)}")
    yield from (f"{_key(point)} = {_pair(place)}" for point, place in fixed.items() if point in named)
    for link in machine.moving:
        yield from ("", f"[links.{_key(link)}]", _link(machine.links[link].points))
    for slide in machine.slides:
        yield from ("", "[[slide]]", *(f"{key} = {value}" for key, value in _slide(machine, slide).items()))
    for driver in machine.drivers:
        yield from ("", "[[driver]]", *(f"{key} = {value}" for key, value in _driver(driver).items()))
    if machine.sketch:
        yield from ("", "[sketch]", *(f"{_key(point)} = {_pair(place)}" for point, place in machine.sketch.items()))
    if "length" in machine.scales:
        yield from ("", "[scales]", f"length = {machine.scales['length']:g}")


def _link(points: Mapping[str, complex]) -> str:
    """One point is listed, two have a distance, more have coordinates in the link's axes."""
    names = list(points)
    if len(names) < 2:
        return f"points = [{', '.join(map(_quoted, names))}]"
    if len(names) == 2:
        return f"{_key(names[0] + names[1])} = {_mm(abs(points[names[1]] - points[names[0]]))}"
    places = (f"{_key(name)} = {_pair(place)}" for name, place in points.items())
    return f"shape = {{ {', '.join(places)} }}"


def _slide(machine: Mechanism, slide: Slide) -> dict[str, str]:
    """A line of the frame has an angle to +x, one of another link goes towards a point of it."""
    table = {"name": _quoted(slide.name)} if slide.named else {}
    if slide.block is None:
        table["pin"] = _quoted(slide.point)
    else:
        table |= {"block": _quoted(slide.block), "point": _quoted(slide.point)}
    points, origin, along = machine.links[slide.guide].points, slide.line.origin, slide.line.direction
    table["guide"] = _quoted(slide.guide)
    table["through"] = _quoted(origin) if origin in machine.points else _pair(points[origin])
    if slide.guide == FRAME:
        table["angle"] = _degrees(math.atan2(along.imag, along.real))
    else:
        table["toward"] = _quoted(ahead_on(points, origin, along))
    if slide.block is not None:
        first = next(other for other in machine.slides if other.block == slide.block)
        if slide.block == FRAME or len(machine.links[slide.block].points) > 1 or first is not slide:
            table["tilt"] = _degrees(slide.tilt)  # the block has a direction of its own
    return table


def _driver(driver: Driver) -> dict[str, str]:
    value = driver.value or 0.0
    if driver.vector is None:
        table = {"slide": _quoted(driver.link), "at": _mm(value), "velocity": _rate(driver.rate)}
        return table | ({"acceleration": _rate(driver.acceleration)} if driver.acceleration else {})
    table = {"vector": _quoted("".join(driver.vector))}
    if driver.from_vector is not None:
        table["from"] = _quoted("".join(driver.from_vector))
    table |= {"angle": _degrees(value), "omega": _rate(driver.rate)}
    return table | ({"alpha": _rate(driver.acceleration)} if driver.acceleration else {})


def _quoted(text: str) -> str:
    """A TOML string."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else " " for c in escaped) + '"'


def _key(name: str) -> str:
    return name if name.isascii() and name.replace("_", "").isalnum() else _quoted(name)


def _mm(length: float) -> str:
    return f"{length * 1e3 + 0.0:.13g}"


def _pair(place: complex) -> str:
    return f"[{_mm(place.real)}, {_mm(place.imag)}]"


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle) + 0.0:.14g}"


def _rate(rate: float) -> str:
    return f"{rate + 0.0:.12g}"
