"""The velocity and the acceleration polygon in words, one plane at a time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from graphkin.construction import (
    Arc,
    Equation,
    Fit,
    Given,
    Image,
    LayOff,
    Measure,
    Meet,
    Plane,
    Ray,
    Roll,
    Simultaneous,
    Step,
    Swing,
    Touch,
)
from graphkin.planning.at_rest import held_points, moving_parts
from graphkin.say import names
from graphkin.say.entry import Entry, Heading, Sentence
from graphkin.say.equations import equation, known_arrow
from graphkin.say.plane import PolygonReading
from graphkin.say.reading import Reading
from graphkin.say.rolling import rolling
from graphkin.say.rotation import image, rotation, sliding, ties
from graphkin.say.together import solved_together


def polygon(reading: Reading, plane: Plane, parts: tuple[Step | Equation, ...], number: int) -> Iterator[Entry]:
    """Pole, known motions, equations, and what is read off each, in the order of the construction."""
    drawn = PolygonReading(reading, plane, moving_parts(reading.method, plane, parts, reading.rested))
    yield Heading(reading.say(f"derivation.plane {plane}", number=number), plane)
    for part in drawn.parts:
        if isinstance(part, Equation):
            yield from equation(drawn, part)
        else:
            yield from _step(drawn, part)


def _step(drawn: PolygonReading, step: Step) -> Iterator[Entry]:
    match step:
        case Given():
            yield from _renamed(drawn)
            yield Sentence(_pole(drawn, step))
            yield from _held(drawn)
            yield from ties(drawn)
        case LayOff():
            yield from known_arrow(drawn, step)
        case Image():
            yield from image(drawn, step)
        case Measure("omega" | "alpha"):
            yield from rotation(drawn, step)
        case Measure():
            yield from sliding(drawn, step)
        case Roll():
            yield from rolling(drawn, step)
        case Simultaneous():
            yield from solved_together(drawn, step)
        case Fit() | Touch():
            raise AssertionError("the mechanism itself is drawn before")
        case Ray() | Arc() | Meet() | Swing():
            raise AssertionError("lines cross inside an equation")
        case _:
            assert_never(step)


def _renamed(drawn: PolygonReading) -> Iterator[Entry]:
    """Where p belongs to a point P, the pole has another letter; said once, in the first polygon."""
    pole = drawn.construction.pole
    if drawn.plane == "velocity" and pole != "p":
        yield Sentence(drawn.reading.say("derivation.renamed pole", letter="P", pole=names.point(pole)))
    taken = {point[0] for point in drawn.reading.mechanism.points}
    for part, tip in _tips(drawn).items():
        if part.upper() in taken and not tip.startswith(part):
            what = drawn.reading.say(f"derivation.tips {part}")
            words = {"letter": part.upper(), "part": what, "tip": tip[0]}
            yield Sentence(drawn.reading.say("derivation.renamed tips", **words))


def _tips(drawn: PolygonReading) -> dict[str, str]:
    """Where normal and Coriolis components end: the first of each that ends at a corner of its own."""
    found, nodes = dict[str, str](), drawn.construction.nodes
    for part in drawn.parts:
        for step in part.steps if isinstance(part, Equation) else (part,):
            if isinstance(step, LayOff) and step.term.part in ("n", "k") and nodes[step.tip].site is None:
                found.setdefault(step.term.part, step.tip)
    return found


def _held(drawn: PolygonReading) -> Iterator[Entry]:
    """The links that drivers at rest hold still: their points are fixed points."""
    reading = drawn.reading
    links = [reading.link(link) for link in reading.mechanism.moving if reading.stands(link)]
    if links:
        held = held_points(reading.method, drawn.plane, reading.rested)
        owners = reading.mechanism.owners
        points = [names.point(p) for p in held if not all(map(reading.stands, owners.get(p, ())))]
        key = "derivation.as fixed" if len(points) == 1 else "derivation.as fixed, several"
        fixed = reading.say(key, points=reading.listed(points), pole=names.point(drawn.construction.pole))
        key = "derivation.held still" if len(links) == 1 else "derivation.held still, several"
        yield Sentence(reading.say(key, links=reading.listed(links), fixed=fixed))


def _pole(drawn: PolygonReading, step: Given) -> str:
    reading, pole = drawn.reading, names.point(step.point)
    first = next((part for part in drawn.parts if isinstance(part, Equation)), None)
    if first is not None and any(isinstance(other, Given) for other in first.steps):
        return reading.say("derivation.pole last", pole=pole)
    if not step.also:
        return reading.say("derivation.pole", pole=pole)
    nodes = reading.listed([names.point(node) for node in step.also])
    points = reading.listed([names.point(drawn.of(node)) for node in step.also])
    key = "derivation.pole fixed" if len(step.also) == 1 else "derivation.pole fixed, several"
    return reading.say(key, pole=pole, points=points, nodes=nodes)
