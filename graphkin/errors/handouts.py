"""Errors in what a handout is set with: fonts and their letters."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang

__all__ = ["NoChineseLetters", "NoFont", "NoLetter"]


class NoChineseLetters(GraphkinError):
    """A Chinese handout on a machine without Chinese letters."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "No Chinese font was found, so Chinese text would be printed as boxes. Install one (on Debian: "
        "apt install fonts-noto-cjk), or name a font file: --font PATH, or the environment variable GRAPHKIN_FONT.",
        "zh": "未找到中文字体，中文会印成方框。请安装中文字体（Debian：apt install fonts-noto-cjk），"
        "或用 --font 路径（或环境变量 GRAPHKIN_FONT）指定字体文件。",
    }


class NoFont(GraphkinError):
    """A font that is named and is not there, or is none."""

    path: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{path} is not a font file (.ttf, .otf, .ttc) that can be read. Name another, or leave --font out.",
        "zh": "{path} 不是可读取的字体文件（.ttf、.otf、.ttc）。请另行指定，或不用 --font。",
    }


class NoLetter(GraphkinError):
    """A letter that no font here has."""

    letter: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "No font here has the character {letter!r}, which would be printed as a box. Install one that has "
        "(on Debian: apt install fonts-noto-core fonts-noto-cjk), or name its file with --font PATH.",
        "zh": "现有字体都没有字符 {letter!r}，会印成方框。请安装含该字符的字体"
        "（Debian：apt install fonts-noto-core fonts-noto-cjk），或用 --font 路径指定字体文件。",
    }
