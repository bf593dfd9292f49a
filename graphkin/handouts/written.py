"""A written solution alone, without drawings: as LaTeX, Markdown, or a page of its own."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping

import graphkin
from graphkin.api import Drawing
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.handouts.document import Foot, Handout, Paragraph, TermRows
from graphkin.handouts.medium import Medium
from graphkin.handouts.page import html
from graphkin.handouts.scripted import Sign, signs
from graphkin.handouts.stages import blocks_of
from graphkin.outputs.tex_words import tex_words
from graphkin.say.catalogue import say
from graphkin.say.explained import derivation
from graphkin.sheet import scales_of
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.paper import KEYS

MARK = "graphkin solution"


def solution(drawing: Drawing, lang: Lang, *, everything: bool = False, only: Plane = "acceleration") -> Handout:
    """What `explain` prints, as blocks, at the scales of the sheet."""
    scales = {KEYS[plane]: scale for plane, scale in scales_of(drawing.method, drawing.plot, lang).items()}
    entries = derivation(drawing.method, drawing.plot, scales, lang, everything, only)
    digest = hashlib.sha256(drawing.mechanism.text.encode()).hexdigest()[:12]
    foot = Foot(say("handouts.stage solution", lang), graphkin.__version__, digest, "", say("handouts.bar", lang))
    return Handout(drawing.mechanism.headline(lang), lang, tuple(blocks_of([*entries], lang)), foot)


# --- LaTeX ------------------------------------------------------------------------------------

_TEX_PAGE = r"""\usepackage[margin=25mm]{geometry}
\raggedright
\newsavebox{\wide}
% an equation that is wider than the page is made smaller
\newcommand{\fit}[1]{\sbox{\wide}{#1}%
  \ifdim\wd\wide>0.95\linewidth\resizebox{0.95\linewidth}{!}{\usebox{\wide}}\else\usebox{\wide}\fi}"""


def tex(found: Handout) -> str:
    """A LaTeX file that stands alone; Chinese wants xelatex."""
    chinese = [r"\usepackage[fontset=fandol]{ctex}"] if found.lang == "zh" else []
    body = _TEX.written(found.blocks, "\n\n")
    head = [f"% {MARK}", r"\documentclass[a4paper]{article}", r"\usepackage{amsmath,amssymb,graphicx}", *chinese]
    return "\n".join([*head, _TEX_PAGE, r"\begin{document}", body, r"\end{document}", ""])


def _tex_text(text: Paragraph) -> str:
    number = rf"\textcircled{{\scriptsize {text.act}}} " if text.act else ""
    return rf"\noindent {number}{tex_words(text.words)}"


def _tex_rows(rows: TermRows) -> str:
    lines = (" & ".join(tex_words(cell or ()) for cell in line) for line in rows.lines)
    table = rf"\begin{{tabular}}{{{'c' * len(rows.lines[0])}}}" + r" \\ ".join(lines) + r"\end{tabular}"
    return rf"\quad\fit{{{table}}}"


_TEX = Medium(
    lambda heading: rf"\subsection*{{{tex_words(heading.words)}}}",
    _tex_text,
    lambda formula: rf"\quad {tex_words(formula.words)}",
    _tex_rows,
)


# --- Markdown ---------------------------------------------------------------------------------


def markdown(found: Handout) -> str:
    """Plain Markdown: subscripts and parts as HTML has them, equations as tables."""
    body = _MARKDOWN.written(found.blocks, "\n\n")
    return f"<!-- {MARK} -->\n\n{body}\n"


def _markdown_rows(rows: TermRows) -> str:
    lines = ["| " + " | ".join(_plain_words(cell or ()) for cell in line) + " |" for line in rows.lines]
    return "\n".join([lines[0], "|" + ":-:|" * len(rows.lines[0]), *lines[1:]])


_MARKDOWN = Medium(
    lambda heading: f"## {_plain_words(heading.words)}",
    lambda text: (f"({text.act}) " if text.act else "") + _plain_words(text.words),
    lambda formula: f"> {_plain_words(formula.words)}",
    _markdown_rows,
)


def _plain_words(label: Label) -> str:
    return "".join(map(_plain_sign, signs(label)))


def _plain_sign(sign: Sign) -> str:
    base = _plain_run(sign.base) if sign.base is not None else ""
    low, high = ("".join(map(_plain_run, runs)) for runs in (sign.low, sign.high))
    return base + (f"<sup>{high}</sup>" if high else "") + (f"<sub>{low}</sub>" if low else "")


def _plain_run(run: Run) -> str:
    text = "".join("\\" + letter if letter in "\\`*_<>#|[]" else letter for letter in run.text)
    return f"*{text}*" if run.italic and text.strip() else text


WRITERS: Mapping[str, Callable[[Handout], str]] = {".html": html, ".tex": tex, ".md": markdown}
"""By the file's ending."""
