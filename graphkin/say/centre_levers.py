"""The levers between centres in words: each sum with its formula, its figures, and the sense of what it gives."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import assert_never

from graphkin.base.value import frozen
from graphkin.construction.drafting import Reckon
from graphkin.model.mechanism import FRAME
from graphkin.say import names
from graphkin.say.catalogue import say
from graphkin.say.centre_steps import CentreReader
from graphkin.say.entry import Calculation, Entry, Sentence
from graphkin.say.figures import Formula, figures
from graphkin.say.numbers import degrees
from graphkin.studies.centres.lever_board import BoardNumber, Lever
from graphkin.studies.centres.levers import Levers

FORMS: Mapping[str, tuple[str, Callable[..., Formula | str]]] = {
    "same": ("{}", lambda value: ""),
    "lever": ("{} {}/{}", lambda rate, arm, other: rate * arm / other),
    "speed": ("{} {} {}", lambda rate, arm, scale: rate * arm * scale),
    "rate": ("{}/({} {})", lambda speed, arm, scale: speed / (arm * scale)),
}
"""By the rule of a sum, how it is written with names and with figures."""


@frozen
class LeverReader:
    """Motions worked out from centres, about to be worded."""

    reader: CentreReader
    levers: Levers

    def entries(self, levers: Iterable[Lever]) -> list[Entry]:
        """One entry each."""
        return [self.entry(lever) for lever in levers]

    def entry(self, lever: Lever, name: str = "") -> Entry:
        """A calculation, or why there is none. name: of a point's velocity, as it was asked for."""
        if (found := lever.sum) is not None:
            return self.calculation(lever, found, name)
        if lever.stage.say == "together":
            words = {"first": self.reader.link(lever.base), "second": self.reader.link(lever.link)}
            return Sentence(self.reader.say("centres.together", name=self._shared(lever), **words))
        return Sentence(self.reader.say("centres.not told", name=self.rate(lever.link)))

    def calculation(self, lever: Lever, found: Reckon, name: str = "") -> Calculation:
        value = float(self.levers.board.numbers[found.name])
        formulas, numbers = self._formulas(lever, found)
        meant = self.levers.meant[found.name]
        unit = "rad/s" if meant.kind in ("omega", "against") else "m/s"
        note = self._note(lever, meant) if value else ""
        return Calculation(name or self.symbol(found.name), formulas, numbers, value, unit, note)

    # --- names ----------------------------------------------------------------------------------

    def rate(self, link: str) -> str:
        """`ω3`."""
        return names.of_link("ω", self.reader.mechanism.called(link))

    def symbol(self, name: str) -> str:
        """What a number is the size of: `ω3`, `v_C`, `P13P34`, `μ_l`."""
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
        plain = all(names.point(end)[1:].isdigit() for end in ends if end not in letters)
        return names.point(first) + ("" if plain else " ") + names.point(second)

    def _formulas(self, lever: Lever, found: Reckon) -> tuple[tuple[str, ...], Formula | str]:
        """The formulas, and the last one with its figures."""
        if lever.stage.say == "triangle":
            return (), ""
        names_in, figured = FORMS[found.rule]
        formula = names_in.format(*(self.symbol(name) for name in found.of))
        numbers = figured(*figures(*(float(self.levers.board.numbers[name]) for name in found.of)))
        match lever.stage.say:
            case "pushed":
                return (f"v_{self._shared(lever)}", formula), numbers
            case "point" if not self.levers.turning[lever.link]:
                return ((formula,) if self.levers.value(lever.link) else ()), ""
            case _:
                return (formula,), numbers

    # --- notes ----------------------------------------------------------------------------------

    def sense(self, omega: float) -> str:
        return say("common.ccw" if omega > 0 else "common.cw", self.reader.lang)

    def _shared(self, lever: Lever) -> str:
        return self.reader.centre(self.levers.found.name(lever.base, lever.link))

    def _note(self, lever: Lever, meant: BoardNumber) -> str:
        """The sense of a rotation, or the direction of a motion."""
        levers, say, link = self.levers, self.reader.say, lever.link
        match lever.stage.say:
            case "levered":
                outside = levers.omega(lever.base) * levers.omega(link) > 0
                ends = self._stretch(*(levers.found.name(FRAME, one) for one in (lever.base, link)))
                key = "centres.sense outside" if outside else "centres.sense between"
                return say(key, sense=self.sense(levers.omega(link)), centre=self._shared(lever), ends=ends)
            case "alike":
                return say("centres.sense alike", sense=self.sense(levers.omega(link)), centre=self._shared(lever))
            case "pushed":
                return say("centres.along", angle=degrees(levers.way(link)))
            case "triangle":
                along = say("centres.along", angle=degrees(levers.way(link)))
                return say("centres.triangle") + say("common.and") + along
            case "glides":
                return ""
            case "point" | "pair":
                return self._of_point(lever, meant)
            case _:
                return self.sense(levers.turned(meant))

    def _of_point(self, lever: Lever, meant: BoardNumber) -> str:
        angle = degrees(self.levers.moved(meant, lever.link))
        if lever.stage.say == "point" and self.levers.turning[lever.link]:
            arm = self._stretch(self.levers.found.name(FRAME, lever.link), meant.of)
            return self.reader.say("centres.across", arm=arm, angle=angle)
        return self.reader.say("centres.at", angle=angle)
