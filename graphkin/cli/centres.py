"""`centres`: instant centres, found, drawn, explained, and what lies around them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from graphkin.base.value import frozen
from graphkin.cli import shared, streams
from graphkin.cli.shared import DriverOptions
from graphkin.cli.spoken import misused
from graphkin.errors import Lang

if TYPE_CHECKING:
    from graphkin.sheet import Sheet
    from graphkin.studies.centres import Centres
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
        misused("usage.needs", self.animate and not self.pair, option="--animate", other="--centrodes 3,1")
        misused("usage.either", not mechanisms, others="--velocities")
        misused("usage.one", draws and len(mechanisms) > 1, option="-o, --steps", what="MECHANISM")
        if draws:
            with streams.waiting():
                pages = self._pages(self._centres(mechanisms[0]))
            shared.write_drawings(pages, self.output, self.steps, self.force)
            return

        def answer(source: str) -> object:
            return self._answer(self._centres(source))

        shared.print_answers(mechanisms, answer, self.as_json, self.lang)

    def _centres(self, source: str) -> Centres:
        from graphkin.studies.centres import centres as find

        drawing = shared.drawing(shared.read(source), self.at)
        return find(drawing.method, drawing.plot)

    def _answer(self, found: Centres) -> object:
        """The centres, or what the options name around them."""
        from graphkin.api.answers import around

        return around(found, self.link, self.point, self.pair, self.centre, self.ranges)

    def _pole_of_two_velocities(self) -> None:
        from graphkin.outputs import svg
        from graphkin.say.centre_about import pole_words
        from graphkin.sheet.centrode_sheet import pole_sheet
        from graphkin.studies.centres.two_velocities import from_text

        misused("usage.without", self.steps, option="--velocities", others="--steps")
        pole = from_text(self.velocities)
        if self.output is None:
            click.echo("\n".join(pole_words(pole, self.lang)))
        else:
            page = svg.svg(pole_sheet(pole, self.lang, paper=self.paper))
            shared.write_drawings([(self.output, page)], self.output, None, self.force)

    def _pages(self, found: Centres) -> Pages:
        """The sheet, and one sheet a step."""
        from graphkin.outputs import svg
        from graphkin.studies.centres.centrodes import Centrodes

        answer = self._answer(found)
        drawn = self._rolling_sheets(answer) if isinstance(answer, Centrodes) else self._sheets(answer)
        whole, sheets, kind = drawn
        name = found.method.mechanism.name
        pages: Pages = []
        if self.output is not None:
            pages.append((self.output, whole if isinstance(whole, str) else svg.svg(whole)))
        if self.steps is not None:
            pages += [(self.steps / f"{name}-{kind}-{k:02d}.svg", svg.svg(page)) for k, page in enumerate(sheets, 1)]
        return pages

    def _sheets(self, answer: object) -> tuple[Sheet, Iterable[Sheet], str]:
        """The sheet of an answer, one for each step, and what they are called."""
        from graphkin.api.answers import sheet_of
        from graphkin.studies.centres import Centres
        from graphkin.studies.centres.about_bobillier import Bobillier

        whole = sheet_of(answer, self.lang, self.paper, **({"fit": self.fit} if isinstance(answer, Centres) else {}))
        if isinstance(answer, Centres):
            return whole, whole.step_sheets(range(1, len(answer.centring.stages) + 1)), "centres"
        if isinstance(answer, Bobillier):
            stages = range(1, len(answer.construction.stages) + 1)
            return whole, whole.step_sheets(stages), f"bobillier-{self.point}"
        return whole, (whole,), f"about-{self.link}"

    def _rolling_sheets(self, curves: Centrodes) -> tuple[Sheet | str, Iterable[Sheet], str]:
        """The sheet of centrodes, or the drawing that moves; frames."""
        from graphkin.outputs.animation import animation
        from graphkin.sheet.centrode_sheet import centrode_frames, centrode_sheet

        moving = self.animate or self.steps is not None
        frames = list(centrode_frames(curves, paper=self.paper, lang=self.lang)) if moving else []
        whole: Sheet | str = ""
        if self.output is not None:
            whole = animation(frames) if self.animate else centrode_sheet(curves, paper=self.paper, lang=self.lang)
        return whole, frames, "centrodes"
