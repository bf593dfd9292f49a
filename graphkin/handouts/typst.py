"""A handout as PDF, set by typst: true scale, PDF/UA-1, the same bytes for the same problem."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import ceil
from pathlib import Path
from types import ModuleType
from typing import Any, assert_never

from graphkin.errors import NoChineseLetters, NoFont, NoLetter
from graphkin.handouts import document
from graphkin.handouts.document import Block, GridRoom, Handout, HandoutPart
from graphkin.handouts.grid import markers_svg, room_svg
from graphkin.handouts.paging import PagePart, page_parts, pages
from graphkin.outputs.files import needed
from graphkin.outputs.paged import unscaled
from graphkin.outputs.svg import svg
from graphkin.outputs.typesetting import mm, signs
from graphkin.photo.markers import DIGITS, MARKERS, SIZE, digits, edges
from graphkin.photo.sheets import PrintedSheet, SheetRoom
from graphkin.sheet.lettering import Label, Run, width
from graphkin.sheet.paper import PAPERS, Paper

VARIABLE = "GRAPHKIN_FONT"  # the environment's name for a font file
_LATIN = ("Times New Roman", "Liberation Serif", "Tinos", "Libertinus Serif")
_WIDE = re.compile(r"[\u2e80-\u9fff\uff00-\uffef]")
_MISSING = re.compile(r'the text `"(.+?)"` could not be displayed')
_ACCENTED = re.compile(r"(.[\u0300-\u036f]+)")
_BOUND = re.compile(r"^ (?== [−\d])|(?<= =) (?=\S)|(?<=\d) (?=(?:[mck]?m|r|s|rad|deg|in|ft)\b)")
_BETWEEN_TAGS = re.compile(r">[^<]*[\\u0300-\\u036f][^<]*")
_MARGIN, _TOP, _BOTTOM = 20.0, 18.0, 26.0  # of a page [mm]
_COLUMN, _GUTTER = 170.0, 10.0  # of a page with two columns: each is as wide as A4 has it, or wider; between them [mm]
_BESIDE, _BOX, _SHORT = 60.0, 21.0, 13.0  # the width of a table beside gridded paper, of a box for an answer beside a
# figure, the length of a blank where two equations stand abreast, at least [mm]
_PLACE, _NARROW, _MANY = 75.0, 55.0, 5  # of a line to write on with what stands before it, of one of many [mm]; so many
_LYING = 200.0  # a page that is wider has less height than a problem wants [mm]
_BETWEEN, _BEFORE = 3.7, 5.5  # clear room between parts of a page, and above one that begins with a heading [mm]
_INSET = 5.0  # what a cell of a table is wider than its letters [mm]
_HEAVY = 600  # the weight of bold letters
_LINE = 6.0  # of a list of problems [mm]
_SLACK = 0.5  # of a page's height that is left over, as lengths are rounded [mm]
_PLACED = """context {{
  let at = here().position()
  [#metadata((page: at.page, x: at.x.mm(), y: at.y.mm(), problem: {problem}))<printed>]
}}"""
Pictures = dict[str, str]  # drawings by the names by which a page asks for them
PageRun = tuple[str, list[tuple[PagePart, str]]]  # what stands before some parts in a row, and their markup

_HEAD = """#set document(title: {title}, author: "graphkin handout", date: none)
#set text(font: ({families}), size: 10.5pt, lang: {lang}, region: none)
#set par(justify: false, leading: 0.62em, spacing: 1em)
#set block(spacing: 1em)
#show math.equation: set text(font: "New Computer Modern Math")
#set heading(outlined: true, bookmarked: true)
#show heading.where(level: 1): set text(size: 15pt)
#show heading.where(level: 2): set text(size: 12pt)
// A closing bracket is set apart from what follows: typst would take half a letter from between; not every font has it.
#show regex("[）】》”]"): set text(number-width: "tabular")
#let lettered(body) = text(font: ({families}), body)
// A number in a circle is as high as its line.
#let act(number) = box(width: 3.8mm, height: 0.66em, place(center + horizon,
  circle(radius: 1.9mm, inset: 0mm, stroke: 0.2mm, align(center + horizon, text(size: 7.5pt, number)))))
