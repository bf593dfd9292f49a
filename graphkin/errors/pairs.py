"""Errors of sliding pairs, gears, rolling and cams."""

from __future__ import annotations

from graphkin.errors.base import LocatedError

__all__ = [
    "BlockOrPin", "CircleOrLine", "LineOnLine", "NeedsDirection", "NeedsTilt", "NoLine", "PinInCircle", "PointOnPoint",
    "SameCircles", "SameTwice", "SlidesOnItself",
]  # fmt: skip


class BlockOrPin(LocatedError):
    en = "{where}: say what slides: block and point for a sliding pair, or pin for a pin in a slot."
    zh = "{where}：请说明什么在滑动：移动副写 block 和 point，销槽写 pin。"


class PinInCircle(LocatedError):
    """A circular slot with a block in it, or with nothing."""

    en = (
        "{where}: centre and radius make a circular slot, in which a pin moves: give pin and guide. A block that "
        "slides in such a slot turns about its centre: leave the slide out and let the block's link have the centre, too."
    )
    zh = "{where}：centre 和 radius 表示圆弧槽，其中只能是销：请写 pin 和 guide。沿圆弧槽滑动的滑块绕槽的圆心转动：请删去该移动副，并让滑块所在构件也含圆心这一点（即铰接于圆心）。"


class SlidesOnItself(LocatedError):
    link: str
    en = "{where}: link {link} would slide on itself. Name another guide, or another block or pin."
    zh = "{where}：构件 {link} 不能在自身上滑动，请更换导路或滑块（销）。"


class NeedsTilt(LocatedError):
    link: str
    en = "{where}: block {link} has a direction of its own already. Add tilt, the angle from the guide's line to that direction."
    zh = "{where}：滑块 {link} 已有自身方向，请补充 tilt，即从导路到该方向的角度。"


class NeedsDirection(LocatedError):
    link: str
    en = "{where}: the direction of the line on link {link} is open. Add toward = a second point, or from = two points (and an angle)."
    zh = "{where}：构件 {link} 上导路的方向未定，请补充 toward（另一点），或 from（两点）及 angle。"


class NoLine(LocatedError):
    first: str
    second: str
    en = "{where}: {first} and {second} lie at one place, so they give no direction. Choose another point."
    zh = "{where}：{first} 与 {second} 重合，不能确定方向，请换一个点。"


class SameTwice(LocatedError):
    """A pair needs two different links (or centres)."""

    given: str
    en = "{where}: {given} stands there twice; a pair joins two different ones. Correct one."
    zh = "{where}：{given} 重复出现，运动副应联接两个不同的对象，请改正其一。"


class SameCircles(LocatedError):
    en = "{where}: one circle cannot lie inside another of the same radius. Correct a radius, or internal."
    zh = "{where}：半径相等的两圆不能内切，请改正半径或 internal。"


class CircleOrLine(LocatedError):
    circle: str
    line: str
    en = "{where}: give either a circle ({circle}) or a line ({line})."
    zh = "{where}：请给出圆（{circle}）或直线（{line}）之一。"


class LineOnLine(LocatedError):
    en = "{where}: a line against a line touches along its length. Make it a [[slide]], or one profile a circle."
    zh = "{where}：直线与直线是面接触，请改用 [[slide]]，或将其中一个廓线改为圆。"


class PointOnPoint(LocatedError):
    en = "{where}: two knife edges cannot stay in contact. Give one profile a radius, or make it a hinge."
    zh = "{where}：两个尖点不能保持接触，请给其中一个廓线以半径，或改为铰链。"
