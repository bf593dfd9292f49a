"""A folder's name for any id: never a path, and another for another id, on any system."""

from __future__ import annotations

import hashlib
import unicodedata

__all__ = ["folder_name"]

_LONGEST = 60
_DEVICES = {"con", "prn", "aux", "nul", *(f"{name}{k}" for name in ("com", "lpt") for k in range(10))}
"""Names that Windows keeps for itself."""


def folder_name(told: str) -> str:
    """Letters and digits of the id; with a mark of the whole id where that is not all of it, or it has capitals."""
    letters = unicodedata.normalize("NFC", told)
    kept = "".join(letter if letter.isalnum() or letter in "-_" else "_" for letter in letters)
    kept = kept[:_LONGEST]
    if kept == told and kept == kept.casefold() and kept and kept not in _DEVICES:
        return kept
    return f"{kept}-{hashlib.sha256(told.encode('utf-8', 'surrogatepass')).hexdigest()[:10]}"
