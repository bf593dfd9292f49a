"""Errors of assembly and movement, by construction and by analysis."""

from __future__ import annotations

from graphkin.errors.base import AboutLink, AboutLinks, Lang, LocatedError, Where, listed


class HigherClass(AboutLinks):
    """Links that no vector equation with two unknowns reaches."""

    en = (
        "{where}: no loop of vectors reaches links {links}: their drivers or their pairs are too few or too many. "
        "See what `graphkin structure` says of a mechanism like it, and drive another link."
    )
    zh = "{where}：没有矢量方程能求出构件 {links}：原动件或运动副过多或过少。请改选原动件。"


class CannotAssemble(AboutLinks):
    gap_mm: float
    en = (
        "{where}: at this position a gap of {gap_mm:.4g} mm stays open between links {links}. "
        "Change the length of one of them, or move the driver."
    )
    zh = "{where}：在此位置构件 {links} 之间相差 {gap_mm:.4g} mm，无法装配。请改变其中一个的尺寸，或改变原动件的位置。"


class FarFromSketch(CannotAssemble):
    points: str
    sketched_mm: float
    given_mm: float
    en = CannotAssemble.en + " Is {points} right? The sketch has {sketched_mm:.4g} mm, the link {given_mm:.4g} mm."
    zh = CannotAssemble.zh + "{points} 是否有误？草图中为 {sketched_mm:.4g} mm，构件上为 {given_mm:.4g} mm。"


class DeadPoint(AboutLinks):
    angle_deg: float
    en = (
        "{where}: dead point: the lines for links {links} meet under {angle_deg:.3f} deg; a drawing needs "
        "0.5 deg at least. Move the driver a little, or drive another link."
    )
    zh = "{where}：死点位置：构件 {links} 的作图线夹角仅 {angle_deg:.3f}°，作图至少需要 0.5°。请稍微改变原动件的位置，或改选原动件。"


class AlongOwnAxis(DeadPoint):
    link: str
    point: str
    guided: str  # the key of the link's own slide
    en = (
        "{where}: link {link} has one point, so a line on it that is not said is its own axis, and that runs the way it slides "
        "({guided}): nothing on that line can move it. Say in the table of that line how it lies, such as through = \"{point}\" and "
        "angle = 90, measured from +x (on a moving guide from = two points of that guide)."
    )
    zh = (
        "{where}：构件 {link} 只有一个点，未说明的直线就是其自身轴线，与它自己的移动方向（{guided}）平行，沿此直线无法推动它。"
        "请在该直线的表中说明其方向，例如 through = \"{point}\"、angle = 90（由 +x 量起；导路活动时写 from = 导路上的两点）。"
    )


class GearsApart(LocatedError):
    centres: tuple[str, str]
    distance_mm: float
    radii_mm: tuple[float, float]  # signed
    en = (
        "{where}: the centres {pair} stand {distance_mm:.6g} mm apart, {off:+.3g} mm from the {wanted:.6g} mm that the "
        "pitch radii want. Change the links that hold the centres, or the radii: of the same ratio {radii} mm fit."
    )
    zh = (
        "{where}：中心距 {pair} 为 {distance_mm:.6g} mm，与节圆半径要求的 {wanted:.6g} mm 相差 {off:+.3g} mm。"
        "请修改确定中心位置的构件，或改写半径：比值相同而相合的半径为 {radii} mm。"
    )

    def _words(self, lang: Lang) -> dict[str, object]:
        wanted = abs(sum(self.radii_mm))
        radii = listed((f"{abs(radius) * self.distance_mm / wanted:.8g}" for radius in self.radii_mm), lang)
        words = {"pair": "".join(self.centres), "off": self.distance_mm - wanted, "wanted": wanted, "radii": radii}
        return super()._words(lang) | words


