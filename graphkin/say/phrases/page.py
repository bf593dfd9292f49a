"""Words of the page that plays."""

from __future__ import annotations

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "page.contents": ("Contents", "目录"),
    "page.language": ("中文", "English"),
    "page.language name": ("Show in Chinese", "用英文显示"),
    "page.print": ("Print", "打印"),
    "page.play": ("Run", "运行"),
    "page.pause": ("Stop", "停止"),
    "page.drive": ("Driver {name}", "原动件 {name}"),
    "page.handle": ("Drag to move {name}", "拖动 {name}"),
    "page.position": ("Mechanism", "机构运动简图"),
    "page.velocity": ("Velocity polygon", "速度多边形"),
    "page.acceleration": ("Acceleration polygon", "加速度多边形"),
    "page.too large": ("Not drawn here: too large, or too near a dead point", "此处不画：过大，或太接近死点"),
    "page.not reached": ("The mechanism does not get here", "机构到不了此位置"),
    "page.not drawn": (
        "Not drawn here, between the calculated positions: it would not be exact. Move a driver a little further.",
        "此处位于计算位置之间，画出会不够准确，故不画；请将原动件再移动一点。",
    ),
    "page.values": ("Results", "结果"),
    "page.steps": ("Construction", "作图步骤"),
    "page.step": ("Step {step} of {count}", "第 {step} 步，共 {count} 步"),
    "page.all steps": ("Whole drawing; step through it with the arrows.", "完整图形；用箭头逐步作图。"),
    "page.not told": ("– : not known well enough between the calculated positions.", "– ：在两个计算位置之间，数值不够准确，不予给出。"),
    "page.next": ("Next step", "下一步"),
    "page.back": ("Step back", "上一步"),
    "page.whole": ("Whole", "全部"),
    "page.layers": ("Show", "显示"),
    "page.layer names": ("Letters", "字母"),
    "page.layer images": ("Velocity and acceleration images", "速度影像和加速度影像"),
    "page.layer coriolis": ("Coriolis accelerations", "科氏加速度"),
    "page.point": ("Point at an arrow, or at a word that is underlined.", "指向图中的矢量，或带下划线的符号。"),
    "page.size": ("{name}: {size} {unit}, {angle}° to +x", "{name}：{size} {unit}，与 +x 成 {angle}°"),
    "page.nothing": ("{name}: 0", "{name}：0"),
    "page.keys": (
        "Arrow keys move the driver (Shift: finer), Page Up and Page Down step, Home shows the whole drawing, Space runs.",
        "左右方向键转动原动件（按住 Shift 更细），Page Up、Page Down 逐步作图，Home 显示完整图形，空格键运行。",
    ),
}
