"""The page's quiz on the drawn position, and the layers over its mechanism."""

from graphkin.say.catalogue import Phrases

# fmt: off
PHRASES: Phrases = {
    # === the quiz
    "quiz.title": ("Quiz", "测验"),
    "quiz.about": ("Questions on the drawn position, in the order of the drawing.", "按作图顺序，对图示位置提问。"),
    "quiz.start": ("Start the quiz", "开始测验"),
    "quiz.leave": ("Leave the quiz", "退出测验"),
    "quiz.count": ("Question {number} of {count}", "第 {number} 题，共 {count} 题"),
    "quiz.line": ("Turn the direction line of {name} through {from}: drag it, use the arrow keys, or type its angle.",
                  "转动过 {from} 的 {name} 的方向线：可拖动，可用方向键，也可输入角度。"),
    "quiz.arrow": ("Turn the arrow of {name} at {from} so that it points as it should: drag it, use the arrow keys, or "
                   "type its angle.",
                   "转动 {from} 处 {name} 的矢量，使其指向正确：可拖动，可用方向键，也可输入角度。"),
    "quiz.value": ("What is {name}? Read it off the drawing, or calculate it.", "{name} 等于多少？可由图量取，也可计算。"),
    "quiz.angle": ("Angle from the x axis, counter-clockwise", "与 x 轴的夹角（逆时针为正）"),
    "quiz.number": ("Value", "数值"),
    "quiz.unit": ("Unit", "单位"),
    "quiz.sense": ("Sense", "转向"),
    "quiz.choose": ("choose", "请选择"),
    "quiz.ccw": ("counter-clockwise", "逆时针"),
    "quiz.cw": ("clockwise", "顺时针"),
    "quiz.check": ("Check", "检查"),
    "quiz.show": ("Show the answer", "显示答案"),
    "quiz.next": ("Next question", "下一题"),
    "quiz.right": ("Right.", "正确。"),
    "quiz.wrong": ("Not right; no common mistake gives this. Try again.", "不对，也不像是常见错误的结果。请再试一次。"),
    "quiz.close": ("Not right, but close: {off}° off. Try again.", "不对，但已接近：相差 {off}°。请再试一次。"),
    "quiz.mistake": ("Not right. This is what comes of a mistake:", "不对。这样的结果来自下面的错误："),
    "quiz.or": ("or", "或"),
    "quiz.not a number": ("Write a number.", "请输入数字。"),
    "quiz.no unit": ("Choose a unit.", "请选择单位。"),
    "quiz.other unit": ("{name} has no such unit.", "{name} 不用这种单位。"),
    "quiz.no sense": ("Choose the sense.", "请选择转向。"),
    "quiz.answer": ("The answer: {answer}", "答案：{answer}"),
    "quiz.score": ("{right} of {count} right at the first try.", "{count} 题中有 {right} 题一次答对。"),
    "quiz.handle": ("Direction of {name}", "{name} 的方向"),
    # === layers
    "layers.show centres": ("Instant centres", "瞬心"),
    "layers.show curve": ("Coupler curve of {name}", "点 {name} 的连杆曲线"),
    "layers.show centrode": ("Centrodes of link {name}", "构件 {name} 的瞬心线"),
    "layers.show diagrams": ("Motion diagrams", "运动线图"),
}
