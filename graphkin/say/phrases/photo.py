"""Phrases of the page on which a teacher looks at what was found on photographs."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    "photo.title": ("Photographs of {name}", "{name}：照片核对"),
    "photo.language": ("中文", "English"),
    "photo.save": ("Save corrections", "保存核对结果"),
    "photo.only": ("only what is unsure", "只看存疑的"),
    "photo.count": ("{open} to look at, of {all} polygons", "共 {all} 个多边形，待核对 {open} 个"),
    "photo.how": ("Drag a point, or move it with the arrow keys (0.1 mm, with Shift 1 mm); Delete takes it away; + and − zoom; N goes to the next. Tick what is right, save, and mark the saved file: graphkin grade KEY {file}",
                  "拖动顶点，或用方向键移动（0.1 mm，按 Shift 为 1 mm）；Delete 删去；+ 和 − 缩放；N 到下一个。核对无误后勾选并保存，再评阅保存的文件：graphkin grade KEY {file}"),
    "photo.velocity": ("velocity polygon", "速度多边形"),
    "photo.acceleration": ("acceleration polygon", "加速度多边形"),
    "photo.heading": ("{called} · #{number} · {plane}", "{called} · #{number} · {plane}"),
    "photo.corner": ("{letter}: {x} mm to the right, {y} mm up", "{letter}：向右 {x} mm，向上 {y} mm"),
    "photo.confirm": ("This is right", "核对无误"),
    "photo.not drawn": ("not drawn:", "未画："),
    "photo.put": ("put {put} on the drawing", "在图上放置 {put}"),
    "photo.empty": ("Nothing is drawn", "没有作图"),
    "photo.saved": ("Saved: {file}", "已保存：{file}"),
    "photo.not read": ("Not read", "未能识读"),
}
# fmt: on
