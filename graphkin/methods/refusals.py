"""What the planner cannot do with a mechanism, said before it tries."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from graphkin.errors import GraphkinError, Lang, Where
from graphkin.mechanism import Mechanism


@dataclass(eq=False)
class NotYetSolved(GraphkinError):
    """A pair kind or a driver that is read but not solved."""

    where: Where
    what: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: graphkin reads {what}, but does not solve mechanisms with it yet. "
        "Use links, hinges and slides, with a driver that states its position.",
        "zh": "{where}：graphkin 能读取 {what}，但尚不能求解含它的机构。请只用构件、转动副、移动副，并给出原动件的位置。",
    }


@dataclass(eq=False)
class Unreached(GraphkinError):
    """Links that no vector equation with two unknowns reaches."""

    where: Where
    links: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: links {links} form a group of Class III or higher, "
        "which graphkin does not solve yet. Drive another link, so that only dyads remain.",
        "zh": "{where}：构件 {links} 组成Ⅲ级或更高级的杆组，graphkin 尚不能求解。请改选原动件，使机构只含Ⅱ级组。",
    }


@dataclass(eq=False)
class CannotAssemble(GraphkinError):
    """Links that do not reach each other."""

    where: Where
    links: list[str]
    gap_mm: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: links {links} miss each other by {gap_mm:.4g} mm at this position. "
        "Lengthen one of them, or move the driver.",
        "zh": "{where}：构件 {links} 在此位置相差 {gap_mm:.4g} mm，无法装配。请改变其中一个的尺寸，或改变原动件的位置。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {"where": self.where, "links": listed(self.links, lang), "gap_mm": self.gap_mm}


@dataclass(eq=False)
class DeadPoint(GraphkinError):
    """Two loci that meet under too small an angle."""

    where: Where
    links: list[str]
    angle_deg: float
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: dead point: the lines of links {links} meet under {angle_deg:.3f} deg, "
        "too little to find anything (0.5 deg at least). Move the driver a little, or drive another link.",
        "zh": "{where}：死点位置：构件 {links} 的作图线夹角仅 {angle_deg:.3f}°（至少需 0.5°），无法求解。请稍微改变原动件的位置，或改选原动件。",
    }

    def _words(self, lang: Lang) -> dict[str, object]:
        return {"where": self.where, "links": listed(self.links, lang), "angle_deg": self.angle_deg}


@dataclass(eq=False)
class AmbiguousSketch(GraphkinError):
    """A sketch as near to one assembly as to the other."""

    where: Where
    points: str
    point: str
    first: str
    second: str
    text: ClassVar[dict[Lang, str]] = {
        "en": "{where}: the sketch fits two assemblies equally well; they differ in {points}. "
        "Say where {point} is: near {first} or near {second} (mm).",
        "zh": "{where}：草图与两种装配形式同样接近，二者的区别在 {points}。请在 [sketch] 中写明 {point} 的大致位置：靠近 {first} 还是 {second}（mm）。",
    }


def listed(names: Iterable[str], lang: Lang) -> str:
    """`2 and 3`; `2、3`."""
    names = list(names)
    if lang == "zh" or len(names) < 2:
        return "、".join(names)
    return ", ".join(names[:-1]) + " and " + names[-1]


def refuse_unsolved(mechanism: Mechanism) -> None:
    """Gears, rolling and cams, wheels driven by themselves, and positions given by a pose."""
    for table, pairs in (("gear", mechanism.gears), ("roll", mechanism.rolls), ("cam", mechanism.cams)):
        if pairs:
            raise NotYetSolved(mechanism.where(table, 0), f"[[{table}]]")
    for k, driver in enumerate(mechanism.drivers):
        if driver.kind == "spin":
            raise NotYetSolved(mechanism.where("driver", k), "link = ...")
        if driver.value is None:
            raise NotYetSolved(mechanism.where("pose", 0), "[[pose]]")
