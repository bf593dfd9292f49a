"""Scales of drawings whose tolerances are to be those of a known paper, whatever paper their sheets take."""

from __future__ import annotations

from dataclasses import replace

from graphkin.model.mechanism import Mechanism

SCALES = {
    "p3-19": {"length": 0.0005, "velocity": 0.002, "acceleration": 0.0006},
    "PRR 0": {"length": 0.002, "velocity": 0.006, "acceleration": 0.03},
    "ex3-7": {"length": 0.004, "velocity": 0.0015, "acceleration": 0.002},
}


def at_paper_scales(machine: Mechanism, place: str) -> Mechanism:
    return replace(machine, scales=SCALES.get(place, machine.scales))
