"""The closed table of units, and what is said about everything else."""

from __future__ import annotations

import math

import pytest

from graphkin.errors import GraphkinError, NotANumber, NoUnit, OtherDimension, OutOfRange, UnknownUnit
from graphkin.files.values import UNITS, read_quantity
from graphkin.model.mechanism import Dimension

GOOD: list[tuple[float | str, Dimension, float]] = [
    (24, "length", 0.024),
    (24.0, "length", 0.024),
    ("24 mm", "length", 0.024),
    ("2.4cm", "length", 0.024),
    ("24 in", "length", 0.6096),
    ("-1 ft", "length", -0.3048),
    ("1e-3 m", "length", 0.001),
    (" +.5 m ", "length", 0.5),
    (1e9, "length", 1e6),
    (180, "angle", math.pi),
    ("1.2 rad", "angle", 1.2),
    ("1 rev", "angle", 2 * math.pi),
    ("45°", "angle", math.pi / 4),
    ("180 °/s", "angular velocity", math.pi),
    ("180 °/s^2", "angular acceleration", math.pi),
    (10, "angular velocity", 10.0),
    ("60 rpm", "angular velocity", 2 * math.pi),
    ("60 r/min", "angular velocity", 2 * math.pi),
    ("60 rev/min", "angular velocity", 2 * math.pi),
    ("60 r / min", "angular velocity", 2 * math.pi),
    ("180 deg/s", "angular velocity", math.pi),
    ("1 rev/s", "angular velocity", 2 * math.pi),
    ("60 rpm/s", "angular acceleration", 2 * math.pi),
    ("60 r/min/s", "angular acceleration", 2 * math.pi),
    ("180 deg/s²", "angular acceleration", math.pi),
    ("180 deg/s^2", "angular acceleration", math.pi),
    ("180 deg/s2", "angular acceleration", math.pi),
    (2, "velocity", 2.0),
    ("50 mm/s", "velocity", 0.05),
    ("36 km/h", "velocity", 10.0),
    (2, "acceleration", 2.0),
    ("12 in/s^2", "acceleration", 0.3048),
]


@pytest.mark.parametrize(("given", "dimension", "expected"), GOOD)
def test_quantity_in_si(given: float | str, dimension: Dimension, expected: float) -> None:
    assert read_quantity(given, dimension) == pytest.approx(expected, rel=1e-15)


BAD: list[tuple[float | str, Dimension, type[GraphkinError], str, str]] = [
    ("24 yd", "length", UnknownUnit, "mm, cm, m, in, ft", "不认识单位 yd"),
    ("24 m/s", "length", OtherDimension, "unit of a velocity, but a length", "速度的单位，此处应为长度"),
    ("10 rad", "angular velocity", OtherDimension, "rad/s, deg/s, °/s, rev/s, rpm, r/min, rev/min", "角度的单位"),
    ("10 mm/s²", "velocity", OtherDimension, "unit of an acceleration", "加速度的单位"),
    ("24", "length", NoUnit, '"24" has no unit', "没有单位"),
    ("mm", "length", NotANumber, '"mm" does not read as a number', "不能读作"),
    ("", "length", NotANumber, '"" does not read', "不能读作"),
    ("1,5 mm", "length", UnknownUnit, ",5mm", ",5mm"),
    ("nan mm", "length", NotANumber, "nan", "nan"),
    ("٣ mm", "length", NotANumber, "٣", "٣"),
    (math.nan, "length", OutOfRange, "nan is not a finite number", "nan 不是"),
    (math.inf, "angle", OutOfRange, "inf", "inf"),
    ("1e400 mm", "length", OutOfRange, "1e400 mm", "1e400 mm"),
    (10**400, "length", OutOfRange, "1e999", "1e999"),
    (-(10**400), "length", OutOfRange, "-1e999", "-1e999"),
    (1e16, "length", OutOfRange, "reasonable size", "大小合理"),
]


@pytest.mark.parametrize(("given", "dimension", "kind", "english", "chinese"), BAD)
def test_what_is_not_a_quantity(
    given: float | str, dimension: Dimension, kind: type[GraphkinError], english: str, chinese: str
) -> None:
    with pytest.raises(kind) as caught:
        read_quantity(given, dimension)
    assert english in caught.value.message("en")
    assert chinese in caught.value.message("zh")


def test_a_unit_belongs_to_one_quantity() -> None:
    units = [unit for table in UNITS.values() for unit in table]
    assert len(units) == len(set(units))


@pytest.mark.parametrize("dimension", UNITS)
def test_a_bare_number_is_in_the_first_unit(dimension: Dimension) -> None:
    first = next(iter(UNITS[dimension]))
    assert read_quantity(7, dimension) == read_quantity(f"7 {first}", dimension)


def test_an_integer_too_long_to_print() -> None:
    with pytest.raises(OutOfRange, match="1e999"):
        read_quantity(16**6000, "length")
