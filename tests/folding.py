"""Linkages that fold flat, all links in one line, on their way round; each with a wheel that rolls along with it."""

from __future__ import annotations

import cmath
import itertools
import math
import random

from graphkin.files import loads
from graphkin.model.mechanism import Mechanism

LINKAGES = ("parallelogram", "rhombus", "kite of crank and frame", "kite of crank and coupler", "folding slider-crank")
WHEELS = ("none", "crank", "rocker", "frame", "coupler hinge", "roll", "bar on a planet")
KINDS = tuple(itertools.product(LINKAGES, WHEELS))


class Drawing:
    """Points where they stand now, turned and mirrored as a whole by lot [mm]."""

    def __init__(self, rng: random.Random) -> None:
        self.turn = cmath.rect(1.0, rng.uniform(0, 2 * math.pi))
        self.mirrored = rng.random() < 0.5
        self.place = complex(rng.uniform(-50, 50), rng.uniform(-50, 50))
        self.points: dict[str, complex] = {}

    def put(self, name: str, z: complex) -> None:
        self.points[name] = self.turn * (z.conjugate() if self.mirrored else z) + self.place

    def at(self, name: str) -> str:
        return f"[{self.points[name].real!r}, {self.points[name].imag!r}]"

    def angle(self, name: str) -> float:
        return math.degrees(cmath.phase(self.points[name[1]] - self.points[name[0]]))

    def length(self, name: str) -> float:
        return abs(self.points[name[1]] - self.points[name[0]])


def folding(linkage: str, wheel: str, seed: int) -> Mechanism:
    rng = random.Random(f"{linkage}{wheel}{seed}")
    draw, lengths = Drawing(rng), {}
    slider = linkage == "folding slider-crank"
    crank, other = rng.uniform(30, 60), rng.uniform(70, 100)
    if rng.random() < 0.5 and linkage != "kite of crank and frame":
        crank, other = other, crank
    arm = cmath.rect(crank, math.radians(rng.choice((20, 35, 50, 65, 115, 130, 145, 200, 230, 310))))
    draw.put("O", 0j)
    draw.put("A", arm)
    if slider:
        lengths |= {"OA": crank, "AB": crank}
        draw.put("B", complex(2 * arm.real))
        fixed = ["O"]
    else:
        frame = crank if linkage in ("rhombus", "kite of crank and frame") else other
        coupler = crank if linkage in ("rhombus", "kite of crank and coupler") else other
        rocker = {"parallelogram": crank, "rhombus": crank}.get(linkage, other)
        lengths |= {"OA": crank, "AB": coupler, "QB": rocker}
        draw.put("Q", complex(frame))
        draw.put("B", _crossing(arm, coupler, complex(frame), rocker, rng, linkage))
        fixed = ["O", "Q"]
    text = _wheel(rng, draw, wheel, slider, fixed)
    return loads("\n".join(_lines(draw, lengths, fixed, slider, rng, text)), name=f"{linkage}, {wheel} {seed}", file="folding.toml")


def _crossing(a: complex, coupler: float, q: complex, rocker: float, rng: random.Random, linkage: str) -> complex:
    """Either crossing of the circles about A and Q; of a kite not the one that lies on a pivot all the time."""
    gap = q - a
    foot = (coupler**2 - rocker**2 + abs(gap) ** 2) / (2 * abs(gap))
    half = math.sqrt(coupler**2 - foot**2)
    side = rng.choice((1, -1))
    ends = [a + gap / abs(gap) * complex(foot, side * s * half) for s in (1, -1)]
    return next(z for z in ends if abs(z) > 1 and abs(z - q) > 1)


def _lines(
    draw: Drawing, lengths: dict[str, float], fixed: list[str], slider: bool, rng: random.Random, more: list[str]
) -> list[str]:
    lines = ["[frame]", *(f"{name} = {draw.at(name)}" for name in fixed)]
    lines += [line for k, (name, length) in enumerate(lengths.items(), 1) for line in (f"[links.{k}]", f"{name} = {length!r}")]
    if slider:
        along = math.degrees(cmath.phase(draw.turn))
        lines += ["[links.3]", 'points = ["B"]', "[[slide]]", 'name = "ram"', 'block = "3"', 'point = "B"', 'guide = "frame"']
        lines += ['through = "O"', f"angle = {along!r}"]
    lines += [*more, "[[driver]]", 'vector = "OA"', f"angle = {draw.angle('OA')!r}", f"omega = {rng.choice((1, -1)) * rng.uniform(1, 9)!r}"]
    return [*lines, "[sketch]", *(f"{name} = {draw.at(name)}" for name in draw.points if name not in fixed)]


def _wheel(rng: random.Random, draw: Drawing, wheel: str, slider: bool, fixed: list[str]) -> list[str]:
    """The lines of a wheel that rolls along; what needs a rocker is put on the crank where there is none."""
    if wheel == "none":
        return []
    if wheel == "roll":
        return _rolling(rng, draw)
    pair = {"crank": "OA", "rocker": "OA" if slider else "QB", "frame": "OP", "coupler hinge": "AO", "bar on a planet": "OA"}[wheel]
    if wheel == "frame":
        draw.put("P", complex(rng.uniform(-20, -70), rng.uniform(-30, 30)))
        fixed.append("P")
    links = {"frame": "1", "coupler hinge": "2"}.get(wheel, "frame")
    share = rng.uniform(0.2, 0.8)
    radii = draw.length(pair) * share, draw.length(pair) * (1 - share)
    centre = draw.points[pair[1]]
    draw.points["M"] = centre + cmath.rect(10, rng.uniform(0, 6))
    lines = ["[links.9]", f"{pair[1]}M = 10", "[[gear]]", f'links = ["{links}", "9"]', f'centres = ["{pair[0]}", "{pair[1]}"]']
    lines += [f"radii = [{radii[0]!r}, {radii[1]!r}]", "[[pose]]", f'vector = "{pair[1]}M"', f"angle = {draw.angle(pair[1] + 'M')!r}"]
    return lines + (_bar(draw) if wheel == "bar on a planet" else [])


def _bar(draw: Drawing) -> list[str]:
    """A bar from the planet's rim to a block on the frame."""
    draw.points["N"] = draw.points["O"] + 250
    draw.points["N"] = complex(draw.points["N"].real, draw.points["O"].imag - 12)
    return ["[links.7]", f"MN = {draw.length('MN')!r}", "[links.8]", 'points = ["N"]', "[[slide]]", 'block = "8"', 'point = "N"',
            'guide = "frame"', f"through = [0, {draw.points['N'].imag!r}]"]  # fmt: skip


def _rolling(rng: random.Random, draw: Drawing) -> list[str]:
    """A wheel on a line of the frame, pushed by a bar from B."""
    radius, low = rng.uniform(5, 15), draw.points["O"].imag - rng.uniform(0, 40)
    draw.points["W"] = complex(draw.points["B"].real + 250, low + radius)
    draw.points["M"] = draw.points["W"] + 5
    return ["[links.8]", f"BW = {draw.length('BW')!r}", "[links.9]", "WM = 5", "[[roll]]", 'wheel = "9"', 'centre = "W"', f"radius = {radius!r}",
            'on = "frame"', f"through = [0, {low!r}]", "[[pose]]", 'vector = "WM"', "angle = 0"]  # fmt: skip
