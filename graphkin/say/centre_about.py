"""A link about its pole in words, Bobillier's construction, and the pole of two velocities."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphkin.construction.drafting import Stage
from graphkin.errors import Lang
from graphkin.say import names
from graphkin.say.catalogue import say as spoken
from graphkin.say.entry import Calculation
from graphkin.say.figures import Operand
from graphkin.say.numbers import SentenceNumber, number
from graphkin.say.senses import sense, sensed
from graphkin.studies.centres.about import About, Circle
from graphkin.studies.centres.about_bobillier import Bobillier, Guided
from graphkin.studies.centres.two_velocities import TwoVelocities


def say(key: str, lang: Lang, /, **words: object) -> str:
    """A phrase whose numbers have four figures."""
    told = {name: SentenceNumber(word) if isinstance(word, float) else word for name, word in words.items()}
    return spoken(key, lang, **told)


def about_words(seen: About, lang: Lang) -> list[str]:
    """What is known of the link and of its points at this instant, a sentence each."""
    return [*link_words(seen, lang), *(_point(seen, name, lang) for name in seen.points)]


def link_words(seen: About, lang: Lang) -> Iterator[str]:
    """What is known of the link as a whole."""
    rates = {"omega": ("ω", seen.omega, "rad/s"), "alpha": ("α", seen.alpha, "rad/s²")}
    known = {"link": seen.called} | {name: sensed(*rate, lang) for name, rate in rates.items()}
    if seen.assumed:
        yield say("about.assumed", lang)
    if not seen.moves:
        yield say("about.rest", lang, **known)
    elif seen.diameter is None:
        yield say("about.translation", lang, **known, at=_degrees(seen.towards))
    else:
        yield say("about.pole", lang, **known, place=_place(seen, seen.pole))
    if seen.acceleration_pole is not None:
        yield say("about.acceleration", lang, place=_place(seen, seen.acceleration_pole))
    elif seen.moves:
        yield say("about.no acceleration", lang)
    yield from _circles(seen, lang)


def _circles(seen: About, lang: Lang) -> Iterator[str]:
    inflection, returning = seen.inflection, seen.returning
    if inflection is None:
        return
    if not isinstance(inflection, Circle):
        place, at = _place(seen, inflection.through), _degrees(inflection.direction)
        yield say("about.inflection line", lang, place=place, at=at)
        return
    if seen.tangent is None or returning is None or seen.pole_velocity is None:
        yield say("about.pivot", lang)
        return
    yield say("about.moving pole", lang, u=abs(seen.pole_velocity), tangent=_degrees(seen.tangent))
    yield say("about.inflection", lang, diameter=2e3 * inflection.radius, place=_place(seen, inflection.centre))
    yield say("about.return", lang, place=_place(seen, returning.centre))


def _point(seen: About, name: str, lang: Lang) -> str:
    carried = seen.points[name]
    known = {"name": name, "v": abs(carried.velocity), "a": abs(carried.acceleration)}
    if cmath.isnan(carried.centre):
        return say("about.still", lang, **known)
    if cmath.isinf(carried.centre):
        return say("about.straight", lang, **known)
    if carried.radius == 0:
        return say("about.cusp", lang, **known)
    return say("about.curved", lang, **known, radius=1e3 * carried.radius, place=_place(seen, carried.centre))


def _place(seen: About, place: complex) -> str:
    """`(66.4, 182.4) mm`."""
    shown = 1e3 * complex(seen.found.method.mechanism.usual.cut(place, "m"))
    return f"({number(shown.real)}, {number(shown.imag)}) mm"


def _degrees(direction: complex) -> float:
    """A line's direction, in (-90, 90] deg."""
    angle = math.degrees(cmath.phase(direction))
    return angle - 180 if angle > 90 else angle + 180 if angle <= -90 else angle


# --- Bobillier's construction -----------------------------------------------------------------


def bobillier_words(drawn: Bobillier, lang: Lang) -> list[str]:
    """What the two points are known from, and one sentence each stage."""
    first, second = drawn.guides
    known = {"a": first.point, "b": second.point, "a0": first.written, "b0": second.written, "c": drawn.point}
    q, qc = drawn.crossings
    known |= {"p": drawn.pole, "q": q, "qc": qc, "k": drawn.answer}
    drawing = (_stage(drawn, stage, lang, known) for stage in drawn.construction.stages)
    return [*(_known(entry, lang) for entry in drawn.guides), *drawing]


def _stage(drawn: Bobillier, stage: Stage, lang: Lang, known: dict[str, str]) -> str:
    """A stage; its lines may be parallel."""
    if stage.say == "Q" and not any(entry.centre[2] for entry in drawn.guides):
        return say("about.bobillier Q line", lang, **known)
    far = stage.say in ("Q", "K") and cmath.isinf(drawn.board.at(stage.last.name))
    return say(f"about.bobillier {stage.say} far" if far else f"about.bobillier {stage.say}", lang, **known)


def _known(entry: Guided, lang: Lang) -> str:
    kind = "measured" if entry.measured else "pivoted" if entry.pivoted else "guided"
    return say(f"about.bobillier {kind}", lang, point=entry.point, centre=entry.written)


# --- two velocities ---------------------------------------------------------------------------


def pole_words(found: TwoVelocities, lang: Lang) -> list[str]:
    """What is drawn, and what is found, a sentence each."""
    first, second = found.names
    still, other = (first, second) if abs(found.velocities[0]) < abs(found.velocities[1]) else (second, first)
    known = {
        "a": first, "b": second, "still": still, "other": other, "x": 1e3 * found.place.real,
        "y": 1e3 * found.place.imag, "omega": abs(found.omega), "at": math.degrees(found.direction or 0.0),
        "sense": sense(found.omega, lang),
    }  # fmt: skip
    along = cmath.phase(found.points[1] - found.points[0])
    component = (found.velocities[0] * cmath.rect(1, -along)).real
    component = component if abs(component) > 1e-12 * abs(found.fastest[1]) else 0.0
    told = [say("about.two rigid", lang, **known, component=component), say(f"about.two {found.case}", lang, **known)]
    if found.case in ("meet", "similar", "point"):
        told.append(_turning(found, lang))
    return told


def _turning(found: TwoVelocities, lang: Lang) -> str:
    """`ω = v_A/l_AP = 1.118/0.1597 = 7 rad/s`."""
    place, speed = found.fastest
    point, arm = names.point(found.names[found.points.index(place)]), abs(found.arm)
    omega = Calculation("ω", (f"v_{point}/l_{point}P",), Operand(abs(speed)) / Operand(arm), abs(found.omega), "rad/s")
    return say("about.two omega", lang, omega=omega.text, sense=sense(found.omega, lang))
