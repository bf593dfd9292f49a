"""Pictures of feedback: the right drawing beside the one with a mistake, and a student's own over them."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "position": ("At position #{at}.", "位置 #{at}。"),
    "title": ("The right drawing, and the one with the mistake", "正确的图与含错误的图"),
    "under right": ("right", "正确"),
    "under mistake": ("with the mistake", "含此错误"),
    "shows": ("Drawn with this mistake: {mistake}.", "按此错误所画：{mistake}。"),
    "between": (" ", ""),
    "thick": (
        "Thick: laid off or directed otherwise than it should be; the rest only follows.",
        "粗线：大小或方向画错之处，其余为其后果。",
    ),
    "dashed": (
        "Dashed, with letters in brackets: your own drawing, as it was measured.",
        "虚线及括号内字母：你所画的图（按量得的结果）。",
    ),
    "no scale": ("Drawn without a scale.", "未注比例尺。"),
    "none": ("No picture could be drawn: {reason}", "无法绘图：{reason}"),
    "nothing": (
        "Nothing is drawn otherwise: the mistake is in what is read off or written down.",
        "图本身无误：错在读数或书写。",
    ),
}
