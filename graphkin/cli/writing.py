"""`equations`: the analytic methods written out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from graphkin.cli.shared import (
    angle_option,
    at_option,
    force_option,
    lang_option,
    mechanisms_argument,
    read_at,
    speaking,
    told_each,
)
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.equations import Document


@click.command()
@mechanisms_argument
@click.option("--method", type=click.Choice(["complex", "matrix"]), default="complex", show_default=True,
              help="Complex vectors, with closed forms; or one system of matrices.")  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path, dir_okay=False),
              help=".txt, .html or .tex; else printed.")  # fmt: skip
@force_option
@angle_option
@at_option
@lang_option
@speaking
def equations(
    mechanisms: tuple[str, ...], method: Literal["complex", "matrix"], output: Path | None, force: bool,
    angles: tuple[float, ...], displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Write out the analytic solution: loops of link vectors, their equations derived twice, closed forms or matrices.

    \b
    Example:
      graphkin equations ex3-5
      graphkin equations ex3-5 --angle 120
      graphkin equations ex3-7 --method matrix --lang zh -o shaper.html
    """
    from graphkin import api
    from graphkin import equations as writing

    def written(source: str) -> Document:
        return writing.document(api.plan(read_at(source, angles, displacements)), method, lang)

    if output is not None and output.suffix.lower() not in writing.WRITERS:
        raise click.UsageError(f"{output}: the file to write must end in .txt, .html or .tex")
    if output is None:
        told_each(mechanisms, lambda source: iter(writing.write_text(written(source)).splitlines()), False, lang)
        return
    if len(mechanisms) > 1:
        raise click.UsageError("-o writes one file; name one MECHANISM, or leave -o out")
    writing.write(output, written(mechanisms[0]), force)
    click.echo(str(output))
