"""A handout as PDF, set by typst: true scale, PDF/UA-1, the same bytes for the same problem."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import assert_never

from graphkin.errors import NoChineseLetters, NoFont, NoLetter
from graphkin.handouts import document
from graphkin.handouts.document import Block, Handout
from graphkin.handouts.grid import DIGITS, MARKERS, SIZE, digits, edges, markers_svg, room_svg
from graphkin.outputs.files import needed
from graphkin.outputs.paged import unscaled
from graphkin.outputs.svg import svg
from graphkin.outputs.typesetting import mm, signs
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.paper import PAPERS, Paper

VARIABLE = "GRAPHKIN_FONT"  # the environment's name for a font file
_LATIN = ("Times New Roman", "Liberation Serif", "Tinos", "Libertinus Serif")
_WIDE = re.compile(r"[\u2e80-\u9fff\uff00-\uffef]")
_MISSING = re.compile(r'the text `"(.+?)"` could not be displayed')
_ACCENTED = re.compile(r"(.[\u0300-\u036f]+)")
_BETWEEN_TAGS = re.compile(r">[^<]*[\\u0300-\\u036f][^<]*")
_MARGIN, _BOTTOM, _CLEAR = 20.0, 26.0, 5.0  # at the sides of a page, at its foot, and between a drawing and words [mm]
_HEAD = """#set document(title: {title}, author: "graphkin handout", date: none)
#set text(font: ({families}), size: 10.5pt, lang: {lang}, region: none)
#set par(justify: false, leading: 0.62em)
#show math.equation: set text(font: "New Computer Modern Math")
#set heading(outlined: true, bookmarked: true)
#show heading.where(level: 1): set text(size: 15pt)
#show heading.where(level: 2): set text(size: 12pt)
// A closing bracket is set apart from what follows: typst would take half a letter from between; not every font has it.
#show regex("[）】》”]"): set text(number-width: "tabular")
#let lettered(body) = text(font: ({families}), body)
#let act(number) = box(
  circle(radius: 1.9mm, inset: 0mm, stroke: 0.2mm, align(center + horizon, text(size: 7.5pt, number))))
// A drawing for which the page has no room comes first on the next one, and what follows it is told before.
// Whether there is room is asked as if it were not yet on the page, over what it follows.
#let drawn(name, body) = {{
  block(height: 0pt, above: 0pt)[#metadata(name)#label(name)]
  context {{
    let (high, at) = (measure(body).height + {clear}mm, locate(label(name)).position())
    let over = query(label(name + "-shown")).map(it => it.location().position())
      .filter(it => it.page == at.page and it.y < at.y)
    let room = page.height - {bottom}mm - at.y + over.len() * high
    let shown = align(center)[#metadata(name)#label(name + "-shown")#body]
    if high > room {{ place(top + center, float: true, clearance: {clear}mm, shown) }} else {{ shown }}
  }}
}}
#let bar = {{
  set text(size: 7pt)
  stack(dir: ttb, spacing: 1mm,
    box(width: 100mm, height: 2mm, {{
      place(top + left, line(length: 100mm, stroke: 0.35mm))
      for k in range(11) {{ place(top + left, dx: k * 10mm, line(start: (0mm, 0mm), end: (0mm, 2mm), stroke: 0.18mm)) }}
    }}),
    {bar})
}}
#set page(width: {width}mm, height: {height}mm, margin: (x: {margin}mm, top: 18mm, bottom: {bottom}mm),
  background: {background},
  footer: context {{
    set text(size: 8pt)
    grid(columns: (1fr, auto), align: (left + bottom, right + bottom),
      bar, {foot} + state("said", "").get(){number} + " · " +
        str(counter(page).get().first()) + "/" + str(counter(page).final().first()))
  }})
