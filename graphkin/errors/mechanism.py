"""Errors of the parts of a mechanism: measures of links, pairs, drivers and poses, in this order."""

from __future__ import annotations

from graphkin.errors.base import AboutLink, AboutLinks, AboutText, Choice, Lang, LocatedError


class TooFewMeasures(AboutLink):
    points: tuple[str, ...]
    en = "{where}: too few measures: nothing fixes {points:,} in link {link}. Add lengths or angles."
    zh = "{where}：构件 {link} 的尺寸不足，点 {points:,} 未定，请补充长度或角度。"


class Contradiction(AboutLink):
    key: str
    gap_mm: float
    en = "{where}: {key} disagrees with the other measures of link {link} by {gap_mm:.3g} mm. Correct it, or leave it out."
    zh = "{where}：{key} 与构件 {link} 的其他尺寸相差 {gap_mm:.3g} mm，请改正或删去。"


class NoTriangle(LocatedError):
    keys: tuple[str, str, str]
    gap_mm: float
    en = "{where}: the lengths {keys:,} cannot close a triangle: {gap_mm:.3g} mm are lacking. Correct one."
    zh = "{where}：长度 {keys:,} 不能构成三角形，差 {gap_mm:.3g} mm，请改正其中之一。"


class MissingCcw(LocatedError):
    triple: tuple[str, str, str]
    en = "{where}: the measures leave two mirror images. Add ccw = {one} or ccw = {other}, whichever runs counter-clockwise."
    zh = "{where}：现有尺寸对应互为镜像的两种形状，请按逆时针顺序补充 ccw = {one} 或 ccw = {other}。"

    def _words(self, lang: Lang) -> dict[str, object]:
        a, b, c = self.triple
        return super()._words(lang) | {"one": f'["{a}", "{b}", "{c}"]', "other": f'["{a}", "{c}", "{b}"]'}


class CcwContradicts(LocatedError):
    triple: tuple[str, ...]
    en = "{where}: {triple:,} cannot run counter-clockwise with the other measures and triples. Exchange two of the points."
    zh = "{where}：按其他尺寸和三点组，{triple:,} 不可能是逆时针顺序，请交换其中两点。"


class CcwOnLine(CcwContradicts):
    en = "{where}: {triple:,} lie on one line, so they run no way round. Leave this ccw out."
    zh = "{where}：{triple:,} 三点共线，没有顺逆之分，请删去此 ccw。"


class ShapeAndMeasures(AboutLink):
    key: str
    en = "{where}: link {link} has both shape and {key}. Give coordinates, or lengths and angles, not both."
    zh = "{where}：构件 {link} 同时给出了 shape 和 {key}；坐标与长度、角度只能用一种。"


class OneSpot(AboutLink):
    en = "{where}: all points of link {link} lie at one place, so it has no direction. Move one."
    zh = "{where}：构件 {link} 的各点重合，没有方向，请移动其中一点。"


class NoPoints(AboutLink):
    en = "{where}: link {link} has no points. Give a length such as AB = 40, or points = [\"B\"]."
    zh = "{where}：构件 {link} 没有点，请给出长度（如 AB = 40）或 points = [\"B\"]。"


class FrameNameTaken(AboutLink):
    en = "{where}: {link} is the name of the frame. Name this link otherwise, or give [frame] another name."
    zh = "{where}：{link} 是机架的名称，请给此构件另取名称，或在 [frame] 中改 name。"


class LooseLink(AboutLink):
    en = "{where}: link {link} is tied to nothing. Let it share a point with another link, or put it in a pair."
    zh = "{where}：构件 {link} 与其他构件没有联系，请让它与别的构件共点，或加入运动副。"


class CannotMove(AboutLink):
    points: tuple[str, ...]
    en = "{where}: link {link} is hinged to the frame at {points:,}, so it cannot move. Keep one of them."
    zh = "{where}：构件 {link} 在 {points:,} 处都与机架铰接，不能运动，请只保留一处。"


class RigidlyJoined(LocatedError):
    first: str
    second: str
    points: tuple[str, ...]
    en = "{where}: links {first} and {second} are rigidly joined at {points:,}. Make them one link, or give one of the points another name."
    zh = "{where}：构件 {first} 与 {second} 在 {points:,} 处刚性相连，请合并为一个构件，或给其中一点另取名称。"


class TooManyPoints(AboutLink):
    limit: int
    en = "{where}: link {link} has more than {limit} points. Give their coordinates with shape."
    zh = "{where}：构件 {link} 的点超过 {limit} 个，请用 shape 给出坐标。"


class BlockOrPin(LocatedError):
    en = "{where}: say what slides: block and point for a sliding pair, or pin for a pin in a slot."
    zh = "{where}：请说明什么在滑动：移动副写 block 和 point，销槽写 pin。"


