"""On which side of a line a wheel or a profile lies where the file leaves `side` out: as the sketch has it, else left.

The sketch is rough and has not every point. What the file fixes exactly goes before it: fixed points, directions and
displacements that drivers and poses give, links that slide without turning.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial

from graphkin.base.worklist import Rounds, Waiting
from graphkin.files.schema import File
from graphkin.model.mechanism import FRAME, Driver, Link, Pose
from graphkin.model.pairs import Cam, Line, Pair, Profile, RollingContact, Slide

Found = tuple[dict[str, complex], str, complex]
"""Directions of links or places of points, and what is to be entered there."""
Rule = tuple[tuple[str | tuple[str], ...], Callable[[], Iterator[Found]]]

_CLOSE = 1e-9
"""A centre this near to the line [m] lies on neither side."""


def as_sketched(
    file: File,
    links: Mapping[str, Link],
    pairs: Sequence[Pair],
    given: Sequence[Driver | Pose],
    sketch: Mapping[str, complex],
) -> tuple[Pair, ...]:
    """The pairs, with the sides that the file leaves out."""
    rolls = [table.side is None for table in file.roll]
    faces = [[profile.side is None for profile in table.profiles] for table in file.cam]
    if not any(rolls) and not any(map(any, faces)):
        return tuple(pairs)
    seen = _Roughly(links, [pair for pair in pairs if isinstance(pair, Slide)], given, sketch)
    rolling, touching = iter(rolls), iter(faces)
    return tuple(
        _rolled(pair, seen) if isinstance(pair, RollingContact) and next(rolling)
        else _faced(pair, next(touching), seen) if isinstance(pair, Cam)
        else pair
        for pair in pairs
    )  # fmt: skip


def _rolled(roll: RollingContact, seen: _Roughly) -> RollingContact:
    return roll if roll.line is None else replace(roll, left=seen.on_left(roll.line, roll.centre))


def _faced(cam: Cam, sides: Sequence[bool], seen: _Roughly) -> Cam:
    first, second = (
        _turned(profile, other, seen) if is_open else profile
        for profile, other, is_open in zip(cam.profiles, cam.profiles[::-1], sides, strict=True)
    )
    return replace(cam, profiles=(first, second))


def _turned(face: Profile, other: Profile, seen: _Roughly) -> Profile:
    if face.line is None or other.centre is None:
        return face
    return replace(face, left=seen.on_left(face.line, other.centre))


class _Roughly:
    """Roughly where points are and how links are turned at the drawn position, as far as it can be told at once."""

    def __init__(
        self, links: Mapping[str, Link], slides: Sequence[Slide], given: Sequence[Driver | Pose],
        sketch: Mapping[str, complex],
    ) -> None:  # fmt: skip
        self.links, self.slides, self.given, self.sketch = links, slides, given, sketch
        self.turns: dict[str, complex] = {FRAME: 1 + 0j}
        self.places: dict[str, complex] = dict(links[FRAME].points)
        self.listed = [*links.values()]
        self.rules = Rounds(self._exact())
        self.open = Waiting(len(links))
        self._settle()

    def on_left(self, line: Line, centre: str) -> bool:
        """Left, where the sketch does not say otherwise."""
        if line.link not in self.turns or line.origin not in self.places or centre not in self.places:
            return True
        way = self.turns[line.link] * line.direction
        return ((self.places[centre] - self.places[line.origin]) / way).imag > -_CLOSE

    def _settle(self) -> None:
        """What is exact first; then point by point what the sketch says."""
        more = iter(self.sketch.items())
        while True:
            for rule in self.rules:
                self._learn(rule())
            turned = self.open.first(self._by_two_points)
            if turned is not None:
                self._learn([turned])
                continue
            point, place = next(more, ("", 0j))
            if not point:
                return
            self._learn([(self.places, point, place)])

    def _learn(self, found: Iterable[Found]) -> None:
        """What is new calls for the rules that may go on from it."""
        for known, name, value in found:
            if name not in known:
                known[name] = value
                self.rules.call(name if known is self.turns else (name,))
                if known is self.places:
                    self.open.call(self._links_at.get(name, ()))

    def _exact(self) -> Iterator[Rule]:
        """The rules in their order, each with the links whose direction and the points whose place it starts from."""
        slides = {slide.name: slide for slide in self.slides}
        for each in self.given:
            yield (each.from_link,), partial(self._driven, each)
        for slide in self.slides:
            yield (slide.guide, slide.block or ""), partial(self._parallel, slide)
        for link in self.listed:
            yield (link.name, *((point,) for point in link.points)), partial(self._rigid, link)
        for each in self.given:
            if each.kind == "slide" and (moved := slides.get(each.link)) is not None:
                yield (moved.guide, (moved.line.origin,)), partial(self._displaced, each, moved)

    @cached_property
    def _links_at(self) -> dict[str, list[int]]:
        """By point, the numbers of the links that have it."""
        found: dict[str, list[int]] = {}
        for k, link in enumerate(self.listed):
            for point in link.points:
                found.setdefault(point, []).append(k)
        return found

    def _driven(self, each: Driver | Pose) -> Iterator[Found]:
        if each.kind != "angle" or each.vector is None or each.value is None or each.from_link not in self.turns:
            return
        base = self.turns[each.from_link]
        if each.from_vector is not None:
            base *= _unit(self.links[each.from_link].arm(*each.from_vector))
        turned = base * cmath.rect(1, each.value) / _unit(self.links[each.link].arm(*each.vector))
        yield self.turns, each.link, turned

    def _parallel(self, slide: Slide) -> Iterator[Found]:
        """A block does not turn against its guide."""
        if slide.block is None:
            return
        way = slide.line.direction * cmath.rect(1, slide.tilt)
        if slide.guide in self.turns:
            yield self.turns, slide.block, self.turns[slide.guide] * way
        if slide.block in self.turns:
            yield self.turns, slide.guide, self.turns[slide.block] / way

    def _rigid(self, link: Link) -> Iterator[Found]:
        """All points of a link whose direction and one of whose points are known."""
        base = next((point for point in link.points if point in self.places), None)
        if link.name in self.turns and base is not None:
            arms = ((point, link.arm(base, point)) for point in link.points)
            place, turn = self.places[base], self.turns[link.name]
            yield from ((self.places, point, place + turn * arm) for point, arm in arms)

    def _displaced(self, each: Driver | Pose, slide: Slide) -> Iterator[Found]:
        """The point of a slide whose displacement is given."""
        if each.value is not None and slide.guide in self.turns and slide.line.origin in self.places:
            way = self.turns[slide.guide] * slide.line.direction
            yield self.places, slide.point, self.places[slide.line.origin] + each.value * way

    def _by_two_points(self, number: int) -> Found | None:
        """The direction of a link two of whose points are known."""
        link = self.listed[number]
        known = [point for point in link.points if point in self.places]
        head = next((point for point in known[1:] if abs(link.arm(known[0], point)) > _CLOSE), None)
        if link.name in self.turns or head is None or self.places[head] == self.places[known[0]]:
            return None
        turned = (self.places[head] - self.places[known[0]]) / link.arm(known[0], head)
        return self.turns, link.name, _unit(turned)


def _unit(arm: complex) -> complex:
    return arm / abs(arm)
