"""Errors in keys, in how marking is asked for, and in files of marks."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import Choice, GraphkinError, Lang, LocatedError

__all__ = [
    "AnotherStudent", "BadKey", "BadPencil", "NoKeyAtPosition", "NoMarks", "NoSuchProblem", "NothingToMark", "OwnSheet",
    "SaidBefore", "SameNumbers", "TurnedPage",
]  # fmt: skip


class BadKey(LocatedError):
    """A file that is no key, or one that was cut or changed; `what` is the place in it."""

    what: str
    en = "{where}: this is no whole key of graphkin ({what}). Name a key.json that graphkin wrote, or a mechanism."
    zh = "{where}：这不是完整的 graphkin 答案文件（{what}）。请给出 graphkin 生成的 key.json，或机构文件。"


class NothingToMark(LocatedError):
    """A mechanism that asks for no number, and has none on the way."""

    en = "{where}: nothing here can be marked as a number. Write for example ask = [\"omega 3\", \"alpha 3\"]."
    zh = "{where}：没有可以按数值评阅的量。请写成如 ask = [\"omega 3\", \"alpha 3\"]。"


class NoKeyAtPosition(LocatedError):
    """A further position (`also`) that cannot be marked: it is not reached, or not told by where points are."""

    number: int
    problem: GraphkinError | None = None
    en = "{where}: position #{number} cannot be marked{because}. Take another value in also."
    zh = "{where}：位置 #{number} 无法评阅{because}。请在 also 中换一个值。"

    def _words(self, lang: Lang) -> dict[str, object]:
        colon = "：" if lang == "zh" else ": "
        because = "" if self.problem is None else colon + self.problem.message(lang).rstrip(".。")
        return {**super()._words(lang), "because": because}


class BadPencil(LocatedError):
    """Errors of a pencil that are none."""

    given: str
    en = "{where}: {given!r} is no pencil. Write what a length and a direction may be off, in mm and deg: 0.25,0.25."
    zh = "{where}：{given!r} 不是有效的作图误差。请写成长度和方向的误差（mm 和度），如 0.25,0.25。"


class NoSuchProblem(Choice):
    """Something handed in that belongs to none of several problems."""

    en = "{where}: of several problems none is called {given!r}. Name what is handed in after its problem, with any ending. {hint}"
    zh = "{where}：各题中没有名为 {given!r} 的题目。请用题目名称命名提交的文件或文件夹（后缀不限）。{hint}"


class NoMarks(LocatedError):
    """A line of a file of marks that graphkin cannot have written."""

    en = "{where}: this is no record of graphkin's marks. Mark the submissions themselves."
    zh = "{where}：这不是 graphkin 的评阅记录，请重新评阅提交的文件。"


class SaidBefore(GraphkinError):
    """The sentence about a submission from when it was marked first; `id`: of a remark."""

    told: str
    id: str = ""
    en = "{told}"
    zh = "{told}"


class TurnedPage(LocatedError):
    degrees: float
    id: ClassVar[str] = "turned"
    en = "{where}: turned? Its directions are all off by {degrees:.0f}°. Try --turned."
    zh = "{where}：图是否转动过？各方向都偏转 {degrees:.0f}°。请试用 --turned。"


class OwnSheet(LocatedError):
    id: ClassVar[str] = "own-sheet"
    en = "{where}: graphkin's own sheet: its marks, its letters, and every point where it drew them."
    zh = "{where}：这是 graphkin 自己画的图：标记、字母和各点位置都原样未动。"


class AnotherStudent(GraphkinError):
    """Numbers that are right for another student's problem, and not for the own."""

    student: str
    agreeing: int
    count: int
    closely: bool = False
    id: ClassVar[str] = "another-student"
    en = "agrees with {student}'s problem{closely} in {agreeing} of {count}"
    zh = "所交 {count} 个量中有 {agreeing} 个与 {student} 的题目相符{closely}"

    def _words(self, lang: Lang) -> dict[str, object]:
        digits = {"en": " to three digits", "zh": "（前三位数字）"}[lang] if self.closely else ""
        return {**super()._words(lang), "closely": digits}


class SameNumbers(GraphkinError):
    """Numbers that another student has handed in, too, and that are not simply the right ones."""

    student: str
    agreeing: int
    count: int
    en = "the same numbers as {student}, digit by digit, in {agreeing} of {count}"
    zh = "与 {student} 共有的 {count} 个量中有 {agreeing} 个数值逐位相同"
