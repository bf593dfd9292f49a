"""Answers in tables (CSV, XLSX), TOML, JSON or lines of text: one student's, or those of a class.

A header with a column of ids and questions beside it is a class; rows of question, value (unit, sense) are a student's.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice, pairwise
from pathlib import PurePosixPath
from typing import IO

from graphkin.base.value import frozen
from graphkin.errors import BrokenSubmission, ExcelInside, GraphkinError, NoAnswers, SeveralStudents, TooMuch, Where
from graphkin.files.toml import parsed
from graphkin.submissions.answers import Entry
from graphkin.submissions.archives import checked_zip, foreign, lines_of
from graphkin.submissions.numbers import plain, short
from graphkin.submissions.questions import begins_like_one
from graphkin.submissions.students import field_of, id_column, stated_in
from graphkin.submissions.submission import Limits, tidy_id

Cells = Iterator[tuple[int, Sequence[object]]]  # rows as they stand, with the number of their line

PLAIN_TABLES, SHEETS = (".csv", ".tsv"), (".xlsx", ".xlsm")
_QUESTION = {
    "question", "quantity", "name", "item", "vector",
    "问题", "题目", "量", "所求量", "物理量", "项目", "矢量", "符号", "名称",
}  # fmt: skip
_VALUE = {"value", "answer", "result", "given", "数值", "值", "答案", "结果"}
_DASHES = "-–—−/ "  # of a cell in which there is nothing to say
_DIRECTION = {"sense", "direction", "sense, angle to +x", "转向", "方向", "转向或与 +x 夹角"}
_MORE = {"unit", "units", "单位"} | _DIRECTION
_BARE = re.compile(r"[+-]?[0-9]+(?:[.,][0-9]+)?")  # an angle without its unit
_LONGEST_CELL = 1 << 16
_DEEP = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){32}""")
_KEY = re.compile(r"""\s*(?:["“”„]([^"“”„]*)["“”„]|'([^']*)'|([^=＝≈:：\s"'“”„][^=＝≈:：]*?))\s*[=＝≈:：]""")
"""Quotes are those that word processors make of plain ones, too; an equals sign may be as wide as a Chinese letter."""
_ANSWER = re.compile(r"\s*[^\W\d].*[0-9]")  # words with a number
_HEADER = re.compile(r"\s*\[\s*([^\[\]]+?)\s*\]\s*")
_TABLES = ("answers", "answer", "values", "results", "答案")
_SCALES = ("scales", "scale", "比例尺")


@frozen
class StudentDocument:
    """Answers, and what is stated of whose they are: the id first, then a name; the line of a table or a list."""

    called: tuple[str, ...]
    entries: tuple[Entry, ...]
    line: int = 1

    @property
    def student(self) -> str:
        """The most telling of what is stated; empty where nothing is."""
        return self.called[0] if self.called else ""


def rows_of(cells: Cells, where: Where, limits: Limits) -> Iterator[StudentDocument]:
    """A row a student where the header says so; else one, with all answers of the table. Raises NoAnswers, TooMuch."""
    filled: Cells = ((line, row) for line, row in cells if any(shown_cell(cell) for cell in row))
    titles = list[tuple[int, Sequence[object]]]()
    while (first := next(filled, None)) is not None and sum(bool(shown_cell(cell)) for cell in first[1]) == 1:
        titles.append(first)
        limits.check(where, "answers", len(titles))
    if first is None:
        if not titles:
            raise NoAnswers(where)
        yield _one(titles, where, limits)
        return
    limits.check(where, "columns", len(first[1]))
    header = [shown_cell(cell)[:200] for cell in first[1]]
    second = next(filled, None)
    filled = chain([] if second is None else [second], filled)
    # `student, s1` over `omega 3, 3.92`, or over another such line, begins one student's table, and no class
    below = [shown_cell(cell) for cell in second[1]] if second is not None else []
    is_one = (any(map(_is_head, below[:1])) or _is_question_table(below)) and not any(map(_is_head, header[1:2]))
    if id_column(header) is None or _is_question_table(header) or is_one:
        yield _one(chain(titles, [first], filled), where, limits)
        return
    for count, (line, row) in enumerate(filled):
        limits.check(where, "rows", count + 1)
        given = ((name, cell) for name, cell in zip(header, row) if name and not field_of(name))
        entries = tuple((name, cell, Where(where.file, line, short(name))) for name, cell in given)
        called = stated_in((name, shown_cell(cell)) for name, cell in zip(header, row))
        yield StudentDocument((*called,), entries, line)


