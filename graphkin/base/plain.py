"""Plain data, as JSON can hold it, and a checksum over it."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TypeAlias, Union

try:  # as `random` does: all of hashlib, with OpenSSL, takes longer to load than a sheet takes to write
    from _sha256 import sha256  # type: ignore[import-not-found]
except ImportError:
    from hashlib import sha256

Plain: TypeAlias = Union[bool, int, float, str, "Sequence[Plain]", "Mapping[str, Plain]", None]
"""Data that JSON can hold, to be written; what is read is `object` until it is looked at."""


def seal(claims: Mapping[str, object]) -> str:
    """A checksum (SHA-256, hexadecimal) over everything a drawing says of itself but the seal."""
    sealed = {key: value for key, value in claims.items() if key != "seal"}
    text = json.dumps(sealed, ensure_ascii=False, sort_keys=True)
    return str(sha256(text.encode("utf-8", "surrogatepass")).hexdigest())
