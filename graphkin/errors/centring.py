"""Errors about instant centres: what has none, and velocities that no rigid body has."""

from __future__ import annotations

from typing import ClassVar

from graphkin.errors.base import Choice, Lang, LocatedError

__all__ = ["BadVelocities", "FrameStands", "NoBobillier", "NoCentrode", "NotOneBody", "OnePlace", "UnknownCentre"]


class NotOneBody(LocatedError):
    """Two velocities whose components along the line that joins their points differ."""

    first: str
    second: str
    one: float
    other: float
    en = (
        "{where}: {first} and {second} are not points of one rigid body: along {first}{second} the velocity of "
        "{first} has the component {one:.4g} m/s, that of {second} {other:.4g} m/s, and they must be equal. Correct one of them."
    )
    zh = (
        "{where}：{first}、{second} 不是同一刚体上的点：沿 {first}{second} 连线方向，v_{first} 的投影为 {one:.4g} m/s，v_{second} 的投影为 "
        "{other:.4g} m/s，二者必须相等（速度投影定理）。请改正其中之一。"
    )


class OnePlace(LocatedError):
    """Two points at one place, which tell no rotation."""

    first: str
    second: str
    en = "{where}: {first} and {second} lie at one place, so they do not tell how the body turns. Give another point."
    zh = "{where}：{first} 与 {second} 位于同一处，不能确定刚体的转动。请改用另一点。"


class BadVelocities(LocatedError):
    """A text that gives no two points with their velocities."""

    given: str
    en = (
        "{where}: {given!r} does not give two points with their velocities. Write NAME x,y vx,vy for each, in mm and "
        "m/s, with a semicolon between: `A 0,0 1,0.5; B 100,0 1,-0.2`."
    )
    zh = "{where}：{given!r} 没有给出两点及其速度。请对每点写 名称 x,y vx,vy（单位 mm、m/s），两点间用分号隔开：`A 0,0 1,0.5; B 100,0 1,-0.2`。"


class FrameStands(LocatedError):
    """The frame, asked about as if it moved."""

    link: str
    en = "{where}: link {link} is the frame; it does not move, so it has no absolute instant centre. Name a moving link."
    zh = "{where}：构件 {link} 是机架，固定不动，没有绝对瞬心。请给出一个活动构件。"


class NoCentrode(LocatedError):
    """Two links whose centre is nowhere on the paper over a whole motion."""

    first: str
    second: str
    en = (
        "{where}: links {first} and {second} have no centrodes: they have no relative rotation, so their instant "
        "centre stays at infinity, or there is none. Name two links that turn relative to each other."
    )
    zh = "{where}：构件 {first} 与 {second} 没有瞬心线：二者无相对转动，瞬心始终在无穷远处或不存在。请另选两个有相对转动的构件。"


class NoBobillier(LocatedError):
    """A link at a position where Bobillier's construction gives nothing."""

    link: str
    reason: str
    en = "{where}: Bobillier's construction cannot be drawn for link {link}: {why} Take another link or position."
    zh = "{where}：不能对构件 {link} 用波比利尔作图法：{why}请另选构件或位置。"
    reasons: ClassVar[dict[str, dict[Lang, str]]] = {
        "pivot": {"en": "it turns about a fixed point.", "zh": "它绕固定点转动。"},
        "translation": {"en": "its pole is at infinity, its rays are parallel.", "zh": "瞬心在无穷远处，各射线平行。"},
        "rest": {"en": "it stands still at this instant.", "zh": "它此刻静止。"},
        "cusp": {"en": "the point lies at the pole; its path has a cusp.", "zh": "该点位于瞬心，轨迹在此为尖点。"},
        "line": {"en": "the points that are guided lie on one ray of the pole.", "zh": "已知曲率中心的点在同一射线上。"},
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "why": self.reasons[self.reason][lang]}


class UnknownCentre(Choice):
    """A text that names no instant centre."""

    en = "{where}: {given!r} is no instant centre of this mechanism. {hint}"
    zh = "{where}：该机构没有瞬心 {given}。{hint}"
