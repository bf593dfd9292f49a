"""Plain data: what JSON can hold."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeAlias, Union

Plain: TypeAlias = Union[bool, int, float, str, "Sequence[Plain]", "Mapping[str, Plain]", None]
"""What JSON can hold, to be written; what is read is `object` until it is looked at."""
