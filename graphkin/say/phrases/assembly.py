"""In which assembly a mechanism is drawn."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "drawn": ("Assembly: {told}.", "装配位置：{told}。"),
    "side above": ("{point} above {line}", "{point} 在 {line} 上方"),
    "side below": ("{point} below {line}", "{point} 在 {line} 下方"),
    "side left": ("{point} to the left of {line}", "{point} 在 {line} 左侧"),
    "side right": ("{point} to the right of {line}", "{point} 在 {line} 右侧"),
    "side far": (
        "{point} at that of its two possible places which is farther from {line}",
        "{point} 取两个可能位置中离 {line} 较远者",
    ),
    "side near": (
        "{point} at that of its two possible places which is nearer to {line}",
        "{point} 取两个可能位置中离 {line} 较近者",
    ),
    "near": ("{point} near ({x}, {y})", "{point} 在 ({x}, {y}) 附近"),
}
