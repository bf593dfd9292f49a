"""Errors in what problem sets are made of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, Where

__all__ = [
    "NoRange",
    "NoVariant",
    "NotATemplate",
]

Words = Mapping[str, Mapping[Lang, str]]


class NotATemplate(GraphkinError):
    """A template without anything that varies."""

    where: Where
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: nothing varies here. Give a number as a range: AB = {{ from = 20, to = 30, step = 1 }}",
        "zh": "{where}：这里没有可变的量。请把某个数写成范围：AB = {{ from = 20, to = 30, step = 1 }}",
    }


class NoRange(GraphkinError):
    """A range that gives no values."""

    where: Where
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this is no range. Write {{ from = 20, to = 30, step = 1 }}: finite, from below to, step above 0, "
        "at most 100000 values.",
        "zh": "{where}：这不是有效的范围。请写成 {{ from = 20, to = 30, step = 1 }}：有限数，from 小于 to，step 大于 0，最多 100000 个值。",
    }


class NoVariant(GraphkinError):
    """No draw of a student's numbers gave a problem that can be solved on paper; `refused` says what for, how often."""

    where: Where
    student: str
    tries: int
    refused: tuple[tuple[str, int], ...]
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: none of {tries} draws for student {student!r} can be solved well on paper ({refused}). Narrow the "
        "ranges to where the mechanism moves well, or widen them if too few variants are left.",
        "zh": "{where}：为学生 {student!r} 抽取 {tries} 次均得不到适合作图的题目（{refused}）。请把范围缩小到机构运动良好的区域，"
        "若可选的题目太少则放宽范围。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        told = {"en": ", ", "zh": "，"}[lang].join(f"{_REFUSED[what][lang]}: {times}" for what, times in self.refused)
        return {**super()._words(lang), "refused": told}


_REFUSED: Words = {
    "assembly": {"en": "does not assemble", "zh": "不能装配"},
    "dead point": {"en": "near a dead point", "zh": "接近死点"},
    "short": {"en": "a vector too short to measure", "zh": "矢量太短"},
    "taken": {"en": "like another student's", "zh": "与其他学生相同"},
}
