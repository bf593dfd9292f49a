"""Tables of results."""

from graphkin.say.catalogue import Phrases

PHRASES: Phrases = {
    "quantity": ("quantity", "量"),
    "graphical": ("construction replayed", "按作图步骤重演"),
    "analytic": ("analytic", "解析法"),
    "difference": ("difference", "差"),
    "unit": ("unit", "单位"),
    "position": ("position", "位置"),
    "asked": ("asked", "所求"),
    "not answered": ("not answered by this command", "本命令不作答"),
    "worst": ("worst relative difference", "最大相对误差"),
}
