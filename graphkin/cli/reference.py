"""`help`: the pages that say more than a command's own `--help`; the Python interface by its docstrings.

>>> "solve_many(mechanisms" in text("solve_many"), "with_(" in text("Mechanism")
(True, True)
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from copy import copy
from dataclasses import fields, is_dataclass
from functools import cached_property
from importlib import import_module
from pathlib import Path
from textwrap import wrap
from typing import Any, get_args

import click

import graphkin
from graphkin.cli import shared
from graphkin.cli.spoken import misused
from graphkin.errors import Lang

_INHERITED = ("Readable", "Measured")
_ALSO = {
    "Builder": "files.builder", "Variants": "files.variants", "Trial": "api.variants", "Readable": "model.readout",
    "Measured": "model.units", "Series": "studies.sweeps", "Method": "planning", "Plot": "construction",
    "NotebookSheet": "outputs.saving", "VectorMark": "sheet.marks", "PointMark": "sheet.marks", "Text": "sheet.marks",
    "Stroke": "sheet.marks", "Disc": "sheet.marks", "ArcMark": "sheet.marks", "DiagramPage": "outputs.diagram.page",
    "SavedHandout": "handouts.saving", "SavedPage": "page.player", "Solved": "api.batches",
    "Swept": "api.batches", "Findings": "studies.finding", "Centres": "studies.centres", "Design": "studies.design",
    "Solution": "studies.design", "Tolerances": "marking.tolerances", "Graded": "marking.records",
    "Judged": "marking.records", "VaryingTable": "studies.finding", "Structure": "studies.assur",
    "Report": "studies.linkages", "Power": "marking.power", "SavedDocument": "equations", "RulerReport": "check",
    "Position": "studies.finding", "Marked": "marking.records", "MistakePower": "marking.power",
    "KeyEntry": "marking.key", "Variant": "homework.problems",
}  # fmt: skip
"""Classes that public names give or share."""
_QUOTED = re.compile(r"(: |-> )'([^']*)'")
_WORDS = {"Lang": "errors", "Plane": "construction", "Style": "sheet", "Ink": "outputs.paint", "Road": "studies.sweeps",
          "Stage": "handouts.document", "Reveal": "homework.platforms.feedback", "By": "equations"}  # fmt: skip
"""Of signatures: each stands for some words, in its module."""


def names() -> tuple[str, ...]:
    """All that has a page: the public names, then what they give."""
    return (*graphkin.__all__, *_ALSO)


def text(*chosen: str, lang: Lang = "en") -> str:
    """The pages of these names; of all, behind what one writes for which job, if none is given."""
    pages = [] if chosen else ["\n".join(_jobs(lang))]
    return "\n\n".join([*pages, *("\n".join(_page(name)) for name in chosen or names())])


def _jobs(lang: Lang) -> Iterator[str]:
    """The manual's own text of the Python interface, its table as pairs of lines."""
    from graphkin.cli.manual import skeleton

    section = skeleton(lang).partition("{api}")[0].rpartition("\n## ")[2].partition("\n")[2].strip()
    for line in re.sub(r"\[(\w+)\]\(#\w+\)", r"\1", section).replace("`", "").splitlines():
        wanted, bar, written = line.strip("| ").partition(" | ")
        if not line.startswith("|---"):
            yield from (wanted, f"    {written}") if bar else (line,)


def _page(name: str) -> Iterator[str]:
    value = getattr(import_module(f"graphkin.{_ALSO[name]}"), name) if name in _ALSO else getattr(graphkin, name)
    home = f" (of graphkin.{_ALSO[name]})" if name in _ALSO else ""
    yield f"{name}{_signature(value) if not inspect.isclass(value) else home}"
    yield "-" * len(name)
    yield inspect.getdoc(value) or ""
    if inspect.isclass(value):
        if is_dataclass(value):
            holds = ", ".join(f"{each.name}: {each.type}" for each in fields(value) if not each.name.startswith("_"))
            yield from ("", *wrap(f"Holds {holds}", 110, subsequent_indent="    ", break_on_hyphens=False))
        for member, method in _members(value):
            yield from ("", f"  .{member}{_signature(method)}")
            yield from (f"      {line}".rstrip() for line in (inspect.getdoc(_function(method)) or "").splitlines())


