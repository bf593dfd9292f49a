"""Positions that are none: what does not close, and dead points, with what probably is wrong in the file."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from graphkin import errors
from graphkin.base.geometry import cross, number, place
from graphkin.base.tolerances import CLOSED, ROUNDED
from graphkin.construction import Arc, Arm, Construction, Fit, Meet, Plot, Ray, Swing
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.model.naming import spelled
from graphkin.model.pairs import Gear
from graphkin.planning.equivalent import Contact
from graphkin.planning.structure import Topology

DEAD_DEG = 0.5  # lines that meet under less than this give no usable drawing [deg]
DEAD_SINE = float(np.sin(np.radians(DEAD_DEG)))
Crossing = Meet | Swing | Fit
FAR = 1.4  # a sketch is rough: so many times longer or shorter than it is no matter


def refuse_bad_positions(structure: Topology, construction: Construction, plot: Plot) -> None:
    """A single position that does not close, or is a dead point, raises; arrays pass, with NaN in them."""
    if any(isinstance(value, np.ndarray) and value.ndim for value in plot.position.values()):
        return
    for step in construction.steps:
        if not isinstance(step, Meet | Swing | Fit):
            continue
        sine = number(plot.sines["position", key_of(step)])
        if not np.isfinite(sine) or sine < DEAD_SINE:
            raise _refusal_at(structure, step, plot)
    refuse_open(structure, plot, CLOSED)


def refuse_open(structure: Topology, plot: Plot, part: float) -> None:
    """A link that repeats a constraint must fit it to a part of the mechanism's size."""
    size, mechanism = extent(plot), structure.mechanism
    link, gap = _open_link(structure, plot, size)
    if gap > part * size:
        called = (spelled(mechanism.called(link)),)
        raise _cannot_assemble(mechanism, mechanism.where("links", link), called, [link], gap * 1000)


def dead_end(structure: Topology, construction: Construction, plot: Plot) -> errors.CannotAssemble | errors.DeadPoint:
    """Of the crossing at which no branch is left; before all of them, of a cylinder driven back too far."""
    last = None
    for step in construction.steps:
        if isinstance(step, Meet | Swing | Fit) and ("position", key_of(step)) in plot.sines:
            last = step
            if not np.isfinite(plot.sines["position", key_of(step)]).any():
                break
    if last is not None:
        return _refusal_at(structure, last, plot)
    mechanism, least = structure.mechanism, {name: float(np.min(value)) for name, value in plot.s.items()}
    slide = structure.slides[min(least, key=lambda name: least[name])]
    links = dict.fromkeys((slide.guide, structure.home(structure.block(slide))))
    called = tuple(spelled(mechanism.called(link)) for link in links)
    driver = next(k for k, driver in enumerate(mechanism.drivers) if driver.link == slide.name)
    return errors.CannotAssemble(mechanism.where("driver", driver), called, abs(least[slide.name]) * 1000)


def _refusal_at(structure: Topology, step: Crossing, plot: Plot) -> errors.CannotAssemble | errors.DeadPoint:
    mechanism, links, key = structure.mechanism, links_of(structure, step), key_of(step)
    where = mechanism.where("links", *[link for link in links if structure.is_link(link)][-1:])
    called = tuple(spelled(mechanism.called(link)) for link in links)
    gap = float(np.nanmin(plot.misses.get(key, np.array(0.0))))
    if gap > CLOSED * extent(plot):
        return _cannot_assemble(mechanism, where, called, links, gap * 1000)
    sine = np.nan_to_num(np.asarray(plot.sines["position", key], dtype=float))
    angle = float(np.degrees(np.arcsin(min(1.0, float(np.max(sine))))))
    return _along_own_axis(mechanism, links, angle) or errors.DeadPoint(where, called, angle)


def _along_own_axis(mechanism: Mechanism, links: Sequence[str], angle_deg: float) -> errors.AlongOwnAxis | None:
    """Of a link of one point whose own axis is the way it slides, and that is to be pushed along that very axis. Two
    such slides in a row extend a telescope; where something else than a driver is to move the link, they say the same
    twice, and the drawing is dead in every position: a yoke whose slot was to lie across its guide, a follower's flat
    face."""
    called = tuple(mechanism.called(link) for link in links)
    for link in links:
        points = [point for point in mechanism.links[link].points if point in mechanism.points]
        own = next((k for k, slide in enumerate(mechanism.slides) if slide.block == link), None)
        along = any(slide.guide == link and slide.line.on_axis for slide in mechanism.slides)
        if len(points) == 1 and own is not None and along:
            where = mechanism.where("links", link)
            return errors.AlongOwnAxis(where, called, angle_deg, link, points[0], f"slide.{own}")
    return None


