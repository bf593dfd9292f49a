"""Errors of studies: conditions looked for, linkages of four links, their design, instant centres, in this order."""

from __future__ import annotations

from graphkin.errors.base import AboutLink, AboutText, Choice, GraphkinError, Lang, LocatedError, WordTable


class BadCondition(AboutText):
    en = (
        "{where}: {given!r} is no condition. Write for example `v C = 0`, `theta 5 = 30`, `omega 2 = omega 3`, "
        "`a E > 3 g`, `max v E`, `range theta 3`, `stroke s ram`, `slowest BC`, `v E = 0.5 by omega 1`."
    )
    zh = (
        "{where}：{given!r} 不是一个条件。请写成如 `v C = 0`、`theta 5 = 30`、`omega 2 = omega 3`、`a E > 3 g`、"
        "`max v E`、`range theta 3`、`stroke s ram`、`slowest BC`、`v E = 0.5 by omega 1`。"
    )


class NothingDrawn(GraphkinError):
    of: str
    en = "{of}: nothing of this kind can be shown so, or it is nowhere. Read its values instead."
    zh = "{of}：这种结果没有可显示的内容，或不在任何位置。请直接读取其数值。"


class OtherUnits(LocatedError):
    """Two quantities that cannot be equal, or a bare number with a unit."""

    first: str
    first_unit: str
    second: str
    second_unit: str
    en = "{where}: {first} is measured in {first_unit}, {second} in {second_unit}: they cannot be compared. Compare quantities of one kind."
    zh = "{where}：{first} 的单位是 {first_unit}，{second} 的单位是 {second_unit}，不能比较。请比较同类的量。"

    def _words(self, lang: Lang) -> dict[str, object]:
        bare = {"en": "plain numbers", "zh": "1（无量纲）"}[lang]
        words = super()._words(lang)
        return words | {key: bare for key in ("first_unit", "second_unit") if words[key] == "1"}


class NegativeSize(LocatedError):
    quantity: str
    given: str
    en = (
        "{where}: {quantity} is the size of a vector and never {given}. Ask for a positive value; a sign has a "
        "meaning only for a point that a guide of the frame leads, along that guide."
    )
    zh = "{where}：{quantity} 是矢量的大小，不会等于 {given}。请给出正值；只有沿机架导路运动的点才有正负之分（沿导路方向）。"


class NoLineOf(Choice):
    en = "{where}: {given!r} is no line of a moving link. Name two points of one link (`slowest BC`), or a link with two points. {hint}"
    zh = "{where}：{given!r} 不是某一活动构件上的直线。请写出同一构件上的两点（如 `slowest BC`），或至少有两点的构件。{hint}"


class NoUnitHere(AboutText):
    en = "{where}: a quotient is a plain number, and {given} is none. Leave the unit out."
    zh = "{where}：比值是无量纲的数，而 {given} 不是。请去掉单位。"


class NotScaled(LocatedError):
    quantity: str
    en = (
        "{where}: {quantity} does not depend on the speed of the drivers, so no speed gives it another value. "
        "Leave `by` out to look for positions, or ask for a velocity or an acceleration."
    )
    zh = "{where}：{quantity} 与原动件的速度无关，改变速度不能得到所要的值。要求位置时请去掉 `by`；否则请改问速度或加速度。"


class CannotScale(LocatedError):
    quantity: str
    value: str
    wanted: str
    en = (
        "{where}: here {quantity} is {value}, and no speed of the drivers makes it {wanted}: it grows with their "
        "speed (accelerations with its square) from nothing and keeps its sense. Ask for another value, or at another position."
    )
    zh = "{where}：此位置 {quantity} 为 {value}，原动件取任何速度都不能使它等于 {wanted}：它与速度成正比（加速度与速度的平方成正比），方向不变。请改用其他值或其他位置。"


class NoDimension(Choice):
    en = (
        "{where}: the file has no dimension {given} with one number that could be varied. Write a length or an "
        "angle of a link (`AB`, `BDE`, `links.2.AB`) or a driver's name. {hint}"
    )
    zh = "{where}：文件中没有可以改变的单个尺寸 {given}。请写构件的长度或角度（`AB`、`BDE`、`links.2.AB`）或原动件的名称。{hint}"


class NotALength(LocatedError):
    what: str
    given: str
    en = "{where}: {what} is {given}. Lengths of links are positive numbers in mm (an offset may be 0 or negative)."
    zh = "{where}：{what} 为 {given}。杆长必须是正数（mm）；偏距可以为 0 或负数。"


class CannotClose(LocatedError):
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
    long: str
    rest: str
    long_mm: float
    en = (
        "{where}: {long} = {rest} = {long_mm:.6g} mm: the links close only when all lie in one line, and cannot move. "
        "Shorten {long}, or lengthen another."
    )
    zh = "{where}：{long} = {rest} = {long_mm:.6g} mm：各杆只能在拉成一直线时装配，不能运动。请缩短 {long} 或加长其余各杆。"


class NoLinkage(LocatedError):
    en = (
        "{where}: no four-bar, slider-crank or guide-bar linkage on the frame was found: no loop of the frame and "
        "three moving links with four revolute pairs, or three and one sliding pair. Mechanisms with cams, gears or "
        "two sliding pairs in the loop have no such report."
    )
    zh = "{where}：没有找到以机架为一构件的铰链四杆机构、曲柄滑块机构或导杆机构：没有由机架和三个活动构件组成、含四个转动副（或三个转动副和一个移动副）的闭环。环中含凸轮副、齿轮副或两个移动副的机构不作此分析。"


