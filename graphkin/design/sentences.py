"""The words of a design: one sentence a stage of its construction, one a reason, in both languages."""
# ruff: noqa: E501

from __future__ import annotations

from graphkin.errors import Lang

__all__ = ["HEADINGS", "NAMES", "REASONS", "SENTENCES", "WORDS", "Both"]

Both = dict[Lang, str]

SENTENCES: dict[str, Both] = {
    "theta": {
        "en": "Angle between the crank's limit positions: θ = 180°(K − 1)/(K + 1) = 180° × {less:n}/{more:n} = {theta:deg}. Choose the scale.",
        "zh": "求极位夹角：θ = 180°(K − 1)/(K + 1) = 180° × {less:n}/{more:n} = {theta:deg}，并确定比例尺 μl。",
    },
    "rocker limits": {
        "en": "Draw the angle C1DC2 = ψ = {psi:deg} with C1D = C2D = {c:mm}: the rocker's two limit positions.",
        "zh": "作 ∠C1DC2 = ψ = {psi:deg}，C1D = C2D = {c:mm}，得摇杆的两个极限位置。",
    },
    "slider limits": {
        "en": "Draw C1C2 = H = {H:mm} on the guide: the slider's two limit positions.",
        "zh": "在导路上作 C1C2 = H = {H:mm}，得滑块的两个极限位置。",
    },
    "corner": {
        "en": "On C1C2 draw the angle C2C1P = 90° − θ = {rest:deg} and C2P at right angles to C1C2; they meet at P, on the near side of C1C2.",
        "zh": "以 C1C2 为底作 ∠C2C1P = 90° − θ = {rest:deg}，作 C2P ⊥ C1C2，两线交于 P 点。",
    },
    "corner beyond": {
        "en": "On C1C2, away from D, draw the angle C2C1P = 90° − θ = {rest:deg} and C2P at right angles to C1C2; they meet at P. (The slow stroke is then the other one.)",
        "zh": "在 C1C2 的另一侧（背离 D）作 ∠C2C1P = 90° − θ = {rest:deg}，作 C2P ⊥ C1C2，两线交于 P 点（此时慢行程方向相反）。",
    },
    "circle": {
        "en": "Draw the circle through C1, C2 and P (centre O, the middle of C1P): from its points C1C2 is seen under θ.",
        "zh": "作 △C1C2P 的外接圆（圆心 O 为 C1P 的中点）；圆上各点对 C1C2 的圆周角均为 θ。",
    },
    "circle beyond": {
        "en": "Draw the circle through C1, C2 and P (centre O, the middle of C1P): from its points beyond C1C2 the chord is seen under θ.",
        "zh": "作 △C1C2P 的外接圆（圆心 O 为 C1P 的中点）；C1C2 外侧圆弧上各点对 C1C2 的圆周角均为 θ。",
    },
    "A by frame": {
        "en": "With D as centre and the frame's length {frame:mm} as radius draw an arc; it meets the circle at A, so that AD = {frame:mm}.",
        "zh": "以 D 为圆心、机架长 {frame:mm} 为半径作弧，与该圆交于 A 点，使 AD = {frame:mm}。",
    },
    "A by offset": {
        "en": "Draw a line parallel to C1C2 at the distance e = {offset:mm}; it meets the circle at A.",
        "zh": "作与 C1C2 平行、距离为偏距 e = {offset:mm} 的直线，与该圆交于 A 点。",
    },
    "A by AC1": {
        "en": "With C1 as centre and AC1 = {ac1:mm} as radius draw an arc; it meets the circle at A.",
        "zh": "以 C1 为圆心、AC1 = {ac1:mm} 为半径作弧，与该圆交于 A 点。",
    },
    "A by crank": {
        "en": "N is the middle of the minor arc C1C2. The circle about N through C1 and the circle about C2 with radius 2a = {twice:mm} meet at E; C2E produced meets the circle again at A, for AE = AC1.",
        "zh": "取劣弧 C1C2 的中点 N。以 N 为圆心、过 C1 作圆，以 C2 为圆心、2a = {twice:mm} 为半径作弧，两者交于 E；延长 C2E 交外接圆于 A 点（AE = AC1）。",
    },
    "A by coupler": {
        "en": "N is the middle of the major arc C1C2. The circle about N through C1 and the circle about C2 with radius 2b = {twice:mm} meet at E; C2E meets the circle at A, for AE = AC1.",
        "zh": "取优弧 C1C2 的中点 N。以 N 为圆心、过 C1 作圆，以 C2 为圆心、2b = {twice:mm} 为半径作弧，两者交于 E；C2E 交外接圆于 A 点（AE = AC1）。",
    },
    "A by gamma": {
        "en": "Try points A along the circle until the least transmission angle is γmin = {gamma_min:deg} (found numerically; ruler and compass do not give it).",
        "zh": "在圆上试取 A 点，直至最小传动角 γmin = {gamma_min:deg}（用数值方法求得，尺规不能直接作出）。",
    },
    "A at best": {
        "en": "A may be anywhere on the admissible arcs: take the point with the largest least transmission angle (found numerically along the arcs).",
        "zh": "A 点可在许用圆弧上任选：取最小传动角为最大的一点（沿圆弧用数值方法求得）。",
    },
    "rocker lengths": {
        "en": "Measure AC1 = {AC1:mm}, AC2 = {AC2:mm}, AD = {d:mm}. Crank lAB = |AC2 − AC1|/2 = {a:mm}, coupler lBC = (AC1 + AC2)/2 = {b:mm}.",
        "zh": "量得 AC1 = {AC1:mm}，AC2 = {AC2:mm}，AD = {d:mm}。解得曲柄 lAB = |AC2 − AC1|/2 = {a:mm}，连杆 lBC = (AC1 + AC2)/2 = {b:mm}。",
    },
    "slider lengths": {
        "en": "Measure AC1 = {AC1:mm}, AC2 = {AC2:mm}. Crank lAB = |AC2 − AC1|/2 = {a:mm}, rod lBC = (AC1 + AC2)/2 = {b:mm}.",
        "zh": "量得 AC1 = {AC1:mm}，AC2 = {AC2:mm}。解得曲柄 lAB = |AC2 − AC1|/2 = {a:mm}，连杆 lBC = (AC1 + AC2)/2 = {b:mm}。",
    },
    "theta swing": {
        "en": "The bar's swing equals the angle between the crank's limit positions: ψ = θ = 180°(K − 1)/(K + 1) = 180° × {less:n}/{more:n} = {theta:deg}.",
        "zh": "导杆的摆角等于极位夹角：ψ = θ = 180°(K − 1)/(K + 1) = 180° × {less:n}/{more:n} = {theta:deg}。",
    },
    "guide pivots": {
        "en": "Lay off the frame AC = {frame:mm}.",
        "zh": "作机架 AC = {frame:mm}。",
    },
    "guide limits": {
        "en": "Through C draw Cm and Cn at ψ/2 = {halved:deg} to both sides of CA: the bar's two limit positions.",
        "zh": "过 C 点在 CA 两侧各作夹角为 ψ/2 = {halved:deg} 的直线 Cm、Cn，得导杆的两个极限位置。",
    },
    "guide limits alone": {
        "en": "From any point C draw the angle mCn = ψ = {theta:deg} and its bisector: the bar's two limit positions; A lies on the bisector.",
        "zh": "任取 C 点，作 ∠mCn = ψ = {theta:deg} 及其角平分线，得导杆的两个极限位置；A 点在角平分线上。",
    },
    "guide crank fits": {
        "en": "A line parallel to Cm at the distance of the crank's length {crank:mm} meets the bisector at A.",
        "zh": "作与 Cm 平行、距离为曲柄长 {crank:mm} 的直线，与角平分线交于 A 点。",
    },
    "guide lengths": {
        "en": "From A draw AB1 at right angles to Cm and AB2 to Cn. Measure the crank lAB = AB1 = {a:mm} and the frame lAC = {d:mm}.",
        "zh": "过 A 作 AB1 ⊥ Cm、AB2 ⊥ Cn。量得曲柄 lAB = AB1 = {a:mm}，机架 lAC = {d:mm}。",
    },
    "coupler laid": {
        "en": "Draw the given positions of the coupler: B1C1, B2C2, .. of length {b1:mm}.",
        "zh": "作连杆的各给定位置 B1C1、B2C2……，长 {b1:mm}。",
    },
    "centre A": {
        "en": "The perpendicular bisectors of B1B2 and B2B3 meet at A.",
        "zh": "作 B1B2、B2B3 的中垂线，交点为固定铰链中心 A。",
    },
    "centre D": {
        "en": "The perpendicular bisectors of C1C2 and C2C3 meet at D.",
        "zh": "作 C1C2、C2C3 的中垂线，交点为固定铰链中心 D。",
    },
    "A given": {
        "en": "On the perpendicular bisector of B1B2 take the given A ({A_x:n}, {A_y:n}).",
        "zh": "作 B1B2 的中垂线，在其上取给定的 A ({A_x:n}, {A_y:n})。",
    },
    "A chosen": {
        "en": "A may be anywhere on the perpendicular bisector of B1B2; ({A_x:n}, {A_y:n}) is chosen, for a good transmission angle.",
        "zh": "A 可在 B1B2 的中垂线上任选；为使传动角较大，取 A ({A_x:n}, {A_y:n})。",
    },
    "D given": {
        "en": "On the perpendicular bisector of C1C2 take the given D ({D_x:n}, {D_y:n}).",
        "zh": "作 C1C2 的中垂线，在其上取给定的 D ({D_x:n}, {D_y:n})。",
    },
    "D chosen": {
        "en": "D may be anywhere on the perpendicular bisector of C1C2; ({D_x:n}, {D_y:n}) is chosen, for a good transmission angle.",
        "zh": "D 可在 C1C2 的中垂线上任选；为使传动角较大，取 D ({D_x:n}, {D_y:n})。",
    },
    "coupler lengths": {
        "en": "Measure lAB = AB1 = {a:mm}, lBC = {b:mm}, lCD = C1D = {c:mm}, lAD = {d:mm}.",
        "zh": "量得 lAB = AB1 = {a:mm}，lBC = {b:mm}，lCD = C1D = {c:mm}，lAD = {d:mm}。",
    },
    "ratios": {
        "en": "Freudenstein's equation cos(φ − ψ) = R1 cos ψ − R2 cos φ + R3 for the three pairs gives R1 = {R1:n}, R2 = {R2:n}, R3 = {R3:n}; a = d/R1 = {a:mm}, c = d/R2 = {c:mm}.",
        "zh": "将三组对应角代入 cos(φ − ψ) = R1 cos ψ − R2 cos φ + R3，解得 R1 = {R1:n}，R2 = {R2:n}，R3 = {R3:n}；a = d/R1 = {a:mm}，c = d/R2 = {c:mm}。",
    },
    "frame laid": {
        "en": "Lay off the frame AD = {d:mm}.",
        "zh": "作机架 AD = {d:mm}。",
    },
    "angles laid": {
        "en": "Lay off AB1, AB2, AB3 at φ = {phi1:deg}, {phi2:deg}, {phi3:deg} and DC1, DC2, DC3 at ψ = {psi1:deg}, {psi2:deg}, {psi3:deg} to AD.",
        "zh": "与 AD 成 φ = {phi1:deg}、{phi2:deg}、{phi3:deg} 作 AB1、AB2、AB3，成 ψ = {psi1:deg}、{psi2:deg}、{psi3:deg} 作 DC1、DC2、DC3。",
    },
    "angles coupler": {
        "en": "Measure lBC = B1C1 = {b:mm}; at the other positions it is {b2:mm} and {b3:mm}.",
        "zh": "量得 lBC = B1C1 = {b:mm}；另两位置为 {b2:mm}、{b3:mm}。",
    },
    "crank laid": {
        "en": "Lay off the crank AB = {a:mm} at φ = {phi1:deg}, {phi2:deg}, {phi3:deg} to AD.",
        "zh": "与 AD 成 φ = {phi1:deg}、{phi2:deg}、{phi3:deg} 作曲柄 AB1、AB2、AB3，长 {a:mm}。",
    },
    "turned back": {
        "en": "Inversion: turn B2 about D by ψ1 − ψ2 = {psi12:deg} to B2', B3 by ψ1 − ψ3 = {psi13:deg} to B3'; the rocker then stands still at DC1.",
        "zh": "反转法：将 B2 绕 D 转 ψ1 − ψ2 = {psi12:deg} 至 B2'，将 B3 绕 D 转 ψ1 − ψ3 = {psi13:deg} 至 B3'，摇杆则相当于固定在 DC1 位置。",
    },
    "inverted centre": {
        "en": "The perpendicular bisectors of B1B2' and B2'B3' meet at C1.",
        "zh": "作 B1B2'、B2'B3' 的中垂线，交点为 C1。",
    },
    "inverted lengths": {
        "en": "Measure lBC = B1C1 = {b:mm}, lCD = C1D = {c:mm}; DC1 stands at {psi01:deg} to AD.",
        "zh": "量得 lBC = B1C1 = {b:mm}，lCD = C1D = {c:mm}；DC1 与 AD 成 {psi01:deg}。",
    },
}

