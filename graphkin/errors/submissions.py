"""Errors in what is handed in: files, answers, drawings, classes; and in what problem sets are made of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

from graphkin.errors.base import Choice, GraphkinError, Lang, Where

__all__ = [
    "AnsweredTwice",
    "BrokenSubmission",
    "HandedTwice",
    "LetterTwice",
    "NamesNobody",
    "NoAnswers",
    "NoLetters",
    "NoPaperScale",
    "NoRange",
    "NoScaleDrawn",
    "NoSenseDrawn",
    "NoStudents",
    "NoVariant",
    "NotAQuestion",
    "NotATemplate",
    "NotAnAnswer",
    "NotMarkable",
    "OffTheDrawing",
    "OwnFault",
    "SenseDisputed",
    "SeveralStudents",
    "StudentTwice",
    "TooMuch",
    "TookTooLong",
    "UnknownStudent",
    "WantsExtra",
]

Words = Mapping[str, Mapping[Lang, str]]


class NotMarkable(GraphkinError):
    """A kind of file that holds neither answers nor a drawing."""

    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: a file of kind {given!r} cannot be read. Hand in .toml, .json, .csv, .xlsx, .svg, .ggb or .dxf.",
        "zh": "{where}：不能读取 {given!r} 类文件。请提交 .toml、.json、.csv、.xlsx、.svg、.ggb 或 .dxf 文件。",
    }


class BrokenSubmission(GraphkinError):
    """Not what its name says; `kind` is what it should be, `reason` the reader's own word."""

    where: Where
    kind: str
    reason: str = ""
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this is not a whole, readable {kind} file{reason}. Save it again and hand it in anew.",
        "zh": "{where}：这不是完整可读的 {kind} 文件{reason}，请重新保存后再提交。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        wrapped = {"en": f" ({self.reason})", "zh": f"（{self.reason}）"}[lang] if self.reason else ""
        return {**super()._words(lang), "reason": wrapped}


_MUCH: Words = {
    "bytes": {"en": "larger than {most} MB", "zh": "超过 {most} MB"},
    "members": {"en": "an archive of more than {most} files", "zh": "压缩包内文件多于 {most} 个"},
    "archive": {"en": "an archive of more than {most} MB", "zh": "压缩包解压后超过 {most} MB"},
    "ratio": {"en": "packed more than {most} to 1, as no honest file is", "zh": "压缩比超过 {most}，不是正常文件"},
    "elements": {"en": "a drawing of more than {most} elements", "zh": "图中元素多于 {most} 个"},
    "depth": {"en": "nested more than {most} deep", "zh": "嵌套超过 {most} 层"},
    "copies": {"en": "a drawing with more than {most} copies", "zh": "图中引用的副本多于 {most} 个"},
    "answers": {"en": "more than {most} answers", "zh": "答案多于 {most} 个"},
    "rows": {"en": "a table of more than {most} rows", "zh": "表格多于 {most} 行"},
    "columns": {"en": "a table of more than {most} columns", "zh": "表格多于 {most} 列"},
}


class TooMuch(GraphkinError):
    """Beyond a limit that no honest submission meets."""

    where: Where
    what: str
    most: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this is {what}. Hand in the answers or the drawing alone.",
        "zh": "{where}：{what}。请只提交答案或图本身。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        most = self.most / 2**20 if self.what in ("bytes", "archive") else self.most
        return {**super()._words(lang), "what": _MUCH[self.what][lang].format(most=f"{most:g}")}


class TookTooLong(GraphkinError):
    where: Where
    seconds: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: not done within {seconds:g} s. Hand in a simpler file.",
        "zh": "{where}：{seconds:g} 秒内未能处理完，请提交更简单的文件。",
    }


class OwnFault(GraphkinError):
    """A fault of graphkin's own, that must not look like a wrong answer."""

    where: Where
    kind: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: graphkin failed to read this file ({kind}); that is no fault of the student's. Mark it by hand, "
        "and report the file.",
        "zh": "{where}：graphkin 未能读取此文件（{kind}），并非学生的错误。请人工评阅，并报告该文件。",
    }


class WantsExtra(GraphkinError):
    """A format that an optional package reads."""

    where: Where
    kind: str
    package: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: reading {kind} files needs the package {package}. Install it with: pip install {package}",
        "zh": "{where}：读取 {kind} 文件需要软件包 {package}，请运行：pip install {package}",
    }


class UnknownStudent(GraphkinError):
    where: Where
    student: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the key has no student {student!r}. Check the id in the file, or mark with this student's own key.",
        "zh": "{where}：答案库中没有学生 {student!r}。请检查文件中的学号，或使用该学生自己的答案库。",
    }


class HandedTwice(GraphkinError):
    """A second submission of one student."""

    where: Where
    student: str
    first: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: student {student!r} handed in {first} before, which is marked; this one is not. Leave one of the two.",
        "zh": "{where}：学生 {student!r} 先提交了 {first}，已按该份批改，这一份不再批改。请只保留其中一份。",
    }


class NoStudents(GraphkinError):
    where: Where
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: no student is listed here. Write a table with a column \"student\" (or 学号), one a row.",
        "zh": "{where}：这里没有学生名单。请写一张含“学号”（或 student）列的表，每行一人。",
    }


