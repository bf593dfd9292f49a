"""The mechanism drawn to scale: its signs and its letters."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, pairwise, product
from typing import Any

from graphkin.base.geometry import place
from graphkin.base.lines import crossing, hull, in_line, leaves, lines_through, off_stretch
from graphkin.construction import Plot
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam, CircularSlot, Pair, RollingContact, Slide
from graphkin.planning import Method
from graphkin.planning.method import births
from graphkin.sheet import symbols, wheels
from graphkin.sheet.added_points import asked_centres, contacts, named_specials, specials
from graphkin.sheet.fixed_link import clearance, drives, grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import link_label, point_label
from graphkin.sheet.marks import BREAK, Disc, Fill, Mark, Place, PointMark, Shows, Stroke
from graphkin.sheet.paper import PenName
from graphkin.sheet.skeleton import Skeleton
from graphkin.sheet.window import Figure, Window

_ASIDE = 7.0  # so far from a joint of others a number is its own link's [mm]
_SEEN = symbols.BLOCK.real / 2 + symbols.SQUARE  # a line that goes on so far, past a block and a square, is seen [mm]
_JOINED = 4.8  # lines that cross so near to a joint meet there: a break would leave a crumb [mm]
Signs = Mapping[type[Pair], Callable[[Skeleton, Any], Iterable[Mark]]]


def mechanism_figure(
    skeleton: Skeleton, method: Method, drawn: list[complex] | None = None, ground: Figure | None = None,
    driving: Figure | None = None, bare: bool = False,
) -> Figure:  # fmt: skip
    """Wheels and ground first, then links, blocks over their guides, hinges over links, arrows last.

    drawn    the places that the figure has room for [m]; without them there are no special points
    ground   what stands still, where it is one of several positions
    driving  the drivers' arrows, where others have them, too
    bare     without lower-pair equivalents, which a solution finds
    """
    special = Figure()
    if drawn is not None:
        special = Figure.of([*specials(method, skeleton, drawn), *asked_centres(method, skeleton, drawn)])
    ground, driving, bodies = ground or grounds(skeleton), driving or drives(skeleton, method), _bodies(skeleton)
    turning, touching = Figure.of(wheels.wheels(skeleton)), Figure.of(contacts(method, skeleton))
    dashed = Figure.of(() if bare else wheels.equivalents(skeleton))
    marks = [*special.marks, *turning.marks, *ground.marks, *bodies.marks, *_hinges(skeleton), *touching.marks,
             *_through_bars(skeleton), *dashed.marks, *driving.marks]  # fmt: skip
    labels = bodies.wanted
    for point in skeleton.points:  # letters of points; those at one place share a label
        away, step = -sum(skeleton.directions(point), 0j), skeleton.step(point)
        labels.append(LabelRequest(point_label(point), skeleton.at(point), gap=symbols.HINGE, away=away, step=step))
    for part in (driving, ground, turning, special, touching, dashed):
        labels += part.wanted
    return Figure(marks, labels)


def moving_links(skeleton: Skeleton) -> list[Mark]:
    """Links, blocks and hinges alone."""
    return [*_bodies(skeleton).marks, *_hinges(skeleton)]


def _bodies(skeleton: Skeleton) -> Figure:
    """Links with their numbers, cams, and blocks over their guides."""
    figure = Figure(_signs(skeleton, BEFORE_LINKS))
    for link in skeleton.mechanism.moving:
        names = skeleton.named(link)
        places, step = [skeleton.at(p) for p in names], skeleton.step(*names)
        for slide in skeleton.guides(link):
            figure.marks += _guide(skeleton, slide)
        if centre := wheels.disc(skeleton, link):  # from its centre a bar to each further joint, else a thin radius
            for ends in ((centre, name) for name in names if name != centre):
                pen: PenName = "visible" if all(len(skeleton.mechanism.owners[point]) > 1 for point in ends) else "thin"
                shows, radius = Shows(link, "bar", ends), (skeleton.at(ends[0]), skeleton.at(ends[1]))
                figure.marks.append(Stroke(radius, pen, shows=shows, step=step))
        elif len(names) > 1:
            figure.marks += _body(names, places, link, step)
        figure.wanted += _link_number(skeleton, link, places, step)
    return Figure([*_broken(skeleton, figure.marks)][::-1] + _signs(skeleton, OVER_LINKS), figure.wanted)


def _broken(skeleton: Skeleton, marks: Sequence[Mark]) -> Iterator[Mark]:
    """Bars and guides, last ones first, broken where others that are not joined to them go over, and about hinges."""
    racks = [(roll.track, gap) for roll in skeleton.mechanism.of(RollingContact)
             if (gap := wheels.toothed(skeleton, roll))]  # fmt: skip
    bars = {id(mark): mark for mark in reversed(marks) if isinstance(mark, Stroke) and mark.shows is not None
            and mark.shows.form in ("bar", "guide")}  # fmt: skip
    gaps = _gaps(skeleton, [*bars.values()])
    for mark in reversed(marks):
        if (bar := bars.get(id(mark))) is None:
            yield mark
            continue
        of, sides = _links(bar), [*pairwise(bar.outline)]
        hinges = [joint for joint in skeleton.joints if len(joint[2]) > 1 and not joint[2] & of]
        about = [(spot, step, half) for at, step, _ in hinges for side in sides for spot, half in _around(at, *side)]
        broken = replace(bar, breaks=(*gaps[id(bar)], *about))
        teeth = [gap for link, gap in racks if link in of and off_stretch(gap[0], *sides[0]) < 0.05]
        yield from wheels.rack_line(broken, *teeth[0]) if teeth and len(bar.places) == 2 else (broken,)  # no outline


def _gaps(skeleton: Skeleton, bars: Sequence[Stroke]) -> dict[int, list[tuple[Place, int | None, float]]]:
    """The breaks of each bar (by identity) where another goes over it: the first of two, unless that leaves a crumb."""
    gaps = {id(bar): list[tuple[Place, int | None, float]]() for bar in bars}
    crossed = {id(bar): list[Place]() for bar in bars}
    turned = list[tuple[Place, Stroke, Stroke]]()
    for over, under in combinations(bars, 2):
        one, other = _links(over), _links(under)
        joined = [at for at, _, links in skeleton.joints if links & one and links & other]
        for side, end in product(pairwise(over.outline), pairwise(under.outline)) if not one & other else ():
            at = crossing(*end, *side)
            if at is None or any(abs(at - joint) <= _JOINED for joint in joined):
                continue
            crossed[id(over)].append(at)
            if min(abs(at - place) for place in end) >= _JOINED:
                gaps[id(under)].append((at, over.step, BREAK / 2))
            elif min(abs(at - place) for place in side) >= _JOINED:
                turned.append((at, over, under))
    for at, bar, above in turned:
        if sum(abs(at - other) < 2 * BREAK for other in crossed[id(bar)]) == 1:
            gaps[id(bar)].append((at, above.step, BREAK / 2))
    return gaps


def _links(bar: Stroke) -> set[str]:
    """The links that a bar shows."""
    assert bar.shows is not None
    return {bar.shows.link, bar.shows.line} - {""}


def _around(hinge: Place, start: Place, end: Place) -> list[tuple[Place, float]]:
    """The gaps of a bar on both sides of a hinge on or beside it, with the half of their length [mm]."""
    along = (end - start) / abs(end - start) if start != end else 1
    off = (hinge - start) / along
    if off_stretch(hinge, start, end) > symbols.HINGE + 0.5:
        return []
    half, foot = math.sqrt(max(0.0, symbols.HINGE**2 - off.imag**2)), start + off.real * along
    sides = [foot + sign * (half + BREAK / 4) * along for sign in (1, -1)]
    return [(side, BREAK / 4) for side in sides] if half > BREAK / 4 else [(foot, BREAK / 2)]


def _signs(skeleton: Skeleton, signs: Signs) -> list[Mark]:
    pairs = ((sign, pair) for kind, sign in signs.items() for pair in skeleton.mechanism.of(kind))
    return [mark for sign, pair in pairs for mark in sign(skeleton, pair)]


def _body(names: tuple[str, ...], places: list[Place], link: str, step: int | None) -> Iterator[Mark]:
    """A bar, or the outline of three and more points; thin lines go to points inside it, which are no bars."""
    lines = [*lines_through(places)]
    inner: PenName = "thin" if any(closed for _, closed in lines) else "visible"
    for through, closed in lines:
        corners, shows = tuple(places[k] for k in through), Shows(link, "bar", tuple(names[k] for k in through))
        yield Stroke(corners, "outline" if closed else inner, closed, "tint" if closed else "none", shows, step)


def _guide(skeleton: Skeleton, slide: Slide) -> list[Mark]:
    """A moving guide's own bar, welded to the rest of its link."""
    origin, step = slide.line.origin, skeleton.step(slide.line.origin, slide.point)
    if skeleton.is_cylinder(slide):
        assert slide.block is not None, slide
        foot, tube = (Shows(slide.guide, "guide", points, slide.name) for points in ((origin,), ()))
        rod = Shows(slide.block, "guide", (slide.point,), slide.name)  # it ends at the point that slides
        return symbols.cylinder(skeleton.at(origin), skeleton.at(slide.point), (foot, tube, rod), step)
    start, end = skeleton.guide_bar(slide)
    shows = Shows(slide.guide, "guide", (origin, slide.point), slide.name)
    marks: list[Mark] = [Stroke((start, end), "visible", shows=shows, step=step)]
    if slide.line.named and len(skeleton.on_line(slide)) < len(skeleton.named(slide.guide)):  # the guide is a bar apart
        at = skeleton.at(origin)
        far = max((start, end), key=lambda p: abs(p - at))
        for other in [skeleton.at(p) for p in skeleton.named(slide.guide) if p != origin][:1]:
            marks += symbols.weld(at, far, other, step)
    return marks