#let part(above, breakable, body) = block(
  breakable: breakable, width: 100%, above: above, below: 0mm, body)
#let foot = state("foot", (bar: "", words: ""))
#let said = state("said", "")
#let named = state("named", "")
#let bar(words) = {{
  set text(size: 7pt)
  stack(dir: ttb, spacing: 1mm,
    box(width: 100mm, height: 2mm, {{
      place(top + left, line(length: 100mm, stroke: 0.35mm))
      for k in range(11) {{ place(top + left, dx: k * 10mm, line(start: (0mm, 0mm), end: (0mm, 2mm), stroke: 0.18mm)) }}
    }}),
    words)
}}
// The titles between two places, on as many pages as they need, about as many on each.
#let contents(start, end) = context {{
  let inside = heading.where(level: 1, outlined: true).after(start)
  let places = query(if query(end).len() > 0 {{ inside.before(end) }} else {{ inside }}).map(it => it.location())
  let count = calc.ceil(places.len() / {lines})
  for (k, some) in places.chunks(calc.max(1, calc.ceil(places.len() / calc.max(1, count)))).enumerate() {{
    if k > 0 {{ pagebreak() }}
    outline(title: none, target: selector.or(..some))
  }}
}}
#set page(width: {width}mm, height: {height}mm, margin: (x: {margin}mm, top: {top}mm, bottom: {bottom}mm),
  background: {background},
  // each further page of what is handed in has a line for the name
  header: context if named.get() != "" and query(<named>).all(it => it.location().page() != here().page()) {{
    align(right, text(size: 8pt, named.get()) + h(2mm) + box(width: 45mm, stroke: (bottom: 0.18mm)))
  }},
  footer: context {{
    set text(size: 8pt)
    grid(columns: (1fr, auto), align: (left + bottom, right + bottom),
      bar(foot.get().bar), foot.get().words + said.get(){number} + " · " +
        str(counter(page).get().first()) + "/" + str(counter(page).final().first()))
  }})
