"""What a linkage does, in figures: its lengths, limits, time ratio and angles of transmission."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphkin.sheet.lettering import Label, Run, number, point_label, points_label, quantity_label
from graphkin.sheet.titleblock import Table
from graphkin.studies.linkages import Report

Row = tuple[Label, Label]


def linkage_tables(reports: Sequence[Report]) -> list[Table]:
    """One for each linkage, headed by its letters."""
    return [Table((called(report), ()), tuple(_rows(report))) for report in reports]


def called(report: Report) -> Label:
    """`ABCD`."""
    return tuple(run for name in report.linkage.names for run in point_label(name))


def _rows(report: Report) -> Iterator[Row]:
    for name, size in report.linkage.sizes.items():
        yield points_label(name), _mm(size)
    if report.swing is not None:
        yield quantity_label("ψ", ""), _degrees(report.swing)
    if report.stroke is not None:
        yield quantity_label("H", ""), _mm(report.stroke)
    if report.theta is not None:
        yield quantity_label("θ", ""), _degrees(report.theta)
    if report.k is not None:
        yield quantity_label("K", ""), number(report.k)
    for letter, low, angle in (("γ", "min", report.gamma_min), ("α", "max", report.alpha_max)):
        if angle is not None:
            yield (Run(letter, True), Run(low, place="sub")), _degrees(angle)


def _mm(length: float) -> Label:
    return (*number(length * 1e3), Run(" mm"))


def _degrees(angle: float) -> Label:
    return (*number(math.degrees(angle)), Run("°"))
