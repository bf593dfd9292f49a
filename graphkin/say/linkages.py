"""A linkage in words: its report in sentences, the names of the kinds, the titles and notes of files."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import degrees

from graphkin.errors import Lang
from graphkin.model.mechanism import FRAME, Driver, Mechanism
from graphkin.say.catalogue import LANGUAGES, in_both, say
from graphkin.say.figures import figures, written
from graphkin.say.numbers import angle, exact, millimetres, number
from graphkin.say.transmission import cosine
from graphkin.studies.linkages import FAMILY, FoundLinkage, Linkage, Report, filed, inverted, report
from graphkin.studies.linkages.linkage import LinkagePosition
from graphkin.studies.linkages.triangles import EVEN

_DIGITS = 5
"""Of K."""

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


def found_lines(found: FoundLinkage, report: Report, lang: Lang) -> Iterator[str]:
    """Lines of a linkage found in a mechanism: which links it is made of first."""
    yield say("linkages.links", lang, links=say("common.list", lang).join(_links(found, lang)))
    yield from lines(report, lang)
    if found.driven != "driver":
        key = "behind" if found.before is not None else found.driven
        yield say(f"linkages.found {key}", lang, driver=report.driver)


def _links(found: FoundLinkage, lang: Lang) -> Iterator[str]:
    """What the links are called; a pin that runs in a slot is none, and called so."""
    pin = found.linkage.names[1] if "bar" in found.linkage.called else ""
    for link in found.links:
        yield say("linkages.pin", lang, point=link) if link == pin else link


def lines(report: Report, lang: Lang) -> Iterator[str]:
    """What a linkage is and does, one sentence a line."""
    told = (f"{name} = {millimetres(value)}" for name, value in report.linkage.sizes.items())
    sizes = say("common.and", lang).join(told)
    yield f"{kind_name(report, lang)}{say('common.colon', lang)}{sizes}"
    yield say("linkages.drives", lang, driver=report.driver, output=report.output)
    yield _sums(report, lang)
    yield say(f"linkages.why {report.kind}", lang, **_parts(report), reach=_reach(report))
    yield from _equal(report, lang)
    yield from _turns(report, lang)
    yield from _limits(report, lang)
    yield from _ratio(report, lang)
    yield from _gamma(report, lang)
    yield from _dead(report, lang)
    yield from _advantage(report, lang)


def amount(report: Report, value: float) -> str:
    """A driver's value: an angle, or a slider's place."""
    return millimetres(value) if report.driver_slides else angle(value)


def _place(report: Report, value: float) -> str:
    return millimetres(value) if report.output_slides else angle(value)


def _parts(report: Report) -> dict[str, str]:
    """What the links are called."""
    return {"driver": report.driver, "output": report.output, **report.linkage.called}


def _reach(report: Report) -> str:
    """`CD + |e| = 600 + 575 = 1175 mm > DE = 150 mm`: why a crank does not turn fully; "" of what has no rod."""
    names, sizes = report.linkage.called, report.linkage.sizes
    if report.kind != "rocker-slider":
        return ""
    crank, rod = names["crank"], names["coupler"]
    parts, total = (sizes[crank], abs(sizes["e"])), sizes[crank] + abs(sizes["e"])
    figures = " + ".join(exact(part * 1e3) for part in parts)
    return f"{crank} + |e| = {figures} = {millimetres(total)} > {rod} = {millimetres(sizes[rod])}"


def _sums(report: Report, lang: Lang) -> str:
    """`AB + CD = 15 + 55 = 70 mm < BC + AD = 48 + 45 = 93 mm`."""
    sizes = report.linkage.sizes
    gap = report.sum_ends - report.sum_middle
    sign = "=" if abs(gap) <= EVEN * (report.sum_ends + report.sum_middle) else "<" if gap < 0 else ">"

    def added(names: tuple[str, str]) -> str:
        shown = [name for name in names if name]
        terms = " + ".join("|e|" if name == "e" else name for name in shown)
        if len(shown) == 1:
            return terms
        return terms + " = " + " + ".join(exact(abs(sizes[name]) * 1e3) for name in shown)

    key = "linkages.lengths" if report.slide else "linkages.grashof"
    first = {"ends": added(report.ends), "first": millimetres(report.sum_ends)}
    return say(key, lang, **first, sign=sign, middle=added(report.middle), second=millimetres(report.sum_middle))


def _equal(report: Report, lang: Lang) -> Iterator[str]:
    """Links of one length each, where that is so."""
    sizes = {name: value for name, value in report.linkage.sizes.items() if name != "e"}
    total = sum(sizes.values())
    alike: list[list[str]] = []
    for name, value in sizes.items():
        group = next((group for group in alike if abs(sizes[group[0]] - value) <= EVEN * total), None)
        alike.append([name]) if group is None else group.append(name)
    if equal := [" = ".join(group) for group in alike if len(group) > 1]:
        yield say("linkages.equal", lang, pairs=say("common.list", lang).join(equal))


def _turns(report: Report, lang: Lang) -> Iterator[str]:
    frame = say("linkages.frame", lang)
    for full in (True, False):
        pairs = [
            f"{turn.first}–{frame if turn.second == FRAME else turn.second}"
            for turn in report.turns if turn.full == full
        ]  # fmt: skip
        joined = say("common.list", lang).join(pairs) or say("linkages.nothing", lang)
        yield say("linkages.full" if full else "linkages.rocks", lang, pairs=joined)


def _how(report: Report, end: LinkagePosition, lang: Lang) -> str:
    """What is in line, or at right angles, in words."""
    called = report.linkage.called
    driver = called["crank"] if report.slide else report.driver
    return say(f"linkages.how {end.how}", lang, driver=driver, middle=called.get("coupler", ""))


def _limits(report: Report, lang: Lang) -> Iterator[str]:
    span = report.driver_span
    if span.full:
        yield say("linkages.turns", lang, driver=report.driver)
    else:
        low, high = (amount(report, value) for value in (span.low, span.high))
        yield say("linkages.range", lang, driver=report.driver, low=low, high=high)
    if not report.limits:
        yield say("linkages.no limits", lang, output=report.output)
        return
    for nth, end in enumerate(report.limits, start=1):
        text = say(
            "linkages.limit", lang, number=nth, how=_how(report, end, lang), driver=report.driver,
            value=amount(report, end.driver), output=report.output, place=_place(report, end.output),
        )  # fmt: skip
        yield text + ("" if end.gamma is None else say("linkages.and gamma", lang, gamma=angle(end.gamma)))
    if report.swing is not None:
        yield say("linkages.swing", lang, output=report.output, value=angle(report.swing))
    elif report.stroke is not None:
        yield say("linkages.stroke", lang, output=report.output, value=millimetres(report.stroke))


def _ratio(report: Report, lang: Lang) -> Iterator[str]:
    if report.k is None or report.theta is None:
        if report.limits:
            yield say("linkages.undetermined" if report.kind == "change-point" else "linkages.no ratio", lang)
    elif report.slow is None:
        yield say("linkages.no quick return", lang)
    else:
        yield say("linkages.theta", lang, theta=angle(report.theta), k=_k(report.theta, report.k))
        one, other = (number + 1 for number in report.slow)
        yield say("linkages.slow", lang, one=one, other=other, driver=report.timed_by or report.driver)


def _k(theta: float, k: float) -> str:
    """`(180 + 29.859)/(180 − 29.859) = 1.3977`."""
    half, found = figures(180.0, degrees(theta))
    return f"{written((half + found) / (half - found), k, _DIGITS)} = {number(k, digits=_DIGITS)}"


def _gamma(report: Report, lang: Lang) -> Iterator[str]:
    least, alpha = report.gamma_min, report.alpha_max
    if least is None or alpha is None:
        yield say("linkages.no gamma", lang)
    elif report.level:
        yield say("linkages.level", lang)
    else:
        for end in report.critical:
            words = {"gamma": angle(end.gamma or 0.0), "how": _how(report, end, lang)}
            words["cosine"] = say("linkages.cosine", lang, cosine=found) if (found := cosine(report, end)) else ""
            yield say("linkages.gamma", lang, **words, driver=report.driver, value=amount(report, end.driver))
        values = say("common.list", lang).join(amount(report, end.driver) for end in report.least)
        words = {"gamma": angle(least), "alpha": angle(alpha)}
        yield say("linkages.least", lang, **words, driver=report.driver, values=values)


def _dead(report: Report, lang: Lang) -> Iterator[str]:
    for driver, values in report.dead.items():
        if values:
            told = (millimetres(value) if driver == report.slide else angle(value) for value in values)
            said = say("common.list", lang).join(told)
            along = report.output != driver == report.slide and driver == "s"
            yield say("linkages.dead along" if along else "linkages.dead", lang, driver=driver, values=said)
        else:
            yield say("linkages.no dead", lang, driver=driver)


def _advantage(report: Report, lang: Lang) -> Iterator[str]:
    found = report.advantage
    if found is None:
        return
    unit = " N/(N·m)" if report.output_slides else ""
    endless = say("linkages.endless", lang) if found.endless else ""
    value, at = f"{number(found.least)}{unit}", amount(report, found.at)
    yield say("linkages.advantage", lang, value=value, driver=report.driver, at=at, endless=endless)


# --- kinds and files -----------------------------------------------------------------------------


def family_lines(lang: Lang) -> Iterator[str]:
    """One line a kind: its name, and where the library has it."""
    for member in FAMILY:
        name = kind_name(report(member.linkage), lang)
        files = say("common.colon", lang) + say("common.list", lang).join(member.library)
        yield name + (files if member.library else "")


def titled(linkage: Linkage, headline: str = "") -> Mechanism:
    """The linkage as a mechanism with its title and its file; headline: a title of its own, in both languages."""
    title = dict.fromkeys(LANGUAGES, headline) if headline else in_both(f"linkages.title {linkage.word}")
    return filed(replace(linkage.mechanism(), title=title))


def held(mechanism: Mechanism, link: str) -> Mechanism:
    """The mechanism with another link (as people call it) held fast, with its title and its file. Raises NoFixing."""
    title = {lang: say("linkages.fixed", lang, title=mechanism.headline(lang), link=link) for lang in LANGUAGES}
    notes = [_note(mechanism, driver, link) for driver in mechanism.drivers]
    return filed(replace(inverted(mechanism, link), title=title), notes)


def _note(mechanism: Mechanism, driver: Driver, fixed: str) -> str:
    """What becomes of a driver, in both languages."""
    key = "slide" if driver.kind == "slide" else "frame" if fixed in (driver.link, driver.from_link) else "moving"
    one, two = mechanism.called(driver.link), mechanism.called(driver.from_link)
    return " ".join(in_both(f"linkages.driven {key}", one=one, two=two).values())
