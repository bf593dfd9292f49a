"""Homework: problem sets, grading, and the files of teaching platforms."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from graphkin.errors import NoFile, Unreadable, Where


@contextmanager
def opening(path: Path) -> Iterator[None]:
    """Raises NoFile, Unreadable where a file cannot be read."""
    try:
        yield
    except FileNotFoundError:
        raise NoFile(Where(str(path)), path.name, ()) from None
    except (OSError, UnicodeDecodeError) as problem:
        raise Unreadable(Where(str(path)), getattr(problem, "strerror", None) or "UTF-8") from None
