"""Linkages of four links, the titles and notes of their files; a design: its stages, reasons, what it gives."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
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
    "linkages.how stretched": ("{driver} and {middle} in line, stretched", "{driver} 与 {middle} 拉直共线"),
    "linkages.how folded": ("{driver} and {middle} in line, folded", "{driver} 与 {middle} 重叠共线"),
    "linkages.how inner": ("{driver} on the frame line, towards the other pivot", "{driver} 与机架共线（重叠）"),
    "linkages.how outer": ("{driver} on the frame line, away from the other pivot", "{driver} 与机架共线（拉直）"),
    "linkages.how far": ("{driver} at right angles to the guide, on the side away from it", "{driver} 垂直于导路（背离导路一侧）"),
    "linkages.how near": ("{driver} at right angles to the guide, towards it", "{driver} 垂直于导路（靠近导路一侧）"),
    "linkages.how across": ("crank at right angles to the bar", "曲柄与导杆垂直"),
    "linkages.how square": ("bar at right angles to the frame", "导杆与机架垂直"),
    "linkages.how end": ("end of the driver's own range", "原动件活动范围的端点"),
    "linkages.drives": ("{driver} drives {output}", "{driver} 为原动件，{output} 为从动件"),
    "linkages.grashof": ("Grashof: shortest + longest = {ends} = {first} {sign} {middle} = {second}",
                         "杆长条件：最短杆 + 最长杆 = {ends} = {first} {sign} {middle} = {second}"),
    "linkages.lengths": ("Lengths: {ends} = {first} {sign} {middle} = {second}",
                         "长度关系：{ends} = {first} {sign} {middle} = {second}"),
    "linkages.pairs": ("[Full turn|Rock] relative to each other: {pairs}", "[能相对整周转动|只能相对摆动]：{pairs}"),
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
    # === a design: a sentence a stage, a reason, what was found
    "design.stage theta": ("Angle between the crank's limit positions: θ = 180°(K − 1)/(K + 1) = {of_K} = "
                           "{theta:deg}. Choose the scale.",
                           "求极位夹角：θ = 180°(K − 1)/(K + 1) = {of_K} = {theta:deg}，并确定比例尺 μ_l。"),
    "design.stage rocker limits": ("Draw the angle C1DC2 = ψ = {psi:deg} with C1D = C2D = {c:mm}: the rocker's two "
                                   "limit positions.",
                                   "作 ∠C1DC2 = ψ = {psi:deg}，C1D = C2D = {c:mm}，得摇杆的两个极限位置。"),
    "design.stage slider limits": ("Draw C1C2 = H = {H:mm} on the guide: the slider's two limit positions.",
                                   "在导路上作 C1C2 = H = {H:mm}，得滑块的两个极限位置。"),
    "design.stage corner": ("On C1C2 draw the angle C2C1P = 90° − θ = {rest:deg} and C2P at right angles to C1C2; "
                            "they meet at P.",
                            "以 C1C2 为底作 ∠C2C1P = 90° − θ = {rest:deg}，作 C2P ⊥ C1C2，两线交于 P 点。"),
    "design.stage corner beyond": ("On C1C2, away from D, draw the angle C2C1P = 90° − θ = {rest:deg} and C2P at "
                                   "right angles to C1C2; they meet at P. (The slow stroke is then the other one.)",
                                   "在 C1C2 的另一侧（背离 D）作 ∠C2C1P = 90° − θ = {rest:deg}，作 C2P ⊥ C1C2，两线交于 P "
                                   "点（此时慢行程方向相反）。"),
    "design.stage circle": ("Draw the circle through C1, C2 and P (centre O, the middle of C1P): from its points C1C2 "
                            "is seen under θ. [The lines at right angles to C1C2 in C1 and C2|The lines C1D and C2D] "
                            "meet it again at F and G. A is not on the dashed arcs: beyond F or G the assembly would "
                            "change.",
                            "作 △C1C2P 的外接圆（圆心 O 为 C1P 的中点）；圆上各点对 C1C2 的圆周角均为 θ。[过 C1、C2 作 C1C2 的垂线"
                            "|直线 C1D、C2D]，与圆另交于 F、G。A 点不在虚线弧上：越过 F、G 则装配方式改变。"),
    "design.stage circle beyond": ("Draw the circle through C1, C2 and P (centre O, the middle of C1P): from its "
                                   "points beyond C1C2 the chord is seen under θ. [The lines at right angles to C1C2 "
                                   "in C1 and C2|The lines C1D and C2D] meet it again at F and G. A is not on the "
                                   "dashed arcs: beyond F or G the assembly would change.",
                                   "作 △C1C2P 的外接圆（圆心 O 为 C1P 的中点）；C1C2 外侧圆弧上各点对 C1C2 的圆周角均为 θ。[过 C1、C2 作 "
                                   "C1C2 的垂线|直线 C1D、C2D]，与圆另交于 F、G。A 点不在虚线弧上：越过 F、G 则装配方式改变。"),
    "design.stage A by frame": ("With D as centre and the frame's length {frame:mm} as radius draw an arc; it meets "
                                "the circle at A, so that AD = {frame:mm}.",
                                "以 D 为圆心、机架长 {frame:mm} 为半径作弧，与该圆交于 A 点，使 AD = {frame:mm}。"),
    "design.stage A by offset": ("Draw a line parallel to C1C2 at the distance e = {offset:mm}; it meets the circle "
                                 "at A.",
                                 "作与 C1C2 平行、距离为偏距 e = {offset:mm} 的直线，与该圆交于 A 点。"),
    "design.stage A by AC1": ("With C1 as centre and AC1 = {ac1:mm} as radius draw an arc; it meets the circle at A.",
                              "以 C1 为圆心、AC1 = {ac1:mm} 为半径作弧，与该圆交于 A 点。"),
    "design.stage A by crank": (
        "N is the middle of the minor arc C1C2. The circle about N through C1 and the circle about C2 with radius 2a "
        "= {twice:mm} meet at E; C2E produced meets the circle again at A, for AE = AC1.",
        "取劣弧 C1C2 的中点 N。以 N 为圆心、过 C1 作圆，以 C2 为圆心、2a = {twice:mm} 为半径作弧，两者交于 E；延长 C2E 交外接圆于 A 点（AE = AC1）。"),
    "design.stage A by coupler": (
        "N is the middle of the major arc C1C2. The circle about N through C1 and the circle about C2 with radius 2b "
        "= {twice:mm} meet at E; C2E meets the circle at A, for AE = AC1.",
        "取优弧 C1C2 的中点 N。以 N 为圆心、过 C1 作圆，以 C2 为圆心、2b = {twice:mm} 为半径作弧，两者交于 E；C2E 交外接圆于 A 点（AE = AC1）。"),
    "design.stage A by gamma": ("Try points A along the circle until the least transmission angle is γ_min = "
                                "{gamma_min:deg} (found numerically; ruler and compass do not give it).",
                                "在圆上试取 A 点，直至最小传动角 γ_min = {gamma_min:deg}（用数值方法求得，尺规不能直接作出）。"),
    "design.stage A at best": ("A may be anywhere on the admissible arcs: take the point with the largest least "
                               "transmission angle (found numerically along the arcs).",
                               "A 点可在许用圆弧上任选：取最小传动角为最大的一点（沿圆弧用数值方法求得）。"),
    "design.stage rocker lengths": ("Measure AC1 = {AC1} mm, AC2 = {AC2} mm, AD = {d:mm}. Crank l_AB = |AC2 − AC1|/2 "
                                    "= {half_less} = {a:mm}, coupler l_BC = (AC1 + AC2)/2 = {half_more} = {b:mm}.",
                                    "量得 AC1 = {AC1} mm，AC2 = {AC2} mm，AD = {d:mm}。解得曲柄 l_AB = |AC2 − AC1|/2 = "
                                    "{half_less} = {a:mm}，连杆 l_BC = (AC1 + AC2)/2 = {half_more} = {b:mm}。"),
    "design.stage slider lengths": ("Measure AC1 = {AC1} mm, AC2 = {AC2} mm. Crank l_AB = |AC2 − AC1|/2 = {half_less} "
                                    "= {a:mm}, rod l_BC = (AC1 + AC2)/2 = {half_more} = {b:mm}.",
                                    "量得 AC1 = {AC1} mm，AC2 = {AC2} mm。解得曲柄 l_AB = |AC2 − AC1|/2 = {half_less} = "
                                    "{a:mm}，连杆 l_BC = (AC1 + AC2)/2 = {half_more} = {b:mm}。"),
    "design.stage theta swing": ("The bar's swing equals the angle between the crank's limit positions: ψ = θ = "
                                 "180°(K − 1)/(K + 1) = {of_K} = {theta:deg}.",
                                 "导杆的摆角等于极位夹角：ψ = θ = 180°(K − 1)/(K + 1) = {of_K} = {theta:deg}。"),
    "design.stage guide pivots": ("Lay off the frame AC = {frame:mm}.", "作机架 AC = {frame:mm}。"),
    "design.stage guide limits": ("Through C draw Cm and Cn at ψ/2 = {halved:deg} to both sides of CA: the bar's two "
                                  "limit positions.",
                                  "过 C 点在 CA 两侧各作夹角为 ψ/2 = {halved:deg} 的直线 Cm、Cn，得导杆的两个极限位置。"),
    "design.stage guide limits alone": ("From any point C draw the angle mCn = ψ = {theta:deg} and its bisector: the "
                                        "bar's two limit positions; A lies on the bisector.",
                                        "任取 C 点，作 ∠mCn = ψ = {theta:deg} 及其角平分线，得导杆的两个极限位置；A 点在角平分线上。"),
    "design.stage guide crank fits": ("A line parallel to Cm at the distance of the crank's length {crank:mm} meets "
                                      "the bisector at A.",
                                      "作与 Cm 平行、距离为曲柄长 {crank:mm} 的直线，与角平分线交于 A 点。"),
    "design.stage guide lengths": ("From A draw AB1 at right angles to Cm and AB2 to Cn. Measure the crank l_AB = AB1 "
                                   "= {a:mm} and the frame l_AC = {d:mm}.",
                                   "过 A 作 AB1 ⊥ Cm、AB2 ⊥ Cn。量得曲柄 l_AB = AB1 = {a:mm}，机架 l_AC = {d:mm}。"),
    "design.stage coupler laid": ("Draw the given positions of the coupler, B1C1, B2C2 and so on, of length {b1:mm}.",
                                  "作连杆的各给定位置 B1C1、B2C2 等，长 {b1:mm}。"),
    "design.stage centre": ("The perpendicular bisectors of [B1B2 and B2B3|C1C2 and C2C3] meet at [A|D].",
                            "作[ B1B2、B2B3 | C1C2、C2C3 ]的中垂线，交点为固定铰链中心[ A| D]。"),
    "design.stage given": ("On the perpendicular bisector of [B1B2|C1C2] take the given [A ({A_x:n}, {A_y:n})|D "
                           "({D_x:n}, {D_y:n})].",
                           "作[ B1B2 | C1C2 ]的中垂线，在其上取给定的[ A（{A_x:n}，{A_y:n}）| D（{D_x:n}，{D_y:n}）]。"),
    "design.stage chosen": ("[A|D] may be anywhere on the perpendicular bisector of [B1B2; ({A_x:n}, {A_y:n})|C1C2; "
                            "({D_x:n}, {D_y:n})] is chosen, for a good transmission angle.",
                            "[A 可在 B1B2|D 可在 C1C2] 的中垂线上任选；为使传动角较大，取"
                            "[ A（{A_x:n}，{A_y:n}）| D（{D_x:n}，{D_y:n}）]。"),
    "design.stage coupler lengths": ("Measure l_AB = AB1 = {a:mm}, l_BC = {b:mm}, l_CD = C1D = {c:mm}, l_AD = {d:mm}.",
                                     "量得 l_AB = AB1 = {a:mm}，l_BC = {b:mm}，l_CD = C1D = {c:mm}，l_AD = {d:mm}。"),
    "design.stage ratios": ("Freudenstein's equation cos(φ − ψ) = R1 cos ψ − R2 cos φ + R3 for the three pairs gives "
                            "R1 = {R1:n}, R2 = {R2:n}, R3 = {R3:n}; a = l_AB = d/R1 = {of_R1} = {a:mm}, c = l_CD = d/R2 = "
                            "{of_R2} = {c:mm}, with d = l_AD.",
                            "将三组对应角代入 cos(φ − ψ) = R1 cos ψ − R2 cos φ + R3，解得 R1 = {R1:n}，R2 = {R2:n}，R3 = {R3:n}；a "
                            "= l_AB = d/R1 = {of_R1} = {a:mm}，c = l_CD = d/R2 = {of_R2} = {c:mm}，其中 d = l_AD。"),
    "design.stage frame laid": ("Lay off the frame AD = {d:mm}.", "作机架 AD = {d:mm}。"),
    "design.stage angles laid": ("Lay off AB1, AB2, AB3 at φ = {phi1:deg}, {phi2:deg}, {phi3:deg} and DC1, DC2, DC3 "
                                 "at ψ = {psi1:deg}, {psi2:deg}, {psi3:deg} to AD.",
                                 "与 AD 成 φ = {phi1:deg}、{phi2:deg}、{phi3:deg} 作 AB1、AB2、AB3，成 ψ = "
                                 "{psi1:deg}、{psi2:deg}、{psi3:deg} 作 DC1、DC2、DC3。"),
    "design.stage angles coupler": ("Measure l_BC = B1C1 = {b:mm}; at the other positions it is {b2:mm} and {b3:mm}.",
                                    "量得 l_BC = B1C1 = {b:mm}；另两位置为 {b2:mm}、{b3:mm}。"),
    "design.stage crank laid": ("Lay off the crank AB = {a:mm} at φ = {phi1:deg}, {phi2:deg}, {phi3:deg} to AD.",
                                "与 AD 成 φ = {phi1:deg}、{phi2:deg}、{phi3:deg} 作曲柄 AB1、AB2、AB3，长 {a:mm}。"),
    "design.stage turned back": ("Inversion: turn B2 about D by ψ1 − ψ2 = {psi12:deg} to B2′, B3 by ψ1 − ψ3 = "
                                 "{psi13:deg} to B3′; the rocker then stands still at DC1.",
                                 "反转法：将 B2 绕 D 转 ψ1 − ψ2 = {psi12:deg} 至 B2′，将 B3 绕 D 转 ψ1 − ψ3 = {psi13:deg} 至 "
                                 "B3′，摇杆则相当于固定在 DC1 位置。"),
    "design.stage inverted centre": ("The perpendicular bisectors of B1B2′ and B2′B3′ meet at C1.",
                                     "作 B1B2′、B2′B3′ 的中垂线，交点为 C1。"),
    "design.stage inverted lengths": ("Measure l_BC = B1C1 = {b:mm}, l_CD = C1D = {c:mm}; DC1 makes an angle of "
                                      "{psi01:deg} with AD.",
                                      "量得 l_BC = B1C1 = {b:mm}，l_CD = C1D = {c:mm}；DC1 与 AD 成 {psi01:deg}。"),
    "design.reason minor": ("A lies on the minor arc C1C2: there the chord is seen under 180° − θ, not θ.",
                            "A 在劣弧 C1C2 上：该处圆周角为 180° − θ，而不是 θ。"),
    "design.reason FG": ("A lies on the arc FG: C1 and C2 belong to different assemblies, and the linkage cannot move "
                         "from one to the other.",
                         "A 在 FG 弧段上：C1、C2 分属两种装配位形，机构不能由一个极限位置连续运动到另一个（错位不连续）。"),
    "design.reason no crank": ("A is as far from C1 as from C2: the crank would have no length.",
                               "A 到 C1、C2 的距离相等：曲柄长度为零。"),
    "design.reason change point": ("The links come to lie in one line (a change point, γ_min = 0): the crank does not "
                                   "carry the linkage through.",
                                   "各杆可共线（变点机构，γ_min = 0），曲柄不能可靠地带动机构连续转动。"),
    "design.reason low gamma": ("γ_min = {gamma:deg} is below the usual 40°.", "γ_min = {gamma:deg}，小于一般要求的 40°。"),
    "design.reason range": ("The {name} must be between {low:mm} and {high:mm} for these values.",
                            "在所给条件下，{name}应在 {low:mm} 与 {high:mm} 之间。"),
    "design.reason range angle": ("The {name} can be at most {high:deg} for these values.",
                                  "在所给条件下，{name}最大为 {high:deg}。"),
    "design.reason no arc": ("No part of the circle is admissible. Change the swing or K.", "圆上没有许用弧段。请改变摆角或 K。"),
    "design.reason no links": ("A link has no length, or the links lie stretched in one line: this cannot move.",
                               "有构件长度为零，或各杆拉成一直线，机构不能运动。"),
    "design.reason kind": ("Kind: {kind}.", "类型：{kind}。"),
    "design.reason no Grashof": ("Shortest + longest is more than the other two (Grashof fails): no link turns fully.",
                                 "最短杆与最长杆之和大于其余两杆之和（不满足杆长条件），没有整转副。"),
    "design.reason passed ccw": ("All given positions lie on one branch, and AB takes them in order as it turns "
                                 "counter-clockwise.",
                                 "各给定位置在同一装配分支上，AB 逆时针转动时依次到达。"),
    "design.reason passed cw": ("All given positions lie on one branch, and AB takes them in order as it turns "
                                "clockwise.",
                                "各给定位置在同一装配分支上，AB 顺时针转动时依次到达。"),
    "design.reason crank rocks": ("AB does not turn fully.", "AB 不能整周转动。"),
    "design.reason drive at CD": ("Driven at DC instead, it passes all positions.", "若改以 DC 为原动件，则可依次通过各位置。"),
    "design.reason dead there": ("Position {position:d} is a dead point for the driver AB: BC and CD are in line.",
                                 "位置 {position:d} 是 AB 主动时的死点：BC 与 CD 共线。"),
    "design.reason branch": ("Branch defect: between positions {first:d} and {second:d} the assembly changes (BC and "
                             "CD would have to pass through a line).",
                             "错位不连续：位置 {first:d} 与 {second:d} 分属不同装配位形（BC 与 CD 须经过共线位置）。"),
    "design.reason circuit": ("Position {position:d} lies on another circuit: AB cannot turn there without taking the "
                              "linkage apart.",
                              "位置 {position:d} 属于另一运动区域：不拆开机构，AB 不能转到该位置（错位不连续）。"),
    "design.reason order": ("Order defect: AB does not turn one way through positions 1, 2, 3.",
                            "错序不连续：AB 单向转动时不能依次通过位置 1、2、3。"),
    "design.reason in line": ("{hinge}1, {hinge}2, {hinge}3 lie in one line: the centre {pivot} is at infinity. Guide "
                              "{hinge} by a slider, or take another hinge.",
                              "{hinge}1、{hinge}2、{hinge}3 共线：{pivot} 在无穷远处。请改用滑块引导 {hinge}，或另选铰链点。"),
    "design.reason no ratios": ("The three pairs do not determine R1, R2, R3. Change a pair, or give phi0, psi0.",
                                "三组角度不能唯一确定 R1、R2、R3。请改变其中一组，或给定 φ0、ψ0。"),
    "design.reason endless": ("A link would have to be endless (R1 or R2 is 0). Change a pair, or phi0, psi0.",
                              "有构件须为无穷长（R1 或 R2 为零）。请改变其中一组角度，或改变 φ0、ψ0。"),
    "design.reason no coupler": ("The coupler would have no real length. Change a pair, or phi0, psi0.",
                                 "连杆长度无实数解。请改变其中一组角度，或改变 φ0、ψ0。"),
    "design.reason turned": ("{link} comes out negative ({mm:n} mm): the link would point the opposite way, at its "
                             "angle + 180°.",
                             "{link} 为负值（{mm:n} mm）：该杆实际指向相反方向，即所给角度加 180°。"),
    "design.reason inverted in line": ("B1, B2′, B3′ lie in one line: C1 is at infinity. Change the crank's length, "
                                       "or a pair.",
                                       "B1、B2′、B3′ 共线：C1 在无穷远处。请改变曲柄长度或其中一组角度。"),
    "design.heading rocker": ("Crank-rocker from swing and K", "按行程速度变化系数 K 设计曲柄摇杆机构"),
    "design.heading slider": ("Slider-crank from stroke and K", "按行程速度变化系数 K 设计曲柄滑块机构"),
    "design.heading guide-bar": ("Oscillating guide bar from K", "按行程速度变化系数 K 设计摆动导杆机构"),
    "design.heading coupler": ("Four-bar through positions of its coupler", "按连杆给定位置设计铰链四杆机构"),
    "design.heading angles": ("Four-bar for three pairs of angles", "按两连架杆三组对应角位置设计铰链四杆机构"),
    "design.name frame": ("frame", "机架长"),
    "design.name crank": ("crank", "曲柄长"),
    "design.name coupler": ("coupler", "连杆长"),
    "design.name rod": ("rod", "连杆长"),
    "design.name offset": ("offset", "偏距"),
    "design.name ac1": ("distance AC1", "AC1"),
    "design.name gamma_min": ("least transmission angle", "最小传动角"),
    "design.name": ("condition", "附加条件"),
    "design.solution": ("Solution {number}: ", "解 {number}："),
    "design.useless": ("Linkage {number}, which does not do: ", "机构 {number}（不可用）："),
    "design.refused": ("Rejected: ", "舍去："),
    "design.invalid": ("This does not do: ", "此机构不可用："),
    "design.none": ("There is no solution.", "无解。"),
    "design.proof": ("Analysed back from its lengths: ", "由杆长分析验证："),
    "design.family": ("Admissible A on the circle of centre ({x:n}, {y:n}) mm, radius {radius:mm} ({axes}): {arcs}; "
                      "least transmission angle at most {best:deg}.",
                      "许用的 A 点在圆心 ({x:n}, {y:n}) mm、半径 {radius:mm} 的圆上（{axes}）：{arcs}；最小传动角最大可达 {best:deg}。"),
    "design.axes rocker": ("D is the origin, the y axis bisects ∠C1DC2", "以 D 为原点，y 轴为 ∠C1DC2 的平分线"),
    "design.axes slider": ("C1 is the origin, the x axis points to C2", "以 C1 为原点，x 轴由 C1 指向 C2"),
    "design.arcs": ("from {start:deg} to {end:deg}", "{start:deg} 至 {end:deg}"),
    "design.slow": ("slow stroke {moving}1 to {moving}2 with the crank {sense}",
                    "曲柄{sense}转动时 {moving}1 至 {moving}2 为慢行程"),
    "design.title rocker": ("Crank-rocker from its time ratio", "曲柄摇杆机构设计"),
    "design.title slider": ("Slider-crank from its time ratio", "曲柄滑块机构设计"),
    "design.title guide-bar": ("Oscillating guide bar from its time ratio", "摆动导杆机构设计"),
    "design.title coupler": ("Four-bar from coupler positions", "按连杆位置设计四杆机构"),
    "design.title angles": ("Four-bar from pairs of angles", "按对应角位置设计四杆机构"),
    "linkages.sheet limits": ("Limit positions of {output}", "{output} 的极限位置"),
    "linkages.sheet k": ("K = (180° + θ)/(180° − θ) = {k}", "K = (180° + θ)/(180° − θ) = {k}"),
    "linkages.sheet timed": ("K = {k} (crank {crank})", "K = {k}（曲柄 {crank}）"),
    "linkages.sheet one": ("θ = 0, K = 1: no quick return", "θ = 0，K = 1，无急回特性"),
    "linkages.sheet dead": ("dead points where {driver} drives: {letter}_{driver} = {values}[| (along the guide, from "
                            "{pivot})]",
                            "{driver} 主动时的死点：{letter}_{driver} = {values}[|（沿导路，自 {pivot} 量起）]"),
    "linkages.sheet none": ("no dead point where {driver} drives", "{driver} 主动时无死点"),
    "linkages.sheet gamma": ("Transmission angle, {driver} driving", "传动角（{driver} 主动）"),
    "linkages.sheet least": ("γ_min = {gamma}, α_max = {alpha}, at {letter}_{driver} = {values}",
                             "γ_min = {gamma}，α_max = {alpha}，此时 {letter}_{driver} = {values}"),
    "linkages.sheet family": ("Linkages of four links", "平面四杆机构的类型"),
    "design.sheet heading": ("Design by construction", "图解设计"),
    "design.sheet slow": ("The slow stroke is that from {moving}1 to {moving}2, with the crank {sense}.",
                          "曲柄{sense}转动时，{moving}1 至 {moving}2 为慢行程。"),
}
