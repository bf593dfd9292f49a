"""The user's language, found before click reads the command line, in which usage is told: by click, too."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextvars import ContextVar

import click
from click import core, decorators, exceptions, formatting, parser, types

from graphkin.errors import Lang
from graphkin.say.catalogue import is_phrase, phrase, say

_SAID: ContextVar[Sequence[str]] = ContextVar("said", default=())


def listen(words: Sequence[str]) -> None:
    """Of what a command line says of its language the last counts, wherever the rest of it goes wrong."""
    _SAID.set(re.findall("(?:^|\0)--lang[=\0](en|zh)(?=\0|$)", "\0".join(words))[-1:])


def user_language() -> Lang:
    """As the command line says; else Chinese where the environment asks for it, else English."""
    asked = (os.environ.get(name) for name in ("GRAPHKIN_LANG", "LC_ALL", "LC_MESSAGES", "LANG"))
    language = next(filter(None, (*_SAID.get(), *asked)), "")
    return "zh" if language.lower().startswith("zh") else "en"


def misused(name: str, wrong: object, /, **words: object) -> None:
    """Refuses wrong usage, where there is some, by the phrase of this name."""
    if wrong:
        raise click.UsageError(say(name, user_language(), **words))


def _said(text: str) -> str:
    """A text of click's own."""
    name = f"usage.click {text}"
    return phrase(name, user_language()) if is_phrase(name) else text


for _module in (core, decorators, exceptions, formatting, parser, types):  # where each looks for translations
    vars(_module).update(_=_said, ngettext=lambda one, more, count: _said(one if count == 1 else more))
