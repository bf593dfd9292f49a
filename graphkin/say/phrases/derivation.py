"""A derivation: what is given, the position, the two polygons."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    # --- frame of the text
    "direction row": ("direction:", "方向："),
    "size row": ("size:", "大小："),
    "given": ("Given: {drivers}. Link {frame} is the frame.", "已知：{drivers}。构件 {frame} 为机架。"),
    "scales": ("Scales: {scales}.", "取比例尺：{scales}。"),
    "too short": (" (too short to draw)", "（过短，图上画不出）"),
    "exactly": (
        "Lengths are those of an exact drawing; figures have four digits, and factors more where their result needs it.",
        "各长度按精确作图取值；数值取四位有效数字，必要时参与运算的数多取几位。",
    ),
    "by hand": (
        "Every length that is not given is read off the drawing to 0.5 mm, every angle to 0.5°, and used as it is read.",
        "凡非已知的长度均由图上量取，读至 0.5 mm（角度读至 0.5°），并以量得的值继续计算。",
    ),
    "plane position": ("(1) The mechanism, drawn to scale", "解：(1) 作机构运动简图"),
    "plane velocity": ("(2) Velocities", "(2) 作速度分析"),
    "plane acceleration": ("(3) Accelerations", "(3) 作加速度分析"),
    # --- drivers
    "driven link": ("{line} of link {link} stands at {angle} to +x", "原动件 {link} 的 {line} 与 x 轴正向成 {angle}"),
    "driven joint": (
        "{line} of link {link} stands at {angle} to {other} of link {seen_from}",
        "构件 {link} 的 {line} 相对构件 {seen_from} 的 {other} 转过 {angle}",
    ),
    "driven slide": ("slide {slide} is at {place}", "移动副 {slide} 的位移 {place}"),
    # --- places and lines
    "guide of": ("guide {name}", "导路 {name}"),
    "origin of": ("the start of guide {name}", "导路 {name} 的起点"),
    # --- position
    "fixed points": ("Fixed points, in mm on paper: {points}.", "定出固定点（图上 mm）：{points}。"),
    "fixed guide": (
        "The line of {guide}: through {place} at {angle} to +x.",
        "{guide}：过 {place}、与 x 轴正向成 {angle} 的直线。",
    ),
    "lay off link": (
        "From {start} lay off {length} at {angle} to +x: {tip}.",
        "由 {start} 沿与 x 轴正向成 {angle} 的方向取 {length}，得 {tip}。",
    ),
    "lay off slide": (
        "From {start} lay off {length} along {guide} ({angle}): {tip}.",
        "由 {start} 沿{guide}（{angle}）取 {length}，得 {tip}。",
    ),
    "circle": ("draw the circle about {about} with radius {length}", "以 {about} 为圆心、{length} 为半径作弧"),
    "take guide": ("take {guide}", "取{guide}"),
    "line parallel": ("draw the line through {through} {direction}", "过 {through} 作{direction} 的直线"),
    "meet circles": (
        "{first}; {second}. They cross at {point} (of the two crossings, the one on the side of the sketch).",
        "{first}；{second}；两者交于 {point}（两交点中取与给定装配位置一致者）。",
    ),
    "meet lines": ("{first}; {second}. They cross at {point}.", "{first}；{second}；两者交于 {point}。"),
    "swing join": (
        "Link {link} turns about {pivot} until its guide line, which runs through {pivot}, passes through {through}: join {pivot} and {through}.",
        "构件 {link} 的导路通过其回转中心 {pivot}，又须通过 {through}：连接 {pivot}、{through}，即得导路方向。",
    ),
    "swing tangent": (
        "Link {link} turns about {pivot} until its guide line passes through {through}. The line keeps the distance {length} from {pivot}: from {through} draw the tangent to the circle about {pivot} with this radius.",
        "构件 {link} 绕 {pivot} 转动，其导路须通过 {through}，且与 {pivot} 的距离恒为 {length}：以 {pivot} 为圆心、以此距离为半径作圆，由 {through} 作该圆的切线，即为导路。",
    ),
    "shape corner": (
        "{point} on link {link}: {first} and {second} ({triangle} in the link's own sense).",
        "构件 {link} 上的 {point}：{first}，{second}（{triangle} 的绕行方向与构件一致）。",
    ),
    "shape line": (
        "{point} on link {link} lies on the line {line}: {length}.",
        "构件 {link} 上的 {point} 在直线 {line} 上：{length}。",
    ),
    "measured angles": ("Measured: {angles}.", "量得：{angles}。"),
    "measured slide": ("Measured: {length}.", "量得：{length}。"),
    "angle of": ("{name} = {angle} ({arrow})", "{name} = {angle}（{arrow}）"),
    # --- polygons: the start
    "pole last": (
        "Both sides start with an unknown vector, so the pole {pole} is found last; the fixed points lie on it.",
        "方程两边都以未知矢量开始，故极点 {pole} 最后确定；固定点与 {pole} 重合。",
    ),
    "from anywhere": (
        "Take any point as {point} and lay the known vector off first.",
        "任取一点作为 {point}，先画出已知矢量。",
    ),
    "pole": ("Take the pole {pole}.", "任取极点 {pole}。"),
    "pole fixed": (
        "Take the pole {pole}; the fixed point {points} is at rest, so {nodes} lies on {pole}.",
        "任取极点 {pole}；固定点 {points} 不动，故 {nodes} 与 {pole} 重合。",
    ),
    "pole fixed, several": (
        "Take the pole {pole}; the fixed points {points} are at rest, so {nodes} lie on {pole}.",
        "任取极点 {pole}；固定点 {points} 不动，故 {nodes} 与 {pole} 重合。",
    ),
    "never turn": (
        "Link {links} can only translate: {rates}, and all its points move alike.",
        "构件 {links} 只能移动：{rates}，其上各点的速度、加速度均相同。",
    ),
    "never turn, several": (
        "Links {links} can only translate: {rates}, and all points of such a link move alike.",
        "构件 {links} 只能移动：{rates}，同一构件上各点的速度、加速度均相同。",
    ),
    # --- polygons: equations
    "points of link": ("{of} and {seen_from} are points of link {link}", "构件 {link} 上 {of}、{seen_from} 两点之间"),
    "coincident": ("{of} and {seen_from} are coincident points", "重合点 {of}、{seen_from} 之间"),
    "from relations, velocity": ("{relations}:", "由{relations}的速度关系，有"),
    "from relations, acceleration": ("{relations}:", "由{relations}的加速度关系，有"),
    "between relations": ("; ", "、"),
    "last relation": ("; ", "以及"),
    "plain equation": ("The {motion} of {of}:", "{of} 的{motion}："),
    "motion velocity": ("velocity", "速度"),
    "motion acceleration": ("acceleration", "加速度"),
    "only normal": (
        "{alpha} = 0, so {of} has only a normal acceleration against {seen_from}.",
        "因 {alpha} = 0，{of} 相对 {seen_from} 只有法向加速度。",
    ),
    "translates": (
        "Link {link} only translates: {of} = {seen_from}, so {node} falls on {base}.",
        "构件 {link} 只作移动：{of} = {seen_from}，{node} 与 {base} 重合。",
    ),
    # --- polygons: known sizes
    "sense of": ("{direction} in the sense of {rate}", "{direction}，指向与 {rate} 的转向一致"),
    "quarter turned": (
        "{relative} turned by 90° in the sense of {rate}: {direction}",
        "将 {relative} 沿 {rate} 的转向转过 90°：{direction}",
    ),
    "slide grows": ("{direction}, the way {s} grows", "{direction}，指向 {s} 增大的方向"),
    "slide shrinks": ("{direction}, the way {s} shrinks", "{direction}，指向 {s} 减小的方向"),
    "at angle": ("{direction}, at {angle}", "{direction}，与 x 轴正向成 {angle}"),
    # --- polygons: the pencil
    "lay off": ("From {start} lay off {length}.", "由 {start} 作矢量 {length}。"),
    "lay off backwards": (
        "{name} has to end at {start}: lay it off backwards from there, {length}.",
        "{name} 的末端须在 {start}：由 {start} 逆向作 {length}。",
    ),
    "lay off nothing": ("{name} = 0: {tip} falls on {start}.", "{name} = 0，{tip} 与 {start} 重合。"),
    "aside": (
        "{name} is known but stands between the unknown vectors. It is laid off out of place first, {way}: {length}, to the auxiliary point {tip}.",
        "{name} 已知，但处于两未知矢量之间，故先移位作出，{way}：{length}，得辅助点 {tip}。",
    ),
    "aside forward": ("from {start}", "由 {start} 顺其指向"),
    "aside backward": ("from {start} against its direction", "由 {start} 逆其指向"),
    "aside more": (
        "{name} likewise, {way}: {length}, to the auxiliary point {tip}.",
        "同样，{name} {way}：{length}，得辅助点 {tip}。",
    ),
    "carry back": (
        "Carry {name} back to its place: {length} from {start} gives {tip}.",
        "再将 {name} 移回原位：由 {start} 作 {length}，得 {tip}。",
    ),
    "carry back reversed": (
        "Carry {name} back to its place, ending at {start}: {length} gives {tip}.",
        "再将 {name} 移回原位，使其末端在 {start}：{length}，得 {tip}。",
    ),
    "meet rays": (
        "From {first} draw the line {first_direction}, from {second} the line {second_direction}; they meet at {point}.",
        "过 {first} 作 {first_direction} 的方向线，过 {second} 作 {second_direction} 的方向线，两线交于 {point}。",
    ),
    "meet rays one point": (
        "The lines {first_direction} and {second_direction} both start from {first}, so {point} falls on {first}.",
        "{first_direction} 与 {second_direction} 两方向线均过 {first}，故 {point} 与 {first} 重合。",
    ),
    "measured": ("Measured: {lengths}; hence", "由图量得 {lengths}，于是得"),
    "at direction": ("at {angle} to +x", "与 x 轴正向成 {angle}"),
    # --- polygons: rotation
    "sense rule": (
        "{sense}: {ends} carried to {head} turns link {link} so about {tail}",
        "{sense}：将 {ends} 平移至 {head} 点，即构件 {link} 绕 {tail} 点的转向",
    ),
    "translation now": (
        "{name} = 0: at this instant link {link} is in translation.",
        "{name} = 0，此瞬时构件 {link} 作瞬时平动。",
    ),
    "rest now": ("{name} = 0: at this instant link {link} is at rest.", "{name} = 0，此瞬时构件 {link} 静止。"),
    "held": (
        "Links {links} slide on each other and do not turn against each other:",
        "构件 {links} 之间组成移动副，无相对转动：",
    ),
    "positive": ("positive: counter-clockwise", "正值，为逆时针"),
    "negative": ("negative: clockwise", "负值，为顺时针"),
    "tangential part": (
        "Resolve {ends} along and across {line}. The part across it is {tangential}.",
        "将 {ends} 沿 {line} 及其垂直方向分解，垂直分量为 {tangential}。",
    ),
    # --- polygons: images
    "image velocity": ("Velocity image", "速度影像"),
    "image acceleration": ("Acceleration image", "加速度影像"),
    "image triangle": (
        "{image} of link {link}: {small} is similar to {large}, lettered in the same sense; this gives {point}.",
        "利用{image}：作 {small} ∽ {large}（构件 {link}），且角标字母顺序方向一致，得 {point}。",
    ),
    "image line": (
        "{image} of link {link}: {point} lies on the line {small} as {corner} lies on {large}: {ratio}.",
        "利用{image}：{corner} 在 {large} 线上（构件 {link}），故 {point} 在 {small} 线上：{ratio}。",
    ),
    "image point": (
        "{image} of link {link}: {small} is a single point, so {point} falls on it too.",
        "利用{image}：构件 {link} 的影像 {small} 缩为一点，故 {point} 也在该点。",
    ),
    # --- polygons: slides
    "grows": ("So {stretch} grows at {size} m/s.", "即 {stretch} 以 {size} m/s 的速率增大。"),
    "shrinks": ("So {stretch} shrinks at {size} m/s.", "即 {stretch} 以 {size} m/s 的速率减小。"),
    # --- given
    "driven wheel": ("wheel {link} turns", "轮 {link} 转动"),
    "driven roll": ("the rolling contact {slide} is at {place}", "滚动副 {slide} 的位移 {place}"),
    "driven slide free": ("slide {slide} is driven", "移动副 {slide} 为主动"),
    "driven roll free": ("the rolling contact {slide} is driven", "滚动副 {slide} 为主动"),
    "driven line free": ("link {link} ({line}) is driven", "原动件 {link}（{line}）"),
    "posed": ("The drawn position: {poses}.", "给定位置：{poses}。"),
    "idle": (
        "Idle freedom: turning moves nothing but the roller itself, so these are drawn without turning: {links}.",
        "局部自由度：滚子的自转不影响其他构件的运动，作图时视为不转：{links}。",
    ),
    "redundant": ("Redundant constraint, set aside: {line}.", "虚约束，求解时除去不计：{line}。"),
    "pose line": ("{line} of link {link} at {angle} to +x", "构件 {link} 的 {line} 与 x 轴正向成 {angle}"),
    "pose joint": (
        "{line} of link {link} at {angle} to {other} of link {seen_from}",
        "构件 {link} 的 {line} 与构件 {seen_from} 的 {other} 成 {angle}",
    ),
}
