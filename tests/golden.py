"""What graphkin says and draws, command by command, kept to be compared.

    .venv/bin/python tests/golden.py             rewrites tests/golden/
    .venv/bin/python tests/golden.py explain     those whose command line holds a word

The gallery keeps the sheets of `draw`; here are words, JSON, and the sheets of everything else.
"""

from __future__ import annotations

import contextlib
import json
import math
import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from click.testing import CliRunner
from gallery import differences

from graphkin.cli import main as graphkin
from graphkin.files import library

GOLDEN = Path(__file__).parent / "golden"
HOMEWORK = Path(__file__).parent / "cases" / "homework"
"""Where the commands are given: what students hand in, and a problem with ranges."""
LANGUAGES = ("en", "zh")
CENTRES = ("fig3-4", "fig3-6", "ex3-1", "ex3-2", "p3-19", "p3-8", "p3-12")
LINKAGES = ("s2-2", "s2-4", "ex3-7", "p3-5", "fig3-6", "p3-22")
DESIGNS = (
    "rocker --length 80 --swing 40 --K 1.3 --frame 71",
    "slider --stroke 40 --K 1.2 --offset 15",
    "guide-bar --K 1.5 --frame 100",
    'positions --at "0,50 0" --at "25,60 -10" --at "50,55 -30" --coupler 60',
    "angles --pair 40:70 --pair 70:85 --pair 110:110 --frame 100",
)
FINDS = (
    'p3-4a "a_k B3B2 = 0"',
    'ex3-7 "stroke s ram"',
    'ex3-7 "max v E"',
    'p3-18 "v_x E = 0.5 by omega 1"',
    'p3-13 "slowest BC"',
    'p3-21 "stroke s piston" --vary DH=55:125:35',
)
TOLERANCES = ("ex3-1", "p3-12")
EQUATIONS = ("ex3-5", "ex3-1", "fig3-5", "p3-19")
CLOSE = 1e-9
"""Numbers of JSON may differ by this part of the largest beside them."""


def commands() -> Iterator[str]:
    """Command lines; `@.svg` stands for a file to write, `@/s1.txt` for one in a folder to write: it is kept then."""
    for name in library.names():
        yield f"solve {name} --json"
        for lang in LANGUAGES:
            yield f"explain {name} --lang {lang}"
            yield f"structure {name} --lang {lang}"
    for name in CENTRES:
        yield f"centres {name} --json"
        for lang in LANGUAGES:
            yield f"centres {name} --lang {lang}"
            yield f"centres {name} --lang {lang} -o @.svg"
    for lang in LANGUAGES:
        yield f"centres fig3-4 --about 3 --lang {lang}"
        yield f"centres fig3-4 --about 3 --lang {lang} -o @.svg"
        yield f"centres fig3-4 --about 3 --bobillier B --lang {lang} -o @.svg"
        yield f"centres fig3-6 --centrodes 3,1 --lang {lang} -o @.svg"
        for name in LINKAGES:
            yield f"linkage {name} --lang {lang}"
            yield f"linkage {name} --lang {lang} -o @.svg"
        for words in DESIGNS:
            yield f"design {words} --lang {lang}"
            yield f"design {words} --lang {lang} -o @.svg"
        for words in FINDS:
            yield f"find {words} --lang {lang}"
        yield f"find {FINDS[0]} --lang {lang} -o @.svg"
        for name in EQUATIONS:
            yield f"equations {name} --lang {lang}"
            yield f"equations {name} --lang {lang} --method complex -o @.html"
        for name in TOLERANCES:
            yield f"tolerance {name} --lang {lang}"
        yield f"grade ex3-1 s1.toml s2.toml --lang {lang}"
        yield f"grade ex3-1 s1.toml --format csv --lang {lang} -o @/class.csv"
        yield f"problems rocker.toml --students 1 --seed 1 --lang {lang} -o @/students/s1.html"
        yield f"sweep ex3-7 --table --lang {lang}"
        yield f"sweep ex3-1 --driver 0:360:30 --lang {lang}"
    for name in LINKAGES:
        yield f"linkage {name} --json"
    for words in (*DESIGNS,):
        yield f"design {words} --json"
        yield f"design {words} --toml @.toml"
    for words in FINDS:
        yield f"find {words} --json"
    yield f"tolerance {TOLERANCES[0]} --json"
    yield "sweep ex3-7 --driver 0:360:15 -o @.csv"
    yield "sweep ex3-7 --driver 0:360:15 -o @.json"
    yield "schema"
    yield "help file"
    yield "help file --lang zh"
    yield "list"
    yield "list --kinds"


