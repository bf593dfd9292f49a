"""Phrases of every subject: signs between, senses."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    "common.note": (" ({note})", "（{note}）"),
    "common.place": ("({x}, {y})", "({x}, {y})"),
    "common.and": (", ", "，"),
    "common.broken off": ("Aborted!", "已中断。"),
    "common.list": (", ", "、"),
    "common.semicolon": ("; ", "；"),
    "common.colon": (": ", "："),
    "common.way round": ("{way} {sense}", "{way} {sense}"),
    "common.ccw": ("counter-clockwise", "逆时针"),
    "common.cw": ("clockwise", "顺时针"),
}