def _sliding(skeleton: Skeleton, slide: Slide) -> list[Mark]:
    at, along = skeleton.at(slide.point), skeleton.direction(slide.line)
    step = skeleton.step(slide.point, slide.line.origin)
    if (rod := wheels.follower(skeleton, slide)) is not None:
        return [*rod, *_square(skeleton, slide, rod[0].places[1] - rod[0].places[0])]
    if skeleton.is_cylinder(slide) or (slide.block is None and slide.guide == FRAME):
        return []
    if slide.block is not None:
        shows = Shows(slide.block, "block", (slide.point,), slide.name)
        corners = symbols.block_corners(at, along)
        block = Stroke(corners, "outline", closed=True, fill="paper", shows=shows, step=step)
        return [block, *_square(skeleton, slide, along, -along, block=True)]
    reach = min(9.0, max(4.0, abs(at - skeleton.at(slide.line.origin)) - 3.0))
    shows = Shows(slide.guide, "slot", (slide.point,), slide.name)
    rims = {way: symbols.SLOT / max(0.2, abs((way / along).imag)) for way in skeleton.directions(slide.point)}
    bars = [Stroke((at, at + rim * way), "visible", step=step) for way, rim in rims.items()]  # they go on to the pin
    return [*symbols.slot((at - reach * along, at + 9.0 * along), shows, step), *bars]


