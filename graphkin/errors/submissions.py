"""Errors in what is handed in: files, classes, students."""

from __future__ import annotations

from graphkin.errors.base import Lang, LocatedError

__all__ = [
    "BrokenSubmission", "HandedTwice", "NamesNobody", "NoAnswers", "NoNumbers", "NoStudents", "NotMarkable", "OwnFault", "SameName",
    "SeveralStudents", "StudentTwice", "TooMuch", "TookTooLong", "TwoNames", "UnknownStudent", "WantsExtra",
]  # fmt: skip


class NotMarkable(LocatedError):
    """A kind of file that holds neither answers nor a drawing."""

    given: str
    en = "{where}: a file of kind {given!r} cannot be read. Hand in .toml, .json, .csv, .xlsx, .docx, .pdf, .svg, .ggb or .dxf."
    zh = "{where}：不能读取 {given!r} 类文件。请提交 .toml、.json、.csv、.xlsx、.docx、.pdf、.svg、.ggb 或 .dxf 文件。"


class BrokenSubmission(LocatedError):
    """Not what its name says; `kind` is what it should be, `reason` the reader's own word."""

    kind: str
    reason: str = ""
    en = "{where}: this is not a whole, readable {kind} file{reason}. Save it again and hand it in anew."
    zh = "{where}：这不是完整可读的 {kind} 文件{reason}，请重新保存后再提交。"

    def _words(self, lang: Lang) -> dict[str, object]:
        wrapped = {"en": f" ({self.reason})", "zh": f"（{self.reason}）"}[lang] if self.reason else ""
        return {**super()._words(lang), "reason": wrapped}


_MUCH: dict[str, dict[Lang, str]] = {
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


class TooMuch(LocatedError):
    """Beyond a limit that no honest submission meets."""

    what: str
    most: float
    en = "{where}: this is {what}. Hand in the answers or the drawing alone."
    zh = "{where}：{what}。请只提交答案或图本身。"

    def _words(self, lang: Lang) -> dict[str, object]:
        most = self.most / 2**20 if self.what in ("bytes", "archive") else self.most
        return {**super()._words(lang), "what": _MUCH[self.what][lang].format(most=f"{most:g}")}


class TookTooLong(LocatedError):
    seconds: float
    en = "{where}: not done within {seconds:g} s. Hand in a simpler file."
    zh = "{where}：{seconds:g} 秒内未能处理完，请提交更简单的文件。"


class OwnFault(LocatedError):
    """A fault of graphkin's own, that must not look like a wrong answer."""

    kind: str
    en = "{where}: graphkin failed to read this file ({kind}); that is no fault of the student's. Mark it by hand, and report the file."
    zh = "{where}：graphkin 未能读取此文件（{kind}），并非学生的错误。请人工评阅，并报告该文件。"


class WantsExtra(LocatedError):
    """A format that an optional package reads."""

    kind: str
    package: str
    en = "{where}: reading {kind} files needs the package {package}. Install it with: pip install {package}"
    zh = "{where}：读取 {kind} 文件需要软件包 {package}，请运行：pip install {package}"


class UnknownStudent(LocatedError):
    """Nobody of the class; `nearest` are those who are called nearly so."""

    student: str
    nearest: tuple[str, ...] = ()
    en = "{where}: the class has no student {student!r}{near}. Check the id in the file or in its name, or add the student to the class list."
    zh = "{where}：班级中没有学生 {student!r}{near}。请检查文件或文件名中的学号，或在名单中补上该学生。"

    def _words(self, lang: Lang) -> dict[str, object]:
        near = {"en": "; the nearest: ", "zh": "，最接近的是："}[lang] + "; ".join(self.nearest) if self.nearest else ""
        return {**super()._words(lang), "near": near}


class HandedTwice(LocatedError):
    """A second submission of one student."""

    student: str
    first: str
    en = "{where}: student {student!r} handed in {first} before, which is marked; this one is not. Leave one of the two."
    zh = "{where}：学生 {student!r} 先提交了 {first}，已按该份批改，这一份不再批改。请只保留其中一份。"


class TwoNames(LocatedError):
    """The folder or the name of a file names one student, and its name or a line in it another."""

    named: str
    student: str
    en = (
        "{where}: by its folder or its name this is of {named!r}, but something beside or in it says {student!r}, who is "
        "another. It is not marked. Rename the file, or take the line out."
    )
    zh = "{where}：按文件夹或文件名，这份属于 {named!r}，而文件名或文件中的一行写的是 {student!r}，二者不是同一人，故不批改。请改正文件名，或删去该行。"


class SameName(LocatedError):
    """A name that several students have."""

    named: str
    students: tuple[str, ...]
    en = "{where}: {named!r} is the name of {students}: it does not tell whose this is. It is not marked. Add the id to the file's name."
    zh = "{where}：姓名 {named!r} 为 {students} 所共有，无法确定是谁的，故不批改。请在文件名中加上学号。"


class NoStudents(LocatedError):
    en = "{where}: no student is listed here. Write a table with a column \"student\" (or 学号), one a row."
    zh = "{where}：这里没有学生名单。请写一张含“学号”（或 student）列的表，每行一人。"


class StudentTwice(LocatedError):
    student: str
    en = "{where}: student {student!r} stands in the list twice. Leave each id once."
    zh = "{where}：名单中学生 {student!r} 出现两次，每个学号只保留一次。"


class NoAnswers(LocatedError):
    en = "{where}: no answer is found here. Write each as question = value, for example \"omega 3\" = 3.92."
    zh = "{where}：未找到任何答案。请写成 问题 = 数值 的形式，例如 \"omega 3\" = 3.92。"


class NoNumbers(LocatedError):
    """A document in which nothing is read: a picture of the work, or a text."""

    kind: str
    en = "{where}: no answer is read in this {kind} file: it holds a picture, or words. Look at it, and mark it by hand."
    zh = "{where}：此 {kind} 文件中没有可读取的答案（只有图片或文字）。请查看并人工评阅。"


class SeveralStudents(LocatedError):
    """A class table among files of single students, of which anybody's may be."""

    first: str
    second: str
    en = (
        "{where}: this table has rows of {first!r} and of {second!r}, and stands among files of one student each. "
        "Give it to graphkin grade by itself."
    )
    zh = "{where}：此表含学生 {first!r} 与 {second!r} 各自的行，却放在每人一份的文件之中。请将此表单独交给 graphkin grade 评阅。"


class NamesNobody(LocatedError):
    """A row of a class table without an id, below rows with one."""

    en = "{where}: this row names no student. Write the id in its column."
    zh = "{where}：此行没有学号。请在学号一列填写。"
