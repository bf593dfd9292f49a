"""`centres`: instant centres, found, drawn, explained, and what lies around them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphkin.base.value import frozen
from graphkin.cli.shared import (
    PAPERS,
    angle_option,
    at_option,
    at_values,
    force_option,
    json_line,
    lang_option,
    library_names,
    ranges_option,
    read,
    said,
    svg_option,
    told_each,
)
from graphkin.errors import Lang, UnknownCentre, UnknownPoint, Where

if TYPE_CHECKING:
    from graphkin.sheet import Sheet
    from graphkin.studies.centres import Centres
    from graphkin.studies.centres.centrodes import Centrodes


@click.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, shell_complete=library_names)
@svg_option("SVG to write; - for stdout.", to_stdout=True)
@click.option("--steps", type=click.Path(path_type=Path, file_okay=False), help="One drawing a step, into this folder.")
@click.option("--about", "link", default="", metavar="LINK",
              help="A link about its pole: velocities, acceleration pole, inflection circle, curvature.")  # fmt: skip
@click.option("--bobillier", "point", default="", metavar="POINT",
              help="With --about: the centre of curvature of a point's path, by Bobillier's construction.")  # fmt: skip
@click.option("--centrodes", "pair", default="", metavar="LINK,LINK",
              help="The centrode of the first link rolling on that of the second; --steps: frames.")  # fmt: skip
@click.option("--path", "centre", default="", metavar="CENTRE", help="The path of a centre such as P13.")
@click.option("--velocities", default="", metavar="TEXT",
              help='The pole of two velocities: "A 0,0 1,0.5; B 100,0 1,-0.2" (mm, m/s).')  # fmt: skip
@click.option("--animate", is_flag=True, help="With --centrodes: one SVG that moves.")
@ranges_option
@click.option("--fit", is_flag=True, help="A smaller scale, so that centres far off come onto the sheet.")
@click.option("--paper", type=click.Choice(PAPERS), help="Paper; else the smallest that fits.")
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, metres and radians.")
@force_option
@angle_option
@at_option
@lang_option
def centres(mechanisms: tuple[str, ...], lang: Lang, **options: Any) -> None:
    """Find all instant centres, by definition and by Kennedy's lines: listed, explained, drawn.

    \b
    Example:
      graphkin centres fig3-4 -o centres.svg --lang zh
      graphkin centres ex3-7 --steps steps
      graphkin centres fig3-4 --about 3 -o coupler.svg
      graphkin centres fig3-6 --centrodes 3,1 -o rolling.svg --animate
      graphkin centres --json *.toml > centres.jsonl
    """
    asked = _Asked(lang=lang, **options)
    if asked.velocities:
        if asked.steps is not None:
            raise click.UsageError("--velocities draws one sheet: leave out --steps")
        with said(lang):
            _of_two_velocities(asked)
        return
    if asked.animate and not asked.pair:
        raise click.UsageError("--animate moves centrodes: --centrodes 3,1")
    if not mechanisms:
        raise click.UsageError("a MECHANISM is missing, or --velocities")
    if len(mechanisms) > 1 and asked.draws:
        raise click.UsageError("-o and --steps draw one mechanism")
    if asked.draws:
        with said(lang):
            _write(asked, mechanisms[0])
        return
    with said(lang):
        told_each(mechanisms, lambda source: _told(asked, source), asked.as_json, lang)


@frozen
class _Asked:
    """The options of the command."""

    output: Path | None
    steps: Path | None
    link: str
    point: str
    pair: str
    centre: str
    velocities: str
    animate: bool
    ranges: tuple[str, ...]
    fit: bool
    paper: str | None
    as_json: bool
    force: bool
    angles: tuple[float, ...]
    displacements: tuple[float, ...]
    lang: Lang

    @property
    def draws(self) -> bool:
        return self.output is not None or self.steps is not None

    def found(self, source: str) -> Centres:
        from graphkin import api
        from graphkin.studies.centres import centres as find

        method = api.plan(read(source))
        return find(method, api.Drawing.at(method, at_values(method, self.angles, self.displacements)).plot)

    def curves(self, found: Centres) -> Centrodes:
        """The centrodes, or the path of a centre, that is asked for."""
        from graphkin.studies import sweeps
        from graphkin.studies.centres.centrodes import centrodes, path, whole

        course = sweeps.course(found.method, self.ranges)
        sweeps.prove(course)
        span = None if self.ranges else whole(course)
        if self.centre:
            try:
                return path(found, self.centre, course, span)
            except UnknownCentre as error:
                raise error.at(Where("--path")) from None
        first, comma, second = self.pair.partition(",")
        if not comma:
            raise click.UsageError("--centrodes takes two links: --centrodes 3,1")
        return centrodes(found, first.strip(), second.strip(), course, span)


# --- words ------------------------------------------------------------------------------------


def _told(asked: _Asked, source: str) -> Iterator[str]:
    from graphkin.studies import centres as finding

    found = asked.found(source)
    if asked.link:
        yield from _about(asked, found)
    elif asked.pair or asked.centre:
        from graphkin.say.centre_curves import curve_lines
        from graphkin.studies.centres.about_data import centrodes_json

        curves = asked.curves(found)
        yield from [json_line(centrodes_json(curves))] if asked.as_json else curve_lines(curves, asked.lang)
    elif asked.as_json:
        yield json_line(finding.as_json(found))
    else:
        yield from _listed(asked, found)


def _listed(asked: _Asked, found: Centres) -> Iterator[str]:
    from graphkin.say.centre_explained import advantage_lines, explain_centres, rows
    from graphkin.say.text_table import table

    mechanism = found.method.mechanism
    yield "  ".join(dict.fromkeys((mechanism.name, mechanism.headline(asked.lang))))
    yield from table(list(rows(found, asked.lang)))
    yield ""
    yield from explain_centres(found, asked.lang)
    yield from advantage_lines(found, asked.lang)


def _about(asked: _Asked, found: Centres) -> Iterator[str]:
    from graphkin.say.centre_about import about_words, bobillier_words
    from graphkin.studies.centres.about import about
    from graphkin.studies.centres.about_bobillier import bobillier
    from graphkin.studies.centres.about_data import about_json

    seen = about(found, asked.link)
    if asked.as_json:
        yield json_line(about_json(seen))
        return
    yield from about_words(seen, asked.lang)
    if asked.point:
        yield ""
        yield from bobillier_words(bobillier(seen, _point(found, asked.point)), asked.lang)


def _point(found: Centres, name: str) -> str:
    points = found.method.mechanism.points
    if name not in points:
        raise UnknownPoint(Where("--bobillier"), name, points)
    return name


def _of_two_velocities(asked: _Asked) -> None:
    from graphkin.say.centre_about import pole_words
    from graphkin.studies.centres.two_velocities import from_text

    found = from_text(asked.velocities)
    if asked.output is None:
        click.echo("\n".join(pole_words(found, asked.lang)))
        return
    from graphkin.outputs import drawings, svg
    from graphkin.sheet.pole_sheet import pole_sheet

    text = svg.svg(pole_sheet(found, asked.lang, paper=asked.paper))
    if str(asked.output) == "-":
        click.echo(text, nl=False)
        return
    drawings.write(asked.output, text, asked.force)
    click.echo(str(asked.output))


# --- drawings ---------------------------------------------------------------------------------


def _write(asked: _Asked, source: str) -> None:
    """The sheet, and one sheet a step; all are made before the first is written."""
    from graphkin.outputs import drawings
    from graphkin.outputs.drawings import refuse_edited

    found = asked.found(source)
    pages = list(_pages(asked, found))
    if str(asked.output) == "-":
        click.echo(pages.pop(0)[1], nl=False)
    if asked.steps is not None:
        asked.steps.mkdir(parents=True, exist_ok=True)
    for path, _ in pages:
        drawings.refuse(path, asked.force)
    if asked.output is not None:
        refuse_edited(asked.output, asked.force)
    for path, text in pages:
        drawings.write(path, text, asked.force)
        click.echo(str(path), err=str(asked.output) == "-")


def _pages(asked: _Asked, found: Centres) -> Iterator[tuple[Path, str]]:
    from graphkin.outputs import svg

    if asked.pair or asked.centre:
        yield from _rolling(asked, found)
        return
    whole, steps, kind = _sheets(asked, found)
    if asked.output is not None:
        yield asked.output, svg.svg(whole)
    if asked.steps is not None:
        for k, page in enumerate(steps, 1):
            yield asked.steps / f"{found.method.mechanism.name}-{kind}-{k:02d}.svg", svg.svg(page)


def _sheets(asked: _Asked, found: Centres) -> tuple[Sheet, Iterator[Sheet], str]:
    """The sheet that is asked for, one for each step, and what they are called."""
    if not asked.link:
        from graphkin.sheet.centre_sheet import centre_sheet, centre_step_sheets

        whole = centre_sheet(found, paper=asked.paper, lang=asked.lang, fit=asked.fit)
        return whole, centre_step_sheets(found, paper=asked.paper, lang=asked.lang, fit=asked.fit), "centres"
    from graphkin.studies.centres.about import about

    seen = about(found, asked.link)
    if not asked.point:
        from graphkin.sheet.about_sheet import about_sheet

        sheet = about_sheet(seen, paper=asked.paper, lang=asked.lang)
        return sheet, iter((sheet,)), f"about-{asked.link}"
    from graphkin.sheet.about_bobillier_sheet import bobillier_sheet, bobillier_step_sheets
    from graphkin.studies.centres.about_bobillier import bobillier

    drawn = bobillier(seen, _point(found, asked.point))
    whole = bobillier_sheet(seen, drawn, paper=asked.paper, lang=asked.lang)
    return whole, bobillier_step_sheets(seen, drawn, paper=asked.paper, lang=asked.lang), f"bobillier-{asked.point}"


def _rolling(asked: _Asked, found: Centres) -> Iterator[tuple[Path, str]]:
    from graphkin.outputs import svg
    from graphkin.outputs.animation import animation
    from graphkin.sheet.centrode_frames import centrode_frames
    from graphkin.sheet.centrode_sheet import centrode_sheet

    curves = asked.curves(found)
    frames = list(centrode_frames(curves, paper=asked.paper, lang=asked.lang)) if asked.animate or asked.steps else []
    if asked.output is not None:
        still = svg.svg(centrode_sheet(curves, paper=asked.paper, lang=asked.lang)) if not asked.animate else ""
        yield asked.output, still or animation(frames)
    if asked.steps is not None:
        for k, frame in enumerate(frames, 1):
            yield asked.steps / f"{found.method.mechanism.name}-centrodes-{k:02d}.svg", svg.svg(frame)
