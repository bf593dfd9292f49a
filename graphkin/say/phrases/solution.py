"""A written solution: what is given, what is asked, and the answers."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    # --- its parts
    "given": ("Given", "已知"),
    "find": ("Find", "求"),
    "solution": ("Solution", "解"),
    "answer": ("Answer", "答"),
    # --- given
    "lengths": ("Lengths: {lengths}.", "各构件尺寸：{lengths}。"),
    "lettered": ("Corners in order: {shapes}.", "各构件上点的绕行方向：{shapes}。"),
    "frame points": ("Link {link} is the frame; fixed points, in mm: {points}.", "构件 {link} 为机架，固定点（mm）：{points}。"),
    "frame": ("Link {link} is the frame.", "构件 {link} 为机架。"),
    "block on frame": (
        "Slider {block}{guide} moves its point {point} along a fixed guide {line}{tilt}.",
        "滑块 {block}{guide} 上的 {point} 点沿固定导路移动，导路{line}{tilt}。",
    ),
    "pin on frame": (
        "Pin {point}{guide} moves in a fixed slot {line}.",
        "销 {point}{guide} 在固定槽中移动，槽{line}。",
    ),
    "block on link": (
        "Links {block} and {link}{guide} form a sliding pair: point {point} of link {block} stays on a line of link {link} {where}{tilt}.",
        "构件 {block} 与构件 {link}{guide} 组成移动副：构件 {block} 上的 {point} 点在构件 {link} 的导路上，导路{where}{tilt}。",
    ),
    "pin on link": (
        "Pin {point}{guide} moves in a slot of link {link} {where}.",
        "销 {point}{guide} 在构件 {link} 的槽中移动，槽{where}。",
    ),
    "tilt": (
        "; the direction of {line} is the guide's turned by {angle} {sense}",
        "；将导路方向{sense}转过 {angle} 即为 {line} 的方向",
    ),
    "line of": ("the guide of link {link}", "构件 {link} 的导路"),
    "tilt none": ("; {line} points along the guide", "；{line} 沿导路方向"),
    "at angle": (
        "through {through} that makes {angle} with {arrow} ({sense})",
        "过 {through} 点，与 {arrow} 成 {angle}（{sense}）",
    ),
    "along": ("along {line}", "为直线 {line}"),
    "parallel": ("through {through}, parallel to {arrow}", "过 {through} 点，平行于 {arrow}"),
    "own axis": ("through {through}, the link's own axis", "过 {through} 点，即该构件的轴线"),
    "line": ("through {start} at {angle} to +x", "过 {start}，与 x 轴正向成 {angle}"),
    "circular slot": (
        "Pin {pin} moves in a circular slot of link {link} about {centre} with radius {radius}.",
        "销 {pin} 在构件 {link} 的圆弧槽中移动，圆心为 {centre}，半径为 {radius}。",
    ),
    "gears": ("Gears {wheels} about {centres} are in external mesh: {radii}.", "齿轮 {wheels}（轮心 {centres}）外啮合：{radii}。"),
    "internal gears": (
        "Gears {wheels} about {centres} are in internal mesh: {radii}.",
        "齿轮 {wheels}（轮心 {centres}）内啮合：{radii}。",
    ),
    "rolls on circle": (
        "Wheel {wheel} about {centre}, {radius}, rolls without slip on the circle of link {track} about {about} with radius {other} ({where}).",
        "轮 {wheel}（轮心 {centre}，{radius}）在构件 {track} 上以 {about} 为圆心、半径为 {other} 的圆上作纯滚动（{where}）。",
    ),
    "inside": ("one inside the other", "内切"),
    "outside": ("side by side", "外切"),
    "rolls on line": (
        "Wheel {wheel} about {centre}, {radius}, rolls without slip on the line{line} of link {track}{side}.",
        "轮 {wheel}（轮心 {centre}，{radius}）在构件 {track} 的直线{line} 上作纯滚动{side}。",
    ),
    "wheel left": (" ({centre} on its left)", "（沿此方向看 {centre} 在其左侧）"),
    "wheel right": (" ({centre} on its right)", "（沿此方向看 {centre} 在其右侧）"),
    "displacement": ("displacement {s}", "位移 {s}"),
    "cam": ("{first} and {second} touch and slide on each other{where}.", "{first}与{second}相接触{where}，组成高副。"),
    "flat face": ("the flat face{line} of link {link}{side}", "构件 {link} 的平底{line}{side}"),
    "knife edge": ("the knife edge {point} of link {link}", "构件 {link} 的尖顶 {point}"),
    "circle": (
        "the circle of link {link} about {centre} with radius {radius}",
        "构件 {link} 以 {centre} 为圆心、半径为 {radius} 的圆弧",
    ),
    # --- asked
    "find these": ("{wanted}.", "{wanted}。"),
    "find all": (
        "the velocities and accelerations of all points, ω and α of all links.",
        "各点的速度和加速度，各构件的角速度和角加速度。",
    ),
    "find velocities": ("the velocities of all points, ω of all links.", "各点的速度，各构件的角速度。"),
    "place": ("the place of {point}", "点 {point} 的位置"),
    "place at": ("{point} is at {place} mm.", "{point} 位于 {place} mm。"),
    "centre": ("instant centre {name}", "瞬心 {name}"),
    "centre at": ("{name}: {place}.", "{name}：{place}。"),
    # --- read by hand
    "exactly": ("Beside the exact values", "与精确值比较"),
    "beside": (
        "{name}: as drawn {read}, exactly {exact}{off}.",
        "{name}：作图值 {read}，精确值 {exact}{off}。",
    ),
    "off": ("; off by {part} %", "，误差 {part} %"),
}