class NoFixing(Choice):
    en = "{where}: {given!r} is no link of a linkage found here that could become the frame. {hint}"
    zh = "{where}：{given!r} 不是此处可以改作机架的构件。{hint}"


class CannotDriveBy(Choice):
    en = "{where}: the linkage cannot be driven by {given!r}. {hint}"
    zh = "{where}：此机构不能以 {given!r} 为原动件。{hint}"


class WantedRange(GraphkinError):
    name: str
    given: str
    low: str
    high: str
    en = "{name} = {given} cannot be: it must be above {low} and below {high}. Give a value within."
    zh = "{name} = {given} 不可能：必须大于 {low}、小于 {high}。请改用其中的值。"


class NoQuickReturn(GraphkinError):
    en = (
        "K = 1 is no quick return, and no condition: advance and return take the same time. A slider-crank does so with "
        "the offset e = 0 and any rod, its crank half the stroke; write such a file, or give a K above 1."
    )
    zh = "K = 1 时进程与回程用时相同，没有急回，不构成设计条件。对心曲柄滑块机构（偏距 e = 0、曲柄为行程之半、连杆任意）即如此；请直接写出机构文件，或给出大于 1 的 K。"


class OneCondition(GraphkinError):
    given: str
    possible: str
    wanted: str
    en = "Given: {given}. Give {wanted} of {possible}."
    zh = "已给：{given}。在 {possible} 中请给 {wanted} 个。"

    def _words(self, lang: Lang) -> dict[str, object]:
        nothing = "nothing" if lang == "en" else "无"
        return {**self._data(), "given": self.given or nothing}


class WrongNumber(GraphkinError):
    count: int
    wanted: str
    en = "{count} given, where {wanted} are wanted."
    zh = "给了 {count} 个，应为 {wanted} 个。"


class SameWanted(GraphkinError):
    first: str
    second: str
    en = "{first} and {second} are the same. Give positions that differ."
    zh = "{first} 与 {second} 重合。请给出互不相同的位置。"


class CouplerChanges(GraphkinError):
    first: str
    first_mm: float
    other: str
    other_mm: float
    en = (
        "{first} = {first_mm:.8g} mm but {other} = {other_mm:.8g} mm: the coupler keeps its length. Correct a position, "
        "or give B and the coupler's direction instead of C."
    )
    zh = "{first} = {first_mm:.8g} mm，而 {other} = {other_mm:.8g} mm：连杆长度不变。请改正其中一个位置，或以 B 点和连杆方向代替 C 点。"


class NotOnBisector(GraphkinError):
    point: str
    off_mm: float
    first: str
    second: str
    x_mm: float
    y_mm: float
    en = (
        "{point} must lie on the perpendicular bisector of {first}{second}; it is {off_mm:.4g} mm off. "
        "The nearest place is ({x_mm:.10g}, {y_mm:.10g})."
    )
    zh = "{point} 必须在 {first}{second} 的中垂线上，现偏离 {off_mm:.4g} mm。最近的点为 ({x_mm:.10g}, {y_mm:.10g})。"


class NoDesign(GraphkinError):
    reasons: tuple[str, str]  # in English, in Chinese
    en = "No solution. {why}"
    zh = "无解。{why}"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {"why": self.reasons[lang == "zh"]}


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
    first: str
    second: str
    en = "{where}: {first} and {second} lie at one place, so they do not tell how the body turns. Give another point."
    zh = "{where}：{first} 与 {second} 位于同一处，不能确定刚体的转动。请改用另一点。"


class BadVelocities(AboutText):
    en = (
        "{where}: {given!r} does not give two points with their velocities. Write NAME x,y vx,vy for each, in mm and "
        "m/s, with a semicolon between: `A 0,0 1,0.5; B 100,0 1,-0.2`."
    )
    zh = "{where}：{given!r} 没有给出两点及其速度。请对每点写 名称 x,y vx,vy（单位 mm、m/s），两点间用分号隔开：`A 0,0 1,0.5; B 100,0 1,-0.2`。"


class FrameStands(AboutLink):
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


_NO_BOBILLIER: WordTable = {
    "pivot": ("it turns about a fixed point.", "它绕固定点转动。"),
    "translation": ("its pole is at infinity, its rays are parallel.", "瞬心在无穷远处，各射线平行。"),
    "rest": ("it stands still at this instant.", "它此刻静止。"),
    "cusp": ("the point lies at the pole; its path has a cusp.", "该点位于瞬心，轨迹在此为尖点。"),
    "alone": ("no other point of it has a path whose centre of curvature is known.", "除该点外，没有其他已知轨迹曲率中心的点。"),
    "line": ("the points that are guided lie on one ray of the pole.", "已知曲率中心的点在同一射线上。"),
}


class NoBobillier(AboutLink, reason=_NO_BOBILLIER):
    reason: str
    en = "{where}: Bobillier's construction cannot be drawn for link {link}: {reason} Take another link or position."
    zh = "{where}：不能对构件 {link} 用波比利尔作图法：{reason}请另选构件或位置。"


class UnknownCentre(Choice):
    en = "{where}: {given!r} is no instant centre of this mechanism. {hint}"
    zh = "{where}：该机构没有瞬心 {given}。{hint}"
