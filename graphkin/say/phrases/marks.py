"""Marks of what was handed in: verdicts, the arithmetic, what wrong values are consistent with."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "student": ("{student}  ({file})  score {score}", "{student}（{file}）  得分 {score}"),
    "not marked": ("{student}  ({file})  not marked: {reason}", "{student}（{file}）  未评阅：{reason}"),
    "column quantity": ("quantity", "量"),
    "column given": ("handed in", "所交"),
    "column right value": ("right", "正确值"),
    "column unit": ("unit", "单位"),
    "column verdict": ("verdict", "评定"),
    "judged with yes": (
        "judged with the own {own}: {quantity} should be {value}: yes",
        "按所交的 {own} 计算，{quantity} 应为 {value}：相符",
    ),
    "judged with no": (
        "judged with the own {own}: {quantity} should be {value}: no",
        "按所交的 {own} 计算，{quantity} 应为 {value}：不符",
    ),
    "not carried": ("not carried on: {own}", "不予沿用：{own}"),
    "consistent": (
        "is consistent with {what} (probability {probability}, explains {explains})",
        "与“{what}”相符（概率 {probability}，可解释 {explains}）",
    ),
    "cannot tell": (
        "is consistent with {what}; these cannot be told apart (probability {probability}, explains {explains})",
        "与“{what}”相符，其间无法区分（概率 {probability}，可解释 {explains}）",
    ),
    "none fits": ("no known mistake fits all values", "没有已知的错误能同时解释所交各值"),
    "or": (", or ", "”或“"),
    "together": (", together with ", "，同时"),
    "more": ("{count} more", "另有 {count} 种"),
    "note": ("note: {note}", "提示：{note}"),
    "interrupted": (
        "Broken off. What was marked is kept beside {path}; the same command goes on from there.",
        "已中断。已批改的部分保存在 {path} 旁；再次运行同一命令即可继续。",
    ),
}
