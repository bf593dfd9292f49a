"""The ends of vectors: each at the point it names, or beside it by the steps that its mark states."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.check.drawing import DrawingFile, Fault

ASIDE = 1.2
"""Vectors on one line are drawn so far apart: both ends are off their points by a whole number of it [mm]."""
_MOST = 99
"""No arrow is moved by more steps."""

_End = tuple[list[complex], complex]
"""Places of the points that an end names, and where it is."""


def loose_ends(drawing: DrawingFile, tolerance_mm: float) -> Iterator[Fault]:
    """Vectors must start and end at the points they name; or as far beside them as they say."""
    places: dict[tuple[str | None, str | None], list[complex]] = {}
    for attributes, place in drawing.points:
        places.setdefault((attributes.get("data-plane"), attributes.get("data-name")), []).append(place)
    for attributes, tail, head in drawing.vectors:
        ends = [(places.get((attributes.get("data-plane"), attributes.get(key)), []), end)
                for key, end in (("data-tail", tail), ("data-head", head))]  # fmt: skip
        aside = _aside(attributes, *ends)
        for key, (here, end) in zip(("data-tail", "data-head"), ends, strict=True):
            name, point = attributes.get("data-name"), attributes.get(key)
            apart = [abs(place + aside - end) for place in here]
            if not apart:
                yield Fault("loose", f"{name}: {point}")
            elif not min(apart) <= tolerance_mm:
                yield Fault("end", f"{name} - {point}: {min(apart):.4f} mm")


def _aside(attributes: Mapping[str, str], tail: _End, head: _End) -> complex:
    """The distance of a vector from the line of its points, at right angles to it, to the side where it lies."""
    steps, along = attributes.get("data-aside", ""), head[1] - tail[1]
    if not (steps.isascii() and steps.isdigit() and int(steps) < _MOST and along and tail[0]):
        return 0j
    off = min((tail[1] - place for place in tail[0]), key=abs)
    across = 1j * along / abs(along) * int(steps) * ASIDE
    return min(across, -across, key=lambda aside: abs(off - aside))
