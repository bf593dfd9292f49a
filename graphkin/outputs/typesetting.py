"""Labels and words as each kind of file sets them: spans of letters for SVG; LaTeX, DXF, GeoGebra."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from itertools import groupby
from typing import NamedTuple

from graphkin.base.value import frozen
from graphkin.sheet.lettering import Label, Run, advance, is_wide, run_size, run_width, scripts
from graphkin.sheet.marks import Place, Text

LATIN = "Times New Roman, Liberation Serif, Tinos, serif"
_CHINESE = "Noto Serif CJK SC, Source Han Serif SC, Songti SC, SimSun, WenQuanYi Micro Hei, serif"
_CHINESE_SIGNS = "√⊥"  # signs that the Chinese letters have, and Latin ones may not
_AS_BARS = str.maketrans({"∥": "||"})  # of the sign of parallels Chinese letters make one as wide as a character
_DOTTED = {"\u1e61": "s\u02d9", "s\u0308": "s\u00a8"}
"""Letters that few fonts have: another one, and the dots over it by themselves."""
_OVER = 0.07  # so far to the right of where the letter begins the dots begin, which are less wide and lean [em]
_ANY_DOTTED = re.compile(f"({'|'.join(_DOTTED)})")


def mm(value: float) -> str:
    """Four decimals, no trailing zeros."""
    return short(value, 4)


def _is_chinese(letter: str) -> bool:
    """True for a letter that is set in the Chinese letters."""
    return is_wide(letter) or (letter in _CHINESE_SIGNS and letter != "")


def short(value: float, decimals: int = 2) -> str:
    """Two decimals, which is enough for letters."""
    if not math.isfinite(value):
        raise ValueError(f"a coordinate is {value}")
    bare = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if bare == "-0" else bare or "0"


class LetterSpan(NamedTuple):
    """Letters of one script and style; where they begin, and how large they are [mm]."""

    text: str
    at: Place
    size: float
    italic: bool
    bold: bool

    def type(self, size: float) -> dict[str, str]:
        """The type they are set in, where the letters around them have that size and are upright Latin ones."""
        wide = _is_chinese(self.text[:1])
        attributes = {"font-family": _CHINESE} if wide else {}
        attributes |= {"font-size": short(self.size)} if size and self.size != size else {}
        attributes |= {"font-style": "italic"} if self.italic and not wide else {}
        return attributes | ({"font-weight": "bold"} if self.bold else {})


def runs(mark: Text) -> list[LetterSpan]:
    """The letters of a text. Spaces end a span and never begin one: some viewers drop those."""
    spans: list[LetterSpan] = []
    for run, start, drop in scripts(mark.label, mark.size):
        size = run_size(run, mark.size)
        # Chinese and Latin letters apart, and those with dots by themselves
        pieces = [run.text] if run.text.isascii() else _ANY_DOTTED.split(run.text)
        apart = ([piece] if piece in _DOTTED or run.text.isascii() else
                 ["".join(some) for _, some in groupby(piece, _is_chinese)] for piece in pieces)  # fmt: skip
        for text in (text for texts in apart for text in texts):
            bare = text.lstrip(" ")
            spaces = text[: len(text) - len(bare)]
            if spaces and spans:
                spans[-1] = spans[-1]._replace(text=spans[-1].text + spaces)
            at = mark.at + complex(start + advance(spaces, run.italic) * size, drop)
            for k, letters in enumerate(_DOTTED.get(bare, [bare])):
                if letters:
                    letters = letters.translate(_AS_BARS)
                    spans.append(LetterSpan(letters, at + complex(k * _OVER * size), size, run.italic, run.bold))
            start += run_width(run._replace(text=text), mark.size) if text != run.text else 0.0
    return spans


def lettered(mark: Text) -> str:
    """Its letters as a reader of the file finds them."""
    text = "".join(run.text for run in mark.label)
    return text if text.isascii() else _ANY_DOTTED.sub(lambda match: _DOTTED[match[0]], text).translate(_AS_BARS)


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

    def letters(run: Run) -> str:
        text = tex_text(run.text)
        return rf"\textit{{{text}}}" if run.italic else text

    def scripts(high: str, low: str) -> str:
        return "$" + (rf"^{{\text{{{high}}}}}" if high else "") + (rf"_{{\text{{{low}}}}}" if low else "") + "$"

    return _scripted(label, letters, scripts)


def stacked(label: Label) -> str:
    """A label as MTEXT of DXF writes it: a part and a subscript are stacked (`a\\Sn^ CB;`)."""
    escapes = str.maketrans({sign: f"\\{sign}" for sign in "\\{};"})
    return _scripted(label, lambda run: run.text.translate(escapes), lambda high, low: f"{{\\H0.7x;\\S{high}^ {low};}}")


def _scripted(label: Label, letters: Callable[[Run], str], scripts: Callable[[str, str], str]) -> str:
    """A label's letters, each raised part set above the subscript before it."""
    text, low = "", ""
    for run in label:
        if run.place == "sub":
            low += letters(run)
        elif run.place == "sup":
            text, low = text + scripts(letters(run), low), ""
        else:
            text, low = text + (scripts("", low) if low else "") + letters(run), ""
    return text + (scripts("", low) if low else "")


