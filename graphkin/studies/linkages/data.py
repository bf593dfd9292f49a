"""A report for programs: plain numbers in SI units, null where a quantity does not exist."""

from __future__ import annotations

from typing import Any

from graphkin.studies.linkages.equal import even
from graphkin.studies.linkages.linkage import LinkagePosition, MotionRange
from graphkin.studies.linkages.report import Report


def as_json(report: Report) -> dict[str, Any]:
    """`{"format": 1, "kind": .., "grashof": .., ..}`: angles in rad, lengths in m.

    Driver angles are directions to +x, counted as the file's driver counts them; those of a link that is not driven
    go from its fixed to its moving hinge; a slider's place is its displacement [m].
    """
    least, found = report.least, report.advantage
    at = least[0].driver if least else None
    return {
        "format": 1,
        "kind": report.kind,
        "family": report.family or None,
        "grashof": report.grashof,
        "lengths": dict(report.linkage.sizes),
        "driver": report.driver,
        "output": report.output,
        "driver_range": _range(report.driver_span),
        "full_turns": [[turn.first, turn.second] for turn in report.turns if turn.full],
        "swing": report.swing,
        "stroke": report.stroke,
        "limits": [_position(report, end) for end in report.limits],
        "theta": report.theta,
        "K": report.k,
        "slow": _slow(report),
        "gamma_min": report.gamma_min,
        "gamma_min_at": at,
        "alpha_max": report.alpha_max,
        "alpha_max_at": at,
        "critical": [_position(report, end) for end in report.critical],
        "dead_points": {driver: list(values) for driver, values in report.dead.items()},
        "advantage_min": None if found is None else found.least,
        "advantage_min_at": None if found is None else found.at,
    }


def _range(found: MotionRange) -> list[float] | None:
    """From, to; null where it turns round and round."""
    return None if found.full else [found.low, found.high]


def _position(report: Report, end: LinkagePosition) -> dict[str, Any]:
    size = min(1.0, sum(abs(length) for length in report.linkage.sizes.values()))
    driver, output, gamma = (None if x is None else even(x, size) for x in (end.driver, end.output, end.gamma))
    return {"how": end.how, "driver": driver, "output": output, "gamma": gamma}


def _slow(report: Report) -> list[int] | None:
    """From which to which of `limits` (0, 1) the output goes slowly while the driver turns counter-clockwise."""
    return None if report.slow is None else list(report.slow)