PAIRS: dict[str, dict[Lang, str]] = {
    "slide": {"en": "guide {name}", "zh": "导路 {name}"},
    "guide": {"en": "the guide of {name}", "zh": "点 {name} 的导路"},
    "circular slot": {"en": "the circular slot of {name}", "zh": "点 {name} 的圆弧槽"},
    "gear": {"en": "gear pair {name}", "zh": "齿轮副 {name}"},
    "roll": {"en": "rolling contact {name}", "zh": "纯滚动副 {name}"},
    "cam": {"en": "cam pair {name}", "zh": "凸轮副 {name}"},
    "hinge": {"en": "hinge {name}", "zh": "转动副 {name}"},
    "links": {"en": "link {name}", "zh": "构件 {name}"},
}


def called_pair(kind: str, name: str, lang: Lang) -> str:
    """`guide low`, `gear pair 1 and 2`."""
    return PAIRS[kind][lang].format(name=name)


class NotRepeated(LocatedError):
    pair: tuple[str, str]  # kind and name
    held: tuple[tuple[str, str], ...]
    off: float
    unit: str
    en = (
        "{where}: {pair} would repeat the constraints of {held} (a redundant constraint), but contradicts them "
        "by {off:.4g} {unit}. Make it agree with them exactly, or leave it out."
    )
    zh = "{where}：{pair} 与 {held} 的约束重复（虚约束），但二者相差 {off:.4g} {unit}，互相矛盾。请使其完全一致，或将其去掉。"

    def _words(self, lang: Lang) -> dict[str, object]:
        held = listed((called_pair(*each, lang) for each in self.held), lang)
        unit = "°" if (lang, self.unit) == ("zh", "deg") else self.unit
        return super()._words(lang) | {"pair": called_pair(*self.pair, lang), "held": held, "unit": unit}


class OffTrack(LocatedError):
    centre: str
    track: str
    distance_mm: float
    wanted_mm: float
    en = (
        "{where}: the centre {centre} lies {distance} of the track on link {track}, the radius and `side` want "
        "{wanted}: {gap_mm:.6g} mm apart. Change `radius` or `side`, or the pairs that hold the centre."
    )
    zh = "{where}：圆心 {centre} 在构件 {track} 的轨道{distance}，而半径和 `side` 要求在{wanted}，相差 {gap_mm:.6g} mm。请修改 `radius` 或 `side`，或修改确定圆心位置的运动副。"

    def _words(self, lang: Lang) -> dict[str, object]:
        sides = {"en": ("{} mm to the left", "{} mm to the right"), "zh": ("左侧 {} mm 处", "右侧 {} mm 处")}[lang]
        places = {name: sides[value < 0].format(f"{abs(value):.6g}")
                  for name, value in (("distance", self.distance_mm), ("wanted", self.wanted_mm))}  # fmt: skip
        return super()._words(lang) | places | {"gap_mm": abs(self.distance_mm - self.wanted_mm)}


class OtherSide(LocatedError):
    side: str
    en = (
        "{where}: the links do not close as the file has it, and they do on the other side of this line. "
        'Write side = "{side}".'
    )
    zh = "{where}：按文件所给，机构无法装配；在此直线的另一侧则可以。请写 side = \"{side}\"。"


class NotPlaced(AboutLinks):
    en = (
        "{where}: nothing says how this stands at the drawn position: link {links}. Give the driver an `angle` "
        "(or `at`), or add a [[pose]] for one of these links."
    )
    zh = "{where}：所画位置中构件 {links} 的位置没有给定。请给出原动件的 `angle`（或 `at`），或为其中之一增加 [[pose]]。"


class PosesDiffer(LocatedError):
    line: str
    said: str
    holds: str
    apart: str
    others: tuple[Where, ...]
    en = (
        "{where}: this says {line} = {said}, but {others} {line} = {holds}: they differ by {apart}. "
        "Correct one of them, or remove this [[pose]]."
    )
    zh = "{where}：此处给定 {line} = {said}，但{others} {line} = {holds}，二者相差 {apart}。请改正其一，或删去此 [[pose]]。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return super()._words(lang) | {"others": self._others(lang)}

    def _others(self, lang: Lang) -> str:
        """`by driver.0 (line 12)`; the pairs, where they alone fix it."""
        if not self.others:
            return {"en": "by the pairs alone", "zh": "仅由运动副即得"}[lang]
        numbered = {"en": "{key} (line {line})", "zh": "{key}（第 {line} 行）"}[lang]
        named = [
            other.key if other.line is None else numbered.format(key=other.key, line=other.line) for other in self.others
        ]
        return {"en": "by {names}", "zh": "由 {names} 得"}[lang].format(names=listed(named, lang))


