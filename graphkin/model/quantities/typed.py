"""Quantities in a running text, as they are typed: `omega 3`, `a_k B3B2`, `v_x E`."""

from __future__ import annotations

import re
from collections.abc import Callable

_TYPED = r"\b(?:(?:omega|alpha|theta) [\w'′]+|[sva](?:_[nktrxy])? [\w'′@,]*\w[\w'′@]*)"


def rewritten(text: str, write: Callable[[str], str]) -> str:
    """The text with each quantity as `write` has it."""
    return re.sub(_TYPED, lambda found: write(found[0]), text)