"""
_BOLD = r"""#show heading: it => {
  show regex("[\u{2e80}-\u{9fff}\u{ff00}-\u{ffef}]+"): set text(stroke: 0.035em)
  it
}
"""
"""Chinese headings, where the Chinese letters come in one weight."""
_MARKER = """#let bits = ({bits})
#let marker(id) = box(width: {size}mm, height: {size}mm, fill: black, {{
  for k in range(16) {{
    if calc.odd(bits.at(id).bit-rshift(15 - k)) {{
      place(top + left, dx: (calc.rem(k, 4) + 1) * {cell}mm, dy: (calc.quo(k, 4) + 1) * {cell}mm,
        rect(width: {cell}mm, height: {cell}mm, fill: white))
    }}
  }}
}})
"""


def pdf(handout: Handout, paper: str = "A4", font: Path | None = None, scan: int | None = None) -> bytes:
    """The PDF of a handout; the rest is as `printed` has it."""
    return printed(handout, paper, font, scan)[0]


def printed(
    handout: Handout, paper: str = "A4", font: Path | None = None, scan: int | None = None
) -> tuple[bytes, list[PrintedSheet]]:
    """The PDF of a handout, and what is on its pages where they are to be photographed.

    font  a font file to use; else the one the environment names, else the system's
    scan  the number of the first page of those that are to be photographed, each of which has the next one: markers
          and dots are printed with it

    Raises NeedsExtra without typst, NoFont, NoChineseLetters, NoLetter.
    """
    typst = needed("typst", "pdf")
    pictures: Pictures = {}
    page = PAPERS[paper]
    if scan is not None:
        pictures["markers"] = markers_svg(page.width, page.height)
    count = int((page.width - 2 * _side(scan) + _GUTTER) / (_COLUMN + _GUTTER)) or 1
    wide = (page.width - 2 * _side(scan) + _GUTTER) / count - _GUTTER
    runs = [run for k, part in enumerate(handout.parts) for run in _runs(k, *part, pictures, wide)]
    words = "".join(markup for _, parts in runs for _, markup in parts)
    chinese = bool(_WIDE.search(handout.title + words + "".join(part.foot.bar for part, _ in handout.parts)))
    fonts, families, one_weight = _fonts(typst, font, chinese)
    head = _head(handout, families, page, scan) + (_BOLD if one_weight else "")
    head += f"#set page(columns: {count})\n#set columns(gutter: {mm(_GUTTER)}mm)\n" * (count > 1)
    measure = "".join(f"#context [#metadata(measure(width: {mm(wide)}mm)[{markup}].height.mm())<high>]\n"
                      for _, parts in runs for _, markup in parts)  # fmt: skip
    compiler = typst.Compiler((head + measure).encode(), font_paths=fonts, sys_inputs=pictures)
    try:
        heights = iter(json.loads(compiler.query("<high>", field="value")))
        room = page.height - _TOP - _BOTTOM - _SLACK
        fitted = [(before, [_fitted(*each, next(heights), room, pictures, wide) for each in parts])
                  for before, parts in runs]  # fmt: skip
        body = "".join(before + _paged(parts, room) for before, parts in fitted)
        turned = body.replace("#pagebreak(weak: true)", "#colbreak(weak: true)") if count > 1 else body
        whole = (head + turned).encode()
        compiler = typst.Compiler(whole, font_paths=fonts, sys_inputs=pictures)  # with the papers that were cut
        placed = [] if scan is None else json.loads(compiler.query("<printed>", field="value"))
        made: bytes = compiler.compile(whole, format="pdf", timestamp=0, pdf_standards=["ua-1"])
        rooms = (block for _, parts in fitted for part, *_ in parts for block in part.blocks)
    except typst.TypstError as problem:
        if (letter := _MISSING.search(str(problem))) is None:
            raise
        raise NoLetter(letter[1]) from None
    return unscaled(made), [] if scan is None else [*_sheets(handout, rooms, page, scan, placed, page_count(made))]


def _sheets(
    handout: Handout, blocks: Iterator[Block], page: Paper, first: int, placed: list[dict[str, Any]], count: int
) -> Iterator[PrintedSheet]:
    """Each page, by the titles of problems and the gridded papers on it, in the order in which they were placed."""
    owner, rooms = ("", ""), (block for block in blocks if isinstance(block, GridRoom))
    for number in range(1, count + 1):
        own: list[SheetRoom] = []
        for each in (each for each in placed if each["page"] == number):
            if each["problem"] is not None:
                owner = handout.owners[each["problem"]]
                continue
            grid, low = next(rooms), complex(each["x"], each["y"])
            high = low + complex(grid.width, grid.height)
            own.append(SheetRoom(grid.plane, 1, low + grid.pole, low, high, grid.scale, grid.direction))
        yield PrintedSheet(first + number - 1, *owner, page.width, page.height, tuple(own))


def _runs(number: int, part: HandoutPart, blocks: list[Block], pictures: Pictures, wide: float) -> Iterator[PageRun]:
    """A part from one new page to the next."""
    here = f"part{number}"
    foot = f"(bar: {_string(part.foot.bar)}, words: {_string(part.foot.words)})"
    before = (f"#pagebreak(weak: true)\n#set text(lang: {_string(part.lang)})\n#foot.update({foot})\n"
              f"#said.update(\"\")\n#metadata(none) #label({_string(here)})\n")  # fmt: skip
    if part.contents:
        before += (f"#heading(level: 1, outlined: false)[#{_string(part.contents)}]\n"
                   f"#contents(label({_string(here)}), label(\"part{number + 1}\"))\n")  # fmt: skip
    together: list[Block] = []
    for block in [*blocks, document.NewPage()]:
        if not isinstance(block, document.NewPage):
            together.append(block)
            continue
        parts = page_parts(together)
        yield before, [(each, _together(each.blocks, pictures, wide)) for each in parts]
        before, together = "#pagebreak(weak: true" + (', to: "odd"' if block.front else "") + ")\n", []


def _together(blocks: Sequence[Block], pictures: Pictures, wide: float) -> str:
    """The markup of what stands together: where a page is as wide, an equation has the next beside it, gridded paper
    its table, and the figure of a problem the room for answers."""
    text, blocks = "", [*blocks]
    while blocks:
        left, *others = blocks
        match blocks:
            case [GridRoom(width=first), document.HandoutTable(heads, rows) as table, *rest] if (
                table.under and wide - first - _INSET > _BESIDE
            ):
                single = tuple(rows[0][:3] for _ in range(len(rows) * len(heads) // 3))
                others = [document.HandoutTable(heads[:3], single, wide - first - _INSET)]
            case [document.TermRows() as one, document.TermRows() as two, *rest] if all(
                _blank(each, wide / 2 - _INSET) > _SHORT for each in (one, two)
            ):
                first, others = wide / 2 - _INSET, [two]
            case [document.HandoutPicture(sheet, of_all=True), document.HandoutHeading() as head,
                  document.HandoutTable() as table, *rest] if (
                wide > _LYING and wide - sheet.paper.width - _INSET > _BOX * len(table.heads)
            ):
                first = sheet.paper.width
                others = [head, replace(table, under=wide - first - _INSET)]
            case _:
                text, blocks = text + _markup(left, pictures, wide), others
                continue
        sides = (_markup(left, pictures, first), "".join(_markup(each, pictures, wide - first) for each in others))
        shape = f"columns: ({mm(first)}mm, 1fr), column-gutter: {mm(_INSET)}mm"
        text, blocks = text + f"#grid({shape})[{sides[0]}][{sides[1]}]\n", rest
    return text


def _fitted(
    part: PagePart, markup: str, high: float, room: float, pictures: Pictures, wide: float
) -> tuple[PagePart, str, float]:
    """A part with its markup and its height: gridded paper is cut where all is to stand on one page with it."""
    if high <= room:
        return part, markup, high
    blocks = [each.lower(high - room) if isinstance(each, GridRoom) else each for each in part.blocks]
    pairs = zip(part.blocks, blocks, strict=True)
    cut = sum(a.height - b.height for a, b in pairs if isinstance(a, GridRoom) and isinstance(b, GridRoom))
    return PagePart(tuple(blocks), part.of), _together(blocks, pictures, wide) if cut else markup, high - cut


def _paged(parts: list[tuple[PagePart, str, float]], room: float) -> str:
    """The markup of parts on the pages that cost least."""
    above = [_BEFORE if part.heads else _BETWEEN for part, *_ in parts]
    whole = [high + over for (*_, high), over in zip(parts, above, strict=True)]
    sheets = pages([part for part, *_ in parts], whole, room + _BETWEEN)
    breaks = ["true" if high > room else "false" for *_, high in parts]
    return "#pagebreak(weak: true)\n".join(
        "".join(f"#part({mm(above[k])}mm, {breaks[k]})[{parts[k][1]}]\n" for k in page) for page in sheets
    )


def page_count(content: bytes) -> int:
    """The number of pages of a PDF of this writer."""
    return len(re.findall(rb"/Type\s*/Page\b", content))


def _fonts(typst: ModuleType, named: Path | None, chinese: bool) -> tuple[object, tuple[str, ...], bool]:
    """Families of fonts by preference, and whether the Chinese has but one weight. Raises NoFont, NoChineseLetters."""
    path = named or (Path(os.environ[VARIABLE]) if os.environ.get(VARIABLE) else None)
    own: tuple[str, ...] = ()
    if path is not None:
        from matplotlib.ft2font import FT2Font

        try:
            own = (FT2Font(str(path)).family_name,)
        except (OSError, RuntimeError):
            raise NoFont(str(path)) from None
    fonts = typst.Fonts(font_paths=[str(path.parent)] if path is not None else [])
    if not chinese:
        return fonts, (*own, *_LATIN), False
    from graphkin.outputs.diagram.fonts import chinese_font

    letters = own or tuple(filter(None, [chinese_font()]))
    if not letters:
        raise NoChineseLetters()
    heaviest = max((each.weight for each in fonts.fonts() if each.family == letters[0]), default=0)
    return fonts, (*_LATIN, *letters), heaviest < _HEAVY


def _head(handout: Handout, families: tuple[str, ...], page: Paper, scan: int | None) -> str:
    """The settings of all pages; of those that are photographed also their markers, and each one's number."""
    before, number, background = "", "", "none"
    if scan is not None:
        left, right = edges(page.width, page.height)
        page_number = f"{scan - 1} + counter(page).get().first()"
        parts = ((left, f"calc.quo({page_number}, {DIGITS})"), (right, f"calc.rem({page_number}, {DIGITS})"))
        placed = "; ".join(
            f"place(top + left, dx: {mm(at.real)}mm, dy: {mm(at.imag)}mm, marker({digits(0)[0]} + {part}))"
            for at, part in parts
        )
        shared = f'image(bytes(sys.inputs.markers), format: "svg", width: {mm(page.width)}mm)'
        background = f"context pdf.artifact({{ place(top + left, {shared}); {placed} }})"
        before = _MARKER.format(bits=", ".join(map(str, MARKERS)), size=mm(SIZE), cell=mm(SIZE / 6))
        number = f' + " · #" + str({page_number})'
    return before + _HEAD.format(
        title=_string(handout.title), families=", ".join(map(_string, families)), lang=_string(handout.lang),
        width=mm(page.width), height=mm(page.height), margin=mm(_side(scan)), top=mm(_TOP), bottom=mm(_BOTTOM),
        number=number, background=background, lines=int((page.height - _TOP - _BOTTOM) / _LINE) - 3,
    )  # fmt: skip


