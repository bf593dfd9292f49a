"""Homework: problem sets, grading, and the files of teaching platforms."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

Record: TypeAlias = Mapping[str, Any]  # the record of a submission in a file of marks, as JSON gives it
