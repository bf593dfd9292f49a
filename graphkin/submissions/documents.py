"""Documents."""

from __future__ import annotations

import csv
import io
import json
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice
from typing import IO, Any

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, GraphkinError, NoAnswers, TooMuch, WantsExtra, Where
from graphkin.submissions.answers import Entry
from graphkin.submissions.archives import checked_zip, lines_of
from graphkin.submissions.numbers import plain, short
from graphkin.submissions.questions import begins_like_one
from graphkin.submissions.submission import Limits

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


_DEEP = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){32}""")
_KEY = re.compile(r"""\s*(?:["“”„]([^"“”„]*)["“”„]|'([^']*)'|([^=＝≈:：\s"'“”„][^=＝≈:：]*?))\s*[=＝≈:：]""")
"""Quotes are those that word processors make of plain ones, too; an equals sign may be as wide as a Chinese letter."""
_HEADER = re.compile(r"\s*\[\s*([^\[\]]+?)\s*\]\s*")
_TABLES = ("answers", "answer", "values", "results", "答案")
_SCALES = ("scales", "scale", "比例尺")


@frozen
class StudentDocument:
    """A student's id as stated ("" where none is) and what is answered."""

    student: str
    entries: tuple[Entry, ...]


def read_toml(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    text = text.removeprefix("\ufeff")
    if _DEEP.search(text) is not None:
        raise TooMuch(where, "depth", limits.depth)
    try:
        document = tomllib.loads(text)
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        if _is_filled_form(text):
            return read_lines(text, where, limits)
        raise BrokenSubmission(where, "TOML", str(problem)[:120]) from None
    return _document(document, where, _lines(text))


def _is_filled_form(text: str) -> bool:
    """Whether all of it is headings and `name = ..`, some left open or without quotes, as people fill in a form."""
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    return bool(lines) and all(_HEADER.fullmatch(line[:60]) or _KEY.match(line[:400]) for line in lines)


def read_json(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    return _document(_json(text, where, limits), where, {})


def listed(text: str, where: Where, limits: Limits) -> list[StudentDocument] | None:
    """The students of a class in one JSON file; None for a file of one student's."""
    document = _json(text, where, limits)
    if not isinstance(document, list) or not all(isinstance(entry, dict) for entry in document):
        return None
    if len(document) > limits.rows:
        raise TooMuch(where, "rows", limits.rows)
    found = []
    for entry in document:
        try:
            found.append(_document(entry, where, {}))
        except GraphkinError:
            found.append(StudentDocument("", ()))
    return found


def read_lines(text: str, where: Where, limits: Limits) -> StudentDocument:
    """`omega 3 = 3.92` line by line, as in a message. Raises NoAnswers, TooMuch."""
    student, entries, table = "", list[Entry](), ""
    for number, line in enumerate(text.splitlines(), 1):
        if (header := _HEADER.fullmatch(line[:60])) is not None:
            table = "scales." if header[1] in _SCALES else ""
        key = _KEY.match(line[:400])
        if key is None:
            continue
        name, value = next(part for part in key.groups() if part is not None), line[key.end() :].strip(" \t\"'“”„")
        if student_of(name):
            student = value[:200]
        else:
            entries.append((table + name, value, Where(where.file, number, short(name))))
        if len(entries) > limits.answers:
            raise TooMuch(where, "answers", limits.answers)
    return _filled(StudentDocument(student, tuple(entries)), where)


def _json(text: str, where: Where, limits: Limits) -> Any:
    try:
        return json.loads(text.removeprefix("\ufeff"))
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        raise BrokenSubmission(where, "JSON", str(problem)[:120]) from None


def _document(document: object, where: Where, lines: Mapping[str, int]) -> StudentDocument:
    if not isinstance(document, dict):
        raise NoAnswers(where)
    student = next((value for key, value in document.items() if student_of(key)), "")
    entries = tuple(
        (name, value, Where(where.file, lines.get(name), f"{table}{short(name)}"))
        for table, name, value in _named_answers(document)
    )
    named = str(student) if isinstance(student, str | int) and not isinstance(student, bool) else ""
    return _filled(StudentDocument(named[:200], entries), where)


def _named_answers(document: Mapping[str, Any]) -> Iterator[tuple[str, str, object]]:
    """Answers in their table or at the top, scales in theirs."""
    for key, value in document.items():
        if key in _SCALES and isinstance(value, dict):
            yield from (("", f"scales.{plane}", size) for plane, size in value.items())
        elif key in _TABLES and isinstance(value, dict):
            yield from ((f"{key}.", name, given) for name, given in value.items())
        elif not student_of(key):
            yield "", key, value


def _filled(document: StudentDocument, where: Where) -> StudentDocument:
    if not document.entries:
        raise NoAnswers(where)
    return document


def _lines(text: str) -> dict[str, int]:
    """The line of each key as far as plain sight tells."""
    found: dict[str, int] = {}
    for number, line in enumerate(text.splitlines(), 1):
        if (key := _KEY.match(line[:400])) is not None:
            found.setdefault(next(part for part in key.groups() if part is not None), number)
    return found
