"""Files are written beside, then renamed: none is ever half written, and none of another's is lost."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import ClassVar

from graphkin.errors import CannotWrite, GraphkinError, Lang, NoFolder

__all__ = ["FileInTheWay", "beside", "refuse"]

GLANCE = 4096
"""How much of a file's beginning and end is looked at for a mark of graphkin."""


class FileInTheWay(GraphkinError):
    """A file that graphkin did not write stands where one is to be written."""

    path: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "{path} exists and is not a file of this kind written by graphkin. Choose another name, or replace it "
        "with --force.",
        "zh": "{path} 已存在，且不是 graphkin 写的同类文件。请换文件名，或用 --force 覆盖。",
    }


@contextlib.contextmanager
def beside(path: Path, force: bool, marks: Sequence[bytes]) -> Iterator[Path]:
    """A file to write into, which takes the place of `path` once it is whole.

    marks   bytes by which graphkin knows a file of its own, which it replaces without `force`

    Raises FileInTheWay, NoFolder, CannotWrite.
    """
    refuse(path, force, marks)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        yield draft
        os.replace(draft, path)
    except OSError as error:
        raise CannotWrite(str(path), error.strerror or str(error)) from None
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def refuse(path: Path, force: bool, marks: Sequence[bytes]) -> None:
    """Whether a file may be written there; several are all asked before the first is written."""
    try:
        if path.exists() and not force and not _ours(path, marks):
            raise FileInTheWay(str(path))
        if not path.parent.is_dir():
            raise NoFolder(str(path), str(path.parent))
    except OSError as error:
        raise CannotWrite(str(path), error.strerror or str(error)) from None


def _ours(path: Path, marks: Sequence[bytes]) -> bool:
    """Whether a file says in its beginning or its end that graphkin wrote it."""
    with path.open("rb") as file:
        glance = file.read(GLANCE)
        file.seek(max(0, path.stat().st_size - GLANCE))
        glance += file.read(GLANCE)
    return any(mark in glance for mark in marks)
