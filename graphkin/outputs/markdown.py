"""Markdown as HTML, as far as graphkin's own texts go: headings, lists, tables, code, links; elements stay as they are.

>>> html("## A *b*\\n\\n- `c | d`\\n- [e](#f)")
'<h2 id="a-b">A <i>b</i></h2>\\n<ul><li><p><code>c | d</code></p></li><li><p><a href="#f">e</a></p></li></ul>'
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from html import escape

_BLOCKS = re.compile(
    r"```.*\n(?P<fence>(?s:.*?))^```$"
    r"|(?P<level>#+) (?P<head>.*)"
    r"|(?P<table>(?:\|.*\n?)+)"
    r"|(?P<list>(?:-|[0-9]+\.) (?:.*\n?|\n(?= +\S))+?)(?=\n\S|\n\n(?! )|\Z)"
    r"|(?P<code>(?: {4}.*\n?|\n(?= {4}))+)"
    r"|(?P<words>(?:.+\n?)+)", re.M,
)  # fmt: skip
_ITEM = re.compile(r"(?m)^(?:-|[0-9]+\.) ")
_MARKUP = (
    (r"\[([^]]*)\]\(([^)]*)\)", r'<a href="\2">\1</a>'),
    (r"\*\*([^*]+)\*\*", r"<b>\1</b>"), (r"\*([^*]+)\*", r"<i>\1</i>"),
)  # fmt: skip


def slug(head: str) -> str:
    """The anchor of a heading, as GitHub makes it."""
    return re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-")


def html(text: str) -> str:
    """The elements of a text."""
    return "\n".join(_elements(text))


def _elements(text: str) -> Iterator[str]:
    for block in _BLOCKS.finditer(text):
        said = block[block.lastgroup or 0].rstrip("\n")
        match block.lastgroup:
            case "fence" | "code":
                yield f"<pre>{escape(textwrap.dedent(said))}</pre>"
            case "head":
                level = len(block["level"])
                yield f'<h{level} id="{slug(said)}">{_words(said)}</h{level}>'
            case "table":
                rows = [re.split(r"(?<!\\)\|", line.strip("|")) for line in said.split("\n")]
                yield f"<table>{_row('th', rows[0])}{''.join(_row('td', row) for row in rows[2:])}</table>"
            case "list":
                items = (re.sub(r"(?m)^ {1,3}", "", item).strip() for item in _ITEM.split(said)[1:])
                first = said.split(".")[0]
                kind, start = ("ul", "") if said.startswith("-") else ("ol", f' start="{first}"')
                yield f"<{kind}{start}>{''.join(f'<li>{html(item)}</li>' for item in items)}</{kind}>"
            case _:
                yield said if said.startswith("<") else f"<p>{_words(said)}</p>"


def _row(tag: str, cells: list[str]) -> str:
    return f"<tr>{''.join(f'<{tag}>{_words(cell.strip())}</{tag}>' for cell in cells)}</tr>"


def _words(text: str) -> str:
    """A line: code stays as it is, an element, too."""
    if text.startswith("<"):
        return text
    pieces = re.split(r"`([^`]+)`", escape(text.replace(r"\|", "|"), quote=False))
    for pattern, element in _MARKUP:
        pieces[::2] = [re.sub(pattern, element, piece) for piece in pieces[::2]]
    return "".join(f"<code>{piece}</code>" if k % 2 else piece for k, piece in enumerate(pieces))
