"""Linkages of four links, and the titles and notes of their files."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # --- kinds
    "linkages.kind crank-rocker": ("crank-rocker", "曲柄摇杆机构"),
    "linkages.kind rocker-crank": ("rocker-crank (a crank-rocker driven at the rocker)", "曲柄摇杆机构（摇杆主动）"),
    "linkages.kind double-crank": ("double-crank (drag link)", "双曲柄机构"),
    "linkages.kind double-rocker": ("double-rocker (the coupler is shortest)", "双摇杆机构（连杆最短，可整周转动）"),
    "linkages.kind triple-rocker": ("triple-rocker (non-Grashof)", "双摇杆机构（不满足杆长条件）"),
    "linkages.kind change-point": ("change-point linkage", "变点机构"),
    "linkages.kind slider-crank": ("slider-crank", "曲柄滑块机构"),
    "linkages.kind rocker-slider": ("rocker-slider", "摇杆滑块机构"),
    "linkages.kind oscillating guide bar": ("oscillating guide bar", "摆动导杆机构"),
    "linkages.kind rotating guide bar": ("rotating guide bar", "转动导杆机构"),
    "linkages.kind rocking guide bar": ("guide bar whose crank does not turn fully", "导杆机构（连架杆均不能整周转动）"),
    # where the block stands on the frame, and the bar slides in it
    "linkages.block oscillating guide bar": ("oscillating block", "曲柄摇块机构"),
    "linkages.block rotating guide bar": ("rotating block", "转动导块机构"),
    "linkages.block slider-crank": ("sliding guide bar in a fixed block", "移动导杆机构（定块机构）"),
    "linkages.block rocker-slider": ("sliding guide bar in a fixed block", "移动导杆机构（定块机构）"),
    "linkages.kind parallelogram": ("parallelogram", "平行四边形机构"),
    "linkages.kind antiparallelogram": ("antiparallelogram", "反平行四边形机构"),
    "linkages.kind rhombus": ("rhombus", "菱形机构"),
    "linkages.kind folded rhombus": ("folded rhombus", "折叠的菱形机构"),
    "linkages.kind kite": ("kite", "筝形机构"),
    "linkages.kind in-line": ("in-line", "对心"),
    "linkages.kind offset": ("offset", "偏置"),
    "linkages.kind isosceles": ("isosceles slider-crank", "等腰曲柄滑块机构"),
    "linkages.kind turning rod": ("the rod turns fully", "连杆可整周转动"),
    "linkages.kind no full turn": ("no link turns fully", "各构件均不能整周转动"),
    "linkages.kind block": ("oscillating block", "摇块"),
    # --- why it is of its kind
    "linkages.why crank-rocker": ("The shortest link {driver} lies next to the frame and drives: it turns fully, "
                                  "{output} rocks.",
                                  "最短杆 {driver} 是连架杆且为原动件，能整周转动，为曲柄；{output} 只能摆动，为摇杆。"),
    "linkages.why rocker-crank": ("The driven link {driver} rocks; {output}, the shortest link, turns fully. It needs "
                                  "help past two dead points.",
                                  "原动件 {driver} 为摇杆；最短杆 {output} 为曲柄，能整周转动。机构有两个死点位置，须借惯性等通过。"),
    "linkages.why double-crank": ("The frame {frame} is the shortest link: {crank} and {rocker} both turn fully.",
                                  "最短杆 {frame} 为机架，{crank} 与 {rocker} 都能整周转动，均为曲柄。"),
    "linkages.why double-rocker": ("The coupler {coupler} is the shortest link: it turns fully relative to both "
                                   "neighbours, {crank} and {rocker} only rock.",
                                   "最短杆 {coupler} 为连杆，相对两连架杆能整周转动；{crank} 与 {rocker} 只能摆动。"),
    "linkages.why triple-rocker": ("The sum of the shortest and the longest link is greater than that of the others: "
                                   "no link turns fully, whichever is fixed.",
                                   "最短杆与最长杆长度之和大于其余两杆之和，无论取哪一杆为机架，都没有能整周转动的构件。"),
    "linkages.why change-point": ("Both sums are equal: the links can all come to lie in one line, and from there go "
                                  "on in two ways (change point).",
                                  "两和相等：各杆可同时共线，此时从动件的运动不确定（变点），须借惯性或附加约束通过。"),
    "linkages.why slider-crank": ("{crank} + |e| is not more than {coupler}: the crank {crank} turns fully.",
                                  "{crank} + |e| 不大于 {coupler}，{crank} 能整周转动，为曲柄。"),
    "linkages.why rocker-slider": ("{reach}: the rod does not reach the guide everywhere, so {crank} only rocks.",
                                   "{reach}，故 {crank} 不能整周转动，只能摆动。"),
    "linkages.why oscillating guide bar": ("{crank} + |e| is less than the frame {frame}: the crank turns fully, the "
                                           "bar {bar} only swings.",
                                           "{crank} + |e| 小于机架长 {frame}：曲柄能整周转动，导杆 {bar} 只能摆动。"),
    "linkages.why rotating guide bar": ("The crank {crank} is longer than {frame} + |e|: crank and bar {bar} both "
                                        "turn fully.",
                                        "{crank} 大于机架长 {frame} + |e|：曲柄与导杆 {bar} 都能整周转动。"),
    "linkages.why rocking guide bar": ("{crank} and {frame} differ by less than |e|: the bar stops the crank, and "
                                       "neither turns fully.",
                                       "{crank} 与 {frame} 之差小于 |e|：曲柄与导杆都不能整周转动。"),
    # --- what is in line, or at right angles
    "linkages.how stretched": ("{driver} and {middle} in line, stretched", "{driver} 与 {middle} 拉直共线"),
    "linkages.how folded": ("{driver} and {middle} in line, folded", "{driver} 与 {middle} 重叠共线"),
    "linkages.how inner": ("{driver} on the frame line, towards the other pivot", "{driver} 与机架共线（重叠）"),
    "linkages.how outer": ("{driver} on the frame line, away from the other pivot", "{driver} 与机架共线（拉直）"),
    "linkages.how far": ("{driver} at right angles to the guide, on the side away from it", "{driver} 垂直于导路（背离导路一侧）"),
    "linkages.how near": ("{driver} at right angles to the guide, towards it", "{driver} 垂直于导路（靠近导路一侧）"),
    "linkages.how across": ("crank at right angles to the bar", "曲柄与导杆垂直"),
    "linkages.how square": ("bar at right angles to the frame", "导杆与机架垂直"),
    "linkages.how end": ("end of the driver's own range", "原动件活动范围的端点"),
    # --- what it does
    "linkages.drives": ("{driver} drives {output}", "{driver} 为原动件，{output} 为从动件"),
    "linkages.grashof": ("Grashof: shortest + longest = {ends} = {first} {sign} {middle} = {second}",
                         "杆长条件：最短杆 + 最长杆 = {ends} = {first} {sign} {middle} = {second}"),
    "linkages.lengths": ("Lengths: {ends} = {first} {sign} {middle} = {second}",
                         "长度关系：{ends} = {first} {sign} {middle} = {second}"),
    "linkages.full": ("Full turn relative to each other: {pairs}", "能相对整周转动：{pairs}"),
    "linkages.rocks": ("Rock relative to each other: {pairs}", "只能相对摆动：{pairs}"),
    "linkages.nothing": ("none", "无"),
    "linkages.range": ("{driver} goes from {low} to {high}", "{driver} 的活动范围：{low} 至 {high}"),
    "linkages.turns": ("{driver} turns fully", "{driver} 作整周转动"),
    "linkages.limit": ("limit {number}: {how}; {driver} at {value}, {output} at {place}",
                       "极限位置 {number}：{how}；{driver} 在 {value}，{output} 在 {place}"),
    "linkages.and gamma": (", γ = {gamma}", "，γ = {gamma}"),
    "linkages.no limits": ("{output} turns fully: no limits, no swing, no K", "{output} 作整周转动，没有极限位置、摆角和 K"),
    "linkages.swing": ("swing of {output}: ψ = {value}", "{output} 的摆角 ψ = {value}"),
    "linkages.stroke": ("stroke of {output}: H = {value}", "{output} 的行程 H = {value}"),
    "linkages.theta": ("angle between the crank's limit positions: θ = {theta}; time ratio K = (180° + θ)/(180° − θ) "
                       "= {k}",
                       "极位夹角 θ = {theta}；行程速度变化系数（行程速比系数）K = (180° + θ)/(180° − θ) = {k}"),
    "linkages.no quick return": ("θ = 0, K = 1: no quick return", "θ = 0，K = 1：无急回特性"),
    "linkages.slow": ("slow stroke: limit {one} to {other} while {driver} turns counter-clockwise (ω > 0), {other} to "
                      "{one} while clockwise",
                      "慢行程：{driver} 逆时针转动（ω > 0）时由极限位置 {one} 到 {other}；顺时针转动时由 {other} 到 {one}"),
    "linkages.no ratio": ("no K: the driver does not turn fully", "无 K：原动件不作整周转动"),
    "linkages.undetermined": ("no K: at the change points the output may go either way", "无 K：经过变点时从动件运动不确定"),
    "linkages.gamma": ("transmission angle, {how} ({driver} at {value}): {cosine}γ = {gamma}",
                       "传动角：{how}（{driver} 在 {value}）时，{cosine}γ = {gamma}"),
    "linkages.least": ("least transmission angle γ_min = {gamma}, greatest pressure angle α_max = 90° − γ_min = "
                       "{alpha}, {driver} at {values}",
                       "最小传动角 γ_min = {gamma}，最大压力角 α_max = 90° − γ_min = {alpha}，{driver} 在 {values}"),
    "linkages.level": ("transmission angle γ = 90° at every position: the block pushes the bar along its motion",
                       "传动角恒为 γ = 90°：滑块对导杆的作用力始终与受力点速度同向"),
    "linkages.no gamma": ("no transmission angle: the coupler itself is driven", "连杆为原动件，不讨论传动角"),
    "linkages.dead": ("{driver} driving: dead points with {driver} at {values}",
                      "{driver} 主动时：死点位置在 {driver} = {values}"),
    "linkages.dead along": ("the block driving along the bar ({driver}: its displacement): dead points with {driver} "
                            "= {values}",
                            "滑块沿导杆主动时（{driver} 为其位移）：死点位置在 {driver} = {values}"),
    "linkages.cosine": ("{cosine}, ", "{cosine}，"),
    "linkages.no dead": ("{driver} driving: no dead point, γ is then never 0", "{driver} 主动时：无死点（此时 γ 恒不为 0）"),
    "linkages.advantage": ("least mechanical advantage {value} with {driver} at {at}{endless}",
                           "最小机械增益 {value}，{driver} 在 {at}{endless}"),
    "linkages.endless": ("; without limit at the output's limits", "；在从动件极限位置趋于无穷大"),
    "linkages.equal": ("equal lengths: {pairs}", "等长：{pairs}"),
    "linkages.found assumed": ("no driver reaches this linkage alone; {driver} is taken for the driver",
                               "此机构没有单独的原动件，取 {driver} 为原动件"),
    "linkages.found link": ("{driver} is moved by other links; the figures hold for the linkage by itself",
                            "{driver} 由其他构件带动；以上数值是就此机构本身而言"),
    "linkages.found pair": ("the file drives one moving link relative to another; the figures take {driver} for the "
                            "driver",
                            "文件中的主动副在两个活动构件之间；以上数值以 {driver} 为原动件"),
    "linkages.found behind": ("{driver} is moved by the linkage before it; ranges, limits and K are those in the "
                              "mechanism",
                              "{driver} 由前一机构带动；活动范围、极限位置和 K 是在整个机构中的"),
    "linkages.links": ("links {links}", "构件 {links}"),
    "linkages.pin": ("pin {point}", "销 {point}"),
    "linkages.frame": ("frame", "机架"),
    # --- files
    "linkages.title fourbar": ("Four-bar linkage", "铰链四杆机构"),
    "linkages.title slider": ("Slider-crank linkage", "曲柄滑块机构"),
    "linkages.title guide": ("Guide-bar linkage", "导杆机构"),
    "linkages.fixed": ("{title}, link {link} fixed", "{title}（以构件 {link} 为机架）"),
    # a driver where another link is held: of a slide, against the new frame, against another link
    "linkages.driven slide": ("The slide {one} stays driven.", "移动副 {one} 仍为主动副。"),
    "linkages.driven frame": ("The same pair is driven: links {one} and {two}.", "主动副不变：构件 {one} 与 {two}。"),
    "linkages.driven moving": ("The same pair is driven, links {one} and {two}: the angle is counted from the moving "
                               "link {two}.",
                               "主动副不变（构件 {one} 与 {two}），转角相对于活动构件 {two} 度量。"),
}
