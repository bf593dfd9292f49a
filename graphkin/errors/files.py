"""Errors of a mechanism file: the file as a whole, which is not there, not text, or not TOML; then single keys and values:
unknown, missing, of the wrong type or unit, names badly formed."""

from __future__ import annotations

from typing import get_args

from graphkin.errors.base import AboutText, Choice, Lang, LocatedError, Where, WordTable


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


KINDS: WordTable = {
    "text": ("a text in quotes", "带引号的文字"),
    "name": ("a name in quotes", "带引号的名称"),
    "title": ("a text in quotes, or { en = \"..\", zh = \"..\" }",
              "带引号的文字或 { en = \"..\", zh = \"..\" }"),
    "quantity": ("a number, or a text such as \"24 in\"", "数，或带单位的文字（如 \"24 in\"）"),
    "number": ("a number", "数"),
    "numbers": ("a list of numbers", "数的列表"),
    "count": ("a whole number, 0 or more", "不小于 0 的整数"),
    "pencil": ("a text \"MM,DEG\", or two numbers", "文字 \"MM,DEG\" 或两个数"),
    "texts": ("a list of texts", "文字的列表"),
    "file": ("a file's name", "文件名"),
    "executor": ("an executor of concurrent.futures", "concurrent.futures 的执行器"),
    "flag": ("true or false", "true 或 false"),
    "list": ("a list in [ ]", "用 [ ] 括起的列表"),
    "place": ("a list of two lengths, [x, y]", "两个长度的列表 [x, y]"),
    "anchor": ("a point's name in quotes, or [x, y]", "带引号的点名或 [x, y]"),
    "triple": ("three points such as [\"B\", \"C\", \"E\"], or a list of such triples",
               "三个点，如 [\"B\", \"C\", \"E\"]，或若干这样的三点组"),
    "table": ("a table: [name], or keys in { }", "表：[名称]，或用 { } 括起的键"),
    "tables": ("tables with double brackets, such as [[slide]]", "双括号表，如 [[slide]]"),
    "point": ("a capital letter, then digits, then primes, such as B, O1 or D'",
              "大写字母后接数字再接撇号，如 B、O1、D'"),
    "vector": ("two different points, such as AB or O1A", "两个不同的点，如 AB、O1A"),
    "measure": ("two points for a length (AB), three for an angle (BDE), or points, ccw, shape",
                "两点表示长度（AB），三点表示角度（BDE），或 points、ccw、shape"),
    "link": ("letters, digits, _ and '", "字母、数字、_ 和 '"),
    "slide": ("letters, digits, _, - and '; c0, c1, .. are taken",
              "字母、数字、_、- 和 '；c0、c1 等为保留名"),
}  # fmt: skip
"""The kinds of value that can be expected somewhere, in words."""

QUANTITIES: WordTable = {
    "length": ("a length", "长度"),
    "angle": ("an angle", "角度"),
    "angular velocity": ("an angular velocity", "角速度"),
    "angular acceleration": ("an angular acceleration", "角加速度"),
    "velocity": ("a velocity", "速度"),
    "acceleration": ("an acceleration", "加速度"),
}


class UnknownKey(Choice):
    en = "{where}: the key {given} means nothing here. {hint}"
    zh = "{where}：此处没有 {given} 这个键。{hint}"


class UnitAsKey(AboutText):
    key: str
    value: str
    en = "{where}: {given} is a unit, not a key. Write {key} = \"{value}\"."
    zh = "{where}：{given} 是单位，不是键。请写成 {key} = \"{value}\"。"


class UnknownPoint(Choice):
    en = "{where}: there is no point {given} here. {hint}"
    zh = "{where}：此处没有点 {given}。{hint}"


class UnknownLink(Choice):
    en = "{where}: there is no link {given}. {hint}"
    zh = "{where}：没有构件 {given}。{hint}"


class UnknownSlide(Choice):
    en = "{where}: no sliding pair or rolling pair on a line has the name {given}; give it one with name = .. {hint}"
    zh = "{where}：没有名为 {given} 的移动副或直线滚动副，请用 name = .. 为其命名。{hint}"


class NotOneOf(Choice):
    en = "{where}: {given} is not one of the words that can stand here. {hint}"
    zh = "{where}：此处不能写 {given}。{hint}"


def among(words: object, **arguments: str | None) -> None:
    """Arguments of a call that have a Literal's words, or are left out. Raises NotOneOf."""
    for name, given in arguments.items():
        if given is not None and given not in get_args(words):
            raise NotOneOf(Where(name), str(given), get_args(words))


class UnknownUnit(Choice, quantity=QUANTITIES):
    quantity: str
    en = "{where}: {given} is not a unit graphkin knows; {quantity} is needed. {hint}"
    zh = "{where}：不认识单位 {given}，此处应为{quantity}。{hint}"


class OtherDimension(Choice, quantity=QUANTITIES, found=QUANTITIES):
    quantity: str
    found: str
    en = "{where}: {given} is the unit of {found}, but {quantity} is needed. {hint}"
    zh = "{where}：{given} 是{found}的单位，此处应为{quantity}。{hint}"


class NoUnit(Choice):
    en = "{where}: \"{given}\" has no unit. Leave the quotes out, or add a unit. {hint}"
    zh = "{where}：“{given}”没有单位，请去掉引号或加上单位。{hint}"


