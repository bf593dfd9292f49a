"""The letters of a motion diagram: Times-like STIX, which comes with matplotlib, and a Chinese font of the system."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import groupby
from typing import TYPE_CHECKING

from graphkin.errors import GraphkinError
from graphkin.sheet.lettering import Label, formula

if TYPE_CHECKING:
    from matplotlib.offsetbox import OffsetBox

MARK = "https://graphkin.invalid/diagram/1"  # by this graphkin knows a diagram of its own, whatever the format
LATIN = "STIXGeneral"
_CHINESE = (
    "Noto Serif CJK SC", "Source Han Serif SC", "Source Han Serif CN", "Noto Serif SC", "Songti SC", "STSong", "SimSun",
    "NSimSun", "AR PL UMing CN", "Noto Serif CJK JP", "Noto Sans CJK SC", "Source Han Sans SC", "Noto Sans SC",
    "PingFang SC", "Microsoft YaHei", "SimHei", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei", "Droid Sans Fallback",
    "Noto Sans CJK JP",
)  # fmt: skip
_BLANK = 0.25  # its width, as part of the size of letters
_FILES = re.compile(r"cjk|source ?han|song|simsun|simhei|msyh|pingfang|uming|wqy|droidsansfallback|notos\w+sc", re.I)
_WIDE = re.compile("[\u2e80-\u9fff\uf900-\ufaff\uff00-\uffef\u3000-\u303f]")
_MATHS = re.compile("[ -~θωαμφ′−×]*")  # letters that stand in mathematics; names in others are written plainly
_RELATIONS = {" = ": "=", " + ": "+", "θ": r"\theta", "ω": r"\omega", "α": r"\alpha", "μ": r"\mu", "φ": r"\varphi"}
_SIGNS = {" ": r"\ ", "-": r"\text{-}", "_": r"\_", "/": "/"}


class NoChineseFont(GraphkinError):
    """A Chinese diagram on a machine without Chinese letters: it is drawn in English."""

    en = (
        "No Chinese font was found, so the diagram has no Chinese text. Install one, such as Noto Serif CJK SC "
        "or WenQuanYi Micro Hei, and draw again."
    )
    zh = "未找到中文字体，线图中没有中文。请安装中文字体（如 Noto Serif CJK SC 或文泉驿微米黑）后重新绘制。"


@cache
def chinese_font() -> str | None:
    """The name of a font with Chinese letters, None where there is none; newly installed ones are found, too."""
    from matplotlib.font_manager import findSystemFonts, fontManager

    def known() -> str | None:
        names = {entry.name for entry in fontManager.ttflist}
        return next((name for name in _CHINESE if name in names), None)

    if (name := known()) is not None:
        return name
    old = {entry.fname for entry in fontManager.ttflist}
    for path in sorted(findSystemFonts()):
        if path not in old and _FILES.search(path):
            try:
                fontManager.addfont(path)
            except (OSError, RuntimeError):
                continue
    return known()


def letters() -> list[str]:
    """Font families in the order in which a letter is looked for."""
    chinese = chinese_font()
    return [LATIN, *([] if chinese is None else [chinese]), "DejaVu Sans"]  # matplotlib's own, with raised letters


def has_chinese(text: str) -> bool:
    """True where a text has Chinese letters."""
    return _WIDE.search(text) is not None


def writable(text: str) -> str:
    """The text in one line, with a question mark for each letter that no font here has."""
    from matplotlib.font_manager import findfont, get_font

    fonts, line = [get_font(findfont(family)) for family in letters()], " ".join(text.split())
    there = {c for c in line if c.isprintable() and any(font.get_char_index(ord(c)) for font in fonts)}
    return "".join(letter if letter in there else "?" for letter in line)


def pieces(line: str, size: float) -> Iterator[OffsetBox]:
    """Words and formulas of a line by themselves: beside Chinese letters matplotlib sets none. A blank with which a
    piece begins is room before it: a viewer of SVG leaves such a blank out."""
    from matplotlib.offsetbox import DrawingArea, TextArea

    for symbols, runs in groupby(formula(line), lambda run: run.italic or run.place != "base"):
        label = tuple(runs)
        text = typeset(label) if symbols else "".join(run.text for run in label)
        yield DrawingArea((len(text) - len(text.lstrip())) * _BLANK * size, 0)
        yield TextArea(text.lstrip(), textprops={"fontsize": size, "parse_math": symbols})


def typeset(label: Label) -> str:
    """A label of the drawings as matplotlib writes it: θ₃ as `$\\theta_{\\mathrm{3}}$`; Chinese names stay outside, as
    `θ 滑块` in one line."""
    runs = [(place, list(some)) for place, some in groupby(label, key=lambda run: run.place)]
    if not all(_MATHS.fullmatch(run.text) for run in label):
        return writable(" ".join("".join(run.text for run in some) for _, some in runs))
    text = ""
    for place, some in runs:
        inside = ""
        for run in some:
            signs = "".join(_SIGNS.get(letter, letter) for letter in run.text)
            inside += _RELATIONS.get(run.text) or (rf"\mathit{{{signs}}}" if run.italic else rf"\mathrm{{{signs}}}")
        text += inside if place == "base" else f"{'_' if place == 'sub' else '^'}{{{inside}}}"
    return f"${text}$"
