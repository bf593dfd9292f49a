"""What drives the mechanism: an arc with an arrow for a turning link, a straight arrow for a driven slide."""

from __future__ import annotations

import cmath
import math

from graphkin.mechanism import FRAME, Driver
from graphkin.sheet import symbols
from graphkin.sheet.labels import Wanted
from graphkin.sheet.lettering import Label, joined, quantity_label
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure

__all__ = ["drives"]


def drives(skeleton: Skeleton) -> Figure:
    """Arrows of all drivers that move."""
    figure = Figure()
    for driver in skeleton.mechanism.drivers:
        if driver.rate == 0 and driver.acceleration == 0:
            continue
        if driver.kind == "slide":
            _slide_arrow(skeleton, driver, figure)
        elif driver.vector is not None:
            _turn_arrow(skeleton, driver, figure)
    return figure


def _turn_arrow(skeleton: Skeleton, driver: Driver, figure: Figure) -> None:
    """About the vector's tail, starting at the link in the sense of its rotation."""
    assert driver.vector is not None
    at, tip = skeleton.at(driver.vector[0]), skeleton.at(driver.vector[1])
    if abs(tip - at) < 1:
        return
    towards = (tip - at) / abs(tip - at)
    sense = driver.rate or driver.acceleration
    radius = min(9.0, max(5.0, 0.45 * abs(tip - at)))
    marks = symbols.spin(at, towards, sense, radius, skeleton.step(*driver.vector))
    figure.marks += marks
    middle = towards * cmath.rect(1, -math.copysign(math.radians(45), sense))
    label = _turn_label(skeleton, driver)
    figure.wanted.append(Wanted(label, at + middle * radius, gap=0.3, away=middle, step=marks[0].step))


def _turn_label(skeleton: Skeleton, driver: Driver) -> Label:
    called = skeleton.mechanism.called(driver.link)
    if driver.from_link != FRAME:
        called += skeleton.mechanism.called(driver.from_link)
    letters = ["ω"] if driver.rate else []
    letters += ["α"] if driver.acceleration else []
    return joined([quantity_label(letter, called) for letter in letters])


def _slide_arrow(skeleton: Skeleton, driver: Driver, figure: Figure) -> None:
    """Beside the block, the way it goes."""
    slide = skeleton.mechanism.slide(driver.link)
    along = skeleton.along(slide) * math.copysign(1, driver.rate or driver.acceleration)
    across = along * 1j if (along * 1j).imag <= 0 else along * -1j
    start = skeleton.at(slide.point) + across * 5.2 - along * 4
    marks = symbols.push(start, along, skeleton.step(slide.point))
    figure.marks += marks
    if slide.guide == FRAME:
        label = quantity_label("v", slide.point)
    else:
        names = [skeleton.mechanism.called(link) for link in reversed(slide.joins)]
        label = quantity_label("v", "".join(names))
    figure.wanted.append(Wanted(label, start, start + 11 * along, away=across, step=marks[0].step))
