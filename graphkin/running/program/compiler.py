"""C functions compiled once, and kept in a private folder of the user's own cache.

The compiler is what `CC` names, else `cc`; `GRAPHKIN_CC=none` says that there is none.
"""

from __future__ import annotations

import ctypes
import hashlib
import logging
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

Function = Callable[..., int]
FLAGS = ("-O3", "-fno-math-errno", "-fno-trapping-math", "-fno-builtin-tan", "-fno-builtin-atan2", "-shared", "-fPIC")
"""Roots and choices that can be done on vectors; results are those of the same operations one by one."""
LONGEST_S = 60
"""What a compiler may take at most [s]."""


@cache
def compiled(text: str, command: tuple[str, ...]) -> Function | None:
    """The function `run` of a C text; None where there is no compiler, or it fails."""
    if not command:
        return None
    try:
        run: Function = ctypes.CDLL(str(_library(command, text))).run
    except (OSError, subprocess.SubprocessError, AttributeError) as error:
        logging.getLogger("graphkin").debug("not compiled, done by NumPy: %s", error)
        return None
    whole, pointer = ctypes.c_longlong, ctypes.c_void_p
    run.restype, run.argtypes = whole, (whole, whole, whole, pointer, pointer)  # type: ignore[attr-defined]
    return run


def compiler() -> tuple[str, ...]:
    """The command of the C compiler; empty where there is none."""
    return () if os.environ.get("GRAPHKIN_CC") == "none" else _command(os.environ.get("CC") or "cc")


@cache
def _command(text: str) -> tuple[str, ...]:
    command = tuple(shlex.split(text))
    return command if shutil.which(command[0]) else ()


def _library(command: tuple[str, ...], text: str) -> Path:
    """The compiled file, named by all that it is made of; it appears there at once and whole."""
    folder = _own_folder()
    name = hashlib.sha256("\0".join((*command, *FLAGS, text)).encode()).hexdigest()
    library = folder / f"{name}.so"
    if not library.exists():
        with tempfile.TemporaryDirectory(dir=folder) as beside:
            source, made = Path(beside, "program.c"), Path(beside, "program.so")
            source.write_text(text, encoding="utf-8")
            call = [*command, *FLAGS, "-o", str(made), str(source), "-lm"]
            subprocess.run(call, check=True, capture_output=True, timeout=LONGEST_S, stdin=subprocess.DEVNULL)
            os.replace(made, library)
    return library


def _own_folder() -> Path:
    """Where only the user may write. Raises PermissionError where others may, too."""
    folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "graphkin")
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    state = folder.lstat()
    if hasattr(os, "getuid") and (state.st_uid != os.getuid() or state.st_mode & 0o077):
        raise PermissionError(f"{folder} is not the user's alone")
    return folder
