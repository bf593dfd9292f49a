"""Every sentence of a problem, both languages side by side."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.errors import Lang

__all__ = ["KEYS", "PHRASES", "TABLES"]


def _both(en: str, zh: str) -> dict[Lang, str]:
    return {"en": en, "zh": zh}


PHRASES: Mapping[str, Mapping[Lang, str]] = {
    "student": _both("Problem of {student}", "{student} 的题目"),
    "given": _both(
        "Given (mm, degrees, rad/s, rad/s², m/s, m/s² where no unit stands; counter-clockwise positive):",
        "已知（未注单位者为 mm、°、rad/s、rad/s²、m/s、m/s²；逆时针为正）：",
    ),
    "find": _both("Find graphically:", "用图解法求："),
    "points": _both(" ({points:g} points)", "（{points:g} 分）"),
    "hand in": _both(
        "Hand in a text file with these lines, a number behind each; senses as signs or as ccw, cw:",
        "请提交含下列各行的文本文件，在每行后填写数值；转向用正负号或“逆时针”“顺时针”表示：",
    ),
    "shared": _both(
        "note: {count} students have a problem whose answers are another's, within 2 %: {students}. Widen the ranges.",
        "提示：{count} 名学生的题目与他人答案相同（相差 2% 以内）：{students}。请放宽范围。",
    ),
    "colon": _both(": ", "："),
    "between": _both(", ", "，"),
}

TABLES: Mapping[str, Mapping[Lang, str]] = {
    "frame": _both("Frame", "机架"), "links": _both("Link", "构件"), "slide": _both("Sliding pair", "移动副"),
    "gear": _both("Gear pair", "齿轮副"), "roll": _both("Rolling wheel", "滚轮"), "cam": _both("Cam pair", "凸轮副"),
    "driver": _both("Driver", "原动件"),
    "pose": _both("Drawn position", "作图位置"), "scales": _both("Scales", "比例尺"),
}  # fmt: skip
"""By table of the mechanism file."""

KEYS: Mapping[str, Mapping[Lang, str]] = {
    "name": _both("name", "名称"), "points": _both("points", "点"), "block": _both("block", "滑块"),
    "point": _both("point", "点"), "guide": _both("guide", "导路构件"), "through": _both("through", "过点"),
    "toward": _both("toward", "指向"), "from": _both("from the direction", "起始方向"), "angle": _both("angle", "角度"),
    "pin": _both("pin", "销"), "vector": _both("line", "线段"), "omega": _both("ω", "ω"), "alpha": _both("α", "α"),
    "velocity": _both("velocity", "速度"), "acceleration": _both("acceleration", "加速度"),
    "slide": _both("slide", "移动副"),
    "at": _both("displacement", "位移"), "also": _both("also at", "另求"), "link": _both("link", "构件"),
    "links": _both("links", "构件"), "centres": _both("centres", "中心"), "radii": _both("radii", "半径"),
    "internal": _both("internal", "内啮合"), "wheel": _both("wheel", "轮"), "centre": _both("centre", "中心"),
    "radius": _both("radius", "半径"), "on": _both("on", "在其上"), "side": _both("side", "侧"),
    "shape": _both("shape", "形状"), "tilt": _both("tilt", "倾角"), "profiles": _both("profiles", "廓线"),
    "length": _both("length", "长度"), "ccw": _both("counter-clockwise order", "逆时针顺序"),
}  # fmt: skip
"""By key of a table; names of points and lengths stand for themselves."""
