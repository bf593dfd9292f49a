"""A linkage report in sentences."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.linkages.data import lengths
from graphkin.linkages.finding import Found
from graphkin.linkages.model import EVEN, FourBar, GuideBar, SliderCrank
from graphkin.linkages.parts import Position
from graphkin.linkages.phrases import BLOCKS, FAMILIES, HOW, KINDS, TEXT, WHY
from graphkin.linkages.report import Report

__all__ = ["amount", "degrees", "found_lines", "kind_name", "lines"]


def degrees(angle: float, lang: Lang = "en") -> str:
    """`32.984 deg`, `32.984°`."""
    value = f"{math.degrees(angle):.3f}".rstrip("0").rstrip(".")
    return f"{'0' if value == '-0' else value}{' deg' if lang == 'en' else '°'}"


def _mm(length: float) -> str:
    return f"{length * 1e3 + 0.0:.6g} mm"


def kind_name(report: Report, lang: Lang) -> str:
    """`crank-rocker`, `offset slider-crank`, `change-point linkage: parallelogram`."""
    kind = KINDS[report.kind][lang]
    on_frame = not isinstance(report.linkage, FourBar) and report.linkage.block
    if on_frame and report.kind in BLOCKS:
        return BLOCKS[report.kind][lang]
    if not report.family:
        return kind
    family = FAMILIES.get(report.family, KINDS.get(report.family, {"en": report.family, "zh": report.family}))[lang]
    if report.family in ("in-line", "offset"):
        return f"{family} {kind}" if lang == "en" else f"{family}{kind}"
    if report.family == "bar":
        return kind
    return f"{kind}: {family}" if lang == "en" else f"{kind}：{family}"


def found_lines(found: Found, report: Report, lang: Lang) -> Iterator[str]:
    """Lines of a linkage found in a mechanism: which links it is made of first."""
    links = ", ".join(found.links)
    yield TEXT["links"][lang].format(links=links)
    yield from lines(report, lang)
    if found.driven != "driver":
        key = "behind" if found.before is not None else found.driven
        yield TEXT[key][lang].format(driver=report.driver)


def lines(report: Report, lang: Lang) -> Iterator[str]:
    """What a linkage is and does, one sentence a line."""
    sizes = ", ".join(f"{name} = {_mm(value)}" for name, value in lengths(report.linkage).items())
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
    return _mm(value) if report.linkage.driver in ("slider", "slide") else degrees(value, lang)


def _place(report: Report, value: float, lang: Lang) -> str:
    slides = isinstance(report.linkage, SliderCrank) and report.linkage.driver != "slider"
    return _mm(value) if slides else degrees(value, lang)


def _parts(report: Report) -> dict[str, str]:
    """What the links are called."""
    names = list(lengths(report.linkage))
    common = {"driver": report.driver, "output": report.output}
    if isinstance(report.linkage, FourBar):
        return common | dict(zip(("crank", "coupler", "rocker", "frame"), names))
    if isinstance(report.linkage, SliderCrank):
        return common | dict(zip(("crank", "coupler"), names)) | {"rocker": report.output, "frame": ""}
    _, b, c = report.linkage.names
    return common | dict(zip(("crank", "frame"), names)) | {"rocker": c + b, "coupler": ""}


def _sums(report: Report, lang: Lang) -> str:
    """`AB + CD = 15 + 55 = 70 mm < BC + AD = 48 + 45 = 93 mm`."""
    sizes = lengths(report.linkage)
    gap = report.sum_ends - report.sum_middle
    sign = "=" if abs(gap) <= EVEN * (report.sum_ends + report.sum_middle) else "<" if gap < 0 else ">"

    def added(names: tuple[str, str]) -> str:
        shown = [name for name in names if name]
        terms = " + ".join("|e|" if name == "e" else name for name in shown)
        if len(shown) == 1:
            return terms
        return terms + " = " + " + ".join(f"{abs(sizes[name]) * 1e3:.6g}" for name in shown)

    key = "grashof" if isinstance(report.linkage, FourBar) else "lengths"
    return _say(
        key, lang, ends=added(report.ends), first=_mm(report.sum_ends), sign=sign, middle=added(report.middle),
        second=_mm(report.sum_middle),
    )  # fmt: skip


def _equal(report: Report, lang: Lang) -> Iterator[str]:
    """Links of one length each, where that is so."""
    sizes = [(name, value) for name, value in lengths(report.linkage).items() if name != "e"]
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
            f"{turn.first}–{frame if turn.second == 'frame' else turn.second}"
            for turn in report.turns if turn.full == full
        ]  # fmt: skip
        yield _say(key, lang, pairs=", ".join(pairs) or TEXT["nothing"][lang])


def _how(report: Report, end: Position, lang: Lang) -> str:
    """What is in line, or at right angles, in words."""
    names = _parts(report)
    middle = names.get("coupler") or ""
    driver = names["crank"] if isinstance(report.linkage, GuideBar | SliderCrank) else report.driver
    return HOW[end.how][lang].format(driver=driver, middle=middle)


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
    slides = slide_names(report)
    for driver, values in report.dead.items():
        if values:
            said = ", ".join(_mm(value) if driver in slides else degrees(value, lang) for value in values)
            yield _say("dead", lang, driver=driver, values=said)
        else:
            yield _say("no dead", lang, driver=driver)


def slide_names(report: Report) -> tuple[str, ...]:
    """Drivers that are told as displacements: the slider, the block along the bar."""
    last = tuple(report.dead)[-1]
    return () if isinstance(report.linkage, FourBar) else (last,)


def _advantage(report: Report, lang: Lang) -> Iterator[str]:
    found = report.advantage
    if found is None:
        return
    unit = " N/(N m)" if isinstance(report.linkage, SliderCrank) else ""
    endless = TEXT["endless"][lang] if found.endless else ""
    at = amount(report, found.at, lang)
    yield _say("advantage", lang, value=f"{found.least:.4g}{unit}", driver=report.driver, at=at, endless=endless)
