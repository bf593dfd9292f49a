"""Whoever puts the printed figures into a calculator gets the printed result, to its last digit: everywhere."""

from __future__ import annotations

import math
import re
from functools import cache
from math import cos, radians
from pathlib import Path

import book
import numpy as np
import pytest
from calculator import NUMBER, calculated, hold, last_digit
from golden import GOLDEN, LANGUAGES
from random_mechanisms import epicyclic

from graphkin.api import Drawing
from graphkin.files import library
from graphkin.marking import ruler
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.say import explain
from graphkin.say.catalogue import phrase
from graphkin.say.centre_velocities import centre_entries
from graphkin.say.entry import text_lines
from graphkin.say.figures import Operand, figures, joined_sum, squared, written
from graphkin.say.linkages import lines as linkage_lines
from graphkin.say.numbers import number
from graphkin.sheet import scales_of
from graphkin.studies.centres import centres
from graphkin.studies.linkages import FourBar, GuideBar, Linkage, SliderCrank, report


@cache
def explained(name: str, lang: str) -> list[str]:
    """As it is kept, which is as it is printed: test_golden sees to that."""
    return (Path(GOLDEN) / f"explain_{name}_--lang_{lang}.txt").read_text("utf-8").splitlines()


@cache
def centred(name: str, lang: str) -> list[str]:
    method = plan(library.load(name))
    return list(text_lines(centre_entries(centres(method, replay_all(method)), lang), lang))


@pytest.mark.parametrize("name", library.names())
def test_a_solution_is_worth_what_it_prints(name: str) -> None:
    counts = [hold(explained(name, lang)) for lang in LANGUAGES]
    assert counts[0] == counts[1] > 5


@pytest.mark.parametrize("name", library.names())
def test_centres_are_worth_what_they_print(name: str) -> None:
    counts = [hold(centred(name, lang)) for lang in LANGUAGES]
    assert counts[0] == counts[1] >= 1


def elsewhere(lines: list[str]) -> int:
    """The line from which on a solution tells answers at further positions; its end where there are none."""
    head = phrase("solution.elsewhere", "en")
    return next((k for k, line in enumerate(lines) if line.strip() == head), len(lines))


def rates(lines: list[str]) -> dict[str, str]:
    """What each calculation ends with, its unit and sense with it, by what it is called; at the first position."""
    lines = lines[: elsewhere(lines)]
    ends = [line.strip().split(" = ") for line in lines if " = " in line]
    return {parts[0]: found[0] for parts in ends if (found := re.match(rf"{NUMBER} (rad|m)/s", parts[-1]))}


@pytest.mark.parametrize("name", library.names())
def test_centres_and_polygons_say_one_figure(name: str) -> None:
    one, other = rates(explained(name, "en")), rates(centred(name, "en"))
    assert {what: one[what] for what in one.keys() & other.keys()} == {
        what: other[what] for what in one.keys() & other.keys()
    }


def test_something_is_said_by_both() -> None:
    assert any(rates(explained(name, "en")).keys() & rates(centred(name, "en")).keys() for name in library.names())


# --- read as a hand reads it --------------------------------------------------------------------


def by_hand(mechanism: Mechanism, scales: dict[str, float]) -> list[str]:
    method = plan(mechanism)
    found, read_by = ruler.as_drawn(method, replay_all(method), scales)
    lengths = scales | {"length": scales["position"]}
    return explain(method, found, lengths, "en", everything=True, ruler=read_by)


def scales(name: str) -> dict[str, float]:
    """Those of its sheet."""
    drawing = Drawing.of(library.load(name))
    return dict(scales_of(drawing.method, drawing.plot))


@pytest.mark.usefixtures("one_paper")
def test_a_train_read_by_hand_is_worth_what_it_prints() -> None:
    """Rotations that were read have not quite the ratio of the radii."""
    assert hold(Drawing.of(epicyclic(200)).explain("en", as_drawn=True)) > 5


@pytest.mark.many
@pytest.mark.parametrize("name", library.names()[::4])
def test_what_is_read_by_hand_is_worth_what_it_prints(name: str) -> None:
    lines = by_hand(library.load(name), scales(name))
    assert hold(lines) > 5
    readings = [line for line in lines if line.endswith("; hence")]
    assert readings or name == "s4-ex4"  # a train at a steady rate, without a vector equation
    for line in readings:
        assert all(2 * float(length) % 1 == 0 for length in re.findall(r"\d[\d.]*(?= mm)", line)), line
    assert not astray(lines)


def astray(lines: list[str]) -> list[str]:
    """Answers of vectors and rotations that are another figure than what the solution has found."""
    start, beside = lines.index("Answer"), lines.index("Beside the exact values")
    end = min(beside, elsewhere(lines))
    assert len([line for line in lines[start:end] if line.startswith("  ")]) == len(lines[beside:]) - 1
    found = {part for line in lines[:start] for part in re.findall(rf"{NUMBER} (?:rad|m)/s²?", line)}
    told = [line for line in lines[start:end] if re.search(r" = .*/s²?", line) and "/" not in line.split(" = ")[0]]
    return [line for line in told if re.findall(rf"{NUMBER} (?:rad|m)/s²?", line)[-1] not in found]


