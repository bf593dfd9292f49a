"""The user's language, found before click reads the command line, in which usage is told: by click, too."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextvars import ContextVar

import click
from click import core, decorators, exceptions, formatting, parser, types

from graphkin.errors import Lang

_SPOKEN: ContextVar[Lang] = ContextVar("spoken")


def listen(words: Sequence[str]) -> None:
    """Of what a command line says of its language the last counts, wherever the rest of it goes wrong."""
    said = re.findall("(?:^|\0)--lang[=\0](en|zh)(?=\0|$)", "\0".join(words))
    _SPOKEN.set(said[-1] if said else _environment())


def user_language() -> Lang:
    """As the command line says; else Chinese where the environment asks for it, else English."""
    return _SPOKEN.get(None) or _environment()


def _environment() -> Lang:
    names = ("GRAPHKIN_LANG", "LC_ALL", "LC_MESSAGES", "LANG")
    value = next((value for name in names if (value := os.environ.get(name))), "")
    return "zh" if value.lower().startswith("zh") else "en"


def misused(name: str, /, **words: object) -> click.UsageError:
    """Wrong usage, as the phrase of this name tells it."""
    from graphkin.say.catalogue import say

    return click.UsageError(say(name, user_language(), **words), click.get_current_context(silent=True))


def _said(text: str) -> str:
    """A text of click's own."""
    if user_language() == "en":
        return text
    from graphkin.say.catalogue import is_phrase, phrase

    name = f"usage.click {text}"
    return phrase(name, "zh") if is_phrase(name) else text


for _module in (core, decorators, exceptions, formatting, parser, types):  # where each looks for translations
    vars(_module).update(_=_said, ngettext=lambda one, more, count: _said(one if count == 1 else more))
