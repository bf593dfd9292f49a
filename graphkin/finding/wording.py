"""What was found, for people: lines for the terminal, captions for the sheet."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.finding.answers import Found, Interval, Phase, Position, SlowPoint, Speeds
from graphkin.finding.conditions import Comparison, Scaling, Slowest
from graphkin.mechanism import Driver
from graphkin.quantities import EDGE, IN_GRAVITY, driven
from graphkin.reports import number

__all__ = ["NOTES", "caption", "lines", "quantity"]

Both = dict[Lang, str]

_COLON: Both = {"en": ": ", "zh": "："}

WORDS: dict[str, Both] = {
    "looked": {"en": "looked from {driver} = {low} to {high}", "zh": "查找范围：{driver} = {low} 至 {high}"},
    "turn": {"en": ", a full turn", "zh": "，即整周"},
    "stopped": {"en": ", as far as it gets ({ends})", "zh": "，即可到达的范围（{ends}）"},
    "low end": {"en": "dead point at {value}", "zh": "{value} 处为死点"},
    "none": {"en": "not met in this range", "zh": "在此范围内不成立"},
    "not passed": {"en": "not passed in this range", "zh": "在此范围内没有超过"},
    "nearest": {"en": "it comes nearest at {at}: {values}", "zh": "最接近处 {at}：{values}"},
    "everywhere": {"en": "met at every position", "zh": "在所有位置都成立"},
    "nothing": {"en": "zero throughout", "zh": "始终为零"},
    "level": {"en": "the same at every position: {values}", "zh": "在所有位置都相同：{values}"},
    "zero": {"en": "", "zh": ""},
    "here": {"en": "", "zh": ""},
    "touch": {"en": "touched, not passed", "zh": "仅相切，不越过"},
    "max": {"en": "greatest", "zh": "最大"},
    "min": {"en": "least", "zh": "最小"},
    "largest": {"en": "largest size, against the guide's direction", "zh": "最大绝对值，方向与导路正向相反"},
    "end": {"en": "at the end of the range", "zh": "在范围端点"},
    "stop": {"en": "tends to this at the dead point", "zh": "趋近死点时的极限"},
    "pole": {"en": "grows without limit there", "zh": "在该处无限增大"},
    "swing": {"en": "difference of greatest and least: {value}", "zh": "最大与最小之差：{value}"},
    "stroke": {"en": "stroke: {value}", "zh": "行程：{value}"},
    "advance": {"en": "advance ({way})", "zh": "工作行程（{way}）"},
    "retreat": {"en": "return ({way})", "zh": "回程（{way}）"},
    "up": {"en": "growing", "zh": "增大"},
    "down": {"en": "falling", "zh": "减小"},
    "phase": {"en": "{name}: {driver} turns {angle}", "zh": "{name}：{driver} 转过 {angle}"},
    "time": {"en": ", {time} s, mean speed {mean}", "zh": "，用时 {time} s，平均速度 {mean}"},
    "ratio": {"en": "time ratio K = {value}", "zh": "行程速比系数 K = {value}"},
    "interval": {"en": "from {begin} to {end}", "zh": "{begin} 至 {end}"},
    "peak": {"en": "{what} {values} at {at}", "zh": "{what} {values}，位于 {at}"},
    "slow": {
        "en": "{at}: slowest point of line {line}: {along} from {first} {side}, speed {speed}",
        "zh": "{at}：直线 {line} 上速度最小的点：距 {first} 为 {along}（{side}），速度 {speed}",
    },
    "beyond": {"en": "towards {second}, beyond it", "zh": "沿 {second} 方向，在 {second} 之外"},
    "between": {"en": "towards {second}, between the two", "zh": "在 {first} 与 {second} 之间"},
    "behind": {"en": "away from {second}", "zh": "在 {second} 的反方向"},
    "alike": {
        "en": "{at}: link translates: all points of line {line} have the speed {speed}",
        "zh": "{at}：构件作平动，直线 {line} 上各点速度均为 {speed}",
    },
    "speeds": {"en": "{at}: {quantity} = {value} wants {rates}", "zh": "{at}：要使 {quantity} = {value}，须 {rates}"},
    "factor": {
        "en": " ({factor} times the file's, where {quantity} is {now})",
        "zh": "（为文件所给的 {factor} 倍，其时 {quantity} 为 {now}）",
    },
    "together": {"en": "all drivers' speeds are changed in proportion", "zh": "各原动件的速度按同一比例改变"},
    "square": {
        "en": "the drivers' accelerations are changed by the square of the factor: {accelerations}",
        "zh": "各原动件的加速度按倍数的平方改变：{accelerations}",
    },
}  # fmt: skip

NOTES: dict[str, Both] = {
    "no turn": {
        "en": "no time ratio: the driver does not go through a full turn here",
        "zh": "无行程速比系数：原动件在此范围内不作整周转动",
    },
    "several strokes": {
        "en": "no time ratio: the output reaches its ends more than once a turn",
        "zh": "无行程速比系数：输出件每转中多次到达极限位置",
    },
    "goes round": {
        "en": "no stroke: the link turns all the way round",
        "zh": "无摆程：该构件作整周转动",
    },
}


def _say(key: str, lang: Lang, **data: object) -> str:
    return WORDS[key][lang].format(**data)


# --- values -----------------------------------------------------------------------------------


def quantity(value: float, unit: str, *, gravity: bool = False) -> str:
    """`26.38 deg`, `188.8 mm`, `0.4 m/s`; accelerations in g, too, where `gravity`."""
    if math.isinf(value):
        return "∞" if value > 0 else "-∞"
    shown = EDGE[unit]
    text = f"{number(value * shown.factor)} {shown.name}".rstrip()
    return f"{text} ({number(value * IN_GRAVITY.factor)} {IN_GRAVITY.name})" if gravity and unit == "m/s^2" else text


def _driven(driver: Driver, value: float) -> str:
    return quantity(value, driven(driver.kind == "slide"))


def _rate(driver: Driver, value: float) -> str:
    return quantity(value, "m/s" if driver.kind == "slide" else "rad/s")


def _at(found: Found, position: Position) -> str:
    """`AB = 26.38 deg, ram = 90 mm`: the driver by which positions are named first."""
    order = sorted(range(len(found.drivers)), key=lambda k: k != found.swept)
    return ", ".join(f"{found.drivers[k].name} = {_driven(found.drivers[k], position.drivers[k])}" for k in order)


def _gravity(found: Found) -> bool:
    """Whether the condition itself speaks of g."""
    wanted = found.condition
    return isinstance(wanted, Comparison) and (wanted.size or wanted.other.rstrip().endswith("g"))


def _values(found: Found, position: Position) -> str:
    size = isinstance(found.condition, Comparison) and found.condition.size
    values = map(abs, position.values) if size else position.values
    entries = zip(found.quantities, found.units, values)
    return ", ".join(f"{name} = {quantity(value, unit, gravity=_gravity(found))}" for name, unit, value in entries)


# --- lines ------------------------------------------------------------------------------------


def lines(found: Found, lang: Lang = "en") -> Iterator[str]:
    """Everything found, for the terminal; nothing twice."""
    for line in dict.fromkeys(_lines(found, lang)):
        yield line.replace(" deg", "°") if lang == "zh" else line


def _lines(found: Found, lang: Lang) -> Iterator[str]:
    wanted = found.condition
    yield f"{wanted.text}" + (f"  ({_looked(found, lang)})" if found.looked else "")
    if isinstance(wanted, Slowest):
        yield from (f"  {_slow(found, entry, lang)}" for entry in found.slow)
    elif isinstance(wanted, Scaling):
        yield from (f"  {line}" for line in _scaling(found, wanted, lang))
    else:
        yield from (f"  {line}" for line in _results(found, lang))


def _looked(found: Found, lang: Lang) -> str:
    assert found.looked is not None
    driver = found.drivers[found.swept]
    low, high = (_driven(driver, end) for end in found.looked)
    text = _say("looked", lang, driver=driver.name, low=low, high=high)
    ends = [_say("low end", lang, value=end) for end, stop in zip((low, high), found.stopped) if stop]
    if ends:
        return text + _say("stopped", lang, ends=("、" if lang == "zh" else ", ").join(ends))
    return text + (_say("turn", lang) if found.turn else "")


def _results(found: Found, lang: Lang) -> Iterator[str]:
    if found.everywhere:
        yield _level(found, lang)
        return
    for position in found.positions:
        yield _line(found, position, lang)
    for interval in found.intervals:
        yield _interval(found, interval, lang)
    if found.nearest is not None:
        at, values = _at(found, found.nearest), _values(found, found.nearest)
        limit = isinstance(found.condition, Comparison) and found.condition.size
        missed = _say("not passed" if limit else "none", lang) + ("；" if lang == "zh" else "; ")
        yield missed + _say("nearest", lang, at=at, values=values)
    elif not found.positions and not found.intervals:
        yield _say("none", lang)
    yield from _swing(found, lang)
    yield from (NOTES[note][lang] for note in found.notes)


def _level(found: Found, lang: Lang) -> str:
    """A condition met everywhere, or a quantity that never changes."""
    if found.zero:
        return _say("nothing", lang)
    if isinstance(found.condition, Comparison):
        return _say("everywhere", lang)
    return _say("level", lang, values=_values(found, found.positions[0]))


def _line(found: Found, position: Position, lang: Lang) -> str:
    said = _say(position.kind, lang)
    line = f"{_at(found, position)}{_COLON[lang]}{_values(found, position)}"
    return line + (f"  ({said})" if said else "")


def _interval(found: Found, part: Interval, lang: Lang) -> str:
    driver = found.drivers[found.swept]
    ends = []
    for position in (part.begin, part.end):
        said = _say(position.kind, lang) if position.kind == "end" else ""
        ends.append(_driven(driver, position.drivers[found.swept]) + (f" ({said})" if said else ""))
    span = f"{driver.name} " + _say("interval", lang, begin=ends[0], end=ends[1])
    at = f"{driver.name} = {_driven(driver, part.peak.drivers[found.swept])}"
    peak = {"what": _say(part.peak.kind, lang), "values": _values(found, part.peak), "at": at}
    return f"{span}{_COLON[lang]}" + _say("peak", lang, **peak)


def _swing(found: Found, lang: Lang) -> Iterator[str]:
    if found.swing is None or "goes round" in found.notes:
        return
    key = "stroke" if found.condition.text.startswith("stroke") else "swing"
    yield _say(key, lang, value=quantity(found.swing, found.units[0]))
    if found.stroke is not None:
        yield _phase(found, "advance", found.stroke.advance, lang)
        yield _phase(found, "retreat", found.stroke.retreat, lang)
        yield _say("ratio", lang, value=number(found.stroke.ratio))


def _phase(found: Found, name: str, phase: Phase, lang: Lang) -> str:
    way = _say("up" if phase.up else "down", lang)
    driver = found.drivers[found.swept].name
    text = _say("phase", lang, name=_say(name, lang, way=way), driver=driver, angle=quantity(phase.angle, "rad"))
    if phase.time is None or phase.mean is None:
        return text
    return text + _say("time", lang, time=number(phase.time), mean=quantity(phase.mean, f"{found.units[0]}/s"))


def _slow(found: Found, entry: SlowPoint, lang: Lang) -> str:
    first, second = entry.points
    data = {"at": _at(found, entry.position), "line": first + second, "speed": quantity(entry.speed, "m/s")}
    if entry.along is None:
        return _say("alike", lang, **data)
    key = "behind" if entry.along < 0 else "beyond" if entry.along > entry.length else "between"
    side = _say(key, lang, first=first, second=second)
    return _say("slow", lang, first=first, along=quantity(abs(entry.along), "m"), side=side, **data)


def _scaling(found: Found, wanted: Scaling, lang: Lang) -> Iterator[str]:
    order = sorted(range(len(found.drivers)), key=lambda k: k != wanted.driver)
    for entry in found.speeds:
        yield _speeds(found, entry, order, lang)
    if sum(bool(driver.rate) for driver in found.drivers) > 1:
        yield _say("together", lang)
    if any(driver.acceleration for driver in found.drivers):
        for entry in found.speeds:
            yield _say("square", lang, accelerations=_accelerations(found, entry))


def _speeds(found: Found, entry: Speeds, order: list[int], lang: Lang) -> str:
    names = [f"{_letter(found.drivers[k])} = {_rate(found.drivers[k], entry.rates[k])}" for k in order]
    name, unit = found.quantities[0], found.units[0]
    value = quantity(entry.position.values[0], unit)
    text = _say("speeds", lang, at=_at(found, entry.position), quantity=name, value=value, rates=", ".join(names))
    return text + _say("factor", lang, factor=number(entry.factor), quantity=name, now=quantity(entry.value, unit))


def _letter(driver: Driver) -> str:
    """What a driver's speed is called: `omega AB`, `v ram`."""
    return f"{'v' if driver.kind == 'slide' else 'omega'} {driver.name}"


def _accelerations(found: Found, entry: Speeds) -> str:
    pairs = [(driver, driver.acceleration * entry.factor**2) for driver in found.drivers if driver.acceleration]
    units = {"slide": "m/s^2"}
    return ", ".join(f"{driver.name}: {quantity(a, units.get(driver.kind, 'rad/s^2'))}" for driver, a in pairs)


def caption(found: Found, position: Position) -> str:
    """What stands under a position on the sheet: `AB = 26.38 deg: v C = 0 m/s`."""
    at = f"{found.drivers[found.swept].name} = {_driven(found.drivers[found.swept], position.drivers[found.swept])}"
    values = _values(found, position)
    return (f"{at}: {values}" if values else at).replace(" deg", "°").replace("^2", "²")
