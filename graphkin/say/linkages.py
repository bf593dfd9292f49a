"""A linkage in words: its report in sentences, the names of the kinds, the titles and notes of files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import degrees

from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.say.catalogue import LANGUAGES, in_both, in_list, say
from graphkin.say.figures import Formula, figures, squared, written
from graphkin.say.numbers import angle, exact, millimetres, number
from graphkin.studies.linkages import FAMILY, Linkage, Report, filed, inverted, report
from graphkin.studies.linkages.linkage import LinkagePosition
from graphkin.studies.linkages.triangles import EVEN

_DIGITS = 5  # of K
_COSINE_DIGITS = 6  # an angle follows from its cosine, so this has more than what is read off paper

HELD_BLOCKS = ("oscillating guide bar", "rotating guide bar", "slider-crank", "rocker-slider")
"""Kinds that have a name of their own where the block is joined to the frame."""


def kind_name(report: Report, lang: Lang) -> str:
    """`crank-rocker`, `offset slider-crank`, `change-point linkage (parallelogram)`."""
    if report.linkage.block and report.kind in HELD_BLOCKS:
        return say(f"linkages.block {report.kind}", lang)
    kind = say(f"linkages.kind {report.kind}", lang)
    if report.family in ("", "bar"):
        return kind
    family = say(f"linkages.kind {report.family}", lang)
    if report.family in ("in-line", "offset"):
        return f"{family} {kind}" if lang == "en" else f"{family}{kind}"
    return kind + say("common.note", lang, note=family)


def all_lines(reports: Sequence[Report], lang: Lang) -> list[str]:
    """A blank line between two linkages."""
    return [line for report in reports for line in ("", *lines(report, lang))][1:]


def lines(report: Report, lang: Lang) -> Iterator[str]:
    """All that a linkage is and does, one sentence a line; of one in a mechanism which links it is made of first."""
    if (found := report.found) is None:
        yield from _own_lines(report, lang)
        return
    pin = found.linkage.names[1] if "bar" in found.linkage.called else ""  # one that runs in a slot is no link
    links = (say("linkages.pin", lang, point=link) if link == pin else link for link in found.links)
    yield say("linkages.links", lang, links=in_list(links, lang))
    yield from _own_lines(report, lang)
    if found.driven != "driver":
        key = "behind" if found.before is not None else found.driven
        yield say(f"linkages.found {key}", lang, driver=report.driver)


def _own_lines(report: Report, lang: Lang) -> Iterator[str]:
    lengths = (f"{name} = {millimetres(value)}" for name, value in report.linkage.sizes.items())
    yield f"{kind_name(report, lang)}{say('common.colon', lang)}{say('common.and', lang).join(lengths)}"
    yield say("linkages.drives", lang, driver=report.driver, output=report.output)
    yield _sums(report, lang)
    links, sizes, reach = report.linkage.called, report.linkage.sizes, ""
    if report.kind == "rocker-slider":  # `CD + |e| = 600 + 575 = 1175 mm > DE = 150 mm`: a crank does not turn fully
        crank, rod, both = links["crank"], links["coupler"], (sizes[links["crank"]], abs(sizes["e"]))
        added = f"{' + '.join(exact(size * 1e3) for size in both)} = {millimetres(sum(both))}"
        reach = f"{crank} + |e| = {added} > {rod} = {millimetres(sizes[rod])}"
    names = {"driver": report.driver, "output": report.output, **links}
    yield say(f"linkages.why {report.kind}", lang, **names, reach=reach)
    yield from _equal(report, lang)
    frame = say("linkages.frame", lang)
    for full in (True, False):
        turns = [turn for turn in report.turns if turn.full == full]
        pairs = [f"{turn.first}–{frame if turn.second == FRAME else turn.second}" for turn in turns]
        yield say("linkages.pairs", lang, which=not full, pairs=in_list(pairs, lang) or say("structure.none", lang))
    yield from _limits(report, lang)
    yield from _ratio(report, lang)
    yield from _gamma(report, lang)
    for driver, values in report.dead.items():
        if values:
            shown = in_list(map(millimetres if driver == report.slide else angle, values), lang)
            along = report.output != driver == report.slide and driver == "s"
            yield say("linkages.dead along" if along else "linkages.dead", lang, driver=driver, values=shown)
        else:
            yield say("linkages.no dead", lang, driver=driver)
    if (advantage := report.advantage) is not None:
        value = f"{number(advantage.least)}{' N/(N·m)' if report.output_slides else ''}"
        words = {"at": amount(report, advantage.at), "value": value, "driver": report.driver}
        endless = say("linkages.endless", lang) if advantage.endless else ""
        yield say("linkages.advantage", lang, endless=endless, **words)


def amount(report: Report, value: float) -> str:
    """A driver's value: an angle, or a slider's place."""
    return millimetres(value) if report.driver_slides else angle(value)


def limit_caption(report: Report, lang: Lang) -> list[str]:
    """The lines under a figure of both limits: K, and the dead points where another part drives."""
    texts = [say("linkages.sheet limits", lang, output=report.output)]
    if report.k is not None:
        key = "timed" if report.timed_by else "one" if report.slow is None else "k"
        texts.append(say(f"linkages.sheet {key}", lang, k=number(report.k), crank=report.timed_by))
    return texts + [_dead(report, name, lang) for name in report.dead if name != report.driver][:1]


def transmission_caption(report: Report, lang: Lang) -> list[str]:
    """The lines under a figure of the least transmission angle."""
    gamma, alpha = (f"{number(degrees(angle or 0.0))}°" for angle in (report.gamma_min, report.alpha_max))
    words = {"letter": _driving(report, report.driver), "driver": report.driver, "gamma": gamma, "alpha": alpha}
    values = ", ".join(amount(report, end.driver) for end in report.least)
    texts = [say("linkages.sheet gamma", lang, driver=report.driver)]
    texts.append(say("linkages.sheet least", lang, values=values, **words))
    return texts + ([_dead(report, report.driver, lang)] if report.driver in report.dead else [])


def _driving(report: Report, driver: str) -> str:
    """The letter for the place of a part that drives."""
    return "s" if driver == report.slide else "φ"


def _dead(report: Report, driver: str, lang: Lang) -> str:
    values, slides = report.dead[driver], driver == report.slide
    texts = (f"{round(value * 1e3, 6) + 0.0:.5g} mm" if slides else angle(value) for value in values)
    shown, linkage = ", ".join(texts).replace("-", "−"), report.linkage
    words = {"driver": driver, "letter": _driving(report, driver), "pivot": linkage.names[linkage.arm[0]]}
    from_pivot = slides and driver == report.output != report.driver  # else as the file counts it
    return say(f"linkages.sheet {'dead' if values else 'none'}", lang, which=from_pivot, values=shown, **words)


def _sums(report: Report, lang: Lang) -> str:
    """`AB + CD = 15 + 55 = 70 mm < BC + AD = 48 + 45 = 93 mm`."""
    sizes, sums = report.linkage.sizes, report.sums
    sign = "=" if sums.gap == 0 else "<" if sums.gap < 0 else ">"

    def added(names: tuple[str, str]) -> str:
        shown = [name for name in names if name]
        terms = " + ".join("|e|" if name == "e" else name for name in shown)
        if len(shown) == 1:
            return terms
        return terms + " = " + " + ".join(exact(abs(sizes[name]) * 1e3) for name in shown)

    key = "linkages.lengths" if report.slide else "linkages.grashof"
    first = {"ends": added(sums.ends), "first": millimetres(sums.sum_ends)}
    return say(key, lang, **first, sign=sign, middle=added(sums.middle), second=millimetres(sums.sum_middle))


def _equal(report: Report, lang: Lang) -> Iterator[str]:
    """Links of one length each, where that is so."""
    sizes = {name: value for name, value in report.linkage.sizes.items() if name != "e"}
    total = sum(sizes.values())
    alike: list[list[str]] = []
    for name, value in sizes.items():
        group = next((group for group in alike if abs(sizes[group[0]] - value) <= EVEN * total), None)
        alike.append([name]) if group is None else group.append(name)
    if equal := [" = ".join(group) for group in alike if len(group) > 1]:
        yield say("linkages.equal", lang, pairs=in_list(equal, lang))


def _how(report: Report, end: LinkagePosition, lang: Lang) -> str:
    """The links in line, or at right angles, in words."""
    called = report.linkage.called
    driver = called["crank"] if report.slide else report.driver
    return say(f"linkages.how {end.how}", lang, driver=driver, middle=called.get("coupler", ""))


def _limits(report: Report, lang: Lang) -> Iterator[str]:
    span, words = report.driver_span, {"driver": report.driver, "output": report.output}
    if span.full:
        yield say("linkages.turns", lang, driver=report.driver)
    else:
        low, high = (amount(report, value) for value in (span.low, span.high))
        yield say("linkages.range", lang, driver=report.driver, low=low, high=high)
    if not report.limits:
        yield say("linkages.no limits", lang, output=report.output)
        return
    for nth, end in enumerate(report.limits, start=1):
        value, place = amount(report, end.driver), (millimetres if report.output_slides else angle)(end.output)
        how = _how(report, end, lang)
        text = say("linkages.limit", lang, number=nth, how=how, value=value, place=place, **words)
        yield text + ("" if end.gamma is None else say("linkages.and gamma", lang, gamma=angle(end.gamma)))
    if report.swing is not None:
        yield say("linkages.swing", lang, output=report.output, value=angle(report.swing))
    elif report.stroke is not None:
        yield say("linkages.stroke", lang, output=report.output, value=millimetres(report.stroke))


def _ratio(report: Report, lang: Lang) -> Iterator[str]:
    """`K = (180 + 29.859)/(180 − 29.859) = 1.3977`, and the slow stroke."""
    if report.k is None or report.theta is None:
        if report.limits:
            yield say("linkages.undetermined" if report.kind == "change-point" else "linkages.no ratio", lang)
    elif report.slow is None:
        yield say("linkages.no quick return", lang)
    else:
        half, theta = figures(180.0, degrees(report.theta))
        formula = written((half + theta) / (half - theta), report.k, _DIGITS)
        k = f"{formula} = {number(report.k, digits=_DIGITS)}"
        yield say("linkages.theta", lang, theta=angle(report.theta), k=k)
        one, other = (number + 1 for number in report.slow)
        yield say("linkages.slow", lang, one=one, other=other, driver=report.timed_by or report.driver)


def _gamma(report: Report, lang: Lang) -> Iterator[str]:
    least, alpha = report.gamma_min, report.alpha_max
    if least is None or alpha is None:
        yield say("linkages.no gamma", lang)
    elif report.level:
        yield say("linkages.level", lang)
    else:
        for end in report.critical:
            words = {"gamma": angle(end.gamma or 0.0), "how": _how(report, end, lang)}
            words["cosine"], called = "", report.linkage.called
            formula: tuple[str, Formula, float] | None = None
            if "rocker" in called and end.how in ("inner", "outer"):
                formula = _on_the_frame(report, end.how == "inner")
            elif "slider" in called and end.how in ("near", "far"):
                formula = _across_the_guide(report, end.how == "far")
            if formula is not None:
                name, numbers, value = formula
                shown = f"{written(numbers, value, _COSINE_DIGITS)} = {number(value, digits=_COSINE_DIGITS)}"
                words["cosine"] = say("linkages.cosine", lang, cosine=f"cos γ = {name} = {shown}")
            yield say("linkages.gamma", lang, **words, driver=report.driver, value=amount(report, end.driver))
        values = in_list((amount(report, end.driver) for end in report.least), lang)
        words = {"gamma": angle(least), "alpha": angle(alpha)}
        yield say("linkages.least", lang, **words, driver=report.driver, values=values)


def _on_the_frame(report: Report, inner: bool) -> tuple[str, Formula, float]:
    """`(BC² + CD² − (AD − AB)²)/(2 × BC × CD)` with its figures: the driver is on the frame's line."""
    names = report.linkage.called
    output = names["rocker" if report.driver == names["crank"] else "crank"]
    b, c, d, a = links = (names["coupler"], output, names["frame"], report.driver)
    coupler, rocker, frame, driver = (report.linkage.sizes[link] * 1e3 for link in links)
    base = abs(frame - driver) if inner else frame + driver
    line, twice = f"({d} {'−' if inner else '+'} {a})²", f"(2 × {b} × {c})"
    two, one, other = figures(2, coupler, rocker)
    value = (coupler**2 + rocker**2 - base**2) / (2 * coupler * rocker)
    if value >= 0:
        above, shown = f"{b}² + {c}² − {line}", squared(coupler) + squared(rocker) - squared(base)
    else:
        above, shown = f"{line} − {b}² − {c}²", squared(base) - squared(coupler) - squared(rocker)
    return f"({above})/{twice}", shown / (two * one * other), abs(value)


