"""A tape as a C function of many positions, compiled once and kept in a private folder of the user's own cache.

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
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from graphkin.running.tape import FAILING, INPUT, NUMBER, Tape

HEAD = """\
#include <math.h>
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) \\
    && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 35)
/* the library has them for vectors, too, and the loop is compiled for each kind of processor */
__attribute__((const, simd("notinbranch"))) double tan(double);
__attribute__((const, simd("notinbranch"))) double atan2(double, double);
__attribute__((target_clones("avx512f", "avx2", "default")))
#else
#error "no tangent of vectors: NumPy is faster"
#endif
"""
FUNCTION = """\
long long run(long long n, long long begin, long long end, const double *const *in, double *results)
{{
{before}
    long long *marks = (long long *)(results + {rows} * n), any = 0;
#pragma GCC ivdep
    for (long long i = begin; i < end; i++) {{
{body}
        long long doubtful = !(least > {flat});
        marks[i - begin] = doubtful;
        any |= doubtful;
    }}
    return any;
}}
"""
WRITTEN = {
    "add": "{0} + {1}",
    "subtract": "{0} - {1}",
    "multiply": "{0} * {1}",
    "minimum": "{0} < {1} ? {0} : {1}",
    "maximum": "{0} > {1} ? {0} : {1}",
    "negative": "-{0}",
    "reciprocal": "1.0 / {0}",
    "sign": "(double)(({0} > 0) - ({0} < 0))",
    "absolute": "fabs({0})",
    "arctan2": "atan2({0}, {1})",
}
"""Operations in C; the others are functions of the same name."""


def written(
    tape: Tape, arrays: Sequence[bool], vectors: Sequence[tuple[int, int]], numbers: Sequence[int], sure: int,
    flat: float,
) -> str:  # fmt: skip
    """The C text of a function that fills vectors (k, n) and after them numbers (m, n), for some positions; beyond them
    it marks which of these are doubtful, and returns whether any is. `arrays`: of each input whether it has an entry a
    position; `sure` is above `flat` at positions that are not doubtful, NaN by infinite results of what may fail."""
    results = [place for pair in vectors for place in pair] + [*numbers, sure]
    needed = tape.needed(results)
    before = [f"    const double *x{k} = in[{k}];" for k, array in enumerate(arrays) if array]
    before += [f"    const double x{k} = *in[{k}];" for k, array in enumerate(arrays) if not array]
    before += [f"    double *v{k} = results + {2 * k} * n;" for k in range(len(vectors))]
    before += [f"    double *r{k} = results + {2 * len(vectors) + k} * n;" for k in range(len(numbers))]

    def name(place: int) -> str:
        does, _, number = tape.operations[place]
        if does == NUMBER:
            return f"({float(number)!r})"
        return f"t{place}" if does != INPUT else f"x{int(number)}" + "[i]" * arrays[int(number)]

    body = []
    for place in needed:
        does, of, _ = tape.operations[place]
        text = WRITTEN.get(does, f"{does}({{0}})").format(*map(name, of))
        body.append(f"const double t{place} = {text};")
    for k, (x, y) in enumerate(vectors):
        body += [f"v{k}[2 * i] = {name(x)};", f"v{k}[2 * i + 1] = {name(y)};"]
    body += [f"r{k}[i] = {name(place)};" for k, place in enumerate(numbers)]
    failing = [name(place) for place in needed if tape.operations[place].does in FAILING]
    failing += [f"x{k}[i]" for k, array in enumerate(arrays) if array]
    body.append(f"const double least = {name(sure)} + 0.0 * ({' + '.join(failing) or '0.0'});")
    lines = {"before": "\n".join(before), "body": "\n".join(" " * 8 + line for line in body)}
    return HEAD + FUNCTION.format(rows=2 * len(vectors) + len(numbers), flat=flat, **lines)


FLAGS = (
    "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fno-builtin-tan", "-fno-builtin-atan2",
    "-shared", "-fPIC",
)  # fmt: skip
"""Roots and choices that can be done on vectors; results are those of the same operations one by one."""
LONGEST_S = 60  # the time that a compiler may take at most [s]


@cache
def compiled(text: str, compiler: str) -> Function | None:
    """The function of a C text; None where there is no compiler, or it fails."""
    try:
        command = shlex.split(compiler)
        if not command or shutil.which(command[0]) is None:
            return None
        # the compiled file, named by all that it is made of; it appears there at once and whole
        # the folder in which only the user may write. Raises PermissionError where others may, too
        folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache", "graphkin")
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        state = folder.lstat()
        if hasattr(os, "getuid") and (state.st_uid != os.getuid() or state.st_mode & 0o022):
            raise PermissionError(f"{folder} is not the user's alone")
        name = hashlib.sha256("\0".join((*command, *FLAGS, text)).encode()).hexdigest()
        library = folder / f"{name}.so"
        if not library.exists():
            with tempfile.TemporaryDirectory(dir=folder) as beside:
                source, made = Path(beside, "program.c"), Path(beside, "program.so")
                source.write_text(text, encoding="utf-8")
                call = [*command, *FLAGS, "-o", str(made), str(source), "-lm"]
                subprocess.run(call, check=True, capture_output=True, timeout=LONGEST_S, stdin=subprocess.DEVNULL)
                os.replace(made, library)
        return Function(ctypes.CDLL(str(library)))
    except (OSError, ValueError, RuntimeError, AttributeError, subprocess.SubprocessError) as error:
        logging.getLogger("graphkin").debug("not compiled, done by NumPy: %s", error)
        return None


def compiler() -> str:
    """The command of the C compiler; empty where there is to be none."""
    return "" if os.environ.get("GRAPHKIN_CC") == "none" else os.environ.get("CC") or "cc"


class Function:
    """A compiled function, called with arrays."""

    def __init__(self, library: ctypes.CDLL) -> None:
        whole, pointer = ctypes.c_longlong, ctypes.c_void_p
        self.run = library.run
        self.run.restype, self.run.argtypes = whole, (whole, whole, whole, pointer, pointer)

    def __call__(
        self, inputs: Sequence[np.ndarray], room: np.ndarray, end: int, blocks: Iterable[slice]
    ) -> list[np.ndarray]:
        """Fill a room with results, block by block; beyond its `end` the function marks what is doubtful of a block."""
        count, results, marks = max(value.size for value in inputs), room.ctypes.data, room[end:].view(np.longlong)
        pointers, doubtful = (ctypes.c_void_p * len(inputs))(*(value.ctypes.data for value in inputs)), []
        for here in blocks:
            if self.run(count, here.start, here.stop, pointers, results):
                doubtful.append(here.start + np.flatnonzero(marks[: here.stop - here.start]))
        return doubtful
