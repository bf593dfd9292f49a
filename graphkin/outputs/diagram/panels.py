"""Panels of a motion diagram: curves that stand together, their axes and divisions, and all words in both languages."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphkin.base.geometry import number
from graphkin.base.scales import multiples, round_step
from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.model.quantities import driven
from graphkin.model.units import Unit
from graphkin.outputs.diagram.curves import Curves
from graphkin.outputs.diagram.fonts import typeset, writable
from graphkin.running.path import Event
from graphkin.say.catalogue import say, say_close
from graphkin.say.names import in_signs
from graphkin.say.numbers import degrees, given_figure, heading
from graphkin.say.sweeps import one_of_several, why
from graphkin.say.text_table import unbraced
from graphkin.sheet.lettering import link_label
from graphkin.sheet.lettering import number as number_label
from graphkin.studies.sweeps import Series

MOST = 6  # more curves than these do not stand together
KINDS = ("position", "velocity", "acceleration", "ratio")
LETTERS = {"rad": "θ", "m": "s", "rad/s": "ω", "m/s": "v", "rad/s^2": "α", "m/s^2": "a", "1": ""}
_APART, _NEAR, _PART = 1.25, 0.012, 0.08
"""So much coarser is an axis whose curves would hide others; parts of the height, and of the way, on which they do."""
HEADROOM = 0.16  # room above and below the curves for what is written at them, as a part of their height

_PLACE = {"rad": (0, 0), "m": (0, 1), "rad/s": (1, 0), "m/s": (1, 1), "rad/s^2": (2, 0), "m/s^2": (2, 1), "1": (3, 0)}
"""By SI unit: the kind of panel, and whether it is the second axis of one."""


@frozen
class CurveAxis:
    """An upright axis: SI unit, and the numbers of its curves."""

    unit: str
    curves: tuple[int, ...]


@frozen
class CurvePanel:
    """Curves that stand together: one axis, or one on each side."""

    kind: str
    axes: tuple[CurveAxis, ...]


def panels(units: Mapping[int, str]) -> tuple[CurvePanel, ...]:
    """Position above velocity above acceleration, quotients last; too many curves are shared out evenly.

    units  of the curves, by their numbers
    """
    panels: list[CurvePanel] = []
    for place, kind in enumerate(KINDS):
        groups: dict[str, list[int]] = {}
        for k, unit in sorted(units.items(), key=lambda entry: (_PLACE.get(entry[1], (3, 1))[1], entry[0])):
            if _PLACE.get(unit, (3, 1))[0] == place:
                groups.setdefault(unit, []).append(k)
        if len(groups) <= 2 and sum(map(len, groups.values())) <= MOST:
            if groups:
                panels.append(CurvePanel(kind, tuple(CurveAxis(unit, tuple(group)) for unit, group in groups.items())))
            continue
        for unit, group in groups.items():
            size = math.ceil(len(group) / math.ceil(len(group) / MOST))
            parts = (tuple(group[begin : begin + size]) for begin in range(0, len(group), size))
            panels += (CurvePanel(kind, (CurveAxis(unit, part),)) for part in parts)
    return tuple(panels)


def limits(curves: Curves, panel: CurvePanel) -> list[tuple[float, float]]:
    """Least and greatest value of each axis, as shown; the zeros of two axes of a panel lie on one line."""
    with_zero = panel.kind != "position"
    ends: list[tuple[float, float]] = []
    for axis in panel.axes:
        factor = curves.shown(axis.unit).factor
        bounds = [(low * factor, high * factor) for low, high in map(curves.bounds, axis.curves)]
        bounds += [(0.0, 0.0)] if with_zero else []
        ends.append((min(low for low, _ in bounds), max(high for _, high in bounds)))
    if with_zero:
        sizes = [max(-low, high) or 1.0 for low, high in ends]
        down = max(-low / size for (low, _), size in zip(ends, sizes, strict=True))
        up = max(high / size for (_, high), size in zip(ends, sizes, strict=True))
        ends = [(-down * size, up * size) for size in sizes]
        if len(ends) > 1 and _hidden(curves, panel, ends):
            ends[1] = (_APART * ends[1][0], _APART * ends[1][1])
    shown = []
    for low, high in ends:
        size = high - low
        if size <= 1e-9 * max(abs(low), abs(high)) or size == 0:
            size = abs(high) or 1.0
        shown.append((low - HEADROOM * size, high + HEADROOM * size))
    return shown


def _hidden(curves: Curves, panel: CurvePanel, ends: Sequence[tuple[float, float]]) -> bool:
    """True where a curve of the second axis would lie on one of the first over a part of its way, off zero."""
    first, second = ([curves.series[k].signed * curves.shown(axis.unit).factor / (high - low) for k in axis.curves]
                     for axis, (low, high) in zip(panel.axes, ends, strict=True))  # fmt: skip
    close = ((abs(one - other) < _NEAR) & (abs(one) > 2 * _NEAR) for one in first for other in second)
    return any(np.mean(each) > _PART for each in close)


def division(low: float, high: float, most: int, degrees: bool = False) -> list[float]:
    """Round values from low to high, at most so many: steps of 1, 2, 5, and of 15, 30, 60, 90 for degrees."""
    least = (high - low) / most
    step = next((s for s in (15.0, 30.0, 60.0, 90.0, 180.0, 360.0) if s >= least), 0.0) if degrees else 0.0
    if not step or (degrees and least <= 10):
        step = round_step(least, up=True)
    return list(map(float, multiples(low, high, step)))


def figure_of(value: float) -> str:
    """A number at a curve: `−3.919`, `2.013×10⁻⁵` as matplotlib writes them; four digits, as on paper."""
    if value and not 1e-4 <= abs(value) < 1e5:
        return typeset(number_label(value, 4))
    return (f"{value:#.4g}" if abs(value) < 1e4 and value else f"{value:.0f}").replace("-", "−").rstrip(".")


def place_of(curves: Curves, t: float) -> str:
    """The driver's value at which something is reached: `125.3°`, `72.35 mm`; as finely as the diagram shows it."""
    course = curves.course
    unit, parts = curves.shown(course.unit), 2000 if course.angular else 5000
    step = abs(number(course.value(curves.high)) - number(course.value(curves.low))) * unit.factor / parts
    digits = max(0, -math.floor(math.log10(step)))
    value = round(number(course.value(t)) * unit.factor, digits) + 0.0
    return f"{value:.{digits}f}".replace("-", "−") + unit.after


