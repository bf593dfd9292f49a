"""A straight line of a link, the path of a slide, the track of a wheel or the flat face of a cam follower; its sides.

On which side of a line a wheel or a profile lies where the file leaves `side` out is as the sketch has it, else left.
The sketch is rough and has not every point. What the file fixes exactly goes before it: fixed points, directions and
displacements that drivers and poses give, links that slide without turning.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from graphkin.errors import KeyClash, MissingKey, NeedsDirection, NoLine, NoMeaning, UnknownPoint
from graphkin.files.draft import Draft
from graphkin.files.schema import File, LineTable
from graphkin.model.mechanism import FRAME, Driver, KeyPath, Link, Pose
from graphkin.model.pairs import Cam, Line, Pair, RollingContact, Slide


def has_line(table: LineTable) -> bool:
    """True of a table that has any key of a line."""
    return any(value is not None for value in (table.through, table.toward, table.from_, table.angle))


def read_line(draft: Draft, table: LineTable, link: str, own_point: str, path: KeyPath) -> Line:
    """The line of `link`; one of the frame given by coordinates goes through a new point called `own_point`."""
    if link != FRAME and len(draft.links[link].points) == 1:
        # a link of one point is its own line; one that slides, and so cannot turn against its guide, may have another
        (point,) = draft.links[link].points
        if table.toward is not None:
            raise NoMeaning(draft.where(*path, "toward"), "toward", "own line")
        if table.through is not None:
            _point_of(draft, link, table.through, path)
        if table.from_ is None and table.angle is None:
            return Line(link, point, 1 + 0j)
        guide, along = _slid_along(draft, link)
        if guide is None:
            for key, value in (("from", table.from_), ("angle", table.angle)):
                if value:
                    raise NoMeaning(draft.where(*path, key), key, "own line")
            return Line(link, point, 1 + 0j)
        return Line(link, point, _turn(table.angle or 0.0) * _base(draft, table, guide, path) / along, base=table.from_)
    if table.through is None:
        raise MissingKey(draft.where(*path), "through")
    if link != FRAME or isinstance(table.through, str):
        origin = _point_of(draft, link, table.through, path)
    else:
        origin, draft.frame_points[own_point], draft.starts[own_point] = own_point, complex(*table.through), path
    base = (origin, table.toward) if table.toward is not None else table.from_
    return Line(link, origin, _direction(draft, table, link, origin, path), origin not in draft.starts, base)


def _slid_along(draft: Draft, link: str) -> tuple[str | None, complex]:
    """The guide of a link of one point, and the direction of sliding in the guide's axes, the link's own axis."""
    number, slide = next(((k, slide) for k, slide in enumerate(draft.slides) if slide.block == link), (0, None))
    if slide is None or slide.guide in (link, *draft.tracing):
        return None, 1 + 0j
    draft.tracing.append(link)
    try:
        guide = draft.link(slide.guide, "slide", number, "guide")
        return guide, read_line(draft, slide, guide, f"s{number}", ("slide", number)).direction
    finally:
        draft.tracing.pop()


def _base(draft: Draft, table: LineTable, guide: str, path: KeyPath) -> complex:
    """The direction from which the angle of such a line is measured, in the guide's axes: `from`, else +x."""
    if table.from_ is not None:
        tail, head = (draft.point(guide, point, *path, "from") for point in table.from_)
        return _arm(draft, guide, tail, head, (*path, "from"))
    if guide == FRAME:
        return 1 + 0j
    beyond, along = _slid_along(draft, guide) if len(draft.links[guide].points) == 1 else (None, 1 + 0j)
    if beyond is None:
        raise NeedsDirection(draft.where(*path), guide)
    return _base(draft, table, beyond, path) / along


def _point_of(draft: Draft, link: str, through: str | Sequence[float], path: KeyPath) -> str:
    if isinstance(through, str):
        return draft.point(link, through, *path, "through")
    raise UnknownPoint(draft.where(*path, "through"), "[x, y]", draft.named(link))


def _direction(draft: Draft, table: LineTable, link: str, origin: str, path: KeyPath) -> complex:
    """Unit vector in the link's axes."""
    if table.toward is not None:
        for key, value in (("from", table.from_), ("angle", table.angle)):
            if value is not None:
                raise KeyClash(draft.where(*path, key), "toward", key)
        return _arm(draft, link, origin, draft.point(link, table.toward, *path, "toward"), (*path, "toward"))
    turn = _turn(table.angle or 0.0)
    if table.from_ is not None:
        tail, head = (draft.point(link, point, *path, "from") for point in table.from_)
        return _arm(draft, link, tail, head, (*path, "from")) * turn
    if link != FRAME:
        raise NeedsDirection(draft.where(*path), link)
    return turn


def _arm(draft: Draft, link: str, tail: str, head: str, path: KeyPath) -> complex:
    arm = draft.links[link].arm(tail, head)
    if abs(arm) < 1e-12:
        raise NoLine(draft.where(*path), tail, head)
    return arm / abs(arm)


def _turn(angle: float) -> complex:
    """Along an angle; quarter turns exactly."""
    turn = cmath.rect(1, angle)
    return complex(*(0.0 if abs(part) < 1e-15 else part for part in (turn.real, turn.imag)))


Learnt = tuple[dict[str, complex], str, complex]
"""Directions of links or places of points, and what is to be put into them."""
Rule = Callable[[], Iterator[Learnt]]

_CLOSE = 1e-9  # a centre this near to the line [m] lies on neither side


