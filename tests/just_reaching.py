"""Four-bars whose links only just reach round their frame: it is as long as the other three, or all but."""

from __future__ import annotations

FOUR_BAR = """
[frame]
A = [0, 0]
D = [{frame}, 0]
[links.1]
AB = {crank}
[links.2]
BC = {coupler}
[links.3]
DC = {rocker}
[[driver]]
vector = "AB"
angle = {angle}
omega = 10
[sketch]
C = [{x}, 46]
"""
TOUCHING = FOUR_BAR.format(frame=78, crank=24, coupler=6, rocker=48, angle=60, x=65)
"""24 + 6 + 48 = 78 mm."""
STRETCHED = FOUR_BAR.format(frame=89.9999999, crank=20, coupler=40, rocker=30, angle=0, x=60)
"""20 + 40 + 30 = 90 mm, to rounding."""
