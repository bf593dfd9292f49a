"""Errors in what is looked for: conditions, dimensions that are varied, limits."""

from __future__ import annotations

from graphkin.errors.base import Choice, Lang, LocatedError

__all__ = [
    "BadCondition", "CannotScale", "NegativeSize", "NoDimension", "NoLineOf", "NoUnitHere", "NotScaled", "OtherUnits",
]  # fmt: skip


class BadCondition(LocatedError):
    """A text that is no condition."""

    given: str
    en = (
        "{where}: {given!r} is no condition. Write for example `v C = 0`, `theta 5 = 30`, `omega 2 = omega 3`, "
        "`a E > 3 g`, `max v E`, `range theta 3`, `stroke s ram`, `slowest BC`, `v E = 0.5 by omega 1`."
    )
    zh = (
        "{where}：{given!r} 不是一个条件。请写成如 `v C = 0`、`theta 5 = 30`、`omega 2 = omega 3`、`a E > 3 g`、"
        "`max v E`、`range theta 3`、`stroke s ram`、`slowest BC`、`v E = 0.5 by omega 1`。"
    )


class OtherUnits(LocatedError):
    """Two quantities that cannot be equal, or a bare number with a unit."""

    first: str
    first_unit: str
    second: str
    second_unit: str
    en = "{where}: {first} is measured in {first_unit}, {second} in {second_unit}: they cannot be compared. Compare quantities of one kind."
    zh = "{where}：{first} 的单位是 {first_unit}，{second} 的单位是 {second_unit}，不能比较。请比较同类的量。"

    def _words(self, lang: Lang) -> dict[str, object]:
        bare = {"en": "plain numbers", "zh": "1（无量纲）"}[lang]
        words = super()._words(lang)
        return words | {key: bare for key in ("first_unit", "second_unit") if words[key] == "1"}


class NegativeSize(LocatedError):
    """A size that is to be negative."""

    quantity: str
    given: str
    en = (
        "{where}: {quantity} is the size of a vector and never {given}. Ask for a positive value; a sign has a "
        "meaning only for a point that a guide of the frame leads, along that guide."
    )
    zh = "{where}：{quantity} 是矢量的大小，不会等于 {given}。请给出正值；只有沿机架导路运动的点才有正负之分（沿导路方向）。"


class NoLineOf(Choice):
    """A link or a pair of points that makes no line on one moving link."""

    en = "{where}: {given!r} is no line of a moving link. Name two points of one link (`slowest BC`), or a link with two points. {hint}"
    zh = "{where}：{given!r} 不是某一活动构件上的直线。请写出同一构件上的两点（如 `slowest BC`），或至少有两点的构件。{hint}"


class NoUnitHere(LocatedError):
    """A unit after the value of a quotient."""

    given: str
    en = "{where}: a quotient is a plain number, and {given} is none. Leave the unit out."
    zh = "{where}：比值是无量纲的数，而 {given} 不是。请去掉单位。"


class NotScaled(LocatedError):
    """A quantity that does not depend on how fast the mechanism is driven."""

    quantity: str
    en = (
        "{where}: {quantity} does not depend on the speed of the drivers, so no speed gives it another value. "
        "Leave `by` out to look for positions, or ask for a velocity or an acceleration."
    )
    zh = "{where}：{quantity} 与原动件的速度无关，改变速度不能得到所要的值。要求位置时请去掉 `by`；否则请改问速度或加速度。"


class CannotScale(LocatedError):
    """A value that no speed of the driver gives at this position."""

    quantity: str
    value: str
    wanted: str
    en = (
        "{where}: here {quantity} is {value}, and no speed of the drivers makes it {wanted}: it grows with their "
        "speed (accelerations with its square) from nothing and keeps its sense. Ask for another value, or at another position."
    )
    zh = "{where}：此位置 {quantity} 为 {value}，原动件取任何速度都不能使它等于 {wanted}：它与速度成正比（加速度与速度的平方成正比），方向不变。请改用其他值或其他位置。"


class NoDimension(Choice):
    """A dimension that the file does not have."""

    en = (
        "{where}: the file has no dimension {given} with one number that could be varied. Write a length or an "
        "angle of a link (`AB`, `BDE`, `links.2.AB`) or a driver's name. {hint}"
    )
    zh = "{where}：文件中没有可以改变的单个尺寸 {given}。请写构件的长度或角度（`AB`、`BDE`、`links.2.AB`）或原动件的名称。{hint}"
