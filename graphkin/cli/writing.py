"""`equations`: the analytic methods written out."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

from graphkin.cli.shared import force_option, lang_option, mechanism_argument, read, speaking
from graphkin.errors import Lang


@click.command()
@mechanism_argument
@click.option("--method", type=click.Choice(["complex", "matrix"]), default="complex", show_default=True,
              help="Complex vectors, with closed forms; or one system of matrices.")  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False),
              help=".txt, .html or .tex; else printed.")  # fmt: skip
@force_option
@lang_option
@speaking
def equations(
    mechanism: str, method: Literal["complex", "matrix"], output: Path | None, force: bool, lang: Lang
) -> None:
    """Write out the analytic solution: loops of link vectors, their equations derived twice, closed forms or matrices.

    \b
    Example:
      graphkin equations ex3-5
      graphkin equations ex3-7 --method matrix --lang zh -o shaper.html
    """
    from graphkin import api
    from graphkin import equations as writing

    if output is not None and output.suffix.lower() not in writing.WRITERS:
        raise click.UsageError(f"{output}: the file to write must end in .txt, .html or .tex")
    document = writing.document(api.plan(read(mechanism)), method, lang)
    if output is None:
        click.echo(writing.write_text(document), nl=False)
        return
    writing.write(output, document, force)
    click.echo(str(output))
