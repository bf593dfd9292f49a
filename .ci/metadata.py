"""README.md as a package index shows it: its pictures and links by their addresses in the repository."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

LINK = re.compile(r"(!?)\[([^]]*)\]\((?!https?:|#)([^)]+)\)")


def with_addresses(text: str, home: str) -> str:
    """A picture as the file that it is, anything else as the page that GitHub makes of it."""
    raw = home.replace("//github.com/", "//raw.githubusercontent.com/")
    return LINK.sub(lambda m: f"{m[1]}[{m[2]}]({f'{raw}/main' if m[1] else f'{home}/blob/main'}/{m[3]})", text)


class Readme(MetadataHookInterface):
    """Called by hatchling for wheel and sdist."""

    def update(self, metadata: dict[str, Any]) -> None:
        text = with_addresses((Path(self.root) / "README.md").read_text("utf-8"), metadata["urls"]["Repository"])
        metadata["readme"] = {"content-type": "text/markdown", "text": text}
