"""Sentences about a link's pole and Bobillier's construction, both languages side by side."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphkin.centres.about import About, CarriedPoint, Circle
from graphkin.centres.about_bobillier import Bobillier, Guided
from graphkin.drafting import Stage
from graphkin.errors import Lang

__all__ = ["about_words", "bobillier_words"]

WORDS: dict[str, dict[Lang, str]] = {
    "assumed": {
        "en": "No driver moves: each is taken to move at 1 rad/s (1 m/s).",
        "zh": "原动件均未给定速度：各按 1 rad/s（1 m/s）计算。",
    },
    "pole": {
        "en": "Link {link} turns about its instant centre P {place} with omega = {omega:.4g} rad/s, alpha = "
        "{alpha:.4g} rad/s².",
        "zh": "构件 {link} 绕瞬心 P {place} 转动，ω = {omega:.4g} rad/s，α = {alpha:.4g} rad/s²。",
    },
    "translation": {
        "en": "Link {link} is in translation: P lies at infinity in the direction {at:.4g}°, omega = 0, alpha = "
        "{alpha:.4g} rad/s².",
        "zh": "构件 {link} 作瞬时平动：瞬心 P 在方向 {at:.4g}° 的无穷远处，ω = 0，α = {alpha:.4g} rad/s²。",
    },
    "rest": {"en": "Link {link} stands still at this instant.", "zh": "构件 {link} 此刻静止。"},
    "acceleration": {
        "en": "Acceleration pole J {place}: the acceleration of this point of the link is 0.",
        "zh": "加速度瞬心 J {place}：构件上该点的加速度为零。",
    },
    "no acceleration": {
        "en": "There is no acceleration pole: omega = alpha = 0, all points have one acceleration.",
        "zh": "没有加速度瞬心：ω = α = 0，各点加速度相同。",
    },
    "pivot": {
        "en": "P is a fixed point: every point moves on a circle about it, there is no inflection circle.",
        "zh": "P 为固定点：各点均绕其作圆周运动，没有拐点圆。",
    },
    "moving pole": {
        "en": "The pole moves along the centrodes with u = {u:.4g} m/s; the pole tangent stands at {tangent:.4g}° to "
        "+x.",
        "zh": "瞬心沿瞬心线移动的速度 u = {u:.4g} m/s；极切线与 x 轴正向成 {tangent:.4g}°。",
    },
    "inflection": {
        "en": "Inflection circle: through P, diameter |u/omega| = {diameter:.4g} mm along the pole normal; centre "
        "{place}. The "
        "paths of its points are straight at this instant.",
        "zh": "拐点圆：过 P，直径 |u/ω| = {diameter:.4g} mm，沿极法线；圆心 {place}。圆上各点的轨迹此刻曲率为零。",
    },
    "return": {
        "en": "Return (cuspidal) circle: its mirror image in the pole tangent, centre {place}.",
        "zh": "回转圆：拐点圆对极切线的镜像，圆心 {place}。",
    },
    "inflection line": {
        "en": "The inflection circle has become a line through {place}, at {at:.4g}° to +x.",
        "zh": "拐点圆退化为直线：过 {place}，与 x 轴正向成 {at:.4g}°。",
    },
    "curved": {
        "en": "{name}: v = {v:.4g} m/s, a = {a:.4g} m/s²; radius of curvature {radius:.4g} mm, centre of curvature "
        "{place}.",
        "zh": "{name}：v = {v:.4g} m/s，a = {a:.4g} m/s²；轨迹曲率半径 {radius:.4g} mm，曲率中心 {place}。",
    },
    "straight": {
        "en": "{name}: v = {v:.4g} m/s, a = {a:.4g} m/s²; its path is straight at this instant.",
        "zh": "{name}：v = {v:.4g} m/s，a = {a:.4g} m/s²；轨迹此刻曲率为零（曲率中心在无穷远处）。",
    },
    "cusp": {
        "en": "{name} lies at the pole: v = 0, a = {a:.4g} m/s²; its path has a cusp.",
        "zh": "{name} 位于瞬心：v = 0，a = {a:.4g} m/s²；轨迹在此为尖点。",
    },
    "still": {"en": "{name} stands still.", "zh": "{name} 静止不动。"},
}


def about_words(seen: About, lang: Lang) -> list[str]:
    """What is known of the link at this instant, a sentence each."""
    return [*_about(seen, lang)]


def _about(seen: About, lang: Lang) -> Iterator[str]:
    known = {"link": seen.called, "omega": seen.omega, "alpha": seen.alpha}
    if seen.assumed:
        yield WORDS["assumed"][lang]
    if not seen.moves:
        yield WORDS["rest"][lang].format(**known)
    elif seen.diameter is None:
        yield WORDS["translation"][lang].format(**known, at=_degrees(seen.towards))
    else:
        yield WORDS["pole"][lang].format(**known, place=_place(seen.pole))
    if seen.acceleration_pole is not None:
        yield WORDS["acceleration"][lang].format(place=_place(seen.acceleration_pole))
    elif seen.moves:
        yield WORDS["no acceleration"][lang]
    yield from _circles(seen, lang)
    for name, carried in seen.points.items():
        yield _point(name, carried, lang)


def _circles(seen: About, lang: Lang) -> Iterator[str]:
    inflection, returning = seen.inflection, seen.returning
    if inflection is None:
        return
    if not isinstance(inflection, Circle):
        place, at = _place(inflection.through), _degrees(inflection.direction)
        yield WORDS["inflection line"][lang].format(place=place, at=at)
        return
    if seen.tangent is None or returning is None or seen.pole_velocity is None:
        yield WORDS["pivot"][lang]
        return
    yield WORDS["moving pole"][lang].format(u=abs(seen.pole_velocity), tangent=_degrees(seen.tangent))
    yield WORDS["inflection"][lang].format(diameter=2e3 * inflection.radius, place=_place(inflection.centre))
    yield WORDS["return"][lang].format(place=_place(returning.centre))


def _point(name: str, carried: CarriedPoint, lang: Lang) -> str:
    known = {"name": name, "v": abs(carried.velocity), "a": abs(carried.acceleration)}
    if cmath.isnan(carried.centre):
        return WORDS["still"][lang].format(**known)
    if cmath.isinf(carried.centre):
        return WORDS["straight"][lang].format(**known)
    if carried.radius == 0:
        return WORDS["cusp"][lang].format(**known)
    return WORDS["curved"][lang].format(**known, radius=1e3 * carried.radius, place=_place(carried.centre))


def _place(place: complex) -> str:
    """`(66.4, 182.4) mm`; what is nothing but rounding as 0."""
    x, y = (0.0 if abs(value) < 1e-9 else 1e3 * value for value in (place.real, place.imag))
    return f"({x:.4g}, {y:.4g}) mm"


def _degrees(direction: complex) -> float:
    """A line's direction, in (-90, 90] deg."""
    angle = math.degrees(cmath.phase(direction))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle


# --- Bobillier's construction -----------------------------------------------------------------

BOBILLIER: dict[str, dict[Lang, str]] = {
    "pivoted": {
        "en": "{point} moves about {centre}: {centre} is the centre of curvature of its path, and the ray "
        "{point}{centre} passes "
        "the pole.",
        "zh": "点 {point} 绕 {centre} 运动：{centre} 为其轨迹的曲率中心，射线 {point}{centre} 过瞬心。",
    },
    "guided": {
        "en": "{point} moves on a straight line: its centre of curvature {centre} lies at infinity, and its ray is the "
        "perpendicular to the path in {point}.",
        "zh": "点 {point} 沿直线运动：其曲率中心 {centre} 在无穷远处，射线为过 {point} 的轨迹垂线。",
    },
    "measured": {
        "en": "{point}: the centre of curvature {centre} of its path is known from v and a (rho = v²/a_n).",
        "zh": "点 {point}：由 v、a 求得其轨迹的曲率中心 {centre}（ρ = v²/a_n）。",
    },
    "P": {"en": "The two rays meet at the pole {p}.", "zh": "两射线的交点为瞬心 {p}。"},
    "Q": {
        "en": "The lines {a}{b} and {a0}{b0} meet at {q}.",
        "zh": "直线 {a}{b} 与 {a0}{b0} 的交点为 {q}。",
    },
    "Q far": {
        "en": "The lines {a}{b} and {a0}{b0} are parallel: {q} lies at infinity.",
        "zh": "直线 {a}{b} 与 {a0}{b0} 平行：{q} 在无穷远处。",
    },
    "Q line": {
        "en": "{a0} and {b0} both lie at infinity; so does {q}, in the direction of {a}{b}.",
        "zh": "{a0}、{b0} 都在无穷远处，故 {q} 也在 {a}{b} 方向的无穷远处。",
    },
    "axis": {
        "en": "{p}{q} is the collineation axis of {a} and {b}.",
        "zh": "{p}{q} 为点 {a}、{b} 的共线轴。",
    },
    "ray c": {"en": "Draw the ray {p}{c}.", "zh": "作射线 {p}{c}。"},
    "axis c": {
        "en": "Carry the angle from the ray of {b} to {p}{c} over to {p}{q}, with its sense: this is the collineation "
        "axis of {a} and {c}.",
        "zh": "将 {b} 的射线到 {p}{c} 的转角（连同转向）移到 {p}{q} 上，得点 {a}、{c} 的共线轴。",
    },
    "Qc": {
        "en": "It meets the line {a}{c} at {qc}.",
        "zh": "它与直线 {a}{c} 的交点为 {qc}。",
    },
    "K": {
        "en": "The line {a0}{qc} meets the ray {p}{c} at {k}, the centre of curvature of the path of {c}.",
        "zh": "直线 {a0}{qc} 与射线 {p}{c} 的交点 {k} 即为点 {c} 轨迹的曲率中心。",
    },
    "K far": {
        "en": "The line {a0}{qc} is parallel to the ray {p}{c}: the path of {c} is straight at this instant.",
        "zh": "直线 {a0}{qc} 与射线 {p}{c} 平行：点 {c} 的轨迹此刻曲率为零。",
    },
}


def bobillier_words(drawn: Bobillier, lang: Lang) -> list[str]:
    """What the two points are known from, and one sentence each stage."""
    first, second = drawn.guides
    known = {"a": first.point, "b": second.point, "a0": first.written, "b0": second.written, "c": drawn.point}
    q, qc = drawn.crossings
    known |= {"p": drawn.pole, "q": q, "qc": qc, "k": drawn.answer}
    keys = [_key(drawn, stage) for stage in drawn.construction.stages]
    return [*(_known(entry, lang) for entry in drawn.guides), *(BOBILLIER[key][lang].format(**known) for key in keys)]


def _key(drawn: Bobillier, stage: Stage) -> str:
    """A stage's key; its lines may be parallel."""
    if stage.say == "Q" and not any(entry.centre[2] for entry in drawn.guides):
        return "Q line"
    far = stage.say in ("Q", "K") and cmath.isinf(drawn.board.at(stage.last.name))
    return f"{stage.say} far" if far else stage.say


def _known(entry: Guided, lang: Lang) -> str:
    kind = "measured" if entry.measured else "pivoted" if entry.pivoted else "guided"
    return BOBILLIER[kind][lang].format(point=entry.point, centre=entry.written)
