"""The words of linkages of four links, English and Chinese."""
# ruff: noqa: E501

from __future__ import annotations

from graphkin.errors import Lang

Both = dict[Lang, str]

KINDS: dict[str, Both] = {
    "crank-rocker": {"en": "crank-rocker", "zh": "曲柄摇杆机构"},
    "rocker-crank": {"en": "rocker-crank (a crank-rocker driven at the rocker)", "zh": "曲柄摇杆机构（摇杆主动）"},
    "double-crank": {"en": "double-crank (drag link)", "zh": "双曲柄机构"},
    "double-rocker": {"en": "double-rocker (the coupler is shortest)", "zh": "双摇杆机构（连杆最短，可整周转动）"},
    "triple-rocker": {"en": "triple-rocker (no Grashof)", "zh": "双摇杆机构（不满足杆长条件）"},
    "change-point": {"en": "change-point linkage", "zh": "变点机构"},
    "slider-crank": {"en": "slider-crank", "zh": "曲柄滑块机构"},
    "rocker-slider": {"en": "rocker-slider", "zh": "摇杆滑块机构"},
    "oscillating guide bar": {"en": "oscillating guide bar", "zh": "摆动导杆机构"},
    "rotating guide bar": {"en": "rotating guide bar", "zh": "转动导杆机构"},
    "rocking guide bar": {"en": "guide bar whose crank does not turn fully", "zh": "导杆机构（连架杆均不能整周转动）"},
}

BLOCKS: dict[str, Both] = {
    "oscillating guide bar": {"en": "oscillating block", "zh": "曲柄摇块机构"},
    "rotating guide bar": {"en": "rotating block", "zh": "转动导块机构"},
    "slider-crank": {"en": "sliding guide bar in a fixed block", "zh": "移动导杆机构（定块机构）"},
    "rocker-slider": {"en": "sliding guide bar in a fixed block", "zh": "移动导杆机构（定块机构）"},
}
"""Where the block stands on the frame, and the bar slides in it."""

FAMILIES: dict[str, Both] = {
    "parallelogram": {"en": "parallelogram", "zh": "平行四边形机构"},
    "antiparallelogram": {"en": "antiparallelogram", "zh": "反平行四边形机构"},
    "rhombus": {"en": "rhombus", "zh": "菱形机构"},
    "folded rhombus": {"en": "folded rhombus", "zh": "折叠的菱形机构"},
    "kite": {"en": "kite", "zh": "筝形机构"},
    "in-line": {"en": "in-line", "zh": "对心"},
    "offset": {"en": "offset", "zh": "偏置"},
    "isosceles": {"en": "isosceles slider-crank", "zh": "等腰曲柄滑块机构"},
    "turning rod": {"en": "the rod turns fully", "zh": "连杆可整周转动"},
    "no full turn": {"en": "no link turns fully", "zh": "各构件均不能整周转动"},
    "block": {"en": "oscillating block", "zh": "摇块"},
    "bar": {"en": "bar hinged to the frame", "zh": "导杆与机架铰接"},
}

