"""One HTML file of scripts, styles and data, which no browser lets ask for anything.

A script of `script/` says by `import {..} from "./dom.js"` which others it needs. They are joined in that order into
one function, without the words import and export: top-level names are therefore different in all of them. The policy
names the digests of the joined script and style; nothing else runs.
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from pathlib import Path

from graphkin.errors import Lang
from graphkin.outputs import files
from graphkin.page.elements import TAGS

FOLDER = Path(__file__).parent / "script"
MARK = "graphkin page"
"""By this graphkin knows a page of its own, which it replaces."""

_IMPORT = re.compile(r'^import\s[^;]*?from "\./(\w+)\.js";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const|let|class)\b)", re.MULTILINE)


def page(
    title: str, lang: Lang, *, scripts: Sequence[str], styles: Sequence[str], data: Mapping[str, object],
    body: str = "",
) -> str:  # fmt: skip
    """The text of a page.

    scripts  the names of those that begin (`player`), the others are theirs; the last one's top level starts the page
    styles   the names of style sheets (`player`), in their order
    data     by the id of the element that holds it: what `json.dumps` writes
    body     HTML that stands there before anything has run
    """
    script = f'(() => {{\n"use strict";\n{joined(scripts)}\n}})();'
    style = "\n".join((FOLDER / f"{name}.css").read_text("utf-8") for name in styles)
    policy = (
        f"default-src 'none'; script-src {_digest(script)}; style-src {_digest(style)}; img-src data:; "
        "base-uri 'none'; form-action 'none'"
    )
    held = "".join(f'<script type="application/json" id="{key}">{_json(value)}</script>\n'
                   for key, value in data.items())  # fmt: skip
    return (
        f'<!DOCTYPE html>\n<html lang="{TAGS[lang]}"><head><meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f'<meta name="generator" content="{MARK}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<link rel="icon" href="data:,"><title>{escape(title)}</title>\n<style>{style}</style></head>\n'
        f"<body>\n{body}{held}<script>{script}</script>\n</body></html>\n"
    )


def watched(text: str) -> str:
    """A page that is read again while nobody works on it, as its file is written again and again."""
    script = f"(() => {{{joined(['watched'])}}})();"
    text = text.replace("script-src ", f"script-src {_digest(script)} ", 1)
    before, end, after = text.rpartition("</body>")
    return f"{before}<script>{script}</script>\n{end}{after}"


def write(path: Path, text: str, force: bool = False) -> None:
    """A page as a file. Raises FileInTheWay where another's is there."""
    files.write(path, text, force, (MARK.encode(),))


def joined(names: Sequence[str]) -> str:
    """Scripts with all that they need, each once and after what it needs."""
    order: dict[str, str] = {}
    for name in names:
        _add(name, order, ())
    return "\n".join(order.values())


def _add(name: str, order: dict[str, str], before: tuple[str, ...]) -> None:
    if name in order or name in before:
        return
    text = (FOLDER / f"{name}.js").read_text("utf-8")
    for other in needed_scripts(text):
        _add(other, order, (*before, name))
    order[name] = _EXPORT.sub("", _IMPORT.sub("", text)).strip() + "\n"


def needed_scripts(text: str) -> Iterable[str]:
    """The names of the scripts that one imports from."""
    return dict.fromkeys(_IMPORT.findall(text))


def _digest(text: str) -> str:
    """A text as a policy names it."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def _json(value: object) -> str:
    """JSON that ends no element it stands in."""
    text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
