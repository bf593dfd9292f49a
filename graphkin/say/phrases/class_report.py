"""The report of a class: which step fails, mistakes, scores."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "title": ("Class report", "班级报告"),
    "marked": (
        "{marked} marked, {unmarked} not marked, {overridden} with the teacher's own points.",
        "已评阅 {marked} 份，未评阅 {unmarked} 份，教师评分 {overridden} 份。",
    ),
    "scores": (
        "Scores: mean {mean}, median {median}, lowest {lowest}, highest {highest} %.",
        "得分率：平均 {mean}，中位数 {median}，最低 {lowest}，最高 {highest} %。",
    ),
    "part steps": ("Where it goes wrong", "错在哪一步"),
    "step": (
        "{name}: {verdicts}; the first to fail for {first}",
        "{name}：{verdicts}；首次出错 {first} 人",
    ),
    "part mistakes": ("Mistakes that the numbers are consistent with", "与结果相符的错误"),
    "mistake": ("{mistake}: {count}", "{mistake}：{count} 人"),
    "part habits": ("Mistakes that a student makes in several problems", "同一学生在几道题中都出现的错误"),
    "habit": ("in {shown} of {of} problems {mistake}: {count}", "{of} 题中有 {shown} 题{mistake}：{count} 人"),
    "unexplained": ("wrong, and no known mistake fits: {count}", "有错误，但没有已知错误与之相符：{count} 人"),
    "range": ("{low} to {high} %: {count}", "{low}–{high} %：{count} 人"),
    "part distribution": ("Distribution of scores", "得分分布"),
    "students": ("students", "人数"),
    "nothing diagnosed": ("No numbers are consistent with a known mistake.", "没有与已知错误相符的结果。"),
    "nobody marked": ("Nobody is marked.", "尚无评阅结果。"),
}
