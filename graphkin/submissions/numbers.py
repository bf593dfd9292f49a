"""Text, values and paper scales as students type them: number, unit, sense, sometimes its direction.

The units are the mechanism file's own. A bare number stands in the house's edge unit (mm, deg, rad/s, m/s ..). One
comma alone is a decimal comma; beside a point, the last of the two is the decimal sign.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

from graphkin.base.value import frozen
from graphkin.construction import Plane
from graphkin.errors import NOWHERE, GraphkinError, NotAnAnswer, OtherDimension, OutOfRange, SenseDisputed
from graphkin.files.values import UNITS, read_quantity
from graphkin.model.mechanism import Dimension, Mechanism
from graphkin.submissions.submission import HandedValue, Sense

_RAISED = re.compile("[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_ALIKE = str.maketrans({
    **dict.fromkeys("−–—‐‑‒―﹣－➖", "-"), "º": "°", "˚": "°", "∘": "°", "∕": "/", "⁄": "/", "÷": "/", "·": "*",
    "⋅": "*", "∙": "*", "•": "*", "×": "*", "✕": "*", "﹢": "+", "，": ",", "；": ";", "：": ":", "。": ".", "（": "(",
    "）": ")", "【": "[", "】": "]", "\u2019": "'", "\u2032": "'", "\u02b9": "'", "\u2033": "''", "\u2034": "'''",
    "\u02bc": "'", "´": "'", "`": "'", "＝": "=", "≈": "=", "≅": "=", "≃": "=", "～": "=", "\u200b": "", "\ufeff": "",
})  # fmt: skip


def plain(text: str) -> str:
    """`−3,92 rad/s²` -> `-3,92 rad/s^2`: compatibility letters folded, and what looks alike written one way."""
    text = _RAISED.sub(lambda run: "^" + unicodedata.normalize("NFKC", run.group()).replace("−", "-"), text)
    text = unicodedata.normalize("NFKC", text.translate(_ALIKE)).translate(_ALIKE)
    return " ".join(text.split())


def short(text: str) -> str:
    """On one line and not too long, for a message."""
    return " ".join(text[:200].split())[:60]


def unaccented(text: str) -> str:
    """Without combining marks: the bar or the arrow over a vector's letter."""
    return "".join(letter for letter in unicodedata.normalize("NFD", text) if not unicodedata.combining(letter))


DIMENSIONS: Mapping[str, Dimension | None] = {
    "rad": "angle", "rad/s": "angular velocity", "rad/s^2": "angular acceleration", "m": "length", "m/s": "velocity",
    "m/s^2": "acceleration", "1": None,
}  # fmt: skip
"""By the SI unit of a quantity, whose units may stand with it."""
_TURNING = ("angle", "angular velocity", "angular acceleration")
LONGEST = 200  # no value is written with more letters

_BODY = r"[0-9]+(?:[ ',.][0-9]+)*[.,]?|[.,][0-9]+"
_POWER = r"[eE][+-]?[0-9]+| ?(?:\*|x|X) ?10 ?(?:\^|\*\*)? ?\(?[+-]?[0-9]+\)?"
_NUMBER = re.compile(rf"([+-]?) ?({_BODY})({_POWER})?(?![0-9A-Za-z]*[0-9])")
_SENSES: tuple[tuple[Sense, re.Pattern[str]], ...] = (
    ("ccw", re.compile(
        r"(?:counter|anti)[- ]?clock[- ]?wise|\bccw\b|\bacw\b|[逆反][时時][针針](?:方向)?|逆|[↺⟲🔄]", re.I)),
    ("cw", re.compile(r"clock[- ]?wise|\bcw\b|[顺順][时時][针針](?:方向)?|[顺順]|[↻⟳🔃]", re.I)),
)  # fmt: skip
_BEFORE = re.compile(r"^(?:[^=<>]*=)+ *")
_PER_SECOND = re.compile(r"(?<=[0-9 ]) ?1 ?/ ?s")
_ANGLE = re.compile(r"\s*(?:∠|@|\bat\b|,(?= *[+-]?[0-9.]+ *°))\s*", re.I)
_GROUPS = re.compile(r"[0-9]{1,3}(?:[ ',.][0-9]{3})+")


@frozen
class WrittenNumber:
    """A value taken apart: `number` as written, its unit in the house's spelling or as typed, the sense in words."""

    number: float
    unit: str
    sense: Sense | None