WHY: dict[str, Both] = {
    "crank-rocker": {
        "en": "The shortest link {crank} lies next to the frame and drives: it turns fully, {rocker} rocks.",
        "zh": "最短杆 {crank} 是连架杆且为原动件，能整周转动，为曲柄；{rocker} 只能摆动，为摇杆。",
    },
    "rocker-crank": {
        "en": "The driven link {driver} rocks; {output}, the shortest link, turns fully. It needs help past two dead points.",
        "zh": "原动件 {driver} 为摇杆；最短杆 {output} 为曲柄，能整周转动。机构有两个死点位置，须借惯性等通过。",
    },
    "double-crank": {
        "en": "The frame {frame} is the shortest link: {crank} and {rocker} both turn fully.",
        "zh": "最短杆 {frame} 为机架，{crank} 与 {rocker} 都能整周转动，均为曲柄。",
    },
    "double-rocker": {
        "en": "The coupler {coupler} is the shortest link: it turns fully against both neighbours, {crank} and {rocker} only rock.",
        "zh": "最短杆 {coupler} 为连杆，相对两连架杆能整周转动；{crank} 与 {rocker} 只能摆动。",
    },
    "triple-rocker": {
        "en": "The sum of the shortest and the longest link is greater than that of the others: no link turns fully, whichever is fixed.",
        "zh": "最短杆与最长杆长度之和大于其余两杆之和，无论取哪一杆为机架，都没有能整周转动的构件。",
    },
    "change-point": {
        "en": "Both sums are equal: the links can all come to lie in one line, and from there go on in two ways (change point).",
        "zh": "两和相等：各杆可同时共线，此时从动件的运动不确定（变点），须借惯性或附加约束通过。",
    },
    "slider-crank": {
        "en": "{crank} + |e| is not more than {coupler}: the crank {crank} turns fully.",
        "zh": "{crank} + |e| 不大于 {coupler}，{crank} 能整周转动，为曲柄。",
    },
    "rocker-slider": {
        "en": "{crank} + |e| is more than {coupler}: the rod does not reach the guide everywhere, so {crank} only rocks.",
        "zh": "{crank} + |e| 大于 {coupler}，{crank} 不能整周转动，只能摆动。",
    },
    "oscillating guide bar": {
        "en": "{crank} + |e| is less than the frame {frame}: the crank turns fully, the bar {bar} only swings.",
        "zh": "{crank} + |e| 小于机架长 {frame}：曲柄能整周转动，导杆 {bar} 只能摆动。",
    },
    "rotating guide bar": {
        "en": "The crank {crank} is longer than {frame} + |e|: crank and bar {bar} both turn fully.",
        "zh": "{crank} 大于机架长 {frame} + |e|：曲柄与导杆 {bar} 都能整周转动。",
    },
    "rocking guide bar": {
        "en": "{crank} and {frame} differ by less than |e|: the bar stops the crank, and neither turns fully.",
        "zh": "{crank} 与 {frame} 之差小于 |e|：曲柄与导杆都不能整周转动。",
    },
}

HOW: dict[str, Both] = {
    "stretched": {"en": "{driver} and {middle} in line, stretched", "zh": "{driver} 与 {middle} 拉直共线"},
    "folded": {"en": "{driver} and {middle} in line, folded", "zh": "{driver} 与 {middle} 重叠共线"},
    "inner": {"en": "{driver} on the frame line, towards the other pivot", "zh": "{driver} 与机架共线（重叠）"},
    "outer": {"en": "{driver} on the frame line, away from the other pivot", "zh": "{driver} 与机架共线（拉直）"},
    "far": {"en": "{driver} at right angles to the guide, on the side away from it", "zh": "{driver} 垂直于导路（背离导路一侧）"},
    "near": {"en": "{driver} at right angles to the guide, towards it", "zh": "{driver} 垂直于导路（靠近导路一侧）"},
    "across": {"en": "crank at right angles to the bar", "zh": "曲柄与导杆垂直"},
    "square": {"en": "bar at right angles to the frame", "zh": "导杆与机架垂直"},
    "end": {"en": "end of the driver's own range", "zh": "原动件活动范围的端点"},
}