def _across_the_guide(report: Report, far: bool) -> tuple[str, Formula, float]:
    """`(AB + |e|)/BC` with its figures: the crank is across the guide."""
    names = report.linkage.called
    crank, rod, offset = (abs(report.linkage.sizes[link] * 1e3) for link in (names["crank"], names["coupler"], "e"))
    (a, one), (e, aside), (long,) = (names["crank"], crank), ("|e|", offset), figures(rod)
    if not offset:
        return f"{a}/{names['coupler']}", figures(crank)[0] / long, crank / rod
    if not far and offset > crank:
        (a, one), (e, aside) = (e, aside), (a, one)
    first, second = figures(one, aside)
    above, sign = (first + second, "+") if far else (first - second, "−")
    return f"({a} {sign} {e})/{names['coupler']}", above / long, abs(one + aside if far else one - aside) / rod


def family_lines(lang: Lang) -> Iterator[str]:
    """One line a kind: its name, and where the library has it."""
    for member in FAMILY:
        name = kind_name(report(member.linkage), lang)
        yield name + (say("common.colon", lang) + in_list(member.library, lang) if member.library else "")


def titled(linkage: Linkage, headline: str = "") -> Mechanism:
    """The linkage as a mechanism with its title and its file; headline: a title of its own, in both languages."""
    title = dict.fromkeys(LANGUAGES, headline) if headline else in_both(f"linkages.title {linkage.word}")
    return filed(replace(linkage.mechanism(), title=title))


def held(mechanism: Mechanism, link: str) -> Mechanism:
    """The mechanism with another link (as people call it) held fast, with its title and its file. Raises NoFixing."""
    title = {lang: say("linkages.fixed", lang, title=mechanism.headline(lang), link=link) for lang in LANGUAGES}
    notes = []
    for driver in mechanism.drivers:
        key = "slide" if driver.kind == "slide" else "frame" if link in (driver.link, driver.from_link) else "moving"
        one, two = mechanism.called(driver.link), mechanism.called(driver.from_link)
        notes.append(" ".join(in_both(f"linkages.driven {key}", one=one, two=two).values()))
    return filed(replace(inverted(mechanism, link), title=title), notes)