REASONS: dict[str, Both] = {
    "minor": {
        "en": "A lies on the minor arc C1C2: there the chord is seen under 180° − θ, not θ.",
        "zh": "A 在劣弧 C1C2 上：该处圆周角为 180° − θ，而不是 θ。",
    },
    "FG": {
        "en": "A lies on the arc FG: C1 and C2 belong to different assemblies, and the linkage cannot move from one to the other.",
        "zh": "A 在 FG 弧段上：C1、C2 分属两种装配位形，机构不能由一个极限位置连续运动到另一个（错位不连续）。",
    },
    "no crank": {
        "en": "A is as far from C1 as from C2: the crank would have no length.",
        "zh": "A 到 C1、C2 的距离相等：曲柄长度为零。",
    },
    "change point": {
        "en": "The links come to lie in one line (a change point, γmin = 0): the crank does not carry the linkage through.",
        "zh": "各杆可共线（变点机构，γmin = 0），曲柄不能可靠地带动机构连续转动。",
    },
    "low gamma": {
        "en": "γmin = {gamma:deg} is below the usual 40°.",
        "zh": "γmin = {gamma:deg}，小于一般要求的 40°。",
    },
    "range": {
        "en": "The {name} must be between {low:mm} and {high:mm} for these values.",
        "zh": "在所给条件下，{name}应在 {low:mm} 与 {high:mm} 之间。",
    },
    "range angle": {
        "en": "The {name} can be at most {high:deg} for these values.",
        "zh": "在所给条件下，{name}最大为 {high:deg}。",
    },
    "no arc": {
        "en": "No part of the circle is admissible. Change the swing or K.",
        "zh": "圆上没有许用弧段。请改变摆角或 K。",
    },
    "no links": {
        "en": "A link has no length, or the links lie stretched in one line: this cannot move.",
        "zh": "有构件长度为零，或各杆拉成一直线，机构不能运动。",
    },
    "kind": {"en": "Kind: {kind}.", "zh": "类型：{kind}。"},
    "no Grashof": {
        "en": "Shortest + longest is more than the other two (Grashof fails): no link turns fully.",
        "zh": "最短杆与最长杆之和大于其余两杆之和（不满足杆长条件），没有整转副。",
    },
    "crank rocks": {"en": "AB does not turn fully.", "zh": "AB 不能整周转动。"},
    "drive at CD": {
        "en": "Driven at DC instead, it passes all positions.",
        "zh": "若改以 DC 为原动件，则可依次通过各位置。",
    },
    "dead there": {
        "en": "Position {position:d} is a dead point for the driver AB: BC and CD are in line.",
        "zh": "位置 {position:d} 是 AB 主动时的死点：BC 与 CD 共线。",
    },
    "branch": {
        "en": "Branch defect: between positions {first:d} and {second:d} the assembly changes (BC and CD would have to pass through a line).",
        "zh": "错位不连续：位置 {first:d} 与 {second:d} 分属不同装配位形（BC 与 CD 须经过共线位置）。",
    },
    "circuit": {
        "en": "Position {position:d} lies on another circuit: AB cannot turn there without taking the linkage apart.",
        "zh": "位置 {position:d} 属于另一运动区域：不拆开机构，AB 不能转到该位置（错位不连续）。",
    },
    "order": {
        "en": "Order defect: AB does not turn one way through positions 1, 2, 3.",
        "zh": "错序不连续：AB 单向转动时不能依次通过位置 1、2、3。",
    },
    "in line": {
        "en": "{hinge}1, {hinge}2, {hinge}3 lie in one line: the centre {pivot} is at infinity. Guide {hinge} by a slider, or take another hinge.",
        "zh": "{hinge}1、{hinge}2、{hinge}3 共线：{pivot} 在无穷远处。请改用滑块引导 {hinge}，或另选铰链点。",
    },
    "no ratios": {
        "en": "The three pairs do not determine R1, R2, R3. Change a pair, or give phi0, psi0.",
        "zh": "三组角度不能唯一确定 R1、R2、R3。请改变其中一组，或给定 φ0、ψ0。",
    },
    "endless": {
        "en": "A link would have to be endless (R1 or R2 is 0). Change a pair, or phi0, psi0.",
        "zh": "有构件须为无穷长（R1 或 R2 为零）。请改变其中一组角度，或改变 φ0、ψ0。",
    },
    "no coupler": {
        "en": "The coupler would have no real length. Change a pair, or phi0, psi0.",
        "zh": "连杆长度无实数解。请改变其中一组角度，或改变 φ0、ψ0。",
    },
    "turned": {
        "en": "{link} comes out negative ({mm:n} mm): the link would point the opposite way, at its angle + 180°.",
        "zh": "{link} 为负值（{mm:n} mm）：该杆实际指向相反方向，即所给角度加 180°。",
    },
    "inverted in line": {
        "en": "B1, B2', B3' lie in one line: C1 is at infinity. Change the crank's length, or a pair.",
        "zh": "B1、B2'、B3' 共线：C1 在无穷远处。请改变曲柄长度或其中一组角度。",
    },
}

