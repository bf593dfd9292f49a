"""The lines and figures of a PDF's pages, and what a printer would send back: a reader of its own, on pypdf.

By hand, over the library as books in both languages: python tests/pdf_pages.py [MECHANISM...]
"""

from __future__ import annotations

import io
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from pdf_lines import _NOTHING, Matrix, _times

_SAME, _BIG = 6.0, 9.0  # baselines that far apart are one line's; letters of that size are no subscripts [pt]
_LEFT, _INDENT = 56.69, 15.0  # the left edge; a formula begins that far to the right of it, or farther [pt]
_CLOSING = "，。；：、）】》”！？,;:!?)"
_OPEN = re.compile("[\u4e00-\u9fffa-z:：，,]$")  # the end of a sentence that has none
_ANSWERS = ("答", "Answer", "Answers")
_WIDE = re.compile("[\u4e00-\u9fff]")
_FOOT, _HEAD = 74.0, 791.0  # the lower and the upper edge of what is printed on A4 [pt]


@dataclass
class Line:
    """A line of text or a figure; role: of its element, `P`, `H1`, `H2`, `TD`, `Figure`, `Foot`, or "" of rows."""

    top: float
    bottom: float
    left: float
    text: str
    role: str

    @property
    def hangs(self) -> bool:
        """True of a formula or of a row of an equation: it needs the sentence before it."""
        return self.role in ("P", "") and self.left > _LEFT + _INDENT


def pages(content: bytes) -> list[list[Line]]:
    """The lines of each page from above, those of its foot last."""
    import pypdf

    reader = pypdf.PdfReader(io.BytesIO(content))
    roles = dict(_roles(reader))
    number = {page.indirect_reference.idnum: k for k, page in enumerate(reader.pages)}
    by_page = {(number[page], mark): role for (page, mark), role in roles.items()}
    return [[*_lines(reader, page, {m: role for (p, m), role in by_page.items() if p == k})]
            for k, page in enumerate(reader.pages)]  # fmt: skip


def _roles(reader: Any) -> Iterator[tuple[tuple[int, int], str]]:
    """The block that each marked piece is part of, by page and mark."""

    def walk(element: Any, role: str, page: Any) -> Iterator[tuple[tuple[int, int], str]]:
        element = getattr(element, "get_object", lambda: element)()
        if isinstance(element, list):
            for each in element:
                yield from walk(each, role, page)
        elif isinstance(element, int):
            yield (page, int(element)), role
        elif "/S" in element or "/K" in element:
            if "/Pg" in element:
                page = element.raw_get("/Pg").idnum
            own = str(element.get("/S", ""))[1:]
            if own in ("P", "H1", "H2", "TH", "TD", "Figure", "Caption", "TOCI"):
                role = f"{own} {id(element)}"
            yield from walk(element.get("/K", []), role, page)
        elif "/MCID" in element:
            yield (element.raw_get("/Pg").idnum if "/Pg" in element else page, int(element["/MCID"])), role

    yield from walk(reader.trailer["/Root"]["/StructTreeRoot"]["/K"], "", None)


def _lines(reader: Any, page: Any, roles: dict[int, str]) -> Iterator[Line]:
    """Pieces of one baseline are a line, with the scripts about it; pieces of a drawing are one figure."""
    pieces = sorted(_pieces(reader, page, roles), key=lambda piece: -piece[1])
    bases = [(y, role) for _, y, size, _, role in pieces if size >= _BIG]
    lines: dict[tuple[float, str], list[tuple[float, str]]] = {}
    figures: dict[str, Line] = {}
    for x, y, size, text, role in pieces:
        if role.startswith("Figure"):
            whole = figures.setdefault(role, Line(y, size, x, "", "Figure"))
            whole.bottom = min(whole.bottom, size)
            continue
        near = [(abs(base - y), base) for base, kind in bases if kind == role and abs(base - y) < _SAME]
        base = min(near)[1] if near else y
        first = next((key for key in lines if key[1] == role and abs(key[0] - base) < 1), (base, role))
        lines.setdefault(first, []).append((x, text))
    yield from figures.values()
    for (y, role), parts in lines.items():
        parts.sort(key=lambda part: part[0])
        if text := "".join(text for _, text in parts).strip():
            yield Line(y + 8, y - 2, parts[0][0], text, role.split(" ")[0])


