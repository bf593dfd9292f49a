"""What a student is told of a submission, and of a number on a platform."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "right": ("Right.", "正确。"),
    "ring": (
        "Close, but less exact than a careful drawing allows. Half of the points.",
        "接近，但精度低于仔细作图所能达到的。得一半分。",
    ),
    "number consistent": ("This number is consistent with: {mistake}", "此数与下述错误相符：{mistake}"),
    "not marked why": ("not marked: {reason}", "未评阅：{reason}"),
    "no reason": ("no reason is given", "未说明原因"),
    "column given": ("your result", "你的结果"),
    "of": ("{points} of {most}", "{points}/{most}"),
    "given": ("you: {value}", "你的结果：{value}"),
    "answer": ("right: {value} ± {tolerance}", "正确值：{value} ± {tolerance}"),
    "carried": (
        "judged with your own {own}: it should be {value}: {agrees}",
        "按你自己的 {own} 计算，应为 {value}：{agrees}",
    ),
    "yes": ("yes", "相符"),
    "no": ("no", "不符"),
    "points of": ("{points} of {most} points", "{points} 分（满分 {most}）"),
    "line": ("{name}: {verdict}", "{name}：{verdict}"),
    "stop": ("{text}.", "{text}。"),
    "consistent": (
        "Your numbers {explains} are consistent with: {mistake}",
        "你的结果 {explains} 与下述错误相符：{mistake}",
    ),
    "habit": ("In {shown} of {of} problems: {told}", "{of} 题中有 {shown} 题：{told}"),
    "one of": ("one of these, which cannot be told apart: {mistakes}", "以下之一（无法区分）：{mistakes}"),
    "note": ("Note: {note}", "提示：{note}"),
    "diagnosis": ("What the numbers are consistent with", "与结果相符的错误"),
    "override": ("Marked by the teacher: {points} of {most} points.", "教师评分：{points} 分（满分 {most}）。"),
    "total": ("Total: {points} of {most} points.", "总分：{points} 分（满分 {most}）。"),
    "title": ("Feedback", "评阅反馈"),
    "title for": ("Feedback for {student}", "{student} 的评阅反馈"),
    "or": (" / ", " / "),
}
