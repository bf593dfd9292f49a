"""Random mechanisms that roll, as files: poses first, dimensions from them, so that every one can be assembled.

Cranks, four-bars and crossheads carry gears, racks and wheels on lines and circles that stand still or move. Links
have numbers or words for names, and some slides are called as a link is.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, field

WORDS = ("crank", "rod", "rocker", "belt", "planet", "arm", "ring", "rack", "cart", "drum", "pulley", "yoke", "lever")


@dataclass
class File:
    """A mechanism file in the making: links with their points where they stand [mm], and its tables as text."""

    rng: random.Random
    frame: dict[str, complex] = field(default_factory=dict)
    links: dict[str, dict[str, complex]] = field(default_factory=dict)
    tables: list[str] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    letters: list[str] = field(default_factory=lambda: list("ABCDEFGHJKLMNOPQRSTUVWXYZ"))

    @classmethod
    def new(cls, seed: str) -> File:
        rng = random.Random(seed)
        names = list(WORDS) if rng.random() < 0.4 else [str(k) for k in range(1, 14)]
        rng.shuffle(names)
        made = cls(rng, names=names)
        if rng.random() < 0.5:
            rng.shuffle(made.letters)
        return made

    # --- parts --------------------------------------------------------------------------------

    def place(self) -> complex:
        return complex(self.rng.uniform(-100, 100), self.rng.uniform(-100, 100))

    def away(self, low: float, high: float) -> complex:
        return cmath.rect(self.rng.uniform(low, high), self.rng.uniform(-math.pi, math.pi))

    def point(self, at: complex, *links: str) -> str:
        """A new point at a place, of these links."""
        name = self.letters.pop(0)
        for link in links:
            self.of(link)[name] = at
        return name

    def join(self, point: str, *links: str) -> None:
        for link in links:
            self.of(link)[point] = self.at(point)

    def of(self, link: str) -> dict[str, complex]:
        return self.frame if link == "frame" else self.links[link]

    def at(self, point: str) -> complex:
        return next(points[point] for points in (self.frame, *self.links.values()) if point in points)

    def link(self) -> str:
        name = self.names.pop(0)
        self.links[name] = {}
        return name

    def table(self, kind: str, **keys: object) -> None:
        lines = [f"{key.rstrip('_')} = {_toml(value)}" for key, value in keys.items() if value is not None]
        self.tables.append("\n".join([f"[[{kind}]]", *lines]))

    # --- drivers and poses --------------------------------------------------------------------

    def angle(self, tail: str, head: str, seen_from: tuple[str, str] | None = None) -> float:
        value = cmath.phase(self.at(head) - self.at(tail))
        if seen_from:
            value -= cmath.phase(self.at(seen_from[1]) - self.at(seen_from[0]))
        return math.degrees(math.remainder(value, 2 * math.pi))

    def rates(self, size: float, *keys: str) -> dict[str, float]:
        first, second = (self.rng.uniform(-size, size) for _ in keys)
        return {keys[0]: first, keys[1]: self.rng.choice((0.0, 3 * second))}

    def turn(self, tail: str, head: str, seen_from: tuple[str, str] | None = None) -> None:
        """A driver that turns a link."""
        more = {"from_": "".join(seen_from)} if seen_from else {}
        value = self.angle(tail, head, seen_from)
        self.table("driver", vector=tail + head, angle=value, **more, **self.rates(8, "omega", "alpha"))

    def pose(self, tail: str, head: str, seen_from: tuple[str, str] | None = None) -> None:
        more = {"from_": "".join(seen_from)} if seen_from else {}
        self.table("pose", vector=tail + head, angle=self.angle(tail, head, seen_from), **more)

    def mark(self, wheel: str, centre: str, beside: tuple[str, str] | None = None) -> None:
        """A point that shows how a wheel stands, with its pose; or none."""
        if self.rng.random() < 0.3:
            return
        head = self.point(self.at(centre) + self.away(5, 15), wheel)
        self.pose(centre, head, beside if self.rng.random() < 0.4 else None)

    # --- machines -----------------------------------------------------------------------------

    def crank(self, driven: bool = True) -> tuple[str, str, str]:
        """A crank on the frame: its link, pivot and pin."""
        link, at = self.link(), self.place()
        pivot, pin = self.point(at, "frame", link), self.point(at + self.away(30, 60), link)
        if driven:
            self.turn(pivot, pin)
        return link, pivot, pin

    def four_bar(self) -> list[tuple[str, str, str]]:
        """Crank, coupler and rocker, each with its two hinges; the crank is driven."""
        crank, a, b = self.crank()
        coupler, rocker = self.link(), self.link()
        self.join(b, coupler)
        c = self.point(self.at(b) + self.away(60, 90), coupler, rocker)
        d = self.point(self.at(c) + self.away(60, 90), rocker, "frame")
        return [(crank, a, b), (coupler, b, c), (rocker, c, d)]

    def wheel(self, centre: str) -> str:
        link = self.link()
        self.join(centre, link)
        return link

    def gear(self, one: tuple[str, str], other: tuple[str, str]) -> None:
        """Two links in mesh about their centres, either way round, outside or inside."""
        ends = [one, other]
        self.rng.shuffle(ends)
        distance = abs(self.at(one[1]) - self.at(other[1]))
        share, internal = self.rng.uniform(0.25, 0.75), self.rng.random() < 0.3
        radii = [distance * share, distance * (1 - share)]
        if internal:
            radii = [distance * (1 + share), distance * share]
            self.rng.shuffle(radii)
        links, centres = ([end[k] for end in ends] for k in (0, 1))
        self.table("gear", links=links, centres=centres, radii=radii, internal=True if internal else None)

    def line(self, link: str, foot: complex, along: complex) -> dict[str, object]:
        """The keys of a line of a link through a place, in one of the ways a file may write it."""
        start = foot + self.rng.uniform(-60, 60) * along
        angle = math.degrees(cmath.phase(along))
        if link == "frame" and self.rng.random() < 0.6:
            return {"through": [start.real, start.imag], "angle": angle}
        first = self.point(start, link)
        if self.rng.random() < 0.5:
            return {"through": first, "toward": self.point(start + along * self.rng.uniform(20, 80), link)}
        if link == "frame":
            return {"through": first, "angle": angle}
        one, other = list(self.of(link))[:2]
        if abs(self.at(other) - self.at(one)) < 1:
            return {"through": first, "toward": self.point(start + along * 50, link)}
        seen = cmath.phase(self.at(other) - self.at(one))
        return {"through": first, "from_": one + other, "angle": angle - math.degrees(seen)}

    def roll_on_line(self, wheel: str, centre: str, track: str, along: complex, radius: float, **more: object) -> None:
        side = self.rng.choice((1, -1))
        foot = self.at(centre) - 1j * along * radius * side
        keys = self.line(track, foot, along)
        said = {"side": "right"} if side < 0 else {"side": self.rng.choice((None, "left"))}
        self.table("roll", wheel=wheel, centre=centre, radius=radius, on=track, **keys, **said, **more)

    def text(self) -> str:
        lines = ["[frame]", *(f"{p} = [{z.real!r}, {z.imag!r}]" for p, z in self.frame.items())]
        for name, points in self.links.items():
            lines += [f'[links."{name}"]', _shape(points, cmath.rect(1, self.rng.uniform(0, 6)))]
        sketch = {p: z for points in self.links.values() for p, z in points.items() if p not in self.frame}
        lines += [*self.tables, "[sketch]", *(f"{p} = [{z.real:.3f}, {z.imag:.3f}]" for p, z in sketch.items())]
        return "\n".join(lines) + "\n"


def _shape(points: dict[str, complex], turned: complex) -> str:
    """Coordinates in any axes fixed in the link."""
    if len(points) == 1:
        return f'points = ["{next(iter(points))}"]'
    origin = next(iter(points.values()))
    places = {p: (z - origin) * turned for p, z in points.items()}
    return "shape = { " + ", ".join(f"{p} = [{z.real!r}, {z.imag!r}]" for p, z in places.items()) + " }"


def _toml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    return "[" + ", ".join(_toml(v) for v in value) + "]" if isinstance(value, (list, tuple)) else repr(value)


# --- families ---------------------------------------------------------------------------------


def gears_on_four_bar(seed: int) -> str:
    """Wheels about the hinges of a four-bar, in mesh with its links or the frame, with each other, one after another."""
    file = File.new(f"gears {seed}")
    rng, bars = file.rng, file.four_bar()
    for _ in range(rng.randint(1, 2)):
        arm, one, other = rng.choice(bars)
        centre, far = rng.sample((one, other), 2)
        owners = [link for link, points in file.links.items() if far in points and link != arm]
        owners += ["frame"] * (far in file.frame)
        wheel = file.wheel(centre)
        file.gear((wheel, centre), (rng.choice(owners), far))
        file.mark(wheel, centre, (one, other))
    return file.text()


def line_of_centres(seed: int) -> str:
    """Wheels on two cranks of a parallelogram beyond its coupler: no link carries both centres."""
    file = File.new(f"centres {seed}")
    crank, a, b = file.crank()
    coupler, other = file.link(), file.link()
    file.join(b, coupler)
    apart = file.away(60, 90)
    c = file.point(file.at(b) + apart, coupler, other)
    file.point(file.at(a) + apart, other, "frame")
    share = file.rng.uniform(1.2, 1.8)
    centres = [file.point(file.at(a) + k * apart + share * (file.at(b) - file.at(a)), (crank, other)[k]) for k in (0, 1)]
    wheels = [file.wheel(centre) for centre in centres]
    file.gear((wheels[0], centres[0]), (wheels[1], centres[1]))
    file.turn(centres[0], file.point(file.at(centres[0]) + file.away(5, 15), wheels[0]), (a, b))
    file.mark(wheels[1], centres[1], (b, c))
    return file.text()


def rack(seed: int) -> str:
    """A rack in a guide of the frame or of a turning link, moved by a pinion; or driven, and the pinion follows."""
    file = File.new(f"rack {seed}")
    rng = file.rng
    if rng.random() < 0.5:
        carrier, pivot = "frame", file.point(file.place(), "frame")
    else:
        carrier, _, pivot = file.crank()
    pinion, bar, along = file.wheel(pivot), file.link(), cmath.rect(1, rng.uniform(-3, 3))
    radius, name = rng.uniform(10, 30), bar if rng.random() < 0.5 else "ram"
    tip = file.point(file.at(pivot) + file.away(5, 15), pinion)
    # the bar's own line, which touches the pinion, and the guide's beside it
    side = rng.choice((1, -1))
    start = file.at(pivot) - 1j * along * radius * side + along * rng.uniform(-40, 40)
    one = file.point(start, bar)
    two = file.point(start + along * rng.uniform(30, 80), bar)
    aside = file.point(start + file.away(10, 30), bar)
    away = along * rng.choice((1, -1))
    foot = file.at(aside) + rng.uniform(20, 60) * away
    guide = file.point(foot, carrier)
    if carrier == "frame":
        line = {"through": guide, "angle": math.degrees(cmath.phase(away))}
    else:
        line = {"through": guide, "toward": file.point(foot + 30 * away, carrier)}
    tilt = math.degrees(cmath.phase((file.at(two) - file.at(one)) / away))
    file.table("slide", name=name, block=bar, point=aside, guide=carrier, **line, tilt=tilt)
    said = {"side": "left" if side > 0 else "right"}
    file.table("roll", wheel=pinion, centre=pivot, radius=radius, on=bar, through=one, toward=two, **said)
    s = ((file.at(aside) - foot) / away).real
    if rng.random() < 0.5:
        file.turn(pivot, tip, tuple(list(file.of(carrier))[:2]) if carrier != "frame" and rng.random() < 0.5 else None)
        file.table("pose", slide=name, at=s)
    else:
        file.table("driver", slide=name, at=s, **file.rates(0.5, "velocity", "acceleration"))
        file.pose(pivot, tip)
    return file.text()


def belt(seed: int) -> str:
    """A wheel on a moving belt, pulled at its centre, pushed by a rod of a crank, or driven along the belt."""
    file = File.new(f"belt {seed}")
    rng, along = file.rng, cmath.rect(1, file.rng.uniform(-3, 3))
    track, wheel = file.link(), file.link()
    spot, radius = file.place(), rng.uniform(10, 40)
    centre = file.point(spot, wheel)
    one = file.point(spot + file.away(60, 100), track)
    file.point(file.at(one) + file.away(60, 100), track)
    name = track if rng.random() < 0.6 else "feed"
    across = cmath.rect(1, rng.uniform(-3, 3))
    foot = file.at(one) - rng.choice((1, -1)) * rng.uniform(20, 60) * across
    tilt = math.degrees(cmath.phase((list(file.of(track).values())[1] - file.at(one)) / across))
    degrees = math.degrees(cmath.phase(across))
    file.table("slide", name=name, block=track, point=one, guide="frame", through=[foot.real, foot.imag],
               angle=degrees, tilt=tilt)  # fmt: skip
    s = ((file.at(one) - foot) / across).real
    file.table("driver", slide=name, at=s, **file.rates(0.6, "velocity", "acceleration"))
    kind = rng.choice(("driven", "rod", "guided"))
    if kind == "driven":
        place = file.rng.uniform(-60, 60)
        side = rng.choice((1, -1))
        start = file.point(spot - 1j * along * radius * side - along * place, track)
        toward = file.point(file.at(start) + 40 * along, track)
        file.table("roll", name=wheel if rng.random() < 0.5 else "road", wheel=wheel, centre=centre, radius=radius,
                   on=track, through=start, toward=toward, side="left" if side > 0 else "right")  # fmt: skip
        driven = wheel if f'name = "{wheel}"' in file.tables[-1] else "road"
        file.table("driver", slide=driven, at=place, **file.rates(0.5, "velocity", "acceleration"))
    else:
        file.roll_on_line(wheel, centre, track, along, radius)
        rod = file.link()
        file.join(centre, rod)
        if kind == "rod":
            _, _, pin = file.crank()
            file.links[rod][pin] = file.at(pin)
        else:
            block = file.link()
            pin = file.point(spot + file.away(60, 100), rod, block)
            at = file.at(pin) - 30 * across
            file.table("slide", name="pull", block=block, point=pin, guide="frame", through=[at.real, at.imag],
                       angle=degrees)  # fmt: skip
            file.table("driver", slide="pull", at=30.0, **file.rates(0.6, "velocity", "acceleration"))
    file.mark(wheel, centre)
    return file.text()


def rolling_line(seed: int) -> str:
    """A wheel on a line of the frame, pushed by a crank; or on a line of a crank, its centre on a rocker, any of them driven."""
    file = File.new(f"line {seed}")
    rng = file.rng
    crank, a, b = file.crank(driven=False)
    rod, wheel = file.link(), file.link()
    centre = file.point(file.place(), rod, wheel)
    track = rng.choice((crank, "frame"))
    file.roll_on_line(wheel, centre, track, cmath.rect(1, rng.uniform(-3, 3)), rng.uniform(10, 40))
    if track == "frame":
        file.links[rod][b] = file.at(b)
        file.turn(a, b)
    else:
        e = file.point(file.at(centre) + file.away(40, 80), rod, "frame")
        ways = ((a, b, None), (e, centre, None), (centre, e, (a, b)), (a, b, (e, centre)))
        file.turn(*rng.choice(ways))
    file.mark(wheel, centre, (a, b))
    return file.text()


def wheel_on_wheel(seed: int) -> str:
    """A wheel on the rim of another that turns about a fixed or moving pivot, held by a rod, or on an arm."""
    file = File.new(f"wheels {seed}")
    rng = file.rng
    _, a, b = file.crank()
    drum, wheel = file.link(), file.link()
    hub = file.point(file.place(), "frame", drum) if rng.random() < 0.5 else b
    file.join(hub, drum)
    rim, radius, internal = rng.uniform(30, 60), rng.uniform(8, 25), rng.random() < 0.4
    way = file.away(1, 1)
    centre = file.point(file.at(hub) + way * (rim - radius if internal else rim + radius), wheel)
    file.table("roll", wheel=wheel, centre=centre, radius=radius, on=drum, on_centre=hub, on_radius=rim,
               internal=True if internal else None)  # fmt: skip
    rod = file.link()
    file.join(centre, rod)
    other = b if hub != b else file.point(file.place(), "frame")
    file.links[rod][other] = file.at(other)
    spot = file.point(file.at(hub) + file.away(5, 20), drum)
    file.turn(hub, spot, (a, b) if rng.random() < 0.5 else None)
    file.mark(wheel, centre, (hub, spot))
    return file.text()


def road(seed: int) -> str:
    """A wheel driven along a line of the frame, a rod on its rim with a crosshead or a rocker."""
    file = File.new(f"road {seed}")
    rng, along = file.rng, cmath.rect(1, file.rng.uniform(-3, 3))
    wheel, rod = file.link(), file.link()
    centre = file.point(file.place(), wheel)
    rim = file.point(file.at(centre) + file.away(20, 40), wheel, rod)
    radius, side, place = rng.uniform(20, 50), rng.choice((1, -1)), rng.uniform(-100, 100)
    start = file.at(centre) - 1j * along * radius * side - along * place
    name = wheel if rng.random() < 0.5 else "road"
    file.table("roll", name=name, wheel=wheel, centre=centre, radius=radius, on="frame", through=[start.real, start.imag],
               angle=math.degrees(cmath.phase(along)), side="left" if side > 0 else "right")  # fmt: skip
    rates, end = file.rates(0.7, "velocity", "acceleration"), file.link()
    pin = file.point(file.at(rim) + file.away(80, 150), rod, end)
    if rng.random() < 0.5:
        file.point(file.at(pin) + file.away(60, 120), end, "frame")
    else:
        way = cmath.rect(1, rng.uniform(-3, 3))
        foot = file.at(pin) - way * rng.uniform(20, 60)
        file.table("slide", name="out", block=end, point=pin, guide="frame", through=[foot.real, foot.imag],
                   angle=math.degrees(cmath.phase(way)))  # fmt: skip
    if rng.random() < 0.5:
        file.table("driver", slide=name, at=place, **rates)
        file.pose(centre, rim)
    else:
        file.table("driver", slide=name, **rates)
        file.pose(centre, rim)
        file.table("pose", slide=name, at=place)
    return file.text()


def train(seed: int) -> str:
    """Sun, compound planet and ring on an arm, on the frame or carried by a crank; any two of the four driven."""
    file = File.new(f"train {seed}")
    rng = file.rng
    base = "frame" if rng.random() < 0.6 else (carried := file.crank())[0]
    hub = file.point(file.place(), "frame") if base == "frame" else carried[2]
    seen = None if base == "frame" else (carried[1], carried[2])
    arm, sun, ring = file.link(), file.link(), file.link()
    file.join(hub, arm, sun, ring)
    pin = file.point(file.at(hub) + file.away(40, 60), arm)
    planet, distance = file.wheel(pin), abs(file.at(pin) - file.at(hub))
    small, other = (distance * rng.uniform(0.2, 0.7) for _ in range(2))
    file.table("gear", links=[sun, planet], centres=[hub, pin], radii=[distance - small, small])
    file.table("gear", links=[ring, planet], centres=[hub, pin], radii=[distance + other, other], internal=True)
    marks = {arm: (hub, pin)}
    for link, centre in ((sun, hub), (ring, hub), (planet, pin)):
        marks[link] = (centre, file.point(file.at(centre) + file.away(5, 15), link))
    driven = rng.sample([arm, sun, ring, planet], 2)
    for link, (tail, head) in marks.items():
        beside = marks[arm] if link != arm and arm in driven and rng.random() < 0.3 else seen
        if link not in driven:
            file.pose(tail, head, beside if rng.random() < 0.5 else None)
        elif rng.random() < 0.3 and seen is None and link != arm:
            file.table("driver", link=link, **file.rates(8, "omega", "alpha"))
            file.pose(tail, head)
        else:
            file.turn(tail, head, beside if rng.random() < 0.5 else None)
    return file.text()


def pinion_drives(seed: int) -> str:
    """A pinion on the frame in mesh with a crank or rocker of a four-bar, which it drives; the bar is posed."""
    file = File.new(f"pinion {seed}")
    rng, bars = file.rng, file.four_bar()
    file.tables.clear()
    (crank, a, b), _, (rocker, c, d) = bars
    bar, pivot, tip = rng.choice(((crank, a, b), (rocker, d, c)))
    shaft = file.point(file.at(pivot) + file.away(40, 80), "frame")
    pinion = file.wheel(shaft)
    file.gear((pinion, shaft), (bar, pivot))
    if rng.random() < 0.5:
        file.table("driver", link=pinion, **file.rates(8, "omega", "alpha"))
    else:
        file.turn(shaft, file.point(file.at(shaft) + file.away(5, 15), pinion))
    file.pose(pivot, tip)
    return file.text()


def coupler_track(seed: int) -> str:
    """A wheel that rolls on a line of a coupler or rocker, its centre on a rocker, in a slot or on a crosshead."""
    file = File.new(f"track {seed}")
    rng, bars = file.rng, file.four_bar()
    wheel, along, radius = file.link(), cmath.rect(1, file.rng.uniform(-3, 3)), file.rng.uniform(8, 25)
    centre = file.point(file.place(), wheel)
    file.roll_on_line(wheel, centre, rng.choice(bars)[0], along, radius)
    if rng.random() < 0.5:
        bar = file.link()
        file.join(centre, bar)
        file.point(file.at(centre) + file.away(50, 90), bar, "frame")
    else:
        way, block = cmath.rect(1, rng.uniform(-3, 3)), rng.random() < 0.5 and file.link()
        foot = file.at(centre) - way * rng.uniform(-50, 50)
        if block:
            file.join(centre, block)
        held = {"block": block, "point": centre} if block else {"pin": centre}
        file.table("slide", **held, guide="frame", through=[foot.real, foot.imag], angle=math.degrees(cmath.phase(way)))
    file.mark(wheel, centre, bars[0][1:])
    return file.text()


def crosshead(seed: int) -> str:
    """A wheel about a crosshead's pin on a line along the guide; the crank or the crosshead is driven."""
    file = File.new(f"crosshead {seed}")
    rng, along = file.rng, cmath.rect(1, file.rng.uniform(-3, 3))
    _, a, b = file.crank(driven=False)
    rod, head = file.link(), file.link()
    file.join(b, rod)
    pin = file.point(file.at(b) + file.away(80, 120), rod, head)
    foot = file.at(pin) - along * rng.uniform(20, 60)
    name = rng.choice((head, "ram", None))
    angle = math.degrees(cmath.phase(along))
    file.table("slide", name=name, block=head, point=pin, guide="frame", through=[foot.real, foot.imag], angle=angle)
    if name and rng.random() < 0.5:
        s = ((file.at(pin) - foot) / along).real
        file.table("driver", slide=name, at=s, **file.rates(0.5, "velocity", "acceleration"))
    else:
        file.turn(a, b)
    wheel = file.wheel(pin)
    file.roll_on_line(wheel, pin, "frame", along * rng.choice((1, -1)), rng.uniform(8, 25))
    file.mark(wheel, pin, (a, b))
    return file.text()


