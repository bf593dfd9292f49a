"""The letters of a motion diagram: Times-like STIX, which comes with matplotlib, and a Chinese font of the system."""

from __future__ import annotations

import re
from functools import cache
from typing import ClassVar

from graphkin.errors import GraphkinError, Lang
from graphkin.sheet.lettering import Label

LATIN = "STIXGeneral"
_CHINESE = (
    "Noto Serif CJK SC", "Source Han Serif SC", "Source Han Serif CN", "Noto Serif SC", "Songti SC", "STSong", "SimSun",
    "NSimSun", "AR PL UMing CN", "Noto Serif CJK JP", "Noto Sans CJK SC", "Source Han Sans SC", "Noto Sans SC",
    "PingFang SC", "Microsoft YaHei", "SimHei", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei", "Droid Sans Fallback",
    "Noto Sans CJK JP",
)  # fmt: skip
_FILES = re.compile(r"cjk|source ?han|song|simsun|simhei|msyh|pingfang|uming|wqy|droidsansfallback|notos\w+sc", re.I)
_WIDE = re.compile("[\u2e80-\u9fff\uf900-\ufaff\uff00-\uffef\u3000-\u303f]")
_MATHS = re.compile("[ -~θωαμφ′−×]*")
"""Letters that stand in mathematics; names in others are written plainly."""
_GREEK = {"θ": r"\theta", "ω": r"\omega", "α": r"\alpha", "μ": r"\mu", "φ": r"\varphi"}
_SIGNS = {" ": r"\ ", "-": r"\text{-}", "_": r"\_", "/": "/"}
_RELATIONS = {" = ": "=", " + ": "+"}


class NoChineseFont(GraphkinError):
    """A Chinese diagram on a machine without Chinese letters: it is drawn in English."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "No Chinese font was found, so the diagram has no Chinese text. Install one, such as Noto Serif CJK SC "
        "or WenQuanYi Micro Hei, and draw again.",
        "zh": "未找到中文字体，线图中没有中文。请安装中文字体（如 Noto Serif CJK SC 或文泉驿微米黑）后重新绘制。",
    }


@cache
def chinese_font() -> str | None:
    """The name of a font with Chinese letters, None where there is none; newly installed ones are found, too."""
    from matplotlib.font_manager import findSystemFonts, fontManager

    if (name := _known()) is not None:
        return name
    old = {entry.fname for entry in fontManager.ttflist}
    for path in sorted(findSystemFonts()):
        if path not in old and _FILES.search(path):
            try:
                fontManager.addfont(path)
            except (OSError, RuntimeError):
                continue
    return _known()


def _known() -> str | None:
    from matplotlib.font_manager import fontManager

    names = {entry.name for entry in fontManager.ttflist}
    return next((name for name in _CHINESE if name in names), None)


def letters() -> list[str]:
    """Font families in the order in which a letter is looked for."""
    found = chinese_font()
    return [LATIN] if found is None else [LATIN, found]


def has_chinese(text: str) -> bool:
    return _WIDE.search(text) is not None


def writable(text: str) -> str:
    """The text in one line, with a question mark for each letter that no font here has."""
    families = tuple(letters())
    return "".join(letter if _has(families, letter) else "?" for letter in " ".join(text.split()))


@cache
def _has(families: tuple[str, ...], letter: str) -> bool:
    from matplotlib.font_manager import findfont, get_font

    fonts = (get_font(findfont(family)) for family in families)
    return letter.isprintable() and any(font.get_char_index(ord(letter)) for font in fonts)


def typeset(label: Label) -> str:
    """A label of the drawings as matplotlib writes it: θ₃ as `$\\theta_{\\mathrm{3}}$`; Chinese names stay outside."""
    if not all(_MATHS.fullmatch(run.text) for run in label):
        return plain(label)
    parts: list[str] = []
    place = "base"
    for run in label:
        text = _run(run.text, run.italic)
        if run.place == place and place != "base":
            parts[-1] = f"{parts[-1][:-1]}{text}}}"
        else:
            parts.append(text if run.place == "base" else f"{'_' if run.place == 'sub' else '^'}{{{text}}}")
        place = run.place
    return f"${''.join(parts)}$"


def _run(text: str, italic: bool) -> str:
    if known := _GREEK.get(text) or _RELATIONS.get(text):
        return known
    letters = "".join(_SIGNS.get(letter, letter) for letter in text)
    return rf"\mathit{{{letters}}}" if italic else rf"\mathrm{{{letters}}}"


def plain(label: Label) -> str:
    """A label in one line: `θ 滑块`."""
    parts: list[str] = []
    place = "base"
    for run in label:
        parts.append(run.text if run.place == place or not parts else f" {run.text}")
        place = run.place
    return writable("".join(parts))
