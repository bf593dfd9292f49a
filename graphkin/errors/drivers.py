"""Errors of drivers and poses: what they name, and how many there are."""

from __future__ import annotations

from graphkin.errors.base import AboutLinks, Choice, LocatedError

__all__ = [
    "DrivenFrame", "DrivenTwice", "JoinedToNothing", "NoDriver", "NoVector", "RepeatedDriver", "SameLink", "SayValue",
    "TooFewDrivers", "TooManyDrivers", "WhatIsDriven",
]  # fmt: skip


class NoDriver(LocatedError):
    en = "{where}: nothing is driven. Add a [[driver]], for example vector = \"AB\", angle = 60, omega = 10."
    zh = "{where}：没有原动件，请添加 [[driver]]，例如 vector = \"AB\"、angle = 60、omega = 10。"


class WhatIsDriven(LocatedError):
    """None of the keys that say what a driver or a pose is about; `keys` could."""

    keys: tuple[str, ...]
    en = "{where}: say what this is about with one of: {keys:,}."
    zh = "{where}：请用下列键之一指明对象：{keys:,}。"


class NoVector(Choice):
    """No link has both points; `possible` are vectors that links do have."""

    en = "{where}: no link has both points of {given}. {hint}"
    zh = "{where}：没有哪个构件同时具有 {given} 的两点。{hint}"


class DrivenFrame(LocatedError):
    given: str
    en = "{where}: {given} belongs to the frame, which does not move. Name a moving link's."
    zh = "{where}：{given} 属于机架，机架不能驱动，请改用活动构件。"


class SameLink(LocatedError):
    link: str
    en = "{where}: both directions belong to link {link}, so the angle between them never changes. Measure from another link."
    zh = "{where}：两个方向都在构件 {link} 上，夹角不变，请从另一构件量起。"


class SayValue(LocatedError):
    """A driver without its value, and no pose to stand for it."""

    key: str
    en = "{where}: the drawn position is open. Say {key}, or fix it with a [[pose]]."
    zh = "{where}：图示位置未定，请给出 {key}，或用 [[pose]] 确定。"


class DrivenTwice(LocatedError):
    given: str
    en = "{where}: {given} is driven twice: two drivers on one freedom. Remove one."
    zh = "{where}：{given} 被驱动两次，一个自由度只能有一个原动件，请删去其一。"


class TooFewDrivers(AboutLinks):
    """Freedoms that no driver takes."""

    freedoms: int
    drivers: int
    en = (
        "{where}: the mobility of this mechanism (its degrees of freedom) is {freedoms}, and drivers take "
        "{drivers} of it; still free: links {links}. Add a [[driver]] for one of them."
    )
    zh = "{where}：机构有 {freedoms} 个自由度，却只有 {drivers} 个原动件；构件 {links} 仍可自由运动。请为其中之一增加 [[driver]]。"


class JoinedToNothing(TooFewDrivers):
    """Freedoms that no driver takes, and points of one link alone that may have been meant as hinges."""

    points: tuple[str, ...]
    en = (
        "{where}: joined to nothing: {points}, which no second link has. So the mobility of this mechanism "
        "(its degrees of freedom) is {freedoms}, and drivers take {drivers} of it; still free: links {links}. "
        "A letter that two links share is a hinge: let them share one, or add a [[driver]]."
    )
    zh = "{where}：{points} 各只属于一个构件，未与其他构件相连；机构因此有 {freedoms} 个自由度，却只有 {drivers} 个原动件，构件 {links} 仍可自由运动。两构件共有的字母即为转动副：请用同一字母，或增加 [[driver]]。"


class TooManyDrivers(LocatedError):
    """More drivers than freedoms."""

    freedoms: int
    drivers: int
    driver: str
    en = (
        "{where}: {drivers} drivers are too many, as the mobility of this mechanism (its degrees of freedom) is "
        "{freedoms}; remove driver {driver}."
    )
    zh = "{where}：机构只有 {freedoms} 个自由度，却有 {drivers} 个原动件；原动件 {driver} 是多余的。请删去。"


class RepeatedDriver(AboutLinks):
    """As many drivers as freedoms, but two of them move the same one."""

    freedoms: int
    driver: str
    en = (
        "{where}: driver {driver} moves what the drivers before it move already, while still free are links "
        "{links} (the mobility of this mechanism, its degrees of freedom, is {freedoms}). Drive one of those instead."
    )
    zh = "{where}：原动件 {driver} 与前面的原动件驱动同一自由度，而构件 {links} 仍可自由运动（机构有 {freedoms} 个自由度）。请改为驱动后者。"
