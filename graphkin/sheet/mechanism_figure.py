"""The mechanism drawn to scale: its signs and its letters."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from graphkin.base.geometry import place
from graphkin.construction import Plot
from graphkin.model.mechanism import FRAME
from graphkin.model.pairs import Cam, CircularSlot, Pair, Slide
from graphkin.planning import Method
from graphkin.planning.method import births
from graphkin.sheet import symbols
from graphkin.sheet.added_points import contacts, named_specials, specials
from graphkin.sheet.fixed_link import drives, grounds
from graphkin.sheet.label_requests import LabelRequest
from graphkin.sheet.lettering import link_label, point_label
from graphkin.sheet.marks import Disc, Fill, Mark, Place, PointMark, Shows, Stroke
from graphkin.sheet.skeleton import Skeleton, crossing, hull, in_line
from graphkin.sheet.wheels import (  # fmt: skip
    circular_slot,
    disc,
    equivalents,
    follower,
    profiles,
    rims,
    rod_letters,
    wheels,
    wheels_of,
)
from graphkin.sheet.window import Figure, Window

_JOINED = 3.0  # lines that cross so near to a point are joined there [mm]
Signs = Mapping[type[Pair], Callable[[Skeleton, Any], list[Mark]]]


def mechanism_figure(
    skeleton: Skeleton, method: Method, drawn: list[complex], others: Sequence[Skeleton] = ()
) -> Figure:
    """Wheels and ground first, then links, blocks over their guides, hinges over links, arrows last.

    drawn   the places that the figure has room for [m]
    others  all positions of which it is one: the ground is the same in each
    """
    ground = grounds(*(others or [skeleton]))
    return _figure(skeleton, method, specials(method, skeleton, drawn), ground, drives(skeleton, method))


def moving_figure(skeleton: Skeleton, method: Method, others: Sequence[Skeleton], driving: Figure) -> Figure:
    """One position of many that are shown in turn: its ground suits them all, its drivers' arrows are given."""
    return _figure(skeleton, method, Figure(), grounds(*others), driving)


def _figure(
    skeleton: Skeleton, method: Method, special: Figure, ground: Figure, driving: Figure, bare: bool = False
) -> Figure:
    """bare: without lower-pair equivalents."""
    turning, bodies, touching = wheels(skeleton), _bodies(skeleton), contacts(method, skeleton)
    marks = special.marks + turning.marks + ground.marks + bodies.marks + _hinges(skeleton) + touching.marks
    marks += [*_through_bars(skeleton), *(equivalents(skeleton) if not bare else ()), *driving.marks]
    labels = bodies.wanted
    for point in skeleton.points:  # letters of points; those at one place share a label
        away, step = -sum(skeleton.directions(point), 0j), skeleton.step(point)
        labels.append(LabelRequest(point_label(point), skeleton.at(point), gap=symbols.HINGE, away=away, step=step))
    for part in (driving, ground, turning, special, touching):
        labels += part.wanted
    labels += rod_letters(skeleton) if not bare else ()
    return Figure(marks, labels)


def moving_links(skeleton: Skeleton) -> list[Mark]:
    """Links, blocks and hinges alone."""
    return _bodies(skeleton).marks + _hinges(skeleton)


# --- links ------------------------------------------------------------------------------------


def _bodies(skeleton: Skeleton) -> Figure:
    """Links with their numbers, cams, and blocks over their guides."""
    figure = Figure(_signs(skeleton, BEFORE_LINKS))
    for link in skeleton.mechanism.moving:
        names = skeleton.named(link)
        places, step = [skeleton.at(p) for p in names], skeleton.step(*names)
        for slide in skeleton.guides(link):
            figure.marks += _guide(skeleton, slide)
        if centre := disc(skeleton, link):  # a thin radius to each further point of a wheel
            figure.marks += [mark for name in names if name != centre for mark in _radius(skeleton, link, centre, name)]
        elif len(names) > 1:
            figure.marks += _body(names, places, link, step)
        figure.wanted += _link_number(skeleton, link, places, step)
    return Figure([*_broken(skeleton, figure.marks)][::-1] + _signs(skeleton, OVER_LINKS), figure.wanted)


def _broken(skeleton: Skeleton, marks: Sequence[Mark]) -> Iterator[Mark]:
    """Bars and guides, last ones first, broken where one goes over them that is of another link and no joint."""
    joints, over = [skeleton.at(point) for point in skeleton.points], list[tuple[set[str], int | None, Place, Place]]()
    for mark in reversed(marks):
        if isinstance(mark, Stroke) and mark.shows is not None and mark.shows.form in ("bar", "guide", "arc"):
            of, sides = {mark.shows.link, mark.shows.line} - {""}, [*pairwise(mark.outline)]
            met = [(crossing(*side, *ends), step) for side in sides for other, step, *ends in over if not other & of]
            breaks = [(at, step) for at, step in met if at and all(abs(at - joint) > _JOINED for joint in joints)]
            over += [(of, mark.step, *side) for side in sides]
            mark = replace(mark, breaks=tuple(breaks))
        yield mark


