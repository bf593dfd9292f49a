"""Labels and words as each kind of file sets them: spans of letters for SVG, LaTeX, DXF, GeoGebra."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import groupby

from graphkin.base.value import frozen
from graphkin.sheet.lettering import Label, Run, advance, is_wide, run_size, run_width, scripts
from graphkin.sheet.marks import Place, Text

LATIN = "Times New Roman, Liberation Serif, Tinos, serif"
_CHINESE = "Noto Serif CJK SC, Source Han Serif SC, Songti SC, SimSun, WenQuanYi Micro Hei, serif"
_CHINESE_SIGNS = "√∥⊥"
"""Signs that the Chinese letters have, and Latin ones may not."""
_DOTTED = {"\u1e61": "s\u02d9", "s\u0308": "s\u00a8"}
"""Letters that few fonts have: another one, and the dots over it by themselves."""
_OVER = 0.07
"""So far to the right of where the letter begins the dots begin, which are less wide and lean [em]."""
_ANY_DOTTED = re.compile(f"({'|'.join(_DOTTED)})")


def mm(value: float) -> str:
    """Four decimals, no trailing zeros."""
    return _bare(value, f"{value:.4f}")


def short(value: float) -> str:
    """Two decimals, which is enough for letters."""
    return _bare(value, f"{value:.2f}")


def _bare(value: float, text: str) -> str:
    if not math.isfinite(value):
        raise ValueError(f"a coordinate is {value}")
    bare = text.rstrip("0").rstrip(".")
    return "0" if bare == "-0" else bare or "0"


@frozen
class LetterSpan:
    """Letters of one script and style; where they begin, and how large they are [mm]."""

    text: str
    at: Place
    size: float
    italic: bool
    bold: bool

    def type(self, size: float) -> dict[str, str]:
        """What they are set in, where the letters around them have that size and are upright Latin ones."""
        wide = _is_chinese(self.text[:1])
        found = {"font-family": _CHINESE} if wide else {}
        found |= {"font-size": short(self.size)} if size and self.size != size else {}
        found |= {"font-style": "italic"} if self.italic and not wide else {}
        return found | ({"font-weight": "bold"} if self.bold else {})


def _is_chinese(letter: str) -> bool:
    """Whether it is set in the Chinese letters."""
    return is_wide(letter) or (letter in _CHINESE_SIGNS and letter != "")


def runs(mark: Text) -> list[LetterSpan]:
    """The letters of a text. Spaces end a span and never begin one: some viewers drop those."""
    found: list[LetterSpan] = []
    for run, start, drop in scripts(mark.label, mark.size):
        size = run_size(run, mark.size)
        for text in _of_one_script(run.text):
            bare = text.lstrip(" ")
            spaces = text[: len(text) - len(bare)]
            if spaces and found:
                found[-1] = replace(found[-1], text=found[-1].text + spaces)
            at = mark.at + complex(start + advance(spaces, run.italic) * size, drop)
            letters = _DOTTED.get(bare, [bare])
            over = (complex(k * _OVER * size) for k in range(len(letters)))
            found += [
                LetterSpan(each, at + aside, size, run.italic, run.bold) for each, aside in zip(letters, over) if each
            ]
            start += run_width(run._replace(text=text), mark.size) if text != run.text else 0.0
    return found


def lettered(mark: Text) -> str:
    """Its letters as a reader of the file finds them."""
    text = "".join(run.text for run in mark.label)
    return text if text.isascii() else _ANY_DOTTED.sub(lambda found: _DOTTED[found[0]], text)


def _of_one_script(text: str) -> list[str]:
    """Its letters, Chinese and Latin ones apart, and those with dots by themselves."""
    if text.isascii():
        return [text]
    parts = ([part] if part in _DOTTED else groupby(part, _is_chinese) for part in _ANY_DOTTED.split(text))
    return [each if isinstance(each, str) else "".join(each[1]) for part in parts for each in part]


_TEX_SIGNS = {
    "μ": r"$\mu$", "ω": r"$\omega$", "α": r"$\alpha$", "θ": r"$\theta$", "φ": r"$\varphi$", "ψ": r"$\psi$",
    "γ": r"$\gamma$", "β": r"$\beta$", "δ": r"$\delta$", "π": r"$\pi$", "±": r"$\pm$", "<": "$<$", ">": "$>$",
    "|": "$|$", "°": r"$^\circ$", "·": r"$\cdot$", "→": r"$\to$", "×": r"$\times$", "²": r"$^2$", "³": r"$^3$",
    "′": r"$'$", "″": r"$''$", "−": r"$-$", "⊥": r"$\perp$", "∥": r"$\parallel$", "∠": r"$\angle$", "√": r"$\surd$",
    "△": r"$\triangle$", "∽": r"$\sim$", "ṡ": r"$\dot{s}$", "\0": r"$\ddot{s}$",
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
} | {sign: f"\\{sign}" for sign in "#$%&_{}"}  # fmt: skip


def tex_text(text: str) -> str:
    """Words with everything special escaped."""
    return "".join(_TEX_SIGNS.get(letter, letter) for letter in text.replace("s\u0308", "\0"))


def tex_words(label: Label) -> str:
    """Runs in text style; a part stands above the subscript it goes with."""
    text, low = "", ""
    for run in label:
        letters = _run(run)
        if run.place == "sub":
            low += letters
        elif run.place == "sup":
            text, low = text + _scripts(letters, low), ""
        else:
            text, low = text + _scripts("", low) + letters, ""
    return text + _scripts("", low)


def _run(run: Run) -> str:
    letters = tex_text(run.text)
    return rf"\textit{{{letters}}}" if run.italic else letters


def _scripts(high: str, low: str) -> str:
    if not high and not low:
        return ""
    return "$" + (rf"^{{\text{{{high}}}}}" if high else "") + (rf"_{{\text{{{low}}}}}" if low else "") + "$"
