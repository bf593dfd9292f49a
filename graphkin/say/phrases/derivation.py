"""A derivation: what is given, the position, the two polygons."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # --- frame of the text
    "derivation.direction row": ("direction:", "方向："),
    "derivation.size row": ("magnitude:", "大小："),
    "derivation.given": ("Drivers: {drivers}.", "原动件：{drivers}。"),
    "derivation.scales": ("Scales: {scales}.", "取比例尺：{scales}。"),
    "derivation.too short": (" (too short to draw)", "（过短，图上画不出）"),
    "derivation.exactly": ("Lengths are those of an exact drawing; figures have four digits, and factors more where "
                           "their result needs it.",
                           "各长度按精确作图取值；数值取四位有效数字，必要时参与运算的数多取几位。"),
    "derivation.by hand": ("Every length that is not given is read off the drawing to 0.5 mm, every angle to 0.5°, "
                           "and used as it is read.",
                           "凡非已知的长度均由图上量取，读至 0.5 mm（角度读至 0.5°），并以量得的值继续计算。"),
    "derivation.numbers left out": ("Circled numbers are those of the drawing; steps that the questions do not need "
                                    "are left out here.",
                                    "圈号为图上的作图步骤号；求解本题不需要的步骤从略。"),
    "derivation.plane position": ("(1) The mechanism, drawn to scale", "(1) 作机构运动简图"),
    "derivation.plane velocity": ("({number}) Velocities", "({number}) 作速度分析"),
    "derivation.plane acceleration": ("({number}) Accelerations", "({number}) 作加速度分析"),
    # --- drivers
    "derivation.driven link": ("{line} of link {link} makes {angle} with +x", "构件 {link} 的 {line} 与 x 轴正向成 {angle}"),
    "derivation.driven joint": ("{line} of link {link} is turned by {angle} from {other} of link {seen_from}",
                                "构件 {link} 的 {line} 相对构件 {seen_from} 的 {other} 转过 {angle}"),
    "derivation.driven slide": ("slide {slide} is at {place}", "移动副 {slide} 的位移 {place}"),
    # --- places and lines
    "derivation.guide of": ("guide {name}", "{name} 导路"),
    "derivation.guide of link": ("the guide of link {link}", "构件 {link} 的导路"),
    "derivation.origin of": ("the start of guide {name}", "{name} 导路的起点"),
    # --- position
    "derivation.fixed points": ("Fixed points, in mm on paper: {points}.", "定出固定点（图上 mm）：{points}。"),
    "derivation.fixed guide": ("The line of {guide}: through {place} at {angle} to +x.",
                               "{guide}：过 {place}、与 x 轴正向成 {angle} 的直线。"),
    "derivation.lay off link": ("From {start} lay off {length} at {angle} to +x: {tip}.",
                                "由 {start} 沿与 x 轴正向成 {angle} 的方向取 {length}，得 {tip}。"),
    "derivation.lay off on line": ("From {start} lay off {length} on the line {line} (at {angle} to +x): {tip}.",
                                   "在直线 {line} 上由 {start} 取 {length}（与 x 轴正向成 {angle}），得 {tip}。"),
    "derivation.composed": ("from {parts} at their known angle", "由 {parts} 及其已知夹角作出"),
    "derivation.lay off slide": ("From {start} lay off {length} along {guide} (at {angle} to +x): {tip}.",
                                 "由 {start} 沿{guide}（与 x 轴正向成 {angle}）取 {length}，得 {tip}。"),
    "derivation.circle": ("draw the circle about {about} with radius {length}", "以 {about} 为圆心、{length} 为半径作弧"),
    "derivation.take guide": ("take {guide}", "取{guide}"),
    "derivation.line parallel": ("draw the line through {through} {direction}", "过 {through} 作{direction} 的直线"),
    "derivation.meet circles": ("{first}; {second}. They cross at {point}{where}.",
                                "{first}；{second}；两者交于 {point}{where}。"),
    "derivation.side above": ("{point} above {line}", "{point} 在 {line} 的上方"),
    "derivation.side below": ("{point} below {line}", "{point} 在 {line} 的下方"),
    "derivation.side left": ("{point} to the left of {line}", "{point} 在 {line} 的左侧"),
    "derivation.side right": ("{point} to the right of {line}", "{point} 在 {line} 的右侧"),
    "derivation.which above": ("the upper crossing", "取上方的交点"),
    "derivation.which below": ("the lower crossing", "取下方的交点"),
    "derivation.which left": ("the left crossing", "取左侧的交点"),
    "derivation.which right": ("the right crossing", "取右侧的交点"),
    "derivation.meet lines": ("{first}; {second}. They cross at {point}.", "{first}；{second}；两者交于 {point}。"),
    "derivation.swing join": ("Link {link} turns about {pivot} until its guide line, which runs through {pivot}, "
                              "passes through {through}: join {pivot} and {through}.",
                              "构件 {link} 的导路通过其回转中心 {pivot}，又须通过 {through}：连接 {pivot}、{through}，即得导路方向。"),
    "derivation.swing tangent": ("The guide line of link {link} keeps the distance {length} from {pivot} and passes "
                                 "through {through}: draw the circle about {pivot} with this radius, and from "
                                 "{through} the tangent that touches it at {foot} ({which}). It is the guide line.",
                                 "构件 {link} 的导路与 {pivot} 的距离恒为 {length}，且须通过 {through}：以 {pivot} 为圆心、以此距离为半径作圆，由 "
                                 "{through} 作该圆的切线，切点为 {foot}（{which}），该切线即为导路。"),
    "derivation.swing beside": ("{through} turns with link {link}, beside its guide line. The line through {through} "
                                "parallel to the guide line keeps the distance {length} from {pivot}, as the given "
                                "dimensions have it: draw the circle about {pivot} with this radius, and from "
                                "{through} the tangent that touches it at {foot} ({which}). The guide line is "
                                "parallel to it.",
                                "{through} 随构件 {link} 一同转动，但不在其导路上；过 {through} 且平行于导路的直线与 {pivot} 的距离由已知尺寸恒为 "
                                "{length}：以 {pivot} 为圆心、以此距离为半径作圆，由 {through} 作该圆的切线，切点为 {foot}（{which}），导路与该切线平行。"),
    "derivation.swing foot": ("The guide line of link {link} keeps the distance {length} from {pivot}, which is the "
                              "distance of {through} itself: it is at right angles to the join of {pivot} and "
                              "{through}, and {foot} falls on {through}.",
                              "构件 {link} 的导路与 {pivot} 的距离恒为 {length}，恰等于 {through} 到 {pivot} 的距离，故导路过 {through} 且垂直于 "
                              "{pivot}、{through} 的连线，切点 {foot} 与 {through} 重合。"),
    "derivation.on paper": (" (on paper {length})", "（图上 {length}）"),
    "derivation.on tangent": ("On this line {tip} lies at {length} from {start}, on the side of {foot} towards "
                              "{through}.",
                              "在该线上取 {tip}，距 {start} 为 {length}，位于 {foot} 的靠 {through} 一侧。"),
    "derivation.on tangent beyond": ("On this line {tip} lies at {length} from {start}, on the side of {foot} away "
                                     "from {through}.",
                                     "在该线上取 {tip}，距 {start} 为 {length}，位于 {foot} 的背离 {through} 一侧。"),
    "derivation.at the foot": ("{tip} is the foot of the perpendicular from {start}: {length}.",
                               "{tip} 即由 {start} 所作垂线的垂足：{length}。"),
    "derivation.lay off parallel": ("From {start} lay off {length} parallel to this line (at {angle} to +x): {tip}.",
                                    "由 {start} 作该线的平行线（与 x 轴正向成 {angle}），取 {length}，得 {tip}。"),
    "derivation.lay off turned": ("From {start} lay off {length} turned by {turned} {sense} from this line: {tip}.",
                                  "由 {start} 作与该线成 {turned}（由该线{sense}转过）的直线，取 {length}，得 {tip}。"),
    "derivation.over reach": ("{first}; {second}. They cross at {point} ({way}).",
                              "{first}；{second}；两者交于 {point}（{way}）。"),
    "derivation.shape corner": ("{point} on link {link}: {first} and {second} ({way}).",
                                "构件 {link} 上的 {point}：{first}，{second}（{way}）。"),
    "derivation.shape line": ("{point} on link {link} lies on the line {line}: {length}.",
                              "构件 {link} 上的 {point} 在直线 {line} 上：{length}。"),
    "derivation.measured angles": ("Measured: {angles}.", "量得：{angles}。"),
    "derivation.measured slide": ("Measured: {length}.", "量得：{length}。"),
    "derivation.measured used": ("Measured, as needed below: {lengths}.", "由图量得下文所用长度：{lengths}。"),
    "derivation.ruled": ("{paper}, so {real}", "{paper}，故 {real}"),
    "derivation.angle of": ("{name} = {angle} ({arrow})", "{name} = {angle}（{arrow}）"),
    # --- polygons: the start
    "derivation.pole last": ("Both sides start with an unknown vector, so the pole {pole} is found last; the fixed "
                             "points lie on it.",
                             "方程两边都以未知矢量开始，故极点 {pole} 最后确定；固定点与 {pole} 重合。"),
    "derivation.from anywhere": ("Take any point as {point} and lay off the known vector first.",
                                 "任取一点作为 {point}，先画出已知矢量。"),
    "derivation.pole": ("Take the pole {pole}.", "任取极点 {pole}。"),
    "derivation.pole fixed": ("Take the pole {pole}; the fixed point {points} is at rest, so {nodes} lies on {pole}.",
                              "任取极点 {pole}；固定点 {points} 不动，故 {nodes} 与 {pole} 重合。"),
    "derivation.pole fixed, several": ("Take the pole {pole}; the fixed points {points} are at rest, so {nodes} lie "
                                       "on {pole}.",
                                       "任取极点 {pole}；固定点 {points} 不动，故 {nodes} 与 {pole} 重合。"),
    "derivation.renamed pole": ("{letter} is a point of the mechanism here, so the pole is called {pole}.",
                                "本题中 {letter} 为机构上的点，故极点记为 {pole}。"),
    "derivation.renamed tips": ("{letter} is a point of the mechanism here, so the ends of {part} are called {tip}.",
                                "本题中 {letter} 为机构上的点，故{part}的终点记为 {tip}。"),
    "derivation.tips n": ("normal components", "法向分量"),
    "derivation.tips k": ("Coriolis components", "哥氏分量"),
    "derivation.held still": ("The driver of link {links} is at rest, so the link stands still: {fixed}.",
                              "构件 {links} 的原动件此时静止，故该构件不动：{fixed}。"),
    "derivation.held still, several": ("The drivers of links {links} are at rest, so these links stand still: {fixed}.",
                                       "构件 {links} 的原动件此时静止，故这些构件不动：{fixed}。"),
    "derivation.as fixed": ("{points} is like a fixed point, and its image lies on {pole}",
                            "{points} 相当于固定点，其影像与 {pole} 重合"),
    "derivation.as fixed, several": ("{points} are like fixed points, and their images lie on {pole}",
                                     "{points} 相当于固定点，其影像均与 {pole} 重合"),
    "derivation.never turn": ("Link {links} can only translate: {rates}, and all its points move alike.",
                              "构件 {links} 只能移动：{rates}，其上各点的速度、加速度均相同。"),
    "derivation.never turn, several": ("Links {links} can only translate: {rates}, and all points of such a link move "
                                       "alike.",
                                       "构件 {links} 只能移动：{rates}，同一构件上各点的速度、加速度均相同。"),
    # --- polygons: equations
    "derivation.points of link": ("{of} and {seen_from} are points of link {link}",
                                  "构件 {link} 上 {of}、{seen_from} 两点之间"),
    "derivation.coincident": ("{of} and {seen_from} are coincident points", "重合点 {of}、{seen_from} 之间"),
    "derivation.from relations, velocity": ("{relations}:", "由{relations}的速度关系，有"),
    "derivation.from relations, acceleration": ("{relations}:", "由{relations}的加速度关系，有"),
    "derivation.between relations": ("; ", "、"),
    "derivation.last relation": ("; ", "以及"),
    "derivation.plain equation": ("The {motion} of {of}:", "{of} 的{motion}："),
    "derivation.motion velocity": ("velocity", "速度"),
    "derivation.motion acceleration": ("acceleration", "加速度"),
    "derivation.only normal": ("{alpha} = 0, so {of} has only a normal acceleration relative to {seen_from}.",
                               "因 {alpha} = 0，{of} 相对 {seen_from} 只有法向加速度。"),
    "derivation.translates": ("Link {link} only translates: {of} = {seen_from}, so {node} falls on {base}.",
                              "构件 {link} 只作移动：{of} = {seen_from}，{node} 与 {base} 重合。"),
    # --- polygons: known sizes
    "derivation.sense of": ("{direction} in the sense of {rate}", "{direction}，指向与 {rate} 的转向一致"),
    "derivation.no turning": ("as {rate} = 0", "因 {rate} = 0"),
    "derivation.no sliding": ("as {relative} = 0", "因 {relative} = 0"),
    "derivation.path of the slot": ("The path of {point} is straight in link {link}, so the Coriolis term takes "
                                    "{rate}.",
                                    "{point} 相对构件 {link} 沿直线移动，故哥氏加速度取 {rate}。"),
    "derivation.chosen": ("The coincident point is taken at {point}, where {known} is known.",
                          "重合点取在 {point} 处，因该处 {known} 已知。"),
    "derivation.quarter turned": ("{relative} turned by 90° in the sense of {rate}: {direction}",
                                  "将 {relative} 沿 {rate} 的转向转过 90°：{direction}"),
    "derivation.slide grows": ("{direction}, in the direction of increasing {s}", "{direction}，指向 {s} 增大的方向"),
    "derivation.slide shrinks": ("{direction}, in the direction of decreasing {s}", "{direction}，指向 {s} 减小的方向"),
    "derivation.at angle": ("{direction}, at {angle} to +x", "{direction}，与 x 轴正向成 {angle}"),
    # --- polygons: the pencil
    "derivation.lay off": ("From {start} lay off {length}.", "由 {start} 作矢量 {length}。"),
    "derivation.lay off backwards": ("{name} has to end at {start}: lay it off backwards from there, {length}.",
                                     "{name} 的末端须在 {start}：由 {start} 逆向作 {length}。"),
    "derivation.lay off nothing": ("{name} = 0: {tip} falls on {start}.", "{name} = 0，{tip} 与 {start} 重合。"),
    "derivation.carried": ("{tip}: carry {name} = {drawn} parallel to itself to {start}; it ends at {tip}.",
                           "将 {name}（即 {drawn}）平移，使其起点在 {start}，其末端即为 {tip}。"),
    "derivation.meet rays": ("From {first} draw the line {first_direction}, from {second} the line "
                             "{second_direction}; they meet at {point}.",
                             "过 {first} 作 {first_direction} 的方向线，过 {second} 作 {second_direction} 的方向线，两线交于 {point}。"),
    "derivation.meet rays one point": ("The lines {first_direction} and {second_direction} both start from {first}, "
                                       "so {point} falls on {first}.",
                                       "{first_direction} 与 {second_direction} 两方向线均过 {first}，故 {point} 与 {first} 重合。"),
    "derivation.measured": ("Measured: {lengths}; hence", "由图量得 {lengths}，于是得"),
    "derivation.at direction": ("at {angle} to +x", "与 x 轴正向成 {angle}"),
    # --- polygons: rotation
    "derivation.sense rule": ("{sense}: {stretch}, carried to {head} in the mechanism, turns {head} about {tail} in "
                              "the sense of {rate}",
                              "{sense}：将 {stretch} 平移至机构图上的 {head} 点，其绕 {tail} 点的转向即为 {rate} 的方向"),
    "derivation.translation now": ("{name} = 0: at this instant link {link} is in translation.",
                                   "{name} = 0，此瞬时构件 {link} 作瞬时平动。"),
    "derivation.rest now": ("{name} = 0: at this instant link {link} is at rest.", "{name} = 0，此瞬时构件 {link} 静止。"),
    "derivation.held": ("Links {links} form a sliding pair, so they have no relative rotation:",
                        "构件 {links} 之间组成移动副，无相对转动："),
    "derivation.positive": ("positive: counter-clockwise", "正值，为逆时针"),
    "derivation.negative": ("negative: clockwise", "负值，为顺时针"),
    "derivation.tangential part": ("Resolve {ends} along and across {line}. The part across it is {tangential}.",
                                   "将 {ends} 沿 {line} 及其垂直方向分解，垂直分量为 {tangential}。"),
    # --- polygons: images
    "derivation.image velocity": ("Velocity image", "速度影像"),
    "derivation.image acceleration": ("Acceleration image", "加速度影像"),
    "derivation.image triangle": ("{image} of link {link}: {small} is similar to {large}, both lettered {sense}; this "
                                  "gives {point}.",
                                  "利用{image}：作 {small} ∽ {large}（构件 {link}），字母顺序同为{sense}，得 {point}。"),
    "derivation.image line": ("{image} of link {link}: {point} lies on the line {small} as {corner} lies on {large}: "
                              "{ratio}.",
                              "利用{image}：{corner} 在 {large} 线上（构件 {link}），故 {point} 在 {small} 线上：{ratio}。"),
    "derivation.image point": ("{image} of link {link}: {small} is a single point, so {point} falls on it too.",
                               "利用{image}：构件 {link} 的影像 {small} 缩为一点，故 {point} 也在该点。"),
    # --- polygons: slides
    "derivation.grows": ("So {stretch} increases at {size} m/s.", "即 {stretch} 以 {size} m/s 的速率增大。"),
    "derivation.shrinks": ("So {stretch} decreases at {size} m/s.", "即 {stretch} 以 {size} m/s 的速率减小。"),
    # --- given
    "derivation.driven wheel": ("wheel {link} turns", "轮 {link} 转动"),
    "derivation.driven roll": ("the rolling contact {slide} is at {place}", "滚动副 {slide} 的位移 {place}"),
    "derivation.driven slide free": ("slide {slide} is driven", "移动副 {slide} 为主动"),
    "derivation.driven roll free": ("the rolling contact {slide} is driven", "滚动副 {slide} 为主动"),
    "derivation.driven line free": ("link {link} ({line}) is driven", "构件 {link}（{line}）"),
    "derivation.posed": ("The drawn position: {poses}.", "给定位置：{poses}。"),
    "derivation.idle": ("Idle freedom: turning moves nothing but the roller itself, so these are drawn without "
                        "turning: {links}.",
                        "局部自由度：滚子的自转不影响其他构件的运动，作图时视为不转：{links}。"),
    "derivation.redundant": ("Redundant constraint, set aside: {line}.", "虚约束，求解时除去不计：{line}。"),
    "derivation.pose line": ("{line} of link {link} at {angle} to +x", "构件 {link} 的 {line} 与 x 轴正向成 {angle}"),
    "derivation.pose joint": ("{line} of link {link} turned by {angle} from {other} of link {seen_from}",
                              "构件 {link} 的 {line} 相对构件 {seen_from} 的 {other} 转过 {angle}"),
}
