"""Verdicts and what goes with them: one word for each, on the terminal, in feedback, in tables and reports."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "verdict right": ("right", "正确"),
    "verdict carried": ("carried", "沿用正确"),
    "verdict wrong": ("wrong", "错误"),
    "verdict missing": ("missing", "未答"),
    "verdict dead point": ("near a dead point: paper cannot tell this value", "接近死点，图上无法确定该值"),
    "verdict too small": ("less than a pencil errs by: paper cannot tell this value", "小于作图误差，图上无法确定该值"),
    "verdict wrong sense": ("wrong sense", "转向（符号）相反"),
    "verdict wrong direction": ("wrong direction", "方向错误"),
    "verdict wrong unit": ("wrong unit", "单位不符"),
    "status marked": ("marked", "已评阅"),
    "status not marked": ("not marked", "未评阅"),
    "tolerance": ("tolerance", "允差"),
    "carried means": (
        "Carried: it follows rightly from your own earlier value, and counts as right.",
        "沿用正确：由你自己前面的结果正确推得，按正确计分。",
    ),
}
