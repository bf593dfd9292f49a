"""Text, values and paper scales as students type them: number, unit, sense, sometimes its direction.

The units are the mechanism file's own. A bare number stands in the house's edge unit (mm, deg, rad/s, m/s ..). One
comma alone is a decimal comma; beside a point, the last of the two is the decimal sign.
"""

from __future__ import annotations

import cmath
import math
import re
import unicodedata
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache

from graphkin.construction import Plane
from graphkin.errors import NOWHERE, GraphkinError, NotAnAnswer, OtherDimension, OutOfRange, SenseDisputed
from graphkin.files.values import UNITS, read_quantity
from graphkin.model.mechanism import Dimension, Mechanism
from graphkin.submissions.grammar import LONGEST, Number, WrittenAnswer, leading_number, taken_apart, unlatexed
from graphkin.submissions.submission import HandedValue, Sense

_RAISED = re.compile("[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_ALIKE = str.maketrans({
    **dict.fromkeys("−–—‐‑‒―﹣－➖", "-"), "º": "°", "˚": "°", "∘": "°", "∕": "/", "⁄": "/", "÷": "/", "·": "*",
    "⋅": "*", "∙": "*", "•": "*", "×": "*", "✕": "*", "﹢": "+", "，": ",", "；": ";", "：": ":", "。": ".", "（": "(",
    "）": ")", "【": "[", "】": "]", "\u2019": "'", "\u2032": "'", "\u02b9": "'", "\u2033": "''", "\u2034": "'''",
    "\u02bc": "'", "´": "'", "`": "'", "＝": "=", "≈": "=", "≅": "=", "≃": "=", "≒": "=", "≐": "=", "∼": "~",
    **dict.fromkeys("\u200b\ufeff\ufe0f", ""), **dict(zip("⬅⬆➡⬇⬈⬉⬊⬋", "←↑→↓↗↖↘↙")),
    **{fraction: f" {unicodedata.normalize('NFKC', fraction)}" for fraction in "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"},
    **{chr(0x2460 + k): f" ({k + 1}) " for k in range(20)},
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
_SIMPLE = re.compile(
    r"([+-]?(?:[0-9]{1,20}(?:\.[0-9]{0,20})?|\.[0-9]{1,20})(?:[eE][+-]?[0-9]{1,3})?) ?([A-Za-z°][A-Za-z/^²]{0,9}2?)?"
)
_NO_SENSE, _DASHES = re.compile(r"\s+[—–―]+\s*$"), re.compile(r"(?<=\S) +-+$")
"""In the last column of an answer table: of what turns a minus may be a sign."""
_ASIDE = re.compile(r" \| |(?<=[^\s(:=,;]) - (?=[^0-9]*$)")
_IN_PI = re.compile("(π(?: ?/ ?[0-9]+)?)(?![ 0-9/]*[a-z°度弧*])")
_DRESS = re.compile("[\"\u201c\u201d\u300c\u300d]|^[*_=' ]+|[*_ ]+$")
_LAST_DIGITS = re.compile(r"([0-9][.,][0-9]+)\([0-9]{1,2}\)")
_MINUTES = re.compile(r"([0-9]+)° ?([0-9]+(?:\.[0-9]+)?)'(?: ?([0-9]+(?:\.[0-9]+)?)'')?")
WORDS = math.radians(60)
"""A direction in words holds within this angle on either side."""


def simple(text: str) -> Number | None:
    """A number alone or with a unit of the house's, as tables have it."""
    match = _SIMPLE.fullmatch(text)
    return None if match is None or (match[2] and not is_unit(match[2])) else (float(match[1]), match[2] or "")


def parsed_value(text: str, si: str, unit: str = "", vector: bool = True, axis: str = "") -> HandedValue:
    """The value that a text gives for a quantity of this SI unit; faults come with `NOWHERE`.

    unit   of its column; vector: whether such a quantity has a direction; axis: of one component alone
    """
    dimension = DIMENSIONS[si]
    try:
        if (number := simple(text)) is not None:
            return _in_si(text, number, dimension, unit)
        if len(text) > LONGEST:
            raise NotAnAnswer(NOWHERE, text[:40] + "..")
        bare = unaccented(plain(unlatexed(_NO_SENSE.sub("", text)))).lower()
        bare = _ASIDE.sub(", ", re.sub("<([^<>]*)>", r"(\1)", bare))
        bare = _IN_PI.sub(r"\1 rad", bare) if dimension == "angle" else bare
        bare = bare if dimension in _TURNING else _DASHES.sub("", bare)
        bare = re.sub("(?<=[0-9]) ?: ?(?=[0-9])", "/", bare) if dimension is None else bare
        bare = _LAST_DIGITS.sub(r"\1", bare)
        bare = _MINUTES.sub(lambda at: f"{int(at[1]) + float(at[2]) / 60 + float(at[3] or 0) / 3600!r}°", bare)
        answer = taken_apart(_DRESS.sub("", bare), text, vector and si in PLANES, dimension in _TURNING, axis)
        return _of_answer(text, answer, dimension, unit)
    except GraphkinError as fault:
        return HandedValue(text, None, fault=fault)


def _of_answer(text: str, answer: WrittenAnswer, dimension: Dimension | None, unit: str) -> HandedValue:
    """Two numbers must agree within 2 %, or the unit of one alone is right; components give the size, or the direction
    of one."""
    halves = [_in_si(text, half, dimension, unit) for half in answer.parts]
    pair = complex(*(half.value or 0.0 for half in halves)) if halves else 0j
    value = replace(halves[0], value=abs(pair)) if halves else None
    numbers = [_in_si(text, one, dimension, unit) for one in (answer.number, *answer.also) if one is not None]
    of_unit = [one for one in numbers if one.fault is None] or numbers
    if len(of_unit) < len(numbers) and not all(one.unit for one in of_unit):
        raise NotAnAnswer(NOWHERE, text)
    if value is None or numbers:
        value = replace(of_unit[0], sense=_SENSES[answer.sense])
    size = value.value or 0.0
    if not all(math.isclose(abs(size), abs(other.value or 0.0), rel_tol=0.02) for other in of_unit):
        raise NotAnAnswer(NOWHERE, text)
    vector, within = (abs(size) * answer.toward, WORDS) if answer.toward else (None, 0.0)
    if pair:
        if not any(math.isclose(abs(pair), length, rel_tol=0.05) for length in (abs(size), 1.0)):
            raise NotAnAnswer(NOWHERE, text)
        vector, within = size * pair / abs(pair), 0.0
    if answer.angle is not None:
        at, of = answer.angle
        in_words, vector = vector, cmath.rect(size, read_quantity(f"{at!r} {unit_named(of)}" if of else at, "angle"))
        if in_words and vector and abs(cmath.phase(vector / in_words)) > WORDS:
            raise SenseDisputed(NOWHERE, text)
        within = 0.0
    return replace(value, vector=vector or None, within=within)


def _in_si(text: str, one: Number, dimension: Dimension | None, unit: str) -> HandedValue:
    number, own = one
    name = unit_named(own or unit)
    if dimension is None:
        if name not in ("", "%"):
            raise NotAnAnswer(NOWHERE, text)
        return HandedValue(text, read_quantity(number / 100 if name else number, "velocity"))
    shown = name.replace("²", "^2")
    try:
        return HandedValue(text, read_quantity(f"{number!r} {name}" if name else number, dimension), None, shown)
    except OtherDimension as fault:
        return HandedValue(text, read_quantity(number, dimension), None, shown, fault)


_SENSES: Mapping[int, Sense | None] = {1: "ccw", 0: None, -1: "cw"}


_SPELT = (
    (r" ?squared|的?平方(?=$)", "^2"), (r"每(?:二次方|平方)秒", "/s^2"), (r"(?<=[a-z]) (?=s\^?\(?-)", "*"),
    (r"\s+|\\|\$|\{|\}|\bmathrm\b", ""), (r"\*\*", "^"), (r"毫米", "mm"), (r"厘米", "cm"),
    (r"米", "m"), (r"弧度", "rad"),
    (r"度|°|degrees?|degs?\b", "deg"), (r"radians?|rads\b", "rad"), (r"分钟?|minutes?|\bmins\b", "min"),
    (r"秒|seconds?|secs?", "s"), (r"revolutions?|revs\b|转|圈", "rev"), (r"millimet(?:re|er)s?", "mm"),
    (r"met(?:re|er)s?", "m"), (r"inch(?:es)?", "in"), (r"feet|foot", "ft"), (r"每", "/"), (r"per", "/"),
    (r"[()\[\]]", ""), (r"²", "^2"), (r"[*.]?s\^?-1", "/s"), (r"[*.]?s\^?-2", "/s^2"), (r"/s/s|/s\*s|/ss", "/s^2"),
    (r"/s2$", "/s^2"), (r"^1/s", "rad/s"), (r"^/s", "rad/s"), (r"^r(?:ev)?/min", "r/min"), (r"^r/s", "rev/s"),
)  # fmt: skip
_SPELT_TESTED = tuple((re.compile(pattern), better) for pattern, better in _SPELT)


@lru_cache(maxsize=1000)
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
    return house if house in _HOUSE else text.strip()[:40]


_HOUSE = {unit for units in UNITS.values() for unit in units}


def is_unit(text: str) -> bool:
    """True of a unit of the house's, however it is spelled."""
    return unit_named(text) in _HOUSE


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
    text, dimension = plain(shown).replace("~", "="), _DIMENSIONS[plane]
    # of a length on paper and what it stands for, in either order
    value, (one, sign, other) = None, text.partition("=") if "=" in text else text.partition(":")
    for paper, thing in ((one, other), (other, one)) if sign else ():
        with suppress(GraphkinError, ZeroDivisionError):
            value = _read(thing, dimension) / (_read(paper, "length") * 1000)
            break
    if value is None:
        number, unit = leading_number(re.sub(r"/\((s(?:\^2)?)\*mm\)", r"/\1/mm", text.replace(" ", "")), text)
        unit = re.sub(r"(?:/|\*? ?per|\*) ?mm(?:\^-1)?$", "", unit.replace("*mm^-1", "/mm")).strip("() ")
        value = read_quantity(f"{number!r} {unit_named(unit)}", dimension) if unit else number
    if not _SMALLEST <= value <= _LARGEST:
        raise OutOfRange(NOWHERE, shown[:40])
    return value


def _read(text: str, dimension: Dimension) -> float:
    number, unit = leading_number(text.strip(), text)
    return read_quantity(f"{number!r} {unit_named(unit)}", dimension)
