"""A mechanism before any sign is drawn: its points and lines on paper."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from functools import cache, cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

from graphkin.base.geometry import number, place
from graphkin.base.lines import lines_through, off_stretch
from graphkin.base.value import frozen
from graphkin.construction import Plot
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.pairs import Line, Slide
from graphkin.sheet.marks import Place
from graphkin.sheet.window import Window

if TYPE_CHECKING:
    from graphkin.studies.linkages.assembled import Placement

OVERRUN = 9.0  # how far a bar goes on beyond its block [mm]


@frozen
class Skeleton:
    """A mechanism at one position, through a window; born: the step in which each of its points is found."""

    mechanism: Mechanism
    plot: Plot | Placement
    window: Window
    born: Mapping[str, int]

    def at(self, point: str) -> Place:
        """A point on paper; one of the frame has its place even where the position does not name it."""
        if point in self.plot.position:
            return self.window(place(self.plot.position[point]))
        return self.window(self.mechanism.links[FRAME].points[point])

    def step(self, *points: str) -> int | None:
        """The step by which all these points are there."""
        return max((self.born[p] for p in points if p in self.born), default=None)

    def named(self, link: str) -> tuple[str, ...]:
        """The points of a link that people named, and that are drawn."""
        fixed = self.mechanism.links[FRAME].points
        return tuple(p for p in self.mechanism.named(link) if p in self.plot.position or p in fixed)

    @cached_property
    def points(self) -> tuple[str, ...]:
        return tuple(p for p in self.mechanism.points if p in self.plot.position)

    @cached_property
    def joints(self) -> list[tuple[Place, int | None, set[str]]]:
        """The places of points, the steps that draw them, and the links that they are on or slide along."""
        owners, slides = self.mechanism.owners, self.mechanism.slides
        links = {p: {*owners[p], *(slide.guide for slide in slides if slide.point == p)} for p in self.points}
        return [(self.at(point), self.step(point), on) for point, on in links.items()]

    @cached_property
    def blocks(self) -> dict[str, Slide]:
        """The slide each sliding block belongs to: the first, for a block on two guides."""
        return {slide.block: slide for slide in reversed(self.mechanism.slides) if slide.block is not None}

    def guides(self, link: str) -> Iterator[Slide]:
        return (slide for slide in self.mechanism.slides if slide.guide == link)

    def direction(self, line: Line) -> complex:
        """Direction of any line of a link on paper."""
        return self.window.turned(line.direction * cmath.rect(1, number(self.plot.theta.get(line.link, 0.0))))

    def is_cylinder(self, slide: Slide) -> bool:
        """A moving guide of one point that is its own line, with a block for its piston; a pin runs in a slot."""
        alone = slide.guide != FRAME and len(self.mechanism.links[slide.guide].points) == 1
        return alone and slide.line.on_axis and slide.block is not None

    def guide_bar(self, slide: Slide) -> tuple[Place, Place]:
        """A moving guide's line as far as it is drawn: past its points and past the block."""
        along, foot = self.direction(slide.line), self.at(slide.line.origin)
        stops = [(along.conjugate() * (self.at(p) - foot)).real for p in self.on_line(slide)]
        t = (along.conjugate() * (self.at(slide.point) - foot)).real
        low, high = min(0.0, *stops, t - OVERRUN), max(0.0, *stops, t + OVERRUN)
        return foot + along * low, foot + along * high

    def on_line(self, slide: Slide) -> list[str]:
        along, foot = self.direction(slide.line), self.at(slide.line.origin)
        return [p for p in self.named(slide.guide) if abs((along.conjugate() * (self.at(p) - foot)).imag) < 0.05]

    @cached_property
    def circles(self) -> list[tuple[Place, float]]:
        """Centre and radius of every circle on paper: of wheels and of cams [mm]."""
        every = sorted({circle[1:] for pair in self.mechanism.pairs for circle in pair.circles})
        return [(self.at(centre), radius / self.window.scale) for centre, radius in every if radius > 0]

    @cached_property
    def segments(self) -> list[tuple[Place, Place]]:
        return [bar for link in self.mechanism.moving for bar in self.bars(link)]

    def bars(self, link: str) -> Iterator[tuple[Place, Place]]:
        """Stretches between any two of its points, and along its guides."""
        places = [self.at(p) for p in self.named(link)]
        yield from ((a, b) for k, a in enumerate(places) for b in places[:k])
        yield from self._guide_bars(link)

    @cached_property
    def drawn(self) -> list[tuple[Place, Place]]:
        """Those of all links that are drawn."""
        drawn = [bar for link in self.mechanism.moving for bar in self._guide_bars(link)]
        for places in ([self.at(p) for p in self.named(link)] for link in self.mechanism.moving):
            for through, closed in lines_through(places) if len(places) > 1 else ():
                drawn += pairwise([places[k] for k in (*through, *through[:closed])])
        return drawn

    def _guide_bars(self, link: str) -> Iterator[tuple[Place, Place]]:
        for slide in self.guides(link):
            cylinder = self.is_cylinder(slide)
            yield (self.at(slide.line.origin), self.at(slide.point)) if cylinder else self.guide_bar(slide)

    @cached_property
    def directions(self) -> Callable[[str], tuple[complex, ...]]:
        """Directions in which lines leave a point, on paper."""
        return cache(lambda point: tuple(self._directions(point)))

    def _directions(self, point: str) -> Iterator[complex]:
        here = self.at(point)
        for link in self.mechanism.owners[point]:
            if link == FRAME:
                continue
            others = [end for bar in self.bars(link) if off_stretch(here, *bar) < 0.1 for end in bar]
            if (slide_of := self.blocks.get(link)) is not None and slide_of.point == point:
                others += (here + side * self.direction(slide_of.line) for side in (1, -1))
            yield from ((p - here) / abs(p - here) for p in others if abs(p - here) > 0.5)