def _signs(skeleton: Skeleton, signs: Signs) -> list[Mark]:
    """The signs of all pairs of these kinds."""
    pairs = ((sign, pair) for kind, sign in signs.items() for pair in skeleton.mechanism.of(kind))
    return [mark for sign, pair in pairs for mark in sign(skeleton, pair)]


def _body(names: tuple[str, ...], places: list[Place], link: str, step: int | None) -> list[Mark]:
    """A bar, or the outline of three and more points; points inside it hang on two corners."""
    if (ends := in_line(places)) is not None:
        return symbols.bar([places[k] for k in ends], Shows(link, "bar", tuple(names[k] for k in ends)), step)
    round_about = hull(places)
    outline = Shows(link, "bar", tuple(names[k] for k in round_about))
    corners = tuple(places[k] for k in round_about)
    marks: list[Mark] = [Stroke(corners, "outline", closed=True, fill="tint", shows=outline, step=step)]
    for k in range(len(places)):
        if k not in round_about:
            one, other = sorted(round_about, key=lambda c, k=k: abs(places[c] - places[k]))[:2]  # type: ignore[misc]
            hung = Shows(link, "bar", (names[one], names[k], names[other]))
            marks.append(Stroke((places[one], places[k], places[other]), "visible", shows=hung, step=step))
    return marks


def _radius(skeleton: Skeleton, link: str, *ends: str) -> list[Mark]:
    shows, step = Shows(link, "bar", ends), skeleton.step(*ends)
    return [Stroke(tuple(map(skeleton.at, ends)), "thin", shows=shows, step=step)]


def _guide(skeleton: Skeleton, slide: Slide) -> list[Mark]:
    """A moving guide's own bar, welded to the rest of its link."""
    origin, step = slide.line.origin, skeleton.step(slide.line.origin, slide.point)
    if skeleton.is_cylinder(slide):
        assert slide.block is not None, slide
        foot, tube = (Shows(slide.guide, "guide", points, slide.name) for points in ((origin,), ()))
        rod = Shows(slide.block, "guide", (slide.point,), slide.name)  # it ends at the point that slides
        return symbols.cylinder(skeleton.at(origin), skeleton.at(slide.point), (foot, tube, rod), step)
    start, end = skeleton.guide_bar(slide)
    marks = symbols.bar([start, end], Shows(slide.guide, "guide", (origin, slide.point), slide.name), step)
    if skeleton.is_welded(slide) and slide.line.named:
        at = skeleton.at(origin)
        far = max((start, end), key=lambda p: abs(p - at))
        for other in [skeleton.at(p) for p in skeleton.named(slide.guide) if p != origin][:1]:
            marks += symbols.corner(at, far, other, step)
    return marks


def _sliding(skeleton: Skeleton, slide: Slide) -> list[Mark]:
    """The block or the slot, over its guide."""
    at, along = skeleton.at(slide.point), skeleton.along(slide)
    step = skeleton.step(slide.point, slide.line.origin)
    if (rod := follower(skeleton, slide)) is not None:
        return [*rod]
    if slide.block is not None:
        if skeleton.is_cylinder(slide):
            return []
        shows = Shows(slide.block, "block", (slide.point,), slide.name)
        corners = symbols.block_corners(at, along)
        return [Stroke(corners, "outline", closed=True, fill="paper", shows=shows, step=step)]
    if slide.guide == FRAME:
        return []
    reach = min(9.0, max(4.0, abs(at - skeleton.at(slide.line.origin)) - 3.0))
    shows = Shows(slide.guide, "slot", (slide.point,), slide.name)
    return symbols.slot((at - reach * along, at + 9.0 * along), shows, step)


OVER_LINKS: Signs = {Cam: profiles, Slide: _sliding}  # the signs of pairs that stand over the links; hinges are points
BEFORE_LINKS: Signs = {CircularSlot: circular_slot}  # those over which links are drawn, as they are over `wheels`


def _through_bars(skeleton: Skeleton) -> list[Mark]:
    """A bar that goes on past a pivot, or past another's that does, is drawn over the circle; other bars end at it."""
    marks: list[Mark] = []
    for point, (along, *others) in _passed(skeleton).items():
        if others or FRAME in skeleton.mechanism.owners[point]:
            at, half = skeleton.at(point), along * symbols.HINGE
            marks += symbols.bar([at - half, at + half], None, skeleton.step(point))
    return marks


def _passed(skeleton: Skeleton) -> dict[str, list[complex]]:
    """Hinges past which bars of links go on, with their directions."""
    directions: dict[str, list[complex]] = {}
    for link in skeleton.mechanism.moving:
        names = skeleton.named(link)
        places = [skeleton.at(p) for p in names]
        if len(names) < 3 or (ends := in_line(places)) is None:
            continue
        along = places[ends[1]] - places[ends[0]]
        for k, point in enumerate(names):
            if k not in ends and len(skeleton.mechanism.owners[point]) > 1:
                directions.setdefault(point, []).append(along / abs(along))
    return directions


