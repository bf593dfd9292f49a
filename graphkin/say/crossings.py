"""Which of two crossings is meant, in words a reader can see on the paper: above, below, left or right."""

from __future__ import annotations

from graphkin.base.geometry import dot
from graphkin.construction import Arc, Meet, Ray
from graphkin.say import names
from graphkin.say.reading import Reading

_LEVEL = 0.5
"""A line whose slope is above this part of its length is called upright."""


def crossing(reading: Reading, step: Meet) -> str:
    """`C above BD` of two circles, `the upper one` of a line and a circle; "" where both crossings are one."""
    assert isinstance(step.second, Arc)
    here, about = complex(reading.plot.position[step.point]), complex(reading.plot.position[step.second.about])
    if isinstance(step.first, Ray):
        along = complex(reading.plot.direction(step.first.direction))
        chord = 2 * float(dot(along, here - about)) * along
        return reading.say(f"derivation.which {_side(chord)}") if abs(chord) > _near(reading, here, about) else ""
    other = complex(reading.plot.position[step.first.about])
    foot = other + float(dot(about - other, here - other)) / abs(about - other) ** 2 * (about - other)
    if abs(here - foot) <= _near(reading, here, about):
        return ""
    words = {"point": names.point(step.point), "line": _line(reading, step.first, step.second)}
    return reading.say(f"derivation.side {_side(here - foot)}", **words)


def _near(reading: Reading, here: complex, about: complex) -> float:
    """A crossing nearer to the other one than this cannot be told from it."""
    return max(reading.noise, 1e-6 * abs(here - about))


def _side(way: complex) -> str:
    if abs(way.imag) > _LEVEL * abs(way):
        return "above" if way.imag > 0 else "below"
    return "right" if way.real > 0 else "left"


def _line(reading: Reading, first: Arc, second: Arc) -> str:
    """The line through both centres."""
    ends = (first.about, second.about)
    return names.pair(*ends) if all(map(reading.named, ends)) else "–".join(map(reading.place, ends))
