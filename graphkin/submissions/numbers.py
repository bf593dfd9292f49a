"""Text, numbers, units and paper scales as students type them.

The units are the mechanism file's own. A bare number stands in the house's edge unit (mm, deg, rad/s, m/s ..). One
comma alone is a decimal comma; beside a point, the last of the two is the decimal sign.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Mapping
from contextlib import suppress
from functools import lru_cache

from graphkin.construction import SCALES, Plane
from graphkin.errors import NOWHERE, GraphkinError, NotAnAnswer, OutOfRange
from graphkin.files.values import UNITS, read_quantity
from graphkin.model.mechanism import Dimension, Mechanism

Number = tuple[float, str]  # with its unit as it is typed
LONGEST = 200  # no value is written with more letters

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
_FONTS = re.compile(r"\\(?:(?:math|text)(?:rm|bf|it)?|boldsymbol|mbox|unit|si|num|hat|vec)\s*\{([^{}]*)\}")
_COMMANDS = {
    "times": "*", "cdot": "*", "pm": "±", "approx": "=", "simeq": "=", "sim": "~", "angle": "∠", "degree": "°",
    "pi": "π", "theta": "θ", "varphi": "φ", "phi": "φ", "circlearrowleft": "↺", "circlearrowright": "↻",
    "leftarrow": "←", "rightarrow": "→", "uparrow": "↑", "downarrow": "↓", "searrow": "↘", "swarrow": "↙",
    "nearrow": "↗", "nwarrow": "↖", **dict.fromkeys(("left", "right", "rm", "mathrm", "text", "quad", "qquad"), " "),
}  # fmt: skip


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


def unlatexed(text: str) -> str:
    """Without the marks of LaTeX; a text that has none as it is."""
    if not any(mark in text for mark in "\\${"):
        return text
    text = re.sub(r"\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{", r"\1 {", text.replace("~", " "))
    text = re.sub(r"\^\s*\{?\s*\\circ\s*\}?", "°", text)
    text = _FONTS.sub(r" \1 ", _FONTS.sub(r" \1 ", text))
    text = re.sub(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", r"\1/\2", text)
    text = re.sub(r"\\[,;:! ()\[\]]", " ", text)
    text = re.sub(r"\\([A-Za-z]+)", lambda run: _COMMANDS.get(run[1], f" {run[1]}"), text)
    return re.sub(r"[${}]", "", text)


# --- numbers -----------------------------------------------------------------------------------

_NO_MORE = "(?![0-9]|[.,][0-9])"
_BODY = (
    rf"(?:[1-9][0-9]{{0,2}}(?P<of>[ ',.])[0-9]{{3}}(?:(?P=of)[0-9]{{3}})*(?!(?P=of))[.,](?:[0-9]{{1,2}}|[0-9]{{4,}})"
    rf"{_NO_MORE}|[1-9][0-9]{{0,2}}(?:(?P<by>[ '])[0-9]{{3}}(?:(?P=by)[0-9]{{3}})*|(?P<at>[.,])[0-9]{{3}}"
    rf"(?:(?P=at)[0-9]{{3}})+){_NO_MORE}"
    r"|[0-9]+(?:[.,][0-9]+|\.(?![0-9]))?|\.[0-9]+)"
)
_POWER = r"(?:e|[*x] ?10 ?(?:\^|\*\*) ?\(?|[*x] ?10(?=[+-]))(?P<power>[+-]?[0-9]+)\)?"
_FRACTION = r"(?:(?P<whole>[0-9]{1,9}) )?(?P<top>[0-9]{1,9}) ?/ ?(?P<bottom>[0-9]{1,9})" + _NO_MORE
_PI = r"(?P<times>[0-9]+(?:[.,][0-9]+)? ?\*? ?)?(?:π|pi(?![a-z]))(?: ?/ ?(?P<over>[0-9]{1,9})" + _NO_MORE + ")?"
NUMBER = rf"(?:{_FRACTION}|{_PI}|(?P<body>{_BODY})(?: ?{_POWER}{_NO_MORE})?)(?![0-9a-z]*[0-9])"
_LEADING = re.compile(rf"(?P<sign>-)?\+? *{NUMBER}")


def number_of(match: re.Match[str]) -> float:
    """The value of a NUMBER: `462/1000`, `1 1/2`, `2π/3`, `3,92*10^-1`, `1.234,5`; NaN of none."""
    if match["top"] is not None:
        top, bottom = int(match["top"]), int(match["bottom"])
        improper = match["whole"] is not None and top >= bottom
        return math.nan if not bottom or improper else int(match["whole"] or 0) + top / bottom
    body, power = match["body"], match["power"] or "0"
    if body is None:
        times = (match["times"] or "1").strip(" *").replace(",", ".")
        return float(times) * math.pi / (int(match["over"] or 1) or math.nan)
    groups = match["of"] or match["by"] or match["at"]
    body = body.replace(groups, "") if groups else body
    return float(f"{body.replace(',', '.').rstrip('.')}e{power}") if len(power) <= 5 else math.nan


def _leading(text: str, whole: str = "") -> Number:
    """The number that a plain text begins with, and the rest. Raises NotAnAnswer."""
    bare = text.rpartition("=")[2].strip().lower()
    if (match := _LEADING.match(bare)) is None or not math.isfinite(number := number_of(match)):
        raise NotAnAnswer(NOWHERE, (whole or text)[:LONGEST])
    return -number if match["sign"] else number, bare[match.end() :].strip(" ,;")


# --- units -------------------------------------------------------------------------------------

WHERE = " (?:the|an?|c?cw|clock|counter|anti|drawing|fig)"  # `in the ..`, not inches
ATOMS = {
    "rad": "rad(?:ian)?s?|弧度", "deg": "deg(?:ree)?s?|°|度", "mm": "mm|milli ?met(?:er|re)s?|毫米", "cm": "cm|厘米",
    "km": "km", "min": "min(?:ute)?s?|分钟?", "m": "m(?:et(?:er|re)s?)?|米", "in": rf"inch(?:es)?|in(?!{WHERE})",
    "ft": "ft|feet|foot", "rpm": "rpm", "rev": "rev(?:olution)?s?|转|圈", "s": "s(?:ec(?:ond)?s?)?|秒",
    "h": "h(?:ours?)?|小时",
}  # fmt: skip
"""Of what units are made: patterns by the house's spelling."""
_ATOM = re.compile("|".join(f"(?P<{name}>{words})" for name, words in ATOMS.items()) + "|per|每")
_FORMS = [(re.compile(pattern), better) for pattern, better in (
    (r"[*.]?s\^?-1", "/s"), (r"/s/s|/s\*s|/ss|/s\^?2|[*.]?s\^?-2", "/s²"), ("^1?/s", "rad/s"),
    ("^r(?:ev)?/min", "r/min"), ("^r/s", "rev/s"),
)]  # fmt: skip
_HOUSE = {unit for units in UNITS.values() for unit in units}


