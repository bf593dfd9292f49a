"""Positions with a property: lines for the terminal, columns of a table."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "looked": ("searched from {driver} = {low} to {high}", "搜索范围：{driver} = {low} 至 {high}"),
    "in brackets": ("  ({text})", "（{text}）"),
    "because": ("  (because {zero})", "（因 {zero}）"),
    "turn": (", a full turn", "，即整周"),
    "stopped": (", as far as it gets ({ends})", "，即可到达的范围（{ends}）"),
    "low end": ("dead point at {value}", "{value} 处为死点"),
    "none": ("not met in this range", "在此范围内不成立"),
    "not passed": ("not passed in this range", "在此范围内没有超过"),
    "nearest": ("it comes nearest at {at}: {values}", "最接近处 {at}：{values}"),
    "everywhere": ("met at every position", "在所有位置都成立"),
    "nothing": ("zero throughout", "始终为零"),
    "level": ("the same at every position: {values}", "在所有位置都相同：{values}"),
    "kind zero": ("", ""),
    "kind here": ("", ""),
    "kind touch": ("touched, not passed", "仅相切，不越过"),
    "kind max": ("greatest", "最大"),
    "kind min": ("least", "最小"),
    "kind largest": ("largest size, against the guide's direction", "最大绝对值，方向与导路正向相反"),
    "kind end": ("at the end of the range", "在范围端点"),
    "kind stop": ("tends to this at the dead point", "趋近死点时的极限"),
    "kind pole": ("grows without limit there", "在该处无限增大"),
    "swing": ("difference of greatest and least: {value}", "最大与最小之差：{value}"),
    "stroke": ("stroke: {value}", "行程：{value}"),
    "phase advance": ("advance ({way})", "工作行程（{way}）"),
    "phase retreat": ("return ({way})", "回程（{way}）"),
    "up": ("growing", "增大"),
    "down": ("falling", "减小"),
    "phase": ("{name}: {driver} turns {angle}", "{name}：{driver} 转过 {angle}"),
    "time": (", {time} s, mean speed {mean}", "，用时 {time} s，平均速度 {mean}"),
    "ratio": ("time ratio K = {value}", "行程速度变化系数（行程速比系数）K = {value}"),
    "interval": ("from {begin} to {end}", "{begin} 至 {end}"),
    "peak": ("{what} {values} at {at}", "{what} {values}，位于 {at}"),
    "slow beyond": (
        "{at}: slowest point of line {line}: {along} from {first} towards {second}, beyond it, speed {speed}",
        "{at}：直线 {line} 上速度最小的点：距 {first} 为 {along}（沿 {second} 方向，在 {second} 之外），速度 {speed}",
    ),
    "slow between": (
        "{at}: slowest point of line {line}: {along} from {first} towards {second}, between the two, speed {speed}",
        "{at}：直线 {line} 上速度最小的点：距 {first} 为 {along}（在 {first} 与 {second} 之间），速度 {speed}",
    ),
    "slow behind": (
        "{at}: slowest point of line {line}: {along} from {first} away from {second}, speed {speed}",
        "{at}：直线 {line} 上速度最小的点：距 {first} 为 {along}（在 {second} 的反方向），速度 {speed}",
    ),
    "alike": (
        "{at}: link translates: all points of line {line} have the speed {speed}",
        "{at}：构件作平动，直线 {line} 上各点速度均为 {speed}",
    ),
    "speeds": ("{at}: {quantity} = {value} requires {rates}", "{at}：要使 {quantity} = {value}，须 {rates}"),
    "factor": (
        " ({factor} times the file's, where {quantity} is {now})",
        "（为文件所给的 {factor} 倍，其时 {quantity} 为 {now}）",
    ),
    "together": ("all drivers' speeds are changed in proportion", "各原动件的速度按同一比例改变"),
    "square": (
        "the drivers' accelerations are changed by the square of the factor: {accelerations}",
        "各原动件的加速度按倍数的平方改变：{accelerations}",
    ),
    # --- why there is no more
    "note no turn": (
        "no time ratio: the driver does not go through a full turn here",
        "无行程速比系数：原动件在此范围内不作整周转动",
    ),
    "note several strokes": (
        "no time ratio: the output reaches its ends more than once a turn",
        "无行程速比系数：输出件每转中多次到达极限位置",
    ),
    "note goes round": ("no stroke: the link turns all the way round", "无摆程：该构件作整周转动"),
    # --- columns
    "column at": ("at {driver}", "{driver} 的位置"),
    "column min": ("least", "最小"),
    "column max": ("greatest", "最大"),
    "column swing": ("difference", "差"),
    "column stroke": ("stroke", "行程"),
    "column along": ("from {first}", "距 {first}"),
    "column speed": ("speed", "速度"),
}