class StudentTwice(GraphkinError):
    where: Where
    student: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: student {student!r} stands in the list twice. Leave each id once.",
        "zh": "{where}：名单中学生 {student!r} 出现两次，每个学号只保留一次。",
    }


class NoAnswers(GraphkinError):
    where: Where
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: no answer is found here. Write each as question = value, for example \"omega 3\" = 3.92.",
        "zh": "{where}：未找到任何答案。请写成 问题 = 数值 的形式，例如 \"omega 3\" = 3.92。",
    }  # fmt: skip


class SeveralStudents(GraphkinError):
    """A class table among files of single students, of which anybody's may be."""

    where: Where
    first: str
    second: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this table has rows of {first!r} and of {second!r}, and stands among files of one student each. "
        "Give it to graphkin grade by itself.",
        "zh": "{where}：此表含学生 {first!r} 与 {second!r} 各自的行，却放在每人一份的文件之中。请将此表单独交给 graphkin grade 评阅。",
    }


class NamesNobody(GraphkinError):
    """A row of a class table without an id, below rows with one."""

    where: Where
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this row names no student. Write the id in its column.",
        "zh": "{where}：此行没有学号。请在学号一列填写。",
    }


class OffTheDrawing(GraphkinError):
    """Quantities that nobody wrote down, and that the drawing determines: no fault, but said."""

    where: Where
    quantities: tuple[str, ...]
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: read from the drawing: {listed} (its arrow over the length of the link, with the arrow's sense).",
        "zh": "{where}：由图量得：{listed}（所画矢量的大小除以杆长，转向由矢量判定）。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "listed": _listed(self.quantities, lang)}


class NoSenseDrawn(GraphkinError):
    """Rotations whose arrow is drawn along the link, where it turns the link neither way."""

    where: Where
    quantities: tuple[str, ...]
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {listed} cannot be read from the drawing: its arrow lies along the link.",
        "zh": "{where}：无法由图量得 {listed}：所画矢量沿杆的方向。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "listed": _listed(self.quantities, lang)}


def _listed(names: tuple[str, ...], lang: Lang) -> str:
    return ("、" if lang == "zh" else ", ").join(names)


class NotAQuestion(Choice):
    """A name of an answer that means nothing for this mechanism."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} names no quantity of this mechanism and is passed over. {hint}",
        "zh": "{where}：{given!r} 不是本机构的量，已略过。{hint}",
    }


class NotAnAnswer(GraphkinError):
    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} does not read as a value. Write a number, with its unit and sense where wanted: "
        "\"62.2 rad/s^2 ccw\".",
        "zh": "{where}：{given!r} 不能读作数值。请写数，必要时带单位和转向，例如 \"62.2 rad/s^2 逆时针\"。",
    }  # fmt: skip


class AnsweredTwice(GraphkinError):
    """Two different values for one question."""

    where: Where
    question: str
    first: str
    second: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {question} is answered twice, {first!r} and {second!r}. Leave one.",
        "zh": "{where}：{question} 有两个答案 {first!r} 和 {second!r}，请只保留一个。",
    }


class SenseDisputed(GraphkinError):
    """A word for the sense that contradicts the sign, or both words."""

    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: sign and words of {given!r} say different senses. Counter-clockwise is positive; write one of both.",
        "zh": "{where}：{given!r} 的正负号与转向文字不一致。逆时针为正，请只写其中一种。",
    }


class NoPaperScale(GraphkinError):
    """A length on paper, and no scale to read it with."""

    where: Where
    given: str
    key: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} is a length on paper, and its scale is missing. State it: [scales] {key} = 0.01",
        "zh": "{where}：{given!r} 是图上长度，但未给出比例尺。请写明：[scales] {key} = 0.01",
    }


class NoLetters(GraphkinError):
    """A drawing none of whose polygon points is lettered."""

    where: Where
    letters: tuple[str, ...]
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: no point of a polygon is lettered here. Letter them {letters} and hand the drawing in anew.",
        "zh": "{where}：图中没有标注字母的多边形顶点。请标注 {letters} 后重新提交。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "letters": ", ".join(self.letters[:12])}


class LetterTwice(GraphkinError):
    """A letter that stands at two places, or beside two points alike."""

    where: Where
    letter: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: it is not clear which point the letter {letter} belongs to. Put it beside its point, and only there.",
        "zh": "{where}：无法确定字母 {letter} 标注的是哪一点。请把它写在该点旁边，且只写一次。",
    }


class NoScaleDrawn(GraphkinError):
    """A polygon whose scale is neither stated nor to be had from its known first vector."""

    where: Where
    plane: str
    key: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the {plane} polygon has no scale. Write it on the drawing ({key} = 0.01), or draw the known first vector.",
        "zh": "{where}：{plane}多边形没有比例尺。请在图上写明（{key} = 0.01），或画出已知的第一个矢量。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "plane": _PLANES[self.plane][lang]}


_PLANES: Words = {
    "position": {"en": "position", "zh": "位置"},
    "velocity": {"en": "velocity", "zh": "速度"},
    "acceleration": {"en": "acceleration", "zh": "加速度"},
}


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