def parsed_value(text: str, si: str, unit: str = "") -> HandedValue:
    """The value that a text gives for a quantity of this SI unit; `unit` is that of its column. Faults come with
    `NOWHERE`."""
    size, *direction = _ANGLE.split(plain(text), maxsplit=1)
    try:
        value = _in_si(text, written(size, text), DIMENSIONS[si], unit)
        if not direction or value.value is None:
            return value
        at = written(direction[0], text)
        angle = read_quantity(f"{at.number!r} {unit_named(at.unit)}" if at.unit else at.number, "angle")
        return replace(value, vector=complex(value.value * math.cos(angle), value.value * math.sin(angle)))
    except GraphkinError as fault:
        return HandedValue(text, None, fault=fault)


def _in_si(text: str, value: WrittenNumber, dimension: Dimension | None, unit: str) -> HandedValue:
    sense = value.sense if dimension in _TURNING else None
    if sense == "ccw" and value.number < 0:
        raise SenseDisputed(NOWHERE, text[:LONGEST])
    sized = abs(value.number) * (-1 if sense == "cw" else 1) if sense else value.number
    name = unit_named(value.unit or unit)
    if dimension is None and name:
        raise NotAnAnswer(NOWHERE, text[:LONGEST])
    if dimension is None:
        return HandedValue(text, read_quantity(sized, "velocity"), sense)
    shown = name.replace("²", "^2")
    try:
        return HandedValue(text, read_quantity(f"{sized!r} {name}" if name else sized, dimension), sense, shown)
    except OtherDimension as fault:
        return HandedValue(text, read_quantity(sized, dimension), sense, shown, fault)


def written(text: str, whole: str) -> WrittenNumber:
    """A plain text taken apart. Raises NotAnAnswer with `whole`, SenseDisputed where both senses are named."""
    if len(text) > LONGEST:
        raise NotAnAnswer(NOWHERE, whole[:40] + "..")
    text = _PER_SECOND.sub("rad/s", _BEFORE.sub("", text))
    senses: set[Sense] = set()
    for sense, words in _SENSES:
        text, times = words.subn(" ", text)
        senses |= {sense} if times else set()
    if len(senses) > 1:
        raise SenseDisputed(NOWHERE, whole[:LONGEST])
    text = re.sub(r"[(\[] *[)\]]", "", text).strip(" ,;=") if senses else text.strip(" ;=")
    match = _NUMBER.match(text)
    if match is None:
        raise NotAnAnswer(NOWHERE, whole[:LONGEST])
    sign, body, power = match.groups()
    exponent = re.sub(r"^(?:[eE]| ?[*xX] ?10 ?(?:\^|\*\*)? ?\(?)", "", power or "").rstrip(")")  # of `e-3`, `*10^-3`
    if len(exponent) > 5:
        raise NotAnAnswer(NOWHERE, power.strip()[:40])
    # with a point as the decimal sign and no groups: of `3,92`, `1 234.5`, `1.234,5`
    points, commas = body.count("."), body.count(",")
    decimal = ""
    if points and commas:
        decimal = max(".,", key=body.rfind)
    elif points == 1 or commas == 1:
        decimal = "." if points else ","
    head, _, tail = body.rpartition(decimal) if decimal else (body, "", "")
    if (not tail.isdigit() and tail) or (not head.isdigit() and head and not _GROUPS.fullmatch(head)):
        raise NotAnAnswer(NOWHERE, whole[:LONGEST])
    value = float(f"{re.sub('[^0-9]', '', head) or '0'}.{tail or '0'}e{int(exponent or 0)}")
    unit = text[match.end() :].strip(" ,;")
    return WrittenNumber(-value if sign == "-" else value, unit, next(iter(senses), None))


_SPELT = (
    (r"\s+|\\|\$|\{|\}|\bmathrm\b", ""), (r"\*\*", "^"), (r"毫米", "mm"), (r"厘米", "cm"),
    (r"米", "m"), (r"弧度", "rad"),
    (r"度|°|degrees?|degs?\b", "deg"), (r"radians?|rads\b", "rad"), (r"分钟?|minutes?|\bmins\b", "min"),
    (r"秒|seconds?|secs?", "s"), (r"revolutions?|revs\b|转|圈", "rev"), (r"millimet(?:re|er)s?", "mm"),
    (r"met(?:re|er)s?", "m"), (r"inch(?:es)?", "in"), (r"feet|foot", "ft"), (r"每", "/"), (r"per", "/"),
    (r"[()\[\]]", ""), (r"²", "^2"), (r"[*.]?s\^?-1", "/s"), (r"[*.]?s\^?-2", "/s^2"), (r"/s/s|/s\*s|/ss", "/s^2"),
    (r"/s2$", "/s^2"), (r"^1/s", "rad/s"), (r"^/s", "rad/s"), (r"^r(?:ev)?/min", "r/min"), (r"^r/s", "rev/s"),
)  # fmt: skip
_SPELT_TESTED = tuple((re.compile(pattern), better) for pattern, better in _SPELT)