def on_the_rim(seed: int) -> str:
    """A crank, and a rod from it to the rim of a wheel that rolls on the frame: on a line or a circle."""
    file = File.new(f"rim {seed}")
    rng = file.rng
    _, a, b = file.crank()
    rod, wheel = file.link(), file.link()
    file.join(b, rod)
    rim = file.point(file.at(b) + file.away(70, 120), rod, wheel)
    centre = file.point(file.at(rim) + file.away(10, 25), wheel)
    if rng.random() < 0.5:
        file.roll_on_line(wheel, centre, "frame", cmath.rect(1, rng.uniform(-3, 3)), rng.uniform(15, 40))
    else:
        radius, big, internal, way = rng.uniform(15, 30), rng.uniform(60, 90), rng.random() < 0.4, file.away(1, 1)
        hub = file.point(file.at(centre) + way * (big - radius if internal else big + radius), "frame")
        file.table("roll", wheel=wheel, centre=centre, radius=radius, on="frame", on_centre=hub, on_radius=big,
                   internal=True if internal else None)  # fmt: skip
    file.pose(centre, rim, (a, b) if rng.random() < 0.5 else None)
    return file.text()


def floating_rack(seed: int) -> str:
    """A rack hinged to a crank and pressed on a pinion, on the frame or on the crank; the pinion follows."""
    file = File.new(f"floating {seed}")
    rng = file.rng
    _, a, b = file.crank()
    bar = file.link()
    file.join(b, bar)
    shaft = file.point(file.at(b) + file.away(50, 90), "frame")
    pinion, along = file.wheel(shaft), (file.at(shaft) - file.at(b)) / abs(file.at(shaft) - file.at(b))
    file.point(file.at(b) + file.away(50, 90), bar)
    file.roll_on_line(pinion, shaft, bar, along * cmath.rect(1, rng.uniform(-0.5, 0.5)), rng.uniform(8, 20))
    file.pose(shaft, file.point(file.at(shaft) + file.away(5, 15), pinion), (a, b) if rng.random() < 0.5 else None)
    return file.text()


