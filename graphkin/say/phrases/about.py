"""A link about its pole, Bobillier's construction, and the pole of two velocities."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "pole title": ("Pole of a body from two velocities", "由两点速度求瞬心"),
    "curves": ("Curves of {centre}, in pieces: {count}", "{centre} 的曲线，共 {count} 段"),
    "piece closed": ("closed, {places} places", "闭合，{places} 个位置"),
    "piece open": ("open, {places} places", "不闭合，{places} 个位置"),
    "reach": ("in the axes of link {link}: x {x}, y {y}", "在构件 {link} 的坐标系中：x {x}，y {y}"),
    "rolling": (
        "The moving centrode (dashed) rolls without slipping on the other; they touch at {centre} {place}.",
        "动瞬心线（虚线）在另一条瞬心线上作纯滚动；此刻两线相切于 {centre} {place}。",
    ),
    "hinge": (
        "{centre} {place} stays at one point of both links: the centrodes are points.",
        "{centre} {place} 始终为两构件上的同一点：瞬心线退化为点。",
    ),
    "centre now": ("At this position {centre} lies at {place}.", "此位置 {centre} 在 {place}。"),
    "where curves": ("Drawn with -o OUT.svg; all places with --json.", "用 -o OUT.svg 画出；用 --json 给出全部位置。"),
    "assumed": (
        "No driver moves: each is taken to move at 1 rad/s (1 m/s).",
        "原动件均未给定速度：各按 1 rad/s（1 m/s）计算。",
    ),
    "pole": (
        "Link {link} turns about its instant centre P {place} with {omega}, {alpha}.",
        "构件 {link} 绕瞬心 P {place} 转动，{omega}，{alpha}。",
    ),
    "translation": (
        "Link {link} is in translation: P lies at infinity in the direction {at:read}°, ω = 0, {alpha}.",
        "构件 {link} 作瞬时平动：瞬心 P 在方向 {at:read}° 的无穷远处，ω = 0，{alpha}。",
    ),
    "rest": ("Link {link} stands still at this instant.", "构件 {link} 此刻静止。"),
    "acceleration": (
        "Acceleration pole J {place}: the acceleration of this point of the link is 0.",
        "加速度瞬心 J {place}：构件上该点的加速度为零。",
    ),
    "no acceleration": (
        "There is no acceleration pole: ω = α = 0, all points have one acceleration.",
        "没有加速度瞬心：ω = α = 0，各点加速度相同。",
    ),
    "pivot": (
        "P is a fixed point: every point moves on a circle about it, there is no inflection circle.",
        "P 为固定点：各点均绕其作圆周运动，没有拐点圆。",
    ),
    "moving pole": (
        "The pole moves along the centrodes with u = {u:read} m/s; the pole tangent makes an angle of {tangent:read}° with +x.",
        "瞬心沿瞬心线移动的速度 u = {u:read} m/s；极切线与 x 轴正向成 {tangent:read}°。",
    ),
    "inflection": (
        "Inflection circle: through P, diameter |u/ω| = {diameter:read} mm along the pole normal; centre {place}. The paths of its points are straight at this instant.",
        "拐点圆：过 P，直径 |u/ω| = {diameter:read} mm，沿极法线；圆心 {place}。圆上各点的轨迹此刻曲率为零。",
    ),
    "return": (
        "Cuspidal circle: its mirror image in the pole tangent, centre {place}.",
        "尖点圆：拐点圆对极切线的镜像，圆心 {place}。",
    ),
    "inflection line": (
        "The inflection circle has become a line through {place}, at an angle of {at:read}° with +x.",
        "拐点圆退化为直线：过 {place}，与 x 轴正向成 {at:read}°。",
    ),
    "curved": (
        "{name}: v = {v:read} m/s, a = {a:read} m/s²; radius of curvature {radius:read} mm, centre of curvature {place}.",
        "{name}：v = {v:read} m/s，a = {a:read} m/s²；轨迹曲率半径 {radius:read} mm，曲率中心 {place}。",
    ),
    "straight": (
        "{name}: v = {v:read} m/s, a = {a:read} m/s²; its path is straight at this instant.",
        "{name}：v = {v:read} m/s，a = {a:read} m/s²；轨迹此刻曲率为零（曲率中心在无穷远处）。",
    ),
    "cusp": (
        "{name} lies at the pole: v = 0, a = {a:read} m/s²; its path has a cusp.",
        "{name} 位于瞬心：v = 0，a = {a:read} m/s²；轨迹在此为尖点。",
    ),
    "still": ("{name} stands still.", "{name} 静止不动。"),
    # --- Bobillier's construction
    "bobillier pivoted": (
        "{point} moves about {centre}: {centre} is the centre of curvature of its path, and the ray {point}{centre} passes the pole.",
        "点 {point} 绕 {centre} 运动：{centre} 为其轨迹的曲率中心，射线 {point}{centre} 过瞬心。",
    ),
    "bobillier guided": (
        "{point} moves on a straight line: its centre of curvature {centre} lies at infinity, and its ray is the perpendicular to the path in {point}.",
        "点 {point} 沿直线运动：其曲率中心 {centre} 在无穷远处，射线为过 {point} 的轨迹垂线。",
    ),
    "bobillier measured": (
        "{point}: the centre of curvature {centre} of its path is known from v and a (ρ = v²/aⁿ).",
        "点 {point}：由 v、a 求得其轨迹的曲率中心 {centre}（ρ = v²/aⁿ）。",
    ),
    "bobillier P": ("The two rays meet at the pole {p}.", "两射线的交点为瞬心 {p}。"),
    "bobillier Q": ("The lines {a}{b} and {a0}{b0} meet at {q}.", "直线 {a}{b} 与 {a0}{b0} 的交点为 {q}。"),
    "bobillier Q far": (
        "The lines {a}{b} and {a0}{b0} are parallel: {q} lies at infinity.",
        "直线 {a}{b} 与 {a0}{b0} 平行：{q} 在无穷远处。",
    ),
    "bobillier Q line": (
        "{a0} and {b0} both lie at infinity; so does {q}, in the direction of {a}{b}.",
        "{a0}、{b0} 都在无穷远处，故 {q} 也在 {a}{b} 方向的无穷远处。",
    ),
    "bobillier axis": ("{p}{q} is the collineation axis of {a} and {b}.", "{p}{q} 为点 {a}、{b} 的共线轴。"),
    "bobillier ray c": ("Draw the ray {p}{c}.", "作射线 {p}{c}。"),
    "bobillier axis c": (
        "Carry the angle from the ray of {b} to {p}{c} over to {p}{q}, with its sense: this is the collineation axis of {a} and {c}.",
        "将 {b} 的射线到 {p}{c} 的转角（连同转向）移到 {p}{q} 上，得点 {a}、{c} 的共线轴。",
    ),
    "bobillier Qc": ("It meets the line {a}{c} at {qc}.", "它与直线 {a}{c} 的交点为 {qc}。"),
    "bobillier K": (
        "The line {a0}–{qc} meets the ray {p}{c} at {k}, the centre of curvature of the path of {c}.",
        "直线 {a0}–{qc} 与射线 {p}{c} 的交点 {k} 即为点 {c} 轨迹的曲率中心。",
    ),
    "bobillier K far": (
        "The line {a0}–{qc} is parallel to the ray {p}{c}: the path of {c} is straight at this instant.",
        "直线 {a0}–{qc} 与射线 {p}{c} 平行：点 {c} 的轨迹此刻曲率为零。",
    ),
    # --- two velocities
    "two rigid": (
        "Along {a}{b} both velocities have the component {component:read} m/s: the points can belong to one rigid body.",
        "两点速度在 {a}{b} 连线上的投影相等，均为 {component:read} m/s，符合速度投影定理，属同一刚体。",
    ),
    "two meet": (
        "The velocities are not parallel. The line through {a} across v_{a} and the line through {b} across v_{b} meet at the instant centre P ({x:read}, {y:read}) mm.",
        "两速度不平行：过 {a} 作 v_{a} 的垂线，过 {b} 作 v_{b} 的垂线，两垂线的交点即为瞬心 P ({x:read}, {y:read}) mm。",
    ),
    "two infinity": (
        "The velocities are parallel and equal. The perpendiculars are parallel: the instant centre lies at infinity, in the direction {at:read}°; ω = 0, the body is in translation at this instant.",
        "两速度平行且相等：两垂线互相平行，瞬心在无穷远处（方向 {at:read}°），ω = 0，刚体作瞬时平动。",
    ),
    "two similar": (
        "The velocities are parallel, across {a}{b}, and unequal. By similar triangles the line through the tips of the two velocity arrows meets the line {a}{b} at the instant centre P ({x:read}, {y:read}) mm.",
        "两速度平行（均垂直于 {a}{b}）但不相等：由相似三角形，两速度矢端的连线与 {a}{b} 连线的交点即为瞬心 P ({x:read}, {y:read}) mm。",
    ),
    "two point": (
        "The velocity of {still} is 0: {still} itself is the instant centre P ({x:read}, {y:read}) mm.",
        "点 {still} 的速度为零，{still} 即为瞬心 P ({x:read}, {y:read}) mm。",
    ),
    "two rest": (
        "Both velocities are 0: the body stands still at this instant, and no instant centre is seen.",
        "两点速度均为零：刚体此刻静止，看不出瞬心。",
    ),
    "two omega": (
        "{omega}, {sense}.",
        "{omega}（{sense}）。",
    ),
}
