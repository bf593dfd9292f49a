"""A link about its pole in words: what turns about what, Bobillier's construction, two velocities, centrodes."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator

import numpy as np

from graphkin.base.geometry import place
from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME
from graphkin.say import catalogue, names
from graphkin.say.entry import Calculation
from graphkin.say.figures import Operand
from graphkin.say.numbers import SentenceNumber, at_edge, circled, coordinates, number, sense, sensed
from graphkin.say.reading import only_translates
from graphkin.studies.centres.about import About, Circle
from graphkin.studies.centres.about_bobillier import Bobillier
from graphkin.studies.centres.centrodes import FAR, LEAST, Centrodes
from graphkin.studies.centres.two_velocities import TwoVelocities


def say(key: str, lang: Lang, /, **words: object) -> str:
    """A phrase whose numbers have four figures."""
    written = {name: SentenceNumber(word) if isinstance(word, float) else word for name, word in words.items()}
    return catalogue.say(key, lang, **written)


def about_words(seen: About, lang: Lang) -> list[str]:
    """The link and its points at this instant, a sentence each."""
    sentences = [*link_words(seen, lang)]
    for name, carried in seen.points.items():
        data = {"name": name, "v": abs(carried.velocity), "a": abs(carried.acceleration)}
        if cmath.isnan(carried.centre) or cmath.isinf(carried.centre):
            sentences.append(say("about.still" if cmath.isnan(carried.centre) else "about.straight", lang, **data))
        elif carried.radius == 0:
            sentences.append(say("about.cusp", lang, **data))
        else:
            place = _place(seen, carried.centre)
            sentences.append(say("about.curved", lang, **data, radius=1e3 * carried.radius, place=place))
    return sentences


def link_words(seen: About, lang: Lang) -> Iterator[str]:
    """The link as a whole: its rotation, its poles and circles."""
    rates = {"omega": ("ω", seen.omega, "rad/s"), "alpha": ("α", seen.alpha, "rad/s²")}
    data = {name: sensed(*rate, lang) for name, rate in rates.items()}
    data |= {"link": seen.called, "p": seen.found.name(FRAME, seen.link)}
    if seen.assumed:
        yield say("about.assumed", lang)
    if not seen.moves:
        yield say("about.rest", lang, **data)
    elif seen.diameter is None:
        always = only_translates(seen.found.method, seen.plot, seen.link)
        yield say("about.translation", lang, **data, which=always, at=_degrees(seen.towards))
    else:
        yield say("about.pole", lang, **data, place=_place(seen, seen.pole))
    if seen.acceleration_pole is not None:
        yield say("about.acceleration", lang, place=_place(seen, seen.acceleration_pole))
    elif seen.moves:
        yield say("about.no acceleration", lang)
    inflection, returning = seen.inflection, seen.returning
    if inflection is None:
        return
    if not isinstance(inflection, Circle):
        place, at = _place(seen, inflection.through), _degrees(inflection.direction)
        yield say("about.inflection line", lang, place=place, at=at)
        return
    if seen.tangent is None or returning is None or seen.pole_velocity is None:
        yield say("about.pivot", lang, **data)
        return
    yield say("about.moving pole", lang, u=abs(seen.pole_velocity), tangent=_degrees(seen.tangent))
    place = _place(seen, inflection.centre)
    data["w"] = _place(seen, 2 * inflection.centre - seen.pole)
    yield say("about.inflection", lang, **data, diameter=2e3 * inflection.radius, place=place)
    yield say("about.return", lang, place=_place(seen, returning.centre))


def _place(seen: About, place: complex) -> str:
    """`(66.4, 182.4) mm`."""
    shown = 1e3 * complex(seen.found.method.mechanism.usual.cut(place, "m"))
    return f"({number(shown.real)}, {number(shown.imag)}) mm"


def _degrees(direction: complex) -> float:
    """A line's direction, in (-90, 90] deg."""
    angle = math.degrees(cmath.phase(direction))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle


