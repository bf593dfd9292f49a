"""No number that is but rounding is printed: what is below that part of the usual size of its kind which `ROUNDING` says is printed as 0."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
import rolling_machines
from click.testing import CliRunner
from every_family import REPEATING, from_text, repeated

from graphkin.cli import main as graphkin
from graphkin.files import library
from graphkin.model.mechanism import Mechanism, Usual
from graphkin.model.quantities import EDGE

COMMANDS = (
    "solve @", "solve @ --json", "explain @ --all", "explain @ --all --lang zh", "equations @",
    "equations @ --method matrix", "structure @ --json", "centres @", "centres @ --json", "linkage @",
    "linkage @ --json", "tolerance @", "tolerance @ --json", "sweep @ --table", "sweep @ -o +.csv", "sweep @ -o +.json",
    "handout @ --stage solution -o +.html", "draw @ -o +.svg",
)  # fmt: skip
ALL = "GRAPHKIN_RANDOM" in os.environ
NAMES = library.names()[:: 1 if ALL else 5]
EVERY = 14
"""Every command of every mechanism; else of some mechanisms, of each so many apart, in turns."""
TURNED = ("solve @ --json", "explain @ --all")
"""At other angles of the crank, too: there something stands still, or moves straight. All, else one in turns."""
UNITS = {"mm": "m", "m": "m", "°": "rad", "deg": "rad", "rad": "rad", "m/s": "m/s", "mm/s": "m/s", "m/s^2": "m/s^2",
         "m/s²": "m/s^2", "rad/s": "rad/s", "rad/s^2": "rad/s^2", "rad/s²": "rad/s^2"}  # fmt: skip
KEYS = {"theta": "rad", "omega": "rad/s", "alpha": "rad/s^2", "r": "m", "v": "m/s", "a": "m/s^2", "s": "m",
        "a_k": "m/s^2", "a_r": "m/s^2", "at": "m", "direction": "rad"}  # fmt: skip
PROOF = ("worst",)
"""How far both roads differ: it is rounding that is told there."""
FAMILIES = {**{name: partial(from_text, family) for name, family in rolling_machines.FAMILIES.items()},
            **{name: partial(from_text, partial(repeated, name)) for name in REPEATING}}  # fmt: skip
_POWER = r"(?:[eE][-+]?\d+|·10\^\([-+]?\d+\))?"
NUMBER = re.compile(rf"(?<![\w.^(])(-?\d+(?:\.\d+)?{_POWER})(?: ?(mm/s|mm|m/s\^2|m/s²|m/s|rad/s\^2|rad/s²|rad/s|deg|°|m)\b)?")
DIFFERENCE = re.compile(r"(?<=\s)-?\d\.\de[-+]\d\d(?=\s|$)")


def run(line: str, source: str, folder: Path) -> str:
    """What a command prints, or writes; nothing where it refuses."""
    words = [word.replace("@", source).replace("+.", f"{folder}/out.") for word in line.split()]
    found = CliRunner().invoke(graphkin, words)
    assert found.exit_code in (0, 3), (line, found.output, found.exception)
    written = next((Path(word) for word in words if "/out." in word), None)
    if found.exit_code:
        return ""
    return (found.output if written is None else written.read_text("utf-8-sig")).replace("−", "-")


def least(usual: Usual, unit: str = "") -> float:
    """In SI; of a number without a unit, what is nothing of any kind."""
    kinds = [unit] if unit else ["m", "rad", "rad/s", "rad/s^2", "m/s", "m/s^2"]
    return min((size for kind in kinds if (size := usual.least(kind))), default=0.0)


def in_text(text: str, usual: Usual) -> Iterator[str]:
    for found in NUMBER.finditer(text.replace("−", "-")):
        value = float(re.sub(r"·10\^\(([-+]?\d+)\)", r"e\1", found[1]))
        shown, kind = found[2] or "", UNITS.get(found[2] or "", "")
        factor = 1.0 if shown == "m" else EDGE[kind].factor if kind else 1.0
        if 0 < abs(value) < 0.999 * least(usual, kind) * factor:
            yield text[max(0, found.start() - 50) : found.end() + 10]


def in_data(data: object, usual: Usual, where: tuple[str, ...] = ()) -> Iterator[str]:
    if isinstance(data, dict):
        unit = str(data.get("unit") or "")
        for key, value in data.items():
            if key not in PROOF:
                yield from in_data(value, usual, (*where, unit if key in ("right", "value", "values", "vector") else key))
    elif isinstance(data, list):
        for value in data:
            yield from in_data(value, usual, where)
    elif isinstance(data, float):
        last = where[-1] if where else ""
        if 0 < abs(data) < 0.999 * least(usual, KEYS.get(last) or (last if last in EDGE else "")):
            yield f"{'.'.join(where)}: {data}"


def in_table(text: str, usual: Usual) -> Iterator[str]:
    head, *rows = text.splitlines()
    names = head.split(",")
    units = [found[1] if (found := re.search(r"\[(.*)\]", name)) else "" for name in names]
    for row in rows:
        for name, unit, cell in zip(names, units, row.split(",")):
            kind = UNITS.get(unit, "")
            factor = EDGE[kind].factor if kind else 1.0
            if cell and 0 < abs(float(cell)) < 0.999 * least(usual, kind) * factor:
                yield f"{name}: {cell}"


def noise(line: str, text: str, usual: Usual) -> list[str]:
    if ".csv" in line:
        return [*in_table(text, usual)] if text else []
    if "json" in line:
        return [found for each in text.splitlines() for found in in_data(json.loads(each), usual)]
    if line.startswith("solve"):
        text = "\n".join(DIFFERENCE.sub("", each) for each in text.splitlines() if "worst" not in each)
    return [*in_text(re.sub(r"<[^>]*>", "", text), usual)]


def hold(machine: Mechanism, source: str, commands: tuple[str, ...], folder: Path, more: str = "") -> None:
    for line in commands:
        assert not noise(line, run(line + more, source, folder), machine.usual), line + more


@pytest.mark.parametrize("name", NAMES)
def test_library(name: str, tmp_path: Path) -> None:
    machine = library.load(name)
    hold(machine, name, COMMANDS if ALL else COMMANDS[NAMES.index(name) % EVERY :: EVERY], tmp_path)
    if all(driver.kind == "angle" for driver in machine.drivers):
        angles = (0, 90, 180)
        for angle in angles if ALL else (angles[NAMES.index(name) % 3],):
            hold(machine, name, TURNED, tmp_path, f" --angle {angle}" * len(machine.drivers))


@pytest.mark.usefixtures("one_paper")
@pytest.mark.parametrize("family", FAMILIES)
def test_random_mechanisms(family: str, tmp_path: Path) -> None:
    machine = FAMILIES[family](0)
    source = tmp_path / "machine.toml"
    source.write_text(machine.text, "utf-8")
    hold(machine, str(source), COMMANDS if ALL else COMMANDS[[*FAMILIES].index(family) % EVERY :: EVERY], tmp_path)


def test_noise_is_seen() -> None:
    """What the tests above look for, as it was printed once."""
    usual = library.load("p3-6a").usual
    assert noise("explain", "v_C = 8.547e−17 m/s", usual)
    assert noise("tolerance", "omega 2 *  −2.651e−16   0.05959", usual)
    assert noise("solve --json", '{"links": {"2": {"omega": 1.07e-15}}}', usual)
    assert noise("sweep -o +.csv", "AB [deg],omega 4 [rad/s]\n90,-4.1e-18", usual)
    assert not noise("explain", "v_C = 8.547e−7 m/s", usual)