class NotANumber(AboutText):
    en = "{where}: \"{given}\" does not read as a number with a unit. Write it like \"24 in\" or \"120 r/min\"."
    zh = "{where}：“{given}”不能读作带单位的数，请写成 \"24 in\" 或 \"120 r/min\" 的形式。"


class OutOfRange(AboutText):
    en = "{where}: {given} is not a finite number of reasonable size. Write an ordinary number."
    zh = "{where}：{given} 不是大小合理的有限数，请写普通的数。"


class NotBetween(AboutText):
    least: float
    most: float
    en = "{where}: {given} will not do: a number from {least:,.0f} to {most:,.0f} is wanted here. Correct it."
    zh = "{where}：{given} 不合要求，此处应为 {least:.0f} 到 {most:.0f} 的数，请改正。"


class TooSmall(AboutText):
    least: str
    en = "{where}: {given} will not do, the value must be greater than 0 (at least {least}). Correct it."
    zh = "{where}：{given} 不合要求，数值必须大于 0（不小于 {least}），请改正。"


class Negative(AboutText):
    en = "{where}: {given} is negative; a radius is 0 (a knife edge) or more. Correct it."
    zh = "{where}：{given} 为负；半径应为 0（尖点）或正数，请改正。"


class AngleRange(LocatedError):
    given_deg: float
    en = "{where}: {given_deg:g} deg; an angle between two lines of a link lies between 0 and 180 deg. Say with ccw which way it opens."
    zh = "{where}：{given_deg:g}°；构件上两线的夹角应在 0° 到 180° 之间，张开方向用 ccw 给出。"


class MissingKey(LocatedError):
    key: str
    en = "{where}: {key} is missing. Add it."
    zh = "{where}：缺少 {key}，请补上。"


class KeyClash(LocatedError):
    first: str
    second: str
    en = "{where}: {first} and {second} cannot stand together. Leave one of them out."
    zh = "{where}：{first} 与 {second} 不能同时给出，请去掉其一。"


_MEANINGLESS: WordTable = {
    "tilt": ("a block of one point takes its direction from the line (one that has a second point, such as BQ = 30, "
             "has its own)", "单点滑块的方向就是导路方向（若有自身方向，请给它第二个点，例如 BQ = 30）"),
    "pin": ("a pin in a slot may turn", "销在槽中可以转动"),
    "own line": ("a guide of one point that slides on nothing is its own line (for a line at an angle give the link a "
                 "second point, such as CQ = 30, and measure from = \"CQ\")",
                 "只有一个点、不在其他构件上滑动的导路以自身轴线为导路（若导路与轴线成角度，请给该构件第二个点，例如 CQ = 30，并用 from = \"CQ\"）"),
    "circle": ("it belongs to a line, and this is a circle", "它只用于直线，而此处是圆"),
    "line": ("it belongs to a circle, and this is a line", "它只用于圆，而此处是直线"),
    "slide": ("it belongs to a turning driver, and a slide is driven by at, velocity, acceleration",
              "它用于转动原动件；移动副用 at、velocity、acceleration 驱动"),
    "vector": ("it belongs to a driven slide, and a vector is driven by angle, omega, alpha",
               "它用于移动副；转动原动件用 angle、omega、alpha 驱动"),
    "spin": ("a wheel whose own direction does not matter has omega and alpha only",
             "不计自身方位的轮只需 omega 和 alpha"),
}


class NoMeaning(LocatedError, why=_MEANINGLESS):
    key: str
    why: str
    en = "{where}: {key} has no meaning here: {why}. Leave it out."
    zh = "{where}：此处的 {key} 没有意义：{why}。请删去。"


class WrongType(LocatedError, expected=KINDS):
    expected: str
    given: str
    en = "{where}: {given} stands where {expected} is needed. Replace it."
    zh = "{where}：此处应为{expected}，而不是 {given}，请改正。"


class RangeHere(LocatedError):
    en = "{where}: a range stands where one number is needed. Replace it; or let `graphkin problems` write files with numbers of the range."
    zh = "{where}：此处应为一个数，而不是范围。请改成一个数，或用 graphkin problems 由范围生成各题的文件。"


class WrongCount(LocatedError):
    expected: int
    given: int
    en = "{where}: the list needs {expected} items, not {given}. Add or remove some."
    zh = "{where}：列表有 {given} 项，应为 {expected} 项，请增减。"


class BadName(WrongType):
    en = "{where}: {given}{odd} is not formed as it must be: {expected}. Rename it."
    zh = "{where}：{given}{odd} 的写法不对，应为：{expected}。请改名。"

    def _words(self, lang: Lang) -> dict[str, object]:
        """A letter of another alphabet may look as it should: its number shows the difference."""
        odd = next((letter for letter in str(self.given) if not letter.isascii()), "")
        code = f"（其中 {odd} 是 U+{ord(odd):04X}）" if lang == "zh" and odd else f" ({odd} is U+{ord(odd):04X})" if odd else ""
        return {**super()._words(lang), "odd": code}


class LongName(AboutText):
    most: int
    en = "{where}: the name {given} is too long for a drawing. Shorten it to {most} letters."
    zh = "{where}：名称 {given} 太长，图上写不下。请缩短到 {most} 个字母（汉字按两个计）以内。"


class DuplicateName(AboutText):
    en = "{where}: the name {given} is used already. Choose another."
    zh = "{where}：名称 {given} 已被使用，请另取一个。"
