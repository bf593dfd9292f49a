"""Whose key it is: one for all, or a set with one for each student."""

from __future__ import annotations

import json
from pathlib import Path

from graphkin.homework.grading.keys import USUAL, Pencils, key_from, text_of
from graphkin.homework.grading.sets import KIND, KeySet, OneKey, SetMarker
from graphkin.marking.marker import Marker


def judge_from(source: str, pencils: Pencils = USUAL) -> SetMarker:
    """Of a key.json, a mechanism file, a library mechanism, or a folder with a set of problems.

    Raises what loading and planning raise, BadKey, NothingToMark.
    """
    path = Path(source)
    path = path / "key.json" if path.is_dir() else path
    if path.suffix.lower() == ".json":
        try:
            data = json.loads(text_of(path))
        except (ValueError, RecursionError):
            data = None  # the reader of one key says what is wrong
        if isinstance(data, dict) and data.get("kind") == KIND:
            return KeySet.read(path, data)
    return OneKey(Marker(key_from(str(path) if path.suffix else source, pencils)))
