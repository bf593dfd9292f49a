"""A derivation: higher pairs, rolling contacts, and groups solved together."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    "contacts.circles touch": (
        "Higher pair replaced by lower pairs, at this instant: the [circles about {first} and {second} touch, so the "
        "distance of their centres is|edge {second} lies on the circle about {first}, at the distance] {length}. A "
        "link {link} with hinges at {first} and {second}, along the line between them, stands for the contact; what "
        "bears the index {link} is its own, as ω_{link}.",
        "高副低代（瞬时）：[以 {first}、{second} 为圆心的两圆弧相切，中心距|尖顶 {second} 在以 {first} 为圆心的圆上，距离]为 {length}；"
        "故以两端铰接于 {first}、{second} 的构件 {link}（沿两点连线）代替该高副；下标为 {link} 者即属该构件，如 ω_{link}。"),
    "contacts.wheel on circle": ("Wheel {wheel} rolls on the circle about {first}: the distance of the centres is "
                                 "{length}. A link {link} with hinges at {first} and {second} holds them.",
                                 "轮 {wheel} 在以 {first} 为圆心的圆上滚动，中心距为 {length}；以两端铰接于 {first}、{second} 的构件 {link} "
                                 "保持此距离。"),
    "contacts.pin in arc": (
        "Higher pair replaced by lower pairs: pin {pin} moves in a circular slot of link {guide} about {centre}, at "
        "the distance {length}. A link {link} with hinges at {centre} and {pin} stands for the slot.",
        "高副低代：销 {pin} 在构件 {guide} 上以 {centre} 为圆心的圆弧槽中移动，距离为 {length}；故以两端铰接于 {centre}、{pin} 的构件 {link} 代替该高副。"),
    "contacts.flat touches": ("Higher pair replaced by lower pairs, at this instant: the circle about {centre} "
                              "touches the straight face{face} of link {link}. {centre} moves in a slot of link "
                              "{link}, parallel to the face at the distance {length}.",
                              "高副低代（瞬时）：以 {centre} 为圆心的圆与构件 {link} 的直线轮廓{face} 相切；故 {centre} 在构件 {link} "
                              "的槽中移动，槽平行于该直线，距离为 {length}。"),
    "contacts.edge touches": ("Higher pair replaced by lower pairs, at this instant: the edge {centre} lies on the "
                              "straight face{face} of link {link}, and moves in a slot of link {link} along it.",
                              "高副低代（瞬时）：尖顶 {centre} 在构件 {link} 的直线轮廓{face} 上，故 {centre} 在构件 {link} 沿该直线的槽中移动。"),
    "contacts.wheel on line": ("Wheel {wheel} rolls on the line{face} of link {link}: its centre {centre} moves "
                               "parallel to it, at the distance {length}.",
                               "轮 {wheel} 在构件 {link} 的直线{face} 上滚动：轮心 {centre} 沿其平行线移动，距离为 {length}。"),
    "contacts.wheel held at line": ("Wheel {wheel} rolls on the line{face} of link {link}: a sliding pair keeps its "
                                    "centre {centre} at the distance {length} from it.",
                                    "轮 {wheel} 在构件 {link} 的直线{face} 上滚动：移动副使轮心 {centre} 到该直线的距离保持为 {length}。"),
    "contacts.line of centres": ("Wheels {wheels} are in mesh: other links keep the distance of their centres, "
                                 "{length}. The line of centres turns as well; it is called {link}.",
                                 "轮 {wheels} 啮合，中心距 {length} 由其他构件保持。其连心线也在转动，记为 {link}。"),
    "contacts.path of": ("the path of {name}", "点 {name} 的轨迹线"),
    "contacts.foot": ("On {path}, {mark} is the foot of the perpendicular from {origin}: {length}.",
                      "由 {origin} 向{path}作垂线，垂足记为 {mark}，{length}。"),
    "contacts.marked start": ("{mark} is the start of {path}.", "{path}的起点记为 {mark}。"),
    "contacts.path start": ("the start of {path}", "{path} 的起点"),
    "contacts.track": ("track", "轨道"),
    "contacts.track of": ("track of {link}", "轮 {link} 的轨道"),
    "contacts.face": ("face", "直线轮廓"),
    "contacts.face of": ("face of {link}", "构件 {link} 的直线轮廓"),
    "contacts.fixed path": ("{path} starts at {place} and runs {heading}.", "{path}：过 {place}、{heading} 的直线。"),
    "contacts.rolled": ("Pure rolling of links {wheels} since the drawn position (Δθ: turned since then): {relation}.",
                        "自给定位置起，构件 {wheels} 作纯滚动（Δθ 为此后的转角）：{relation}。"),
    "contacts.with rotations": ("Together with {sums} this gives:", "与 {sums} 联立，得："),
    "contacts.turned by": ("Since the drawn position link {link} has turned by {name}:", "自给定位置起构件 {link} 转过 {name}："),
    "contacts.touch wheels": ("Wheels {first} and {second} touch at {point}, on the line {line}, {length} from "
                              "{centre}.",
                              "轮 {first}、{second} 的接触点 {point} 在连心线 {line} 上，距 {centre} 为 {length}。"),
    "contacts.touch inside": ("Wheels {first} and {second} touch at {point}, on the line {line} produced beyond {end}, "
                              "{length} from {centre}.",
                              "轮 {first}、{second} 的接触点 {point} 在连心线 {line} 过 {end} 的延长线上，距 {centre} 为 {length}。"),
    "contacts.touch line": ("Wheel {first} touches link {second} at {point}: {length} from {centre}, at right angles "
                            "to the track.",
                            "轮 {first} 与构件 {second} 的接触点 {point}：由 {centre} 作轨道的垂线，取 {length}。"),
    "contacts.gear image": ("{name} about {centre}", "{name}（圆心 {centre}）"),
    "contacts.gear at rest": ("The image {name} of the gear at rest is a point, {centre}.",
                              "静止齿轮的速度影像 {name} 为一点，与 {centre} 重合。"),
    "contacts.gear images": ("[The circle {circles} is the velocity image of the pitch circle|The circles {circles} "
                             "are the velocity images of the pitch circles].",
                             "圆 {circles} [为节圆|分别为各轮节圆]的速度影像。"),
    "contacts.same velocity": ("Pure rolling of links {first} and {second}: their points at the contact {point} have "
                               "one velocity, {of} = {other}. So {node} serves both.",
                               "构件 {first}、{second} 在 {point} 点作纯滚动，接触点速度相同：{of} = {other}，其速度影像点均为 {node}。"),
    "contacts.no velocity": ("Pure rolling of link {first} on link {second}, which is at rest: {of} = {other} = 0 at "
                             "the contact {point}, the instant centre of link {first}. Its image falls on {node}.",
                             "构件 {first} 在静止的构件 {second} 上作纯滚动，接触点 {point} 为构件 {first} 的绝对瞬心：{of} = {other} = "
                             "0，其影像点与 {node} 重合。"),
    "contacts.rolling relation": ("Pure rolling of links {wheels}: {relation}.", "由构件 {wheels} 的纯滚动，有 {relation}。"),
    "contacts.check relation": ("Check: {relation}; in figures {figures}.", "校核：{relation}；代入数值，{figures}。"),
    "contacts.contact points": ("{of} and {seen_from} are the contact points of pure rolling, whose accelerations "
                                "differ along the common normal only",
                                "纯滚动接触点 {of}、{seen_from}（两点加速度仅沿公法线方向不同）之间"),
    "contacts.fit": (
        "Links {links} form a group of Class {cls}. Ruler and compass do not give its position. On paper a template "
        "is tried: link {template} on tracing paper is shifted until {lengths} fit. Here the fit is found numerically:",
        "构件 {links} 组成{cls}级杆组，其位置不能用直尺和圆规直接作出。作图时用样板法：将构件 {template} 描在透明纸上试移，直至 {lengths} 均相符；此处用数值法求得："),
    "contacts.fit coupled": (
        "Links {links} are coupled {ties}. On paper a template finds their position: link {template} on tracing paper "
        "is shifted until {lengths} fit, and {relations}{note}. Here the fit is found numerically:",
        "构件 {links} 由{ties}互相约束。作图时用样板法求其位置：将构件 {template} 描在透明纸上试移，直至 {lengths} 均相符，且 {relations}{note}；此处用数值法求得："),
    "contacts.by joints": ("by their joints", "运动副"),
    "contacts.by rolling": ("by pure rolling", "纯滚动"),
    "contacts.by drivers": ("by driven angles", "给定的相对转角"),
    "contacts.since drawn": (" (Δθ: turned since the drawn position)", "（Δθ 为自给定位置起的转角）"),
    "contacts.fit train": ("The turns of links {links} since the drawn position (Δθ) are coupled; the rolling "
                           "relations {relations} are solved together:",
                           "构件 {links} 自给定位置起的转角 Δθ 互相关联，须联立求解纯滚动关系 {relations}："),
    "contacts.fit floating": ("The directions of links {links} follow from a closed figure alone, wherever it lies: "
                              "it is drawn apart with {lengths}, and turned until the known directions agree. Here it "
                              "is found numerically:",
                              "构件 {links} 的方位由自身封闭的图形单独确定，与其位置无关：另作此图形，使 {lengths}，并转至与已知方位相符；此处用数值法求得："),
    "contacts.lies on": ("{point} on {guide}", "{point} 在 {guide} 上"),
    "contacts.fitted": ("This gives {values}.", "得 {values}。"),
    "contacts.special point": ("Special point: {first} and {second} meet at {point}, taken as a point of link {link}.",
                               "特殊点：{first}与{second}交于 {point}，将 {point} 视为构件 {link} 上的点。"),
    "contacts.leg line": ("the line of leg {line}", "支路 {line} 所在直线"),
    "contacts.leg normal": ("the line through {through} at right angles to {guide}", "过 {through} 所作{guide} 的垂线"),
    "contacts.special": ("Special point {of} of link {link}, by way of {first} and of {second}. The two unknown "
                         "vectors of each leg lie on one line and are drawn as one:",
                         "取构件 {link} 上的特殊点 {of}，分别由 {first} 和 {second} 列方程；每一支路的两个未知矢量在同一方向线上，合为一个矢量作出："),
    "contacts.instant centre": ("Both legs are joined to the fixed link: {point} is the absolute instant centre of "
                                "link {link}, so {name} = 0, and {node} falls on {pole}. (Its acceleration is not 0.)",
                                "两支路均与机架相连，特殊点 {point} 即为构件 {link} 的绝对瞬心，故 {name} = 0，{node} 与 {pole} "
                                "重合（但其加速度一般不为零）。"),
    "contacts.about centre": ("Both legs are joined to the fixed link: {point} is the absolute instant centre of link "
                              "{link}, so {name} {direction}.",
                              "两支路均与机架相连，特殊点 {point} 即为构件 {link} 的绝对瞬心，故 {name} {direction}。"),
    "contacts.steady": ("Pure rolling: {relations} at all times, with {rates} constant; so {zero}.",
                        "纯滚动关系 {relations} 始终成立，其中 {rates} 为常量，故 {zero}。"),
    "contacts.constant ratio": ("The ratios of the train are constant, so the angular accelerations have those of the "
                                "angular velocities:",
                                "轮系的传动比为常数，故角加速度之比等于角速度之比："),
    "contacts.together": ("No order of ruler and triangle gives {unknowns} one after another. {equations} are solved "
                          "together:",
                          "{unknowns} 不能用作图法依次求得，须联立求解{equations}："),
    "contacts.together, coupled": ("{equations} are solved together, for {unknowns}:", "联立求解{equations}，得 {unknowns}："),
    "contacts.together, one": ("No order of ruler and triangle gives {unknowns} one after another. {equations} is "
                               "solved for them together:",
                               "{unknowns} 不能用作图法依次求得，须由{equations}联立求解："),
    "contacts.closed in themselves": ("The links are closed in themselves: {unknowns} do not depend on how any point "
                                      "of them moves. {equations} alone gives them:",
                                      "各构件自身封闭，{unknowns} 与其上任一点的运动无关，仅由{equations}即可求得："),
    "contacts.the loops": ("The vector [equation of the loop|equations of the loops] {loops}", "封闭矢量方程 {loops} "),
    "contacts.the relations": ("the pure rolling {relations}", "纯滚动关系 {relations}"),
    "contacts.the rotations": ("{sums}", "相对转动 {sums}"),
    "contacts.and both": (" and ", "及"),
}
