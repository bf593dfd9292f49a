"""The textbook's mechanisms, one file each, in a folder for each source. `load("ex3-1")`.

A new mechanism is a new file `NAME.toml` in one of the folders; nothing else has to be changed.
"""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from graphkin.errors import Lang, UnknownMechanism, Where

if TYPE_CHECKING:
    from graphkin.files import MechanismFile

__all__ = ["KINDS", "chosen", "groups", "has", "load", "names", "text", "titles"]

KINDS = ("hinge", "slide", "gear", "roll", "cam")  # the kinds of pair that `chosen` looks for

_SUFFIX = ".toml"


def names() -> tuple[str, ...]:
    """All mechanisms, in the order one would look for them: p3-3a before p3-11a."""
    return tuple(_files())


def groups() -> Mapping[str, tuple[str, ...]]:
    """The mechanisms of each source, by its folder."""
    folders = sorted(set(_files().values()))
    return {folder: tuple(name for name, group in _files().items() if group == folder) for folder in folders}


def text(name: str) -> str:
    """The file's text. `UnknownMechanism` for a name that is not there."""
    if (file := _file(name)) is None:
        raise UnknownMechanism(Where(name), name, names())
    return file.read_text("utf-8")


def has(name: str) -> bool:
    """True of the name of a mechanism that is there."""
    return _file(name) is not None


def load(name: str) -> MechanismFile:
    """The mechanism of this name."""
    from graphkin.files import loads

    return loads(text(name), name=name, file=name + _SUFFIX)


def titles(lang: Lang) -> dict[str, str]:
    """The title of each mechanism. It stands before the first table; no more of a file is read for it."""
    heads = {name: tomllib.loads(text(name).split("\n[", 1)[0])["title"] for name in names()}
    return {name: title if isinstance(title, str) else title[lang] for name, title in heads.items()}


def chosen(kind: str = "", group: str = "", source: str = "") -> tuple[str, ...]:
    """Those that have a pair of this kind (`hinge`: no other pair), in this folder, with this text in their source.
    Files are read only to look for a pair or a source in them."""
    in_folder = groups().get(group, ()) if group else names()
    chosen = []
    for name in in_folder:
        if kind or source:
            mechanism = load(name)
            tables = {pair.table for pair in mechanism.pairs}
            of_kind = not tables if kind == "hinge" else not kind or kind in tables
            if not of_kind or source.casefold() not in " ".join(mechanism.source.values()).casefold():
                continue
        chosen.append(name)
    return tuple(chosen)


def _file(name: str) -> Path | None:
    """Looked for by its name alone; reading all folders takes longer."""
    if "/" in name or name != Path(name).name:
        return None
    places = (folder / f"{name}{_SUFFIX}" for folder in _folders())
    return next((place for place in places if os.path.isfile(place)), None)


@cache
def _files() -> dict[str, str]:
    """Name -> folder, in natural order."""
    folders = {file.stem: folder.name for folder in _folders() for file in folder.glob(f"*{_SUFFIX}")}
    parts = {name: re.findall(r"[0-9]+|[^0-9]+", name) for name in folders}
    natural = {name: [(int(part), "") if part.isdigit() else (-1, part) for part in parts[name]] for name in folders}
    return {name: folders[name] for name in sorted(folders, key=natural.__getitem__)}


@cache
def _folders() -> tuple[Path, ...]:
    return tuple(path for path in Path(__file__).parent.iterdir() if path.is_dir())
