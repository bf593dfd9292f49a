"""Texts in XML and HTML, and archives of files.

Of a text that goes into a file, what no such file can hold is left out; nothing else is changed. An archive is the same
for the same members: no clock, no machine, and names that stay inside.
"""

from __future__ import annotations

import html
import re
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

from graphkin.outputs.files import beside

_NOT_IN_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufdd0-\ufdef\ufffe\uffff]")
_BREAKS = re.compile(r"[ \t]*(?:\r\n|[\r\n\x0b\x0c\x85\u2028\u2029])[ \t]*")


def clean(text: str) -> str:
    """Without the characters that no XML file can hold."""
    return _NOT_IN_XML.sub("", text)


def one_line(text: str) -> str:
    """A text whose lines are one."""
    return clean(_BREAKS.sub(" ", text)).strip()


def in_html(text: str) -> str:
    """A plain text as HTML that stands between tags."""
    return "<br>".join(html.escape(line, quote=False) for line in broken(text))


def broken(text: str) -> list[str]:
    """The lines of a plain text."""
    return [clean(line) for line in _BREAKS.split(text)]


def element(tag: str, *content: str | ET.Element, **attributes: str) -> ET.Element:
    """An element with a text, or with its children. A `_` before a name that is a word of Python is not part of it."""
    whole = ET.Element(tag, {name.lstrip("_"): clean(value) for name, value in attributes.items()})
    whole.text = clean("".join(part for part in content if isinstance(part, str))) or None
    whole.extend(part for part in content if not isinstance(part, str))
    return whole


def xml(root: ET.Element) -> bytes:
    """An XML file."""
    text = ET.tostring(root, encoding="unicode")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + text.encode() + b"\n"


_COMMENT = b"graphkin"
ZIP_MARKS = (_COMMENT,)  # at the end of each archive: by this graphkin knows its own
_LONG_AGO = (1980, 1, 1, 0, 0, 0)
_NOWHERE = frozenset('\\:*?"<>|')  # letters that no file of Windows has in its name


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


def write_file(
    path: Path, data: str | bytes | Iterable[tuple[str, bytes | Iterable[bytes]]], force: bool, marks: Sequence[bytes]
) -> Path:
    """A file of a text or of bytes, or an archive of members. Raises FileInTheWay, NoFolder, CannotWrite."""
    with beside(path, force, marks) as draft:
        if isinstance(data, str | bytes):
            draft.write_bytes(data.encode() if isinstance(data, str) else data)
        else:
            pack(draft, data)
    return path


def member(name: str) -> zipfile.ZipInfo:
    """A member without a time, readable by all."""
    info = zipfile.ZipInfo(name, _LONG_AGO)
    info.compress_type, info.create_system, info.external_attr = zipfile.ZIP_DEFLATED, 3, 0o644 << 16
    return info


def inside(name: str) -> bool:
    """True where a member of this name can be unpacked on any system, and stays inside the folder it is unpacked in."""
    return name.isprintable() and not set(name) & _NOWHERE and all(
        part and part == part.strip() and part.strip(".") for part in name.split("/")
    )


# --- files of an office: Word, Excel ----------------------------------------------------------------------------------

OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_LINKS = "http://schemas.openxmlformats.org/package/2006/relationships"
_TYPES = "http://schemas.openxmlformats.org/package/2006/content-types"


def office_package(parts: Iterable[tuple[str, str]], main: str) -> Iterator[tuple[str, bytes]]:
    """The first members of an office file. parts: names of further ones, each with its kind; main: the chief one."""
    kinds = (("rels", "application/vnd.openxmlformats-package.relationships+xml"), ("xml", "application/xml"),
             ("png", "image/png"))  # fmt: skip
    yield "[Content_Types].xml", xml(element(
        "Types", *(element("Default", Extension=end, ContentType=kind) for end, kind in kinds),
        *(element("Override", PartName=part, ContentType=kind) for part, kind in parts), xmlns=_TYPES,
    ))  # fmt: skip
    yield "_rels/.rels", office_link("officeDocument", main)


def office_link(kind: str, *targets: str) -> bytes:
    """A file of relationships."""
    links = (element("Relationship", Id=f"rId{k}", Type=f"{OFFICE}/{kind}", Target=target)
             for k, target in enumerate(targets, 1))  # fmt: skip
    return xml(element("Relationships", *links, xmlns=_LINKS))
