"""Quantities at the further positions that a problem asks for: `omega 3 #2` is omega 3 at the second."""

from __future__ import annotations

import re

_NUMBER = r"\s*[#＃]\s*([1-9][0-9]{0,3})(?![0-9])"


def at_position(text: str, number: int) -> str:
    """What a quantity is called at a position; the drawn one is the first, and is not said.

    >>> at_position("omega 3", 1), at_position("omega 3", 2)
    ('omega 3', 'omega 3 #2')
    """
    return text if number == 1 else f"{text} #{number}"


def position_of(text: str) -> tuple[str, int]:
    """The quantity's own name, with whatever else stands there, and the number of the position; 1 where none is said.

    >>> position_of("omega 3 #2"), position_of("ω3 #2 (rad/s)"), position_of("omega 3")
    (('omega 3', 2), ('ω3 (rad/s)', 2), ('omega 3', 1))
    """
    found = re.search(_NUMBER, text)
    return (text, 1) if found is None else (text[: found.start()] + text[found.end() :], int(found[1]))
