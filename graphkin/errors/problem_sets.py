"""Errors of problem sets: how they are made, what goes to teaching platforms, what is read back from their tables."""

from __future__ import annotations

from graphkin.errors.base import GraphkinError, Lang, LocatedError

__all__ = ["NoRange", "NoRightNumber", "NoVariant", "NotAResult", "NotATemplate", "NotAnOverride", "NotForPlatform"]


class NotATemplate(LocatedError):
    """A template without anything that varies."""

    en = "{where}: nothing varies here. Give a number as a range: AB = {{ from = 20, to = 30, step = 1 }}"
    zh = "{where}：这里没有可变的量。请把某个数写成范围：AB = {{ from = 20, to = 30, step = 1 }}"


class NoRange(LocatedError):
    """A range that gives no values."""

    en = "{where}: this is no range. Write {{ from = 20, to = 30, step = 1 }}: finite, from below to, step above 0, at most 100000 values."
    zh = "{where}：这不是有效的范围。请写成 {{ from = 20, to = 30, step = 1 }}：有限数，from 小于 to，step 大于 0，最多 100000 个值。"


class NoVariant(LocatedError):
    """No draw of a student's numbers gave a problem that can be solved on paper; `refused` says what for, how often;
    `question` is one that a pencil tells in none of them, `part` how much of the answer may be off at best."""

    student: str
    tries: int
    refused: tuple[tuple[str, int], ...]
    question: str = ""
    part: float = 0.0
    en = (
        "{where}: none of {tries} draws for student {student!r} can be solved well on paper ({refused}). {untold}Narrow "
        "the ranges to where the mechanism moves well, or widen them if too few variants are left."
    )
    zh = "{where}：为学生 {student!r} 抽取 {tries} 次均得不到适合作图的题目（{refused}）。{untold}请把范围缩小到机构运动良好的区域，若可选的题目太少则放宽范围。"

    def _words(self, lang: Lang) -> dict[str, object]:
        reasons = {"en": ", ", "zh": "，"}[lang].join(f"{_REFUSED[what][lang]}: {times}" for what, times in self.refused)
        untold = _UNTOLD[lang].format(question=self.question, part=self.part) if self.question else ""
        return {**super()._words(lang), "refused": reasons, "untold": untold}


_REFUSED: dict[str, dict[Lang, str]] = {
    "assembly": {"en": "does not assemble", "zh": "不能装配"},
    "dead point": {"en": "near a dead point", "zh": "接近死点"},
    "short": {"en": "a vector too short to measure", "zh": "矢量太短"},
    "taken": {"en": "like another student's", "zh": "与其他学生相同"},
    "untold": {"en": "an answer that a pencil cannot tell", "zh": "所求量作图误差过大"},
    "unlike": {"en": "an answer of another accuracy than others have", "zh": "所求量的作图精度与其他题相差过大"},
}
_UNTOLD: dict[Lang, str] = {
    "en": "A pencil gives {question} to within {part:.0%} at best, which tells nothing: ask for another quantity, move the "
    "ranges, state finer [scales], or allow for a finer pencil with --pencil. ",
    "zh": "作图求 {question} 的允差至少为 {part:.0%}，无法评判：请改求其他量、改变范围、在 [scales] 中取更大的图，或用 --pencil 指定更细的铅笔。",
}


class NotForPlatform(GraphkinError):
    """A number that the platform cannot hold."""

    platform: str
    question: str
    part: str
    number: str
    en = (
        "Problem {question}: {platform} cannot ask for {part} = {number}: it rounds answers below 0.0001 to 0. Change "
        "the mechanism's dimensions or speeds so that the answer is larger, or leave {part} out."
    )
    zh = "题目 {question}：{platform} 会把小于 0.0001 的答案舍为 0，无法考查 {part} = {number}。请改变机构尺寸或速度使答案变大，或不要求 {part}。"


class NoRightNumber(GraphkinError):
    """A right number, a tolerance or points that are no number."""

    question: str
    part: str
    en = "Problem {question}: the right value, the tolerance or the points of {part} are no finite number. Make the key anew."
    zh = "题目 {question}：{part} 的正确值、允差或分值不是有限数，请重新生成答案。"


class NotAResult(LocatedError):
    """A line of a results file that is no result."""

    reason: str
    en = "{where}: this is no result that graphkin wrote ({reason}). Mark the submissions again."
    zh = "{where}：这不是 graphkin 写的成绩记录（{reason}），请重新评阅。"


class NotAnOverride(LocatedError):
    """A cell of the column `override` that is no number of points."""

    given: str
    en = "{where}: {given!r} in the column override is no number of points. Write a number from 0 up, or leave it empty."
    zh = "{where}：override 列中的 {given!r} 不是分数。请填不小于 0 的数，或留空。"
