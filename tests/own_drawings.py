"""Every kind of drawing that the commands write, of any mechanism, as the text of its file; `draw` chooses its paper,
others are given theirs."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

from reading_back import PAPER
from si_values import si

from graphkin import Drawing
from graphkin.errors import GraphkinError
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.outputs.animation import animation
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet import finding_sheet
from graphkin.sheet.about_sheet import about_sheet, bobillier_sheet
from graphkin.sheet.centre_sheet import centre_sheet
from graphkin.sheet.centrode_sheet import centrode_frames, centrode_sheet
from graphkin.sheet.linkage_sheet import limit_sheet
from graphkin.sheet.motion_frames import motion_frames
from graphkin.sheet.page import step_sheets
from graphkin.studies import sweeps
from graphkin.studies.centres import Centres, centres
from graphkin.studies.centres.about import about
from graphkin.studies.centres.about_bobillier import bobillier
from graphkin.studies.centres.centrodes import centrodes, path, whole
from graphkin.studies.finding import find
from graphkin.studies.linkages import reported, some_found_in


@dataclass
class Of:
    """A mechanism, and what options are drawn by lot from."""

    mechanism: Mechanism
    rng: random.Random

    @property
    def lang(self) -> str:
        return self.rng.choice(("en", "zh"))

    def links(self, count: int) -> list[str]:
        return self.rng.sample(list(self.mechanism.links), count)

    @cached_property
    def drawing(self) -> Drawing:
        return Drawing.of(self.mechanism)

    @cached_property
    def centres(self) -> Centres:
        method = plan(self.mechanism)
        return centres(method, replay_all(method))


def draw(of: Of) -> Iterator[str]:
    rng = of.rng
    only = rng.choice((None, None, "position", "velocity", "acceleration"))
    style, tight, ink = rng.choice(("construction", "result")), rng.random() < 0.3, rng.choice(("accent", "black"))
    yield svg(of.drawing.sheet(lang=of.lang, only=only, style=style, tight=tight), ink)


def given(of: Of) -> Iterator[str]:
    yield svg(of.drawing.sheet(lang=of.lang, style="given", paper=PAPER))


def elsewhere(of: Of) -> Iterator[str]:
    values = [float(value) + of.rng.uniform(-0.2, 0.2) * (1 if driver.kind == "angle" else 0.05)
              for driver, value in zip(of.mechanism.drivers, of.drawing.plot.facts.values, strict=True)]  # fmt: skip
    yield svg(Drawing.of(of.mechanism, si(of.mechanism, values)).sheet(lang=of.lang, paper=PAPER))


def steps(of: Of) -> Iterator[str]:
    pages = list(of.drawing.step_sheets(lang=of.lang, tight=of.rng.random() < 0.2, paper=PAPER))
    yield from map(svg, of.rng.sample(pages, min(4, len(pages))))


def by_centre(of: Of) -> Iterator[str]:
    yield svg(Drawing.of(plan(of.mechanism, "", True)).sheet(lang=of.lang, paper=PAPER))


def coincident(of: Of) -> Iterator[str]:
    yield svg(Drawing.of(plan(of.mechanism, of.rng.choice(of.mechanism.points))).sheet(lang=of.lang, paper=PAPER))


def paths(of: Of) -> Iterator[str]:
    moving = [point for point in of.mechanism.points if FRAME not in of.mechanism.owners[point]]
    arrows, only = of.rng.random() < 0.5, of.rng.choice((None, "position"))
    yield svg(of.drawing.sheet(lang=of.lang, only=only, paths=[of.rng.choice(moving)], arrows=arrows, paper=PAPER))


def moving(of: Of) -> Iterator[str]:
    yield animation(motion_frames(plan(of.mechanism), 6, lang=of.lang))


def linkage(of: Of) -> Iterator[str]:
    if reports := [reported(found) for found in some_found_in(of.mechanism)]:
        yield svg(limit_sheet(reports, of.lang, title=of.mechanism.headline(of.lang)))


def all_centres(of: Of) -> Iterator[str]:
    yield svg(centre_sheet(of.centres, lang=of.lang, fit=of.rng.random() < 0.3))
    pages = list(step_sheets(centre_sheet(of.centres, lang=of.lang), range(1, len(of.centres.centring.stages) + 1)))
    yield svg(of.rng.choice(pages))


def one_link(of: Of) -> Iterator[str]:
    seen = about(of.centres, of.rng.choice(list(of.mechanism.moving)))
    yield svg(about_sheet(seen, lang=of.lang))
    drawn = bobillier(seen, of.rng.choice(of.mechanism.points))
    whole = bobillier_sheet(drawn, lang=of.lang)
    yield svg(whole)
    yield svg(of.rng.choice(list(step_sheets(whole, range(1, len(drawn.construction.stages) + 1)))))


def curves(of: Of) -> Iterator[str]:
    course = sweeps.course(plan(of.mechanism))
    if of.rng.random() < 0.5:
        found = path(of.centres, of.rng.choice(of.centres.names), course, whole(course))
    else:
        found = centrodes(of.centres, *of.links(2), course, whole(course))
    yield svg(centrode_sheet(found, lang=of.lang))
    frames = list(centrode_frames(found, lang=of.lang))
    yield svg(of.rng.choice(frames))
    yield animation(frames)


def finding(of: Of) -> Iterator[str]:
    method, link = plan(of.mechanism), of.rng.choice(list(of.mechanism.moving))
    condition = of.rng.choice((f"max omega {link}", f"min omega {link}", f"omega {link} = 0", f"theta {link} = 30"))
    if (drawn := finding_sheet.drawn(find(method, condition), of.lang))[0] is not None:
        yield svg(drawn[0])


COMMANDS: tuple[Callable[[Of], Iterator[str]], ...] = (
    draw, given, elsewhere, steps, by_centre, coincident, paths, moving, linkage, all_centres, one_link, curves,
    finding,
)  # fmt: skip


def drawings(mechanism: Mechanism, command: Callable[[Of], Iterator[str]], seed: object) -> Iterator[str]:
    """As many as there are before something cannot be drawn."""
    try:
        yield from command(Of(mechanism, random.Random(f"{command.__name__} {seed}")))
    except GraphkinError:
        return
