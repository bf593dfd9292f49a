"""Tables: CSV and XLSX, a row a student or a file each.

A header with a column of ids and questions beside it is a class; rows of question, value (unit, sense) are a student's.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, islice
from typing import IO

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, NoAnswers, TooMuch, WantsExtra, Where
from graphkin.submissions.archives import checked_zip
from graphkin.submissions.questions import begins_like_one
from graphkin.submissions.spelling import plain
from graphkin.submissions.submission import Limits
from graphkin.submissions.texts import lines_of

Cells = Iterator[tuple[int, Sequence[object]]]
"""Rows as they stand, with the number of their line."""

IDS = (
    "student", "student id", "studentid", "student number", "学号", "id", "id number", "学生学号", "考号",
    "sis user id", "sis login id", "identifier", "participant", "username", "user name", "用户名", "user",
    "login", "email", "email address", "学生", "name", "full name", "姓名", "学生姓名",
)  # fmt: skip
"""What a column of ids is called, the most telling first."""
_QUESTION = {"question", "quantity", "name", "item", "问题", "题目", "量", "物理量", "项目"}
_VALUE = {"value", "answer", "result", "given", "数值", "值", "答案", "结果"}
_MORE = {"unit", "units", "单位", "sense", "direction", "转向", "方向"}
_LONGEST_CELL = 1 << 16


@frozen
class TableRow:
    """One student's row, or one student's whole table. `student` is empty where none is named."""

    student: str
    line: int
    entries: tuple[tuple[str, object, int], ...]


def rows_of(cells: Cells, where: Where, limits: Limits) -> Iterator[TableRow]:
    """A row a student where the header says so; else one, with all answers of the table. Raises NoAnswers, TooMuch."""
    filled: Cells = ((line, row) for line, row in cells if any(_shown(cell) for cell in row))
    first = next(filled, None)
    if first is None:
        raise NoAnswers(where)
    if len(first[1]) > limits.columns:
        raise TooMuch(where, "columns", limits.columns)
    header = [_shown(cell)[:200] for cell in first[1]]
    at = _id_column(header)
    second = next(filled, None)
    filled = chain([] if second is None else [second], filled)
    if at is None or _is_question_table(header) or (second is not None and _is_one(header, second[1])):
        yield _one(chain([first], filled), limits)
        return
    for count, (line, row) in enumerate(filled):
        if count >= limits.rows:
            raise TooMuch(where, "rows", limits.rows)
        pairs = enumerate(zip(header, row))
        answers = tuple((name, cell, line) for k, (name, cell) in pairs if name and k != at and not student_of(name))
        yield TableRow(_shown(row[at]) if at < len(row) else "", line, answers)


def student_of(name: str) -> bool:
    """Whether a name in a table of answers stands for the student's id."""
    return plain(name[:60]).lower().replace("_", " ").strip(" :") in IDS


def _id_column(header: Sequence[str]) -> int | None:
    folded = [plain(name).lower().replace("_", " ") for name in header]
    return next((folded.index(name) for name in IDS if name in folded), None)


def _is_question_table(header: Sequence[str]) -> bool:
    folded = {plain(name).lower() for name in header}
    return bool(folded & _QUESTION and folded & _VALUE)


def _is_one(header: Sequence[str], row: Sequence[object]) -> bool:
    """Whether `student, s1` over `omega 3, 3.92` begins one student's table, and no class."""
    return len(header) == 2 and bool(row) and begins_like_one(_shown(row[0])) and not begins_like_one(header[1])


def _one(cells: Iterable[tuple[int, Sequence[object]]], limits: Limits) -> TableRow:
    """A student's own table: question and value beside each other, unit and sense after them."""
    student, entries, names = "", [], None
    for line, row in islice(cells, limits.answers + 2):
        shown = [_shown(cell) for cell in row[:20]]
        if names is None and _is_question_table(shown):
            names = [plain(name).lower() for name in shown]
            continue
        if len(shown) > 1 and student_of(shown[0]):
            student = shown[1]
        elif len(shown) > 1 and shown[0]:
            entries.append((shown[0], _value(row, shown, names), line))
    return TableRow(student, 1, tuple(entries))


def _value(row: Sequence[object], shown: Sequence[str], names: Sequence[str] | None) -> object:
    """The cell itself, or number, unit and sense in cells of their own."""
    if names is None:
        more = [text for text in shown[2:4] if text]
        return row[1] if not more else " ".join([shown[1], *more])
    at = next(k for k, name in enumerate(names) if name in _VALUE)
    if at >= len(row):
        return None
    more = [shown[k] for k, name in enumerate(names[: len(shown)]) if name in _MORE and shown[k]]
    return row[at] if not more or not shown[at] else " ".join([shown[at], *more])


def _shown(cell: object) -> str:
    if isinstance(cell, float) and cell.is_integer() and abs(cell) < 1e15:
        return str(int(cell))
    return "" if cell is None else str(cell).strip()


# --- CSV --------------------------------------------------------------------------------------


def csv_cells(stream: IO[bytes], where: Where) -> Cells:
    """The rows of a CSV in any usual encoding, by comma, semicolon or tabulator. Raises BrokenSubmission."""
    csv.field_size_limit(_LONGEST_CELL)
    lines: Iterator[str] = (line.replace("\0", "") for line in lines_of(stream, where))
    first = next(lines, "")
    if (told := re.fullmatch(r"sep=(.)\s*", first)) is not None:
        delimiter, rest = told[1], lines
    else:
        bare = re.sub(r'"[^"]*"', "", first)
        delimiter, rest = max(",;\t", key=bare.count), chain([first], lines)
    reader = csv.reader(rest, delimiter=delimiter)
    try:
        for row in reader:
            yield reader.line_num, row
    except csv.Error as problem:
        raise BrokenSubmission(Where(where.file, reader.line_num), "CSV", str(problem)) from None


# --- XLSX -------------------------------------------------------------------------------------


def xlsx_cells(content: bytes, where: Where, limits: Limits) -> Cells:
    """The rows of the first sheet that has any. Raises WantsExtra, BrokenSubmission, TooMuch."""
    try:
        from openpyxl import load_workbook
    except ImportError:
        raise WantsExtra(where, "XLSX", "openpyxl") from None
    checked_zip(content, where, limits)
    try:
        book = load_workbook(io.BytesIO(content), read_only=True, data_only=True, keep_links=False)
        for sheet in book.worksheets:
            sheet.reset_dimensions()
            started = False
            for line, row in enumerate(sheet.iter_rows(values_only=True, max_col=limits.columns + 1), 1):
                started = True
                yield line, _trimmed(row)
            if started:
                return
    except (MemoryError, RecursionError, GeneratorExit):
        raise
    except Exception as problem:  # openpyxl raises whatever it meets in a file that is none
        raise BrokenSubmission(where, "XLSX", type(problem).__name__) from None


def _trimmed(row: Sequence[object]) -> Sequence[object]:
    """Without the empty cells at its end, of which a sheet may have any number."""
    last = max((k for k, cell in enumerate(row, 1) if cell is not None), default=0)
    return row[:last]
