"""A written solution: what is given, what is asked, and the answers."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # --- its parts
    "solution.given": ("Given", "已知"),
    "solution.find": ("Find", "求"),
    "solution.solution": ("Solution", "解"),
    "solution.answer": ("Answer", "答"),
    # --- given
    "solution.lengths": ("Lengths: {lengths}.", "各构件尺寸：{lengths}。"),
    "solution.lettered": ("Corners in order: {shapes}.", "各构件上点的绕行方向：{shapes}。"),
    "solution.frame points": ("Link {link} is the frame; fixed points, in mm: {points}.",
                              "构件 {link} 为机架，固定点（mm）：{points}。"),
    "solution.frame": ("Link {link} is the frame.", "构件 {link} 为机架。"),
    "solution.block on frame": ("Slider {block}{guide} moves its point {point} along a fixed guide {line}{tilt}.",
                                "滑块 {block}{guide} 上的 {point} 点沿固定导路移动，导路{line}{tilt}。"),
    "solution.pin on frame": ("Pin {point}{guide} moves in a fixed slot {line}.", "销 {point}{guide} 在固定槽中移动，槽{line}。"),
    "solution.block on link": ("Links {block} and {link}{guide} form a sliding pair: point {point} of link {block} "
                               "stays on a line of link {link} {where}{tilt}.",
                               "构件 {block} 与构件 {link}{guide} 组成移动副：构件 {block} 上的 {point} 点在构件 {link} "
                               "的导路上，导路{where}{tilt}。"),
    "solution.pin on link": ("Pin {point}{guide} moves in a slot of link {link} {where}.",
                             "销 {point}{guide} 在构件 {link} 的槽中移动，槽{where}。"),
    "solution.tilt": ("; the direction of {line} is the guide's turned by {angle} {sense}",
                      "；将导路方向{sense}转过 {angle} 即为 {line} 的方向"),
    "solution.line of": ("the guide of link {link}", "构件 {link} 的导路"),
    "solution.tilt none": ("; {line} points along the guide", "；{line} 沿导路方向"),
    "solution.at angle": ("through {through} that makes {angle} with {arrow} ({sense})",
                          "过 {through} 点，与 {arrow} 成 {angle}（{sense}）"),
    "solution.along": ("along {line}", "为直线 {line}"),
    "solution.parallel": ("through {through}, parallel to {arrow}", "过 {through} 点，平行于 {arrow}"),
    "solution.own axis": ("through {through}, the link's own axis", "过 {through} 点，即该构件的轴线"),
    "solution.line": ("through {start} at {angle} to +x", "过 {start}，与 x 轴正向成 {angle}"),
    "solution.circular slot": ("Pin {pin} moves in a circular slot of link {link} about {centre} with radius {radius}.",
                               "销 {pin} 在构件 {link} 的圆弧槽中移动，圆心为 {centre}，半径为 {radius}。"),
    "solution.gears": ("Gears {wheels} about {centres} are in external mesh: {radii}.",
                       "齿轮 {wheels}（轮心 {centres}）外啮合：{radii}。"),
    "solution.internal gears": ("Gears {wheels} about {centres} are in internal mesh: {radii}.",
                                "齿轮 {wheels}（轮心 {centres}）内啮合：{radii}。"),
    "solution.rolls on circle": ("Wheel {wheel} about {centre}, {radius}, rolls without slip on the circle of link "
                                 "{track} about {about} with radius {other} ({where}).",
                                 "轮 {wheel}（轮心 {centre}，{radius}）在构件 {track} 上以 {about} 为圆心、半径为 {other} "
                                 "的圆上作纯滚动（{where}）。"),
    "solution.inside": ("one inside the other", "内切"),
    "solution.outside": ("side by side", "外切"),
    "solution.rolls on line": ("Wheel {wheel} about {centre}, {radius}, rolls without slip on the line{line} of link "
                               "{track}{side}.",
                               "轮 {wheel}（轮心 {centre}，{radius}）在构件 {track} 的直线{line} 上作纯滚动{side}。"),
    "solution.wheel left": (" ({centre} on its left)", "（沿此方向看 {centre} 在其左侧）"),
    "solution.wheel right": (" ({centre} on its right)", "（沿此方向看 {centre} 在其右侧）"),
    "solution.displacement": ("displacement {s}", "位移 {s}"),
    "solution.cam": ("{first} and {second} touch and slide on each other{where}.", "{first}与{second}相接触{where}，组成高副。"),
    "solution.flat face": ("the flat face{line} of link {link}{side}", "构件 {link} 的平底{line}{side}"),
    "solution.knife edge": ("the knife edge {point} of link {link}", "构件 {link} 的尖顶 {point}"),
    "solution.circle": ("the circle of link {link} about {centre} with radius {radius}",
                        "构件 {link} 以 {centre} 为圆心、半径为 {radius} 的圆弧"),
    # --- asked
    "solution.find these": ("{wanted}.", "{wanted}。"),
    "solution.find all": ("the velocities and accelerations of all points, ω and α of all links.",
                          "各点的速度和加速度，各构件的角速度和角加速度。"),
    "solution.find velocities": ("the velocities of all points, ω of all links.", "各点的速度，各构件的角速度。"),
    "solution.place": ("the place of {point}", "点 {point} 的位置"),
    "solution.place at": ("{point} is at {place} mm.", "{point} 位于 {place} mm。"),
    "solution.centre": ("instant centre {name}", "瞬心 {name}"),
    "solution.centre at": ("{name}: {place}.", "{name}：{place}。"),
    # --- read by hand
    "solution.exactly": ("Beside the exact values", "与精确值比较"),
    "solution.beside": ("{name}: as drawn {read}, exactly {exact}{off}.", "{name}：作图值 {read}，精确值 {exact}{off}。"),
    "solution.off": ("; off by {part} %", "，误差 {part} %"),
}
