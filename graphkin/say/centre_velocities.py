"""The velocities that instant centres give, with figures: each sum of a lever, then all that is asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import hypot
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction.drafting import Reckon
from graphkin.errors import Lang, listed
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import Seen, common_link
from graphkin.model.quantities import Moving, Quantity, Rotation, parts
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.centre_steps import CentreReader, centre_rows
from graphkin.say.entry import Calculation, Entry, Heading, Sentence, text_lines
from graphkin.say.figures import Formula, Operand, figures
from graphkin.say.numbers import degrees, heading, number, sense
from graphkin.say.solution_goal import SolutionGoal
from graphkin.say.text_table import table
from graphkin.studies.centres import Centres, advantages
from graphkin.studies.centres.lever_board import BoardNumber, Lever
from graphkin.studies.centres.levers import Levers, given_drivers

_FORMS: Mapping[str, tuple[str, Callable[..., Formula | str]]] = {
    "same": ("{}", lambda value: ""),
    "lever": ("{} {}/{}", lambda rate, arm, other: rate * arm / other),
    "speed": ("{} {} {}", lambda rate, arm, scale: rate * arm * scale),
    "rate": ("{}/({} {})", lambda speed, arm, scale: speed / (arm * scale)),
}
"""By the rule of a sum, how it is written with names and with figures."""
_RATES = ("alpha", "a", "a_n", "a_t", "a_k", "a_r")


def centre_lines(found: Centres, lang: Lang) -> Iterator[str]:
    """All that there is of them: a table, the lines that give them, the velocities and advantages that follow."""
    mechanism = found.method.mechanism
    yield "  ".join(dict.fromkeys((mechanism.name, mechanism.headline(lang))))
    yield from table(list(centre_rows(found, lang)))
    yield ""
    yield from text_lines(centre_entries(found, lang), lang)
    yield from advantage_lines(found, lang)


def shorter_road(goal: SolutionGoal, number: int) -> Iterator[Entry]:
    """The instant centres asked for, then the velocities that a driven link's contact gives at once."""
    assert goal.centred is not None
    yield from goal.centred.entries(number)
    if goal.pushed:
        reader, scale = goal.centred.reader, goal.reading.scales["length"]
        levers = LeverReader(reader, Levers(reader.found, scale))
        levers.levers.start(goal.reading.mechanism.drivers[0])
        yield Sentence(reader.say("centres.shorter", scale=Operand(scale).text()))
        yield from dict.fromkeys(entry for asked in goal.pushed.values() for entry in _answer(levers, *asked))
        yield Sentence(reader.say("centres.second way"))


def centre_entries(found: Centres, lang: Lang, scale: float | None = None) -> Iterator[Entry]:
    """All centres at one position with the lines that give them, and the velocities asked for with their figures.

    scale  of the drawing from which lengths are taken [m/mm]; the file's own, or 0.001, where left out
    """
    reader = CentreReader(found, lang)
    yield Heading(found.method.mechanism.headline(lang))
    yield from reader.entries(found.centring.stages, found.without)
    yield from _velocities(reader, scale or found.method.mechanism.scales.get("length", 0.001))


def advantage_lines(found: Centres, lang: Lang) -> Iterator[str]:
    """The mechanical advantage of each link against the driver, by the ratios of the centres' distances."""
    mechanism = found.method.mechanism
    driver = given_drivers(mechanism)[0]
    for link, value in advantages(found).items():
        senses = say("centres.same", lang) if value > 0 else say("centres.opposite", lang)
        out, drives = (mechanism.called(one) for one in (link, driver.link))
        words = {"out": names.point(out), "driver": names.point(drives), "senses": senses}
        ratio = f"{names.of_link('ω', drives)}/{names.of_link('ω', out)}"
        yield "  " + say("centres.advantage", lang, value=number(abs(value)), ratio=ratio, **words)


