"""Tables of results, and a drawing measured: its table, its faults, and what was not judged."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # === tables of results
    "results.quantity": ("quantity", "量"),
    "results.graphical": ("construction replayed", "按作图步骤重演"),
    "results.analytic": ("analytic", "解析法"),
    "results.difference": ("difference", "差"),
    "results.unit": ("unit", "单位"),
    "results.position": ("position", "位置"),
    "results.asked": ("asked", "所求"),
    "results.not answered": ("not answered by this command", "本命令不作答"),
    "results.worst": ("worst relative difference", "最大相对误差"),
    # === a drawing measured
    "checks.drawn": ("drawn [mm]", "图上 [mm]"),
    "checks.exact": ("exact [mm]", "精确 [mm]"),
    "checks.off": ("off [mm]", "差 [mm]"),
    "checks.value": ("off, in unit", "差（实际单位）"),
    "checks.name": ("name", "名称"),
    "checks.good": ("good: every vector and point within {tolerance:g} mm", "合格：全部矢量和点的误差不超过 {tolerance:g} mm"),
    "checks.bad": ("NOT GOOD: {count} wrong (tolerance {tolerance:g} mm)", "不合格：{count} 处有误（允许误差 {tolerance:g} mm）"),
    "checks.fault": ("fault", "缺陷"),
    "checks.note": ("not judged", "未判断"),
    "checks.unit": ("unit", "单位"),
    "checks.plane position": ("mechanism", "机构图"),
    "checks.plane sheet": ("sheet", "图纸"),
    "checks.plane centres": ("instant centres", "瞬心"),
    "checks.plane velocity": ("velocity", "速度图"),
    "checks.plane acceleration": ("acceleration", "加速度图"),
    # --- faults
    "checks.fault changed": ("the mechanism, the drivers or the scales in the file were changed after drawing",
                             "图中的机构、原动件或比例尺数据在作图后被改动"),
    "checks.fault scale": ("the printed scale {what} is not the one drawn with", "图上标注的比例尺 {what} 与作图所用的不符"),
    "checks.fault missing": ("{what} is missing", "缺少 {what}"),
    "checks.fault unscaled": ("the scale {what} is not printed", "图上没有标注比例尺 {what}"),
    "checks.fault title": ("the printed title is not that of the mechanism in the file: {what}",
                           "图上的标题不是文件中机构的标题：{what}"),
    "checks.fault letters": ("these letters were changed, hidden or taken away: {what}", "图上的文字被改动、遮盖或删去：{what}"),
    "checks.fault head": ("the arrow head of {what} is missing, turned or at the wrong end", "{what} 的箭头缺失、方向不对或画在另一端"),
    "checks.fault arrow": ("an arrow at {what} mm bears no name, so it cannot be measured", "{what} mm 处的箭头没有名称，无法测量"),
    "checks.fault signs": ("lines and signs were moved, hidden or taken away: {what} mm", "线条和符号被移动、遮盖或删去：{what} mm"),
    "checks.fault tip": ("the value that {what} shows when pointed at is not its length", "鼠标指向 {what} 时显示的数值与其长度不符"),
    "checks.fault hidden": ("{what} cannot be seen", "{what} 看不见"),
    "checks.fault covered": ("something is drawn over {what}", "{what} 被别的图形盖住"),
    "checks.fault name": ("the point {what} is not called as what it shows", "点 {what} 的名称与其所指不符"),
    "checks.fault loose": ("the end of {what} has no point", "{what} 的端点不存在"),
    "checks.fault end": ("a vector does not end at its point: {what}", "矢量端点与点不重合：{what}"),
    # --- not judged
    "checks.note signs": ("{what} lines and signs that show no length, which are as they were drawn, and where "
                          "letters stand",
                          "{what} 个不表示长度的线条和符号（与作图时相同），以及文字的位置"),
    "checks.note other": ("lines and signs added since: {what} mm", "后来增添的线条和符号：{what} mm"),
    "checks.note words": ("{what} texts that graphkin did not write", "{what} 处不是 graphkin 写的文字"),
    "checks.note blank": ('what viewers make of the size "{what}", with a blank in it', "看图程序如何理解带空格的尺寸“{what}”"),
    "checks.note nothing": ("lengths of links: there is no point to measure from; their lines are as they were drawn",
                            "构件的长度：没有可供测量的点；其图线与作图时相同"),
    "checks.note unknown": ("the point {what}, which graphkin does not know", "点 {what}：不是 graphkin 所知的点"),
}
