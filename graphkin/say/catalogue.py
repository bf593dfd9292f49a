"""The catalogue: everything graphkin says but its errors, which bring their own words.

A phrase is an English and a Chinese text with the same placeholders, in the file of its subject in `phrases`. It is
asked for by that file and its key there, `say("sweeps.range", lang, driver=..)`; a file is imported when first needed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import get_args

from graphkin.base.value import frozen
from graphkin.errors import Lang

Phrases = Mapping[str, tuple[str, str]]
"""By key: English, Chinese."""

LANGUAGES: tuple[Lang, ...] = get_args(Lang)
_WORD, _SIGN = "[\u4e00-\u9fff]", "[（）；，。、：]"
_START, _END = "\ue002", "\ue003"
_LETTER = "[A-Za-z0-9\u0370-\u03ff\ue000]"
_BESIDE = f"(?<={_WORD}){_START}+(?={_LETTER})|(?<=[A-Za-z0-9\u0370-\u03ff\u2032\ue001]){_END}+(?={_WORD})"
_EDGE = f"[{_START}{_END}]"
_ROOM = f"(?<={_WORD}) +(?={_WORD})|(?<={_SIGN}) +(?=\\S)|(?<=\\S) +(?={_SIGN})"


def phrase(name: str, lang: Lang) -> str:
    """A phrase as it stands in the catalogue. name: `subject.key`."""
    subject, _, key = name.partition(".")
    en, zh = _phrases(subject)[key]
    return zh if lang == "zh" else en


def is_phrase(name: str) -> bool:
    """Whether there is such a phrase; for names made of what comes from outside."""
    subject, _, key = name.partition(".")
    return key in _phrases(subject)


def say(name: str, lang: Lang, /, **words: object) -> str:
    """A phrase with these words put in."""
    return phrase(name, lang).format(**words)


def in_both(name: str, /, **words: object) -> dict[Lang, str]:
    """The same in each language, for what bears its title in both."""
    return {lang: say(name, lang, **words) for lang in LANGUAGES}


@frozen
class Meaning:
    """A phrase with its words, in no language yet; a word may be such a phrase itself."""

    name: str
    words: tuple[tuple[str, object], ...]

    def spoken(self, lang: Lang) -> str:
        words = {key: word.spoken(lang) if isinstance(word, Meaning) else word for key, word in self.words}
        return say(self.name, lang, **words)


def meaning(name: str, /, **words: object) -> Meaning:
    """What data says of itself; whoever shows it speaks it."""
    return Meaning(name, tuple(words.items()))


def close(text: str) -> str:
    """Chinese leaves no room between two Chinese words, nor beside its signs."""
    return re.sub(_ROOM, "", text)


def set_close(name: str, /, **words: object) -> str:
    """A Chinese phrase with room between its own words and the letters and figures put in, and nowhere else."""
    held = {key: f"{_START}{word}{_END}" if isinstance(word, str) else word for key, word in words.items()}
    return close(re.sub(_EDGE, "", re.sub(_BESIDE, " ", say(name, "zh", **held))))


def say_close(name: str, lang: Lang, /, **words: object) -> str:
    """A phrase filled in, in Chinese set close."""
    return set_close(name, **words) if lang == "zh" else say(name, lang, **words)


@cache
def _phrases(subject: str) -> Phrases:
    found: Phrases = import_module(f"{__package__}.phrases.{subject}").PHRASES
    return found
