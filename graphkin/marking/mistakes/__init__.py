"""The mistakes: one small function each, which says where it can be made. Importing enters them all."""

from __future__ import annotations

from graphkin.marking.mistakes import coriolis

__all__ = ["coriolis"]
