"""The mistakes: one small function each, which says where it can be made. Importing enters them all.

`driving`: what is given. `directions`: of unknown arrows. `rotations`: omega and alpha read off, and segments of the
polygon. `images`; `normals`; `coriolis`: the known terms. `conversions`: units and scales. `centres`; `contacts`.
"""

from __future__ import annotations

from graphkin.marking.mistakes import (
    centres,
    contacts,
    conversions,
    coriolis,
    directions,
    driving,
    images,
    normals,
    rotations,
)

__all__ = [
    "centres", "contacts", "conversions", "coriolis", "directions", "driving", "images", "normals", "rotations",
]  # fmt: skip
