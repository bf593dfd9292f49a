"""A seal on what a drawing file says of itself, as it was when the file was written."""

from __future__ import annotations

import json
from collections.abc import Mapping

try:  # as `random` does: all of hashlib, with OpenSSL, takes longer to load than a sheet takes to write
    from _sha256 import sha256  # type: ignore[import-not-found]
except ImportError:
    from hashlib import sha256

__all__ = ["seal"]


def seal(claims: Mapping[str, object]) -> str:
    """A checksum (SHA-256, hexadecimal) over everything a drawing says of itself but the seal."""
    told = {key: value for key, value in claims.items() if key != "seal"}
    text = json.dumps(told, ensure_ascii=False, sort_keys=True)
    return str(sha256(text.encode("utf-8", "surrogatepass")).hexdigest())
