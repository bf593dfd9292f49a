"""Files to start from, one for each kind of mechanism, with comments in either language. `graphkin new four-bar`.

A new kind is a new file `KIND.toml`; each of its comments is `#en .. #zh ..`, and `text` keeps one of the two.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from graphkin.errors import Lang

__all__ = ["SCHEMA", "kinds", "text"]

SCHEMA = "https://raw.githubusercontent.com/graphkin/graphkin/main/graphkin/files/graphkin.schema.json"
"""The address of the JSON Schema, for editors."""

_COMMENT = re.compile(r"#en (.*?) #zh (.*)$", re.MULTILINE)


@cache
def kinds() -> tuple[str, ...]:
    """The kinds there are."""
    return tuple(sorted(file.stem for file in Path(__file__).parent.glob("*.toml")))


def text(kind: str, lang: Lang) -> str:
    """The file of one of `kinds`, its comments in this language; by its first line editors know it."""
    whole = (Path(__file__).parent / f"{kind}.toml").read_text("utf-8")
    return f"#:schema {SCHEMA}\n" + _COMMENT.sub(r"# \2" if lang == "zh" else r"# \1", whole)