def _side(scan: int | None) -> float:
    """The margin at the sides; a page to be photographed has its markers there [mm]."""
    return _MARGIN + (8 if scan is not None else 0)


def _markup(block: Block, pictures: Pictures, wide: float) -> str:
    """A block in typst's markup; drawings are kept under the names by which it asks for them; wide: the page [mm]."""
    match block:
        case document.HandoutHeading(words, level, said, problem):  # with what feet and heads say from here on
            foot = f"#said.update({_string(said and ' · ' + said)})\n#metadata(none)<named>\n#named.update(\"\")\n"
            foot = foot if level == 1 else ""
            foot += "" if problem is None else f"#{_PLACED.format(problem=problem)}\n"
            return f"{foot}#heading(level: {level})[{_words(words)}]\n"
        case document.BlankLine(words):
            rules = "".join(f"[{_words(word)}], line(length: 100%, stroke: 0.18mm), " for word in words)
            named = isinstance(block, document.NameLine)
            lines = 1 if named else ceil(len(words) / int(wide / (_PLACE if len(words) < _MANY else _NARROW)))
            count = ceil(len(words) / lines)
            shape = f"columns: (auto, 1fr) * {count}, align: bottom, column-gutter: 2mm, row-gutter: 4mm"
            name = _string("".join(run.text for run in words[0]))
            head = f"#metadata(none)<named>\n#named.update({name})\n" if named else ""
            return f"{head}#block(above: 4mm, below: 4mm, grid({shape}, {rules}))\n"
        case document.Paragraph(words, act):
            number = f"#act({_string(act)}) " if act else ""
            return f"#par[{number}{_words(words)}]\n"
        case document.FormulaLine(words):
            return f"#pad(left: 8mm, par[{_words(words)}])\n"
        case document.TermRows():
            return f"#block(breakable: false, pad(left: 8mm, {_rows(block, wide)}))\n"
        case document.HandoutPicture(sheet, words, number):
            image = _image(pictures, svg(sheet), sheet.paper.width, words)
            return f"#figure({image}, caption: [#{_string(number)}], numbering: none, gap: 2mm)\n"
        case GridRoom():
            image = _image(pictures, room_svg(block), block.width, block.words)
            placed = f"place(top + left, {_PLACED.format(problem='none')})"
            return f"#align(center, block(width: {mm(block.width)}mm, {{ {placed}; {image} }}))\n"
        case document.HandoutTable():
            return f"#block(breakable: false, width: 100%, {_table(block, wide)})\n"
        case document.NewPage() | document.HandoutPart():
            raise TypeError(f"{type(block).__name__} stands between pages, not on one")
        case _:
            assert_never(block)


