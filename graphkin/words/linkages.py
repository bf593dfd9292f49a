"""A linkage in words: its report in sentences, the names of the kinds, the titles and notes of files."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from graphkin.errors import Lang
from graphkin.linkages import FAMILY, FoundLinkage, Linkage, Report, filed, inverted, report
from graphkin.linkages.equal import EVEN
from graphkin.linkages.linkage import LinkagePosition
from graphkin.mechanism import FRAME, Driver, Mechanism
from graphkin.words.linkage_phrases import BLOCKS, DRIVEN, FAMILIES, FIXED, HOW, KINDS, TEXT, TITLES, WHY


def degrees(angle: float, lang: Lang = "en") -> str:
    """`32.984 deg`, `32.984°`."""
    value = f"{math.degrees(angle):.3f}".rstrip("0").rstrip(".")
    return f"{'0' if value == '-0' else value}{' deg' if lang == 'en' else '°'}"


def _mm(length: float) -> str:
    """`20 mm`; less than a millionth of one is none."""
    return f"{length * 1e3:.6g} mm" if abs(length) > 1e-9 else "0 mm"


def kind_name(report: Report, lang: Lang) -> str:
    """`crank-rocker`, `offset slider-crank`, `change-point linkage: parallelogram`."""
    kind = KINDS[report.kind][lang]
    if report.linkage.block and report.kind in BLOCKS:
        return BLOCKS[report.kind][lang]
    if not report.family:
        return kind
    family = FAMILIES.get(report.family, KINDS.get(report.family, {"en": report.family, "zh": report.family}))[lang]
    if report.family in ("in-line", "offset"):
        return f"{family} {kind}" if lang == "en" else f"{family}{kind}"
    if report.family == "bar":
        return kind
    return f"{kind}: {family}" if lang == "en" else f"{kind}：{family}"


def found_lines(found: FoundLinkage, report: Report, lang: Lang) -> Iterator[str]:
    """Lines of a linkage found in a mechanism: which links it is made of first."""
    links = ", ".join(found.links)
    yield TEXT["links"][lang].format(links=links)
    yield from lines(report, lang)
    if found.driven != "driver":
        key = "behind" if found.before is not None else found.driven
        yield TEXT[key][lang].format(driver=report.driver)


def lines(report: Report, lang: Lang) -> Iterator[str]:
    """What a linkage is and does, one sentence a line."""
    sizes = ", ".join(f"{name} = {_mm(value)}" for name, value in report.linkage.sizes.items())
    yield f"{kind_name(report, lang)}: {sizes}" if lang == "en" else f"{kind_name(report, lang)}：{sizes}"
    yield _say("drives", lang, driver=report.driver, output=report.output)
    yield _sums(report, lang)
    yield WHY[report.kind][lang].format(**_parts(report))
    yield from _equal(report, lang)
    yield from _turns(report, lang)
    yield from _limits(report, lang)
    yield from _ratio(report, lang)
    yield from _gamma(report, lang)
    yield from _dead(report, lang)
    yield from _advantage(report, lang)


def _say(key: str, lang: Lang, **words: object) -> str:
    return TEXT[key][lang].format(**words)


def amount(report: Report, value: float, lang: Lang) -> str:
    """A driver's value: an angle, or a slider's place."""
    return _mm(value) if report.driver_slides else degrees(value, lang)


def _place(report: Report, value: float, lang: Lang) -> str:
    return _mm(value) if report.output_slides else degrees(value, lang)


def _parts(report: Report) -> dict[str, str]:
    """What the links are called."""
    return {"driver": report.driver, "output": report.output, **report.linkage.called}


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
        return terms + " = " + " + ".join(f"{abs(sizes[name]) * 1e3:.6g}" for name in shown)

    key = "lengths" if report.slide else "grashof"
    return _say(
        key, lang, ends=added(report.ends), first=_mm(report.sum_ends), sign=sign, middle=added(report.middle),
        second=_mm(report.sum_middle),
    )  # fmt: skip


def _equal(report: Report, lang: Lang) -> Iterator[str]:
    """Links of one length each, where that is so."""
    sizes = [(name, value) for name, value in report.linkage.sizes.items() if name != "e"]
    total = sum(value for _, value in sizes)
    pairs = [
        f"{one} = {other}" for k, (one, a) in enumerate(sizes) for other, b in sizes[:k] if abs(a - b) <= EVEN * total
    ]
    if pairs:
        yield _say("equal", lang, pairs=", ".join(pairs))


def _turns(report: Report, lang: Lang) -> Iterator[str]:
    frame = {"en": "frame", "zh": "机架"}[lang]
    for key, full in (("full", True), ("rocks", False)):
        pairs = [
            f"{turn.first}–{frame if turn.second == FRAME else turn.second}"
            for turn in report.turns if turn.full == full
        ]  # fmt: skip
        yield _say(key, lang, pairs=", ".join(pairs) or TEXT["nothing"][lang])


def _how(report: Report, end: LinkagePosition, lang: Lang) -> str:
    """What is in line, or at right angles, in words."""
    called = report.linkage.called
    driver = called["crank"] if report.slide else report.driver
    return HOW[end.how][lang].format(driver=driver, middle=called.get("coupler", ""))


def _limits(report: Report, lang: Lang) -> Iterator[str]:
    span = report.driver_span
    if span.full:
        yield _say("turns", lang, driver=report.driver)
    else:
        low, high = (amount(report, value, lang) for value in (span.low, span.high))
        yield _say("range", lang, driver=report.driver, low=low, high=high)
    if not report.limits:
        yield _say("no limits", lang, output=report.output)
        return
    for number, end in enumerate(report.limits, start=1):
        text = _say(
            "limit", lang, number=number, how=_how(report, end, lang), driver=report.driver,
            value=amount(report, end.driver, lang), output=report.output, place=_place(report, end.output, lang),
        )  # fmt: skip
        yield text + ("" if end.gamma is None else _say("and gamma", lang, gamma=degrees(end.gamma, lang)))
    if report.swing is not None:
        yield _say("swing", lang, output=report.output, value=degrees(report.swing, lang))
    elif report.stroke is not None:
        yield _say("stroke", lang, output=report.output, value=_mm(report.stroke))


def _ratio(report: Report, lang: Lang) -> Iterator[str]:
    if report.k is None or report.theta is None:
        if report.limits:
            yield _say("undetermined" if report.kind == "change-point" else "no ratio", lang)
    elif report.slow is None:
        yield _say("no quick return", lang)
    else:
        yield _say("theta", lang, theta=degrees(report.theta, lang), k=f"{report.k:.5g}")
        one, other = (number + 1 for number in report.slow)
        yield _say("slow", lang, one=one, other=other, driver=report.timed_by or report.driver)


def _gamma(report: Report, lang: Lang) -> Iterator[str]:
    least, alpha = report.gamma_min, report.alpha_max
    if least is None or alpha is None:
        yield _say("no gamma", lang)
    elif report.level:
        yield _say("level", lang)
    else:
        for end in report.critical:
            value = amount(report, end.driver, lang)
            gamma = degrees(end.gamma or 0.0, lang)
            yield _say("gamma", lang, gamma=gamma, how=_how(report, end, lang), driver=report.driver, value=value)
        values = ", ".join(amount(report, end.driver, lang) for end in report.least)
        words = {"gamma": degrees(least, lang), "alpha": degrees(alpha, lang)}
        yield _say("least", lang, **words, driver=report.driver, values=values)


def _dead(report: Report, lang: Lang) -> Iterator[str]:
    for driver, values in report.dead.items():
        if values:
            said = ", ".join(_mm(value) if driver == report.slide else degrees(value, lang) for value in values)
            yield _say("dead", lang, driver=driver, values=said)
        else:
            yield _say("no dead", lang, driver=driver)


def _advantage(report: Report, lang: Lang) -> Iterator[str]:
    found = report.advantage
    if found is None:
        return
    unit = " N/(N m)" if report.output_slides else ""
    endless = TEXT["endless"][lang] if found.endless else ""
    at = amount(report, found.at, lang)
    yield _say("advantage", lang, value=f"{found.least:.4g}{unit}", driver=report.driver, at=at, endless=endless)


# --- kinds and files -----------------------------------------------------------------------------


def family_lines(lang: Lang) -> Iterator[str]:
    """One line a kind: its name, and where the library has it."""
    for member in FAMILY:
        name = kind_name(report(member.linkage), lang)
        gap = ": " if lang == "en" else "："
        yield name + (gap + ", ".join(member.library) if member.library else "")


def titled(linkage: Linkage) -> Mechanism:
    """The linkage as a mechanism with its title and its file."""
    return filed(replace(linkage.mechanism(), title=TITLES[linkage.word]))


def held(mechanism: Mechanism, link: str) -> Mechanism:
    """The mechanism with another link (as people call it) held fast, with its title and its file. Raises NoFixing."""
    title: dict[Lang, str] = {
        lang: text.format(title=mechanism.headline(lang), link=link) for lang, text in FIXED.items()
    }
    notes = [_note(mechanism, driver, link) for driver in mechanism.drivers]
    return filed(replace(inverted(mechanism, link), title=title), notes)


def _note(mechanism: Mechanism, driver: Driver, fixed: str) -> str:
    """What becomes of a driver, in both languages."""
    key = "slide" if driver.kind == "slide" else "frame" if fixed in (driver.link, driver.from_link) else "moving"
    one, two = mechanism.called(driver.link), mechanism.called(driver.from_link)
    return " ".join(text.format(one=one, two=two) for text in DRIVEN[key].values())
