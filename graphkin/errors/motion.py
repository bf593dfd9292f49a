"""Errors of assembly and movement: links that do not reach, dead points, wrong number of drivers, drawings."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar

from graphkin.errors.base import GraphkinError, Lang, Where

__all__ = [
    "AmbiguousSketch",
    "BadDrawing",
    "CannotAssemble",
    "DeadPoint",
    "GearsApart",
    "HigherClass",
    "NotYetSolved",
    "RepeatedDriver",
    "TooFewDrivers",
    "TooManyDrivers",
    "listed",
]


def listed(names: Iterable[str], lang: Lang) -> str:
    """`2 and 3`; `2、3`."""
    names = list(names)
    if lang == "zh" or len(names) < 2:
        return "、".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


class _AboutLinks(GraphkinError):
    """An error about several links, listed as the language does."""

    where: Where
    links: tuple[str, ...]

    def _words(self, lang: Lang) -> dict[str, object]:
        return super()._words(lang) | {"links": listed(self.links, lang)}


class NotYetSolved(GraphkinError):
    """A pair kind or a driver that is read but not solved."""

    where: Where
    what: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: graphkin reads {what}, but does not solve mechanisms with it yet. "
        "Use links, hinges and slides, with a driver that states its position.",
        "zh": "{where}：graphkin 能读取 {what}，但尚不能求解含它的机构。请只用构件、转动副和移动副，并给出原动件的位置。",
    }


class HigherClass(_AboutLinks):
    """Links that no vector equation with two unknowns reaches."""

    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: links {links} form a group of Class III or higher, which graphkin does not solve yet. "
        "Drive another link, so that only dyads remain.",
        "zh": "{where}：构件 {links} 组成Ⅲ级或更高级的杆组，graphkin 尚不能求解。请改选原动件，使机构只含Ⅱ级杆组。",
    }


class CannotAssemble(_AboutLinks):
    """Links that do not reach each other."""

    gap_mm: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: links {links} miss each other by {gap_mm:.4g} mm at this position. "
        "Change the length of one of them, or move the driver.",
        "zh": "{where}：构件 {links} 在此位置相差 {gap_mm:.4g} mm，无法装配。请改变其中一个的尺寸，或改变原动件的位置。",
    }


class DeadPoint(_AboutLinks):
    """Two loci that meet under too small an angle."""

    angle_deg: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: dead point: the lines for links {links} meet under {angle_deg:.3f} deg; a drawing needs "
        "0.5 deg at least. Move the driver a little, or drive another link.",
        "zh": "{where}：死点位置：构件 {links} 的作图线夹角仅 {angle_deg:.3f}°，作图至少需要 0.5°。请稍微改变原动件的位置，或改选原动件。",
    }


class GearsApart(GraphkinError):
    """Two gears whose centres are not as far apart as their radii want."""

    where: Where
    centres: tuple[str, str]
    distance_mm: float
    wanted_mm: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the centres {pair} stand {distance_mm:.6g} mm apart, the pitch radii want {wanted_mm:.6g} mm. "
        "Change the radii, or the links that hold the centres.",
        "zh": "{where}：中心距 {pair} 为 {distance_mm:.6g} mm，而节圆半径要求 {wanted_mm:.6g} mm。请修改半径，或修改确定中心位置的构件。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return super()._words(lang) | {"pair": "".join(self.centres)}



class AmbiguousSketch(GraphkinError):
    """A sketch as near to one assembly as to the other."""

    where: Where
    points: tuple[str, ...]
    point: str
    first: str
    second: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the sketch fits two assemblies equally well; they differ in {points}. "
        "Say in [sketch] where {point} is: near {first} or near {second} (mm).",
        "zh": "{where}：草图与两种装配形式同样接近，二者的区别在于 {points}。"
        "请在 [sketch] 中写明 {point} 的大致位置：靠近 {first} 还是 {second}（mm）。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return super()._words(lang) | {"points": listed(self.points, lang)}


class TooFewDrivers(_AboutLinks):
    """Freedoms that no driver takes."""

    freedoms: int
    drivers: int
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the mechanism has {freedoms} degrees of freedom but {drivers} driver(s); "
        "links {links} are still free. Add a [[driver]] for one of them.",
        "zh": "{where}：机构有 {freedoms} 个自由度，却只有 {drivers} 个原动件；构件 {links} 仍可自由运动。请为其中之一增加 [[driver]]。",
    }


class TooManyDrivers(GraphkinError):
    """More drivers than freedoms."""

    where: Where
    freedoms: int
    drivers: int
    driver: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the mechanism has {freedoms} degree(s) of freedom but {drivers} drivers; "
        "driver {driver} is one too many. Remove it.",
        "zh": "{where}：机构只有 {freedoms} 个自由度，却有 {drivers} 个原动件；原动件 {driver} 是多余的。请删去。",
    }


class RepeatedDriver(_AboutLinks):
    """As many drivers as freedoms, but two of them move the same one."""

    freedoms: int
    driver: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: driver {driver} moves what the drivers before it move already, while links {links} are "
        "still free (the mechanism has {freedoms} degrees of freedom). Drive one of those instead.",
        "zh": "{where}：原动件 {driver} 与前面的原动件驱动同一自由度，而构件 {links} 仍可自由运动（机构有 {freedoms} 个自由度）。请改为驱动后者。",
    }


class BadDrawing(GraphkinError):
    """A file that is no drawing of graphkin's, or no longer one."""

    where: Where
    what: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: this is not a drawing that graphkin can measure: {what}. Draw it anew with `graphkin draw`.",
        "zh": "{where}：这不是 graphkin 能测量的图：{what}。请用 `graphkin draw` 重新作图。",
    }