@lru_cache(maxsize=1000)
def unit_named(text: str) -> str:
    """A unit in the house's spelling, where it is one of the house's; else as typed.

    >>> unit_named("rad·s^-2"), unit_named("弧度/秒²"), unit_named("°"), unit_named("1/s^2"), unit_named("furlong")
    ('rad/s²', 'rad/s²', 'deg', 'rad/s²', 'furlong')
    """
    name = re.sub(r"(?<=[a-z]) (?=s\^?\(?-)", "*", plain(unlatexed(text[:40])).lower()).replace("**", "^")
    name = re.sub(r"squared|的?平方$", "^2", re.sub(r"每(?:二次方|平方)秒", "/s^2", re.sub(r"[\s()\[\]]", "", name)))
    name = _ATOM.sub(lambda atom: atom.lastgroup or "/", name)
    for pattern, better in _FORMS:
        name = pattern.sub(better, name)
    return name if name in _HOUSE else text.strip()[:40]


def is_unit(text: str) -> bool:
    """True of a unit of the house's, however it is spelled."""
    return unit_named(text) in _HOUSE


def in_si(number: float, unit: str, dimension: Dimension) -> float:
    """Raises OtherDimension, UnknownUnit, OutOfRange with `NOWHERE`."""
    return read_quantity(f"{number!r} {unit_named(unit)}" if unit else number, dimension)


# --- scales of paper ---------------------------------------------------------------------------

PAPER: Mapping[str, float] = {"mm": 1.0, "cm": 10.0, "in": 25.4}
"""Units of lengths on paper in mm: such a length becomes a velocity or an acceleration by its scale."""
PLANES: Mapping[str, Plane] = {"m/s": "velocity", "m/s^2": "acceleration"}
"""The polygon in which a quantity of a unit is drawn."""
_NAMES: Mapping[str, Plane] = {
    **dict.fromkeys("lsp长", "position"), **dict.fromkeys("v速", "velocity"), **dict.fromkeys("a加", "acceleration"),
}  # fmt: skip
_KEY = re.compile(
    r"(?:scales?\.|(?:mu|[μµ]|k|scale)[ _]*)(?:of )?(l|s|v|a|length|position|velocity|acceleration)"
    r"|(?:(length|velocity|acceleration)[ _]*scale|(长度|速度|加速度)比例尺)"
)
_SMALLEST, _LARGEST = 1e-9, 1e9


def plane_named(text: str) -> Plane | None:
    """The plane whose scale a name is: `mu_v`, `μa`, `scales.velocity`, `velocity scale`, `速度比例尺`."""
    match = _KEY.fullmatch(re.sub(r"[{}\\$]", "", plain(text[:60])).strip().lower())
    return _NAMES[next(name for name in match.groups() if name)[0]] if match is not None else None


def stated_by(mechanism: Mechanism) -> dict[Plane, float]:
    """The scales that the problem says to take."""
    return {plane: mechanism.scales[key] for plane, key in SCALES.items() if key in mechanism.scales}


def scale(raw: object, plane: Plane) -> float:
    """SI units per mm on paper: `0.01`, `0.01 (m/s)/mm`, `1 mm = 0.01 m/s`, `100 mm : 1 m/s`. Raises NotAnAnswer,
    OutOfRange, OtherDimension with `NOWHERE`."""
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise NotAnAnswer(NOWHERE, str(raw)[:40])
    shown = str(raw)[:200] if isinstance(raw, str) or abs(raw) < 1e30 else "1e30"
    text, dimension = plain(shown).replace("~", "="), SCALES[plane]
    # of a length on paper and what it stands for, in either order
    value, (one, sign, other) = None, text.partition("=") if "=" in text else text.partition(":")
    for paper, thing in ((one, other), (other, one)) if sign else ():
        with suppress(GraphkinError, ZeroDivisionError):
            value = _quantity(thing, dimension) / (_quantity(paper, "length") * 1000)
            break
    if value is None:
        number, unit = _leading(re.sub(r"/\((s(?:\^2)?)\*mm\)", r"/\1/mm", text.replace(" ", "")), text)
        unit = re.sub(r"(?:/|\*?per|\*)mm(?:\^-1)?$", "", unit).strip("() ")
        value = in_si(number, unit, dimension) if unit else number
    if not _SMALLEST <= value <= _LARGEST:
        raise OutOfRange(NOWHERE, shown[:40])
    return value


def _quantity(text: str, dimension: Dimension) -> float:
    number, unit = _leading(text)
    return read_quantity(f"{number!r} {unit_named(unit)}", dimension)
