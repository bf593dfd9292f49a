"""What the answers to a set of problems tell of mistakes."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "head": (
        "Which mistakes the answers to these problems tell apart ({problems}; handed in is what is asked for, drawn "
        "with a pencil that errs by {length} mm and {angle}°):",
        "各题答案能区分哪些错误（{problems}；只交所求各量，作图误差 {length} mm、{angle}°）：",
    ),
    "problems one": ("{count} problem", "{count} 题"),
    "problems many": ("{count} problems", "{count} 题"),
    "column mistake": ("mistake", "错误"),
    "column places": ("places", "处数"),
    "column seen": ("changes an answer", "改变答案"),
    "column apart": ("told from all others", "可与其他错误区分"),
    "all": ("all", "合计"),
    "not applicable": (
        "Not applicable (no answer changes by more than the tolerance): {share} of all places.",
        "不适用（没有答案的变化超过允差）：占全部处数的 {share}。",
    ),
    "pairs sets": (
        "One set, since their answers are the same whatever the numbers are (part of the places):",
        "下列错误无论数据如何答案都相同，视为一组（所占处数）：",
    ),
    "pairs rivals": (
        "Within the tolerance of each other in some problems, by their numbers (part of the problems):",
        "下列错误在部分题目中因数据接近而无法区分（题目所占比例）：",
    ),
    "pair": ("{first} and {second}: {share}", "{first} 与 {second}：{share}"),
    "more": ("and {count} more", "另有 {count} 组"),
    "lost": (
        "By their numbers alone {share} of all places cannot be told. Each problem is the best of up to {looked}; to tell "
        "more, ask for more (such as what is met on the way), or change the ranges.",
        "仅因数据接近而无法区分的占全部处数的 {share}。每题都是从至多 {looked} 个候选中选出的；"
        "要提高区分能力，请增加所求量（如中间量）或改变范围。",
    ),
    "nothing lost": (
        "No mistake is lost by the numbers of a problem.",
        "没有因数据接近而无法区分的错误。",
    ),
    "false alarms": (
        "Right work with that pencil (tried on {problems}): a value is judged wrong in {wrong}, a mistake is named in "
        "{named}.",
        "正确作图（同样的作图误差，试 {problems}）：{wrong} 有量被判错，{named} 被误诊。",
    ),
}
