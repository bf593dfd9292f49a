"""A seal on what a drawing file says of itself: text, drivers and scales, as they were when it was drawn."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence

__all__ = ["seal"]


def seal(text: str, drivers: Sequence[float], scales: Mapping[str, float]) -> str:
    """A checksum (SHA-256, hexadecimal) over the mechanism's text, its driver values and the scales."""
    sealed = json.dumps([text, list(drivers), dict(sorted(scales.items()))], ensure_ascii=False)
    return hashlib.sha256(sealed.encode("utf-8", "surrogatepass")).hexdigest()
