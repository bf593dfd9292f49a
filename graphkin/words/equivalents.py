"""Higher pairs before anything is drawn: what replaces them (高副低代), and where their lines run."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.mechanism import FRAME
from graphkin.pairs import Cam, Line, Roll
from graphkin.words import names
from graphkin.words.entries import Entry, Sentence
from graphkin.words.figures import degrees, number
from graphkin.words.reading import Reading

__all__ = ["equivalents"]


def equivalents(reading: Reading) -> Iterator[Entry]:
    """Each cam by its lower pairs, each rolling wheel by what its centre does."""
    for k, cam in enumerate(reading.mechanism.cams):
        yield Sentence(_cam(reading, k, cam))
        yield from _fixed_path(reading, f"c{k}")
    for roll in reading.mechanism.rolls:
        if roll.line is not None:
            yield Sentence(_on_line(reading, roll, roll.line))
            yield from _fixed_path(reading, roll.name)
        elif f"e {roll.name}" in reading.method.structure.bodies:
            yield Sentence(_on_circle(reading, roll))


def _cam(reading: Reading, k: int, cam: Cam) -> str:
    first, second = cam.profiles
    if first.line is None and second.line is None:
        assert first.centre is not None
        assert second.centre is not None
        one, other = names.point(first.centre), names.point(second.centre)
        length = _distance(reading, (first.centre, second.centre), (first.radius, second.radius), cam.internal)
        return reading.say("circles touch", first=one, second=other, length=length, link=names.point(f"e c{k}"))
    flat, disc = (first, second) if first.line is not None else (second, first)
    assert flat.line is not None
    assert disc.centre is not None
    words = {
        "centre": names.point(disc.centre),
        "face": _face(reading, flat.line, f"c{k}"),
        "link": reading.link(flat.line.link),
    }
    if not disc.radius:
        return reading.say("edge touches", **words)
    return reading.say("flat touches", length=_radius(disc.radius), **words)


def _on_line(reading: Reading, roll: Roll, line: Line) -> str:
    return reading.say(
        "wheel on line",
        wheel=reading.link(roll.wheel),
        face=_face(reading, line, roll.name),
        link=reading.link(line.link),
        centre=names.point(roll.centre),
        length=_radius(roll.radius),
    )


def _on_circle(reading: Reading, roll: Roll) -> str:
    assert roll.track_centre is not None
    centres = (roll.track_centre, roll.centre)
    return reading.say(
        "wheel on circle",
        wheel=reading.link(roll.wheel),
        first=names.point(roll.track_centre),
        second=names.point(roll.centre),
        length=_distance(reading, centres, (roll.track_radius, roll.radius), roll.internal),
        link=names.point(f"e {roll.name}"),
    )


def _distance(reading: Reading, centres: tuple[str, str], radii: tuple[float, float], internal: bool) -> str:
    """`O1O2 = 35 + 18 = 53 mm`; of circles that touch inside, the difference of the radii."""
    greater, less = sorted((1000 * radius for radius in radii), reverse=True) if internal else [1000 * r for r in radii]
    sign, length = ("−", greater - less) if internal else ("+", greater + less)
    return f"{names.pair(*centres)} = {number(greater)} {sign} {number(less)} = {number(length)} mm"


def _radius(radius: float) -> str:
    return f"r = {number(radius * 1000)} mm"


def _face(reading: Reading, line: Line, slide: str) -> str:
    """Two points of the line where they are named, else nothing that needs a name."""
    line_of = reading.parallel(slide)
    if line.link != FRAME and line_of is not None:
        return names.pair(*line_of)
    origin = f"{names.point(line.origin)} · " if line.origin[0].isupper() else ""
    angle = degrees(line.direction * (1 if line.link == FRAME else 1))
    return f"({origin}{angle})" if line.link == FRAME else ""


def _fixed_path(reading: Reading, name: str) -> Iterator[Entry]:
    """Where the path of a centre lies, if it stands still."""
    slide = reading.method.structure.slides.get(name)
    if slide is None or slide.guide != FRAME:
        return
    place = reading.plot.facts.shapes[FRAME][slide.line.origin]
    x, y = (reading.on_paper(value) for value in (place.real, place.imag))
    path = reading.path(name)
    angle = degrees(slide.line.direction)
    yield Sentence(reading.say("fixed path", path=path[0].upper() + path[1:], place=f"({x}, {y})", angle=angle))
