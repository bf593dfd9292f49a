"""README and manual: what they name is there, in both languages; the Python and the mechanism of the README work."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import click
import pytest

import graphkin
from graphkin.cli import main
from graphkin.cli.manual import skeleton
from graphkin.errors import Lang
from graphkin.outputs import drawings

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")
ENGLISH, _, CHINESE = TEXT.partition("# graphkin 中文\n")
HALVES = {"en": ENGLISH, "zh": CHINESE}
LANGUAGES: tuple[Lang, ...] = get_args(Lang)
SPAN = re.compile(r"`+([^`\n]+)`+")
OPTION = re.compile(r"(?<![\w-])--?[A-Za-z][\w-]*")


def commands(text: str) -> Iterator[tuple[str, str]]:
    """The command and the words of everything in code that calls graphkin; in a line that begins so also what follows it."""
    for line in text.splitlines():
        name, row = "", line.startswith("`graphkin")
        spans = SPAN.findall(re.split(": |：", line)[0] if row else line)
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


@pytest.mark.parametrize("lang", LANGUAGES)
def test_commands_have_the_options_that_are_named(lang: Lang) -> None:
    assert len({name for name, _ in commands(HALVES[lang])}) > 15
    found = list(commands(HALVES[lang] + skeleton(lang)))
    assert len({name for name, _ in found}) == len(main.list_commands(click.Context(main))), "every command is named"
    for name, words in found:
        known = options(name)
        for option, choices in re.findall(rf"({OPTION.pattern})(?: ([a-z]+(?:\|[a-z]+)+))?", words):
            assert option in known, f"{name} {option}"
            kind = known[option].type
            if choices and isinstance(kind, click.Choice):
                assert set(choices.split("|")) <= set(kind.choices), f"{name} {option} {choices}"


@pytest.mark.parametrize("lang", LANGUAGES)
def test_every_format_is_named(lang: Lang) -> None:
    [row] = [line for line in skeleton(lang).splitlines() if line.startswith("`graphkin draw ")]
    for ending in drawings.DRAWN:
        assert f"{ending}|" in row, f"the line of draw has no {ending}"


def test_both_halves_have_the_same_commands_and_pictures() -> None:
    lines = [re.findall("(?m)^(`graphkin .*?`)(?:: |：)", skeleton(lang)) for lang in LANGUAGES]
    assert lines[0] == lines[1]
    assert len(lines[0]) > 20
    marks = [re.findall(r"(?m)^\{(.*)\}$", skeleton(lang)) for lang in LANGUAGES]
    assert marks[0] == marks[1]
    run = [words.split()[1] for words in marks[0] if words.startswith("run ")]
    assert sorted(run) == sorted(main.list_commands(click.Context(main))), "every command has a picture"
    pictures = [re.findall(r"!\[[^]]+\]\(([^)]+)\)", text) for text in (ENGLISH, CHINESE)]
    assert [re.sub("-zh", "", name) for name in pictures[1]] == pictures[0]
    for target in re.findall(r"\]\(((?!http|#)[^)]+)\)", TEXT):
        assert (ROOT / target).is_file(), target
    for link in re.findall(r"\]\(#([^)]+)\)", TEXT):
        assert link in [re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in re.findall("(?m)^#+ (.*)", TEXT)]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_it_is_short(lang: Lang) -> None:
    assert HALVES[lang].count("\n") <= 150


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_mechanism_of_ones_own_is_drawn(lang: Lang) -> None:
    (text,) = re.findall(r"```toml\n(.*?)```", HALVES[lang], re.S)
    drawing = graphkin.Drawing.of(graphkin.loads(text))
    assert abs(drawing.answers()["omega 3"].value) > 1  # type: ignore[union-attr]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_notebook_lines_run(lang: Lang) -> None:
    (code,) = re.findall(r"```python\n(.*?)```", HALVES[lang], re.S)
    names: dict[str, object] = {}
    exec(compile(code.replace("range(361)", "range(0, 361, 30)"), "README", "exec"), names)
    assert round(names["drawing"].omega["3"], 3) == -3.919  # type: ignore[attr-defined]
