"""Errors in what is asked of a mechanism at the command line: ranges of drivers, quantities, conditions."""

from __future__ import annotations

from graphkin.errors.base import AboutText, Choice, GraphkinError, Lang, LocatedError


class BadRange(AboutText):
    en = (
        "{where}: {given!r} is no range. Write FROM:TO:STEP (0:360:10, or 50 mm:90 mm:5 mm), with FROM and TO "
        "different, STEP above 0, at most 1000 turns and 10 million steps; drivers that move together take equally many."
    )
    zh = "{where}：{given!r} 不是有效的范围。请写成 起:止:步长（如 0:360:10 或 50 mm:90 mm:5 mm），起止不得相同，步长大于 0，最多 1000 转、一千万步；同时运动的各原动件步数必须相同。"


class BadValues(AboutText):
    en = (
        "{where}: {given!r} are no values to move through. Give finite numbers in deg or mm, a list or an array (n,) "
        "of at most ten million and 1000 turns, or a text FROM:TO:STEP; drivers that move together take equally many, "
        "which rise and fall in proportion."
    )
    zh = "{where}：{given!r} 不能作为运动的取值。请给出以 deg 或 mm 为单位的有限数（列表或一维数组，最多一千万个、1000 转），或写成 起:止:步长；同时运动的各原动件取值个数相同，并按比例变化。"


class SeveralPositions(AboutText):
    en = "{where}: {given} are several positions, and this is of one. Give each driver one number; `replay` and `sweep` take arrays."
    zh = "{where}：{given} 是多个位置，而此处只能有一个。请给每个原动件一个数；数组可用于 `replay` 和 `sweep`。"


class BadPair(AboutText):
    en = "{where}: {given!r} does not read as a pair. Write a point as X,Y (10,40), two points as 'X,Y X,Y', two angles as PHI:PSI (40:30)."
    zh = "{where}：{given!r} 不是一对数值。点写成 X,Y（如 10,40），两点写成 'X,Y X,Y'，两个角写成 φ:ψ（如 40:30）。"


class NeedsTwoLinks(AboutText):
    en = "{where}: {given!r} does not name two links. Write both with a comma: 3,1."
    zh = "{where}：{given!r} 不是两个构件，请用逗号分开，如 3,1。"


class GivenTwice(LocatedError):
    driver: str
    en = "{where}: driver {driver} is given twice. Give each driver one range or one value."
    zh = "{where}：原动件 {driver} 给了两次，每个原动件只能给一个范围或一个值。"


class TooManyRows(LocatedError):
    rows: int
    most: int
    en = (
        "{where}: {rows} rows, and {most} at most are printed or written as JSON. Take a larger step, or write them "
        "into a file with -o: .csv, .jsonl and .parquet take any number."
    )
    zh = "{where}：共 {rows} 行，显示或写成 JSON 最多 {most} 行。请加大步长，或用 -o 写入 .csv、.jsonl、.parquet 文件（行数不限）。"


class NoSuchDriver(Choice):
    en = "{where}: there is no driver {given} to move. {hint}"
    zh = "{where}：没有可以运动的原动件 {given}。{hint}"


class NoSuchValue(Choice):
    en = (
        "{where}: {given!r} is not one value of this file. A length is named AB, an angle BDE, a fixed or sketched "
        "point A, a driver's value 'angle AB' or 'omega AB', any other by its place: links.2.AB, slide.0.angle. {hint}"
    )
    zh = "{where}：{given!r} 不是该文件中唯一的一个值。长度写 AB，角度写 BDE，固定点或草图点写 A，原动件的值写 'angle AB'、'omega AB'，其他按位置写：links.2.AB、slide.0.angle。{hint}"


class NoSuchName(Choice, KeyError):
    en = "{where}: there is no {given!r}. {hint}"
    zh = "{where}：没有 {given!r}。{hint}"


class NotSwept(Choice, KeyError):
    en = "{where}: {given!r} is not in this sweep. Name it in `of` to have it. {hint}"
    zh = "{where}：这次扫描中没有 {given!r}，需要时请写入 `of`。{hint}"


class OtherUnit(GraphkinError, AttributeError):
    asked: str
    units: tuple[str, ...]
    own: str
    en = "{asked} is of a value in {units:,}; this one is in {own}."
    zh = "{asked} 用于单位为 {units:,} 的量，而此量的单位是 {own}。"


class NotAVector(GraphkinError, AttributeError):
    asked: str
    en = "{asked} is of a vector; this is a number with a sign. `v C` and `path C` are vectors."
    zh = "{asked} 用于矢量，而此处是带正负号的数。`v C`、`path C` 是矢量。"


class NotAMechanism(AboutText, TypeError):
    en = (
        "{where}: a mechanism is wanted, and this is of type {given}. Give its name in the library, its file, or what "
        "`load` (a file), `loads` (a text), `from_dict` (tables) or the `done()` of a builder gives."
    )
    zh = "{where}：此处应为机构，而给出的类型是 {given}。请给出库中的名称、机构文件，或 `load`（文件）、`loads`（文本）、`from_dict`（数据）以及构造器的 `done()` 所得的机构。"