class PinInCircle(LocatedError):
    en = (
        "{where}: centre and radius make a circular slot, in which a pin moves: give pin and guide. A block that "
        "slides in such a slot turns about its centre: leave the slide out and let the block's link have the centre, too."
    )
    zh = "{where}：centre 和 radius 表示圆弧槽，其中只能是销：请写 pin 和 guide。沿圆弧槽滑动的滑块绕槽的圆心转动：请删去该移动副，并让滑块所在构件也含圆心这一点（即铰接于圆心）。"


class SlidesOnItself(AboutLink):
    en = "{where}: link {link} would slide on itself. Name another guide, or another block or pin."
    zh = "{where}：构件 {link} 不能在自身上滑动，请更换导路或滑块（销）。"


class NeedsTilt(AboutLink):
    own: str  # `M→N`, or `+x` of the frame
    en = (
        "{where}: block {link} has a direction of its own already, {own}. Add tilt, the angle from the guide's line to "
        "that direction: 0 where it points along the line, 90 where it is a quarter turn counter-clockwise from it."
    )
    zh = "{where}：滑块 {link} 已有自身方向 {own}，请补充 tilt，即从导路到该方向的角度：与导路同向为 0，由导路逆时针转 90° 为 90。"


class NeedsSecondTilt(AboutLink):
    other: str  # the link of its first guide
    en = (
        "{where}: block {link} has a direction of its own already, that of the line on link {other} along which it "
        "slides, too. Add tilt, the angle from this guide's line to that one: 90 or -90 where they cross at right angles."
    )
    zh = "{where}：滑块 {link} 已有自身方向，即它在构件 {other} 上滑动的导路方向。请补充 tilt，即从本导路到该导路的角度：两导路垂直时为 90 或 -90。"


class NeedsDirection(AboutLink):
    en = "{where}: the direction of the line on link {link} is open. Add toward = a second point, or from = two points (and an angle)."
    zh = "{where}：构件 {link} 上导路的方向未定，请补充 toward（另一点），或 from（两点）及 angle。"


class NoLine(LocatedError):
    first: str
    second: str
    en = "{where}: {first} and {second} lie at one place, so they give no direction. Choose another point."
    zh = "{where}：{first} 与 {second} 重合，不能确定方向，请换一个点。"


class SameTwice(AboutText):
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


class NoDriver(LocatedError):
    en = "{where}: nothing is driven. Add a [[driver]], for example vector = \"AB\", angle = 60, omega = 10."
    zh = "{where}：没有原动件，请添加 [[driver]]，例如 vector = \"AB\"、angle = 60、omega = 10。"


class WhatIsDriven(LocatedError):
    keys: tuple[str, ...]
    en = "{where}: say what this is about with one of: {keys:,}."
    zh = "{where}：请用下列键之一指明对象：{keys:,}。"


class NoVector(Choice):
    en = "{where}: no link has both points of {given}. {hint}"
    zh = "{where}：没有哪个构件同时具有 {given} 的两点。{hint}"


class DrivenFrame(AboutText):
    en = "{where}: {given} belongs to the frame, which does not move. Name a moving link's."
    zh = "{where}：{given} 属于机架，机架不能驱动，请改用活动构件。"


class SameLink(AboutLink):
    en = "{where}: both directions belong to link {link}, so the angle between them never changes. Measure from another link."
    zh = "{where}：两个方向都在构件 {link} 上，夹角不变，请从另一构件量起。"


class SayValue(LocatedError):
    key: str
    en = "{where}: the drawn position is open. Say {key}, or fix it with a [[pose]]."
    zh = "{where}：图示位置未定，请给出 {key}，或用 [[pose]] 确定。"


class DrivenTwice(AboutText):
    en = "{where}: {given} is driven twice: two drivers on one freedom. Remove one."
    zh = "{where}：{given} 被驱动两次，一个自由度只能有一个原动件，请删去其一。"


class TooFewDrivers(AboutLinks):
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
    zh = "{where}：{points} 只在一个构件上，未与其他构件相连；机构因此有 {freedoms} 个自由度，却只有 {drivers} 个原动件，构件 {links} 仍可自由运动。两构件共有的字母即为转动副：请用同一字母，或增加 [[driver]]。"


class TooManyDrivers(LocatedError):
    freedoms: int
    drivers: int
    driver: str
    en = (
        "{where}: {drivers} drivers are too many, as the mobility of this mechanism (its degrees of freedom) is "
        "{freedoms}; remove driver {driver}."
    )
    zh = "{where}：机构只有 {freedoms} 个自由度，却有 {drivers} 个原动件；原动件 {driver} 是多余的。请删去。"


class RepeatedDriver(AboutLinks):
    freedoms: int
    driver: str
    en = (
        "{where}: driver {driver} moves what the drivers before it move already, while still free are links "
        "{links} (the mobility of this mechanism, its degrees of freedom, is {freedoms}). Drive one of those instead."
    )
    zh = "{where}：原动件 {driver} 与前面的原动件驱动同一自由度，而构件 {links} 仍可自由运动（机构有 {freedoms} 个自由度）。请改为驱动后者。"