def _rows(rows: document.TermRows, wide: float) -> str:
    """A grid of terms, directions, sizes; a blank is a line to write on, as long as all have room."""
    rule = f"#box(width: {mm(_blank(rows, wide))}mm, height: 6mm, stroke: (bottom: 0.18mm))"
    cells = [f"[{_words(cell) if cell is not None else rule}]" for line in rows.lines for cell in line]
    shape = f"columns: {len(rows.lines[0])}, align: center + horizon, column-gutter: 2mm, row-gutter: 2mm"
    return f"grid({shape}, {', '.join(cells)})"


def _blank(rows: document.TermRows, wide: float) -> float:
    """The length of each blank of an equation; 0 of a printed one [mm]."""
    across = max(([each for each in line if each != ()] for line in rows.lines[::3]), key=len)
    blanks = sum(cell is None for cell in across)
    signs = 8.0 + 16.0 + 4.0 + 6.5 * (len(across) - blanks) + 2.0 * blanks  # edge, heads, the rest, gaps [mm]
    return min(20.0, (wide - signs) / blanks) if blanks else 0.0


def _table(table: document.HandoutTable, wide: float) -> str:
    """A table whose heads do not break, as high as its cells need; under gridded paper it ends where that ends."""
    cells = [f"[{_words(cell)}]" for row in table.rows for cell in row]
    first = ", ".join(f"[{_words(head)}]" for head in table.heads)
    room = table.under or min(30.0 * len(table.heads), wide - 10)
    least = [width(head, document.LETTERS) + _INSET for head in table.heads]
    wraps = any(width(cell, document.LETTERS) + _INSET > room / len(least) for row in table.rows for cell in row)
    columns = ", ".join("1fr" if each < room / len(least) else f"{mm(each)}mm" for each in least)
    rows = "auto" if wraps else f"{mm(table.row)}mm"
    shape = f"columns: ({columns}), rows: {rows}, align: center + horizon, stroke: 0.18mm"
    place = "center" if table.under else "left"
    return f"align({place}, block(width: {mm(room)}mm, table({shape}, table.header({first}), {', '.join(cells)})))"


