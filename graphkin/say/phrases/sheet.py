"""What is written on a sheet beside drawings and results."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "given": ("given", "已知"),
    "find": ("find", "求"),
    "path of": ("path of {point}", "{point} 的轨迹"),
    "ticks": ("ticks every {step} of {driver}", "{driver} 每隔 {step} 一刻度"),
    "arrows": ("arrows: 1 mm is ", "箭头：1 mm 表示 "),
    "every": ("from arrow to arrow ", "相邻箭头相隔 "),
    "step": ("Step {number} of {count}", "第 {number} 步，共 {count} 步"),
}
"""`given` heads what is known of the mechanism, `find` what is asked; `step` heads the sentence of a step's sheet.
The rest goes with the path of a point."""
