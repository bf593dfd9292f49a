"""Random mechanisms drawn and measured again."""

from __future__ import annotations

import os
import random
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import repeating
import rolling_machines
from random_mechanisms import (
    DYADS,
    cam,
    chain,
    circular_slot,
    coupler_angle,
    cylinder,
    dyad,
    epicyclic,
    geared_five_bar,
    relative_angle,
    rolling,
    six_bar,
    triad,
)
from renamed import renamed

from graphkin import Drawing
from graphkin.check import RulerReport, measured
from graphkin.check.drawing import read
from graphkin.errors import DeadPoint, TooLargeForPaper
from graphkin.files import loads
from graphkin.model.mechanism import Mechanism
from graphkin.outputs.svg import svg

FAMILIES: dict[str, Callable[[int], Mechanism]] = {
    **{kind: lambda seed, kind=kind: dyad(kind, seed) for kind in DYADS},
    "cylinder": cylinder, "relative": relative_angle, "coupler": coupler_angle, "chain": chain, "triad": triad,
    "six": six_bar, "geared": geared_five_bar, "epicyclic": epicyclic, "rolling": rolling, "cam": cam,
    "circular": circular_slot,
    "line": lambda seed: loads(rolling_machines.rolling_line(10 + seed)),
}  # fmt: skip
PAPER = None if "GRAPHKIN_RANDOM" in os.environ else "A3"
"""Of what is drawn to be read: choosing it takes longer than all the rest."""
if "GRAPHKIN_RANDOM" in os.environ:
    FAMILIES |= {
        **{name: lambda seed, f=f: loads(f(seed)) for name, f in rolling_machines.FAMILIES.items()},
        **{name: lambda seed, f=f: loads(f(random.Random(seed), 0.0)) for name, (f, _) in repeating.FAMILIES.items()},
    }


def make(family: str, seed: int) -> Mechanism:
    """A random mechanism; every second one with words and points' names for its links."""
    found = replace(FAMILIES[family](seed), text="# random")
    return renamed(found, seed) if seed % 2 else found


@lru_cache(maxsize=64)
def drawn(family: str, seed: int) -> str | None:
    """A drawing; None at a dead point."""
    try:
        return svg(Drawing.of(make(family, seed)).sheet(paper=PAPER))
    except (DeadPoint, TooLargeForPaper):
        return None


def read_back(folder: Path, text: str, mechanism: Mechanism) -> RulerReport:
    path = folder / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    return measured(read(path), mechanism, 0.01)


def wrong(report: RulerReport) -> list[object]:
    return [entry for entry in report.measured if not entry.off_mm <= 0.01] + list(report.faults)
