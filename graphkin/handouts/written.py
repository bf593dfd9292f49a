"""A written solution alone, without drawings: as LaTeX, Markdown, or a page of its own."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from typing import assert_never

import graphkin
from graphkin.api import Drawing
from graphkin.construction import Plane
from graphkin.errors import Lang
from graphkin.handouts.document import Block, Foot, Formula, Handout, Heading, NewPage, Picture, Room, Rows, Table, Text
from graphkin.handouts.page import html
from graphkin.handouts.scripted import Sign, signs
from graphkin.handouts.stages import blocks_of
from graphkin.outputs.tex_words import tex_words
from graphkin.say.catalogue import say
from graphkin.say.explained import derivation
from graphkin.sheet import scales_of
from graphkin.sheet.lettering import Label, Run
from graphkin.sheet.scales import KEYS

MARK = "graphkin solution"


def solution(drawing: Drawing, lang: Lang, *, everything: bool = False, only: Plane = "acceleration") -> Handout:
    """What `explain` prints, as blocks, at the scales of the sheet."""
    scales = {KEYS[plane]: scale for plane, scale in scales_of(drawing.method, drawing.plot, lang).items()}
    entries = derivation(drawing.method, drawing.plot, scales, lang, everything, only)
    digest = hashlib.sha256(drawing.mechanism.text.encode()).hexdigest()[:12]
    foot = Foot(say("handouts.stage solution", lang), graphkin.__version__, digest, "", say("handouts.bar", lang))
    return Handout(drawing.mechanism.headline(lang), lang, tuple(blocks_of([*entries], lang)), foot)


# --- LaTeX ------------------------------------------------------------------------------------


def tex(found: Handout) -> str:
    """A LaTeX file that stands alone; Chinese wants xelatex."""
    chinese = [r"\usepackage[fontset=fandol]{ctex}"] if found.lang == "zh" else []
    body = "\n\n".join(line for block in found.blocks for line in _tex(block))
    head = [f"% {MARK}", r"\documentclass[a4paper]{article}", r"\usepackage{amsmath,amssymb}", *chinese]
    return "\n".join([*head, r"\begin{document}", body, r"\end{document}", ""])


def _tex(block: Block) -> Iterator[str]:
    match block:
        case Heading(words):
            yield rf"\subsection*{{{tex_words(words)}}}"
        case Text(words, act):
            number = rf"\textcircled{{\scriptsize {act}}} " if act else ""
            yield rf"\noindent {number}{tex_words(words)}"
        case Formula(words):
            yield rf"\quad {tex_words(words)}"
        case Rows():
            columns = [((), *block.heads), *(column or ((), (), ()) for column in block.columns)]
            lines = (" & ".join(tex_words(column[k]) for column in columns) for k in range(3))
            yield rf"\quad\begin{{tabular}}{{{'c' * len(columns)}}}" + r" \\ ".join(lines) + r"\end{tabular}"
        case Table() | Picture() | Room() | NewPage():
            raise AssertionError("a solution alone has words and equations")
        case _:
            assert_never(block)


# --- Markdown ---------------------------------------------------------------------------------


def markdown(found: Handout) -> str:
    """Plain Markdown: subscripts and parts as HTML has them, equations as tables."""
    body = "\n\n".join(line for block in found.blocks for line in _markdown(block))
    return f"<!-- {MARK} -->\n\n{body}\n"


def _markdown(block: Block) -> Iterator[str]:
    match block:
        case Heading(words):
            yield f"## {_plain_words(words)}"
        case Text(words, act):
            yield (f"({act}) " if act else "") + _plain_words(words)
        case Formula(words):
            yield f"> {_plain_words(words)}"
        case Rows():
            columns = [((), *block.heads), *(column or ((), (), ()) for column in block.columns)]
            lines = ["| " + " | ".join(_plain_words(column[k]) for column in columns) + " |" for k in range(3)]
            yield "\n".join([lines[0], "|" + ":-:|" * len(columns), *lines[1:]])
        case Table() | Picture() | Room() | NewPage():
            raise AssertionError("a solution alone has words and equations")
        case _:
            assert_never(block)


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