def _members(cls: type) -> Iterator[tuple[str, object]]:
    """Members that a class itself and its own kin document, not those of every mapping or exception."""
    seen: set[str] = set()
    for kin in cls.__mro__:
        if not kin.__module__.startswith("graphkin") or (kin is not cls and kin.__name__ in _INHERITED):
            continue
        for member, value in vars(kin).items():
            own = str(getattr(_function(value), "__module__", "")).startswith("graphkin") and _function(value).__doc__
            if member.startswith("_") or member in seen or not own:
                continue
            if inspect.isroutine(value) or isinstance(value, property | classmethod | staticmethod):
                seen.add(member)
                yield member, value


def _function(member: object) -> Any:
    """The function behind a property, a class method or a static method."""
    if isinstance(member, property | cached_property):
        return member.fget if isinstance(member, property) else member.func
    return getattr(member, "__func__", member)


def _signature(value: object) -> str:
    """`(mechanism: Mechanism, ..) -> Sweep`; nothing of a property."""
    if isinstance(value, property | cached_property):
        return ""
    try:
        shown = str(inspect.signature(_function(value)))
    except (TypeError, ValueError):
        return ""
    shown = _QUOTED.sub(r"\1\2", re.sub(r"\((?:self|cls)(?:, )?", "(", shown, count=1))
    return re.sub(rf": ({'|'.join(_WORDS)})\b", _spelled, shown)


def _spelled(name: re.Match[str]) -> str:
    """`: Lang` -> `: 'en' | 'zh'`."""
    words = getattr(import_module(f"graphkin.{_WORDS[name[1]]}"), name[1])
    return f": {' | '.join(map(repr, get_args(words)))}"


def in_chinese(command: click.Command) -> click.Command:
    """A command with what the manual's own text says of it, line by line, before its examples."""
    from graphkin.cli.manual import skeleton

    told = "".join(re.findall(rf"(?m)^\{{run {command.name} ?.*\}}\n((?:.+\n)*)", skeleton("zh")))
    _, mark, examples = inspect.cleandoc(command.help or "").partition("\b")
    described, lines = copy(command), "\n\n".join(f"\b\n{line}" for line in told.splitlines())
    described.help = f"{lines}\n\n{mark}{examples}" if told else command.help
    return described


@click.command("help")
@click.argument("topic", metavar="[file|api|COMMAND]", default="")
@click.argument("chosen", nargs=-1, metavar="[NAME]...")
@click.option("--html", "whole", is_flag=True, help="The whole manual with pictures, as one web page.")
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False), help="With --html: the file to write.")
@shared.force_option
@shared.speaking
def help_(topic: str, chosen: tuple[str, ...], whole: bool, output: Path | None, force: bool, lang: Lang) -> None:
    """Print the reference of the mechanism file, of the Python interface, or what a command says of itself.

    After api: the names that are wanted; all without any. The manual has all of it.

    \b
    Example:
      graphkin help file
      graphkin help api sweep Mechanism
      graphkin help sweep
      graphkin help --html -o manual.html
    """
    if whole or output is not None:
        misused("usage.manual", topic or output is None or not whole)
        assert output is not None
        from graphkin.cli import manual

        manual.write(output, force, lang, {name: text(name) for name in names()})
        return
    if topic == "api":
        unknown = [name for name in chosen if name not in names()]
        misused("usage.names", unknown, names=", ".join(unknown), known=", ".join(names()))
        click.echo(text(*chosen, lang=lang))
        return
    misused("usage.needs", chosen, option=" ".join(chosen), other="help api")
    if topic == "file":
        from graphkin.say.file_help import file_lines

        click.echo("\n".join(file_lines(lang)))
        return
    context = click.get_current_context().find_root()
    group = context.command
    assert isinstance(group, click.Group)
    misused("usage.page", topic and topic not in group.list_commands(context), topic=topic)
    if topic:
        _, command, _ = group.resolve_command(context, [topic, "--help"])
        assert command is not None
        context = click.Context(command, info_name=topic, parent=context)
    click.echo(context.get_help())
