"""Errors of a link's measures, and of links that cannot be what the file says."""

from __future__ import annotations

from graphkin.errors.base import Lang, LocatedError

__all__ = [
    "CannotMove", "CcwContradicts", "CcwOnLine", "Contradiction", "FrameNameTaken", "LooseLink", "MissingCcw",
    "NoPoints", "NoTriangle", "OneSpot", "RigidlyJoined", "ShapeAndMeasures", "TooFewMeasures", "TooManyPoints",
]  # fmt: skip


class TooFewMeasures(LocatedError):
    """`points` are those that stay free."""

    link: str
    points: tuple[str, ...]
    en = "{where}: too few measures: nothing fixes {points:,} in link {link}. Add lengths or angles."
    zh = "{where}：构件 {link} 的尺寸不足，点 {points:,} 未定，请补充长度或角度。"


class Contradiction(LocatedError):
    """`key` disagrees with the measures before it."""

    link: str
    key: str
    gap_mm: float
    en = "{where}: {key} disagrees with the other measures of link {link} by {gap_mm:.3g} mm. Correct it, or leave it out."
    zh = "{where}：{key} 与构件 {link} 的其他尺寸相差 {gap_mm:.3g} mm，请改正或删去。"


class NoTriangle(LocatedError):
    """One length is longer than the two others together."""

    keys: tuple[str, str, str]
    gap_mm: float
    en = "{where}: the lengths {keys:,} cannot close a triangle: {gap_mm:.3g} mm are lacking. Correct one."
    zh = "{where}：长度 {keys:,} 不能构成三角形，差 {gap_mm:.3g} mm，请改正其中之一。"


class MissingCcw(LocatedError):
    """The measures leave two mirror images."""

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


class ShapeAndMeasures(LocatedError):
    link: str
    key: str
    en = "{where}: link {link} has both shape and {key}. Give coordinates, or lengths and angles, not both."
    zh = "{where}：构件 {link} 同时给出了 shape 和 {key}；坐标与长度、角度只能用一种。"


class OneSpot(LocatedError):
    link: str
    en = "{where}: all points of link {link} lie at one place, so it has no direction. Move one."
    zh = "{where}：构件 {link} 的各点重合，没有方向，请移动其中一点。"


class NoPoints(LocatedError):
    link: str
    en = "{where}: link {link} has no points. Give a length such as AB = 40, or points = [\"B\"]."
    zh = "{where}：构件 {link} 没有点，请给出长度（如 AB = 40）或 points = [\"B\"]。"


class FrameNameTaken(LocatedError):
    link: str
    en = "{where}: {link} is the name of the frame. Name this link otherwise, or give [frame] another name."
    zh = "{where}：{link} 是机架的名称，请给此构件另取名称，或在 [frame] 中改 name。"


class LooseLink(LocatedError):
    link: str
    en = "{where}: link {link} is tied to nothing. Let it share a point with another link, or put it in a pair."
    zh = "{where}：构件 {link} 与其他构件没有联系，请让它与别的构件共点，或加入运动副。"


class CannotMove(LocatedError):
    link: str
    points: tuple[str, ...]
    en = "{where}: link {link} is hinged to the frame at {points:,}, so it cannot move. Keep one of them."
    zh = "{where}：构件 {link} 在 {points:,} 处都与机架铰接，不能运动，请只保留一处。"


class RigidlyJoined(LocatedError):
    """Two links that cannot move against each other."""

    first: str
    second: str
    points: tuple[str, ...]
    en = "{where}: links {first} and {second} are rigidly joined at {points:,}. Make them one link, or give one of the points another name."
    zh = "{where}：构件 {first} 与 {second} 在 {points:,} 处刚性相连，请合并为一个构件，或给其中一点另取名称。"


class TooManyPoints(LocatedError):
    link: str
    limit: int
    en = "{where}: link {link} has more than {limit} points. Give their coordinates with shape."
    zh = "{where}：构件 {link} 的点超过 {limit} 个，请用 shape 给出坐标。"
