"""What is said of marks and tolerances, in both languages side by side; placeholders are named."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.errors import Lang

__all__ = ["PHRASES", "say"]

PHRASES: Mapping[str, Mapping[Lang, str]] = {
    # marks
    "student": {"en": "{student}  ({file})  score {score}", "zh": "{student}（{file}）  得分 {score}"},
    "not marked": {"en": "{student}  ({file})  not marked: {reason}", "zh": "{student}（{file}）  未批改：{reason}"},
    "quantity": {"en": "quantity", "zh": "量"},
    "given": {"en": "handed in", "zh": "所交"},
    "right value": {"en": "right", "zh": "正确值"},
    "tolerance": {"en": "tolerance", "zh": "允差"},
    "unit": {"en": "unit", "zh": "单位"},
    "verdict": {"en": "verdict", "zh": "评定"},
    "right": {"en": "right", "zh": "正确"},
    "carried": {"en": "carried", "zh": "延续正确"},
    "wrong": {"en": "wrong", "zh": "错误"},
    "missing": {"en": "missing", "zh": "未交"},
    "sense wrong": {"en": "wrong sense", "zh": "转向（符号）相反"},
    "unit wrong": {"en": "wrong unit", "zh": "单位不符"},
    "judged with yes": {"en": "judged with the own {own}: {quantity} should be {value}: yes",
                        "zh": "按所交的 {own} 计算，{quantity} 应为 {value}：相符"},
    "judged with no": {"en": "judged with the own {own}: {quantity} should be {value}: no",
                       "zh": "按所交的 {own} 计算，{quantity} 应为 {value}：不符"},
    "not carried": {"en": "not carried on: {own}", "zh": "不予延续：{own}"},
    "consistent": {"en": "is consistent with {what} (probability {probability}, explains {explains})",
                   "zh": "与“{what}”相符（概率 {probability}，可解释 {explains}）"},
    "cannot tell": {"en": "is consistent with {what}; these cannot be told apart (probability {probability}, explains {explains})",
                    "zh": "与“{what}”相符，其间无法区分（概率 {probability}，可解释 {explains}）"},
    "none fits": {"en": "no known mistake fits all values", "zh": "没有已知的错误能同时解释所交各值"},
    "or": {"en": ", or ", "zh": "”或“"},
    "and": {"en": ", together with ", "zh": "，同时"},
    "comma": {"en": ", ", "zh": "、"},
    "more": {"en": "{count} more", "zh": "另有 {count} 种"},
    "note": {"en": "note: {note}", "zh": "提示：{note}"},
    # tolerances
    "pencil": {"en": "A pencil that errs by {length} mm in lengths and {angle}° in directions (standard deviations), {count} drawings.",
               "zh": "作图误差（标准差）：长度 {length} mm，方向 {angle}°；重复作图 {count} 次。"},
    "scales": {"en": "Scales: {scales}.", "zh": "比例尺：{scales}。"},
    "allowed": {"en": "Tolerance: {sigmas} standard deviations, at least half of the third digit.",
                "zh": "允差：{sigmas} 倍标准差，且不小于第三位有效数字的一半。"},
    "allowed part": {"en": "Tolerance: {part} of the right value, at least half of the third digit.",
                     "zh": "允差：正确值的 {part}，且不小于第三位有效数字的一半。"},
    "scatter": {"en": "scatter", "zh": "标准差"},
    "part": {"en": "part", "zh": "相对"},
    "worst step": {"en": "what costs it most", "zh": "影响最大的一步"},
    "asked": {"en": "asked", "zh": "所求"},
    "on the way": {"en": "on the way", "zh": "中间量"},
    "costs": {"en": "What costs most accuracy, over all that is asked (one error at a time):",
              "zh": "各步对所求量精度的影响（逐项计算）："},
    "position point": {"en": "position: point {of1} of link {of0} laid off", "zh": "位置图：在构件 {of0} 上定出点 {of1}"},
    "position frame": {"en": "position: fixed point {of1}", "zh": "位置图：固定点 {of1}"},
    "position guide": {"en": "position: direction of the guide {of0}", "zh": "位置图：导路 {of0} 的方向"},
    "position driver": {"en": "position: driver {of0} set", "zh": "位置图：原动件 {of0} 的位置"},
    "position reading": {"en": "reading {of0}", "zh": "量取 {of0}"},
    "velocity arrow": {"en": "velocity: laying off {of0}", "zh": "速度图：画出 {of0}"},
    "velocity line": {"en": "velocity: the line through {of0}", "zh": "速度图：过 {of0} 作方向线"},
    "velocity image": {"en": "velocity image: {of0}", "zh": "速度影像：{of0}"},
    "velocity reading": {"en": "velocity: reading {of0}{of1}", "zh": "速度图：量取 {of0}{of1}"},
    "acceleration arrow": {"en": "acceleration: laying off {of0}", "zh": "加速度图：画出 {of0}"},
    "acceleration line": {"en": "acceleration: the line through {of0}", "zh": "加速度图：过 {of0} 作方向线"},
    "acceleration image": {"en": "acceleration image: {of0}", "zh": "加速度影像：{of0}"},
    "acceleration reading": {"en": "acceleration: reading {of0}{of1}", "zh": "加速度图：量取 {of0}{of1}"},
    # power
    "power": {"en": "Diagnosis: {trials} students a mistake, all values handed in, with the pencil above.",
              "zh": "诊断能力：每种错误模拟 {trials} 名学生，交出全部各量，作图误差同上。"},
    "mistake": {"en": "mistake", "zh": "错误"},
    "places": {"en": "places", "zh": "处数"},
    "applicable": {"en": "applicable", "zh": "可辨"},
    "moved": {"en": "moved by [σ]", "zh": "偏移 [σ]"},
    "seen": {"en": "found wrong", "zh": "判为有错"},
    "named": {"en": "named first", "zh": "首位命中"},
    "alone": {"en": "named alone", "zh": "单独命中"},
    "least": {"en": "least", "zh": "最低"},
    "all": {"en": "all", "zh": "合计"},
    "false alarms": {"en": "Right work with a pencil: a value judged wrong in {wrong}, a mistake named in {named}.",
                     "zh": "正确作图：{wrong} 有量被判错，{named} 被误诊。"},
    "random": {"en": "Random wrong numbers: a mistake named in {named}.", "zh": "随机错误数值：{named} 被误诊。"},
    "not applicable": {"en": "Not applicable (moves no value by more than 3 σ): {share}: {what}.",
                       "zh": "不适用（没有任何量偏移超过 3σ）：{share}：{what}。"},
}  # fmt: skip


def say(key: str, lang: Lang, **data: object) -> str:
    """A phrase with its data in it."""
    return PHRASES[key][lang].format(**data)
