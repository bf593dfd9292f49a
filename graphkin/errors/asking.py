"""Errors in what is asked of a mechanism at the command line: ranges of drivers, quantities, conditions."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import Choice, GraphkinError, Lang, Where

__all__ = ["BadPair", "BadRange", "NoPosition", "NoSuchDriver", "UnknownQuantity"]


class BadRange(GraphkinError):
    """A range of driver values that is none."""

    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} is no range. Write FROM:TO:STEP (0:360:10, or 50 mm:90 mm:5 mm), with FROM and TO "
        "different, STEP above 0, at most 1000 turns and 100 million steps; drivers that move together take equally many.",
        "zh": "{where}：{given!r} 不是有效的范围。请写成 起:止:步长（如 0:360:10 或 50 mm:90 mm:5 mm），起止不得相同，步长大于 0，"
        "最多 1000 转、一亿步；同时运动的各原动件步数必须相同。",
    }


class BadPair(GraphkinError):
    """Two values that belong together, written otherwise."""

    where: Where
    given: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} does not read as a pair. Write a point as X,Y (10,40), two points as 'X,Y X,Y', "
        "two angles as PHI:PSI (40:30).",
        "zh": "{where}：{given!r} 不是一对数值。点写成 X,Y（如 10,40），两点写成 'X,Y X,Y'，两个角写成 φ:ψ（如 40:30）。",
    }


class NoSuchDriver(Choice):
    """A driver that the mechanism does not have, or has no range left for."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: there is no driver {given} to move. {hint}",
        "zh": "{where}：没有可以运动的原动件 {given}。{hint}",
    }


class NoPosition(GraphkinError):
    """A sweep none of whose positions is reached."""

    where: Where
    driver: str
    low: str
    high: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: none of the positions asked for is reached: {driver} moves from {low} to {high} only. "
        "Ask for a range within, or with smaller steps.",
        "zh": "{where}：所要求的位置都不能到达：{driver} 只能在 {low} 至 {high} 之间运动。请改用其中的范围，或减小步长。",
    }


class UnknownQuantity(Choice):
    """A text that names no quantity."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: {given!r} names no quantity. Write for example `theta 3`, `omega 3`, `v C`, `a_k B3B2`, `s ram`, "
        "`omega 1 / omega 3`. {hint}",
        "zh": "{where}：{given!r} 不是一个量。请写成如 `theta 3`、`omega 3`、`v C`、`a_k B3B2`、`s ram`、`omega 1 / omega 3`。{hint}",
    }