def across(curves: Curves, lang: Lang) -> str:
    """The name of the x axis."""
    course, driver = curves.course, curves.course.driver
    kind = "between" if driver.kind == "angle" and driver.from_vector is not None else driver.kind
    name, unit = writable(course.method.mechanism.driver_title(driver, lang)), curves.shown(course.unit).sign
    return say_close(f"diagrams.across {kind}", lang, name=name, unit=unit)


def upright_label(unit: str, shown: Unit, lang: Lang, power: int = 0) -> str:
    """The name of a y axis: `ω [rad/s]`, in Chinese as the standard has it `ω /(rad/s)`."""
    name, letter = shown.sign, LETTERS.get(unit, "")
    if power:
        name = f"10^{{{power}}}" + (f"\\ {name}" if name else "")
    name = "$\\mathrm{" + name.replace("²", "^2") + "}$" if "²" in name or "\\" in name or power else name
    letter = typeset(link_label(letter)) if letter else ""
    if lang == "en":
        return f"{letter} [{name}]".strip() if name else letter
    compound = any(sign in name for sign in "/° ")
    return (f"{letter} /({name})" if compound else f"{letter} /{name}").strip() if name else letter


def about_drivers(curves: Curves, lang: Lang) -> str:
    """`driver AB: ω = 10 rad/s`, and where those stand that do not move."""
    colon, comma, course = say("common.colon", lang), say("common.and", lang), curves.course
    drivers = []
    for k, driver in enumerate(course.method.drivers):
        slides = driver.kind == "slide"
        still = not course.path.pace[k]
        parts = [curves.shown(driven(slides)).shown(float(course.path.start[k]))] if still else []
        rates = zip("va" if slides else "ωα", ("m/s", "m/s^2") if slides else ("rad/s", "rad/s^2"))
        for (letter, unit), rate in zip(rates, (driver.rate, driver.acceleration), strict=True):
            if rate or (letter in "vω" and not still):
                shown = curves.shown(unit)
                parts.append(f"{letter} = {given_figure(rate * shown.factor)} {shown.sign}")
        name = writable(course.method.mechanism.driver_title(driver, lang))
        drivers.append(f"{name}{colon}{comma.join(part.replace('-', '−') for part in parts)}")
    key = "diagrams.driver" if len(drivers) == 1 else "diagrams.drivers"
    return say_close(key, lang, names=say("common.semicolon", lang).join(drivers))


def event_mark(event: Event, lang: Lang) -> str:
    """The word beside an upright line."""
    if event.choices or event.kind == "two ways":
        return say("diagrams.event change", lang)
    return say("diagrams.event limit" if event.kind in ("tangent", "parallel") else "diagrams.event dead", lang)


def foot_lines(curves: Curves, layout: Sequence[CurvePanel], lang: Lang) -> Iterator[str]:
    """The lines below the diagram: what one does not see in its curves, and where the driver stops or may turn."""
    machine, moved, sizes = curves.course.method.mechanism, curves.course.driver, list[Series]()
    driver = writable(machine.driver_title(moved, lang))
    yield from one_of_several(curves.course, driver, lang)
    if moved.rate < 0:
        yield say_close("diagrams.backwards", lang, driver=driver)
    if any(each.acceleration for each in machine.drivers):
        yield say("diagrams.as stated", lang)
    ways = dict[str, list[Series]]()
    for panel in layout:
        every = [curves.series[k] for axis in panel.axes for k in axis.curves]
        if any(np.nanmin(each.signed, initial=0.0) < 0 for each in every):
            sizes += [one for one in every if one.vectors is not None and one.along is None]
        for one in every:
            if one.along is not None:
                ways.setdefault(heading(degrees(one.along), lang), []).append(one)
            elif one.unit in ("rad/s", "rad/s^2"):
                ways.setdefault(say("common.ccw", lang), []).append(one)
    for way, those in ways.items():
        if any(np.nanmin(each.signed, initial=0.0) < 0 for each in those):
            yield say("diagrams.signs", lang, names=_listed(those, lang), way=way)
    if sizes:
        yield say("diagrams.sizes", lang, names=_listed(sizes, lang))
    yield from (event_line(curves, event, lang) for event in curves.events)


def _listed(every: Sequence[Series], lang: Lang) -> str:
    return writable(unbraced(say("common.list", lang).join(in_signs(one.name) for one in every)))


def event_line(curves: Curves, event: Event, lang: Lang) -> str:
    """The place of an upright line, and its links."""
    mark, reason = event_mark(event, lang), writable(why(event, lang))
    return say("diagrams.event", lang, mark=mark[0].upper() + mark[1:], place=place_of(curves, event.at), why=reason)
