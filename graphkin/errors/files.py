"""Errors of the file as a whole: it is not there, it is not text, it is not TOML."""

from __future__ import annotations

from graphkin.errors.base import Choice, Lang, LocatedError

__all__ = [
    "BrokenToml", "ControlCharacter", "EmptyFile", "FileTooLarge", "IsFolder", "NoFile", "NotUtf8", "StrayLetter",
    "TooDeep", "UnknownMechanism", "Unreadable",
]  # fmt: skip


class NoFile(Choice):
    """There is no such file; `possible` are the .toml files beside it."""

    en = "{where}: there is no such file. Check the path. {hint}"
    zh = "{where}：没有这个文件，请检查路径。{hint}"


class UnknownMechanism(Choice):
    en = "There is neither a file {given} nor a mechanism of that name in the library. {hint}"
    zh = "没有文件 {given}，机构库中也没有这个名称。{hint}"


class IsFolder(LocatedError):
    en = "{where}: this is a folder. Name a mechanism file (.toml) in it."
    zh = "{where}：这是文件夹，请给出其中的机构文件（.toml）。"


class Unreadable(LocatedError):
    """The operating system refuses; `reason` is its own word."""

    reason: str
    en = "{where}: the file cannot be read ({reason}). Check its name and permissions."
    zh = "{where}：无法读取文件（{reason}），请检查文件名和访问权限。"


class EmptyFile(LocatedError):
    en = "{where}: the file is empty. Write at least [frame], one [links.NAME] and a [[driver]]."
    zh = "{where}：文件是空的，至少应写出 [frame]、一个 [links.名称] 和一个 [[driver]]。"


class FileTooLarge(LocatedError):
    limit_mb: float
    en = "{where}: the file is larger than {limit_mb:g} MB, so it is hardly a mechanism file. Name another."
    zh = "{where}：文件超过 {limit_mb:g} MB，不像机构文件，请换一个文件。"


class NotUtf8(LocatedError):
    """`encoding` is what it is instead, where that is plain; PowerShell's `>` writes UTF-16."""

    encoding: str
    en = "{where}: this is not UTF-8 text but {encoding}. Save the file with the encoding UTF-8."
    zh = "{where}：此处不是 UTF-8 文本，而是{encoding}，请将文件另存为 UTF-8 编码。"

    def _words(self, lang: Lang) -> dict[str, object]:
        unknown = "另一种编码（也许是 GBK）" if lang == "zh" else "in another encoding, perhaps GBK"
        known = f" {self.encoding}" if lang == "zh" and self.encoding else self.encoding
        return {**super()._words(lang), "encoding": known or unknown}


class ControlCharacter(LocatedError):
    code: str
    en = "{where}: the character {code} steers a screen or printer and shows nothing. Remove it from this text."
    zh = "{where}：字符 {code} 是控制字符，不显示任何内容，请从这段文字中删去。"


class BrokenToml(LocatedError):
    reason: str
    en = "{where}: this is not valid TOML: {reason}. Mend this line, or the one above it."
    zh = "{where}：TOML 语法错误（{reason}），请改正这一行或上一行。"


class StrayLetter(LocatedError):
    """A letter of another alphabet, or a full-width sign, that looks as it should."""

    letter: str
    code: str
    en = (
        "{where}: {letter} ({code}) cannot stand outside quotes, where only letters, digits and signs of an English "
        "keyboard can. Type it anew, even if it looks the same; a name of such letters stands in quotes."
    )
    zh = "{where}：引号以外不能有字符 {letter}（{code}），那里只能用英文半角字母、数字和符号；即使看起来一样，也请重新输入；名称中用到时请加引号。"


class TooDeep(LocatedError):
    en = "{where}: brackets or dotted keys are nested far too deep. A mechanism file needs three levels at most."
    zh = "{where}：括号或带点的键嵌套过深，机构文件最多只需三层。"