TEXT: dict[str, Both] = {
    "drives": {"en": "{driver} drives {output}", "zh": "{driver} 为原动件，{output} 为从动件"},
    "grashof": {
        "en": "Grashof: shortest + longest = {ends} = {first} {sign} {middle} = {second}",
        "zh": "杆长条件：最短杆 + 最长杆 = {ends} = {first} {sign} {middle} = {second}",
    },
    "lengths": {"en": "Lengths: {ends} = {first} {sign} {middle} = {second}", "zh": "长度关系：{ends} = {first} {sign} {middle} = {second}"},
    "full": {"en": "Full turn against each other: {pairs}", "zh": "能相对整周转动：{pairs}"},
    "rocks": {"en": "Rock against each other: {pairs}", "zh": "只能相对摆动：{pairs}"},
    "nothing": {"en": "none", "zh": "无"},
    "range": {"en": "{driver} goes from {low} to {high}", "zh": "{driver} 的活动范围：{low} 至 {high}"},
    "turns": {"en": "{driver} turns fully", "zh": "{driver} 作整周转动"},
    "limit": {"en": "limit {number}: {how}; {driver} at {value}, {output} at {place}", "zh": "极限位置 {number}：{how}；{driver} 在 {value}，{output} 在 {place}"},
    "and gamma": {"en": ", gamma {gamma}", "zh": "，γ = {gamma}"},
    "no limits": {"en": "{output} turns fully: no limits, no swing, no K", "zh": "{output} 作整周转动，没有极限位置、摆角和 K"},
    "swing": {"en": "swing of {output}: psi = {value}", "zh": "{output} 的摆角 ψ = {value}"},
    "stroke": {"en": "stroke of {output}: H = {value}", "zh": "{output} 的行程 H = {value}"},
    "theta": {"en": "between the crank positions: theta = {theta}, K = (180 + theta)/(180 - theta) = {k}", "zh": "极位夹角 θ = {theta}，行程速比系数 K = (180° + θ)/(180° − θ) = {k}"},
    "no quick return": {"en": "theta = 0, K = 1: no quick return", "zh": "θ = 0，K = 1：无急回特性"},
    "slow": {
        "en": "slow stroke: limit {one} to {other} while {driver} turns counter-clockwise (omega > 0), {other} to {one} while clockwise",
        "zh": "慢行程：{driver} 逆时针转动（ω > 0）时由极限位置 {one} 到 {other}；顺时针转动时由 {other} 到 {one}",
    },
    "no ratio": {"en": "no K: the driver does not turn fully", "zh": "无 K：原动件不作整周转动"},
    "undetermined": {"en": "no K: at the change points the output may go either way", "zh": "无 K：经过变点时从动件运动不确定"},
    "gamma": {"en": "transmission angle {gamma} with {how} ({driver} at {value})", "zh": "传动角 {gamma}：{how}（{driver} 在 {value}）"},
    "least": {"en": "least transmission angle gamma_min = {gamma}, largest pressure angle alpha_max = {alpha}, {driver} at {values}", "zh": "最小传动角 γmin = {gamma}，最大压力角 αmax = {alpha}，{driver} 在 {values}"},
    "level": {"en": "transmission angle 90 deg at every position: the block pushes the bar along its motion", "zh": "传动角恒为 90°：滑块对导杆的作用力始终与受力点速度同向"},
    "no gamma": {"en": "no transmission angle: the coupler itself is driven", "zh": "连杆为原动件，不讨论传动角"},
    "dead": {"en": "{driver} driving: dead points with {driver} at {values}", "zh": "{driver} 主动时：死点位置在 {driver} = {values}"},
    "no dead": {"en": "{driver} driving: no dead point, gamma never becomes 0", "zh": "{driver} 主动时：无死点（γ 不为 0）"},
    "advantage": {"en": "least mechanical advantage {value} with {driver} at {at}{endless}", "zh": "最小机械增益 {value}，{driver} 在 {at}{endless}"},
    "endless": {"en": "; without limit at the output's limits", "zh": "；在从动件极限位置趋于无穷大"},
    "equal": {"en": "equal lengths: {pairs}", "zh": "等长：{pairs}"},
    "assumed": {"en": "no driver reaches this linkage alone; {driver} is taken for the driver", "zh": "此机构没有单独的原动件，取 {driver} 为原动件"},
    "link": {"en": "{driver} is moved by other links; the figures hold for the linkage by itself", "zh": "{driver} 由其他构件带动；以上数值是就此机构本身而言"},
    "pair": {"en": "the file drives two moving links against each other; the figures take {driver} for the driver", "zh": "文件中的主动副在两个活动构件之间；以上数值以 {driver} 为原动件"},
    "behind": {"en": "{driver} is moved by the linkage before it; ranges, limits and K are those in the mechanism", "zh": "{driver} 由前一机构带动；活动范围、极限位置和 K 是在整个机构中的"},
    "links": {"en": "links {links}", "zh": "构件 {links}"},
}  # fmt: skip

TITLES: dict[str, Both] = {
    "fourbar": {"en": "Four-bar linkage", "zh": "铰链四杆机构"},
    "slider": {"en": "Slider-crank linkage", "zh": "曲柄滑块机构"},
    "guide": {"en": "Guide-bar linkage", "zh": "导杆机构"},
}
"""The title of a file of a linkage, by the word of its kind."""

FIXED: Both = {"en": "{title}, link {link} fixed", "zh": "{title}（以构件 {link} 为机架）"}

DRIVEN: dict[str, Both] = {
    "slide": {"en": "The slide {one} stays driven.", "zh": "移动副 {one} 仍为主动副。"},
    "frame": {"en": "The same pair is driven: links {one} and {two}.", "zh": "主动副不变：构件 {one} 与 {two}。"},
    "moving": {
        "en": "The same pair is driven, links {one} and {two}: the angle is counted from the moving link {two}.",
        "zh": "主动副不变（构件 {one} 与 {two}），转角相对于活动构件 {two} 度量。",
    },
}
"""What is said of a driver where another link is held: of a slide, of a link against the new frame, against another."""