def _image(pictures: Pictures, text: str, width: float, words: str) -> str:
    """A drawing under a name of its own, and what shows it."""
    name, own_font = f"picture{len(pictures)}", r'<tspan font-family="Libertinus Serif">\1</tspan>'
    pictures[name] = _BETWEEN_TAGS.sub(lambda part: _ACCENTED.sub(own_font, part[0]), text)
    return f'image(bytes(sys.inputs.{name}), format: "svg", width: {mm(width)}mm, alt: {_string(words)})'


def _words(label: Label) -> str:
    """Letters with their scripts; where both stand over one another it is a formula, and read aloud as its name."""
    text = ""
    for sign in signs(label):
        base, low, high = ("".join(map(_run, runs)) for runs in sign.runs)
        if low and high:
            whole = f"$attach(#lettered[{base}], t: #lettered[{high}], b: #lettered[{low}])$"
            text += f"#math.equation(alt: {_string(sign.plain)}, {whole})"
        else:
            text += base + (f"#sub[{low}]" if low else "") + (f"#super[{high}]" if high else "")
    return text


def _run(run: Run) -> str:
    """Its letters; one with an accent of its own in typst's own font, as few others have such accents."""
    bound = _BOUND.sub("\u00a0", run.text) if run.place == "base" else run.text.replace(" ", "\u00a0")
    text = bound.replace("/", "/\u2060")  # a fraction, a unit, or a subscript stays on its line
    parts = (_string(part) if not k % 2 else f'text(font: "Libertinus Serif", {_string(part)})'
             for k, part in enumerate(_ACCENTED.split(text)) if part)  # fmt: skip
    return "".join(f"#emph({part})" if run.italic else f"#{part}" for part in parts)


def _string(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'
