"""`list`, `show`, `structure`, `schema`: what there is, and what it is made of."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli.shared import (
    angle_option,
    as_told,
    at_option,
    force_option,
    json_line,
    lang_option,
    library_names,
    mechanisms_argument,
    read_at,
    speaking,
    svg_option,
    told_each,
    told_option,
)
from graphkin.errors import Lang
from graphkin.files import library
from graphkin.say.catalogue import say

if TYPE_CHECKING:
    from graphkin.model.mechanism import Mechanism


@click.command("list")
@click.option("--kinds", is_flag=True, help="The kinds of four-bar, slider-crank and guide-bar linkages.")
@click.option("--kind", type=click.Choice(library.KINDS), help="With a pair of this kind; hinge: with hinges alone.")
@click.option("--group", type=click.Choice(library.groups()), help="Of this part of the library.")
@click.option("--source", default="", metavar="TEXT", help='Whose source has this text, such as "3-1".')
@svg_option("With --kinds: sketches, as SVG.")
@force_option
@lang_option
@speaking
def list_(
    kinds: bool, kind: str | None, group: str | None, source: str, output: Path | None, force: bool, lang: Lang
) -> None:
    """List the mechanisms of the library with their titles, all or some, or the kinds of linkages.

    \b
    Example:
      graphkin list --lang zh
      graphkin list --kind gear --group classics
      graphkin list --kinds -o kinds.svg
    """
    if kinds:
        _kinds(output, force, lang)
        return
    if output is not None:
        raise click.UsageError("-o draws the kinds of linkages: --kinds")
    found = library.chosen(kind or "", group or "", source)
    if not found:
        click.echo(say("structure.none listed", lang), err=True)
    titles = library.titles(lang)
    for name in found:
        click.echo(f"{name:<12}{titles[name]}")


def _kinds(output: Path | None, force: bool, lang: Lang) -> None:
    from graphkin.say.linkages import family_lines

    click.echo("\n".join(family_lines(lang)))
    if output is not None:
        from graphkin.outputs import drawings, svg
        from graphkin.sheet.linkage_family import family_sheet

        drawings.write(output, svg.svg(family_sheet(lang)), force)
        click.echo(str(output), err=True)


@click.command()
@click.argument("name", shell_complete=library_names)
@lang_option
@speaking
def show(name: str, lang: Lang) -> None:
    """Print the TOML file of a library mechanism, to start one's own from.

    \b
    Example:
      graphkin show ex3-1 > mine.toml
    """
    click.echo(library.text(name), nl=False)


@click.command()
@mechanisms_argument
@told_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line.")
@force_option
@angle_option
@at_option
@lang_option
@speaking
def structure(
    mechanisms: tuple[str, ...], output: Path | None, as_json: bool, force: bool, angles: tuple[float, ...],
    displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """List links, pairs, degrees of freedom and the Assur groups in the order they are solved.

    \b
    Example:
      graphkin structure p3-15
    """
    data = as_told(as_json, output, len(mechanisms))

    def told(source: str) -> Iterator[str]:
        return _structure(read_at(source, angles, displacements), data, lang)

    told_each(mechanisms, told, data, lang, output, force)


def _structure(machine: Mechanism, as_json: bool, lang: Lang) -> Iterator[str]:
    from graphkin import api
    from graphkin.say.structure import structure_lines
    from graphkin.studies import assur

    method = api.plan(machine)
    if as_json:
        yield json_line(assur.as_json(method))
    else:
        yield from structure_lines(method, lang)


@click.command()
@lang_option
@speaking
def schema(lang: Lang) -> None:
    """Print the JSON Schema of the mechanism file, for editors.

    \b
    Example:
      graphkin schema > graphkin.schema.json
    """
    from graphkin.outputs.json_schema import json_schema_text

    click.echo(json_schema_text(lang), nl=False)
