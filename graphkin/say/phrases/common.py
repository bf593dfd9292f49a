"""What every subject says: signs between, senses."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "note": (" ({note})", "（{note}）"),
    "and": (", ", "，"),
    "broken off": ("Aborted!", "已中断。"),
    "list": (", ", "、"),
    "semicolon": ("; ", "；"),
    "colon": (": ", "："),
    "way round": ("{way} {sense}", "{way} {sense}"),
    "ccw": ("counter-clockwise", "逆时针"),
    "cw": ("clockwise", "顺时针"),
}
