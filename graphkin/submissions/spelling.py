"""Text as students type it, made plain: one minus, ASCII digits, superscripts as powers, Greek as words."""

from __future__ import annotations

import re
import unicodedata

_RAISED = re.compile("[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_MINUS = "−–—‐‑‒―﹣－➖"
_ALIKE = str.maketrans({
    **dict.fromkeys(_MINUS, "-"), "º": "°", "˚": "°", "∘": "°", "∕": "/", "⁄": "/", "÷": "/", "·": "*", "⋅": "*",
    "∙": "*", "•": "*", "×": "*", "✕": "*", "﹢": "+", "，": ",", "；": ";", "：": ":", "。": ".", "（": "(", "）": ")",
    "【": "[", "】": "]", "\u2019": "'", "\u2032": "'", "\u02b9": "'", "\u2033": "''", "\u2034": "'''", "\u02bc": "'",
    "´": "'", "`": "'", "＝": "=", "≈": "=", "≅": "=", "≃": "=", "～": "=", "\u200b": "", "\ufeff": "",
})  # fmt: skip


def plain(text: str) -> str:
    """`−3,92 rad/s²` -> `-3,92 rad/s^2`: compatibility letters folded, and what looks alike written one way."""
    text = _RAISED.sub(lambda run: "^" + unicodedata.normalize("NFKC", run.group()).replace("−", "-"), text)
    text = unicodedata.normalize("NFKC", text.translate(_ALIKE)).translate(_ALIKE)
    return " ".join(text.split())


def short(text: str) -> str:
    """On one line and not too long, for a message."""
    return " ".join(text[:200].split())[:60]


def unaccented(text: str) -> str:
    """Without combining marks: the bar or the arrow over a vector's letter."""
    return "".join(letter for letter in unicodedata.normalize("NFD", text) if not unicodedata.combining(letter))
