"""The problems that are to be marked: one, or all of a folder, each with what was handed in for it."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import NoFile, NoSuchProblem, Where

_KEY, _SET = ".key.json", "key.json"


@frozen
class Problem:
    """One problem.

    name    "" where there is only one
    key     as `judge_from` takes it
    paths   what was handed in
    """

    name: str
    key: str
    paths: tuple[str, ...]


def problems_of(key: str, submissions: Sequence[str]) -> tuple[Problem, ...]:
    """One, or those of a folder of keys for which something was handed in.

    In a folder of keys each problem is a NAME.key.json, a mechanism NAME.toml, or a folder NAME with a set of problems;
    what was handed in for it is NAME with any ending (a class table, an archive, a folder), among `submissions` or in
    folders of these. Raises NoSuchProblem, and NoFile where no submission is there.
    """
    if submissions and not any(map(os.path.exists, submissions)):  # written wrongly; one among several is a row
        raise NoFile(Where(submissions[0]), Path(submissions[0]).name, ())
    keys = _keys(Path(key))
    if not keys:
        return (Problem("", key, tuple(submissions)),)
    paths: dict[str, list[str]] = {name: [] for name in keys}
    handed_in: list[Path] = []
    for path in map(Path, submissions):
        folder = path.is_dir() and path.name not in keys
        handed_in += sorted(one for one in path.iterdir() if not one.name.startswith(".")) if folder else [path]
    for path in handed_in:
        name = next((name for name in (path.name, path.stem) if name in keys), None)
        if name is None:
            raise NoSuchProblem(Where(str(path)), path.stem, tuple(keys))
        paths[name].append(str(path))
    if not any(paths.values()):
        raise NoSuchProblem(Where(submissions[0]), Path(submissions[0]).name, tuple(keys))
    return tuple(Problem(name, str(keys[name]), tuple(own)) for name, own in paths.items() if own)


def _keys(folder: Path) -> Mapping[str, Path]:
    """The problems of a folder by name; none of one that is itself a set of problems, or that is no folder."""
    if not folder.is_dir() or (folder / _SET).exists():
        return {}
    keys: dict[str, Path] = {}
    for path in sorted(folder.iterdir()):
        if path.name.endswith(_KEY):
            keys[path.name.removesuffix(_KEY)] = path
        elif (path / _SET).is_file():
            keys.setdefault(path.name, path)
        elif path.suffix == ".toml":
            keys.setdefault(path.stem, path)
    return keys