def test_example_3_1_as_the_book_reads_it() -> None:
    """27, 32 and 43 mm."""
    scales = {"position": 0.001, "velocity": 0.01, "acceleration": 0.1}
    text = "\n".join(by_hand(book.example(), scales))
    assert "Measured: pb3 = 27 mm, b2b3 = 32 mm" in text
    assert "0.01 × 27/(0.001 × 69) = 3.913 rad/s" in text
    assert "Measured: n3′b3′ = 43 mm, k′b3′ = 2 mm" in text


@pytest.mark.parametrize("name", ["ex3-1", "ex3-2", "p3-12", "p3-22", "p3-17"])
def test_a_finer_ruler_reads_what_is_right(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ruler, "READ_MM", 1e-9)
    method = plan(library.load(name))
    plot = replay_all(method)
    found, _ = ruler.as_drawn(method, plot, {"position": 0.001, "velocity": 0.01, "acceleration": 0.1})
    for link, rate in plot.alpha.items():
        assert found.alpha[link] == pytest.approx(rate, rel=1e-6, abs=1e-6 * max(map(abs, plot.alpha.values())))


# --- linkages -----------------------------------------------------------------------------------

LENGTHS = (
    FourBar(0.015, 0.048, 0.055, 0.045), FourBar(0.0212345, 0.0481, 0.0557, 0.0453), FourBar(0.04, 0.06, 0.03, 0.06, driver="rocker"),
    FourBar(0.03, 0.03, 0.03, 0.03), SliderCrank(0.02, 0.065, -0.015), SliderCrank(0.02, 0.065, 0.0), SliderCrank(0.02, 0.065, 0.0312345),
    GuideBar(0.03, 0.1, 0.0), GuideBar(0.03, 0.1, 0.0123),
)  # fmt: skip


@pytest.mark.parametrize("command", ["linkage", "find", "design"])
def test_what_is_computed_is_worth_what_it_prints(command: str) -> None:
    texts = {path.name: path.read_text("utf-8") for path in Path(GOLDEN).glob(f"{command}_*.txt")}
    counts = {name: hold(text.replace("180° ×", "180 ×").splitlines()) for name, text in texts.items()}
    en, zh = (sorted(count for name, count in counts.items() if f"_{lang}." in name) for lang in LANGUAGES)
    assert en == zh
    assert en


@pytest.mark.parametrize("linkage", LENGTHS, ids=str)
def test_a_linkage_is_worth_what_it_prints(linkage: Linkage) -> None:
    told = [[*linkage_lines(report(linkage), lang)] for lang in LANGUAGES]
    counts = [hold(lines) for lines in told]
    assert counts[0] == counts[1] >= 1
    cosines = [re.findall(r"cos γ = .* = ([\d.]+)[,，] ?γ = ([\d.]+)°", line) for line in told[0]]
    assert all(float(found) == pytest.approx(cos(radians(float(angle))), abs=2e-5) for (found, angle), in filter(None, cosines))


# --- formulas -----------------------------------------------------------------------------------


def test_more_digits_where_four_do_not_suffice() -> None:
    speed, scale = figures(1.50042, 0.05)
    assert written(speed / scale, 1.50042 / 0.05) == "1.5004/0.05"
    assert written(speed * scale, 1.50042 * 0.05) == "1.5004 × 0.05"


@pytest.mark.parametrize("values", [(9.42478, 0.185389), (21.9911, 34.29, 23.1799), (0.273392, 0.41)])
def test_a_factor_is_its_value_rounded(values: tuple[float, ...]) -> None:
    """2 × 9.42478 × 0.185389 is 3.494 to four digits; 9.4247 × 0.18538, which give it, too, are neither of them right."""
    rng = np.random.default_rng(7)
    for scale in (1.0, *rng.uniform(0.5, 2.0, 200)):
        own = [value * scale for value in values]
        one, *others = figures(*own)
        product = 2.0 * math.prod(own)
        formula = Operand(2.0) * one
        for other in others:
            formula = formula * other
        text = written(formula, product)
        for figure, value in zip(text.split(" × ")[1:], own, strict=True):
            assert abs(float(figure) - value) <= 0.5 * last_digit(figure) * (1 + 1e-6), text
        assert abs(calculated(text) - float(number(product))) <= 0.5 * last_digit(number(product)) * (1 + 1e-6)


def test_brackets_stand_where_they_are_needed() -> None:
    a, b, c, d = figures(1, -2, 3, 4)
    assert (a * b / (c * d)).text() == "1 × (−2)/(3 × 4)"
    assert (a - (b + c)).text() == "1 − (−2 + 3)"
    assert (a * (c - d)).text() == "1 × (3 − 4)"
    assert (-(a / c)).text() == "−1/3"
    assert (squared(2.5) * a).text() == "2.5² × 1"
    assert joined_sum([(-1, Operand(0.49)), (1, Operand(2.0)), (-1, Operand(-3.0))]).text() == "−0.49 + 2 − (−3)"
    assert calculated((-(a - c)).text()) == (-(a - c)).worth(4) == 2


def test_zeros_at_the_end_are_kept_of_what_is_not_exact() -> None:
    assert Operand(9.1).text() == "9.1"
    assert Operand(9.1002).text() == "9.100"
    assert Operand(0.1000004).text(6) == "0.100000"
    assert Operand(99.9996).text() == "100.0"
    assert Operand(1.20004e-5).text() == "0.00001200"
