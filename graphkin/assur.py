"""What a mechanism is made of: links, pairs, freedoms, and its Assur groups in the order they are solved.

The class of a group is that of its most complex part: II for a dyad, III for a ternary link on three legs, IV for
two links more that close a four-sided figure. The class of the mechanism is the highest of its groups'.
"""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.analytic import Mobility, mobility
from graphkin.errors import Lang
from graphkin.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh
from graphkin.planning.structure import Hinge, Joint
from graphkin.redundancy import redundant_constraints

__all__ = ["structure_lines"]

WORDS: dict[str, dict[Lang, str]] = {
    "links": {"en": "Links", "zh": "构件"},
    "frame": {"en": "{name} (frame)", "zh": "{name}（机架）"},
    "pairs": {"en": "Pairs", "zh": "运动副"},
    "hinge": {"en": "hinge {point}: links {links}", "zh": "转动副 {point}：构件 {links}"},
    "multiple": {"en": "multiple hinge {point}: links {links}", "zh": "复合铰链 {point}：构件 {links}"},
    "slide": {"en": "sliding pair: {block} on {guide}", "zh": "移动副：构件 {block} 与 {guide}"},
    "pin": {"en": "pin {point} in a slot of {guide}", "zh": "销 {point} 在构件 {guide} 的滑槽中（高副）"},
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
    mechanism, found = method.mechanism, mobility(method.mechanism)
    say = _Speaker(lang)
    yield mechanism.headline(lang)
    frame = say("frame", name=mechanism.frame)
    yield f"{say('links')}: {', '.join([frame, *mechanism.moving])}"
    yield f"{say('pairs')}:"
    yield from (f"  {line}" for line in _pairs(mechanism, say))
    yield from _freedoms(method, found, say)
    yield f"{say('drivers')}: {', '.join(driver.name for driver in mechanism.drivers)}"
    yield f"{say('groups')}:"
    groups = list(_groups(method, say))
    yield from (f"  {k}. {text}" for k, (text, _) in enumerate(groups, 1))
    if not groups:
        yield f"  {say('none')}"
    yield say("class", cls=ROMAN[lang][max((cls for _, cls in groups), default=1)])
    yield f"{say('methods')}: {', '.join(say(key) for key in _methods(method)) or say('none')}"


class _Speaker:
    def __init__(self, lang: Lang) -> None:
        self.lang = lang

    def __call__(self, key: str, **values: object) -> str:
        return WORDS[key][self.lang].format(**values)


def _pairs(mechanism: Mechanism, say: _Speaker) -> Iterator[str]:
    def called(links: tuple[str, ...]) -> str:
        return ", ".join(mechanism.called(link) for link in links)

    for hinge in mechanism.hinges:
        yield say("multiple" if len(hinge.links) > 2 else "hinge", point=hinge.point, links=called(hinge.links))
    for slide in mechanism.slides:
        guide = mechanism.called(slide.guide)
        if slide.block is None:
            yield say("pin", point=slide.point, guide=guide)
        else:
            yield say("slide", block=mechanism.called(slide.block), guide=guide)
    for key, pairs in (("gear", mechanism.gears), ("roll", mechanism.rolls), ("cam", mechanism.cams)):
        for pair in pairs:
            yield say(key, links=called(pair.joins))


def _freedoms(method: Method, found: Mobility, say: _Speaker) -> Iterator[str]:
    """F = 3 n - 2 p_l - p_h: a pin in a slot, a cam pair and a gear pair take one freedom, rolling contact two."""
    mechanism = method.mechanism
    low = sum(len(hinge.links) - 1 for hinge in mechanism.hinges)
    low += sum(slide.block is not None for slide in mechanism.slides) + len(mechanism.rolls)
    high = sum(slide.block is None for slide in mechanism.slides) + len(mechanism.gears) + len(mechanism.cams)
    count = len(mechanism.moving)
    yield say("formula", n=count, low=low, high=high, f=3 * count - 2 * low - high)
    yield say("rank", f=found.freedoms)
    if found.idle:
        yield "  " + say("idle", links=", ".join(found.idle))
    if found.repeated:
        yield "  " + say("redundant", count=found.repeated)
        yield from ("  " + say("repeats", what=what) for what in redundant_constraints(method, say.lang))


def _groups(method: Method, say: _Speaker) -> Iterator[tuple[str, int]]:
    """Each group in words, with its class; driven links are Class I by themselves and make no group."""
    for stage in method.stages:
        match stage:
            case Loop():
                kind = "".join(_letter(method, joint) for joint in stage.joints)
                yield say("dyad", kind=kind.strip(), links=_named(method, stage.bodies)), 2
            case Group() if not stage.loops:
                yield say("train", links=_named(method, stage.angles)), 1
            case Group():
                yield _group(method, stage, say)
            case Mesh():
                yield say("wheel", links=", ".join(method.mechanism.called(w) for w in stage.contact.wheels)), 1
            case Carry() | Bridge():
                pass


def _group(method: Method, stage: Group, say: _Speaker) -> tuple[str, int]:
    links = _named(method, stage.bodies)
    if (found := method.ternaries.get(stage)) is not None:
        return say("triad", links=links, point=found.name, link=found.link), 3
    cls = 4 if len(stage.loops) == 2 and not stage.contacts else 3 + len(stage.loops) - 1
    return say("higher", cls=ROMAN[say.lang][min(cls, 5)], links=links), min(cls, 5)


def _letter(method: Method, joint: Joint) -> str:
    """R for a hinge, P for a sliding pair; a driven one counts as rigid."""
    if isinstance(joint, Hinge):
        return "R"
    return "" if joint.slide in method.structure.slides_driven else "P"


def _named(method: Method, bodies: tuple[str, ...]) -> str:
    """Links of the file; blocks that stand for pins and links of an equivalent are none."""
    return ", ".join(body for body in bodies if body in method.mechanism.links and body != FRAME)


def _methods(method: Method) -> Iterator[str]:
    terms = [term for equation in method.acceleration.equations for term in equation.left + equation.right]
    if any(term.part == "t" and not term.over for term in terms):
        yield "two points"
    if any(term.part == "k" for term in terms):
        yield "coincident"
    if method.ternaries:
        yield "special"
    groups = [stage for stage in method.stages if isinstance(stage, Group)]
    if any(stage not in method.ternaries for stage in groups):
        yield "together"
    if method.mechanism.gears or method.mechanism.rolls:
        yield "rolling"
    if method.mechanism.cams:
        yield "lower"
