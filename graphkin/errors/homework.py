"""Errors of homework: keys and marks, what is handed in, the answers in it, problem sets, in this order."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import AboutText, Choice, GraphkinError, Lang, LocatedError, WordTable
from graphkin.errors.drawings import PLANES


class BadKey(LocatedError):
    """A file that is no key, or one that was cut or changed; `what` is the place in it."""

    what: str
    en = "{where}: this is no whole key of graphkin ({what}). Name a key.json that graphkin wrote, or a mechanism."
    zh = "{where}：这不是完整的 graphkin 答案文件（{what}）。请给出 graphkin 生成的 key.json，或机构文件。"


class NothingToMark(LocatedError):
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


class BadPencil(AboutText):
    en = "{where}: {given!r} is no pencil. Write what a length and a direction may be off, in mm and deg: 0.25,0.25."
    zh = "{where}：{given!r} 不是有效的作图误差。请写成长度和方向的误差（mm 和度），如 0.25,0.25。"


class NoSuchProblem(Choice):
    en = "{where}: of several problems none is called {given!r}. Name what is handed in after its problem, with any ending. {hint}"
    zh = "{where}：各题中没有名为 {given!r} 的题目。请用题目名称命名提交的文件或文件夹（后缀不限）。{hint}"


class NoMarks(LocatedError):
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


class NotMarkable(AboutText):
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
    "pixels": {"en": "a picture of more than {most} million pixels", "zh": "图片超过 {most} 百万像素"},
}


class TooMuch(LocatedError):
    what: str
    most: float
    en = "{where}: this is {what}. Hand in the answers or the drawing alone."
    zh = "{where}：{what}。请只提交答案或图本身。"

    def _words(self, lang: Lang) -> dict[str, object]:
        most = self.most / {"bytes": 2**20, "archive": 2**20, "pixels": 1e6}.get(self.what, 1)
        return {**super()._words(lang), "what": _MUCH[self.what][lang].format(most=f"{most:g}")}


class TookTooLong(LocatedError):
    seconds: float
    en = "{where}: not done within {seconds:g} s. Hand in a simpler file."
    zh = "{where}：{seconds:g} 秒内未能处理完，请提交更简单的文件。"


class OwnFault(LocatedError):
    kind: str
    en = "{where}: graphkin failed to read this file ({kind}); that is no fault of the student's. Mark it by hand, and report the file."
    zh = "{where}：graphkin 未能读取此文件（{kind}），并非学生的错误。请人工评阅，并报告该文件。"


class WantsExtra(LocatedError):
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
    student: str
    first: str
    en = "{where}: student {student!r} handed in {first} before, which is marked; this one is not. Leave one of the two."
    zh = "{where}：学生 {student!r} 先提交了 {first}，已按该份批改，这一份不再批改。请只保留其中一份。"


class TwoNames(LocatedError):
    named: str
    student: str
    en = (
        "{where}: by its folder or its name this is of {named!r}, but something beside or in it says {student!r}, who is "
        "another. It is not marked. Rename the file, or take the line out."
    )
    zh = "{where}：按文件夹或文件名，这份属于 {named!r}，而文件名或文件中的一行写的是 {student!r}，二者不是同一人，故不批改。请改正文件名，或删去该行。"


class SameName(LocatedError):
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


class StudentWithoutId(LocatedError):
    student: str
    en = "{where}: {student!r} has no id in the list. Give everybody one, or delete the row."
    zh = "{where}：名单中 {student!r} 没有学号。请补上学号，或删去该行。"


class NoRows(LocatedError):
    en = "{where}: the table has a header and no rows below it. Write a row for each student."
    zh = "{where}：表中只有表头，没有数据行。请为每名学生写一行。"


class ExcelInside(LocatedError):
    en = "{where}: this is an Excel file that has another ending. Give it its own (.xlsx), or save it as CSV."
    zh = "{where}：这是改了扩展名的 Excel 文件。请改回 .xlsx，或另存为 CSV。"


class NoneMarked(GraphkinError):
    count: int
    en = "None of what was handed in could be marked ({count}): the reason stands with each."
    zh = "交来的作业均未能评阅（共 {count} 份），原因见各行。"


class NoAnswers(LocatedError):
    en = "{where}: no answer is found here. Write each as question = value, for example \"omega 3\" = 3.92."
    zh = "{where}：未找到任何答案。请写成 问题 = 数值 的形式，例如 \"omega 3\" = 3.92。"


class NoNumbers(LocatedError):
    """A document in which nothing is read: a picture of the work, or a text."""

    kind: str
    en = "{where}: no answer is read in this {kind} file: it holds a picture, or words. Look at it, and mark it by hand."
    zh = "{where}：此 {kind} 文件中没有可读取的答案（只有图片或文字）。请查看并人工评阅。"


class SeveralStudents(LocatedError):
    first: str
    second: str
    en = (
        "{where}: this table has rows of {first!r} and of {second!r}, and stands among files of one student each. "
        "Give it to graphkin grade by itself."
    )
    zh = "{where}：此表含学生 {first!r} 与 {second!r} 各自的行，却放在每人一份的文件之中。请将此表单独交给 graphkin grade 评阅。"


class NamesNobody(LocatedError):
    en = "{where}: this row names no student. Write the id in its column."
    zh = "{where}：此行没有学号。请在学号一列填写。"


class OffTheDrawing(LocatedError):
    """Quantities that nobody wrote down, and that the drawing determines: no fault, but said."""

    quantities: tuple[str, ...]
    en = "{where}: read from the drawing: {quantities} (its arrow over the length of the link, with the arrow's sense)."
    zh = "{where}：由图量得：{quantities}（所画矢量的大小除以杆长，转向由矢量判定）。"


class NoSenseDrawn(LocatedError):
    """Rotations whose arrow is drawn along the link, where it turns the link neither way."""

    quantities: tuple[str, ...]
    en = "{where}: {quantities} cannot be read from the drawing: its arrow lies along the link."
    zh = "{where}：无法由图量得 {quantities}：所画矢量沿杆的方向。"


class CentresNotMarked(LocatedError):
    """Instant centres that were handed in: they have no place in a key."""

    quantities: tuple[str, ...]
    en = "{where}: not marked here, as places of instant centres are looked at by the teacher: {quantities}."
    zh = "{where}：瞬心位置不自动评阅，请由教师核对：{quantities}。"


class NotAQuestion(Choice):
    en = "{where}: {given!r} names no quantity of this mechanism and is passed over. {hint}"
    zh = "{where}：{given!r} 不是本机构的量，已略过。{hint}"


class BrokenBoard(LocatedError):
    """The file of a drawing board whose data were cut or changed; `what` is the place in them."""

    what: str
    en = "{where}: the data of this drawing board are not whole ({what}). Open the file on the board and hand it in anew."
    zh = "{where}：此画板文件的数据不完整（{what}）。请在画板中打开该文件，重新提交。"


class ForeignBoard(LocatedError):
    en = "{where}: this drawing board is of another problem: its mechanism is not the one that is marked here."
    zh = "{where}：此画板文件是另一题的：其机构与本题不同。"


EXAMPLES: WordTable = {
    "rad": ("105.6°", "105.6°"), "rad/s": ("3.92 rad/s cw", "3.92 rad/s 顺时针"), "rad/s^2": ("62.2 rad/s² ccw", "62.2 rad/s² 逆时针"),
    "m": ("101 mm", "101 mm"), "m/s": ("0.271 m/s 72.5°", "0.271 m/s 72.5°"), "m/s^2": ("4.31 m/s² 163°", "4.31 m/s² 163°"), "1": ("2.8", "2.8"),
}
"""Answers by the SI unit of what is asked."""


class NotAnAnswer(AboutText, unit=EXAMPLES):
    unit: str = "rad/s^2"
    en = "{where}: {given!r} does not read as a value. Write a number, with its unit and sense or direction where wanted: \"{unit}\"."
    zh = "{where}：“{given}”不能读作数值。请写数，必要时带单位和转向或方向，例如“{unit}”。"


class AnsweredTwice(LocatedError):
    question: str
    first: str
    second: str
    en = "{where}: {question} is answered twice, {first!r} and {second!r}. Leave one."
    zh = "{where}：{question} 有两个答案 {first!r} 和 {second!r}，请只保留一个。"


class SenseDisputed(AboutText):
    en = "{where}: sign and words of {given!r} say different senses. Counter-clockwise is positive; write one of both."
    zh = "{where}：{given!r} 的正负号与转向文字不一致。逆时针为正，请只写其中一种。"


class NoPaperScale(AboutText):
    key: str
    en = "{where}: {given!r} is a length on paper, and its scale is missing. State it: [scales] {key} = 0.01"
    zh = "{where}：{given!r} 是图上长度，但未给出比例尺。请写明：[scales] {key} = 0.01"


class NoLetters(LocatedError):
    letters: tuple[str, ...]
    en = "{where}: no point of a polygon is lettered here. Letter them {letters} and hand the drawing in anew."
    zh = "{where}：图中没有标注字母的多边形顶点。请标注 {letters} 后重新提交。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "letters": ", ".join(self.letters[:12])}


class LetterTwice(LocatedError):
    letter: str
    en = "{where}: it is not clear which point the letter {letter} belongs to. Put it beside its point, and only there."
    zh = "{where}：无法确定字母 {letter} 标注的是哪一点。请把它写在该点旁边，且只写一次。"


class NoScaleDrawn(LocatedError, plane=PLANES):
    """A polygon whose scale is neither stated nor to be had from its known first vector."""

    plane: str
    key: str
    en = "{where}: the {plane} polygon has no scale. Write it on the drawing ({key} = 0.01), or draw the known first vector."
    zh = "{where}：{plane}多边形没有比例尺。请在图上写明（{key} = 0.01），或画出已知的第一个矢量。"


class NotATemplate(LocatedError):
    en = "{where}: nothing varies here. Give a number as a range: AB = {{ from = 20, to = 30, step = 1 }}"
    zh = "{where}：这里没有可变的量。请把某个数写成范围：AB = {{ from = 20, to = 30, step = 1 }}"


class NoRange(LocatedError):
    en = (
        '{where}: this is no range. Write {{ from = 20, to = 30, step = 1 }}, or with units {{ from = "2 in", to = "3 in", '
        'step = "0.1 in" }}: finite, from below to, step above 0, at most 100000 values.'
    )
    zh = (
        '{where}：这不是有效的范围。请写成 {{ from = 20, to = 30, step = 1 }}，带单位时写成 {{ from = "2 in", to = "3 in", '
        'step = "0.1 in" }}：有限数，from 小于 to，step 大于 0，最多 100000 个值。'
    )


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
    "elsewhere": {
        "en": "in another assembly than in the middle of the ranges", "zh": "不能由范围中点的装配形式连续到达",
    },
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
    question: str
    part: str
    en = "Problem {question}: the right value, the tolerance or the points of {part} are no finite number. Make the key anew."
    zh = "题目 {question}：{part} 的正确值、允差或分值不是有限数，请重新生成答案。"


class NotAResult(LocatedError):
    reason: str
    en = "{where}: this is no result that graphkin wrote ({reason}). Mark the submissions again."
    zh = "{where}：这不是 graphkin 写的成绩记录（{reason}），请重新评阅。"


class NotAnOverride(AboutText):
    en = "{where}: {given!r} in the column override is no number of points. Write a number from 0 up, or leave it empty."
    zh = "{where}：“教师改分”列中的 {given!r} 不是分数。请填不小于 0 的数，或留空。"


class NotASet(GraphkinError):
    """A folder whose list of students is not one of graphkin's, or names a file that is not there."""

    path: str
    en = (
        "{path}: this is no list of a problem set that graphkin wrote. Write the set again with "
        "`graphkin problems`, or name the mechanism files."
    )
    zh = "{path}：这不是 graphkin 生成的题组清单。请用 `graphkin problems` 重新生成题组，或直接给出机构文件。"