@frozen
class LeverReader:
    """Motions worked out from centres, about to be worded."""

    reader: CentreReader
    levers: Levers

    def entry(self, lever: Lever, name: str = "") -> Entry:
        """A calculation, or why there is none. name: of a point's velocity, as it was asked for."""
        if (result := lever.sum) is not None:
            value, meant = float(self.levers.board.numbers[result.name].real), self.levers.meant[result.name]
            formulas, numbers = self._formulas(lever, result)
            unit = "rad/s" if meant.kind in ("omega", "against") else "m/s"
            note = self._note(lever, meant) if value else ""
            return Calculation(name or self._symbol(result.name), formulas, numbers, value, unit, note)
        if lever.stage.say == "together":
            words = {"first": self.reader.link(lever.base), "second": self.reader.link(lever.link)}
            return Sentence(self.reader.say("centres.together", name=self._shared(lever), **words))
        return Sentence(self.reader.say("centres.not told", name=self.rate(lever.link)))

    def rate(self, link: str) -> str:
        """`ω3`."""
        return names.of_link("ω", self.reader.mechanism.called(link))

    def _symbol(self, name: str) -> str:
        """The symbol of a number on the board: `ω3`, `v_C`, `P13P34`, `μ_l`."""
        meant, called = self.levers.meant[name], self.reader.mechanism.called
        match meant.kind:
            case "omega":
                return self.rate(meant.of)
            case "against":
                return names.relative("ω", called(meant.of), called(meant.other))
            case "speed":
                return "v_" + self.reader.link(meant.of)
            case "velocity":
                return f"v_{names.point(meant.of)}"
            case "slide":
                return "ṡ"
            case "length":
                return self._stretch(meant.of, meant.other)
            case "scale":
                return names.SCALE["position"]
            case _:
                assert_never(meant.kind)

    def _stretch(self, *ends: str) -> str:
        """`P13P34`, `P13E`: the line between two centres, or from one to a point; `BC` between two points."""
        letters = self.levers.letters
        first, second = (letters.get(end, end) for end in ends)
        if letters.keys() >= {*ends}:
            return names.pair(first, second)
        plain = all(len(names.point(end)) == 1 or names.point(end)[1:].isdigit() for end in ends if end not in letters)
        return names.point(first) + ("" if plain else " ") + names.point(second)

    def _formulas(self, lever: Lever, result: Reckon) -> tuple[tuple[str, ...], Formula | str]:
        """The formulas, and the last one with its figures."""
        if lever.stage.say == "triangle":
            return (), ""
        pattern, figured = _FORMS[result.rule]
        formula = pattern.format(*map(self._symbol, result.of))
        numbers = figured(*figures(*(float(self.levers.board.numbers[name].real) for name in result.of)))
        match lever.stage.say:
            case "pushed":
                return (f"v_{self._shared(lever)}", formula), numbers
            case "point" if not self.levers.turning[lever.link]:
                return ((formula,) if self.levers.value(lever.link) else ()), ""
            case _:
                return (formula,), numbers

    def _shared(self, lever: Lever) -> str:
        return names.point(self.levers.found.name(lever.base, lever.link))

    def _note(self, lever: Lever, meant: BoardNumber) -> str:
        """The sense of a rotation, or the direction of a motion."""
        levers, say, lang, link = self.levers, self.reader.say, self.reader.lang, lever.link
        match lever.stage.say:
            case "levered":
                outside = levers.omega(lever.base) * levers.omega(link) > 0
                ends = listed([names.point(levers.found.name(FRAME, one)) for one in (lever.base, link)], lang)
                words = {"sense": sense(levers.omega(link), lang), "centre": self._shared(lever), "ends": ends}
                return say("centres.sense", which=not outside, **words)
            case "alike":
                return say("centres.sense alike", sense=sense(levers.omega(link), lang), centre=self._shared(lever))
            case "pushed" | "triangle":
                phrases = ["centres.triangle", "centres.along"][lever.stage.say == "pushed" :]
                return say("common.and").join([*map(say, phrases), heading(degrees(levers.way(link)), lang)])
            case "glides":
                return ""
            case "point" | "pair":
                across = [f"⊥{self._stretch(levers.found.name(FRAME, link), meant.of)}"]
                across = across if lever.stage.say == "point" and levers.turning[link] else []
                return say("common.and").join([*across, heading(degrees(levers.moved(meant, link)), lang)])
            case _:
                return sense(levers.turned(meant), lang)


def _velocities(reader: CentreReader, scale: float) -> Iterator[Entry]:
    """The velocities that the file asks for, or all rotations where it asks for none; scale of the drawing [m/mm]."""
    yield Heading(reader.say("centres.using"))
    if not any(driver.rate for driver in reader.mechanism.drivers):
        yield Sentence(reader.say("centres.resting"))
        return
    yield Sentence(reader.say("centres.scale", scale=names.SCALE["position"], value=number(scale)))
    levers = LeverReader(reader, Levers(reader.found, scale))
    drivers = given_drivers(reader.mechanism)
    yield Sentence(reader.say("centres.given", what=reader.say("common.list").join(map(reader.given, drivers))))
    yield from map(levers.entry, levers.levers.given())
    lines = set[str]()
    asked = {text.strip(): parts(reader.mechanism, text) for text in reader.mechanism.ask}
    if not any(halves and halves[0].word in ("omega", "v") for halves in asked.values()):
        links = [link for link in reader.mechanism.moving if link not in {driver.link for driver in drivers}]
        asked |= {f"omega {link}": (Rotation("omega", link, link),) for link in links}
    for halves in asked.values():
        for entry in _quotient(levers, *halves) if len(halves) == 2 else _answer(levers, *halves):
            line = entry.text if isinstance(entry, Calculation | Sentence) else ""
            if line not in lines:
                lines.add(line)
                yield entry
    rates = [text for text, halves in asked.items() if halves and halves[0].word in _RATES]
    if rates:
        yield Sentence(reader.say("centres.no accelerations", names=listed(map(names.symbols, rates), reader.lang)))


