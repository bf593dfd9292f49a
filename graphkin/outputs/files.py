"""Files are written beside, then renamed: none is ever half written, and none of another's is lost.

Packages that only some files need are imported when such a file is written, and named where they are not there.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Sequence
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from graphkin.errors import CannotWrite, GraphkinError, NoFolder

NAMESPACE = "https://graphkin.invalid/sheet/1"  # by this a program knows a drawing of graphkin's
_DRAFT = ".draft"  # the end of the name of a file that is being written
_GLANCE = 4096  # how much of a file's beginning and end is looked at for a mark of graphkin


class FileInTheWay(GraphkinError):
    path: str
    en = (
        "{path} exists and is not a file of this kind written by graphkin. Choose another name, or replace it "
        "with --force (in Python: force=True)."
    )
    zh = "{path} 已存在，且不是 graphkin 写的同类文件。请换文件名，或用 --force 覆盖。"


class UnknownEnding(GraphkinError):
    path: str
    endings: tuple[str, ...]
    en = "{path}: this is written as {endings:,}. Let the file's name end in one of these."
    zh = "{path}：只能写成 {endings:,} 文件，请用其中之一作扩展名。"


@contextlib.contextmanager
def beside(path: Path, force: bool, marks: Sequence[bytes]) -> Iterator[Path]:
    """A file to write into, which takes the place of `path` once it is whole; a link stays one, to the new file.

    marks   bytes by which graphkin knows a file of its own, which it replaces without `force`

    Raises FileInTheWay, NoFolder, CannotWrite.
    """
    refuse(path, force, marks)
    path = Path(os.path.realpath(path))
    draft = path.with_name(f".{path.name[:60]}.{os.getpid()}{_DRAFT}")
    _clear(path.parent)
    try:
        yield draft
        os.replace(draft, path)
    except OSError as error:
        raise CannotWrite.by(path, error) from None
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


def write(path: Path, content: bytes | str, force: bool, marks: Sequence[bytes]) -> None:
    """The whole file; a text as UTF-8. Raises what `beside` raises."""
    with beside(path, force, marks) as draft:
        draft.write_bytes(content.encode() if isinstance(content, str) else content)


@cache
def _clear(folder: Path) -> None:
    """Drafts in a folder that writers left who were ended before they were done; looked for once a process."""
    with contextlib.suppress(OSError):
        for left in folder.glob(f".*{_DRAFT}"):
            owner = left.name.removesuffix(_DRAFT).rpartition(".")[2]
            if owner.isdecimal() and owner.isascii() and _is_ended(int(owner)):
                left.unlink()


def _is_ended(process: int) -> bool:
    """True if there surely is no such process, or it only waits to be asked; not where that cannot be found out."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
        return ") Z " in Path(f"/proc/{process}/stat").read_text(encoding="utf-8", errors="replace")
    except ProcessLookupError:
        return True
    except (OSError, OverflowError):
        return False


def refuse(path: Path, force: bool, marks: Sequence[bytes]) -> None:
    """Raises FileInTheWay, NoFolder, CannotWrite; several files are all asked about before the first is written. A
    device or a pipe is no file: the new one would take its place. A file says in its beginning or its end that graphkin
    wrote it, a PDF anywhere; an empty one is nobody's loss."""
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            raise CannotWrite(str(path), "not a regular file")
        if path.exists() and not force:
            glance = b"no file"
            if path.is_file():
                with path.open("rb") as file:
                    glance = file.read(_GLANCE)
                    if not glance.startswith(b"%PDF"):  # which says it before a list of all that is in it
                        file.seek(max(0, path.stat().st_size - _GLANCE))
                    glance += file.read()
            if glance and not any(mark in glance for mark in marks):
                raise FileInTheWay(str(path))
        if not path.parent.is_dir():
            raise NoFolder(str(path), str(path.parent))
    except OSError as error:
        raise CannotWrite.by(path, error) from None


class NeedsExtra(GraphkinError):
    package: str
    extra: str
    en = (
        "This kind of file is written by {package}, which is not installed. "
        "Install it: pip install 'graphkin[{extra}]'."
    )
    zh = "写这种文件需要 {package}，尚未安装。请安装：pip install 'graphkin[{extra}]'。"


def needed(package: str, extra: str) -> Any:
    """A package by name, imported. Raises NeedsExtra."""
    try:
        return import_module(package)
    except ImportError:
        raise NeedsExtra(package, extra) from None