def _cannot_assemble(
    mechanism: Mechanism, where: errors.Where, called: tuple[str, ...], links: Sequence[str], gap_mm: float
) -> errors.CannotAssemble:
    """The error that says what is open, and which measure the sketch has quite differently: that is probably wrong."""
    places = {**mechanism.links[FRAME].points, **mechanism.sketch}
    worst = (FAR, "", 0.0, 0.0)  # times off, two points, as sketched, as given [mm]
    for link in links:
        own = mechanism.links[link].points if link in mechanism.moving else {}
        for one, other in combinations([point for point in own if point in places], 2):
            sketched, given = abs(places[other] - places[one]) * 1000, abs(own[other] - own[one]) * 1000
            if sketched > 0 and given > 0:
                worst = max(worst, (max(sketched / given, given / sketched), one + other, sketched, given))
    if not worst[1]:
        return errors.CannotAssemble(where, called, gap_mm)
    return errors.FarFromSketch(where, called, gap_mm, *worst[1:])


def extent(plot: Plot) -> float:
    """The greatest distance of a placed point from the first [m]."""
    places = [z for value in plot.position.values() for z in np.ravel(value).tolist() if cmath.isfinite(z)]
    return max(abs(z - places[0]) for z in places) if places else 1.0


def _open_link(structure: Topology, plot: Plot, size: float) -> tuple[str, float]:
    """The link whose points fit its shape least, and by how much [m], in a mechanism of this size. Only a link that
    repeats a constraint can fail so; every other has been drawn from its shape."""
    gaps = [("", 0.0)]
    for link in structure.mechanism.links.values():
        points = [] if link.name in structure.followers or link.name not in plot.theta else [*link.points]
        for point in points[1:]:
            turned = link.arm(points[0], point) * np.exp(1j * plot.theta[link.name])
            gaps.append((link.name, abs(place(plot.arm(points[0], point) - turned))))
    for slide in structure.slides.values():
        arm = plot.arm(slide.line.origin, slide.point)
        gap = abs(number(cross(plot.guide_direction(slide.name), arm)))
        if slide.block is not None:  # which may not turn on its guide
            leaning = plot.theta[slide.block] - plot.theta[slide.guide] - slide.turn
            gap = max(gap, abs(place(np.exp(1j * leaning) - 1)) * size)
        gaps.append((structure.home(structure.block(slide)), gap))
    return max(gaps, key=lambda entry: entry[1])


def key_of(step: Crossing) -> str:
    """The name under which a plot keeps the angle of a crossing."""
    return step.point if isinstance(step, Meet) else step.slide if isinstance(step, Swing) else step.name


def links_of(structure: Topology, step: Crossing) -> list[str]:
    """The links whose reach, or whose guide, a crossing is about."""
    if isinstance(step, Swing):
        pair = structure.slides[step.slide]
        return list(dict.fromkeys((pair.guide, structure.home(structure.block(pair)))))
    if isinstance(step, Fit):
        arms = [part for closure in step.closures for part in closure.parts if isinstance(part, Arm)]
        return list(dict.fromkeys(structure.home(arm.link) for arm in arms))
    links: dict[str, None] = {}
    for locus in (step.first, step.second):
        if isinstance(locus, Arc):
            parts = locus.reach.parts
            links |= dict.fromkeys(p.link if isinstance(p, Arm) else structure.slides[p.slide].guide for p in parts)
        elif isinstance(locus, Ray) and (slide := getattr(locus.direction, "slide", None)):
            pair = structure.slides[slide]
            links |= dict.fromkeys((structure.home(structure.block(pair)), pair.guide))
    return list(links)


def refuse_contacts_apart(mechanism: Mechanism, ties: tuple[Contact, ...], plot: Plot) -> None:
    """Centres that other pairs hold must stand as the radii want: apart as far, or as far beside the track. At a single
    position; those of arrays pass."""
    if any(np.ndim(value) for value in plot.position.values()):
        return
    for tie in ties:
        if not tie.slide:
            distance, radii = abs(place(plot.arm(*tie.centres))), abs(sum(tie.radii))
            if abs(distance - radii) > ROUNDED * max(distance, radii):
                first, second = (1000 * radius for radius in tie.radii)
                raise errors.GearsApart(_radii(mechanism, tie), tie.centres, 1000 * distance, (first, second))
        elif mechanism.slides and (path := tie.pair.path) is not None:
            line, offset = path.line, path.offset  # the point lies so far to the left of its line
            along = line.direction * np.exp(1j * plot.theta[line.link])
            distance = number(cross(along, plot.arm(line.origin, path.point)))
            if abs(distance - offset) > ROUNDED * abs(offset):
                track = mechanism.called(line.link)
                raise errors.OffTrack(_radii(mechanism, tie), path.point, track, distance * 1000, offset * 1000)


def _radii(mechanism: Mechanism, tie: Contact) -> errors.Where:
    """The place where the file gives the radii of a contact."""
    return mechanism.where(*mechanism.path(tie.pair), "radii" if isinstance(tie.pair, Gear) else "radius")
