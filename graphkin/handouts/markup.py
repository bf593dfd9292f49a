"""A handout as a web page that needs nothing but itself; a written solution also as LaTeX and as Markdown."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from html import escape
from typing import assert_never

import graphkin
from graphkin.api import Drawing
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.handouts import document
from graphkin.handouts.document import Block, Foot, Handout, HandoutPart, HandoutPicture
from graphkin.handouts.grid import room_svg
from graphkin.handouts.paging import page_parts
from graphkin.handouts.stages import blocks_of
from graphkin.outputs.svg import inline
from graphkin.outputs.typesetting import html_words, signs, tex_words
from graphkin.say.catalogue import say
from graphkin.say.entry import Heading
from graphkin.say.explained import derivation
from graphkin.sheet import scales_of
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.mechanism_sheet import mechanism_sheet
from graphkin.sheet.paper import KEYS, PAPERS

MARK = "graphkin solution"
"""By this graphkin knows a written solution of its own; a handout's page says `graphkin handout`."""


def solution(
    drawing: Drawing, lang: Lang, *, everything: bool = False, only: Plane = "acceleration", drawn: bool = False
) -> Handout:
    """The written solution that `explain` prints, as blocks, at the scales of the sheet; `drawn`: with its figures."""
    scales = {KEYS[plane]: scale for plane, scale in scales_of(drawing.method, drawing.plot).items()}
    entries = derivation(drawing.method, drawing.plot, scales, lang, everything, only)
    digest = hashlib.sha256(drawing.mechanism.text.encode()).hexdigest()[:12]
    foot = Foot(say("handouts.stage solution", lang), graphkin.__version__, digest, "", say("handouts.bar", lang))
    machine = replace(drawing.mechanism, scales=scales)
    method, blocks = replace(drawing.method, mechanism=machine), list[Block]()
    plane: Plane | None = None
    for each in entries:
        if isinstance(each, Heading):
            if plane is not None and drawn:  # all of it is told
                sheet = mechanism_sheet(method, drawing.plot, lang=lang, only=plane, tight=True, told=True)
                blocks.append(HandoutPicture(sheet, say(f"sheet.plane {plane}", lang)))
            plane = each.plane
        blocks += blocks_of([each], lang, machine.points)
    return Handout(machine.headline(lang), lang, (HandoutPart(lang, foot), *blocks))


_STYLE = """@page{{size:{width}mm {height}mm;margin:15mm 20mm 20mm}}
body,mi,mn,mtext{{font-family:"Times New Roman","Liberation Serif",Tinos,"Noto Serif CJK SC","Source Han Serif SC",
SimSun,serif}}body{{font-size:10.5pt;line-height:1.45;max-width:{room}mm;margin:0 auto}}
h1{{font-size:15pt}}h2{{font-size:12pt;break-after:avoid}}
math{{font-family:"DejaVu Math TeX Gyre","TeX Gyre Termes Math","XITS Math","STIX Two Math",math}}
mi{{font-style:italic;text-transform:none}}
.formula{{margin-left:8mm}}figure{{margin:3mm 0;text-align:center;break-inside:avoid}}svg{{max-width:none}}
table{{border-collapse:collapse;break-inside:avoid}}.filled td,.filled th{{border:.18mm solid;min-width:24mm;
height:7mm;padding:0 2mm;text-align:center;font-weight:normal}}.rows{{margin-left:8mm}}.rows td{{text-align:center;
padding:.6mm 1mm}}.rule{{display:inline-block;width:20mm;height:6mm;border-bottom:.18mm solid}}
footer{{margin-top:8mm;font-size:8pt;display:flex;justify-content:space-between;align-items:flex-end}}
.bar{{width:100mm;height:2mm;border:solid;border-width:.35mm .18mm 0}}
.part{{break-inside:avoid}}section+section{{break-before:page}}
.names{{display:flex;gap:2mm;align-items:flex-end}}.names .rule{{flex:1}}
.new{{break-before:page}}.front{{break-before:right}}
small{{font-size:8pt;font-weight:normal}}
.act{{display:inline-block;min-width:3.6mm;line-height:3.6mm;border:.2mm solid;border-radius:2mm;text-align:center;
font-size:7.5pt}}"""


def html(handout: Handout, paper: str = "A4") -> str:
    """The whole page: MathML, drawings in it, printed in true millimetres."""
    size = PAPERS[paper]
    style = _STYLE.format(width=size.width, height=size.height, room=size.width - 40)
    body = "\n".join(_section(part, blocks) for part, blocks in handout.parts)
    return (
        f'<!DOCTYPE html>\n<html lang="{handout.lang}"><head><meta charset="utf-8">'
        f'<meta name="generator" content="graphkin handout"><title>{escape(handout.title)}</title>\n'
        f"<style>{style}</style></head>\n<body>\n{body}\n</body></html>\n"
    )


def _section(part: HandoutPart, blocks: list[Block]) -> str:
    """A part with the list of its problems, and its foot."""
    contents = ""
    if part.contents:
        heads = (block for block in blocks if isinstance(block, document.HandoutHeading) and block.level == 1)
        items = "".join(f"<li>{html_words(head.words)}</li>" for head in heads)
        contents = f"<h1>{escape(part.contents)}</h1>\n<ol>{items}</ol>\n"
    bar = f'<div><div class="bar"></div>{escape(part.foot.bar)}</div>'
    together = ("\n".join(map(block_html, each.blocks)) for each in page_parts(blocks))
    body = "\n".join(f'<div class="part">{each}</div>' for each in together)
    foot = f"<footer>{bar}<span>{escape(part.foot.words)}</span></footer>"
    return f'<section lang="{part.lang}">\n{contents}{body}\n{foot}\n</section>'


