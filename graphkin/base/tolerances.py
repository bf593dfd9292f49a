"""Tolerances on which several rooms must agree, and both roads; one that serves a single room stands in it."""

from __future__ import annotations

ROUNDED = 1e-6  # figures in files are rounded: lengths that differ by less than this part, and angles [rad], are one
CLOSED = 1e-9  # a gap of less than this part of the mechanism's size is none; so are angles that differ by less [rad]
TOUCH = 1e-11
"""Links that miss each other by less than this part of the mechanism's size at a dead point reach each other there."""
RANK = 1e-6  # singular values of equations in units of the mechanism's size that count as zero
STILL = 1e-9
"""Links that move against each other by less than this part of the fastest motion stand still against each other."""
