"""Packages that only some files need: imported when such a file is written, and named where they are not there."""

from __future__ import annotations

from importlib import import_module
from typing import Any, ClassVar

from graphkin.errors import GraphkinError, Lang


class NeedsExtra(GraphkinError):
    """A file whose writer is a package that is not installed."""

    package: str
    extra: str

    text: ClassVar[dict[Lang, str]] = {
        "en": "This kind of file is written by {package}, which is not installed. "
        "Install it: pip install 'graphkin[{extra}]'.",
        "zh": "写这种文件需要 {package}，尚未安装。请安装：pip install 'graphkin[{extra}]'。",
    }


def needed(package: str, extra: str) -> Any:
    """A package by name, imported. Raises NeedsExtra."""
    try:
        return import_module(package)
    except ImportError:
        raise NeedsExtra(package, extra) from None
