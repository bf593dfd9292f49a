"""The JSON Schema takes what graphkin reads, problem templates too, and refuses what an editor should mark."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from graphkin.files import library, starters
from graphkin.outputs.json_schema import json_schema

ROOT = Path(__file__).parents[2]
SCHEMA: Any = json_schema()
TYPES = {"object": (dict,), "array": (list,), "string": (str,), "boolean": (bool,), "number": (int, float)}
BOUNDS = {
    "minimum": lambda value, bound: value >= bound, "exclusiveMinimum": lambda value, bound: value > bound,
    "exclusiveMaximum": lambda value, bound: value < bound,
}  # fmt: skip


def faults(value: Any, rule: Any, path: str = "") -> Iterator[str]:
    """The places of a file that break the schema; the words of JSON Schema that ours has, and no other."""
    kinds = rule.get("type", [*TYPES])
    if type(value) not in [kind for name in ([kinds] if isinstance(kinds, str) else kinds) for kind in TYPES[name]]:
        yield path
        return
    for word, said in rule.items():
        match word:
            case "$ref":
                found = SCHEMA
                for name in said.removeprefix("#/").split("/"):
                    found = found[int(name) if isinstance(found, list) else name]
                yield from faults(value, found, path)
            case "anyOf" | "oneOf":
                fitting = sum(not list(faults(value, each, path)) for each in said)
                if not fitting or (word == "oneOf" and fitting > 1):
                    yield path
            case "enum" if value not in said:
                yield path
            case "pattern" if isinstance(value, str) and not re.search(said, value):
                yield path
            case "minItems" | "maxItems" if isinstance(value, list) and len(value) != said:
                yield path
            case "items" if isinstance(value, list):
                for k, each in enumerate(value):
                    yield from faults(each, said, f"{path}.{k}")
            case "required" if isinstance(value, dict):
                yield from (f"{path}.{key}" for key in said if key not in value)
            case _ if word in BOUNDS and isinstance(value, int | float) and not BOUNDS[word](value, said):
                yield path
    if isinstance(value, dict) and {"properties", "patternProperties"} & rule.keys():
        for key, inner in value.items():
            rules = [rule.get("properties", {}).get(key)]
            rules += [each for pattern, each in rule.get("patternProperties", {}).items() if re.search(pattern, key)]
            if not any(rules) and rule.get("additionalProperties") is False:
                yield f"{path}.{key}"
            for each in filter(None, rules):
                yield from faults(inner, each, f"{path}.{key}")


def of(text: str) -> list[str]:
    return list(faults(tomllib.loads(text), SCHEMA))


def test_every_file_there_is_fits() -> None:
    files = [library.text(name) for name in library.names()] + [starters.text(kind, "zh") for kind in starters.kinds()]
    cases = (*Path(__file__).parents[1].glob("cases/*.toml"), Path(__file__).parents[1] / "cases/homework/rocker.toml")
    assert [(text[:80], of(text)) for text in (*files, *(case.read_text("utf-8") for case in cases)) if of(text)] == []


GOOD = library.text("ex3-1")


@pytest.mark.parametrize(
    ("right", "other", "fits"),
    [
        ("AB = 24", "AB = -24", False), ("AB = 24", "AB = 0", False), ("AB = 24", 'AB = "-24 mm"', False),
        ("AB = 24", 'AB = "0.8 in"', True), ("AB = 24", 'AB = "24 deg"', False), ("AB = 24", "AB = true", False),
        ("AB = 24", "AB = { from = 20, to = 30, step = 1 }", True), ("AB = 24", "AB = { from = 20 }", False),
        ("AB = 24", 'AB = { from = "2 cm", to = "3 cm" }', True), ("AB = 24", "AB = { from = -2, to = 3 }", False),
        ("AB = 24", "AB = { from = 20, to = 30, steps = 1 }", False),
        ("angle = 60", 'angle = "sixty"', False), ("angle = 60", 'angle = "60"', False), ("angle = 60", "angle = -60", True),
        ("angle = 60", 'angle = "-1.05 rad"', True), ("angle = 60", 'angle = "60°"', True), ("angle = 60", "angel = 60", False),
        ("omega = 10", 'omega = "95 r / min"', True), ("omega = 10", "omega = { from = 5, to = 9 }", True),
        ("omega = 10", 'omega = 10\nalpha = "2 rad/s^2"', True), ("omega = 10", 'omega = "10 rad/s²"', False),
    ],
)  # fmt: skip
def test_what_an_editor_marks(right: str, other: str, fits: bool) -> None:
    assert GOOD.count(f"{right}\n") == 1
    text = GOOD.replace(f"{right}\n", f"{other}\n")
    assert (of(text) == []) is fits, of(text)


def test_points_of_answers() -> None:
    points = GOOD.replace("[frame]", '[points]\nfollows = "half"\n"omega 3" = 2\n\n[frame]')
    assert of(points) == []
    assert of(points.replace("half", "often")) == [".points.follows"]


def test_its_address_is_where_it_lies() -> None:
    """In the repository that pyproject.toml names, under its name in the package; a new file says so."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    home = project["urls"]["Repository"].replace("https://github.com/", "https://raw.githubusercontent.com/")
    assert SCHEMA["$id"] == starters.SCHEMA
    assert (ROOT / starters.SCHEMA.removeprefix(f"{home}/main/")).is_file()
    assert starters.text("cam", "en").splitlines()[0] == f"#:schema {starters.SCHEMA}"
