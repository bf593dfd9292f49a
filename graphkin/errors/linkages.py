"""Errors about linkages of four links: lengths that make none, mechanisms that hold none."""

from __future__ import annotations

from graphkin.errors.base import Choice, LocatedError

__all__ = ["CannotClose", "CannotDriveBy", "NoFixing", "NoLinkage", "NotALength", "OnlyStretched"]


class NotALength(LocatedError):
    """A length that is not positive, or no number."""

    what: str
    given: str
    en = "{where}: {what} is {given}. Lengths of links are positive numbers in mm (an offset may be 0 or negative)."
    zh = "{where}：{what} 为 {given}。杆长必须是正数（mm）；偏距可以为 0 或负数。"


class CannotClose(LocatedError):
    """Lengths that never make a closed loop."""

    long: str
    long_mm: float
    rest: str
    rest_mm: float
    en = (
        "{where}: the links do not reach each other: {long} = {long_mm:.6g} mm is more than {rest} = {rest_mm:.6g} mm. "
        "Shorten {long}, or lengthen the others."
    )
    zh = "{where}：各杆无法装配：{long} = {long_mm:.6g} mm 大于 {rest} = {rest_mm:.6g} mm。请缩短 {long} 或加长其余各杆。"


class OnlyStretched(LocatedError):
    """Lengths that close in one position only."""

    long: str
    rest: str
    long_mm: float
    en = (
        "{where}: {long} = {rest} = {long_mm:.6g} mm: the links close only when all lie in one line, and cannot move. "
        "Shorten {long}, or lengthen another."
    )
    zh = "{where}：{long} = {rest} = {long_mm:.6g} mm：各杆只能在拉成一直线时装配，不能运动。请缩短 {long} 或加长其余各杆。"


class NoLinkage(LocatedError):
    """A mechanism without any such linkage."""

    en = (
        "{where}: no four-bar, slider-crank or guide-bar linkage on the frame was found: no loop of the frame and "
        "three moving links with four revolute pairs, or three and one sliding pair. Mechanisms with cams, gears or "
        "two sliding pairs in the loop have no such report."
    )
    zh = "{where}：没有找到以机架为一构件的铰链四杆机构、曲柄滑块机构或导杆机构：没有由机架和三个活动构件组成、含四个转动副（或三个转动副和一个移动副）的闭环。环中含凸轮副、齿轮副或两个移动副的机构不作此分析。"


class NoFixing(Choice):
    """A link that cannot be made the frame."""

    en = "{where}: {given!r} is no link of a linkage found here that could become the frame. {hint}"
    zh = "{where}：{given!r} 不是此处可以改作机架的构件。{hint}"


class CannotDriveBy(Choice):
    """A driver that the linkage does not have."""

    en = "{where}: the linkage cannot be driven by {given!r}. {hint}"
    zh = "{where}：此机构不能以 {given!r} 为原动件。{hint}"
