"""Files of teaching platforms: columns and titles, and what is left out of them."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "problem title": ("{set}, {id}", "{set} {id}"),
    "column student": ("student", "学号"),
    "column text": ("problem", "题目"),
    "column quantity": ("quantity", "所求量"),
    "column unit": ("unit", "单位"),
    "column points": ("points", "分值"),
    "column percent": ("percent", "得分百分比"),
    "column number": ("number", "数值"),
    "column tolerance": ("tolerance", "允差"),
    "column mistakes": ("mistakes", "错误"),
    "column sentence": ("sentence", "说明"),
    "column file": ("file", "文件"),
    "column status": ("status", "状态"),
    "column earned": ("points", "得分"),
    "column most": ("out of", "满分"),
    "column override": ("override", "override"),
    "column total": ("total", "总分"),
    "column score percent": ("score, %", "得分率（%）"),
    "column part earned": ("{name} points", "{name} 得分"),
    "column diagnosis": ("consistent with", "与之相符的错误"),
    "column reason": ("reason", "原因"),
    "column habits": ("in several problems", "多题中出现的错误"),
    "habit": (
        "{mistake} ({shown} of {of} problems, evidence {evidence})", "{mistake}（{of} 题中 {shown} 题，证据 {evidence}）",
    ),
    "no platform name": (
        "{count} submissions are not named as {platform} names its downloads (the first: {file}): nothing goes "
        "back for them. Mark the archive as it was downloaded.",
        "{count} 份提交的文件名不是 {platform} 下载包中的格式（如 {file}），无法回传。请直接评阅平台下载的压缩包。",
    ),
    "no feedback in kind": (
        "Canvas takes feedback back only as the kind of file that was handed in, and graphkin writes none of "
        "kind {kind}: {count} submissions have marks and no file of feedback.",
        "Canvas 只接受与提交文件同类的反馈文件，而 graphkin 不写 {kind} 类文件：{count} 份提交只有分数，没有反馈"
        "文件。",
    ),
    "override kept": (
        "{student} has an override and nothing among these submissions; the override is kept.",
        "{student} 有 override，但不在本次提交中；已保留该 override。",
    ),
}
