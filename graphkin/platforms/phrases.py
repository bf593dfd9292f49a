"""What platforms are told, English and Chinese side by side, with the same placeholders."""

from __future__ import annotations

from collections.abc import Mapping

from graphkin.errors import Lang

__all__ = ["PHRASES", "say"]

PHRASES: Mapping[str, tuple[str, str]] = {
    # --- sets ----------------------------------------------------------------------------------
    "right": ("Right.", "正确。"),
    "ring": (
        "Close, but less exact than a careful drawing allows. Half of the points.",
        "接近，但精度低于仔细作图所能达到的。得一半分。",
    ),
    "number consistent": ("This number is consistent with: {mistake}", "此数与下述错误相符：{mistake}"),
    "problem title": ("{set}, {id}", "{set} {id}"),
    "column student": ("student", "学号"),
    "column text": ("problem", "题目"),
    "column quantity": ("quantity", "所求量"),
    "column unit": ("unit", "单位"),
    "column points": ("points", "分值"),
    "column percent": ("percent", "得分百分比"),
    "column number": ("number", "数值"),
    "column tolerance": ("tolerance", "容差"),
    "column mistakes": ("mistakes", "错误"),
    "column sentence": ("sentence", "说明"),
    # --- class table ---------------------------------------------------------------------------
    "column file": ("file", "文件"),
    "column status": ("status", "状态"),
    "column earned": ("points", "得分"),
    "column most": ("out of", "满分"),
    "column override": ("override", "override"),
    "column total": ("total", "总分"),
    "column part earned": ("{name} points", "{name} 得分"),
    "column diagnosis": ("consistent with", "与之相符的错误"),
    "column reason": ("reason", "原因"),
    "marked": ("marked", "已评阅"),
    "not marked": ("not marked", "未评阅"),
    "not marked why": ("not marked: {reason}", "未评阅：{reason}"),
    "no reason": ("no reason is given", "未说明原因"),
    # --- verdicts ------------------------------------------------------------------------------
    "verdict right": ("right", "正确"),
    "verdict carried": ("right from your own earlier value", "由前面自己的结果推得，正确"),
    "verdict wrong": ("wrong", "错误"),
    "verdict missing": ("missing", "缺"),
    "wrong unit": ("{verdict}, the unit", "{verdict}（单位）"),
    "wrong sense": ("{verdict}, the sense", "{verdict}（转向）"),
    "given": ("you: {value}", "你的结果：{value}"),
    "answer": ("right: {value} ± {tolerance}", "正确值：{value} ± {tolerance}"),
    "carried": (
        "judged with your own {own}: it should be {value}: {agrees}", "按你自己的 {own} 计算，应为 {value}：{agrees}",
    ),
    "yes": ("yes", "相符"),
    "no": ("no", "不符"),
    "points of": ("{points} of {most} points", "{points} 分（满分 {most}）"),
    "line": ("{name}: {verdict}", "{name}：{verdict}"),
    "after": ("; {more}", "；{more}"),
    "stop": ("{text}.", "{text}。"),
    "consistent": (
        "Your numbers {explains} are consistent with: {mistake}", "你的结果 {explains} 与下述错误相符：{mistake}",
    ),
    "one of": ("one of these, which cannot be told apart: {mistakes}", "以下之一（无法区分）：{mistakes}"),
    "or": (" / ", " / "),
    "more": ("{count} more", "另有 {count} 种"),
    "together": (", together with ", "，同时"),
    "note": ("Note: {note}", "提示：{note}"),
    "and": (", ", "、"),
    "diagnosis": ("What the numbers are consistent with", "与结果相符的错误"),
    "override": ("Marked by the teacher: {points} of {most} points.", "教师评分：{points} 分（满分 {most}）。"),
    "total": ("Total: {points} of {most} points.", "总分：{points} 分（满分 {most}）。"),
    "feedback title": ("Feedback", "评阅反馈"),
    "feedback for": ("Feedback for {student}", "{student} 的评阅反馈"),
    # --- what was left out ---------------------------------------------------------------------
    "no platform name": (
        "{count} submissions are not named as {platform} names its downloads (the first: {file}): nothing goes back "
        "for them. Mark the archive as it was downloaded.",
        "{count} 份提交的文件名不是 {platform} 下载包中的格式（如 {file}），无法回传。请直接评阅平台下载的压缩包。",
    ),
    "no feedback in kind": (
        "Canvas takes feedback back only as the kind of file that was handed in, and graphkin writes none of kind "
        "{kind}: {count} submissions have marks and no file of feedback.",
        "Canvas 只接受与提交文件同类的反馈文件，而 graphkin 不写 {kind} 类文件：{count} 份提交只有分数，没有反馈文件。",
    ),
    "override kept": (
        "{student} has an override and nothing among these submissions; the override is kept.",
        "{student} 有 override，但不在本次提交中；已保留该 override。",
    ),
    # --- class report --------------------------------------------------------------------------
    "report title": ("Class report", "班级报告"),
    "report marked": (
        "{marked} marked, {unmarked} not marked, {overridden} with the teacher's own points.",
        "已评阅 {marked} 份，未评阅 {unmarked} 份，教师评分 {overridden} 份。",
    ),
    "report scores": (
        "Scores: mean {mean}, median {median}, lowest {lowest}, highest {highest} %.",
        "得分率：平均 {mean}，中位数 {median}，最低 {lowest}，最高 {highest} %。",
    ),
    "report steps": ("Where it goes wrong", "错在哪一步"),
    "report step": (
        "{name}: right {right}, carried {carried}, wrong {wrong}, missing {missing}; the first to fail for {first}",
        "{name}：正确 {right}，沿用 {carried}，错误 {wrong}，缺 {missing}；首次出错 {first} 人",
    ),
    "report mistakes": ("Mistakes that the numbers are consistent with", "与结果相符的错误"),
    "report mistake": ("{mistake}: {count}", "{mistake}：{count} 人"),
    "report unexplained": (
        "wrong, and no known mistake fits: {count}", "有错误，但没有已知错误与之相符：{count} 人",
    ),
    "report range": ("{low} to {high} %: {count}", "{low}–{high} %：{count} 人"),
    "report distribution": ("Distribution of scores", "得分分布"),
    "students": ("students", "人数"),
    "score percent": ("score, %", "得分率（%）"),
    "legend right": ("right", "正确"),
    "legend carried": ("carried", "沿用"),
    "legend wrong": ("wrong", "错误"),
    "legend missing": ("missing", "缺"),
}  # fmt: skip
"""By key: English, Chinese."""


def say(key: str, lang: Lang, **words: object) -> str:
    """The phrase of this key with these words put in."""
    en, zh = PHRASES[key]
    return (zh if lang == "zh" else en).format(**words)