# --- points and names -------------------------------------------------------------------------


def _hinges(skeleton: Skeleton) -> list[Mark]:
    """Hinges as white circles, beside a bar that goes on; other points of links as dots."""
    marks, passed = list[Mark](), _passed(skeleton)
    pins = {pair.pin for pair in skeleton.mechanism.pairs if pair.pin is not None}
    signs = {slide.point for slide in skeleton.mechanism.slides}
    signs |= {wheel.centre for wheel in wheels_of(skeleton.mechanism)}  # other hinges may have nothing but bars
    for point in skeleton.points:
        at, step, owners = skeleton.at(point), skeleton.step(point), skeleton.mechanism.owners[point]
        hinged, bars = len(owners) > 1 or point in pins, passed.get(point, [])
        if hinged and len(bars) == 1 and FRAME not in owners and point not in pins | signs:
            along = bars[0]
            across = sum((off * along.conjugate()).imag for off in skeleton.directions(point))
            side = along * (-1j if across < 0 else 1j)  # on which the links leave that end at it
            marks.append(Disc(at + (symbols.HINGE + 0.35) * side, symbols.HINGE, "outline", "paper", step=step))
            hinged = False
        fill: Fill = "paper" if hinged else "ink"
        radius, site = symbols.HINGE if hinged else 0.6, f"{point}@{owners[0]}"
        marks.append(PointMark("position", point, point, at, radius, fill, step, site=site))
    return marks


def _link_number(skeleton: Skeleton, link: str, places: list[Place], step: int | None) -> Iterator[LabelRequest]:
    """A link's number beside its longest bar, inside its outline, or beside its block."""
    label = link_label(skeleton.mechanism.called(link))
    slide, guide = skeleton.blocks.get(link), next(skeleton.guides(link), None)
    if disc(skeleton, link):
        return  # it stands within the rim
    if slide is not None and len(places) < 2:
        at, rod = skeleton.at(slide.point), follower(skeleton, slide)
        if skeleton.is_cylinder(slide):
            yield LabelRequest(label, _tube_end(skeleton, slide), at, gap=1.2, step=step)
        elif rod is not None:
            yield LabelRequest(label, rod[0].places[0], rod[0].places[1], gap=1.2, step=step)
        else:
            yield LabelRequest(label, at, gap=math.hypot(2.4, 2.8), away=skeleton.along(slide) * 1j, step=step)
    elif len(places) > 1 and (ends := in_line(places)) is None:
        corners = [places[k] for k in hull(places)]
        yield LabelRequest(label, sum(corners) / len(corners), gap=-2.6, step=step)
    elif len(places) > 1 and ends is not None:
        order = sorted(places, key=lambda p: abs(p - places[ends[0]]))
        longest = max(pairwise(order), key=lambda pair: abs(pair[1] - pair[0]))
        yield LabelRequest(label, *longest, gap=1.2, step=step)
    elif guide is not None:
        yield LabelRequest(label, skeleton.at(guide.line.origin), _tube_end(skeleton, guide), gap=3.4, step=step)
    elif places and not any(wheel.link == link for wheel in wheels_of(skeleton.mechanism)):
        yield LabelRequest(label, places[0], gap=4.0, step=step)


def _tube_end(skeleton: Skeleton, slide: Slide) -> Place:
    """The end of a cylinder's tube, from which its rod goes on."""
    foot = skeleton.at(slide.line.origin)
    return foot + symbols.TUBE * (skeleton.at(slide.point) - foot)


def mechanism_places(method: Method, plot: Plot) -> list[complex]:
    """The places that the mechanism itself takes up [m]."""
    machine, points = method.mechanism, {name: place(value) for name, value in plot.position.items()}
    return [*(points[name] for name in machine.points if name in points), *rims(machine, points)]


def shown_places(method: Method, plot: Plot) -> list[complex]:
    """The places its figure shows: the mechanism's, and special points near it [m]."""
    places = mechanism_places(method, plot)
    return [*places, *named_specials(method, plot, places).values()]


def plain_mechanism(method: Method, plot: Plot, window: Window, others: Sequence[Plot] = ()) -> Figure:
    """The mechanism's own figure with its points as circles; others: all positions of which it is one."""
    born = births(method, "position")
    here, *every = (Skeleton(method.mechanism, each, window, born) for each in (plot, *others))
    figure = mechanism_figure(here, method, shown_places(method, plot), every)
    return Figure([plainly(mark) for mark in figure.marks], figure.wanted)


def bare_figure(method: Method, skeleton: Skeleton) -> Figure:
    """The mechanism as a problem gives it: no special points and no lower-pair equivalents, which a solution finds."""
    return _figure(skeleton, method, Figure(), grounds(skeleton), drives(skeleton, method), bare=True)


def plainly(mark: Mark) -> Mark:
    """A point as a circle and nothing more."""
    if not isinstance(mark, PointMark):
        return mark
    return Disc(mark.at, mark.radius, "outline" if mark.fill == "paper" else "construction", mark.fill, step=mark.step)
