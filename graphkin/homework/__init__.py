"""Homework: problem sets, grading, and the files of teaching platforms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from graphkin.errors import NoFile, NotOneOf, Unreadable, Where


@contextmanager
def opening(path: Path) -> Iterator[None]:
    """Raises NoFile, Unreadable where a file cannot be read."""
    try:
        yield
    except FileNotFoundError:
        raise NoFile(Where(str(path)), path.name, ()) from None
    except (OSError, UnicodeDecodeError) as problem:
        raise Unreadable(Where(str(path)), getattr(problem, "strerror", None) or "UTF-8") from None


def kinds_of(formats: str | Iterable[str], known: Sequence[str]) -> list[str]:
    """Formats as a call names them, one or several. Raises NotOneOf."""
    kinds = [formats] if isinstance(formats, str) else [*formats]
    if unknown := [kind for kind in kinds if kind not in known]:
        raise NotOneOf(Where("formats"), unknown[0], tuple(known))
    return kinds