def _square(skeleton: Skeleton, slide: Slide, *guide: complex, block: bool = False) -> list[Stroke]:
    """The right angle between the ways of a guide and a line of its block, where the file says that there is one: where
    a line that is drawn leaves the block, if no other block is there; about two that lie across each other."""
    if abs(math.cos(slide.tilt)) > 1e-9 or (*skeleton.mechanism.path(slide), "tilt") not in skeleton.mechanism.given:
        return []
    at, ways, step = skeleton.at(slide.point), [way / abs(way) for way in guide], skeleton.step(slide.point)
    lines = [line for line in skeleton.directions(slide.point) if abs((line / ways[0]).real) < 1e-6]
    reach = {line: max((((end - at) / line).real for bar in skeleton.drawn if leaves(at, line, bar) for end in bar),
                       default=0.0) for line in lines}  # fmt: skip
    others = [skeleton.at(other.point) for other in skeleton.blocks.values() if other is not slide]
    across = any(abs(place - at) < symbols.HINGE for place in others)
    off, side = (symbols.BLOCK.imag / 2 if block and not across else 0.0), _SEEN if across else symbols.SQUARE
    corners = [(at + off * line, way, line) for way, line in product(ways, lines) if reach[line] > _SEEN
               and (across or all(abs(at + off * line - place) > _SEEN for place in others))]  # fmt: skip
    room = [clearance(skeleton, corner + side * (way + line)) for corner, way, line in corners]
    return symbols.right_angle(*corners[room.index(max(room))], side, step) if corners else []


OVER_LINKS: Signs = {Cam: wheels.profiles, Slide: _sliding}  # signs of pairs that stand over links; hinges are points
BEFORE_LINKS: Signs = {CircularSlot: wheels.circular_slot}  # those over which links are drawn, as over wheels


def _through_bars(skeleton: Skeleton) -> Iterator[Mark]:
    """A bar that goes on past a hinge, but no block's, is drawn over its circle; other bars end at it."""
    machine, done = skeleton.mechanism, {slide.point for slide in skeleton.mechanism.slides}
    for names in map(skeleton.named, machine.moving):
        places = [skeleton.at(p) for p in names]
        if len(names) < 3 or (ends := in_line(places)) is None:
            continue
        half = (places[ends[1]] - places[ends[0]]) / abs(places[ends[1]] - places[ends[0]]) * symbols.HINGE
        for k, (point, at) in enumerate(zip(names, places, strict=True)):
            if k not in ends and len(machine.owners[point]) > 1 and point not in done:
                done.add(point)
                yield Stroke((at - half, at + half), "visible", step=skeleton.step(point))


