"""The mistakes: one small function each, which says where it can be made. Importing enters them all.

`centres`: ratios of rotations. `conversions`: units, scales and written answers. `coriolis`. `directions`: of unknown
arrows. `driving`: what is given. `link_motion`: images, normal accelerations, a diameter for a radius. `readings`:
omega, alpha and segments of the polygon.
"""

from __future__ import annotations

from graphkin.marking.mistakes import centres, conversions, coriolis, directions, driving, link_motion, readings

__all__ = ["centres", "conversions", "coriolis", "directions", "driving", "link_motion", "readings"]
