"""Instant centres: how each is found and what they give; a link about its pole, and the pole of two velocities."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # === instant centres
    "centres.finding": ("({number}) Instant centres", "({number}) 求瞬心"),
    "centres.count": ("The mechanism has N = {n} links, the frame included: K = N(N−1)/2 = {n}×{less}/2 = {count} "
                      "instant centres.",
                      "机构共有 N = {n} 个构件（含机架），瞬心总数 K = N(N−1)/2 = {n}×{less}/2 = {count}。"),
    "centres.definition": ("By definition, of links that are joined directly:", "由瞬心定义直接确定的瞬心："),
    "centres.kennedy": ("By the theorem of three centres (Kennedy and Aronhold):", "不直接相连的构件，由三心定理确定其瞬心："),
    # --- by definition
    "centres.found hinge": ("{name}: in hinge {point}, which joins links {first} and {second}; {place}.",
                            "{name}：构件 {first}、{second} 以转动副 {point} 相连，瞬心在 {point}，{place}。"),
    "centres.found contact": ("{name}: links {first} and {second} roll on each other without sliding: where they "
                              "touch, {place}.",
                              "{name}：构件 {first}、{second} 作纯滚动，瞬心在接触点，{place}。"),
    "centres.found slide": ("{name}: links {first} and {second} slide on each other: at infinity, at right angles to "
                            "the guide ({angle}).",
                            "{name}：构件 {first}、{second} 组成移动副，瞬心在垂直于导路方向（{angle}）的无穷远处。"),
    # --- Kennedy's lines
    "centres.found two lines": ("{name} lies on {first} and on {second}: {met}.",
                                "{name} 在{first}上，又在{second}上：{met}。"),
    "centres.join": ("{line} (links {links})", " {line} 连线（构件 {links}）"),
    "centres.across guide": ("the line through {near} at right angles to the guide, towards {far} → ∞ (links {links})",
                             "过 {near} 且垂直于导路的直线（指向 {far} → ∞，构件 {links}）"),
    "centres.parallel": ("the line through {near} parallel to the direction of {far} → ∞ at {angle} (links {links})",
                         "过 {near} 且平行于 {far} → ∞ 方向（{angle}）的直线（构件 {links}）"),
    "centres.at infinity": ("the line at infinity, as {first} and {second} do (links {links})",
                            "无穷远直线（{first}、{second} 均在无穷远，构件 {links}）"),
    "centres.normal of contact": ("the common normal n–n at the contact of links {first} and {second}",
                                  "构件 {first}、{second} 接触点处的公法线（n–n）"),
    "centres.normal of slot": ("the normal of the slot through {point} (where links {first} and {second} touch)",
                               "构件 {first}、{second} 接触处 {point} 的槽的法线"),
    "centres.normal of circular slot": ("the normal n–n of the circular slot through its centre {point} (where links "
                                        "{first} and {second} touch)",
                                        "构件 {first}、{second} 接触处圆弧槽的公法线 n–n（过槽的圆心 {point}）"),
    "centres.met": ("where the two lines meet, {place}", "两线交点，{place}"),
    "centres.met far": ("the lines are parallel, so {name} → ∞ at {angle}", "两线平行，故 {name} → ∞，方向 {angle}"),
    "centres.met infinity": ("so {name} → ∞ at {angle}", "故 {name} → ∞，方向 {angle}"),
    # --- from velocities
    "centres.found velocities": ("{name} cannot be found by three-centre lines alone: {reason}. From velocities: "
                                 "where links {first} and {second} have one velocity, {place}.",
                                 "{name} 仅用三心定理不能确定：{reason}。由速度求得：构件 {first}、{second} 在该点速度相同，{place}。"),
    "centres.several freedoms": ("the mechanism has {count} degrees of freedom, and the centre depends on how the "
                                 "drivers move",
                                 "机构有 {count} 个自由度，该瞬心与各原动件运动的比例有关"),
    "centres.lines coincide": ("no two lines through it that differ are known", "已知的过该点的直线重合或不足两条"),
    "centres.together": ("{name}: links {first} and {second} have no relative motion at this instant, and no centre.",
                         "{name}：构件 {first}、{second} 此瞬时无相对运动，不存在瞬心。"),
    "centres.mm": ("at ({x}, {y}) mm", "坐标（{x}，{y}）mm"),
    "centres.infinite": ("at infinity, in the direction {angle}", "在方向 {angle} 的无穷远处"),
    # --- what they are used for
    "centres.using": ("(2) Velocities from the centres", "(2) 用瞬心作速度分析"),
    "centres.scale": ("Lengths are measured on paper in mm; {scale} = {value} m/mm.",
                      "长度在图上量取（mm），取 {scale} = {value} m/mm。"),
    "centres.given": ("Given: {what}.", "已知：{what}。"),
    "centres.resting": ("No driver moves: nothing has a velocity.", "各原动件均静止，速度为零。"),
    "centres.no accelerations": ("Accelerations ({names}) cannot be found from instant centres.",
                                 "瞬心法不能用于加速度分析（{names}）。"),
    "centres.not told": ("{name}: the centres give no lever for it at this position.", "{name}：此位置不能直接由瞬心求出。"),
    "centres.sense outside": ("{sense}; {centre} lies outside {ends}: same sense", "{sense}，{centre} 在 {ends} 之外，转向相同"),
    "centres.sense between": ("{sense}; {centre} lies between {ends}: opposite sense",
                              "{sense}，{centre} 在 {ends} 之间，转向相反"),
    "centres.sense alike": ("{sense}; {centre} → ∞, the links turn alike", "{sense}，{centre} → ∞，两构件角速度相同"),
    "centres.across": ("at right angles to {arm}, at {angle}", "⊥{arm}，方向 {angle}"),
    "centres.along": ("the link moves without turning, at {angle}", "构件作平动，方向 {angle}"),
    "centres.at": ("at {angle}", "方向 {angle}"),
    "centres.same": ("same sense", "转向相同"),
    "centres.opposite": ("opposite sense", "转向相反"),
    "centres.triangle": ("from both velocities and their angle", "由两速度及其夹角"),
    # --- the table
    "centres.by hinge": ("hinge", "转动副"),
    "centres.by contact": ("rolling contact", "纯滚动接触点"),
    "centres.by slide": ("sliding pair", "移动副"),
    "centres.by velocities": ("velocities", "由速度求得"),
    "centres.by normal": ("common normal", "公法线"),
    "centres.by together": ("no relative motion", "无相对运动"),
    "centres.column centre": ("centre", "瞬心"),
    "centres.column links": ("links", "构件"),
    "centres.column place": ("place [mm]", "位置 [mm]"),
    "centres.column by": ("found by", "求法"),
    "centres.place at infinity": ("at infinity, {angle}°", "无穷远，{angle}°"),
    "centres.advantage": ("Mechanical advantage without losses, torque on link {out} by torque on link {driver}: "
                          "{ratio} = {value} ({senses})",
                          "不计损耗时的机械增益：构件 {out} 与构件 {driver} 的力矩之比 {ratio} = {value}（{senses}）"),
    # === a link about its pole (about)
    "about.pole title": ("Pole of a body from two velocities", "由两点速度求瞬心"),
    "about.curves": ("Curves of {centre}, in pieces: {count}", "{centre} 的曲线，共 {count} 段"),
    "about.piece closed": ("closed, {places} places", "闭合，{places} 个位置"),
    "about.piece open": ("open, {places} places", "不闭合，{places} 个位置"),
    "about.reach": ("in the axes of link {link}: x {x}, y {y}", "在构件 {link} 的坐标系中：x {x}，y {y}"),
    "about.rolling": ("The moving centrode (dashed) rolls without slipping on the other; they touch at {centre} "
                      "{place}.",
                      "动瞬心线（虚线）在另一条瞬心线上作纯滚动；此刻两线相切于 {centre} {place}。"),
    "about.hinge": ("{centre} {place} stays at one point of both links: the centrodes are points.",
                    "{centre} {place} 始终为两构件上的同一点：瞬心线退化为点。"),
    "about.centre now": ("At this position {centre} lies at {place}.", "此位置 {centre} 在 {place}。"),
    "about.where curves": ("Drawn with -o OUT.svg; all places with --json.", "用 -o OUT.svg 画出；用 --json 给出全部位置。"),
    "about.assumed": ("No driver moves: each is taken to move at 1 rad/s (1 m/s).", "原动件均未给定速度：各按 1 rad/s（1 m/s）计算。"),
    "about.pole": ("Link {link} turns about its instant centre P {place} with {omega}, {alpha}.",
                   "构件 {link} 绕瞬心 P {place} 转动，{omega}，{alpha}。"),
    "about.translation": ("Link {link} is in translation: P lies at infinity in the direction {at:read}°, ω = 0, "
                          "{alpha}.",
                          "构件 {link} 作瞬时平动：瞬心 P 在方向 {at:read}° 的无穷远处，ω = 0，{alpha}。"),
    "about.rest": ("Link {link} stands still at this instant.", "构件 {link} 此刻静止。"),
    "about.acceleration": ("Acceleration pole J {place}: the acceleration of this point of the link is 0.",
                           "加速度瞬心 J {place}：构件上该点的加速度为零。"),
    "about.no acceleration": ("There is no acceleration pole: ω = α = 0, all points have one acceleration.",
                              "没有加速度瞬心：ω = α = 0，各点加速度相同。"),
    "about.pivot": ("P is a fixed point: every point moves on a circle about it, there is no inflection circle.",
                    "P 为固定点：各点均绕其作圆周运动，没有拐点圆。"),
    "about.moving pole": ("The pole moves along the centrodes with u = {u:read} m/s; the pole tangent makes an angle "
                          "of {tangent:read}° with +x.",
                          "瞬心沿瞬心线移动的速度 u = {u:read} m/s；极切线与 x 轴正向成 {tangent:read}°。"),
    "about.inflection": ("Inflection circle: through P, diameter |u/ω| = {diameter:read} mm along the pole normal; "
                         "centre {place}. The paths of its points are straight at this instant.",
                         "拐点圆：过 P，直径 |u/ω| = {diameter:read} mm，沿极法线；圆心 {place}。圆上各点的轨迹此刻曲率为零。"),
    "about.return": ("Cuspidal circle: its mirror image in the pole tangent, centre {place}.",
                     "尖点圆：拐点圆对极切线的镜像，圆心 {place}。"),
    "about.inflection line": ("The inflection circle has become a line through {place}, at an angle of {at:read}° "
                              "with +x.",
                              "拐点圆退化为直线：过 {place}，与 x 轴正向成 {at:read}°。"),
    "about.curved": ("{name}: v = {v:read} m/s, a = {a:read} m/s²; radius of curvature {radius:read} mm, centre of "
                     "curvature {place}.",
                     "{name}：v = {v:read} m/s，a = {a:read} m/s²；轨迹曲率半径 {radius:read} mm，曲率中心 {place}。"),
    "about.straight": ("{name}: v = {v:read} m/s, a = {a:read} m/s²; its path is straight at this instant.",
                       "{name}：v = {v:read} m/s，a = {a:read} m/s²；轨迹此刻曲率为零（曲率中心在无穷远处）。"),
    "about.cusp": ("{name} lies at the pole: v = 0, a = {a:read} m/s²; its path has a cusp.",
                   "{name} 位于瞬心：v = 0，a = {a:read} m/s²；轨迹在此为尖点。"),
    "about.still": ("{name} stands still.", "{name} 静止不动。"),
    # --- Bobillier's construction
    "about.bobillier pivoted": ("{point} moves about {centre}: {centre} is the centre of curvature of its path, and "
                                "the ray {point}{centre} passes the pole.",
                                "点 {point} 绕 {centre} 运动：{centre} 为其轨迹的曲率中心，射线 {point}{centre} 过瞬心。"),
    "about.bobillier guided": ("{point} moves on a straight line: its centre of curvature {centre} lies at infinity, "
                               "and its ray is the perpendicular to the path in {point}.",
                               "点 {point} 沿直线运动：其曲率中心 {centre} 在无穷远处，射线为过 {point} 的轨迹垂线。"),
    "about.bobillier measured": ("{point}: the centre of curvature {centre} of its path is known from v and a (ρ = "
                                 "v²/aⁿ).",
                                 "点 {point}：由 v、a 求得其轨迹的曲率中心 {centre}（ρ = v²/aⁿ）。"),
    "about.bobillier P": ("The two rays meet at the pole {p}.", "两射线的交点为瞬心 {p}。"),
    "about.bobillier Q": ("The lines {a}{b} and {a0}{b0} meet at {q}.", "直线 {a}{b} 与 {a0}{b0} 的交点为 {q}。"),
    "about.bobillier Q far": ("The lines {a}{b} and {a0}{b0} are parallel: {q} lies at infinity.",
                              "直线 {a}{b} 与 {a0}{b0} 平行：{q} 在无穷远处。"),
    "about.bobillier Q line": ("{a0} and {b0} both lie at infinity; so does {q}, in the direction of {a}{b}.",
                               "{a0}、{b0} 都在无穷远处，故 {q} 也在 {a}{b} 方向的无穷远处。"),
    "about.bobillier axis": ("{p}{q} is the collineation axis of {a} and {b}.", "{p}{q} 为点 {a}、{b} 的共线轴。"),
    "about.bobillier ray c": ("Draw the ray {p}{c}.", "作射线 {p}{c}。"),
    "about.bobillier axis c": ("Carry the angle from the ray of {b} to {p}{c} over to {p}{q}, with its sense: this is "
                               "the collineation axis of {a} and {c}.",
                               "将 {b} 的射线到 {p}{c} 的转角（连同转向）移到 {p}{q} 上，得点 {a}、{c} 的共线轴。"),
    "about.bobillier Qc": ("It meets the line {a}{c} at {qc}.", "它与直线 {a}{c} 的交点为 {qc}。"),
    "about.bobillier K": ("The line {a0}–{qc} meets the ray {p}{c} at {k}, the centre of curvature of the path of {c}.",
                          "直线 {a0}–{qc} 与射线 {p}{c} 的交点 {k} 即为点 {c} 轨迹的曲率中心。"),
    "about.bobillier K far": ("The line {a0}–{qc} is parallel to the ray {p}{c}: the path of {c} is straight at this "
                              "instant.",
                              "直线 {a0}–{qc} 与射线 {p}{c} 平行：点 {c} 的轨迹此刻曲率为零。"),
    # --- two velocities
    "about.two rigid": ("Along {a}{b} both velocities have the component {component:read} m/s: the points can belong "
                        "to one rigid body.",
                        "两点速度在 {a}{b} 连线上的投影相等，均为 {component:read} m/s，符合速度投影定理，属同一刚体。"),
    "about.two meet": ("The velocities are not parallel. The line through {a} across v_{a} and the line through {b} "
                       "across v_{b} meet at the instant centre P ({x:read}, {y:read}) mm.",
                       "两速度不平行：过 {a} 作 v_{a} 的垂线，过 {b} 作 v_{b} 的垂线，两垂线的交点即为瞬心 P ({x:read}, {y:read}) mm。"),
    "about.two infinity": ("The velocities are parallel and equal. The perpendiculars are parallel: the instant "
                           "centre lies at infinity, in the direction {at:read}°; ω = 0, the body is in translation "
                           "at this instant.",
                           "两速度平行且相等：两垂线互相平行，瞬心在无穷远处（方向 {at:read}°），ω = 0，刚体作瞬时平动。"),
    "about.two similar": ("The velocities are parallel, across {a}{b}, and unequal. By similar triangles the line "
                          "through the tips of the two velocity arrows meets the line {a}{b} at the instant centre P "
                          "({x:read}, {y:read}) mm.",
                          "两速度平行（均垂直于 {a}{b}）但不相等：由相似三角形，两速度矢端的连线与 {a}{b} 连线的交点即为瞬心 P ({x:read}, {y:read}) mm。"),
    "about.two point": ("The velocity of {still} is 0: {still} itself is the instant centre P ({x:read}, {y:read}) mm.",
                        "点 {still} 的速度为零，{still} 即为瞬心 P ({x:read}, {y:read}) mm。"),
    "about.two rest": ("Both velocities are 0: the body stands still at this instant, and no instant centre is seen.",
                       "两点速度均为零：刚体此刻静止，看不出瞬心。"),
    "about.two omega": ("{omega}, {sense}.", "{omega}（{sense}）。"),
}