def _hinges(skeleton: Skeleton) -> Iterator[Mark]:
    """Hinges as white circles, other points of links as dots."""
    pins = {pair.pin for pair in skeleton.mechanism.pairs if pair.pin is not None}
    for point in skeleton.points:
        at, step, owners = skeleton.at(point), skeleton.step(point), skeleton.mechanism.owners[point]
        hinged, site = len(owners) > 1 or point in pins, f"{point}@{owners[0]}"
        radius = symbols.HINGE if hinged else 0.6
        yield PointMark("position", point, point, at, radius, "paper" if hinged else "ink", step, site=site)


def _link_number(skeleton: Skeleton, link: str, places: list[Place], step: int | None) -> Iterator[LabelRequest]:
    """A link's number beside its longest bar, inside its outline, or beside its block."""
    label = link_label(skeleton.mechanism.called(link))
    slide, guide = skeleton.blocks.get(link), next(skeleton.guides(link), None)
    if link in wheels.numbered(skeleton):
        return  # it stands at the wheel
    if slide is not None and len(places) < 2:
        at, rod = skeleton.at(slide.point), wheels.follower(skeleton, slide)
        if skeleton.is_cylinder(slide) or rod is not None:
            start, end = (_tube_end(skeleton, slide), at) if rod is None else rod[0].places[:2]
            yield LabelRequest(label, start, end, gap=1.2, step=step)
        else:
            yield LabelRequest(label, at, gap=math.hypot(2.4, 2.8), away=skeleton.direction(slide.line) * 1j, step=step)
    elif len(places) > 1 and in_line(places) is None:
        corners = [places[k] for k in hull(places)]
        middle = sum(corners) / len(corners)  # or half-way to a corner, where a joint of others lies there
        others = [at for at, _, links in skeleton.joints if link not in links]
        inside = [middle, *((middle + corner) / 2 for corner in corners)]
        at = max(inside, key=lambda at: min([_ASIDE, *(abs(at - other) for other in others)]))
        yield LabelRequest(label, at, gap=-2.6, step=step)
    elif bars := [*skeleton.bars(link)]:
        tube = guide if guide is not None and skeleton.is_cylinder(guide) else None
        start, end = max(bars, key=lambda bar: abs(bar[1] - bar[0]))
        end, gap = (end, 1.2) if tube is None else (_tube_end(skeleton, tube), 3.4)
        yield LabelRequest(label, start, end, gap=gap, step=step)
    elif places:
        yield LabelRequest(label, places[0], gap=4.0, step=step)


def _tube_end(skeleton: Skeleton, slide: Slide) -> Place:
    """The end of a cylinder's tube, from which its rod goes on."""
    foot = skeleton.at(slide.line.origin)
    return foot + symbols.TUBE * (skeleton.at(slide.point) - foot)


def mechanism_places(method: Method, plot: Plot) -> list[complex]:
    """The places that the mechanism itself takes up [m]."""
    machine, points = method.mechanism, {name: place(value) for name, value in plot.position.items()}
    circles = [circle for pair in machine.pairs for circle in pair.circles]
    rims = (points[centre] + side * complex(radius, radius) for _, centre, radius in circles for side in (-1, 1))
    return [*(points[name] for name in machine.points if name in points), *rims]


def shown_places(method: Method, plot: Plot) -> list[complex]:
    """The places its figure shows: the mechanism's, and special points near it [m]."""
    places = mechanism_places(method, plot)
    return [*places, *named_specials(method, plot, places).values()]


def plain_mechanism(method: Method, plot: Plot, window: Window, others: Sequence[Plot] = ()) -> Figure:
    """The mechanism's own figure with its points as circles; others: all positions of which it is one."""
    born = births(method, "position")
    here, *every = (Skeleton(method.mechanism, each, window, born) for each in (plot, *others))
    figure = mechanism_figure(here, method, shown_places(method, plot), grounds(*(every or [here])))
    return plainly(figure)


def plainly(figure: Figure) -> Figure:
    """The same with its points as circles and nothing more."""
    pens: dict[Fill, PenName] = {"paper": "outline"}
    return Figure([Disc(mark.at, mark.radius, pens.get(mark.fill, "construction"), mark.fill, step=mark.step)
                   if isinstance(mark, PointMark) else mark for mark in figure.marks], figure.wanted)  # fmt: skip
