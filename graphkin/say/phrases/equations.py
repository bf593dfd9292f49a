"""Between the equations, and in their legend."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # headings
    "equations.method complex": ("Method of complex vectors", "复数矢量法"),
    "equations.method matrix": ("Matrix method", "矩阵法"),
    "equations.polygon": ("Vector polygon {number}: {names}", "矢量多边形 {number}：{names}"),
    "equations.rolling": ("Rolling of {names}", "{names} 的滚动"),
    "equations.group": ("Group of links {names}", "构件组 {names}"),
    "equations.position": ("Position", "位置分析"),
    "equations.velocity": ("Velocity", "速度分析"),
    "equations.acceleration": ("Acceleration", "加速度分析"),
    "equations.point": ("Point {name}", "{name} 点的运动"),
    "equations.legend": ("Symbols", "符号说明"),
    # tables
    "equations.symbol": ("symbol", "符号"),
    "equations.meaning": ("meaning", "含义"),
    "equations.value": ("value", "数值"),
    # figure
    "equations.figure": ("The mechanism with its link vectors", "机构的杆矢量图"),
    # polygons
    "equations.every vector": ("Every link is a vector with a length l and a direction θ, counted counter-clockwise "
                               "from the x axis; a displacement s is the length of a vector that changes. i is the "
                               "imaginary unit; {euler}.",
                               "将各构件表示为杆矢量，其长度为 l，方位角为 θ，由 x 轴起逆时针方向计量为正；滑块位移 s 为长度变化的矢量。i 为虚数单位，{euler}。"),
    "equations.drivers": ("Given: the motions of the drivers, {drivers}.", "已知：原动件的运动 {drivers}。"),
    "equations.driver": ("Given: the motion of the driver, {drivers}.", "已知：原动件的运动 {drivers}。"),
    "equations.auxiliary fixed": ("{letter} is an auxiliary fixed point, at ({x}, {y}) mm.",
                                  "{letter} 为机架上的辅助点，坐标为 ({x}, {y}) mm。"),
    "equations.auxiliary": ("{letter} is an auxiliary point of link {link}: there the line begins on which {point} "
                            "moves.",
                            "{letter} 为构件 {link} 上的辅助点，即 {point} 所沿直线的起点。"),
    "equations.no loop": ("Every link follows from the drivers directly; there is no polygon to close.",
                          "各构件的位置均可由原动件直接求得，无需封闭矢量多边形。"),
    "equations.fixed angles": ("Links that keep their angle to one another:", "方位角关系固定的构件："),
    "equations.same rates": ("and, differentiated with respect to time:", "对时间求导，得角速度、角加速度的关系："),
    "equations.unknown": ("Unknown: {unknowns}.", "未知量：{unknowns}。"),
    "equations.closure": ("The vectors of the polygon close:", "封闭矢量方程写成复数矢量形式："),
    "equations.parts": ("Real and imaginary parts, by Euler's formula:", "应用欧拉公式将实部和虚部分离，得"),
    "equations.derived": ("Differentiated with respect to time:", "对时间求导，可得"),
    "equations.derived steady": ("Differentiated with respect to time, with {zero}:", "对时间求导（{zero}），可得"),
    "equations.derived again": ("Differentiated with respect to time once more:", "再对时间求导，可得"),
    "equations.derived again steady": ("Differentiated with respect to time once more, with {zero}:",
                                       "再对时间求导（{zero}），可得"),
    # positions
    "equations.eliminate angle": ("To eliminate {other}, its vectors are left alone on one side, both sides are "
                                  "squared and added. This gives an equation for {angle}:",
                                  "将含 {other} 的项单独留在等式一端，两端平方后相加，消去 {other}，得关于 {angle} 的方程"),
    "equations.eliminate slide": ("Projected across the direction of {other}, which eliminates {other}:",
                                  "向垂直于 {other} 的方向投影，消去 {other}，得"),
    "equations.with": ("with", "式中"),
    "equations.solved": ("Its solution is", "解之可得"),
    "equations.sign": ("Of the two solutions, the drawn assembly takes ± = {sign}, and keeps it as long as no dead "
                       "point is passed.",
                       "两个解对应机构的两种装配形式：给定的装配形式取 ± = {sign}，在不越过死点时保持不变。"),
    "equations.direction of": ("{angle} is then the direction of the remaining vector; atan2(y, x) is the angle of "
                               "the vector (x, y):",
                               "于是 {angle} 为其余矢量之和的方位角（atan2(y, x) 为矢量 (x, y) 的方位角）："),
    "equations.along": ("Projected along the direction of {slide}:", "向 {slide} 的方向投影，得"),
    "equations.square": ("Squaring the magnitudes of both sides eliminates {angle} and leaves the length that changes:",
                         "两端取模的平方，消去 {angle}，得"),
    "equations.each across": ("Projected across each of the two guides, which eliminates the other displacement:",
                              "分别向垂直于两导路的方向投影，可得"),
    "equations.newton": ("These {count} equations hold {count} unknowns that no pair of them separates: there is no "
                         "closed form that ruler and compass could draw. They are solved by Newton's method from a "
                         "nearby position; velocities and accelerations follow from linear equations, below in "
                         "matrices.",
                         "上列 {count} 个方程含 {count} 个未知量，不能逐对分离求解，无简单的封闭解，须用牛顿迭代法由邻近位置求出；速度和加速度由线性方程组求得，以矩阵形式列于下。"),
    "equations.linear": ("These {count} rolling relations are linear: eliminating one unknown after the other gives "
                         "them in closed form.",
                         "上列 {count} 个滚动关系均为线性方程，逐一消元即得封闭解。"),
    # rates
    "equations.rates": ("Each unknown is found from the scalar product of both sides with the unit vector at right "
                        "angles to the other unknown's vector, which eliminates that one:",
                        "为逐一求出各未知量，将等式两端点乘与另一未知矢量垂直的单位矢量以消去之，得"),
    "equations.rolling relation": ("Rolling without slip, seen from the arm, ties the angles; the constant is that of "
                                   "the drawn position:",
                                   "由无滑动滚动条件（相对于系杆）得转角关系，常数由给定位置确定："),
    "equations.hence": ("Hence", "故"),
    # points
    "equations.point from": ("The vector from {start} to {name} runs over the links:", "由 {start} 至 {name} 的位置矢量为"),
    # matrix
    "equations.all unknowns": ("All polygons together, terms with unknowns on the left:",
                               "将各封闭矢量方程在两坐标轴上投影，方程左边仅含未知量项："),
    "equations.as matrices": ("As a matrix equation:", "写成矩阵形式："),
    "equations.matrix A": ("The matrix of the followers' position parameters:", "机构从动件的位置参数矩阵为"),
    "equations.matrix B": ("The column of the driver's position parameters:", "机构原动件的位置参数列阵为"),
    "equations.matrix B many": ("The matrix of the drivers' position parameters, one column a driver:",
                                "机构原动件的位置参数矩阵（每一原动件对应一列）为"),
    "equations.columns": ("The columns of the followers' velocities and accelerations:", "从动件的速度列阵与加速度列阵为"),
    "equations.driver columns": ("The drivers' velocities and accelerations:", "原动件的速度列阵与加速度列阵为"),
    "equations.derivatives": ("Their derivatives with respect to time:", "对时间的导数为"),
    "equations.numbers": ("With the values of the drawn position (m, rad, s):", "代入给定位置的数值（单位 m、rad、s）："),
    "equations.solution": ("Solved:", "解得"),
    "equations.more rows": ("There are more rows than unknowns: some constraints repeat others, and hold all the same.",
                            "方程数多于未知量数：其中有重复约束，但彼此协调。"),
    # --- the legend
    "equations.length": ("length {ends} of link {link}", "构件 {link} 的长度 {ends}"),
    "equations.frame direction": ("direction of the frame's {vector}", "机架矢量 {vector} 的方位角"),
    "equations.offset": ("angle from the direction of link {link} to {vector}", "构件 {link} 的方向到 {vector} 的夹角"),
    "equations.turning direction": ("direction of link {link}", "构件 {link} 的方位角"),
    "equations.turning angular velocity": ("angular velocity of link {link}", "构件 {link} 的角速度"),
    "equations.turning angular acceleration": ("angular acceleration of link {link}", "构件 {link} 的角加速度"),
    "equations.relative direction": ("direction of link {link} relative to link {other}",
                                     "构件 {link} 相对构件 {other} 的方位角"),
    "equations.relative direction given": ("direction of link {link} relative to link {other} (given: {vector} turned "
                                           "by {angle}° from {seen})",
                                           "构件 {link} 相对构件 {other} 的方位角（题给 {vector} 相对 {seen} 转过 {angle}°）"),
    "equations.relative angular velocity": ("angular velocity of link {link} relative to link {other}",
                                            "构件 {link} 相对构件 {other} 的角速度"),
    "equations.relative angular acceleration": ("angular acceleration of link {link} relative to link {other}",
                                                "构件 {link} 相对构件 {other} 的角加速度"),
    "equations.sliding displacement": ("displacement of {point} along the guide on link {guide}, from {start}",
                                       "{point} 沿构件 {guide} 上导路、自 {start} 起的位移"),
    "equations.sliding velocity": ("sliding velocity of {point} along the guide on link {guide}, from {start}",
                                   "{point} 沿构件 {guide} 上导路、自 {start} 起的滑动速度"),
    "equations.sliding acceleration": ("sliding acceleration of {point} along the guide on link {guide}, from {start}",
                                       "{point} 沿构件 {guide} 上导路、自 {start} 起的滑动加速度"),
    "equations.guide line": ("angle from the direction of link {link} to its guide line", "构件 {link} 的方向到其导路的夹角"),
    "equations.fixed guide": ("direction of the guide of {point}", "{point} 点导路的方位角"),
    "equations.block line": ("angle from the direction of link {guide} to that of link {block}",
                             "构件 {guide} 的方向到构件 {block} 的方向的夹角"),
    "equations.part along": ("part of {ends} along the direction of link {link}", "{ends} 沿构件 {link} 方向的分量"),
    "equations.part across": ("part of {ends} at +90° to link {link}", "{ends} 在构件 {link} 方向 +90° 上的分量"),
    "equations.point position": ("position of {point} from {start}", "由 {start} 至 {point} 的位置矢量"),
    "equations.point velocity": ("velocity of {point}", "{point} 点的速度"),
    "equations.point acceleration": ("acceleration of {point}", "{point} 点的加速度"),
    "equations.component": ("{of}, {axis}", "{of}（{axis} 分量）"),
    "equations.rolling constant": ("constant of the rolling of {first} and {second}, from the drawn position",
                                   "构件 {first} 与 {second} 滚动关系的常数，由给定位置确定"),
    "equations.radius": ("radius {radius} mm of wheel {wheel}", "轮 {wheel} 的半径 {radius} mm"),
}
