"""`list`, `show`, `new`, `structure`, `schema`: what there is, what it is made of, and files to start from."""

from __future__ import annotations

from pathlib import Path

import click

from graphkin.cli import shared
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.errors import Lang
from graphkin.files import library, starters
from graphkin.say.catalogue import say


@click.command("list")
@click.option("--kinds", is_flag=True, help="The kinds of four-bar, slider-crank and guide-bar linkages.")
@click.option("--kind", type=click.Choice(library.KINDS), help="With a pair of this kind; hinge: with hinges alone.")
@click.option("--group", type=click.Choice(library.groups()), help="Of this part of the library.")
@click.option("--source", default="", metavar="TEXT", help='Whose source has this text, such as "3-1".')
@shared.svg_option("With --kinds: sketches, as SVG.")
@shared.force_option
@shared.speaking
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
        from graphkin.say.linkages import family_lines

        click.echo("\n".join(family_lines(lang)))
        if output is not None:
            from graphkin.outputs.saving import NotebookSheet
            from graphkin.sheet.linkage_sheet import family_sheet

            click.echo(str(NotebookSheet.of(family_sheet(lang)).save(output, force=force)), err=True)
        return
    misused("usage.needs", output, option="-o", other="--kinds")
    names = library.chosen(kind or "", group or "", source)
    if not names:
        click.echo(say("structure.none listed", lang), err=True)
    titles = library.titles(lang)
    for name in names:
        click.echo(f"{name:<12}{titles[name]}")


@click.command()
@click.argument("name", shell_complete=shared.library_names)
@shared.speaking
def show(name: str, lang: Lang) -> None:
    """Print the TOML file of a library mechanism, to start one's own from.

    \b
    Example:
      graphkin show ex3-1 > mine.toml
    """
    click.echo(library.text(name), nl=False)


@click.command()
@click.argument("kind", type=click.Choice(starters.kinds()))
@shared.speaking
def new(kind: str, lang: Lang) -> None:
    """Print a mechanism file of a kind, with comments, to start one's own from.

    \b
    Example:
      graphkin new four-bar > mine.toml
      graphkin new shaper --lang zh > mine.toml
    """
    click.echo(starters.text(kind, lang), nl=False)


@click.command()
@shared.mechanisms_argument
@shared.text_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line.")
@shared.force_option
@shared.driver_options
@shared.speaking
def structure(
    mechanisms: tuple[str, ...], output: Path | None, as_json: bool, force: bool, at: DriverOptions, lang: Lang
) -> None:
    """List links, pairs, degrees of freedom and the Assur groups in the order they are solved.

    \b
    Example:
      graphkin structure p3-15
    """
    from graphkin.api import answers

    def answer(source: str) -> object:
        return answers.structure(shared.placed(source, at))

    shared.print_answers(mechanisms, answer, shared.wants_json(as_json, output, len(mechanisms)), lang, output, force)


@click.command()
@shared.speaking
def schema(lang: Lang) -> None:
    """Print the JSON Schema of the mechanism file, for editors.

    \b
    Example:
      graphkin schema > graphkin.schema.json
    """
    from graphkin.outputs.json_schema import json_schema_text

    click.echo(json_schema_text(lang), nl=False)
