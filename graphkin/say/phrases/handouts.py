"""Handouts: a problem on paper, empty, half done, or solved."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "stage problem": ("problem", "题目"),
    "stage blank": ("worksheet", "作业纸"),
    "stage half": ("half-worked solution", "半成品解答"),
    "stage solution": ("solution", "解答"),
    "contents": ("Problems", "目录"),
    "answers": ("Answers", "答案"),
    "figure given": (
        "The mechanism to scale, with what is given: {title}", "按比例绘制的机构运动简图及已知条件：{title}",
    ),
    "figure drawn": ("{what} of the mechanism, to scale: {title}", "按比例绘制的{what}：{title}"),
    "scales": ("Scales to use", "取比例尺"),
    "your answers": ("Your answers", "答案栏"),
    "quantity": ("quantity", "量"),
    "answer": ("answer", "答案"),
    "unit": ("unit", "单位"),
    "sense": ("sense", "转向"),
    "vector": ("vector", "矢量"),
    "measured": ("measured (mm)", "量得 (mm)"),
    "value": ("value", "数值"),
    "draw here": ("Draw the polygon from the pole, at {scale}.", "从极点起作图，比例尺 {scale}。"),
    "go on": ("Go on with the next equation:", "续作下一矢量方程："),
    "beside": ("The drawing beside the analysis", "图解与解析结果对照"),
    "drawn": ("drawn", "图解"),
    "analysed": ("analysis", "解析"),
    "allowed": ("a pencil allows", "作图允差"),
    "common": ("Mistakes to look for", "常见错误"),
    "gives": ("{mistake}: {values}", "{mistake}：{values}"),
    "bar": ("100 mm when printed to scale", "按实际尺寸打印时为 100 mm"),
    "seed": ("seed {seed}", "种子 {seed}"),
}
