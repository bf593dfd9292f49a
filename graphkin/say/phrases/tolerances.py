"""What paper allows: the pencil, scatter, what each step costs; how well mistakes are told apart."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "pencil": (
        "A pencil that errs by {length} mm in lengths and {angle}° in directions (standard deviations), {count} "
        "drawings.",
        "作图误差（标准差）：长度 {length} mm，方向 {angle}°；重复作图 {count} 次。",
    ),
    "scales": ("Scales: {scales}.", "比例尺：{scales}。"),
    "allowed": (
        "Tolerance: {sigmas} standard deviations, at least half of the third digit.",
        "允差：{sigmas} 倍标准差，且不小于第三位有效数字的一半。",
    ),
    "allowed part": (
        "Tolerance: {part} of the right value, at least half of the third digit.",
        "允差：正确值的 {part}，且不小于第三位有效数字的一半。",
    ),
    "column scatter": ("scatter", "标准差"),
    "column part": ("part", "相对"),
    "column worst step": ("what costs it most", "影响最大的一步"),
    "steep": ("; near a dead point: not in proportion to the errors", "；接近死点，与作图误差不成比例"),
    "asked": ("* is asked for; the others are on the way.", "* 为所求量，其余为中间量。"),
    "costs": (
        "What costs most accuracy, over all that is asked (one error at a time):",
        "各步对所求量精度的影响（逐项计算）：",
    ),
    "step position point": ("position: point {of1} of link {of0} laid off", "位置图：在构件 {of0} 上定出点 {of1}"),
    "step position frame": ("position: fixed point {of1}", "位置图：固定点 {of1}"),
    "step position guide": ("position: direction of the guide {of0}", "位置图：导路 {of0} 的方向"),
    "step position driver": ("position: driver {of0} set", "位置图：原动件 {of0} 的位置"),
    "step position reading": ("reading {of0}", "量取 {of0}"),
    "step velocity arrow": ("velocity: laying off {of0}", "速度图：画出 {of0}"),
    "step velocity line": ("velocity: the line through {of0}", "速度图：过 {of0} 作方向线"),
    "step velocity image": ("velocity image: {of0}", "速度影像：{of0}"),
    "step velocity reading": ("velocity: reading {of0}{of1}", "速度图：量取 {of0}{of1}"),
    "step acceleration arrow": ("acceleration: laying off {of0}", "加速度图：画出 {of0}"),
    "step acceleration line": ("acceleration: the line through {of0}", "加速度图：过 {of0} 作方向线"),
    "step acceleration image": ("acceleration image: {of0}", "加速度影像：{of0}"),
    "step acceleration reading": ("acceleration: reading {of0}{of1}", "加速度图：量取 {of0}{of1}"),
    "power": (
        "Diagnosis: {trials} students a mistake, all values handed in, with the pencil above.",
        "诊断能力：每种错误模拟 {trials} 名学生，交出全部各量，作图误差同上。",
    ),
    "column mistake": ("mistake", "错误"),
    "column places": ("places", "处数"),
    "column applicable": ("applicable", "可辨"),
    "column seen": ("found wrong", "判为有错"),
    "column named": ("named first", "首位命中"),
    "column alone": ("named alone", "单独命中"),
    "column least": ("least", "最低"),
    "all": ("all", "合计"),
    "column tellable": ("tellable", "可判"),
    "well named": (
        "Named first for at least {part} of the students: at {count} of the {all} places that paper can tell.",
        "至少 {part} 的学生首位命中：图上可判的 {all} 处中有 {count} 处。",
    ),
    "not tellable": (
        "Not tellable on this paper: {count} of {all} places ({share}). Who knows this mistake alone, and the pencil, would "
        "still miss it in more than {missed} of the students; at {hidden} of them since all values stay within tolerance. "
        "{named} of them are named first for at least {part} all the same.",
        "本图无法判定：{all} 处中有 {count} 处（{share}）。即使只考虑该错误并已知作图误差，仍有超过 {missed} 的学生会漏判；其中 {hidden} 处是因为"
        "各量都在允差之内。其中仍有 {named} 处至少 {part} 首位命中。",
    ),
    "false alarms": (
        "Right work with a pencil: a value judged wrong in {wrong}, a mistake named in {named}.",
        "正确作图：{wrong} 有量被判错，{named} 被误诊。",
    ),
    "random": ("Random wrong numbers: a mistake named in {named}.", "随机错误数值：{named} 被误诊。"),
    "not applicable": (
        "Not applicable (moves no value by more than 3 σ): {share}: {what}.",
        "不适用（没有任何量偏移超过 3σ）：{share}：{what}。",
    ),
}