def block_html(block: Block) -> str:
    """A block of a page."""
    match block:
        case document.HandoutHeading(words, level, said):
            whose = said and said not in "".join(run.text for run in words)
            small = f" <small>{escape(said)}</small>" if whose else ""
            return f"<h{level}>{html_words(words)}{small}</h{level}>"
        case document.Paragraph(words, act):
            number = f'<span class="act">{escape(act)}</span> ' if act else ""
            return f"<p>{number}{html_words(words)}</p>"
        case document.FormulaLine(words):
            return f'<p class="formula">{html_words(words)}</p>'
        case document.TermRows():
            rule = '<span class="rule"></span>'
            lines = ([rule if cell is None else html_words(cell) for cell in line] for line in block.lines)
            return '<table class="rows">' + "".join(_row("td", line) for line in lines) + "</table>"
        case document.BlankLine(words):
            blanks = (f'<span>{html_words(word)}</span><span class="rule"></span>' for word in words)
            return f'<p class="names">{"".join(blanks)}</p>'
        case document.HandoutPicture(sheet, words, number):
            caption = f"<figcaption>{escape(number)}</figcaption>" if number else ""
            return f'<figure><div role="img" aria-label="{escape(words)}">{inline(sheet)}</div>{caption}</figure>'
        case document.GridRoom():
            return f"<figure>{room_svg(block)}</figure>"
        case document.HandoutTable(heads, rows):
            body = "".join(_row("td", map(html_words, row)) for row in rows)
            return f'<table class="filled">{_row("th", map(html_words, heads))}{body}</table>'
        case document.NewPage(front):
            return f'<div class="{"front" if front else "new"}"></div>'
        case document.HandoutPart():
            raise TypeError("a part has no place in another")
        case _:
            assert_never(block)


def _row(tag: str, cells: Iterable[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" for cell in cells) + "</tr>"


_TEX_PAGE = r"""\usepackage[margin=25mm]{geometry}
\raggedright
\newsavebox{\wide}
% an equation that is wider than the page is made smaller
\newcommand{\fit}[1]{\sbox{\wide}{#1}%
  \ifdim\wd\wide>0.95\linewidth\resizebox{0.95\linewidth}{!}{\usebox{\wide}}\else\usebox{\wide}\fi}"""


def tex(handout: Handout) -> str:
    """A LaTeX file that stands alone; Chinese wants xelatex."""
    chinese = [r"\usepackage[fontset=fandol]{ctex}"] if handout.lang == "zh" else []
    body = "\n\n".join(map(_latex, handout.parts[0][1]))
    head = [f"% {MARK}", r"\documentclass[a4paper]{article}", r"\usepackage{amsmath,amssymb,graphicx}", *chinese]
    return "\n".join([*head, _TEX_PAGE, r"\begin{document}", body, r"\end{document}", ""])


def _latex(block: Block) -> str:
    match block:
        case document.HandoutHeading(words):
            return rf"\subsection*{{{tex_words(words)}}}"
        case document.Paragraph(words, act):
            number = rf"\textcircled{{\scriptsize {act}}} " if act else ""
            return rf"\noindent {number}{tex_words(words)}"
        case document.FormulaLine(words):
            return rf"\quad {tex_words(words)}"
        case document.TermRows():
            lines = (" & ".join(tex_words(cell or ()) for cell in line) for line in block.lines)
            table = rf"\begin{{tabular}}{{{'c' * len(block.lines[0])}}}" + r" \\ ".join(lines) + r"\end{tabular}"
            return rf"\quad\fit{{{table}}}"
        case _:
            raise TypeError(f"{type(block).__name__} has no place in a solution of words alone")


def markdown(handout: Handout) -> str:
    """Plain Markdown: subscripts and parts as HTML has them, equations as tables."""
    return "\n\n".join([f"<!-- {MARK} -->", *map(_markdown, handout.parts[0][1])]) + "\n"


def _markdown(block: Block) -> str:
    match block:
        case document.HandoutHeading(words):
            return f"## {_markdown_words(words)}"
        case document.Paragraph(words, act):
            return (f"({act}) " if act else "") + _markdown_words(words)
        case document.FormulaLine(words):
            return f"> {_markdown_words(words)}"
        case document.TermRows():
            lines = ["| " + " | ".join(_markdown_words(cell or ()) for cell in line) + " |" for line in block.lines]
            return "\n".join([lines[0], "|" + ":-:|" * len(block.lines[0]), *lines[1:]])
        case _:
            raise TypeError(f"{type(block).__name__} has no place in a solution of words alone")


def _markdown_words(label: Label) -> str:
    text = ""
    for sign in signs(label):
        base, low, high = ("".join(map(_markdown_run, runs)) for runs in sign.runs)
        text += base + (f"<sup>{high}</sup>" if high else "") + (f"<sub>{low}</sub>" if low else "")
    return text


def _markdown_run(run: Run) -> str:
    text = "".join("\\" + letter if letter in "\\`*_<>#|[]" else letter for letter in run.text)
    return f"*{text}*" if run.italic and text.strip() else text


WRITERS: Mapping[str, Callable[[Handout], str]] = {".html": html, ".tex": tex, ".md": markdown}  # by the file's ending
