"""The manual's own text, `manual.md`: from `#en` on English, from `#zh` on Chinese."""

from __future__ import annotations

import re
from pathlib import Path

from graphkin.errors import Lang

_PAIR, _ONE = re.compile(r"(?m)#en (.*?) #zh (.*)$"), re.compile(r"#(?:en|zh) ")


def skeleton(lang: Lang) -> str:
    """The manual's own text, and lines that say what stands between."""
    both = Path(__file__).with_suffix(".md").read_text("utf-8")
    each = _PAIR.sub(r"\2" if lang == "zh" else r"\1", both).splitlines()
    lines = (line.removeprefix(f"#{lang} ") for line in each if not _ONE.match(line) or line.startswith(f"#{lang} "))
    return re.sub("\n{3,}", "\n\n", "\n".join([*lines, ""]))


def description(command: str, lang: Lang) -> str:
    """What the manual's own text says of a command: paragraphs whose lines stay as they are."""
    told = "".join(re.findall(rf"(?m)^\{{run {command} ?.*\}}\n((?:.+\n)*)", skeleton(lang)))
    return "\n\n".join(f"\b\n{line}" for line in told.splitlines())
