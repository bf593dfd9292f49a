"""Mistakes in words: what was done, and where to look again."""

from __future__ import annotations

from collections.abc import Iterable

from graphkin.errors import Lang
from graphkin.marking.key import Name
from graphkin.say.catalogue import is_phrase, say


def mistake(name: Name, lang: Lang) -> str:
    """As it was made, a noun phrase; one that is not known here by its id."""
    id, way, of, form = name
    for made in (f"mistakes.made {id} {way}", f"mistakes.made {id}"):
        if is_phrase(made):
            return say(made, lang, of=of, form=form)
    return id


def together(names: tuple[Name, ...], lang: Lang) -> str:
    """Mistakes that were made together."""
    return say("marks.together", lang).join(mistake(name, lang) for name in names)


def once(texts: Iterable[str]) -> list[str]:
    """Each once, and not again with more behind it, as `.., and carried on`: these cannot be told apart."""
    each = list(dict.fromkeys(texts))
    return [text for text in each if not any(text.startswith((f"{other}, ", f"{other}，")) for other in each)]


def kind(id: str, lang: Lang) -> str:
    """A mistake by itself, whatever it was made with."""
    return say(f"mistakes.kind {id}", lang) if is_phrase(f"mistakes.kind {id}") else id


def hint(topic: str, lang: Lang) -> str:
    """Where to look again, by a mistake's topic."""
    return say(f"mistakes.look {topic}", lang)