def rack_in_a_slot(seed: int) -> str:
    """A driven pinion on the frame moves a rack that a pin of its own leads in a fixed slot."""
    file = File.new(f"in a slot {seed}")
    rng = file.rng
    pinion, pivot, _ = file.crank()
    bar = file.link()
    pin = file.point(file.at(pivot) + file.away(90, 160), bar)
    end = file.point(file.at(pin) + file.away(40, 90), bar)
    along = (file.at(pivot) - file.at(pin)) / abs(file.at(pivot) - file.at(pin)) * cmath.rect(1, rng.uniform(-0.4, 0.4))
    file.roll_on_line(pinion, pivot, bar, along, rng.uniform(10, 30))
    slot = along * cmath.rect(1, rng.uniform(-0.9, 0.9))
    file.table("slide", pin=pin, guide="frame", **file.line("frame", file.at(pin), slot))
    file.pose(pin, end)
    return file.text()


def wheel_upon_wheel(seed: int) -> str:
    """A wheel that rolls on the rim of a wheel that rolls on a line, both centres held by bars."""
    file = File.new(f"upon {seed}")
    rng = file.rng
    _, a, b = file.crank()
    low, high, bar = file.link(), file.link(), file.link()
    one = file.point(file.at(b) + file.away(70, 110), bar, low)
    file.join(b, bar)
    radius, small = rng.uniform(20, 35), rng.uniform(8, 18)
    file.roll_on_line(low, one, "frame", cmath.rect(1, rng.uniform(-3, 3)), radius)
    two = file.point(file.at(one) + cmath.rect(radius + small, rng.uniform(-3, 3)), high)
    file.table("roll", wheel=high, centre=two, radius=small, on=low, on_centre=one, on_radius=radius)
    rod = file.link()
    file.join(two, rod)
    file.point(file.at(two) + file.away(60, 100), rod, "frame")
    file.mark(low, one, (a, b))
    file.mark(high, two)
    return file.text()


FAMILIES = {
    family.__name__: family
    for family in (
        gears_on_four_bar, line_of_centres, rack, belt, rolling_line, wheel_on_wheel, road, train, pinion_drives,
        coupler_track, crosshead, on_the_rim, floating_rack,
        rack_in_a_slot, wheel_upon_wheel,
    )
}  # fmt: skip
