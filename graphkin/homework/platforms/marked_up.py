"""Text that goes into XML, HTML and tables: what no such file can hold is left out, nothing else is changed."""

from __future__ import annotations

import html
import re
import xml.etree.ElementTree as ET

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
    return "<br>".join(html.escape(clean(line), quote=False) for line in _BREAKS.split(text))


def element(tag: str, *content: str | ET.Element, **attributes: str) -> ET.Element:
    """An element with a text, or with its children. A `_` before a name that is a word of Python is not part of it."""
    made = ET.Element(tag, {name.lstrip("_"): clean(value) for name, value in attributes.items()})
    made.text = clean("".join(part for part in content if isinstance(part, str))) or None
    made.extend(part for part in content if not isinstance(part, str))
    return made


def xml(root: ET.Element) -> bytes:
    """An XML file."""
    text = ET.tostring(root, encoding="unicode")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + text.encode() + b"\n"