class NoPosition(LocatedError):
    driver: str
    low: str
    high: str
    en = (
        "{where}: none of the positions asked for is reached: {driver} moves from {low} to {high} only. "
        "Ask for a range within, or with smaller steps."
    )
    zh = "{where}：所要求的位置都不能到达：{driver} 只能在 {low} 至 {high} 之间运动。请改用其中的范围，或减小步长。"


class ValueForEach(LocatedError, ValueError):
    count: int
    drivers: tuple[str, ...]
    en = (
        "{where}: {needed} drivers, {count} values. Give one value, or one array of many, for each of {names}, in this "
        "order [deg, mm]: [[60, 70, 80]] are three positions of one driver."
    )
    zh = (
        "{where}：原动件有 {needed} 个，给了 {count} 个值。请按 {names} 的顺序各给一个值，或各给一个数组 [deg, mm]："
        "[[60, 70, 80]] 是一个原动件的三个位置。"
    )

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "needed": len(self.drivers), "names": ", ".join(self.drivers)}


class UnevenArrays(LocatedError, ValueError):
    counts: tuple[int, ...]
    en = "{where}: arrays of {numbers} values. Give one value for each mechanism, equally many in every array."
    zh = "{where}：各数组分别有 {numbers} 个值。请为每个机构各给一个值，各数组长度相同且不为零。"

    def _words(self, lang: Lang) -> dict[str, object]:
        return {**super()._words(lang), "numbers": ", ".join(map(str, self.counts))}


class StandsStill(LocatedError):
    point: str
    en = "{where}: {point} stays where it is as the mechanism moves, so it has no path. Name a point that moves."
    zh = "{where}：机构运动时点 {point} 静止不动，没有轨迹。请改用运动的点。"


class NoSpeed(LocatedError):
    """Velocities are to be drawn along a path, and the driver says nothing of how fast it moves."""

    driver: str
    keys: str
    en = "{where}: driver {driver} has no {keys}, so there are no velocities to draw. Give it one, or leave the arrows out."
    zh = "{where}：原动件 {driver} 未给出 {keys}，没有可画的速度。请补上，或不画箭头。"


class UnknownQuantity(Choice):
    en = "{where}: {given!r} names no quantity. Write for example `theta 3`, `omega 3`, `v C`, `a_k B3B2`, `s ram`, `omega 1 / omega 3`. {hint}"
    zh = "{where}：{given!r} 不是一个量。请写成如 `theta 3`、`omega 3`、`v C`、`a_k B3B2`、`s ram`、`omega 1 / omega 3`。{hint}"


class NeedsTwo(LocatedError):
    """Part of a relative acceleration, asked of one point; `pairs` have it as their first."""

    quantity: str
    point: str
    pairs: tuple[str, ...]
    en = "{where}: {quantity} is part of the acceleration of one point seen from another, and {point} alone is one point. {hint}"
    zh = "{where}：{quantity} 是一点相对另一点的加速度的分量，只写一个点 {point} 不够。{hint}"

    def _words(self, lang: Lang) -> dict[str, object]:
        asked = ", ".join(f"`{self.quantity} {two}`" for two in self.pairs[:6])
        hint = {"en": f"Write {asked}." if asked else "", "zh": f"可写 {asked}。" if asked else ""}[lang]
        return {**super()._words(lang), "hint": hint}


class SketchMirrored(LocatedError):
    """Said as a note: the assembly that is nearest to the sketch is drawn."""

    link: str
    points: str
    en = "{where}: note: the sketch shows {points} the other way round than link {link} has them. Look at ccw, and at the sketch."
    zh = "{where}：提示：草图中 {points} 的绕行方向与构件 {link} 上的相反，请核对 ccw 与草图。"


class TurnsAsItLikes(LocatedError):
    """Asked is how a roller turns that nothing but its pin holds."""

    quantity: str
    link: str
    en = "{where}: {quantity} has no value: roller {link} may turn as it likes (idle freedom). Leave it out."
    zh = "{where}：{quantity} 没有确定的值：滚子 {link} 的自转为局部自由度。请删去。"


class NoQuestion(AboutText):
    """A text of `ask` that names nothing, and is no question in words either; `meant` is the nearest that does."""

    meant: str
    en = "{where}: `{given}` names nothing that can be answered. {advice}A question in words ends with `?`; it is shown only."
    zh = "{where}：`{given}` 不是可以求解的量。{advice}文字问题请以“？”结尾，只显示、不求解。"

    def _words(self, lang: Lang) -> dict[str, object]:
        sample = self.meant or "omega 3`, `v C`, `a_k B3B2"
        english = f"Did you mean `{sample}`? " if self.meant else f"Write for example `{sample}`. "
        chinese = f"是否为 `{sample}`？" if self.meant else f"请写成如 `{sample}`。"
        return {**super()._words(lang), "advice": chinese if lang == "zh" else english}


class NoRate(LocatedError):
    """A driver that says nothing of how fast it moves; said as a note, no command stops for it."""

    driver: str
    keys: str
    en = "{where}: note: driver {driver} has no {keys}, so it stands still and all velocities that follow from it are 0."
    zh = "{where}：提示：原动件 {driver} 未给出 {keys}，按静止处理，由它引起的速度均为 0。"