def _answer(levers: LeverReader, *quantities: Quantity) -> Iterator[Entry]:
    for quantity in quantities:
        if isinstance(quantity, Rotation) and quantity.word == "omega":
            if (path := levers.levers.path(quantity.link)) is None:
                yield Sentence(levers.reader.say("centres.not told", name=levers.rate(quantity.link)))
                continue
            yield from map(levers.entry, levers.levers.along(path))
            if not levers.levers.turning[quantity.link]:
                yield Calculation(levers.rate(quantity.link), (), "", 0.0, "rad/s")
        elif isinstance(quantity, Moving) and quantity.word == "v" and quantity.seen_from is None:
            yield from _of_site(levers, quantity.of, quantity.site)
        elif isinstance(quantity, Moving) and quantity.word == "v" and quantity.seen_from is not None:
            yield from _relative(levers, quantity.of, quantity.site, quantity.seen_from)


def _of_site(levers: LeverReader, text: str, site: Seen) -> Iterator[Entry]:
    """`v C` of a point: of the links that have it, the frame, then one with known motion, then one within reach."""
    owners, name = levers.reader.mechanism.owners[site.point], f"v_{names.point(text)}"
    nearest = sorted(owners, key=lambda link: (link != FRAME, link not in levers.levers.turning))
    for link in [site.link] if site.explicit else nearest:
        if (path := levers.levers.path(link)) is not None:
            yield from map(levers.entry, levers.levers.along(path))
            yield levers.entry(levers.levers.of_point(site.point, link), name)
            return
    yield Sentence(levers.reader.say("centres.not told", name=name))


def _relative(levers: LeverReader, text: str, of: Seen, seen_from: Seen) -> Iterator[Entry]:
    """`v B3B2`, `v CB`: both velocities, and the difference of the two; on one link omega times the distance."""
    name, link = f"v_{names.point(text)}", common_link(levers.reader.mechanism, of, seen_from)
    link = link if of.point != seen_from.point else None
    links = [of.link, seen_from.link] if link is None else [link]
    paths = [path for one in links if (path := levers.levers.path(one)) is not None]
    if len(paths) < len(links):
        yield Sentence(levers.reader.say("centres.not told", name=name))
        return
    for path in paths:
        yield from map(levers.entry, levers.levers.along(path))
    if link is not None:
        yield levers.entry(levers.levers.of_pair(of.point, seen_from.point, link), name)
        return
    for site in (of, seen_from):
        label = f"v_{names.point(site.point)}{levers.reader.link(site.link)}"
        yield levers.entry(levers.levers.of_point(site.point, site.link), label)
    first, second = (complex(levers.levers.velocity(site.point, site.link)) for site in (of, seen_from))
    difference = abs(first - second)  # the third side of the triangle of both
    difference = difference if difference > 1e-6 * hypot(abs(first), abs(second)) else 0.0
    yield Calculation(name, (), "", difference, "m/s", levers.reader.say("centres.triangle") if difference else "")


def _quotient(levers: LeverReader, top: Quantity, bottom: Quantity) -> Iterator[Entry]:
    """omega_i / omega_j = P1jPij / P1iPij, or of what has been worked out."""
    values: list[tuple[str, float]] = []  # the names and the values of both, of a rotation with its sign
    for half in (top, bottom):
        answer = list(_answer(levers, half))
        yield from answer
        if isinstance(half, Rotation) and half.word == "omega" and half.link in levers.levers.turning:
            values.append((levers.rate(half.link), levers.levers.omega(half.link)))
        elif answer and isinstance(answer[-1], Calculation):
            values.append((answer[-1].name, answer[-1].value))
    if len(values) < 2 or values[1][1] == 0:
        return
    (one, first), (other, second) = values
    numbers = Operand(abs(first)) / Operand(abs(second))
    turning = top.word == "omega"
    note = levers.reader.say("centres.same" if first * second > 0 else "centres.opposite") if turning and first else ""
    yield Calculation(f"{one}/{other}", (), numbers, abs(first / second), "", note)
