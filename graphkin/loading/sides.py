"""On which side of a line a wheel or a profile lies where the file leaves `side` out: as the sketch has it, else left.

The sketch is rough and has not every point. What the file fixes exactly goes before it: fixed points, directions and
displacements that drivers and poses give, links that slide without turning.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from graphkin.loading.schema import File
from graphkin.mechanism import FRAME, Driver, Link, Pose
from graphkin.pairs import Cam, Line, Pair, Profile, Roll, Slide

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
        _rolled(pair, seen) if isinstance(pair, Roll) and next(rolling)
        else _faced(pair, next(touching), seen) if isinstance(pair, Cam)
        else pair
        for pair in pairs
    )  # fmt: skip


def _rolled(roll: Roll, seen: _Roughly) -> Roll:
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
            while self._learnt(self._exact()):
                pass
            if self._learnt(self._by_two_points()):
                continue
            point, place = next(more, ("", 0j))
            if not point:
                return
            self.places.setdefault(point, place)

    def _learnt(self, found: Iterable[tuple[dict[str, complex], str, complex]]) -> bool:
        """Whether something new is among what was found."""
        before = len(self.turns) + len(self.places)
        for known, name, value in found:
            known.setdefault(name, value)
        return len(self.turns) + len(self.places) > before

    def _exact(self) -> Iterator[tuple[dict[str, complex], str, complex]]:
        yield from ((self.turns, *found) for each in self.given for found in self._driven(each))
        yield from ((self.turns, *found) for slide in self.slides for found in self._parallel(slide))
        yield from ((self.places, *found) for found in self._rigid())
        yield from ((self.places, *found) for each in self.given for found in self._displaced(each))

    def _driven(self, each: Driver | Pose) -> Iterator[tuple[str, complex]]:
        if each.kind != "angle" or each.vector is None or each.value is None or each.from_link not in self.turns:
            return
        base = self.turns[each.from_link]
        if each.from_vector is not None:
            base *= _unit(self.links[each.from_link].arm(*each.from_vector))
        yield each.link, base * cmath.rect(1, each.value) / _unit(self.links[each.link].arm(*each.vector))

    def _parallel(self, slide: Slide) -> Iterator[tuple[str, complex]]:
        """A block does not turn against its guide."""
        if slide.block is None:
            return
        way = slide.line.direction * cmath.rect(1, slide.tilt)
        if slide.guide in self.turns:
            yield slide.block, self.turns[slide.guide] * way
        if slide.block in self.turns:
            yield slide.guide, self.turns[slide.block] / way

    def _rigid(self) -> Iterator[tuple[str, complex]]:
        """All points of a link whose direction and one of whose points are known."""
        for name, link in self.links.items():
            base = next((point for point in link.points if point in self.places), None)
            if name in self.turns and base is not None:
                arms = ((point, link.arm(base, point)) for point in link.points)
                yield from ((point, self.places[base] + self.turns[name] * arm) for point, arm in arms)

    def _displaced(self, each: Driver | Pose) -> Iterator[tuple[str, complex]]:
        """The point of a slide whose displacement is given."""
        for slide in self.slides:
            known = slide.guide in self.turns and slide.line.origin in self.places
            if each.kind == "slide" and each.link == slide.name and each.value is not None and known:
                way = self.turns[slide.guide] * slide.line.direction
                yield slide.point, self.places[slide.line.origin] + each.value * way

    def _by_two_points(self) -> Iterator[tuple[dict[str, complex], str, complex]]:
        """The direction of the first link two of whose points are known."""
        for name, link in self.links.items():
            known = [point for point in link.points if point in self.places]
            head = next((point for point in known[1:] if abs(link.arm(known[0], point)) > _CLOSE), None)
            if name not in self.turns and head is not None and self.places[head] != self.places[known[0]]:
                turned = (self.places[head] - self.places[known[0]]) / link.arm(known[0], head)
                yield self.turns, name, _unit(turned)
                return


def _unit(arm: complex) -> complex:
    return arm / abs(arm)
