"""Instant centres: how each is found, what they give, and their table."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "finding": ("({number}) Instant centres", "({number}) 求瞬心"),
    "count": (
        "The mechanism has N = {n} links, the frame included: K = N(N−1)/2 = {n}×{less}/2 = {count} instant centres.",
        "机构共有 N = {n} 个构件（含机架），瞬心总数 K = N(N−1)/2 = {n}×{less}/2 = {count}。",
    ),
    "definition": ("By definition, of links that are joined directly:", "由瞬心定义直接确定的瞬心："),
    "kennedy": (
        "By the theorem of three centres (Kennedy and Aronhold):",
        "不直接相连的构件，由三心定理确定其瞬心：",
    ),
    # --- by definition
    "found hinge": (
        "{name}: in hinge {point}, which joins links {first} and {second}; {place}.",
        "{name}：构件 {first}、{second} 以转动副 {point} 相连，瞬心在 {point}，{place}。",
    ),
    "found contact": (
        "{name}: links {first} and {second} roll on each other without sliding: where they touch, {place}.",
        "{name}：构件 {first}、{second} 作纯滚动，瞬心在接触点，{place}。",
    ),
    "found slide": (
        "{name}: links {first} and {second} slide on each other: at infinity, at right angles to the guide ({angle}).",
        "{name}：构件 {first}、{second} 组成移动副，瞬心在垂直于导路方向（{angle}）的无穷远处。",
    ),
    # --- Kennedy's lines
    "found two lines": (
        "{name} lies on {first} and on {second}: {met}.",
        "{name} 在{first}上，又在{second}上：{met}。",
    ),
    "join": ("{line} (links {links})", " {line} 连线（构件 {links}）"),
    "across guide": (
        "the line through {near} at right angles to the guide, towards {far} → ∞ (links {links})",
        "过 {near} 且垂直于导路的直线（指向 {far} → ∞，构件 {links}）",
    ),
    "parallel": (
        "the line through {near} parallel to the direction of {far} → ∞ at {angle} (links {links})",
        "过 {near} 且平行于 {far} → ∞ 方向（{angle}）的直线（构件 {links}）",
    ),
    "at infinity": (
        "the line at infinity, as {first} and {second} do (links {links})",
        "无穷远直线（{first}、{second} 均在无穷远，构件 {links}）",
    ),
    "normal of contact": (
        "the common normal n–n at the contact of links {first} and {second}",
        "构件 {first}、{second} 接触点处的公法线（n–n）",
    ),
    "normal of slot": (
        "the normal of the slot through {point} (where links {first} and {second} touch)",
        "构件 {first}、{second} 接触处 {point} 的槽的法线",
    ),
    "normal of circular slot": (
        "the normal n–n of the circular slot through its centre {point} (where links {first} and {second} touch)",
        "构件 {first}、{second} 接触处圆弧槽的公法线 n–n（过槽的圆心 {point}）",
    ),
    "met": ("where the two lines meet, {place}", "两线交点，{place}"),
    "met far": ("the lines are parallel, so {name} → ∞ at {angle}", "两线平行，故 {name} → ∞，方向 {angle}"),
    "met infinity": ("so {name} → ∞ at {angle}", "故 {name} → ∞，方向 {angle}"),
    # --- from velocities
    "found velocities": (
        "{name} cannot be found by three-centre lines alone: {reason}. From velocities: where links {first} and {second} have one velocity, {place}.",
        "{name} 仅用三心定理不能确定：{reason}。由速度求得：构件 {first}、{second} 在该点速度相同，{place}。",
    ),
    "several freedoms": (
        "the mechanism has {count} degrees of freedom, and the centre depends on how the drivers move",
        "机构有 {count} 个自由度，该瞬心与各原动件运动的比例有关",
    ),
    "lines coincide": ("no two lines through it that differ are known", "已知的过该点的直线重合或不足两条"),
    "together": (
        "{name}: links {first} and {second} have no relative motion at this instant, and no centre.",
        "{name}：构件 {first}、{second} 此瞬时无相对运动，不存在瞬心。",
    ),
    "mm": ("at ({x}, {y}) mm", "坐标（{x}，{y}）mm"),
    "infinite": ("at infinity, in the direction {angle}", "在方向 {angle} 的无穷远处"),
    # --- what they are used for
    "using": ("(2) Velocities from the centres", "(2) 用瞬心作速度分析"),
    "scale": (
        "Lengths are measured on paper in mm; {scale} = {value} m/mm.",
        "长度在图上量取（mm），取 {scale} = {value} m/mm。",
    ),
    "given": ("Given: {what}.", "已知：{what}。"),
    "resting": ("No driver moves: nothing has a velocity.", "各原动件均静止，速度为零。"),
    "no accelerations": (
        "Accelerations ({names}) cannot be found from instant centres.",
        "瞬心法不能用于加速度分析（{names}）。",
    ),
    "not told": ("{name}: the centres give no lever for it at this position.", "{name}：此位置不能直接由瞬心求出。"),
    "sense outside": (
        "{sense}; {centre} lies outside {ends}: same sense",
        "{sense}，{centre} 在 {ends} 之外，转向相同",
    ),
    "sense between": (
        "{sense}; {centre} lies between {ends}: opposite sense",
        "{sense}，{centre} 在 {ends} 之间，转向相反",
    ),
    "sense alike": ("{sense}; {centre} → ∞, the links turn alike", "{sense}，{centre} → ∞，两构件角速度相同"),
    "across": ("at right angles to {arm}, at {angle}", "⊥{arm}，方向 {angle}"),
    "along": ("the link moves without turning, at {angle}", "构件作平动，方向 {angle}"),
    "at": ("at {angle}", "方向 {angle}"),
    "same": ("same sense", "转向相同"),
    "opposite": ("opposite sense", "转向相反"),
    "triangle": ("from both velocities and their angle", "由两速度及其夹角"),
    # --- the table
    "by hinge": ("hinge", "转动副"),
    "by contact": ("rolling contact", "纯滚动接触点"),
    "by slide": ("sliding pair", "移动副"),
    "by velocities": ("velocities", "由速度求得"),
    "by normal": ("common normal", "公法线"),
    "by together": ("no relative motion", "无相对运动"),
    "column centre": ("centre", "瞬心"),
    "column links": ("links", "构件"),
    "column place": ("place [mm]", "位置 [mm]"),
    "column by": ("found by", "求法"),
    "place at infinity": ("at infinity, {angle}°", "无穷远，{angle}°"),
    "advantage": (
        "Mechanical advantage without losses, torque on link {out} by torque on link {driver}: {ratio} = {value} ({senses})",
        "不计损耗时的机械增益：构件 {out} 与构件 {driver} 的力矩之比 {ratio} = {value}（{senses}）",
    ),
}
