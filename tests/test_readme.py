"""The README: what it names is there, in both languages, and its Python runs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from graphkin.cli import main
from graphkin.outputs import drawings

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
ENGLISH, _, CHINESE = TEXT.partition("# graphkin 中文\n")
SPAN = re.compile(r"`+([^`\n]+)`+")
OPTION = re.compile(r"(?<![\w-])--?[A-Za-z][\w-]*")


def commands(text: str) -> Iterator[tuple[str, str]]:
    """The command and the words of everything in code that calls graphkin; in a row of a table also what follows it."""
    for line in text.splitlines():
        name, row = "", line.startswith("| `graphkin")
        spans = SPAN.findall(line.rpartition(" | ")[0] if row else line)
        for span in spans:
            if found := re.match(r"(?:\.venv/bin/)?graphkin ([a-z]+)\b(.*)", span):
                name = found[1]
                yield name, found[2]
            elif row and name:
                yield name, span


def options(name: str) -> dict[str, click.Parameter]:
    command = main.get_command(click.Context(main), name)
    assert command is not None, name
    parts = [command, *(command.commands.values() if isinstance(command, click.Group) else ())]
    return {word: option for part in parts for option in part.params for word in (*option.opts, *option.secondary_opts)}


@pytest.mark.parametrize("text", [ENGLISH, CHINESE], ids=["en", "zh"])
def test_commands_have_the_options_that_are_named(text: str) -> None:
    found = list(commands(text))
    assert len({name for name, _ in found}) == len(main.list_commands(click.Context(main))), "every command is named"
    for name, words in found:
        known = options(name)
        for option, choices in re.findall(rf"({OPTION.pattern})(?: ([a-z]+(?:\\\|[a-z]+)+))?", words):
            assert option in known, f"{name} {option}"
            kind = known[option].type
            if choices and isinstance(kind, click.Choice):
                assert set(choices.split("\\|")) <= set(kind.choices), f"{name} {option} {choices}"


@pytest.mark.parametrize("text", [ENGLISH, CHINESE], ids=["en", "zh"])
def test_every_format_is_named(text: str) -> None:
    [row] = [line for line in text.splitlines() if line.startswith("| `graphkin draw ")]
    for ending in drawings.WRITERS:
        assert f"{ending}\\|" in row, f"the row of draw has no {ending}"


def test_both_halves_have_the_same_commands_and_pictures() -> None:
    tables = [[line.rpartition(" | ")[0] for line in text.splitlines() if line.startswith("| `graphkin")] for text in (ENGLISH, CHINESE)]
    assert tables[0] == tables[1]
    pictures = [re.findall(r"!\[[^]]+\]\(([^)]+)\)", text) for text in (ENGLISH, CHINESE)]
    assert [re.sub("-zh", "", name) for name in pictures[1]] == pictures[0]
    for target in re.findall(r"\]\(((?!http|#)[^)]+)\)", TEXT):
        assert (ROOT / target).is_file(), target
    for link in re.findall(r"\]\(#([^)]+)\)", TEXT):
        assert link in [re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in re.findall("(?m)^#+ (.*)", TEXT)]


def test_the_notebook_lines_run() -> None:
    (code,) = re.findall(r"```python\n(.*?)```", TEXT, re.S)
    names: dict[str, object] = {}
    exec(compile(code.replace("range(361)", "range(0, 361, 30)"), "README", "exec"), names)
    assert round(names["drawing"].omega["3"], 3) == -3.919  # type: ignore[attr-defined]