def of_one(cells: Cells, where: Where, limits: Limits) -> StudentDocument:
    """The one student's answers in a table. Raises NoAnswers, SeveralStudents, TooMuch."""
    rows = rows_of(cells, where, limits)
    row = next(rows, None)
    if row is None:
        raise NoAnswers(where)
    other = next((other.student for other in rows if other.student not in ("", row.student)), None)
    if other is not None:
        raise SeveralStudents(where, tidy_id(row.student), tidy_id(other))
    return row


def _is_head(text: str) -> bool:
    """True of what answers, or a student's id, may stand beside or below."""
    return begins_like_one(text) or field_of(text) is not None


def _is_question_table(header: Sequence[str]) -> bool:
    folded = {plain(name).lower() for name in header}
    return bool(folded & _QUESTION and folded & _VALUE)


def _one(cells: Iterable[tuple[int, Sequence[object]]], where: Where, limits: Limits) -> StudentDocument:
    """A student's own table: question and value beside each other, unit and sense after them, several under a head."""
    stated, entries = list[tuple[str, str]](), list[Entry]()
    names: list[str] | None = None
    starts = [0]
    for line, row in islice(cells, limits.answers + 2):
        shown = [shown_cell(cell) for cell in row[:20]]
        if _is_question_table(shown):
            names = [plain(name).lower() for name in shown]
            starts = [k for k, name in enumerate(names) if name in _QUESTION]
            continue
        inside = [(_key_name(key), cell[key.end() :].strip()) for cell in shown if (key := _KEY.match(cell[:400]))]
        own = [(name, text) for name, text in (*pairwise(shown), *inside) if text and field_of(name)]
        stated += [(name, text) for name, text in own if not field_of(text)]
        if own:
            continue
        if len([cell for cell in shown if cell]) == 1:  # ω3 = 3.92
            entries += [(name, text, Where(where.file, line, short(name))) for name, text in inside]
            continue
        for start, end in zip(starts, [*starts[1:], len(shown)], strict=True):
            if len(shown) > start + 1 and shown[start]:
                value = _value(row[start:end], shown[start:end], names and names[start:end])
                entries.append((shown[start], value, Where(where.file, line, short(shown[start]))))
    return StudentDocument((*stated_in(stated),), tuple(entries))


def _value(row: Sequence[object], shown: Sequence[str], names: Sequence[str] | None) -> object:
    """The cell itself, or number, unit and sense in cells of their own."""
    if names is None:
        more = [text for text in shown[2:4] if text.strip(_DASHES)]
        return row[1] if not more else " ".join([shown[1], *more])
    at = next((k for k, name in enumerate(names) if name in _VALUE), len(row))
    if at >= len(row):
        return None
    filled = enumerate(zip(names, shown))
    more = [f"∠ {text}°" if name in _DIRECTION and _BARE.fullmatch(plain(text)) else text
            for k, (name, text) in filled if k != at and name in _MORE and text.strip(_DASHES)]  # fmt: skip
    return row[at] if not more or not shown[at] else " ".join([shown[at], *more])


def shown_cell(cell: object) -> str:
    if isinstance(cell, float) and cell.is_integer() and abs(cell) < 1e15:
        return str(int(cell))
    return "" if cell is None else str(cell).strip()


_EXCEL = (b"PK\x03\x04", b"\xd0\xcf\x11\xe0")  # how workbooks begin, new ones and old ones


def csv_cells(stream: IO[bytes], where: Where) -> Cells:
    """The rows of a CSV in any usual encoding, by comma, semicolon or tabulator. Raises ExcelInside,
    BrokenSubmission."""
    start = stream.read(4)
    stream.seek(0)
    if start in _EXCEL:
        raise ExcelInside(where)
    csv.field_size_limit(_LONGEST_CELL)
    lines: Iterator[str] = (line.replace("\0", "") for line in lines_of(stream, where))
    first = next(lines, "")
    if (stated := re.fullmatch(r"sep=(.)\s*", first)) is not None:
        delimiter, rest = stated[1], lines
    else:
        bare = re.sub(r'"[^"]*"', "", first)
        delimiter, rest = max(",;\t", key=bare.count), chain([first], lines)
    reader = csv.reader(rest, delimiter=delimiter)
    try:
        for row in reader:
            yield reader.line_num, row
    except csv.Error as problem:
        raise BrokenSubmission(Where(where.file, reader.line_num), "CSV", str(problem)) from None