def _pieces(reader: Any, page: Any, roles: dict[int, str]) -> Iterator[tuple[float, float, float, str, str]]:
    """Left end, baseline, size, text and role of each piece; of a drawing left, upper and lower edge."""
    from pypdf.generic import ContentStream

    fonts = {name: _letters(font.get_object()) for name, font in page["/Resources"].get("/Font", {}).items()}
    forms = page["/Resources"].get("/XObject", {})
    matrix, before, marks = _NOTHING, list[Matrix](), list[str]()
    text: Matrix = _NOTHING
    font, size = "", 0.0
    for operands, operator in ContentStream(page.get_contents(), reader).operations:
        match operator:
            case b"q":
                before.append(matrix)
            case b"Q":
                matrix = before.pop()
            case b"cm":
                matrix = _times(tuple(map(float, operands)), matrix)
            case b"BDC" | b"BMC":
                mark = operands[1].get("/MCID") if len(operands) > 1 else None
                marks.append("Foot" if operands[0] == "/Artifact" else roles.get(mark, marks[-1] if marks else ""))
            case b"EMC":
                marks.pop()
            case b"Tf":
                font, size = operands[0], float(operands[1])
            case b"Tm":
                text = _times(tuple(map(float, operands)), matrix)
            case b"Tj" | b"TJ":
                parts = operands[0] if operator == b"TJ" else operands
                raw = b"".join(part.original_bytes for part in parts if hasattr(part, "original_bytes"))
                codes = [int.from_bytes(raw[k : k + 2], "big") for k in range(0, len(raw), 2)]
                words = "".join(fonts[font].get(code, "") for code in codes)
                yield text[4], text[5], size, words, marks[-1] if marks else ""
            case b"Do" if marks and marks[-1].startswith("Figure"):
                a, _, _, d, e, f = matrix
                box = [float(each) for each in forms[operands[0]].get_object().get("/BBox", (0, 0, 1, 1))]
                ends = sorted((f + d * box[1], f + d * box[3]))
                yield min(e + a * box[0], e + a * box[2]), ends[1], ends[0], "", marks[-1]
            case _:
                pass


def _letters(font: Any) -> dict[int, str]:
    """The text of each code of a font, as its ToUnicode map has it."""
    letters: dict[int, str] = {}

    def text(code: str) -> str:
        return bytes.fromhex(code).decode("utf-16-be")

    content = font["/ToUnicode"].get_object().get_data().decode("latin-1")
    for block in re.findall(r"beginbfchar(.*?)endbfchar", content, re.S):
        for code, letter in re.findall(r"<(\w+)>\s*<(\w+)>", block):
            letters[int(code, 16)] = text(letter)
    for block in re.findall(r"beginbfrange(.*?)endbfrange", content, re.S):
        for first, last, letter in re.findall(r"<(\w+)>\s*<(\w+)>\s*<(\w+)>", block):
            for k in range(int(first, 16), int(last, 16) + 1):
                letters[k] = text(letter)[:-1] + chr(ord(text(letter)[-1]) + k - int(first, 16))
    return letters


@dataclass
class Page:
    """What stands on a page above its foot, from above; `section`: the heading that it goes on with."""

    body: list[Line]
    foot: str
    section: str
    last: bool

    @property
    def words(self) -> list[Line]:
        return [line for line in self.body if line.role != "Figure"]

    @property
    def sections(self) -> list[tuple[str, Line]]:
        """Each line with the heading that it stands under."""
        heading, lines = self.section, []
        for line in self.body:
            heading = line.text if line.role in ("H1", "H2") else heading
            lines.append((heading, line))
        return lines