"""
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
    """The PDF of a handout.

    font  a font file to use; else the one the environment names, else the system's
    scan  the number of the first page of those that are to be photographed, each of which has the next one: markers
          and dots are printed with it

    Raises NeedsExtra without typst, NoFont, NoChineseLetters, NoLetter.
    """
    typst = needed("typst", "pdf")
    pictures: dict[str, str] = {}
    page, body = PAPERS[paper], "\n".join(_markup(block, pictures) for block in handout.blocks)
    families, folders = _fonts(font, bool(_WIDE.search(handout.title + body + handout.foot.bar)))
    if scan is not None:
        pictures["markers"] = markers_svg(page.width, page.height)
    contents = ""
    if handout.contents:
        title = f"heading(level: 1, outlined: false)[#{_string(handout.contents)}]"
        contents = f"#{title}\n#outline(title: none, depth: 1)\n"
    text = _head(handout, families, page, scan) + contents + body
    try:
        made: bytes = typst.compile(
            text.encode(), format="pdf", sys_inputs=pictures, font_paths=folders, timestamp=0,
            pdf_standards=["ua-1"],
        )  # fmt: skip
    except typst.TypstError as problem:
        if (letter := _MISSING.search(str(problem))) is None:
            raise
        raise NoLetter(letter[1]) from None
    return unscaled(made)


def pages(content: bytes) -> int:
    """The number of pages of a PDF of this writer."""
    return len(re.findall(rb"/Type\s*/Page\b", content))


def _fonts(named: Path | None, chinese: bool) -> tuple[tuple[str, ...], list[str]]:
    """Families in the order in which they are tried, folders beside the system's. Raises NoFont, NoChineseLetters."""
    from matplotlib.ft2font import FT2Font

    from graphkin.outputs.diagram.fonts import chinese_font

    path = named or (Path(os.environ[VARIABLE]) if os.environ.get(VARIABLE) else None)
    own: tuple[str, ...] = ()
    folders: list[str] = []
    if path is not None:
        try:
            own, folders = (FT2Font(str(path)).family_name,), [str(path.parent)]
        except (OSError, RuntimeError):
            raise NoFont(str(path)) from None
    if not chinese:
        return (*own, *_LATIN), folders
    letters = own or tuple(filter(None, [chinese_font()]))
    if not letters:
        raise NoChineseLetters()
    return (*_LATIN, *letters), folders


def _head(handout: Handout, families: tuple[str, ...], page: Paper, scan: int | None) -> str:
    """The settings of all pages; of those that are photographed also their markers, and each one's number."""
    foot, before, number, background = handout.foot, "", "", "none"
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
        width=mm(page.width), height=mm(page.height), margin=mm(_MARGIN + (8 if scan is not None else 0)),
        bottom=mm(_BOTTOM), clear=mm(_CLEAR), bar=_string(foot.bar), foot=_string(foot.words), number=number,
        background=background,
    )  # fmt: skip


def _markup(block: Block, pictures: dict[str, str]) -> str:
    """A block in typst's markup; drawings are kept under the names by which it asks for them."""
    match block:
        case document.HandoutHeading(words, level, said):  # with what the feet say from here on
            foot = f"#state(\"said\", \"\").update({_string(' · ' + said)})\n" if said else ""
            return f"{foot}#heading(level: {level})[{_words(words)}]\n"
        case document.Paragraph(words, act):
            number = f"#act({_string(act)}) " if act else ""
            return f"#par[{number}{_words(words)}]\n"
        case document.FormulaLine(words):
            return f"#pad(left: 8mm, par[{_words(words)}])\n"
        case document.TermRows():  # terms, directions, sizes; a blank is a line to write on
            rule = "#box(width: 20mm, height: 6mm, stroke: (bottom: 0.18mm))"
            cells = [f"[{_words(cell) if cell is not None else rule}]" for line in block.lines for cell in line]
            shape = f"columns: {len(block.lines[0])}, align: center + horizon, column-gutter: 2mm, row-gutter: 2mm"
            return f"#block(breakable: false, pad(left: 8mm, grid({shape}, {', '.join(cells)})))\n"
        case document.HandoutPicture(sheet, words):
            name, image = _image(pictures, svg(sheet), sheet.paper.width, words)
            return f"#drawn({_string(name)}, {image})\n"
        case document.GridRoom():
            _, image = _image(pictures, room_svg(block), block.width, "".join(run.text for run in block.name))
            return f"#align(center, {image})\n"
        case document.HandoutTable(heads, rows):
            cells = [f"[{_words(cell)}]" for row in rows for cell in row]
            first = ", ".join(f"[{_words(head)}]" for head in heads)
            wide = mm(min(30, 152 / len(heads)))
            shape = f"columns: ({wide}mm,) * {len(heads)}, rows: 8mm, align: center + horizon, stroke: 0.18mm"
            return f"#block(breakable: false, table({shape}, table.header({first}), {', '.join(cells)}))\n"
        case document.NewPage(front):
            return "#pagebreak(weak: true" + (', to: "odd"' if front else "") + ")\n"
        case _:
            assert_never(block)


def _image(pictures: dict[str, str], text: str, width: float, words: str) -> tuple[str, str]:
    """The name of a drawing, and what shows it."""
    name, own_font = f"picture{len(pictures)}", r'<tspan font-family="Libertinus Serif">\1</tspan>'
    pictures[name] = _BETWEEN_TAGS.sub(lambda part: _ACCENTED.sub(own_font, part[0]), text)
    return name, f'image(bytes(sys.inputs.{name}), format: "svg", width: {mm(width)}mm, alt: {_string(words)})'


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
    parts = (_string(part) if not k % 2 else f'text(font: "Libertinus Serif", {_string(part)})'
             for k, part in enumerate(_ACCENTED.split(run.text)) if part)  # fmt: skip
    return "".join(f"#emph({part})" if run.italic else f"#{part}" for part in parts)


def _string(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'
