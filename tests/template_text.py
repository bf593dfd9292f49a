"""A template of a problem set."""

from __future__ import annotations

from graphkin.homework.problems import drawn_variants


def variants(template, students, seed):
    """All problems of a class in the order of the students."""
    own = {one.student.id: one for one in drawn_variants(template, students, seed)}
    return tuple(own[student.id] for student in students)


TEXT = """# a comment with AB = { from = 1, to = 2 } in it
title  = { en = "Four-bar # with a slide", zh = "含移动副的四杆机构" }
ask    = ["omega 3", "alpha 3", "a_k B3B2"]   # { from = 1, to = 2 }

[points]
"omega 3" = 2
"alpha 3" = 3

[frame]
name = "4"
A = [0, 0]
D = [{ from = 74, to = 84, step = 0.5 }, 0]

[links.1]
AB = { from = 20, to = 28, step = 1 }   # crank

[links.2]
points = ["B"]

[links.3]
DC = 48

[[slide]]
block = "2"
point = "B"
guide = "3"
through = "C"
from = "DC"
angle = 100

[[driver]]
vector = "AB"
angle = { from = 30, to = 150, step = 5 }
omega = { from = "60 rpm", to = "120 rpm", step = "10 rpm" }

[sketch]
C = [65, 46]
"""
