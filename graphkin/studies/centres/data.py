"""Instant centres as plain data for JSON: SI units, radians."""

from __future__ import annotations

from typing import Any

import numpy as np

from graphkin.construction.drafting import LineStep, Stage, drawn_through
from graphkin.studies.centres.instant_centres import Centres
from graphkin.studies.centres.search import Centring

Json = dict[str, Any]


def as_json(found: Centres) -> Json:
    """One object: of each centre its links, its place [m] or direction [rad], and how it is found.

    `by` is "hinge", "contact" (wheels that roll on each other), "slide", "velocities", or the two lines: each two
    centres that it joins, or ["normal"]. Links that do not move against each other have "by": "together" and no place.
    """
    mechanism = found.method.mechanism
    stages = {stage.last.name: stage for stage in found.centring.stages}
    centres: dict[str, Json] = {}
    for first, second in found.pairs:
        name = found.name(first, second)
        entry: Json = {"links": [mechanism.called(first), mechanism.called(second)]}
        if name in stages:
            entry |= place(found, first, second) | {"by": found_by(found.centring, stages[name])}
        else:
            entry |= {"by": "together"}
        centres[name] = entry
    return {"format": 1, "name": mechanism.name, "centres": centres}


def place(found: Centres, first: str, second: str) -> Json:
    """`at` [m], `direction` [rad] for a centre at infinity, nothing where there is none."""
    if found.together(first, second):
        return {}
    cut = found.method.mechanism.usual.cut
    at = complex(cut(found.place(first, second), "m"))
    if np.isfinite(at):
        return {"at": [at.real + 0.0, at.imag + 0.0]}
    return {"direction": float(cut(found.direction(first, second), "rad")) + 0.0}


def found_by(centring: Centring, stage: Stage) -> str | list[list[str]]:
    """A rule's name, or the two lines on which a centre lies."""
    return [_line(centring, line) for line in stage.lines] if stage.say == "two lines" else stage.say


def _line(centring: Centring, line: LineStep) -> list[str]:
    return ["normal"] if line.name in centring.normals else [*drawn_through(line)]