def xlsx_cells(content: bytes, where: Where, limits: Limits) -> Cells:
    """The rows of the first sheet that has any, without the empty cells at their ends. Raises WantsExtra,
    BrokenSubmission, TooMuch."""
    with foreign(where, "XLSX", "openpyxl"):
        from openpyxl import load_workbook

        checked_zip(content, where, limits)
        book = load_workbook(io.BytesIO(content), read_only=True, data_only=True, keep_links=False)
        for sheet in book.worksheets:
            sheet.reset_dimensions()
            started = False
            for line, row in enumerate(sheet.iter_rows(values_only=True, max_col=limits.columns + 1), 1):
                started = True
                yield line, row[: max((k for k, cell in enumerate(row, 1) if cell is not None), default=0)]
            if started:
                return


def cells_of(name: str, content: bytes, where: Where, limits: Limits) -> Cells:
    """The rows of a table file, by its suffix."""
    if PurePosixPath(name).suffix.lower() in SHEETS:
        return xlsx_cells(content, where, limits)
    return csv_cells(io.BytesIO(content), where)


def read_toml(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    text = text.removeprefix("\ufeff")
    if _DEEP.search(text) is not None:
        raise TooMuch(where, "depth", limits.depth)
    try:
        document = parsed(text)
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        # headings and `name = ..`, some left open or without quotes, as people fill in a form
        filled = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
        if filled and all(_HEADER.fullmatch(line[:60]) or _KEY.match(line[:400]) for line in filled):
            return read_lines(text, where, limits)
        raise BrokenSubmission(where, "TOML", str(problem)[:120]) from None
    lines: dict[str, int] = {}  # of each key as far as plain sight tells
    for number, line in enumerate(text.splitlines(), 1):
        if (key := _KEY.match(line[:400])) is not None:
            lines.setdefault(_key_name(key), number)
    return _document(document, where, lines)


def _key_name(key: re.Match[str]) -> str:
    return next(part for part in key.groups() if part is not None)


def read_json(text: str, where: Where, limits: Limits) -> StudentDocument:
    """Raises BrokenSubmission, TooMuch, NoAnswers."""
    return _document(_parsed(text, where, limits), where, {})


def _parsed(text: str, where: Where, limits: Limits) -> object:
    try:
        document: object = json.loads(text.removeprefix("\ufeff"))
        return document
    except RecursionError:
        raise TooMuch(where, "depth", limits.depth) from None
    except ValueError as problem:
        raise BrokenSubmission(where, "JSON", str(problem)[:120]) from None


def listed(text: str, where: Where, limits: Limits) -> list[StudentDocument] | None:
    """The students of a class in one JSON file; None for a file of one student's."""
    document = _parsed(text, where, limits)
    if not isinstance(document, list) or not all(isinstance(entry, dict) for entry in document):
        return None
    limits.check(where, "rows", len(document))
    students = []
    for number, entry in enumerate(document, 1):
        try:
            students.append(_document(entry, Where(where.file, number), {}))
        except GraphkinError:
            students.append(StudentDocument((), (), number))
    return students


def read_lines(text: str, where: Where, limits: Limits) -> StudentDocument:
    """`omega 3 = 3.92` line by line, as in a message; there may be none. Raises TooMuch."""
    stated, entries, table = list[tuple[str, str]](), list[Entry](), ""
    for number, line in enumerate(text.splitlines(), 1):
        if (header := _HEADER.fullmatch(line[:60])) is not None:
            table = "scales." if header[1] in _SCALES else ""
        key = _KEY.match(line[:400])
        if key is None:
            if header is None and _ANSWER.match(line[:400]):  # it is not passed over in silence
                entries.append((line.strip(), line.strip(), Where(where.file, number, short(line.strip()))))
            continue
        name, value = _key_name(key), line[key.end() :].strip(" \t\"'“”„")
        if field_of(name):
            stated.append((name, value))
        else:
            entries.append((table + name, value, Where(where.file, number, short(name))))
        limits.check(where, "answers", len(entries))
    return StudentDocument((*stated_in(stated),), tuple(entries))


def _document(document: object, where: Where, lines: Mapping[str, int]) -> StudentDocument:
    """Answers in their table or at the top, scales in theirs."""
    if not isinstance(document, dict):
        raise NoAnswers(where)
    named: list[tuple[str, str, object]] = []
    for key, value in document.items():
        if key in _SCALES and isinstance(value, dict):
            named += (("", f"scales.{plane}", size) for plane, size in value.items())
        elif key in _TABLES and isinstance(value, dict):
            named += ((f"{key}.", name, answer) for name, answer in value.items())
        elif not field_of(key):
            named.append(("", key, value))
    if not named:
        raise NoAnswers(where)
    entries = (
        (name, value, Where(where.file, lines.get(name, where.line), f"{table}{short(name)}"))
        for table, name, value in named
    )
    stated = ((key, str(value)) for key, value in document.items() if type(value) in (str, int))
    return StudentDocument((*stated_in(stated),), tuple(entries), where.line or 1)
