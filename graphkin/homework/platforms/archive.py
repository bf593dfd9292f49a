"""Zip files that are the same for the same members: no clock, no machine, and names that stay inside."""

from __future__ import annotations

import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import BinaryIO

_COMMENT = b"graphkin"
ZIP_MARKS = (_COMMENT,)
"""At the end of each archive: by this graphkin knows its own."""
_LONG_AGO = (1980, 1, 1, 0, 0, 0)
_NOWHERE = frozenset('\\:*?"<>|')
"""Letters that no file of Windows has in its name."""


def pack(file: Path | BinaryIO, members: Iterable[tuple[str, bytes | Iterable[bytes]]]) -> None:
    """Write an archive, member by member, a long one part by part; of two of one name the first is kept."""
    written: set[str] = set()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.comment = _COMMENT
        for name, data in members:
            if name not in written:
                written.add(name)
                with archive.open(member(name), "w", force_zip64=not isinstance(data, bytes)) as room:
                    for part in [data] if isinstance(data, bytes) else data:
                        room.write(part)


def member(name: str) -> zipfile.ZipInfo:
    """A member without a time, readable by all."""
    made = zipfile.ZipInfo(name, _LONG_AGO)
    made.compress_type, made.create_system, made.external_attr = zipfile.ZIP_DEFLATED, 3, 0o644 << 16
    return made


def inside(name: str) -> bool:
    """Whether a member of this name can be unpacked on any system, and stays inside the folder it is unpacked in."""
    return name.isprintable() and not set(name) & _NOWHERE and all(
        part and part == part.strip() and part.strip(".") for part in name.split("/")
    )