def read(content: bytes) -> list[Page]:
    """Each page of a handout; the last one of a problem is before a title."""
    made: list[Page] = []
    for lines in pages(content):
        body = sorted((line for line in lines if line.role not in ("Foot", "Caption")), key=lambda line: -line.top)
        foot = "".join(line.text for line in lines if line.role == "Foot")
        made.append(Page(body, foot, made[-1].sections[-1][0] if made and made[-1].body else "", True))
    for page, following in pairwise(made):
        page.last = bool(following.body) and following.body[0].role == "H1"
    return made


def faults(content: bytes) -> Iterator[tuple[int, str, str]]:
    """Page, kind and place of each fault."""
    whole = read(content)
    for number, page in enumerate(whole, 1):
        of_page = (*_of_its_end(page), *_of_its_figures(page), *_of_its_words(page))
        for kind, where in of_page if page.body else [("few", "nothing")]:
            yield number, kind, where
        if number < len(whole) and _goes_on_in_answers(page, whole[number]):
            yield number, "apart", "answers"


def _of_its_end(page: Page) -> Iterator[tuple[str, str]]:
    """A page that ends where more is waited for, or that has hardly anything."""
    end, words = page.body[-1], page.words
    if end.text.endswith((":", "：")):
        yield "colon", end.text
    if end.role in ("H1", "H2"):
        yield "heading", end.text
    if len(words) <= (0 if len(words) < len(page.body) else 4):
        yield "few", f"{len(words)} lines"
    if page.body[0].hangs:
        yield "apart", f"begins with {page.body[0].text}"
    free = min(line.bottom for line in page.body) - _FOOT
    if not page.last and free > 0.4 * (_HEAD - _FOOT):
        yield "hole", f"{free / 2.835:.0f} mm"


def _of_its_figures(page: Page) -> Iterator[tuple[str, str]]:
    """A figure between a sentence and what that leads to, or on a page without a line of its section."""
    own = Counter(heading for heading, line in page.sections if line.role not in ("H1", "H2", "Figure"))
    neighbours = zip([None, *page.body], page.sections, [*page.body[1:], None], strict=False)
    for before, (heading, line), after in neighbours:
        if line.role != "Figure":
            continue
        if after is not None and after.hangs:
            yield "apart", f"figure before {after.text}"
        if before is not None and before.role == "P" and not before.hangs and _OPEN.search(before.text):
            yield "apart", f"figure behind {before.text}"
        if not own[heading] + own[page.section]:
            yield "apart", f"figure of {heading}"


def _of_its_words(page: Page) -> Iterator[tuple[str, str]]:
    """Lines that begin with a closing sign, heads of tables that break, a foot of another language."""
    for line in page.words:
        if line.text[0] in _CLOSING and len(line.text) > 1:
            yield "punctuation", line.text
    heads = sorted(line.top for line in page.body if line.role == "TH")
    if any(1 < high - low < 14 for low, high in pairwise(heads)):
        yield "cell", ""
    if page.words and bool(_WIDE.search("".join(line.text for line in page.words))) != bool(_WIDE.search(page.foot)):
        yield "mixed", page.foot


def _goes_on_in_answers(page: Page, following: Page) -> bool:
    """True where a page turns between the heading of the answers and their end."""
    return page.sections[-1][0] in _ANSWERS and bool(following.body) and following.body[0].hangs


def books(names: list[str]) -> Iterator[tuple[str, bytes]]:
    """Handouts of every stage, in both languages."""
    import graphkin
    from graphkin.handouts import in_languages
    from graphkin.handouts.typst import pdf

    machines = [graphkin.load(name) for name in names]
    for stage in ("problem", "half", "solution", "blank"):
        yield stage, pdf(in_languages(machines, stage, ("zh", "en"), answers=stage == "problem"))


def main() -> None:
    """Count the faults over the mechanisms named, else over the library; `hole` is none where a new page is wanted."""
    from graphkin.files import library

    total = Counter[str]()
    for stage, content in books(sys.argv[1:] or library.names()):
        faulty = list(faults(content))
        count = Counter(kind for _, kind, _ in faulty)
        total += count
        print(stage, len(pages(content)), "pages:", dict(count) or "none", flush=True)
        for fault in faulty:
            print("   ", *fault)
    print("all:", dict(total) or "none")


if __name__ == "__main__":
    main()
