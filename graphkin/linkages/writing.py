"""Linkages as mechanism files: text that `loading` reads and `draw` draws."""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterator, Mapping, Sequence

from graphkin.errors import Lang
from graphkin.linkages.model import FourBar, GuideBar, Linkage, SliderCrank
from graphkin.value import frozen

__all__ = ["Draft", "as_mechanism", "free_names", "quoted"]


@frozen
class Draft:
    """What goes into a file, everything at the drawn position.

    frame, fixed   the frame's name and its points [m]
    links          the points of each moving link, where they are [m]
    slides, drivers   tables as key -> TOML text
    length_scale   [m/mm], or None
    """

    title: Mapping[Lang, str]
    notes: tuple[str, ...]
    frame: str
    fixed: Mapping[str, complex]
    links: Mapping[str, Mapping[str, complex]]
    slides: tuple[Mapping[str, str], ...]
    drivers: tuple[Mapping[str, str], ...]
    length_scale: float | None = None

    @property
    def text(self) -> str:
        """The file."""
        return "\n".join(self._lines()) + "\n"

    def _lines(self) -> Iterator[str]:
        yield from (f"# {note}" for note in self.notes)
        titles = ", ".join(f"{lang} = {quoted(title)}" for lang, title in self.title.items())
        yield from (f"title = {{ {titles} }}", "", "[frame]", f"name = {quoted(self.frame)}")
        yield from (f"{_key(point)} = {_pair(place)}" for point, place in self.fixed.items())
        for link, points in self.links.items():
            yield from ("", f"[links.{_key(link)}]", *_link(points))
        for table in self.slides:
            yield from ("", "[[slide]]", *(f"{key} = {value}" for key, value in table.items()))
        for table in self.drivers:
            yield from ("", "[[driver]]", *(f"{key} = {value}" for key, value in table.items()))
        moving = {p: z for points in self.links.values() for p, z in points.items() if p not in self.fixed}
        if moving:
            yield from ("", "[sketch]", *(f"{_key(point)} = {_pair(place)}" for point, place in moving.items()))
        if self.length_scale is not None:
            yield from ("", "[scales]", f"length = {self.length_scale:g}")


def _link(points: Mapping[str, complex]) -> Iterator[str]:
    """One point is listed, two have a distance, more have coordinates in axes of the first two."""
    names = list(points)
    if len(names) < 2:
        yield f"points = [{', '.join(quoted(name) for name in names)}]"
    elif len(names) == 2:
        yield f"{_key(names[0] + names[1])} = {_mm(abs(points[names[1]] - points[names[0]]))}"
    else:
        axis = points[names[1]] - points[names[0]]
        turn = abs(axis) / axis if axis else 1.0
        places = (f"{_key(name)} = {_pair((points[name] - points[names[0]]) * turn)}" for name in names)
        yield f"shape = {{ {', '.join(places)} }}"


