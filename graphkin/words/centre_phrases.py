"""Every sentence about instant centres, both languages side by side."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.errors import Lang
from graphkin.words.contact_phrases import both

__all__ = ["CENTRE_PHRASES", "told"]


def told(key: str, lang: Lang, **words: object) -> str:
    """The sentence of this key with these words put in."""
    return CENTRE_PHRASES[key][lang].format(**words)


CENTRE_PHRASES: Mapping[str, dict[Lang, str]] = {
    "finding": both("(1) Instant centres", "(1) 求瞬心"),
    "count": both(
        "The mechanism has N = {n} links, the frame included: K = N(N−1)/2 = {n}×{less}/2 = {count} instant centres.",
        "机构共有 N = {n} 个构件（含机架），瞬心总数 K = N(N−1)/2 = {n}×{less}/2 = {count}。",
    ),
    "definition": both("By definition, of links that are joined directly:", "由瞬心定义直接确定的瞬心："),
    "kennedy": both(
        "By the theorem of three centres (Kennedy and Aronhold):", "不直接相连的构件，由三心定理确定其瞬心："
    ),
    # --- by definition -------------------------------------------------------------------------
    "hinge": both(
        "{name}: in hinge {point}, which joins links {first} and {second}; {place}.",
        "{name}：构件 {first}、{second} 以转动副 {point} 相连，瞬心在 {point}，{place}。",
    ),
    "contact": both(
        "{name}: links {first} and {second} roll on each other without sliding: where they touch, {place}.",
        "{name}：构件 {first}、{second} 作纯滚动，瞬心在接触点，{place}。",
    ),
    "slide": both(
        "{name}: links {first} and {second} slide on each other: at infinity, at right angles to the guide ({angle}).",
        "{name}：构件 {first}、{second} 组成移动副，瞬心在垂直于导路方向（{angle}）的无穷远处。",
    ),
    # --- Kennedy's lines -----------------------------------------------------------------------
    "two lines": both(
        "{name} lies on {first} and on {second}: {met}.", "{name} 在{first}上，又在{second}上：{met}。"
    ),
    "join": both("{line} (links {links})", " {line} 连线（构件 {links}）"),
    "across guide": both(
        "the line through {near} at right angles to the guide, towards {far} → ∞ (links {links})",
        "过 {near} 且垂直于导路的直线（指向 {far} → ∞，构件 {links}）",
    ),
    "parallel": both(
        "the line through {near} parallel to the direction of {far} → ∞ at {angle} (links {links})",
        "过 {near} 且平行于 {far} → ∞ 方向（{angle}）的直线（构件 {links}）",
    ),
    "at infinity": both(
        "the line at infinity, as {first} and {second} do (links {links})",
        "无穷远直线（{first}、{second} 均在无穷远，构件 {links}）",
    ),
    "normal": both(
        "the common normal n–n at the contact of links {first} and {second}",
        "构件 {first}、{second} 接触点处的公法线 n–n",
    ),
    "slot": both(
        "the normal of the slot through {point}, where links {first} and {second} touch",
        "构件 {first}、{second} 接触处 {point} 的槽的法线",
    ),
    "circular slot": both(
        "the normal n–n of the circular slot, through its centre {point}, where links {first} and {second} touch",
        "构件 {first}、{second} 接触处圆弧槽的公法线 n–n（过槽的圆心 {point}）",
    ),
    "met": both("where the two lines meet, {place}", "两线交点，{place}"),
    "met far": both("the lines are parallel, so {name} → ∞ at {angle}", "两线平行，故 {name} → ∞，方向 {angle}"),
    "met infinity": both("so {name} → ∞ at {angle}", "故 {name} → ∞，方向 {angle}"),
    # --- from velocities -----------------------------------------------------------------------
    "velocities": both(
        "{name} cannot be found by three-centre lines alone: {reason}. From velocities: where links {first} and "
        "{second} have one velocity, {place}.",
        "{name} 仅用三心定理不能确定：{reason}。由速度求得：构件 {first}、{second} 在该点速度相同，{place}。",
    ),
    "several freedoms": both(
        "the mechanism has {count} degrees of freedom, and the centre depends on how the drivers move",
        "机构有 {count} 个自由度，该瞬心与各原动件运动的比例有关",
    ),
    "lines coincide": both("no two lines through it that differ are known", "已知的过该点的直线重合或不足两条"),
    "together": both(
        "{name}: links {first} and {second} do not move against each other at this instant, and have no centre.",
        "{name}：构件 {first}、{second} 此瞬时无相对运动，不存在瞬心。",
    ),
    "mm": both("at ({x}, {y}) mm", "坐标（{x}，{y}）mm"),
    "infinite": both("at infinity, in the direction {angle}", "在方向 {angle} 的无穷远处"),
    # --- what they are used for ----------------------------------------------------------------
    "using": both("(2) Velocities from the centres", "(2) 用瞬心作速度分析"),
    "scale": both(
        "Lengths are measured on paper in mm; {scale} = {value} m/mm.",
        "长度在图上量取（mm），取 {scale} = {value} m/mm。",
    ),
    "given": both("Given: {what}.", "已知：{what}。"),
    "resting": both("No driver moves: nothing has a velocity.", "各原动件均静止，速度为零。"),
    "no accelerations": both(
        "Accelerations ({names}) cannot be found from instant centres.", "瞬心法不能用于加速度分析（{names}）。"
    ),
    "not told": both(
        "{name}: the centres give no lever for it at this position.", "{name}：此位置不能直接由瞬心求出。"
    ),
    "sense outside": both(
        "{sense}; {centre} lies outside {ends}: same sense", "{sense}，{centre} 在 {ends} 之外，转向相同"
    ),
    "sense between": both(
        "{sense}; {centre} lies between {ends}: opposite sense", "{sense}，{centre} 在 {ends} 之间，转向相反"
    ),
    "sense alike": both("{sense}; {centre} → ∞, the links turn alike", "{sense}，{centre} → ∞，两构件角速度相同"),
    "across": both("at right angles to {arm}, at {angle}", "⊥{arm}，方向 {angle}"),
    "along": both("the link moves without turning, at {angle}", "构件作平动，方向 {angle}"),
    "at": both("at {angle}", "方向 {angle}"),
    "same": both("same sense", "转向相同"),
    "opposite": both("opposite sense", "转向相反"),
    "triangle": both("from both velocities and their angle", "由两速度及其夹角"),
}