def unit_named(text: str) -> str:
    """A unit in the house's spelling, where it is one of the house's; else as typed.

    >>> unit_named("rad·s^-2"), unit_named("弧度/秒²"), unit_named("°"), unit_named("1/s^2"), unit_named("furlong")
    ('rad/s²', 'rad/s²', 'deg', 'rad/s²', 'furlong')
    """
    if not text:
        return ""
    name = plain(text[:40]).lower()
    for pattern, better in _SPELT_TESTED:
        name = pattern.sub(better, name)
    house = name.replace("^2", "²")
    return house if any(house in units for units in UNITS.values()) else text.strip()[:40]


PAPER: Mapping[str, float] = {"mm": 1.0, "cm": 10.0, "in": 25.4}
"""Units of lengths on paper in mm: such a length becomes a velocity or an acceleration by its scale."""
_DIMENSIONS: Mapping[Plane, Dimension] = {"position": "length", "velocity": "velocity", "acceleration": "acceleration"}
PLANES: Mapping[str, Plane] = {"m/s": "velocity", "m/s^2": "acceleration"}
"""The polygon in which a quantity of a unit is drawn."""
_NAMES: Mapping[str, Plane] = {
    "l": "position", "s": "position", "length": "position", "position": "position", "长度": "position",
    "v": "velocity", "velocity": "velocity", "速度": "velocity",
    "a": "acceleration", "acceleration": "acceleration", "加速度": "acceleration",
}  # fmt: skip
_KEY = re.compile(
    r"(?:scales?\.|(?:mu|[μµ]|k|scale)[ _]*)(?:of )?(l|s|v|a|length|position|velocity|acceleration)"
    r"|(?:(length|velocity|acceleration)[ _]*scale|(长度|速度|加速度)比例尺)"
)
_SMALLEST, _LARGEST = 1e-9, 1e9


def plane_named(text: str) -> Plane | None:
    """The plane whose scale a name is: `mu_v`, `μa`, `scales.velocity`, `velocity scale`, `速度比例尺`."""
    match = _KEY.fullmatch(re.sub(r"[{}\\$]", "", plain(text[:60])).strip().lower())
    return _NAMES[next(name for name in match.groups() if name)] if match is not None else None


def stated_by(mechanism: Mechanism) -> dict[Plane, float]:
    """The scales that the problem says to take."""
    return {plane: mechanism.scales[key] for plane, key in _DIMENSIONS.items() if key in mechanism.scales}


def scale(raw: object, plane: Plane) -> float:
    """SI units per mm on paper: `0.01`, `0.01 (m/s)/mm`, `1 mm = 0.01 m/s`, `100 mm : 1 m/s`. Raises NotAnAnswer,
    OutOfRange, OtherDimension with `NOWHERE`."""
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise NotAnAnswer(NOWHERE, str(raw)[:40])
    shown = str(raw)[:200] if isinstance(raw, str) or abs(raw) < 1e30 else "1e30"
    text, dimension = plain(shown), _DIMENSIONS[plane]
    # of a length on paper and what it stands for, in either order
    value, (one, sign, other) = None, text.partition("=") if "=" in text else text.partition(":")
    for paper, thing in ((one, other), (other, one)) if sign else ():
        with suppress(GraphkinError, ZeroDivisionError):
            value = _read(thing, dimension) / (_read(paper, "length") * 1000)
            break
    if value is None:
        number = written(re.sub(r"/\((s(?:\^2)?)\*mm\)", r"/\1/mm", text.replace(" ", "")), text)
        unit = re.sub(r"(?:/|\*? ?per|\*) ?mm(?:\^-1)?$", "", number.unit.replace("*mm^-1", "/mm")).strip("() ")
        value = _read(f"{number.number!r} {unit}", dimension) if unit else number.number
    if not _SMALLEST <= value <= _LARGEST:
        raise OutOfRange(NOWHERE, shown[:40])
    return value


def _read(text: str, dimension: Dimension) -> float:
    number = written(text.strip(), text)
    return read_quantity(f"{number.number!r} {unit_named(number.unit)}", dimension)
