"""Mechanism files spoilt in many ways, and command lines that are asked of them.

Each case has a number and is made from it alone: `python tests/fuzzing.py 1234` runs that one case and prints it,
`python tests/fuzzing.py 0 500 folder` runs 500 with limits of time and memory, and keeps the files that fail.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import re
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from xml.etree import ElementTree

from click.testing import CliRunner

from graphkin.cli import main
from graphkin.files import library

SECONDS = 10.0
"""CPU time that no command may pass, whatever it is given."""
MEMORY = 1 << 30
"""Bytes that no command may pass."""

NUMBERS = (
    "0", "-0.0", "1", "-1", "0.5", "1e-9", "1e-12", "1e9", "-1e9", "1e15", "1e308", "1e400", "nan", "inf", "-inf", "90",
    "180", "360", "-90", "720.5", "1e5", "1e8", '"30 deg"', '"1 in"', '"24"', '"1e3 rad"', '"5 kg"', '""', "true",
    "1979-05-27", "[]", "{}", "[1, 2]", "0x10", "1_000", "9" * 400,
)  # fmt: skip
TEXTS = (
    "", " ", "\t", "\n", "\x00", "\x1b[31m", "\x7f", "\x85", "\u2028", "\u202e", "\ufeff", "\ufffe", "\u200b", "\u0301",
    "²", "٣", "½", "Ⅷ", "é", "中文", "🙂", "<b>&amp;]]>", "\\write18{x}", "$x^2$ % # & ~", "%s %n {0}", "../../x", "-", "--help",
    "A", "B3", "P13", "c0", "frame", "0", "a" * 3000, "omega3", "omega 3 / ", "v", "v  C", "P1,2", "theta 1/omega 1",
)  # fmt: skip
NAMES = ("A", "B", "B1", "O'", "Z9", "1", "2", "frame", "0", "²", "٣", "c0", "pin", "pin s0", "S", "K", "k'", "_", "link", "x")
KEYS = (
    "angle", "tilt", "through", "toward", "from", "block", "point", "pin", "guide", "name", "vector", "omega", "alpha",
    "velocity", "acceleration", "at", "also", "slide", "link", "links", "centres", "radii", "internal", "wheel",
    "centre", "radius", "on", "on_centre", "on_radius", "side", "profiles", "points", "ccw", "shape", "ask", "title",
)  # fmt: skip
WORDS = (
    "", " ", "0", "-1", "1", "30", "1e-12", "1e9", "-1e9", "1e308", "1e400", "nan", "inf", "-inf", "٣", "²", "1,5", "0x10",
    "30 deg", "24 in", "5 kg", "a\nb", "\x1b[31m", "\u202e", "%s", "🙂", "A" * 2000, "../../x", "-", "A,B", "1,2", "P12", "=",
    "AB=", "=30", "::", "0:360", "0:360:0", "0:360:10", "360:0:10", "0:1e9:1e-9", "nan:1:1", "0:inf:1", "10:350:7", "5:5:5",
)  # fmt: skip


# --- files ------------------------------------------------------------------------------------


@cache
def originals() -> tuple[str, ...]:
    return tuple(library.text(name) for name in library.names())


def _a_number(rng: random.Random, text: str) -> str:
    places = [match.span() for match in re.finditer(r"(?<![\w.'\"])-?\d+(?:\.\d+)?(?![\w'\"])", text)]
    if not places:
        return text
    begin, end = rng.choice(places)
    old = text[begin:end]
    near = [repr(float(old) * factor) for factor in (-1, 0.5, 0.99, 1 + 1e-9, 2, 10, 1000)]
    return text[:begin] + rng.choice([*NUMBERS, *near, *near]) + text[end:]


def _gently(rng: random.Random, text: str) -> str:
    """Some numbers changed a little, so that most such files are mechanisms still."""
    factors = (0.9, 0.98, 1 - 1e-6, 1 + 1e-12, 1.03, 1.1, 1.3)

    def changed(match: re.Match[str]) -> str:
        return repr(float(match[0]) * rng.choice(factors)) if rng.random() < 0.3 else match[0]

    return re.sub(r"(?<![\w.'\"-])\d+(?:\.\d+)?(?![\w'\"])", changed, text)


def _a_name(rng: random.Random, text: str) -> str:
    """One name changed, at one place or everywhere."""
    names = re.findall(r"[A-Z]\d*'*|(?<=\")\w+(?=\")|(?<=links\.)\w+", text)
    if not names:
        return text
    old, new = rng.choice(names), rng.choice([*NAMES, rng.choice(names)])
    return text.replace(old, new, rng.choice([1, 1, -1]))


def _a_key(rng: random.Random, text: str) -> str:
    keys = list(re.finditer(r"^([\w.\"']+)(?=\s*=)", text, re.MULTILINE))
    if not keys:
        return text
    match = rng.choice(keys)
    return text[: match.start()] + rng.choice(KEYS) + text[match.end() :]


def _a_text(rng: random.Random, text: str) -> str:
    """A title, a source, a question or a name that is hostile, written so that TOML takes it."""
    odd = json.dumps(rng.choice(TEXTS) + rng.choice(("", "x", rng.choice(TEXTS))))
    odd = re.sub(r"\\ud[89a-f]\w\w\\ud[c-f]\w\w", "🙂", odd)
    key = rng.choice(("title", "source", "title.zh", "ask", "ask"))
    kept = re.sub(rf"^{key.split('.')[0]}\b.*$", "", text, count=1, flags=re.MULTILINE)
    return f"{key} = {f'[{odd}]' if key == 'ask' else odd}\n{kept}"


def _lines(rng: random.Random, text: str) -> str:
    """A line left out, doubled, moved; or one of another mechanism put in."""
    lines = text.splitlines()
    if len(lines) < 2:
        return text
    here, there = rng.randrange(len(lines)), rng.randrange(len(lines))
    match rng.randrange(5):
        case 0:
            del lines[here]
        case 1:
            lines.insert(here, lines[here])
        case 2:
            lines[here], lines[there] = lines[there], lines[here]
        case 3:
            lines.insert(here, rng.choice(rng.choice(originals()).splitlines()))
        case _:
            del lines[min(here, there) : max(here, there)]
    return "\n".join(lines) + "\n"


def _tables(rng: random.Random, text: str) -> str:
    """A table left out, doubled, put elsewhere; or one of another mechanism put in."""
    parts = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    here = rng.randrange(len(parts))
    match rng.randrange(4):
        case 0:
            del parts[here]
        case 1:
            parts.append(parts[here])
        case 2:
            rng.shuffle(parts)
        case _:
            parts.append(rng.choice(re.split(r"^(?=\[)", rng.choice(originals()), flags=re.MULTILINE)))
    return "\n".join(parts)


def _bytes(rng: random.Random, text: str) -> bytes:
    data = bytearray(text.encode())
    match rng.randrange(6):
        case 0:
            data = data[: rng.randrange(len(data) + 1)]
        case 1:
            data = bytearray(text.encode("utf-16"))
        case 2:
            data = bytearray(text.encode("gbk", "replace"))
        case 3:
            data = bytearray(b"\xef\xbb\xbf") + data
        case _:
            for _ in range(rng.randint(1, 4)):
                data[rng.randrange(len(data))] = rng.randrange(256)
    return bytes(data)


SPOILING: tuple[Callable[[random.Random, str], str], ...] = (
    _a_number, _a_number, _a_number, _a_name, _a_key, _a_text, _lines, _tables,
)  # fmt: skip


def spoilt(rng: random.Random) -> bytes:
    """A library file with one to three things wrong or merely changed; one in three is only changed a little."""
    text = rng.choice(originals())
    if rng.random() < 0.35:
        return (_gently(rng, text) if rng.random() < 0.7 else text).encode()
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        text = rng.choice(SPOILING)(rng, text)
    if rng.random() < 0.05 and text:
        return _bytes(rng, text)
    return text.encode("utf-8", "replace")


# --- command lines ----------------------------------------------------------------------------

OPTIONS: dict[str, dict[str, tuple[str, ...]]] = {
    "draw": {
        "-o": ("o.svg", "o.svg", "-", "o.txt", "no/o.svg", "."), "--only": ("position", "velocity", "acceleration"),
        "--paper": ("A4", "A3-landscape", "B5"), "--steps": ("steps", "mine.toml"), "--lang": ("zh", "en", "fr"),
        "--angle": ("30", "200", "-360", *WORDS), "--at": ("10", *WORDS), "--coincident": ("B", "C", *WORDS),
        "--method": ("centre", "special"),
    },
    "explain": {
        "--lang": ("zh", "en"), "--angle": ("30", "200", *WORDS), "--at": ("10", *WORDS), "--method": ("centre", "special"),
        "--coincident": ("B", "C", *WORDS),
    },
    "solve": {"--json": (), "--angle": ("30", *WORDS), "--at": ("10", *WORDS), "--lang": ("zh", "en")},
    "structure": {"--json": (), "--lang": ("zh", "en")},
    "equations": {"--method": ("complex", "matrix"), "-o": ("o.tex", "o.html", "o.txt", "o.pdf"), "--lang": ("zh", "en")},
    "sweep": {
        "--driver": ("0:360:30", "0:90:10", "350:-10:20", *WORDS), "--table": (), "--by": ("analysis", "construction"),
        "--of": ("theta 2, v B", "v_x B, x C", "omega 3/omega 2", "P12", *TEXTS), "-o": ("o.csv", "o.json", "-", "o.doc"),
        "--limit": ("v B 1", "a B 3 g", "omega 2 -1", *WORDS), "--lang": ("zh", "en"),
    },
    "find": {
        "--driver": ("0:360:30", "0:90:10", *WORDS), "--by": ("analysis", "construction"), "--json": (),
        "-o": ("o.svg", "o.txt"), "--vary": ("AB=20:30:5", "omega=1:2:1", *WORDS), "--lang": ("zh", "en"),
    },
    "centres": {
        "-o": ("o.svg", "-"), "--steps": ("steps",), "--about": ("2", "3", *NAMES), "--bobillier": ("B", "C", *WORDS),
        "--path": ("P13", *WORDS), "--json": (), "--fit": (), "--angle": ("30", *WORDS), "--lang": ("zh", "en"),
        "--centrodes": ("2,4", "3,1", "2,0", *WORDS), "--driver": ("0:90:30", *WORDS),
    },
    "linkage": {"--fix": ("1", "2", "3", *NAMES), "-o": ("o.svg",), "--json": (), "--lang": ("zh", "en")},
}  # fmt: skip
CONDITIONS = (
    "v B = 0", "max v C", "min a B", "range theta 3", "stroke s ram", "slowest BC", "omega 3 > 1 rad/s", "a_k B3B2 = 0",
    "omega 2 = omega 3", "v E = 0.5 by omega 1", "theta 3 = 30", "x B = y B", "max omega 2/omega 3", *WORDS,
)  # fmt: skip
ALONE = (
    ("linkage", "--fourbar", 4), ("linkage", "--slider", 3), ("linkage", "--guide", 3), ("show", "", 1), ("check", "", 1),
    ("centres", "--velocities", 1), ("list", "--kinds", 0), ("schema", "", 0), ("solve", "", 2),
    ("help", "", 1), ("new", "", 1), ("list", "--source", 1),
)  # fmt: skip
DESIGNS = {
    "rocker": ("--length", "--swing", "--K", "--frame", "--crank", "--coupler", "--gamma-min", "--AC1"),
    "slider": ("--stroke", "--K", "--offset", "--crank", "--rod", "--gamma-min"),
    "guide-bar": ("--K", "--frame", "--crank"),
    "positions": ("--at", "--at", "--at", "--coupler", "--A", "--D"),
    "angles": ("--pair", "--pair", "--pair", "--frame", "--crank", "--phi0", "--psi0"),
}
LIKELY = ("80", "40", "1.3", "100", "15", "0,50 0", "25,60 -10", "50,55 -30", "40:70", "70:85", "110:110", "0,0", "200,0")


def command_line(rng: random.Random) -> list[str]:
    """A command with some of its options, sensible or not."""
    if rng.random() < 0.12:
        return _without_file(rng)
    name = rng.choice(list(OPTIONS))
    words = [name, "mine.toml"]
    if name == "find":
        words.append(rng.choice(CONDITIONS))
    for option, values in rng.sample(list(OPTIONS[name].items()), min(len(OPTIONS[name]), rng.choice((0, 1, 1, 2, 3)))):
        likely = [value for value in values if value not in WORDS and value not in TEXTS]
        words += [option] if not values else [option, rng.choice(likely if likely and rng.random() < 0.6 else values)]
    return words


def _without_file(rng: random.Random) -> list[str]:
    if rng.random() < 0.5:
        kind = rng.choice(list(DESIGNS))
        words = ["design", kind]
        for option in DESIGNS[kind]:
            if rng.random() < 0.75:
                words += [option, rng.choice(WORDS) if rng.random() < 0.2 else rng.choice(LIKELY)]
        return [*words, *rng.choice(([], ["--json"], ["-o", "o.svg"], ["--toml", "o.toml"]))]
    name, option, count = rng.choice(ALONE)
    numbers = ("20", "70", "60", "80", *WORDS)
    return [name, *([option] if option else []), *(rng.choice(numbers) for _ in range(count))]


# --- running ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Case:
    """A file and a command line, by a number; `fault` says what went wrong, if anything did."""

    number: int
    file: bytes
    words: tuple[str, ...]
    fault: str = ""
    seconds: float = 0.0


def case(number: int) -> Case:
    rng = random.Random(f"graphkin {number}")
    return Case(number, spoilt(rng), tuple(command_line(rng)))


class TooLong(BaseException):
    """Raised by the clock; no command may catch it."""


@contextlib.contextmanager
def _clock(seconds: float) -> Iterator[None]:
    """Interrupts what takes more CPU time."""

    def ring(*_: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def run(given: Case) -> Case:
    """The case, with what went wrong. It runs in the working folder, which is to be empty."""
    for left in Path().iterdir():
        shutil.rmtree(left) if left.is_dir() else left.unlink()
    Path("mine.toml").write_bytes(given.file)
    begin = time.process_time()
    fault = _fault(given)
    return replace(given, fault=fault, seconds=time.process_time() - begin)


def _fault(given: Case) -> str:
    try:
        with _clock(SECONDS):
            result = CliRunner().invoke(main, list(given.words), env={"GRAPHKIN_LANG": "en"})
    except TooLong:
        return f"takes more than {SECONDS:g} s"
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        frames = traceback.extract_tb(result.exception.__traceback__)
        own = next((frame for frame in reversed(frames) if "graphkin" in frame.filename), frames[-1])
        return f"{type(result.exception).__name__}: {str(result.exception)[:120]} in {Path(own.filename).name}:{own.name}"
    if result.exit_code not in ((0, 1, 2, 3) if given.words[0] == "check" else (0, 2, 3)):
        return f"exit status {result.exit_code}"
    if result.exit_code and not result.stderr.strip() and "error" not in result.stdout:
        return f"exit status {result.exit_code} without a word"
    return _spoilt_output(given, result.stdout, result.stderr)


STEERING = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e]")


def _spoilt_output(given: Case, out: str, err: str) -> str:
    """What no output may have: characters that steer a terminal, XML or JSON that no reader takes, drafts left."""
    for text, name in ((out, "stdout"), (err, "stderr")):
        own = any(STEERING.search(word) for word in given.words)
        if (found := STEERING.search(text)) and not (own and name == "stderr"):
            return f"U+{ord(found.group()):04X} in {name}"
    try:
        if "--json" in given.words and not {"-o", "--steps"} & {*given.words}:
            for line in out.splitlines():
                json.loads(line, parse_constant=lambda word: _refuse(word))
        if out.startswith("<?xml"):
            ElementTree.fromstring(out)
        for path in (path for path in Path().rglob("*.svg") if path.is_file()):
            ElementTree.parse(path)
    except (ValueError, ElementTree.ParseError) as error:
        return f"{type(error).__name__}: {error}"
    drafts = [path.name for path in Path().rglob(".*") if path.is_file()]
    return f"draft {drafts[0]} left" if drafts else ""


def _refuse(word: str) -> float:
    raise ValueError(f"{word} in JSON")


def limited() -> None:
    """No more memory than allowed, for this process."""
    import resource

    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))


def _main(words: list[str]) -> None:
    begin, count = int(words[0]), int(words[1]) if len(words) > 1 else 1
    kept = Path(words[2]).resolve() if len(words) > 2 else None
    limited()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for number in range(begin, begin + count):
            done = run(case(number))
            if count == 1:
                print(done.file.decode("utf-8", "replace"))
            if count == 1 or done.fault:
                print(json.dumps({"case": number, "words": done.words, "fault": done.fault, "s": round(done.seconds, 2)}))
                sys.stdout.flush()
            if done.fault and kept is not None:
                kept.mkdir(exist_ok=True)
                (kept / f"{number}.toml").write_bytes(done.file)
        os.chdir("/")


if __name__ == "__main__":
    _main(sys.argv[1:])
