"""Errors of printed sheets: their lists, whose they are, and what is measured on them, in this order."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, LocatedError, WordTable, listed
from graphkin.errors.homework import PLANES

__all__ = ["NoSheetList", "NoSheetsKnown", "NothingToGoOn", "NothingToScan", "SheetTwice", "UnknownSheet", "UnsureDrawing"]


class NoSheetList(LocatedError):
    """Neither a list of printed sheets, nor what was measured on them."""

    en = "{where}: this is not as graphkin wrote it. Take the sheets.json of handout --scan, or save the page of grade --confirm anew."
    zh = "{where}：文件内容与 graphkin 所写的不符。请用 handout --scan 生成的 sheets.json，或在 grade --confirm 的网页上重新保存。"


class NoSheetsKnown(LocatedError):
    en = "{where}: to measure a picture of paper, put the sheets.json that graphkin handout --scan wrote beside KEY, or say --sheets FILE."
    zh = "{where}：量取照片须知道纸上印了什么。请把 graphkin handout --scan 生成的 sheets.json 放在 KEY 旁，或用 --sheets 指出。"


class NothingToScan(GraphkinError):
    en = "--scan is for paper that is drawn on: a solution leaves nothing to measure. Take --stage blank, or leave --scan out."
    zh = "--scan 用于供学生作图的纸，solution 阶段没有可量取的内容。请用 --stage blank，或去掉 --scan。"


class NothingToGoOn(GraphkinError):
    en = "--upto says how far a half-worked solution goes. Take --stage half, or leave --upto out."
    zh = "--upto 规定半成解答做到哪一步。请用 --stage half，或去掉 --upto。"


class UnknownSheet(LocatedError):
    number: int
    en = "{where}: sheet #{number} is not in the list, or of another problem. Name the sheets.json with which it was printed: --sheets FILE"
    zh = "{where}：第 #{number} 号纸不在清单中，或属于另一题。请用 --sheets 给出打印该纸时生成的 sheets.json。"


class SheetTwice(LocatedError):
    number: int
    kept: str
    id: ClassVar[str] = "sheet-twice"
    en = "{where}: what is on sheet #{number} is on {kept}, too, which is read better and counts."
    zh = "{where}：第 #{number} 号纸上的图在 {kept} 中也有，该份读得更清楚，以其为准。"


_REASONS: WordTable = {
    "blank": ("nothing is seen that was drawn", "看不到所画的图"),
    "outside": ("a part of the paper is not on the picture", "作图区未全部拍入"),
    "no ink": ("where they should lie there is no line", "应有线处没有线"),
    "short": ("the lines are too short to be measured", "线段太短，无法量准"),
    "flat": ("the lines cross at too flat an angle", "两线夹角太小，交点量不准"),
    "alike": ("two drawings fit as well", "有两种画法都相符"),
    "unexplained": ("there are lines that belong to no known drawing", "有不属于任何已知画法的线"),
    "far": ("they lie where no known drawing has them", "其位置与任何已知画法都不符"),
    "twice": ("it is there twice, and drawn differently", "有两份，且所画不同"),
    "lost": ("it may be on a picture that could not be read", "可能在未能识读的照片上"),
}


_NOT_COUNTED = "It is not counted", "暂不计入"
_AS_KNOWN = "It is known to {off} mm, and is counted where that is exact enough", "误差约 {off} mm，精度足够时才计入"


class UnsureDrawing(LocatedError, plane=PLANES, reason=_REASONS):
    """What a photograph does not surely show: points of a polygon, or all of it; off: their standard deviation [mm], 0
    where none is known."""

    plane: str
    reason: str
    letters: tuple[str, ...] = ()
    off: float = 0.0
    id: ClassVar[str] = "unsure"
    en = "{where}: look at the {plane} polygon{points}: {reason}. {counted}."
    zh = "{where}：请核对{plane}多边形{points}：{reason}，{counted}。"

    def _words(self, lang: Lang) -> dict[str, object]:
        points = f"{'：' if lang == 'zh' else ', '}{listed(self.letters, lang)}" if self.letters else ""
        en, zh = _AS_KNOWN if self.off else _NOT_COUNTED
        counted = (zh if lang == "zh" else en).format(off=f"{self.off:.1f}")
        return {**super()._words(lang), "points": points, "counted": counted}