HEADINGS: dict[str, Both] = {
    "rocker": {"en": "Crank-rocker from swing and K", "zh": "按行程速比系数设计曲柄摇杆机构"},
    "slider": {"en": "Slider-crank from stroke and K", "zh": "按行程速比系数设计曲柄滑块机构"},
    "guide-bar": {"en": "Oscillating guide bar from K", "zh": "按行程速比系数设计摆动导杆机构"},
    "coupler": {"en": "Four-bar through positions of its coupler", "zh": "按连杆给定位置设计铰链四杆机构"},
    "angles": {"en": "Four-bar for three pairs of angles", "zh": "按两连架杆三组对应角位置设计铰链四杆机构"},
}

NAMES: dict[str, Both] = {
    "frame": {"en": "frame", "zh": "机架长"}, "crank": {"en": "crank", "zh": "曲柄长"},
    "coupler": {"en": "coupler", "zh": "连杆长"}, "rod": {"en": "rod", "zh": "连杆长"},
    "offset": {"en": "offset", "zh": "偏距"}, "ac1": {"en": "distance AC1", "zh": "AC1"},
    "gamma_min": {"en": "least transmission angle", "zh": "最小传动角"}, "": {"en": "condition", "zh": "附加条件"},
}  # fmt: skip

WORDS: dict[str, Both] = {
    "solution": {"en": "Solution {number}: ", "zh": "解 {number}："},
    "useless": {"en": "Linkage {number}, which does not do: ", "zh": "机构 {number}（不可用）："},
    "refused": {"en": "No solution: ", "zh": "不是解："},
    "invalid": {"en": "does not do: ", "zh": "不可用："},
    "none": {"en": "There is no solution.", "zh": "无解。"},
    "proof": {"en": "Analysed back from its lengths: ", "zh": "由杆长分析验证："},
    "family": {
        "en": "Admissible A on the circle of centre ({x:n}, {y:n}) mm, radius {radius:mm}: {arcs}; least transmission angle at most {best:deg}.",
        "zh": "许用的 A 点在圆心 ({x:n}, {y:n}) mm、半径 {radius:mm} 的圆上：{arcs}；最小传动角最大可达 {best:deg}。",
    },
    "arcs": {"en": "from {start:deg} to {end:deg}", "zh": "{start:deg} 至 {end:deg}"},
    "slow ccw": {"en": "slow stroke C1 to C2 with the crank counter-clockwise", "zh": "曲柄逆时针转动时 C1 至 C2 为慢行程"},
    "slow cw": {"en": "slow stroke C1 to C2 with the crank clockwise", "zh": "曲柄顺时针转动时 C1 至 C2 为慢行程"},
}