def ggb_text(label: Label) -> str:
    """A label as GeoGebra shows it: subscripts as `_{..}`, a part above them by LaTeX."""
    parts = {"base": "{}", "sub": "_{{{}}}", "sup": "^{{{}}}"}
    text = "".join(parts[run.place].format(run.text.replace("′", "'")) for run in label)
    return f"${text}$" if any(run.place == "sup" for run in label) else text


@frozen
class Sign:
    """A run of letters, and the runs of its subscript and of what is raised."""

    base: Run | None
    low: tuple[Run, ...] = ()
    high: tuple[Run, ...] = ()

    @property
    def runs(self) -> tuple[tuple[Run, ...], ...]:
        """The letters themselves, the subscript, what is raised."""
        return () if self.base is None else (self.base,), self.low, self.high

    @property
    def plain(self) -> str:
        """To be read aloud, or where nothing can be lowered: `a^k_B3B2`."""
        base, low, high = ("".join(run.text for run in runs) for runs in self.runs)
        return base + (f"^{high}" if high else "") + (f"_{low}" if low else "")


def signs(label: Label) -> Iterator[Sign]:
    """Each letter with its scripts, and the text between."""
    base: Run | None = None
    low: tuple[Run, ...] = ()
    high: tuple[Run, ...] = ()
    for run in label:
        if run.place == "sub":
            low += (run,)
        elif run.place == "sup":
            high += (run,)
        elif base is not None and not low and not high and base.italic == run.italic:
            base = base._replace(text=base.text + run.text)
        else:
            if base is not None or low or high:
                yield Sign(base, low, high)
            base, low, high = run, (), ()
    if base is not None or low or high:
        yield Sign(base, low, high)


def html_words(label: Label) -> str:
    """A label on a page of the web."""
    return "".join(map(_mathml, signs(label)))


def _mathml(sign: Sign) -> str:
    """Letters as they are; a letter with scripts as MathML."""
    from html import escape

    base = sign.base
    if not sign.low and not sign.high:
        return "" if base is None else f"<i>{escape(base.text)}</i>" if base.italic else escape(base.text)
    letter = _token(base) if base is not None else "<mrow></mrow>"
    low, high = ("<mrow>" + "".join(map(_token, runs)) + "</mrow>" for runs in (sign.low, sign.high))
    if sign.low and sign.high:
        return f"<math><msubsup>{letter}{low}{high}</msubsup></math>"
    return f"<math><msub>{letter}{low}</msub></math>" if sign.low else f"<math><msup>{letter}{high}</msup></math>"


def _token(run: Run) -> str:
    """Browsers set several letters in one `mi` upright; the page's style slants them as the drawings have them."""
    from html import escape

    kind = "mi" if run.italic else "mn" if run.text.isdigit() else "mtext"
    return f"<{kind}>{escape(run.text).replace(' ', '&#160;')}</{kind}>"
