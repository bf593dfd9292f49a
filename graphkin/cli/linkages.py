"""`linkage`: what a four-bar, slider-crank or guide-bar linkage is and does."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from graphkin.cli.shared import (
    PAPERS,
    angle_option,
    at_option,
    force_option,
    json_line,
    lang_option,
    library_names,
    read_at,
    speaking,
    svg_option,
    told_each,
)
from graphkin.errors import GraphkinError, Lang, OutOfRange, Where

if TYPE_CHECKING:
    from graphkin.model.mechanism import Mechanism
    from graphkin.studies.linkages import Report

LEAST_PART = 1e-9
"""Beside the longest link, one shorter than this part of it is none."""


@click.command()
@click.argument("mechanisms", metavar="[MECHANISM...]", nargs=-1, shell_complete=library_names)
@click.option("--fourbar", nargs=4, metavar="CRANK COUPLER ROCKER FRAME", help="A four-bar by its lengths, mm.")
@click.option("--slider", nargs=3, metavar="CRANK ROD OFFSET", help="A slider-crank by its lengths, mm.")
@click.option("--guide", nargs=3, metavar="CRANK FRAME OFFSET", help="A guide bar by its lengths, mm.")
@click.option("--driver", "by", default="crank", metavar="WORD",
              help="With lengths: driven at the crank, coupler, rocker, slider or bar.")  # fmt: skip
@click.option("--fix", default="", metavar="LINK", help="Print the mechanism with another link as frame, as TOML.")
@svg_option("Draw the limits, as SVG.")
@click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object a linkage, metres and radians.")
@force_option
@angle_option
@at_option
@lang_option
@speaking
def linkage(
    mechanisms: tuple[str, ...], fourbar: tuple[str, ...], slider: tuple[str, ...], guide: tuple[str, ...], by: str,
    fix: str, output: Path | None, paper: str | None, as_json: bool, force: bool, angles: tuple[float, ...],
    displacements: tuple[float, ...], lang: Lang,
) -> None:  # fmt: skip
    """Tell a linkage's kind, limits, quick return, transmission angles and dead points, for each one in MECHANISM.

    \b
    Example:
      graphkin linkage s2-2 -o limits.svg
      graphkin linkage --fourbar 15 48 55 45
      graphkin linkage --slider 20 65 15 --json
      graphkin linkage ex3-5 --fix 2 > inverted.toml
    """
    given = {name: sizes for name, sizes in (("fourbar", fourbar), ("slider", slider), ("guide", guide)) if sizes}
    if len(given) + bool(mechanisms) != 1:
        raise click.UsageError("give a MECHANISM, or one of --fourbar, --slider, --guide")
    if given and (angles or displacements):
        raise click.UsageError("--angle and --at are for a MECHANISM")
    if len(mechanisms) > 1 and (fix or output is not None):
        raise click.UsageError("--fix and -o are for one MECHANISM")
    if fix and (as_json or output is not None):
        raise click.UsageError("--fix prints a mechanism as TOML; leave out --json and -o")
    def machine(source: str) -> Mechanism:
        return read_at(source, angles, displacements)

    if fix:
        click.echo(_held(machine(mechanisms[0]) if mechanisms else None, given, by, fix), nl=False)
        return
    if output is None and mechanisms:
        told_each(mechanisms, lambda source: _told(_of_mechanism(machine(source), lang), as_json), as_json, lang)
        return
    one = machine(mechanisms[0]) if mechanisms else None
    told = list(_of_lengths(given, by, lang) if one is None else _of_mechanism(one, lang))
    click.echo("\n".join(_told(told, as_json)))
    if output is not None:
        title = one.headline(lang) if one is not None and mechanisms != ("-",) else ""
        _draw(output, [report for report, _ in told], title, paper, force, lang)


def _told(found: Iterable[tuple[Report, list[str]]], as_json: bool) -> Iterator[str]:
    """Line by line, a blank one between two linkages."""
    from graphkin.studies.linkages import as_json as data

    for k, (report, lines) in enumerate(found):
        yield from [json_line(data(report))] if as_json else ([""] if k else []) + lines


def _of_lengths(given: dict[str, tuple[str, ...]], by: str, lang: Lang) -> Iterator[tuple[Report, list[str]]]:
    from graphkin.say.linkages import lines
    from graphkin.studies import linkages

    ((kind, sizes),) = given.items()
    report = linkages.report(linkages.from_lengths(kind, *_metres(kind, sizes), driver=by))
    yield report, list(lines(report, lang))


def _metres(kind: str, sizes: tuple[str, ...]) -> list[float]:
    from graphkin.cli.shared import plain
    from graphkin.files.values import read_quantity

    try:
        found = [read_quantity(plain(size), "length") for size in sizes]
        for size, text in zip(found, sizes, strict=True):
            if 0 < abs(size) < LEAST_PART * max(map(abs, found)):
                raise OutOfRange(Where(""), text)
    except GraphkinError as error:
        raise error.at(Where(f"--{kind}")) from None
    return found


def _of_mechanism(machine: Mechanism, lang: Lang) -> Iterator[tuple[Report, list[str]]]:
    from graphkin.say.linkages import found_lines
    from graphkin.studies import linkages

    for found in linkages.some_found_in(machine):
        report = linkages.reported(found)
        yield report, list(found_lines(found, report, lang))


def _held(mechanism: Mechanism | None, given: dict[str, tuple[str, ...]], by: str, link: str) -> str:
    """Another link as frame, as TOML."""
    from graphkin.say.linkages import held, titled
    from graphkin.studies.linkages import from_lengths

    if mechanism is not None:
        return held(mechanism, link).text
    ((kind, sizes),) = given.items()
    machine = titled(from_lengths(kind, *_metres(kind, sizes), driver=by))
    return held(replace(machine, name=kind, file=f"{kind}.toml"), link).text


def _draw(output: Path, reports: list[Report], title: str, paper: str | None, force: bool, lang: Lang) -> None:
    from graphkin.outputs import drawings, svg
    from graphkin.sheet.linkage_sheet import limit_sheet

    drawings.write(output, svg.svg(limit_sheet(reports, lang, paper=paper, title=title)), force)
    click.echo(str(output), err=True)
