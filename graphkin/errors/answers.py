"""Errors in answers: what they name, how they are written, and what a drawing of them lacks."""

from __future__ import annotations

from graphkin.errors.base import Choice, Lang, LocatedError

__all__ = [
    "AnsweredTwice", "LetterTwice", "NoLetters", "NoPaperScale", "NoScaleDrawn", "NoSenseDrawn", "NotAQuestion",
    "NotAnAnswer", "OffTheDrawing", "SenseDisputed",
]  # fmt: skip


class OffTheDrawing(LocatedError):
    """Quantities that nobody wrote down, and that the drawing determines: no fault, but said."""

    quantities: tuple[str, ...]
    en = "{where}: read from the drawing: {quantities} (its arrow over the length of the link, with the arrow's sense)."
    zh = "{where}：由图量得：{quantities}（所画矢量的大小除以杆长，转向由矢量判定）。"


class NoSenseDrawn(LocatedError):
    """Rotations whose arrow is drawn along the link, where it turns the link neither way."""

    quantities: tuple[str, ...]
    en = "{where}: {quantities} cannot be read from the drawing: its arrow lies along the link."
    zh = "{where}：无法由图量得 {quantities}：所画矢量沿杆的方向。"


class NotAQuestion(Choice):
    """A name of an answer that means nothing for this mechanism."""

    en = "{where}: {given!r} names no quantity of this mechanism and is passed over. {hint}"
    zh = "{where}：{given!r} 不是本机构的量，已略过。{hint}"


class NotAnAnswer(LocatedError):
    given: str
    en = "{where}: {given!r} does not read as a value. Write a number, with its unit and sense where wanted: \"62.2 rad/s^2 ccw\"."
    zh = "{where}：{given!r} 不能读作数值。请写数，必要时带单位和转向，例如 \"62.2 rad/s^2 逆时针\"。"


class AnsweredTwice(LocatedError):
    """Two different values for one question."""

    question: str
    first: str
    second: str
    en = "{where}: {question} is answered twice, {first!r} and {second!r}. Leave one."
    zh = "{where}：{question} 有两个答案 {first!r} 和 {second!r}，请只保留一个。"


class SenseDisputed(LocatedError):
    """A word for the sense that contradicts the sign, or both words."""

    given: str
    en = "{where}: sign and words of {given!r} say different senses. Counter-clockwise is positive; write one of both."
    zh = "{where}：{given!r} 的正负号与转向文字不一致。逆时针为正，请只写其中一种。"


class NoPaperScale(LocatedError):
    """A length on paper, and no scale to read it with."""

    given: str
    key: str
    en = "{where}: {given!r} is a length on paper, and its scale is missing. State it: [scales] {key} = 0.01"
    zh = "{where}：{given!r} 是图上长度，但未给出比例尺。请写明：[scales] {key} = 0.01"


class NoLetters(LocatedError):
    """A drawing none of whose polygon points is lettered."""

    letters: tuple[str, ...]
    en = "{where}: no point of a polygon is lettered here. Letter them {letters} and hand the drawing in anew."
    zh = "{where}：图中没有标注字母的多边形顶点。请标注 {letters} 后重新提交。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "letters": ", ".join(self.letters[:12])}


class LetterTwice(LocatedError):
    """A letter that stands at two places, or beside two points alike."""

    letter: str
    en = "{where}: it is not clear which point the letter {letter} belongs to. Put it beside its point, and only there."
    zh = "{where}：无法确定字母 {letter} 标注的是哪一点。请把它写在该点旁边，且只写一次。"


class NoScaleDrawn(LocatedError):
    """A polygon whose scale is neither stated nor to be had from its known first vector."""

    plane: str
    key: str
    en = "{where}: the {plane} polygon has no scale. Write it on the drawing ({key} = 0.01), or draw the known first vector."
    zh = "{where}：{plane}多边形没有比例尺。请在图上写明（{key} = 0.01），或画出已知的第一个矢量。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "plane": _PLANES[self.plane][lang]}


_PLANES: dict[str, dict[Lang, str]] = {
    "position": {"en": "position", "zh": "位置"},
    "velocity": {"en": "velocity", "zh": "速度"},
    "acceleration": {"en": "acceleration", "zh": "加速度"},
}
