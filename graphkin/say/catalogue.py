"""The catalogue: everything graphkin says but its errors, which bring their own words.

A phrase is an English and a Chinese text with the same placeholders. It is asked for by its full name, `subject.key`:
`say("sweeps.range", lang, driver=..)`. It stands under that name in the file of its subject in `phrases`, which is
imported when first needed; small subjects share a file.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib import import_module
from typing import get_args

from graphkin.base.value import frozen
from graphkin.errors import Lang

Phrases = Mapping[str, tuple[str, str]]  # by full name: English, Chinese

SHARED_FILES: Mapping[str, tuple[str, ...]] = {
    "centres": ("about",),
    "common": ("usage",),
    "derivation": ("solution",),
    "file_help": ("file_page", "file_keys"),
    "homework": ("problems", "assembly", "platforms", "feedback", "class_report"),
    "linkages": ("design",),
    "marking": ("marks", "mistakes", "verdicts", "tolerances", "discriminability"),
    "page": ("quiz", "layers", "photo", "board"),
    "results": ("checks", "structure", "sweeps", "finding"),
    "sheets": ("sheet", "diagrams", "pictures", "handouts", "equations"),
}
"""The subjects in a file of `phrases` beside that after which it is called."""
_FILE_OF = {subject: file for file, subjects in SHARED_FILES.items() for subject in subjects}

LANGUAGES: tuple[Lang, ...] = get_args(Lang)
_WORD, _SIGN = "[\u4e00-\u9fff]", "[（）；，。、：]"
_START, _END = "\ue002", "\ue003"
_LETTER = "[A-Za-z0-9\u0370-\u03ff\ue000\ue100-\uf8ff]"  # with those that stand for figures that are noted
_BESIDE = f"(?<={_WORD}){_START}+(?={_LETTER})|(?<=[A-Za-z0-9\u0370-\u03ff\u2032\ue001\ue100-\uf8ff]){_END}+(?={_WORD})"
_LOW = f"(_\\w*{_WORD}′*)"  # a word below the line, which would take in those that follow
_CHOICE = re.compile(r"\[([^\[\]]*\|[^\[\]]*)\]")
_EDGE = f"[{_START}{_END}]"
_PART = f"{_WORD}*[件杆架块轮环柄条臂盘缸板塞]"  # a name that says itself what it is, and needs no such word before it
_PARTS = f"({_START}+(?:{_PART}(?:{_END}*[、和]{_START}*|(?={_END})))+)"
_NAMED = re.compile(f"(构件|滑块|齿轮|轮) *{_PARTS}(?:(?={_END})|(?P<more>))")
_TWICE = re.compile(r"\b(link|slider|gear|wheel|pin) \1\b", re.IGNORECASE)
_ROOM = f"{_LOW} +(?={_WORD})|(?<={_WORD}) +(?={_WORD})|(?<={_SIGN}) +(?=\\S)|(?<=\\S) +(?={_SIGN})"


@cache
def _subject(subject: str) -> Phrases:
    phrases: Phrases = import_module(f"{__package__}.phrases.{_FILE_OF.get(subject, subject)}").PHRASES
    return phrases


def phrase(name: str, lang: Lang, which: int = 0) -> str:
    """A phrase as it stands in the catalogue. name: `subject.key`; which: of the words in `[point lies|points lie]`."""
    en, zh = _subject(name.partition(".")[0])[name]
    return _CHOICE.sub(lambda words: words[1].split("|")[which], zh if lang == "zh" else en)


def for_scripts(subject: str) -> dict[str, dict[Lang, str]]:
    """All phrases of a subject in both languages, which the scripts of a page put words into."""
    own = (name for name in _subject(subject) if name.startswith(f"{subject}."))
    return {name: {lang: phrase(name, lang) for lang in LANGUAGES} for name in own}


def is_phrase(name: str) -> bool:
    """True of the name of a phrase; for names made of what comes from outside."""
    return name in _subject(name.partition(".")[0])


def say(name: str, lang: Lang, /, **words: object) -> str:
    """A phrase with these words put in; `which`: the number of those that it leaves a choice of."""
    which = words.get("which", 0)
    assert isinstance(which, int), which
    return phrase(name, lang, which).format(**words)


def in_list(parts: Iterable[str], lang: Lang) -> str:
    """`A, B, C`; `A、B、C`."""
    return say("common.list", lang).join(parts)


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
    """A phrase that data carries; whoever shows the data speaks it."""
    return Meaning(name, tuple(words.items()))


def close(text: str) -> str:
    """Chinese leaves no room between two Chinese words, unless one is a subscript, nor beside its signs."""
    return re.sub(_ROOM, lambda room: f"{room[1]} " if room[1] else "", text)


def say_close(name: str, lang: Lang, /, **words: object) -> str:
    """A phrase filled in, without `slider` before the name `slider`; in Chinese with room between its own words and
    letters and figures, and nowhere else."""
    if lang != "zh":
        return _TWICE.sub(r"\1", say(name, lang, **words))
    held = {key: f"{_START}{word}{_END}" if isinstance(word, str) else word for key, word in words.items()}
    text = say(name, "zh", **held)
    text = _NAMED.sub(lambda named: named[2] + ("" if named["more"] is None else f"{named[1]} "), text)
    text = re.sub(f"{_LOW}{_END}+(?={_WORD})", r"\1 ", re.sub(_BESIDE, " ", text))
    return close(re.sub(_EDGE, "", text))
