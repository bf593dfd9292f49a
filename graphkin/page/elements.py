"""Elements of HTML and of drawings in it, as text; labels as a page's scripts letter them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from graphkin.base.plain import Plain
from graphkin.errors import Lang
from graphkin.outputs.typesetting import signs
from graphkin.say.catalogue import LANGUAGES
from graphkin.sheet.lettering import Label

Attributes = Mapping[str, str | float | bool | None]
"""Those that are None or False are left out, those that are True stand without a value."""

TAGS: Mapping[Lang, str] = {"en": "en", "zh": "zh-CN"}
_EMPTY = ("input",)  # have no end


def element(tag: str, attributes: Attributes, *inside: str) -> str:
    """An element with these inside, which are HTML themselves."""
    said = "".join(f" {name}" if value is True else f' {name}="{escape(_text(value))}"'
                   for name, value in attributes.items() if value is not None and value is not False)  # fmt: skip
    return f"<{tag}{said}>" + ("" if tag in _EMPTY else f"{''.join(inside)}</{tag}>")


def _text(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:.10g}"


def worded(tag: str, word: str, attributes: Attributes | None = None) -> str:
    """An element that holds a phrase in the language of the page."""
    return element(tag, {**(attributes or {}), "data-word": word})


def select(attributes: Attributes, options: Iterable[tuple[str, str]]) -> str:
    """One of some values is chosen: value and text of each."""
    every = (element("option", {"value": value}, escape(text)) for value, text in options)
    return element("select", attributes, *every)


def tick_box(attributes: Attributes, words: str) -> str:
    """A box that is ticked, with words behind it."""
    return element("label", {}, element("input", {"type": "checkbox", **attributes}), " ", words)


def in_languages(words: Mapping[Lang, str]) -> str:
    """Words, which are HTML, in each language: the page shows those in its own."""
    return "".join(element("span", {"lang": TAGS[lang]}, words[lang]) for lang in LANGUAGES)


def signs_of(label: Label) -> list[list[Plain]]:
    """Each sign of a label: letters, whether they lean, what stands below and above."""
    every: list[list[Plain]] = []
    for sign in signs(label):
        base, low, high = ("".join(run.text for run in each) for each in sign.runs)
        leans = int(sign.base is not None and sign.base.italic)
        every.append([base, leans, low, high] if low or high else [base, leans] if leans else [base])
    return every
