"""The textbook's mechanisms, one file each, in a folder for each source. `load("ex3-1")`.

A new mechanism is a new file `NAME.toml` in one of the folders; nothing else has to be told.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

from graphkin.errors import Lang, UnknownMechanism, Where
from graphkin.loading import loads
from graphkin.mechanism import Mechanism

__all__ = ["groups", "load", "names", "text", "titles"]

_SUFFIX = ".toml"


def names() -> tuple[str, ...]:
    """All mechanisms, in the order one would look for them: p3-3a before p3-11a."""
    return tuple(_files())


def groups() -> Mapping[str, tuple[str, ...]]:
    """The mechanisms of each source, by its folder."""
    folders = sorted({group for group, _ in _files().values()})
    return {folder: tuple(name for name, (group, _) in _files().items() if group == folder) for folder in folders}


def text(name: str) -> str:
    """The file's text. `UnknownMechanism` for a name that is not there."""
    if name not in _files():
        raise UnknownMechanism(Where(name), name, names())
    return _files()[name][1].read_text("utf-8")


def load(name: str) -> Mechanism:
    """The mechanism of this name."""
    return loads(text(name), name=name, file=name + _SUFFIX)


def titles(lang: Lang) -> dict[str, str]:
    """What each mechanism is called."""
    return {name: load(name).headline(lang) for name in names()}


@cache
def _files() -> dict[str, tuple[str, Traversable]]:
    """Name -> folder and file, in natural order."""
    found = {
        file.name.removesuffix(_SUFFIX): (folder.name, file)
        for folder in files(__name__).iterdir()
        if folder.is_dir()
        for file in folder.iterdir()
        if file.name.endswith(_SUFFIX)
    }
    return {name: found[name] for name in sorted(found, key=_natural)}


def _natural(name: str) -> list[tuple[int, str]]:
    """Numbers compare as numbers."""
    parts = re.findall(r"[0-9]+|[^0-9]+", name)
    return [(int(part), "") if part.isdigit() else (-1, part) for part in parts]