def quoted(text: str) -> str:
    """A TOML string."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c.isprintable() else " " for c in escaped) + '"'


def _key(name: str) -> str:
    return name if name.isascii() and name.replace("_", "").isalnum() else quoted(name)


def _mm(length: float) -> str:
    return f"{length * 1e3 + 0.0:.13g}"


def _pair(place: complex) -> str:
    return f"[{_mm(place.real)}, {_mm(place.imag)}]"


def degrees(angle: float) -> str:
    """An angle as a file has it."""
    return f"{math.degrees(angle) + 0.0:.14g}"


def free_names(taken: Collection[str], count: int) -> list[str]:
    """Names of points that nobody has: P, Q, R, .., then P1, Q1, .."""
    letters = "PQRSTUVW"
    every = (f"{letter}{number or ''}" for number in range(len(taken) + count) for letter in letters)
    return [name for name in every if name not in taken][:count]


# --- linkages by their lengths --------------------------------------------------------------------


def as_mechanism(linkage: Linkage, omega: float = 10.0) -> str:
    """A file of the linkage at its drawn position: links 1, 2, 3, frame 4, driven at `omega` [rad/s] or 0.1 m/s."""
    match linkage:
        case FourBar():
            return _four_bar(linkage, omega).text
        case SliderCrank():
            return _slider(linkage, omega).text
        case GuideBar():
            return _guide(linkage, omega).text


_TITLES: dict[type, dict[Lang, str]] = {
    FourBar: {"en": "Four-bar linkage", "zh": "铰链四杆机构"},
    SliderCrank: {"en": "Slider-crank linkage", "zh": "曲柄滑块机构"},
    GuideBar: {"en": "Guide-bar linkage", "zh": "导杆机构"},
}


def _turning(vector: Sequence[str], direction: complex, omega: float) -> dict[str, str]:
    return {"vector": quoted("".join(vector)), "angle": degrees(cmath.phase(direction)), "omega": f"{omega:.12g}"}


def _four_bar(bar: FourBar, omega: float) -> Draft:
    (a, b, c, d), (pa, pb, pc, pd) = bar.names, bar.places
    driver = {
        "crank": _turning((a, b), pb - pa, omega), "coupler": _turning((b, c), pc - pb, omega),
        "rocker": _turning((d, c), pc - pd, omega),
    }[bar.driver]  # fmt: skip
    links = {"1": {a: pa, b: pb}, "2": {b: pb, c: pc}, "3": {d: pd, c: pc}}
    return Draft(_TITLES[FourBar], (), "4", {a: pa, d: pd}, links, (), (driver,))


def _slider(slider: SliderCrank, omega: float) -> Draft:
    if slider.block:
        return _fixed_block(slider, omega)
    (a, b, c), (pa, pb, pc) = slider.names, slider.places
    along = cmath.rect(1, slider.way)
    foot = pa + 1j * along * slider.offset
    slide = {
        "name": quoted("s"), "block": quoted("3"), "point": quoted(c), "guide": quoted("frame"),
        "through": _pair(foot), "angle": degrees(slider.way),
    }  # fmt: skip
    at = ((pc - foot) * along.conjugate()).real
    driver = {
        "crank": _turning((a, b), pb - pa, omega), "coupler": _turning((b, c), pc - pb, omega),
        "slider": {"slide": quoted("s"), "at": _mm(at), "velocity": "0.1"},
    }[slider.driver]  # fmt: skip
    links = {"1": {a: pa, b: pb}, "2": {b: pb, c: pc}, "3": {c: pc}}
    return Draft(_TITLES[SliderCrank], (), "4", {a: pa}, links, (slide,), (driver,))


def _fixed_block(slider: SliderCrank, omega: float) -> Draft:
    """The sliding link is a bar through a block that stands on the frame, at the foot of A."""
    (a, b, c), (pa, pb, pc) = slider.names, slider.places
    along = cmath.rect(1, slider.way)
    foot = pa + 1j * along * slider.offset
    p, q = free_names(slider.names, 2)
    own = ((foot - pc) * along.conjugate()).real
    ahead = along if own >= 0 else -along
    tip = pc + ahead * (abs(own) + 0.4 * (slider.crank + slider.coupler))
    fixed = {a: pa} if slider.offset == 0 else {a: pa, p: foot}
    slide = {
        "name": quoted("s"), "block": quoted("frame"), "point": quoted(a if slider.offset == 0 else p),
        "guide": quoted("3"), "through": quoted(c), "toward": quoted(q), "tilt": degrees(-cmath.phase(ahead)),
    }  # fmt: skip
    driver = {
        "crank": _turning((a, b), pb - pa, omega), "coupler": _turning((b, c), pc - pb, omega),
        "slider": {"slide": quoted("s"), "at": _mm(abs(own)), "velocity": "0.1"},
    }[slider.driver]  # fmt: skip
    links = {"1": {a: pa, b: pb}, "2": {b: pb, c: pc}, "3": {c: pc, q: tip}}
    return Draft(_TITLES[SliderCrank], (), "4", fixed, links, (slide,), (driver,))


def _guide(bar: GuideBar, omega: float) -> Draft:
    """The bar is hinged at C, or at B where it slides through a block at C."""
    (a, b, c), (pa, pb, pc) = bar.names, bar.places
    along = cmath.rect(1, bar.turn)
    hinge, other = (b, c) if bar.block else (c, b)
    where = {b: pb, c: pc}
    foot = where[hinge] + (-1j if bar.block else 1j) * along * bar.offset
    ahead = 1.0 if ((where[other] - foot) * along.conjugate()).real >= 0 else -1.0
    tip = foot + ahead * along * 1.15 * (bar.crank + bar.frame)
    p, q = free_names(bar.names, 2)
    points = {hinge: where[hinge]} | ({} if bar.offset == 0 else {p: foot}) | {q: tip}
    origin = hinge if bar.offset == 0 else p
    slide = {
        "name": quoted("s"), "block": quoted("3" if bar.block else "2"), "point": quoted(other),
        "guide": quoted("2" if bar.block else "3"), "through": quoted(origin), "toward": quoted(q),
    }  # fmt: skip
    at = ((where[other] - foot) * ahead * along.conjugate()).real
    driver = {
        "crank": _turning((a, b), pb - pa, omega), "bar": _turning((origin, q), ahead * along, omega),
        "slide": {"slide": quoted("s"), "at": _mm(at), "velocity": "0.1"},
    }[bar.driver]  # fmt: skip
    single = {other: where[other]}
    links = {"1": {a: pa, b: pb}, "2": points if bar.block else single, "3": single if bar.block else points}
    return Draft(_TITLES[GuideBar], (), "4", {a: pa, c: pc}, links, (slide,), (driver,))
