"""`centres`: instant centres, found, drawn, explained, and what lies around them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphkin.base.value import frozen
from graphkin.cli import shared, streams
from graphkin.cli.shared import DriverOptions
from graphkin.errors import Lang, UnknownCentre, UnknownPoint, Where

if TYPE_CHECKING:
    from graphkin.sheet import Sheet
    from graphkin.studies.centres import Centres
    from graphkin.studies.centres.about import About
    from graphkin.studies.centres.about_bobillier import Bobillier
    from graphkin.studies.centres.centrodes import Centrodes

Pages = list[tuple[Path, bytes | str]]


@click.command()
@click.argument("mechanisms", metavar="MECHANISM...", nargs=-1, shell_complete=shared.library_names)
@shared.svg_option("SVG to write; - for stdout.", to_stdout=True)
@shared.steps_option
@click.option("--about", "link", default="", metavar="LINK",
              help="A link about its pole: velocities, acceleration pole, inflection circle, curvature.")
@click.option("--bobillier", "point", default="", metavar="POINT",
              help="With --about: the centre of curvature of a point's path, by Bobillier's construction.")
@click.option("--centrodes", "pair", default="", metavar="LINK,LINK",
              help="The centrode of the first link rolling on that of the second; --steps: frames.")
@click.option("--path", "centre", default="", metavar="CENTRE", help="The path of a centre such as P13.")
@click.option("--velocities", default="", metavar="TEXT",
              help='The pole of two velocities: "A 0,0 1,0.5; B 100,0 1,-0.2" (mm, m/s).')
@click.option("--animate", is_flag=True, help="With --centrodes: one SVG that moves.")
@shared.ranges_option
@click.option("--fit", is_flag=True, help="A smaller scale, so that centres far off come onto the sheet.")
@shared.paper_option
@click.option("--json", "as_json", is_flag=True, help="One JSON object a line, metres and radians.")
@shared.force_option
@shared.driver_options
@shared.speaking
def centres(mechanisms: tuple[str, ...], **options: Any) -> None:
    """Find all instant centres, by definition and by Kennedy's lines: listed, explained, drawn.

    \b
    Example:
      graphkin centres fig3-4 -o centres.svg --lang zh
      graphkin centres ex3-7 --steps steps
      graphkin centres fig3-4 --about 3 -o coupler.svg
      graphkin centres fig3-6 --centrodes 3,1 -o rolling.svg --animate
      graphkin centres --json *.toml > centres.jsonl
    """
    _CentreCommand(**options).run(mechanisms)


@frozen
class _CentreCommand:
    """The options of the command, and what is printed and drawn by them."""

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
    at: DriverOptions
    lang: Lang

    def run(self, mechanisms: tuple[str, ...]) -> None:
        draws = self.output is not None or self.steps is not None
        if self.velocities:
            self._pole_of_two_velocities()
            return
        if self.animate and not self.pair:
            raise click.UsageError("--animate moves centrodes: --centrodes 3,1")
        if not mechanisms:
            raise click.UsageError("a MECHANISM is missing, or --velocities")
        if len(mechanisms) > 1 and draws:
            raise click.UsageError("-o and --steps draw one mechanism")
        if draws:
            with streams.waiting():
                pages = self._pages(self._centres(mechanisms[0]))
            shared.write_drawings(pages, self.output, self.steps, self.force)
        else:
            shared.print_each(mechanisms, lambda source: self._lines(self._centres(source)), self.as_json, self.lang)

    def _centres(self, source: str) -> Centres:
        from graphkin.studies.centres import centres as find

        drawing = shared.drawing(shared.read(source), self.at)
        return find(drawing.method, drawing.plot)

    def _curves(self, found: Centres) -> Centrodes:
        """The centrodes, or the path of a centre, that the options name."""
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

    def _bobillier(self, found: Centres, pole: About) -> Bobillier:
        from graphkin.studies.centres.about_bobillier import bobillier

        points = found.method.mechanism.points
        if self.point not in points:
            raise UnknownPoint(Where("--bobillier"), self.point, points)
        return bobillier(pole, self.point)

    def _lines(self, found: Centres) -> Iterator[str]:
        """Of what the options name; a blank line between two answers, of which data have the first."""
        from graphkin.api.answers import data_of, lines_of

        answers = [self._curves(found)] if self.pair or self.centre else self._about(found) if self.link else [found]
        if self.as_json:
            yield shared.json_line(data_of(answers[0]))
            return
        for k, answer in enumerate(answers):
            yield from ([""] if k else []) + lines_of(answer, self.lang)

    def _about(self, found: Centres) -> list[object]:
        from graphkin.studies.centres.about import about

        pole = about(found, self.link)
        return [pole, self._bobillier(found, pole)] if self.point else [pole]

    def _pole_of_two_velocities(self) -> None:
        from graphkin.outputs import svg
        from graphkin.say.centre_about import pole_words
        from graphkin.sheet.centrode_sheet import pole_sheet
        from graphkin.studies.centres.two_velocities import from_text

        if self.steps is not None:
            raise click.UsageError("--velocities draws one sheet: leave out --steps")
        pole = from_text(self.velocities)
        if self.output is None:
            click.echo("\n".join(pole_words(pole, self.lang)))
        else:
            page = svg.svg(pole_sheet(pole, self.lang, paper=self.paper))
            shared.write_drawings([(self.output, page)], self.output, None, self.force)

    def _pages(self, found: Centres) -> Pages:
        """The sheet, and one sheet a step."""
        from graphkin.outputs import svg

        rolling = bool(self.pair or self.centre)
        whole, sheets, kind = self._rolling_sheets(found) if rolling else self._sheets(found)
        name = found.method.mechanism.name
        pages: Pages = []
        if self.output is not None:
            pages.append((self.output, whole if isinstance(whole, str) else svg.svg(whole)))
        if self.steps is not None:
            pages += [(self.steps / f"{name}-{kind}-{k:02d}.svg", svg.svg(page)) for k, page in enumerate(sheets, 1)]
        return pages

    def _sheets(self, found: Centres) -> tuple[Sheet, Iterable[Sheet], str]:
        """The sheet that the options name, one for each step, and what they are called."""
        from graphkin.api.answers import sheet_of
        from graphkin.sheet.about_sheet import bobillier_sheet
        from graphkin.sheet.page import step_sheets
        from graphkin.studies.centres.about import about

        if not self.link:
            whole = sheet_of(found, self.lang, self.paper, fit=self.fit)
            return whole, whole.step_sheets(range(1, len(found.centring.stages) + 1)), "centres"
        pole = about(found, self.link)
        if not self.point:
            whole = sheet_of(pole, self.lang, self.paper)
            return whole, (whole,), f"about-{self.link}"
        curvature = self._bobillier(found, pole)
        drawn = bobillier_sheet(pole, curvature, paper=self.paper, lang=self.lang)
        return drawn, step_sheets(drawn, range(1, len(curvature.construction.stages) + 1)), f"bobillier-{self.point}"

    def _rolling_sheets(self, found: Centres) -> tuple[Sheet | str, Iterable[Sheet], str]:
        """The same of centrodes: the sheet, or the drawing that moves."""
        from graphkin.outputs.animation import animation
        from graphkin.sheet.centrode_sheet import centrode_frames, centrode_sheet

        curves = self._curves(found)
        moving = self.animate or self.steps is not None
        frames = list(centrode_frames(curves, paper=self.paper, lang=self.lang)) if moving else []
        whole: Sheet | str = ""
        if self.output is not None:
            whole = animation(frames) if self.animate else centrode_sheet(curves, paper=self.paper, lang=self.lang)
        return whole, frames, "centrodes"
