"""A problem of a set: what is given, off the mechanism file, what is asked, how to hand it in."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "student": ("Problem of {student}", "{student} 的题目"),
    "given": (
        "Given (mm, degrees, rad/s, rad/s², m/s, m/s² where no unit stands; counter-clockwise positive):",
        "已知（未注单位者为 mm、°、rad/s、rad/s²、m/s、m/s²；逆时针为正）：",
    ),
    "figure drawn": ("Figure: {file}", "图：{file}"),
    "figure elsewhere": (
        "Figure, in another position than the one asked for: {file}", "图（非所求位置）：{file}",
    ),
    "angle": (
        "; {angle} is the angle of the direction {tail}→{head} from +x, counter-clockwise",
        "；{angle} 为方向 {tail}→{head} 与 +x 的夹角，逆时针为正",
    ),
    "angle of guide": (
        "; {angle} is the angle of the sliding direction on link {guide} from +x, counter-clockwise",
        "；{angle} 为构件 {guide} 上导路方向与 +x 的夹角，逆时针为正",
    ),
    "find": ("Find graphically:", "用图解法求："),
    "points one": (" ({points:g} point)", "（{points:g} 分）"),
    "points many": (" ({points:g} points)", "（{points:g} 分）"),
    "hand in": (
        "Hand in a text file with these lines, a number behind each; senses as signs or as ccw, cw:",
        "请提交含下列各行的文本文件，在每行后填写数值；转向用正负号或“逆时针”“顺时针”表示：",
    ),
    "positions": (
        "Positions, each to be solved; behind a quantity #2 says at which (the first needs no number):",
        "下列各位置均须求解；量后的 #2 表示所在位置（第一个位置不必注明）：",
    ),
    "as given": ("as given", "所给位置"),
    "drawing of position": (
        "A drawing of a position has its number at the end of its file's name: drawing #2.svg.",
        "某一位置的图，文件名末尾注明位置编号，如 drawing #2.svg。",
    ),
    "shared": (
        "note: {count} students have a problem whose answers are another's, within 2 %: {students}. Widen the "
        "ranges.",
        "提示：{count} 名学生的题目与他人答案相同（相差 2% 以内）：{students}。请放宽范围。",
    ),
    # tables of the mechanism file
    "table frame": ("Frame", "机架"),
    "the frame": ("the frame", "机架"),
    "table links": ("Link", "构件"),
    "table slide": ("Sliding pair", "移动副"),
    "table gear": ("Gear pair", "齿轮副"),
    "table roll": ("Rolling wheel", "滚轮"),
    "table cam": ("Cam pair", "凸轮副"),
    "table driver": ("Driver", "原动件"),
    "table pose": ("Drawn position", "作图位置"),
    "table scales": ("Scales", "比例尺"),
    # keys of a table; names of points and lengths stand for themselves
    "key name": ("name", "名称"),
    "key points": ("points", "点"),
    "key block": ("block", "滑块"),
    "key point": ("point", "点"),
    "key guide": ("guide", "导路构件"),
    "key through": ("through", "过点"),
    "key toward": ("toward", "指向"),
    "key from": ("from the direction", "起始方向"),
    "key angle": ("angle", "角度"),
    "key pin": ("pin", "销"),
    "key vector": ("line", "线段"),
    "key omega": ("ω", "ω"),
    "key alpha": ("α", "α"),
    "key velocity": ("velocity", "速度"),
    "key acceleration": ("acceleration", "加速度"),
    "key slide": ("slide", "移动副"),
    "key at": ("displacement", "位移"),
    "key also": ("also at", "另求"),
    "key link": ("link", "构件"),
    "key links": ("links", "构件"),
    "key centres": ("centres", "中心"),
    "key radii": ("radii", "半径"),
    "key internal": ("internal", "内啮合"),
    "key wheel": ("wheel", "轮"),
    "key centre": ("centre", "中心"),
    "key radius": ("radius", "半径"),
    "key on": ("on", "在其上"),
    "key side": ("side", "侧"),
    "key shape": ("shape", "形状"),
    "key tilt": ("tilt", "倾角"),
    "key profiles": ("profiles", "廓线"),
    "key length": ("length", "长度"),
    "key ccw": ("counter-clockwise order", "逆时针顺序"),
}