def bobillier_words(drawn: Bobillier, lang: Lang) -> list[str]:
    """The source of both points, and one sentence each stage."""
    first, second, q, qc = drawn.guides[0], drawn.guides[-1], drawn.crossings[0], drawn.crossings[-1]
    data = {"a": first.point, "b": second.point, "a0": first.written, "b0": second.written, "c": drawn.point}
    data |= {"p": drawn.pole, "q": q, "qc": qc, "k": drawn.answer, "link": drawn.seen.called}
    data = {name: letter.replace("'", "′") for name, letter in data.items()}
    radius = 1e3 * abs(place(drawn.board.at(drawn.answer)) - place(drawn.board.at(drawn.point)))
    stages, pivots = [], any(entry.centre[2] for entry in drawn.guides)
    for count, stage in enumerate(drawn.construction.stages, start=1):  # whose lines may be parallel
        far = stage.say in ("Q", "K") and cmath.isinf(drawn.board.at(stage.last.name))
        where = " line" if stage.say == "Q" and not pivots else " far" if far else ""
        if stage.say == "axis c" and drawn.point == second.point:
            where = " same"
        stages.append(f"{circled(count)} {say(f'about.bobillier {stage.say}{where}', lang, **data, radius=radius)}")
    sources = []
    for entry in drawn.guides:
        kind = "measured" if entry.measured else "pivoted" if entry.pivoted else "guided"
        sources.append(say(f"about.bobillier {kind}", lang, point=entry.point, centre=entry.written.replace("'", "′")))
    return [*sources, *stages]


def bobillier_lines(drawn: Bobillier, lang: Lang) -> list[str]:
    """The link about its pole, then the construction."""
    return [*about_words(drawn.seen, lang), "", *bobillier_words(drawn, lang)]


def pole_words(found: TwoVelocities, lang: Lang) -> list[str]:
    """The drawing of two velocities and the pole it gives, a sentence each."""
    first, second = found.names
    still, other = (first, second) if abs(found.velocities[0]) < abs(found.velocities[1]) else (second, first)
    data = {
        "a": first, "b": second, "still": still, "other": other, "x": 1e3 * found.place.real,
        "y": 1e3 * found.place.imag, "omega": abs(found.omega), "at": math.degrees(found.direction or 0.0),
        "sense": sense(found.omega, lang),
    }  # fmt: skip
    along = cmath.phase(found.points[1] - found.points[0])
    component = (found.velocities[0] * cmath.rect(1, -along)).real
    component = component if abs(component) > 1e-12 * abs(found.fastest[1]) else 0.0
    words = [say("about.two rigid", lang, **data, component=component), say(f"about.two {found.case}", lang, **data)]
    if found.case in ("meet", "similar", "point"):  # `ω = v_A/l_AP = 1.118/0.1597 = 7 rad/s`
        place, speed = found.fastest
        numbers = Operand(abs(speed)) / Operand(abs(found.arm))
        point = names.point(found.names[found.points.index(place)])
        omega = Calculation("ω", (f"v_{point}/l_{point}P",), numbers, abs(found.omega), "rad/s").text
        words.append(say("about.two omega", lang, omega=omega, sense=sense(found.omega, lang)))
    return words


def curves_met(curves: Centrodes, centre: complex | None, lang: Lang, off: bool = False) -> Iterator[str]:
    """The curves at a centre [m], for a sheet that shows them, or that it lies off; how far each reaches."""
    if centre is not None:
        key = "about.hinge" if curves.is_point else "about.rolling" if len(curves.axes) > 1 else "about.centre now"
        place = coordinates(1e3 * centre, lang, 1e-6) + " mm" + off * catalogue.say("about.off", lang)
        yield catalogue.say(key, lang, centre=curves.name, place=place)
    every = () if curves.is_point else [pair for one in curves.pieces for pair in zip(curves.axes, one.places)]
    yield from dict.fromkeys(_reach(curves, *pair, lang, lambda value: f"{number(1e3 * value)} mm") for pair in every)


def curve_lines(curves: Centrodes, lang: Lang) -> Iterator[str]:
    """A line for each piece, and under it one for each link that the curve lies in."""
    yield catalogue.say("about.curves", lang, centre=curves.name, count=len(curves.pieces))
    for count, piece in enumerate(curves.pieces, 1):
        yield f"  {count}. " + catalogue.say("about.piece", lang, which=not piece.closed, places=piece.t.size)
        for link, places in zip(curves.axes, piece.places):
            yield "     " + _reach(curves, link, places, lang, lambda value: at_edge(value, "m"))
    yield catalogue.say("about.where curves", lang)


def _reach(curves: Centrodes, link: str, places: np.ndarray, lang: Lang, shown: Callable[[float], str]) -> str:
    """The extent of a curve; one that is smaller than curves are looked at is none."""
    sides, least, called = list[str](), LEAST * curves.found.board.size, curves.found.method.mechanism.called(link)
    if float(np.abs(places).max()) > FAR * curves.found.board.size / 2:
        return catalogue.say("about.endless", lang, link=called)
    for part in (places.real, places.imag):
        low, high = (float(end) * (abs(end) > least) for end in (part.min(), part.max()))
        key = "about.stays" if high - low <= least else "finding.interval"
        sides.append(catalogue.say(key, lang, value=shown(low), begin=shown(low), end=shown(high)))
    return catalogue.say("about.reach", lang, link=called, x=sides[0], y=sides[1])
