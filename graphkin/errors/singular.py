"""Errors of the analytic road."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, Where

__all__ = ["NoAssembly", "NotJoined", "SingularPosition"]


class SingularPosition(GraphkinError):
    """The drivers do not move the mechanism in one definite way here: a dead point or a change point.

    condition   reciprocal condition number of A in A y' = B, with lengths in units of the mechanism's size
    """

    where: Where
    condition: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the mechanism stands at a dead point or a change point (reciprocal condition "
        "{condition:.1e}), where the drivers give it no definite velocity. Move the driver a little.",
        "zh": "{where}：机构正处于死点或变点位置（条件数倒数 {condition:.1e}），原动件不能给出确定的速度。"
        "请稍微改变原动件的位置。",
    }


class NoAssembly(GraphkinError):
    """No position meets all lengths, angles and driver values at once.

    gap_mm   the smallest gap found that stays open [mm]
    """

    where: Where
    gap_mm: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the mechanism cannot be assembled with these lengths and driver values; "
        "a gap of {gap_mm:.3g} mm stays open. Change a length or move the driver.",
        "zh": "{where}：按给定的长度和原动件位置无法装配，最小缺口为 {gap_mm:.3g} mm。请改变某一长度或原动件的位置。",
    }


class NotJoined(GraphkinError):
    """No chain of pairs joins this link to the frame."""

    where: Where
    link: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: no chain of pairs joins link {link} to the frame. "
        "Let it share a point with another link, or add a slide.",
        "zh": "{where}：构件 {link} 没有通过任何运动副与机架相连。请让它与另一构件共用一点，或加一个移动副。",
    }
