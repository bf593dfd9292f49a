"""What a mechanism is made of, in words: links, pairs, degrees of freedom, groups, and the methods it needs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from graphkin.assur import Structure, structure
from graphkin.errors import Lang
from graphkin.mechanism import Mechanism
from graphkin.pairs import Cam, CircularSlot, Gear, Pair, Revolute, Roll, Slide
from graphkin.planning import Method
from graphkin.words.redundancy import redundant_constraints

WORDS: dict[str, dict[Lang, str]] = {
    "links": {"en": "Links", "zh": "构件"},
    "frame": {"en": "{name} (frame)", "zh": "{name}（机架）"},
    "pairs": {"en": "Pairs", "zh": "运动副"},
    "hinge": {"en": "hinge {point}: links {links}", "zh": "转动副 {point}：构件 {links}"},
    "multiple": {"en": "multiple hinge {point}: links {links}", "zh": "复合铰链 {point}：构件 {links}"},
    "slide": {"en": "sliding pair: {block} on {guide}", "zh": "移动副：构件 {block} 与 {guide}"},
    "pin": {"en": "pin {point} in a slot of {guide}", "zh": "销 {point} 在构件 {guide} 的滑槽中（高副）"},
    "circular slot": {
        "en": "pin {point} in a circular slot of {guide}", "zh": "销 {point} 在构件 {guide} 的圆弧槽中（高副）",
    },
    "gear": {"en": "gear pair: {links}", "zh": "齿轮副：{links}"},
    "roll": {"en": "rolling without slip: {links}", "zh": "纯滚动副：{links}"},
    "cam": {"en": "cam pair: {links}", "zh": "凸轮副：{links}"},
    "formula": {
        "en": "Degrees of freedom by the formula: F = 3 × {n} − 2 × {low} − {high} = {f}",
        "zh": "自由度公式：F = 3n − 2p_l − p_h = 3 × {n} − 2 × {low} − {high} = {f}",
    },
    "rank": {"en": "Degrees of freedom by rank: {f}", "zh": "由方程的秩得自由度：{f}"},
    "idle": {"en": "idle freedom (turning of): {links}", "zh": "局部自由度：构件 {links} 的转动"},
    "redundant": {"en": "redundant constraints: {count}", "zh": "虚约束：{count} 个"},
    "repeats": {"en": "repeats a constraint: {what}", "zh": "虚约束：{what}"},
    "drivers": {"en": "Drivers", "zh": "原动件"},
    "groups": {"en": "Groups, in the order they are solved", "zh": "杆组（按求解顺序）"},
    "dyad": {"en": "Class II, {kind}: links {links}", "zh": "Ⅱ级组 {kind}：构件 {links}"},
    "triad": {
        "en": "Class III: links {links}; special point {point} on link {link}",
        "zh": "Ⅲ级组：构件 {links}；特殊点 {point} 取在构件 {link} 上",
    },
    "higher": {
        "en": "Class {cls}: links {links}; solved simultaneously",
        "zh": "{cls}级组：构件 {links}；联立求解",
    },
    "train": {"en": "gear train: {links}", "zh": "轮系：构件 {links}"},
    "wheel": {"en": "rolling contact: {links}", "zh": "纯滚动：构件 {links}"},
    "none": {"en": "none", "zh": "无"},
    "class": {"en": "Mechanism of Class {cls}", "zh": "机构级别：{cls}级机构"},
    "methods": {"en": "Methods it needs", "zh": "所需方法"},
    "two points": {"en": "two points of one link", "zh": "同一构件两点法"},
    "coincident": {"en": "coincident points, with Coriolis", "zh": "重合点法（含科氏加速度）"},
    "special": {"en": "special point of the ternary link", "zh": "特殊点法"},
    "together": {"en": "simultaneous solution", "zh": "联立求解"},
    "rolling": {"en": "rolling contact", "zh": "纯滚动接触点法"},
    "lower": {"en": "lower-pair equivalent", "zh": "高副低代"},
}
ROMAN: dict[Lang, tuple[str, ...]] = {
    "en": ("", "I", "II", "III", "IV", "V"),
    "zh": ("", "Ⅰ", "Ⅱ", "Ⅲ", "Ⅳ", "Ⅴ"),
}


def structure_lines(method: Method, lang: Lang) -> Iterator[str]:
    """Text for a terminal."""
    mechanism, found = method.mechanism, structure(method)
    say = _Speaker(lang)
    yield mechanism.headline(lang)
    frame = say("frame", name=mechanism.frame)
    yield f"{say('links')}: {', '.join([frame, *mechanism.moving])}"
    yield f"{say('pairs')}:"
    yield from (f"  {line}" for line in _pairs(mechanism, say))
    yield from _freedoms(method, found, say)
    yield f"{say('drivers')}: {', '.join(driver.name for driver in mechanism.drivers)}"
    yield f"{say('groups')}:"
    yield from (f"  {k}. {text}" for k, text in enumerate(_groups(found, say), 1))
    if not found.groups:
        yield f"  {say('none')}"
    yield say("class", cls=ROMAN[lang][found.cls])
    yield f"{say('methods')}: {', '.join(say(key) for key in found.methods) or say('none')}"


KINDS: Mapping[type[Pair], Callable[[Any], tuple[str, str]]] = {
    Revolute: lambda hinge: ("multiple" if len(hinge.links) > 2 else "hinge", hinge.point),
    Slide: lambda slide: ("pin" if slide.block is None else "slide", slide.point),
    CircularSlot: lambda slot: ("circular slot", slot.point),
    Gear: lambda gear: ("gear", ""),
    Roll: lambda roll: ("roll", ""),
    Cam: lambda cam: ("cam", ""),
}
"""The line of each kind, and the point it is about."""


class _Speaker:
    def __init__(self, lang: Lang) -> None:
        self.lang = lang

    def __call__(self, key: str, **values: object) -> str:
        return WORDS[key][self.lang].format(**values)


def _pairs(mechanism: Mechanism, say: _Speaker) -> Iterator[str]:
    def called(links: tuple[str, ...]) -> str:
        return ", ".join(mechanism.called(link) for link in links)

    for pair in (*mechanism.hinges, *mechanism.pairs):
        key, point = KINDS[type(pair)](pair)
        guide, *block = pair.joins
        yield say(key, point=point, links=called(pair.joins), guide=called((guide,)), block=called(tuple(block)))


def _freedoms(method: Method, found: Structure, say: _Speaker) -> Iterator[str]:
    yield say("formula", n=found.moving, low=found.low, high=found.high, f=found.formula)
    yield say("rank", f=found.mobility.freedoms)
    if found.mobility.idle:
        yield "  " + say("idle", links=", ".join(found.mobility.idle))
    if found.mobility.repeated:
        yield "  " + say("redundant", count=found.mobility.repeated)
        yield from ("  " + say("repeats", what=what) for what in redundant_constraints(method, say.lang))


def _groups(found: Structure, say: _Speaker) -> Iterator[str]:
    for group in found.groups:
        cls, links = ROMAN[say.lang][group.cls], ", ".join(group.links)
        yield say(group.kind, cls=cls, links=links, kind=group.letters, point=group.point, link=group.ternary)
