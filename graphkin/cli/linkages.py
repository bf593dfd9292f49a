"""`linkage`: what a four-bar, slider-crank or guide-bar linkage is and does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.api.answers import from_lengths
from graphkin.api.answers import linkage as linkage_of
from graphkin.cli import shared
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.errors import Lang
from graphkin.model.mechanism import Mechanism

if TYPE_CHECKING:
    from graphkin.studies.linkages import Linkage

@click.command()
@click.argument("mechanisms", metavar="[MECHANISM...]", nargs=-1, shell_complete=shared.library_names)
@click.option("--fourbar", nargs=4, metavar="CRANK COUPLER ROCKER FRAME", help="A four-bar by its lengths, mm.")
@click.option("--slider", nargs=3, metavar="CRANK ROD OFFSET", help="A slider-crank by its lengths, mm.")
@click.option("--guide", nargs=3, metavar="CRANK FRAME OFFSET", help="A guide bar by its lengths, mm.")
@click.option("--driver", "by", default="crank", metavar="WORD",
              help="With lengths: driven at the crank, coupler, rocker, slider or bar.")
@click.option("--fix", default="", metavar="LINK", help="Print the mechanism with another link as frame, as TOML.")
@shared.svg_option("Draw the limits, as SVG.")
@shared.paper_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a linkage, metres and radians.")
@shared.force_option
@shared.driver_options
@shared.speaking
def linkage(
    mechanisms: tuple[str, ...], fourbar: tuple[str, ...], slider: tuple[str, ...], guide: tuple[str, ...], by: str,
    fix: str, output: Path | None, paper: str | None, as_json: bool, force: bool, at: DriverOptions, lang: Lang,
) -> None:  # fmt: skip
    """Tell a linkage's kind, limits, quick return, transmission angles and dead points, for each one in MECHANISM.

    \b
    Example:
      graphkin linkage s2-2 -o limits.svg
      graphkin linkage --fourbar 15 48 55 45
      graphkin linkage --slider 20 65 15 --json
      graphkin linkage ex3-5 --fix 2 > inverted.toml
    """
    given = [(kind, sizes) for kind, sizes in (("fourbar", fourbar), ("slider", slider), ("guide", guide)) if sizes]
    misused("usage.either", len(given) + bool(mechanisms) != 1, others="--fourbar, --slider, --guide")
    misused("usage.without", given and at, option="--fourbar, --slider, --guide", others="--angle, --at")
    misused("usage.one", len(mechanisms) > 1 and (fix or output), option="--fix, -o", what="MECHANISM")
    misused("usage.without", fix and (as_json or output), option="--fix", others="--json, -o")
    if output is None and mechanisms and not fix:
        shared.print_answers(mechanisms, lambda source: linkage_of(shared.read_at(source, at)), as_json, lang)
        return
    subject = shared.read_at(mechanisms[0], at) if mechanisms else from_lengths(*given[0], by)
    if fix:
        click.echo(_inverted(subject, fix, given[0][0] if given else ""), nl=False)
        return
    reports = linkage_of(subject)
    shared.print_answer(reports, as_json, lang)
    if output is not None:
        from graphkin.outputs.saving import NotebookSheet
        from graphkin.sheet.linkage_sheet import limit_sheet

        title = subject.headline(lang) if isinstance(subject, Mechanism) and mechanisms != ("-",) else ""
        sheet = NotebookSheet.of(limit_sheet(reports, lang, paper=paper, title=title))
        click.echo(str(sheet.save(output, force=force)), err=True)


def _inverted(subject: Mechanism | Linkage, link: str, kind: str) -> str:
    """The mechanism with another link as frame, as TOML; `kind`: the name of one that is given by its lengths."""
    from graphkin.say.linkages import held, titled

    if not isinstance(subject, Mechanism):
        subject = replace(titled(subject), name=kind, file=f"{kind}.toml")
    return held(subject, link).text
