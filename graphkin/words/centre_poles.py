"""Sentences about the pole of two velocities, both languages side by side."""

from __future__ import annotations

import cmath

from graphkin.centres.two_velocities import TwoVelocities
from graphkin.errors import Lang

__all__ = ["pole_words"]


def pole_words(found: TwoVelocities, lang: Lang) -> list[str]:
    """What is drawn, and what is found, a sentence each."""
    (first, second), sense = found.names, "ccw" if found.omega > 0 else "cw"
    still, other = (first, second) if abs(found.velocities[0]) < abs(found.velocities[1]) else (second, first)
    known = {
        "a": first, "b": second, "still": still, "other": other, "x": 1e3 * found.place.real,
        "y": 1e3 * found.place.imag, "omega": abs(found.omega), "sense": SENSES[sense][lang],
        "at": (found.direction or 0.0) * 180 / cmath.pi,
    }  # fmt: skip
    along = cmath.phase(found.points[1] - found.points[0])
    component = (found.velocities[0] * cmath.rect(1, -along)).real
    component = component if abs(component) > 1e-12 * abs(found.fastest[1]) else 0.0
    told = [WORDS["rigid"][lang].format(**known, component=component), WORDS[found.case][lang].format(**known)]
    if found.case in ("meet", "similar", "point"):
        told.append(WORDS["omega"][lang].format(**known, v=abs(found.fastest[1]), arm=1e3 * abs(found.arm)))
    return told


SENSES: dict[str, dict[Lang, str]] = {
    "ccw": {"en": "counter-clockwise", "zh": "逆时针"},
    "cw": {"en": "clockwise", "zh": "顺时针"},
}
WORDS: dict[str, dict[Lang, str]] = {
    "rigid": {
        "en": "Along {a}{b} both velocities have the component {component:.4g} m/s: the points can belong to one "
        "rigid body.",
        "zh": "两点速度在 {a}{b} 连线上的投影相等，均为 {component:.4g} m/s，符合速度投影定理，属同一刚体。",
    },
    "meet": {
        "en": "The velocities are not parallel. The line through {a} across v_{a} and the line through {b} across "
        "v_{b} "
        "meet at the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "两速度不平行：过 {a} 作 v_{a} 的垂线，过 {b} 作 v_{b} 的垂线，两垂线的交点即为瞬心 P ({x:.4g}, "
        "{y:.4g}) mm。",
    },
    "infinity": {
        "en": "The velocities are parallel and equal. The perpendiculars are parallel: the instant centre lies at "
        "infinity, in "
        "the direction {at:.4g}°; omega = 0, the body is in translation at this instant.",
        "zh": "两速度平行且相等：两垂线互相平行，瞬心在无穷远处（方向 {at:.4g}°），ω = 0，刚体作瞬时平动。",
    },
    "similar": {
        "en": "The velocities are parallel, across {a}{b}, and unequal. By similar triangles the line through the "
        "tips of the "
        "two velocity arrows meets the line {a}{b} at the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "两速度平行（均垂直于 {a}{b}）但不相等：由相似三角形，两速度矢端的连线与 {a}{b} 连线的交点即为瞬心 "
        "P ({x:.4g}, {y:.4g}) mm。",
    },
    "point": {
        "en": "The velocity of {still} is 0: {still} itself is the instant centre P ({x:.4g}, {y:.4g}) mm.",
        "zh": "点 {still} 的速度为零，{still} 即为瞬心 P ({x:.4g}, {y:.4g}) mm。",
    },
    "rest": {
        "en": "Both velocities are 0: the body stands still at this instant, and no instant centre is seen.",
        "zh": "两点速度均为零：刚体此刻静止，看不出瞬心。",
    },
    "omega": {
        "en": "omega = {v:.4g} m/s / {arm:.4g} mm = {omega:.4g} rad/s, {sense}.",
        "zh": "ω = {v:.4g} m/s / {arm:.4g} mm = {omega:.4g} rad/s（{sense}）。",
    },
}
