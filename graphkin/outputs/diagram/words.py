"""The words of a motion diagram, in both languages."""

from __future__ import annotations

import math

from graphkin.errors import Lang
from graphkin.model.quantities import EDGE, IN_GRAVITY, driven
from graphkin.outputs.diagram.curves import Curves
from graphkin.outputs.diagram.fonts import typeset, writable
from graphkin.outputs.diagram.panels import LETTERS
from graphkin.running.path import Event
from graphkin.say.catalogue import say
from graphkin.say.sweeps import why
from graphkin.sheet.lettering import link_label, number
from graphkin.studies.sweeps import Course

_RATES = {"slide": ("v", "m/s", "a", "m/s²")}


def _signed(text: str) -> str:
    return text.replace("-", "−")


def figure_of(value: float, unit: str = "") -> str:
    """A number at a curve: `−3.919`, `117.0°`, `2.013×10⁻⁵` as matplotlib writes them; four digits, as on paper."""
    if value == 0 or 1e-4 <= abs(value) < 1e5:
        text = _signed(f"{value:#.4g}" if abs(value) < 1e4 and value else f"{value:.0f}").rstrip(".")
    else:
        text = typeset(number(value, 4))
    return f"{text}{unit}"


def place_of(found: Curves, t: float) -> str:
    """Where a value is reached: `125.3°`, `72.35 mm`; as finely as is told apart in the diagram."""
    course = found.course
    unit, parts = EDGE[course.unit], 2000 if course.angular else 5000
    step = abs(float(course.value(found.high)) - float(course.value(found.low))) * unit.factor / parts
    digits = max(0, -math.floor(math.log10(step)))
    value = round(float(course.value(t)) * unit.factor, digits) + 0.0
    return _signed(f"{value:.{digits}f}") + unit.after


def across(course: Course, lang: Lang) -> str:
    """What the x axis shows."""
    driver = course.driver
    kind = "between" if driver.kind == "angle" and driver.from_vector is not None else driver.kind
    return say(f"diagrams.across {kind}", lang, name=writable(driver.name))


def upright_label(unit: str, lang: Lang, power: int = 0) -> str:
    """What a y axis shows: `ω [rad/s]`, in Chinese as the standard has it `ω /(rad/s)`."""
    name, letter = (IN_GRAVITY if unit == "g" else EDGE[unit]).sign, LETTERS.get(unit, "")
    name = r"\mathit{g}" if name == "g" else name
    if power:
        name = f"10^{{{power}}}" + (f"\\ {name}" if name else "")
    name = "$\\mathrm{" + name.replace("²", "^2") + "}$" if "²" in name or "\\" in name or power else name
    letter = typeset(link_label(letter)) if letter else ""
    if lang == "en":
        return f"{letter} [{name}]".strip() if name else letter
    compound = any(sign in name for sign in "/° ")
    return (f"{letter} /({name})" if compound else f"{letter} /{name}").strip() if name else letter


def about_drivers(course: Course, lang: Lang) -> str:
    """`driver AB: ω = 10 rad/s`, and where those stand that do not move."""
    colon, comma = say("common.colon", lang), say("common.and", lang)
    why = []
    for k, driver in enumerate(course.method.drivers):
        speed, per_second, gain, per_square = _RATES.get(driver.kind, ("ω", "rad/s", "α", "rad/s²"))
        still = not course.path.pace[k]
        parts = [] if still and not driver.rate else [f"{speed} = {_signed(f'{driver.rate:.6g}')} {per_second}"]
        if driver.acceleration:
            parts.append(f"{gain} = {_signed(f'{driver.acceleration:.6g}')} {per_square}")
        if still:
            parts.insert(0, _signed(EDGE[driven(driver.kind == "slide")].shown(float(course.path.start[k]))))
        why.append(f"{writable(driver.name)}{colon}{comma.join(parts)}")
    word = say("diagrams.driver" if len(why) == 1 else "diagrams.drivers", lang)
    return word + say("common.semicolon", lang).join(why)


def event_mark(event: Event, lang: Lang) -> str:
    """The word beside an upright line."""
    if event.choices or event.kind == "two ways":
        return say("diagrams.event change", lang)
    return say("diagrams.event limit" if event.kind in ("tangent", "parallel") else "diagrams.event dead", lang)


def event_line(found: Curves, event: Event, lang: Lang) -> str:
    """The line below the diagram: where, and which links."""
    mark = event_mark(event, lang)
    words = {"mark": mark[0].upper() + mark[1:], "place": place_of(found, event.at), "why": writable(why(event, lang))}
    return say("diagrams.event", lang, **words)

