"""Errors in what goes to teaching platforms, and in what is read back from their tables."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, Where

__all__ = ["NoRightNumber", "NotAResult", "NotAnOverride", "NotForPlatform"]


class NotForPlatform(GraphkinError):
    """A number that the platform cannot hold."""

    platform: str
    question: str
    part: str
    number: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "Problem {question}: {platform} cannot ask for {part} = {number}: it rounds answers below 0.0001 to 0. "
        "Change the mechanism's dimensions or speeds so that the answer is larger, or leave {part} out.",
        "zh": "题目 {question}：{platform} 会把小于 0.0001 的答案舍为 0，无法考查 {part} = {number}。"
        "请改变机构尺寸或速度使答案变大，或不要求 {part}。",
    }


class NoRightNumber(GraphkinError):
    """A right number, a tolerance or points that are no number."""

    question: str
    part: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "Problem {question}: the right value, the tolerance or the points of {part} are no finite number. "
        "Make the key anew.",
        "zh": "题目 {question}：{part} 的正确值、允差或分值不是有限数，请重新生成答案。",
    }


class NotAResult(GraphkinError):
    """A line of a results file that is no result."""

    where: Where
    reason: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this is no result that graphkin wrote ({reason}). Mark the submissions again.",
        "zh": "{where}：这不是 graphkin 写的成绩记录（{reason}），请重新评阅。",
    }


class NotAnOverride(GraphkinError):
    """A cell of the column `override` that is no number of points."""

    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} in the column override is no number of points. Write a number from 0 up, "
        "or leave it empty.",
        "zh": "{where}：override 列中的 {given!r} 不是分数。请填不小于 0 的数，或留空。",
    }  # fmt: skip
