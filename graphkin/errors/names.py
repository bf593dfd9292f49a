"""Errors of names: not formed as they must be, too long, taken."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, Where
from graphkin.errors.keys import WrongType

__all__ = ["BadName", "DuplicateName", "LongName"]


class BadName(WrongType):
    """A name or key that is not formed as its kind is."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given}{odd} is not formed as it must be: {expected}. Rename it.",
        "zh": "{where}：{given}{odd} 的写法不对，应为：{expected}。请改名。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        """A letter of another alphabet may look as it should: it is told by its number."""
        odd = next((letter for letter in str(self.given) if not letter.isascii()), "")
        told = f"（其中 {odd} 是 U+{ord(odd):04X}）" if lang == "zh" and odd else f" ({odd} is U+{ord(odd):04X})" if odd else ""
        return {**super()._words(lang), "odd": told}


class LongName(GraphkinError):
    """A name that no drawing has room for."""

    where: Where
    given: str
    most: int
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the name {given} is too long for a drawing. Shorten it to {most} letters.",
        "zh": "{where}：名称 {given} 太长，图上写不下。请缩短到 {most} 个字母（汉字按两个计）以内。",
    }


class DuplicateName(GraphkinError):
    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the name {given} is used already. Choose another.",
        "zh": "{where}：名称 {given} 已被使用，请另取一个。",
    }
