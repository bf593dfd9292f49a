"""The extreme transmission angles of a linkage by the law of cosines, with their figures."""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.say.figures import Formula, figures, squared, written
from graphkin.say.numbers import number
from graphkin.studies.linkages import Report
from graphkin.studies.linkages.linkage import LinkagePosition

_DIGITS = 6
"""An angle follows from its cosine, so this has more than what is read off paper."""


def cosine(report: Report, end: LinkagePosition) -> str:
    """`cos γ = (BC² + CD² − (AD − AB)²)/(2 × BC × CD) = (48² + 55² − 30²)/(2 × 48 × 55) = 0.838826`.

    Of the two positions with the driver on the frame's line, and of the two with the crank across the guide; "" of
    others.
    """
    names = report.linkage.called
    if "rocker" in names and end.how in ("inner", "outer"):
        name, numbers, value = _on_the_frame(report, end.how == "inner")
    elif "slider" in names and end.how in ("near", "far"):
        name, numbers, value = _across_the_guide(report, end.how == "far")
    else:
        return ""
    return f"cos γ = {name} = {written(numbers, value, _DIGITS)} = {number(value, digits=_DIGITS)}"


def _on_the_frame(report: Report, inner: bool) -> tuple[str, Formula, float]:
    """In the triangle of coupler, output and the line between their outer hinges."""
    names = report.linkage.called
    output = names["rocker" if report.driver == names["crank"] else "crank"]
    b, c, d, a = links = (names["coupler"], output, names["frame"], report.driver)
    coupler, rocker, frame, driver = _millimetres(report, links)
    base = abs(frame - driver) if inner else frame + driver
    line, twice = f"({d} {'−' if inner else '+'} {a})²", f"(2 × {b} × {c})"
    two, one, other = figures(2, coupler, rocker)
    value = (coupler**2 + rocker**2 - base**2) / (2 * coupler * rocker)
    if value >= 0:
        above, shown = f"{b}² + {c}² − {line}", squared(coupler) + squared(rocker) - squared(base)
    else:
        above, shown = f"{line} − {b}² − {c}²", squared(base) - squared(coupler) - squared(rocker)
    return f"({above})/{twice}", shown / (two * one * other), abs(value)


def _across_the_guide(report: Report, far: bool) -> tuple[str, Formula, float]:
    """From how far the crank's end is from the guide."""
    names = report.linkage.called
    crank, rod, offset = map(abs, _millimetres(report, (names["crank"], names["coupler"], "e")))
    (a, one), (e, aside), (long,) = (names["crank"], crank), ("|e|", offset), figures(rod)
    if not offset:
        return f"{a}/{names['coupler']}", figures(crank)[0] / long, crank / rod
    if not far and offset > crank:
        (a, one), (e, aside) = (e, aside), (a, one)
    first, second = figures(one, aside)
    above, sign = (first + second, "+") if far else (first - second, "−")
    return f"({a} {sign} {e})/{names['coupler']}", above / long, abs(one + aside if far else one - aside) / rod


def _millimetres(report: Report, links: tuple[str, ...]) -> Iterator[float]:
    return (report.linkage.sizes[link] * 1e3 for link in links)