def place(line: str) -> Path:
    """Where a command's words are kept."""
    kept = re.search(r"@[/\w]*(\.\w+)", line)
    end = kept[1] if kept else ".json" if "--json" in line or line == "schema" else ".txt"
    return GOLDEN / (re.sub(r"[^\w.=-]+", "_", re.sub(r"(-o|--toml) @[/\w]*\.\w+", "", line)).strip("_") + end)


def said(line: str) -> str:
    """What a command prints, or what it writes where it writes a file."""
    import shlex

    with tempfile.TemporaryDirectory() as folder:
        inside = re.search(r"@/(\S+)", line)
        target = Path(folder) / ("out" + place(line).suffix)
        given = str(Path(folder) if inside else target)
        words = [given if word.startswith("@") else word for word in shlex.split(line)]
        with contextlib.chdir(HOMEWORK):
            done = CliRunner().invoke(graphkin, words, catch_exceptions=False)
        target = Path(folder) / inside[1] if inside else target
        assert done.exit_code == 0, (line, done.output)
        return target.read_text("utf-8") if "@" in line else done.output


def unlike(path: Path, old: str, new: str) -> str:
    """The first thing that differs; nothing where the two say the same."""
    if path.suffix == ".svg":
        return next(differences(old, new), "")
    if path.suffix == ".json":
        pairs = zip(old.splitlines(), new.splitlines(), strict=False) if old[0] == "{" and "\n{" in old else [(old, new)]
        return next((found for one, two in pairs if (found := _off(json.loads(one), json.loads(two), ""))), "")
    lines = zip(old.splitlines(), new.splitlines(), strict=False)
    first = next((f"{one!r} is now {two!r}" for one, two in lines if one != two), "")
    return first or ("" if old == new else f"{len(old)} characters, now {len(new)}")


def _off(old: object, new: object, where: str) -> str:
    """What differs between two values of JSON."""
    if isinstance(old, dict) and isinstance(new, dict):
        if [*old] != [*new]:
            return f"{where}: keys {[*old]} are now {[*new]}"
        return next((found for key in old if (found := _off(old[key], new[key], f"{where}.{key}"))), "")
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        size = max((abs(x) for x in old if isinstance(x, (int, float))), default=0.0)
        found = (_off(a, b, f"{where}[{k}]") for k, (a, b) in enumerate(zip(old, new)) if not _same(a, b, size))
        return next(found, "")
    return "" if _same(old, new, 0.0) else f"{where}: {old!r} is now {new!r}"


def _same(old: object, new: object, size: float) -> bool:
    if isinstance(old, float) and isinstance(new, (int, float)):
        return math.isclose(old, new, rel_tol=CLOSE, abs_tol=max(CLOSE * size, 1e-11))
    return old == new


def main(words: list[str]) -> None:
    """Rewrite all, or those whose command line holds a word."""
    GOLDEN.mkdir(exist_ok=True)
    lines = [line for line in commands() if not words or any(word in line for word in words)]
    if not words:
        for path in GOLDEN.iterdir():
            path.unlink()
    for line in lines:
        place(line).write_text(said(line), encoding="utf-8", newline="\n")
        print(line)


if __name__ == "__main__":
    main(sys.argv[1:])
