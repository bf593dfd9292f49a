"""Marks of what was handed in, verdicts, what paper allows, and how well mistakes are told apart."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # === marks of what was handed in
    "marks.student": ("{student}  ({file})  score {score}", "{student}（{file}）  得分 {score}"),
    "marks.not marked": ("{student}  ({file})  not marked: {reason}", "{student}（{file}）  未评阅：{reason}"),
    "marks.column quantity": ("quantity", "量"),
    "marks.column given": ("handed in", "所交"),
    "marks.column right value": ("right", "正确值"),
    "marks.column unit": ("unit", "单位"),
    "marks.column verdict": ("verdict", "评定"),
    "marks.judged with yes": ("judged with the own {own}: {quantity} should be {value}: yes",
                              "按所交的 {own} 计算，{quantity} 应为 {value}：相符"),
    "marks.judged with no": ("judged with the own {own}: {quantity} should be {value}: no",
                             "按所交的 {own} 计算，{quantity} 应为 {value}：不符"),
    "marks.not carried": ("not carried on: {own}", "不予沿用：{own}"),
    "marks.consistent": ("is consistent with {what} (probability {probability}, explains {explains})",
                         "与“{what}”相符（概率 {probability}，可解释 {explains}）"),
    "marks.cannot tell": ("is consistent with {what}; these cannot be told apart (probability {probability}, explains "
                          "{explains})",
                          "与“{what}”相符，其间无法区分（概率 {probability}，可解释 {explains}）"),
    "marks.none fits": ("no known mistake fits all values", "没有已知的错误能同时解释所交各值"),
    "marks.or": (", or ", "”或“"),
    "marks.together": (", together with ", "，同时"),
    "marks.more": ("{count} more", "另有 {count} 种"),
    "marks.note": ("note: {note}", "提示：{note}"),
    "marks.interrupted": ("Broken off. What was marked is kept beside {path}; the same command goes on from there.",
                          "已中断。已批改的部分保存在 {path} 旁；再次运行同一命令即可继续。"),
    # === verdicts: one word for each, everywhere
    "verdicts.verdict right": ("right", "正确"),
    "verdicts.verdict carried": ("carried", "沿用正确"),
    "verdicts.verdict wrong": ("wrong", "错误"),
    "verdicts.verdict missing": ("missing", "未答"),
    "verdicts.verdict dead point": ("near a dead point: paper cannot tell this value", "接近死点，图上无法确定该值"),
    "verdicts.verdict too small": ("less than a pencil errs by: paper cannot tell this value", "小于作图误差，图上无法确定该值"),
    "verdicts.verdict wrong sense": ("wrong sense", "转向（符号）相反"),
    "verdicts.verdict wrong direction": ("wrong direction", "方向错误"),
    "verdicts.verdict wrong unit": ("wrong unit", "单位不符"),
    "verdicts.status marked": ("marked", "已评阅"),
    "verdicts.status not marked": ("not marked", "未评阅"),
    "verdicts.tolerance": ("tolerance", "允差"),
    "verdicts.carried means": ("Carried: it follows rightly from your own earlier value, and counts as right.",
                               "沿用正确：由你自己前面的结果正确推得，按正确计分。"),
    # === what paper allows: the pencil, scatter, what each step costs
    "tolerances.pencil": ("A pencil that errs by {length} mm in lengths and {angle}° in directions (standard "
                          "deviations), {count} drawings.",
                          "作图误差（标准差）：长度 {length} mm，方向 {angle}°；重复作图 {count} 次。"),
    "tolerances.scales": ("Scales: {scales}.", "比例尺：{scales}。"),
    "tolerances.allowed": ("Tolerance: {sigmas} standard deviations, at least half of the third digit.",
                           "允差：{sigmas} 倍标准差，且不小于第三位有效数字的一半。"),
    "tolerances.allowed part": ("Tolerance: {part} of the right value, at least half of the third digit.",
                                "允差：正确值的 {part}，且不小于第三位有效数字的一半。"),
    "tolerances.column scatter": ("scatter", "标准差"),
    "tolerances.column part": ("part", "相对"),
    "tolerances.column worst step": ("what costs it most", "影响最大的一步"),
    "tolerances.steep": ("; near a dead point: not in proportion to the errors", "；接近死点，与作图误差不成比例"),
    "tolerances.asked": ("* is asked for; the others are on the way.", "* 为所求量，其余为中间量。"),
    "tolerances.costs": ("What costs most accuracy, over all that is asked (one error at a time):",
                         "各步对所求量精度的影响（逐项计算）："),
    "tolerances.step position point": ("position: point {of1} of link {of0} laid off", "位置图：在构件 {of0} 上定出点 {of1}"),
    "tolerances.step position frame": ("position: fixed point {of1}", "位置图：固定点 {of1}"),
    "tolerances.step position guide": ("position: direction of the guide {of0}", "位置图：导路 {of0} 的方向"),
    "tolerances.step position driver": ("position: driver {of0} set", "位置图：原动件 {of0} 的位置"),
    "tolerances.step position reading": ("reading {of0}", "量取 {of0}"),
    "tolerances.step velocity arrow": ("velocity: laying off {of0}", "速度图：画出 {of0}"),
    "tolerances.step velocity line": ("velocity: the line through {of0}", "速度图：过 {of0} 作方向线"),
    "tolerances.step velocity image": ("velocity image: {of0}", "速度影像：{of0}"),
    "tolerances.step velocity reading": ("velocity: reading {of0}{of1}", "速度图：量取 {of0}{of1}"),
    "tolerances.step acceleration arrow": ("acceleration: laying off {of0}", "加速度图：画出 {of0}"),
    "tolerances.step acceleration line": ("acceleration: the line through {of0}", "加速度图：过 {of0} 作方向线"),
    "tolerances.step acceleration image": ("acceleration image: {of0}", "加速度影像：{of0}"),
    "tolerances.step acceleration reading": ("acceleration: reading {of0}{of1}", "加速度图：量取 {of0}{of1}"),
    "tolerances.power": ("Diagnosis: {trials} students a mistake, all values handed in, with the pencil above.",
                         "诊断能力：每种错误模拟 {trials} 名学生，交出全部各量，作图误差同上。"),
    "tolerances.column mistake": ("mistake", "错误"),
    "tolerances.column places": ("places", "处数"),
    "tolerances.column applicable": ("applicable", "可辨"),
    "tolerances.column seen": ("found wrong", "判为有错"),
    "tolerances.column named": ("named first", "首位命中"),
    "tolerances.column alone": ("named alone", "单独命中"),
    "tolerances.column least": ("least", "最低"),
    "tolerances.all": ("all", "合计"),
    "tolerances.column tellable": ("tellable", "可判"),
    "tolerances.well named": ("Named first for at least {part} of the students: at {count} of the {all} places that "
                              "paper can tell.",
                              "至少 {part} 的学生首位命中：图上可判的 {all} 处中有 {count} 处。"),
    "tolerances.not tellable": ("Not tellable on this paper: {count} of {all} places ({share}). Who knows this "
                                "mistake alone, and the pencil, would still miss it in more than {missed} of the "
                                "students; at {hidden} of them since all values stay within tolerance. {named} of "
                                "them are named first for at least {part} all the same.",
                                "本图无法判定：{all} 处中有 {count} 处（{share}）。即使只考虑该错误并已知作图误差，仍有超过 {missed} 的学生会漏判；其中 "
                                "{hidden} 处是因为各量都在允差之内。其中仍有 {named} 处至少 {part} 首位命中。"),
    "tolerances.false alarms": ("Right work with a pencil: a value judged wrong in {wrong}, a mistake named in "
                                "{named}.",
                                "正确作图：{wrong} 有量被判错，{named} 被误诊。"),
    "tolerances.random": ("Random wrong numbers: a mistake named in {named}.", "随机错误数值：{named} 被误诊。"),
    "tolerances.not applicable": ("Not applicable (moves no value by more than 3 σ): {share}: {what}.",
                                  "不适用（没有任何量偏移超过 3σ）：{share}：{what}。"),
    # === what the answers to a set of problems tell of mistakes
    "discriminability.head": ("Which mistakes the answers to these problems tell apart ({problems}; handed in is what "
                              "is asked for, drawn with a pencil that errs by {length} mm and {angle}°):",
                              "各题答案能区分哪些错误（{problems}；只交所求各量，作图误差 {length} mm、{angle}°）："),
    "discriminability.problems one": ("{count} problem", "{count} 题"),
    "discriminability.problems many": ("{count} problems", "{count} 题"),
    "discriminability.column mistake": ("mistake", "错误"),
    "discriminability.column places": ("places", "处数"),
    "discriminability.column seen": ("changes an answer", "改变答案"),
    "discriminability.column apart": ("told from all others", "可与其他错误区分"),
    "discriminability.all": ("all", "合计"),
    "discriminability.not applicable": ("Not applicable (no answer changes by more than the tolerance): {share} of "
                                        "all places.",
                                        "不适用（没有答案的变化超过允差）：占全部处数的 {share}。"),
    "discriminability.pairs sets": ("One set, since their answers are the same whatever the numbers are (part of the "
                                    "places):",
                                    "下列错误无论数据如何答案都相同，视为一组（所占处数）："),
    "discriminability.pairs rivals": ("Within the tolerance of each other in some problems, by their numbers (part of "
                                      "the problems):",
                                      "下列错误在部分题目中因数据接近而无法区分（题目所占比例）："),
    "discriminability.pair": ("{first} and {second}: {share}", "{first} 与 {second}：{share}"),
    "discriminability.more": ("and {count} more", "另有 {count} 组"),
    "discriminability.lost": ("By their numbers alone {share} of all places cannot be told. Each problem is the best "
                              "of up to {looked}; to tell more, ask for more (such as what is met on the way), or "
                              "change the ranges.",
                              "仅因数据接近而无法区分的占全部处数的 {share}。每题都是从至多 {looked} 个候选中选出的；要提高区分能力，请增加所求量（如中间量）或改变范围。"),
    "discriminability.nothing lost": ("No mistake is lost by the numbers of a problem.", "没有因数据接近而无法区分的错误。"),
    "discriminability.false alarms": ("Right work with that pencil (tried on {problems}): a value is judged wrong in "
                                      "{wrong}, a mistake is named in {named}.",
                                      "正确作图（同样的作图误差，试 {problems}）：{wrong} 有量被判错，{named} 被误诊。"),
}