class NotReached(LocatedError):
    driver: str
    start: str
    end: str
    stop: str
    en = (
        "{where}: {driver} = {end} is not reached from the drawn position {start}: on the way there is a dead "
        "point, or the end of the movement, at {stop}. Ask for a position before it, or draw the mechanism beyond it."
    )
    zh = "{where}：从所画位置 {driver} = {start} 出发不能到达 {end}：途中在 {stop} 处有死点，或已到运动极限。请取此前的位置，或把机构画在其后的位置。"


class RoadsDiffer(LocatedError):
    worst: float
    en = (
        "{where}: the drawing and the analytic solution differ by {worst:.1e} of the largest value, so neither is "
        "given. Where the mechanism stands near a dead point, move the driver a little; anywhere else the fault is "
        "graphkin's: please report the file."
    )
    zh = "{where}：图解结果与解析结果相差 {worst:.1e}（相对值），故均不予给出。机构若接近死点，请稍微改变原动件的位置；否则为 graphkin 的错误，请将该文件报告给开发者。"


class UnevenLengths(LocatedError):
    longest_mm: float
    shortest_mm: float
    en = (
        "{where}: {longest_mm:.6g} mm beside {shortest_mm:.6g} mm: too few digits are left to solve by. Correct the "
        "length that is wrong."
    )
    zh = "{where}：{longest_mm:.6g} mm 与 {shortest_mm:.6g} mm 相差过大，计算位数不够。请改正有误的长度。"


class TooFar(LocatedError):
    driver: str
    start: str
    end: str
    most: str
    en = "{where}: {driver} is to move from {start} to {end}, but is followed {most} at most. Ask for less of it."
    zh = "{where}：{driver} 要从 {start} 运动到 {end}，但最多只能跟踪 {most}。请缩小范围。"


class AmbiguousSketch(LocatedError):
    points: tuple[str, ...]
    point: str
    first: str
    second: str
    en = (
        "{where}: the sketch fits two assemblies equally well; they differ in {points}. Say in [sketch] where {point} "
        "is: near {first} or near {second} (mm)."
    )
    zh = "{where}：草图与两种装配形式同样接近，二者的区别在于 {points}。请在 [sketch] 中写明 {point} 的大致位置：靠近 {first} 还是 {second}（mm）。"


class AmbiguousDirection(LocatedError):
    link: str
    en = (
        "{where}: two assemblies are possible, and no point of the file tells them apart: link {link} stands in one of "
        "two directions. Give it a second point, with a length, and say in [sketch] roughly where that is."
    )
    zh = "{where}：有两种装配形式，而文件中没有任何点能区分它们：构件 {link} 可取两个方向。请给它加第二个点（写明长度），并在 [sketch] 中写明该点的大致位置。"


class SingularPosition(LocatedError):
    condition: float  # reciprocal, of A in A y' = B, with lengths in units of the mechanism's size
    en = (
        "{where}: the mechanism stands at a dead point or a change point (reciprocal condition {condition:.1e}), "
        "where the drivers give it no definite velocity. Move the driver a little."
    )
    zh = "{where}：机构正处于死点或变点位置（条件数倒数 {condition:.1e}），原动件不能给出确定的速度。请稍微改变原动件的位置。"


class NoAssembly(LocatedError):
    gap_mm: float
    en = (
        "{where}: the mechanism cannot be assembled with these lengths and driver values; "
        "a gap of {gap_mm:.3g} mm stays open. Change a length or move the driver."
    )
    zh = "{where}：按给定的长度和原动件位置无法装配，最小缺口为 {gap_mm:.3g} mm。请改变某一长度或原动件的位置。"


class NotJoined(AboutLink):
    en = "{where}: no chain of pairs joins link {link} to the frame. Let it share a point with another link, or add a slide."
    zh = "{where}：构件 {link} 没有通过任何运动副与机架相连。请让它与另一构件共用一点，或加一个移动副。"
