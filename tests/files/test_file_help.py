"""The page of the mechanism file and the descriptions of the JSON Schema: every key, in both languages, with an example."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import get_args

import pytest
from click.testing import CliRunner

from graphkin.cli import main
from graphkin.errors import Lang
from graphkin.files.fields import keys, kind_of
from graphkin.files.schema import FURTHER, TABLES
from graphkin.outputs.json_schema import json_schema
from graphkin.say.file_help import EXAMPLES, LINE, file_lines
from graphkin.say.text_table import width

LANGUAGES: tuple[Lang, ...] = get_args(Lang)


@pytest.mark.parametrize("table", TABLES)
def test_every_key_has_an_example(table: str) -> None:
    further = [FURTHER] if "patternProperties" in kind_of(TABLES[table]).json else []
    assert sorted(EXAMPLES[table]) == sorted([*keys(TABLES[table]), *further])


@pytest.mark.parametrize("table", TABLES)
def test_an_example_is_toml_of_its_key(table: str) -> None:
    for key, example in EXAMPLES[table].items():
        (written,) = tomllib.loads(example)
        assert written == key or key == FURTHER


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_page_has_every_key(lang: Lang) -> None:
    lines = list(file_lines(lang))
    for table, examples in EXAMPLES.items():
        shared = LINE if table in ("roll", "profile") else {}
        assert not [example for key, example in examples.items() if key not in shared and f"  {example}" not in lines]
    assert max(map(width, lines)) <= 112


def properties(node: object, path: str = "") -> Iterator[tuple[str, dict[str, object]]]:
    """Every key of the schema with what is said of it."""
    if isinstance(node, dict):
        for kind in ("properties", "patternProperties"):
            yield from ((f"{path}.{key}", told) for key, told in node.get(kind, {}).items())
        for key, child in node.items():
            yield from properties(child, f"{path}.{key}")


def test_every_key_of_the_schema_is_described_in_both_languages() -> None:
    """Names of links and points within a key, and the ends of ranges, are described with that key."""
    english, chinese = (dict(properties(json_schema(lang))) for lang in LANGUAGES)
    named = [path for path in english if not any(f".{key}." in path for key in ("sketch", "shape", "title", "links"))]
    named = [path for path in named if not path.endswith(".^(from|to|step)$")]
    assert len(named) > 60
    for path in named:
        assert len({english[path]["description"], chinese[path]["description"]} - {""}) == 2, path


def test_an_editor_is_told_units() -> None:
    driver = json_schema()["$defs"]["DriverTable"]["properties"]  # type: ignore[index]
    assert "[rad/s; as text also deg/s" in driver["omega"]["description"]


@pytest.mark.parametrize(("words", "said"), [("help file", "[[slide]]"), ("help sweep", "--driver"), ("help", "Commands")])
def test_help(words: str, said: str) -> None:
    result = CliRunner().invoke(main, words.split())
    assert result.exit_code == 0
    assert said in result.stdout


def test_no_such_page() -> None:
    result = CliRunner().invoke(main, ["help", "fiel"])
    assert result.exit_code == 2
    assert "file, api, or a command" in result.output
