"""`list`, `show`, `structure`, `schema`: what there is, and what it is made of."""

from __future__ import annotations

from pathlib import Path

import click

from graphkin.cli.shared import force_option, lang_option, mechanism_argument, read, speaking, svg_option
from graphkin.errors import Lang


@click.command("list")
@click.option("--kinds", is_flag=True, help="The kinds of four-bar, slider-crank and guide-bar linkages.")
@svg_option("With --kinds: sketches, as SVG.")
@force_option
@lang_option
@speaking
def list_(kinds: bool, output: Path | None, force: bool, lang: Lang) -> None:
    """List the mechanisms of the library, or the kinds of linkages.

    \b
    Example:
      graphkin list --lang zh
      graphkin list --kinds -o kinds.svg
    """
    if kinds:
        _kinds(output, force, lang)
        return
    if output is not None:
        raise click.UsageError("-o draws the kinds of linkages: --kinds")
    from graphkin import library

    for name, title in library.titles(lang).items():
        click.echo(f"{name:<12}{title}")


def _kinds(output: Path | None, force: bool, lang: Lang) -> None:
    from graphkin.say.linkages import family_lines

    click.echo("\n".join(family_lines(lang)))
    if output is not None:
        from graphkin.outputs import svg
        from graphkin.sheet.linkage_family import family_sheet

        svg.write(output, svg.svg(family_sheet(lang)), force)
        click.echo(str(output), err=True)


@click.command()
@click.argument("name")
@lang_option
@speaking
def show(name: str, lang: Lang) -> None:
    """Print the TOML file of a library mechanism, to start one's own from.

    \b
    Example:
      graphkin show ex3-1 > mine.toml
    """
    from graphkin import library

    click.echo(library.text(name), nl=False)


@click.command()
@mechanism_argument
@lang_option
@speaking
def structure(mechanism: str, lang: Lang) -> None:
    """List links, pairs, degrees of freedom and the Assur groups in the order they are solved.

    \b
    Example:
      graphkin structure p3-15
    """
    from graphkin import api
    from graphkin.say.structure import structure_lines

    for line in structure_lines(api.plan(read(mechanism)), lang):
        click.echo(line)


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