def as_sketched(
    file: File, links: Mapping[str, Link], pairs: Sequence[Pair], held: Sequence[Driver | Pose],
    sketch: Mapping[str, complex],
) -> tuple[Pair, ...]:  # fmt: skip
    """The pairs, with the sides that the file leaves out; `held` are its drivers and poses."""
    rolls = [table.side is None for table in file.roll]
    faces = [[profile.side is None for profile in table.profiles] for table in file.cam]
    if not any(rolls) and not any(map(any, faces)):
        return tuple(pairs)
    layout = _RoughLayout(links, [pair for pair in pairs if isinstance(pair, Slide)], held, sketch)
    rolling, touching = iter(rolls), iter(faces)
    sided: list[Pair] = []
    for pair in pairs:
        if isinstance(pair, RollingContact) and next(rolling) and pair.line is not None:
            pair = replace(pair, left=layout.on_left(pair.line, pair.centre))
        elif isinstance(pair, Cam):
            profiles = zip(pair.profiles, pair.profiles[::-1], next(touching), strict=True)
            first, second = (replace(face, left=layout.on_left(face.line, other.centre))
                             if is_open and face.line is not None and other.centre is not None else face
                             for face, other, is_open in profiles)  # fmt: skip
            pair = replace(pair, profiles=(first, second))
        sided.append(pair)
    return tuple(sided)


class _RoughLayout:
    """Roughly where points are and how links are turned at the drawn position, as far as it can be said at once."""

    def __init__(
        self, links: Mapping[str, Link], slides: Sequence[Slide], held: Sequence[Driver | Pose],
        sketch: Mapping[str, complex],
    ) -> None:  # fmt: skip
        self.links, self.slides, self.held = links, slides, held
        self.turns: dict[str, complex] = {FRAME: 1 + 0j}
        self.places: dict[str, complex] = dict(links[FRAME].points)
        rules, more = [*self._exact()], ((self.places, point, place) for point, place in sketch.items())
        while True:  # what is exact comes first; then point by point what the sketch says
            while sum(self._learns(rule()) for rule in rules):
                pass  # until they all give nothing new
            news = next(filter(None, map(self._by_two_points, links.values())), None) or next(more, None)
            if news is None:
                return
            self._learns([news])

    def on_left(self, line: Line, centre: str) -> bool:
        """Left, where the sketch does not say otherwise."""
        if line.link not in self.turns or line.origin not in self.places or centre not in self.places:
            return True
        along = self.turns[line.link] * line.direction
        return ((self.places[centre] - self.places[line.origin]) / along).imag > -_CLOSE

    def _learns(self, news: Iterable[Learnt]) -> bool:
        """Note what is new; true where anything is."""
        new = False
        for table, name, value in news:
            if name not in table:
                table[name], new = value, True
        return new

    def _exact(self) -> Iterator[Rule]:
        """The rules in their order."""
        slides = {slide.name: slide for slide in self.slides}
        yield from (partial(self._driven, each) for each in self.held)
        yield from (partial(self._parallel, slide) for slide in self.slides)
        yield from (partial(self._rigid, link) for link in self.links.values())
        for each in self.held:
            if each.kind == "slide" and (moved := slides.get(each.link)) is not None:
                yield partial(self._displaced, each, moved)

    def _driven(self, each: Driver | Pose) -> Iterator[Learnt]:
        if each.kind != "angle" or each.vector is None or each.value is None or each.from_link not in self.turns:
            return
        base = self.turns[each.from_link]
        if each.from_vector is not None:
            base *= _unit(self.links[each.from_link].arm(*each.from_vector))
        turned = base * cmath.rect(1, each.value) / _unit(self.links[each.link].arm(*each.vector))
        yield self.turns, each.link, turned

    def _parallel(self, slide: Slide) -> Iterator[Learnt]:
        """A block does not turn against its guide."""
        if slide.block is None:
            return
        tilted = slide.line.direction * cmath.rect(1, slide.tilt)
        if slide.guide in self.turns:
            yield self.turns, slide.block, self.turns[slide.guide] * tilted
        if slide.block in self.turns:
            yield self.turns, slide.guide, self.turns[slide.block] / tilted

    def _rigid(self, link: Link) -> Iterator[Learnt]:
        """All points of a link whose direction and one of whose points are known."""
        base = next((point for point in link.points if point in self.places), None)
        if link.name in self.turns and base is not None:
            arms = ((point, link.arm(base, point)) for point in link.points)
            place, turn = self.places[base], self.turns[link.name]
            yield from ((self.places, point, place + turn * arm) for point, arm in arms)

    def _displaced(self, each: Driver | Pose, slide: Slide) -> Iterator[Learnt]:
        """The point of a slide whose displacement is given."""
        if each.value is not None and slide.guide in self.turns and slide.line.origin in self.places:
            along = self.turns[slide.guide] * slide.line.direction
            yield self.places, slide.point, self.places[slide.line.origin] + each.value * along

    def _by_two_points(self, link: Link) -> Learnt | None:
        """The direction of a link two of whose points are known."""
        known = [point for point in link.points if point in self.places]
        head = next((point for point in known[1:] if abs(link.arm(known[0], point)) > _CLOSE), None)
        if link.name in self.turns or head is None or self.places[head] == self.places[known[0]]:
            return None
        turned = (self.places[head] - self.places[known[0]]) / link.arm(known[0], head)
        return self.turns, link.name, _unit(turned)


def _unit(arm: complex) -> complex:
    return arm / abs(arm)
