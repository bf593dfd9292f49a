"""svgwrite, without what it reads fonts from the net with: that takes as long to load as all the rest of it.

It comes where it is first used, which graphkin never does.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import Any

_NET = "urllib.request"


def svgwrite() -> Any:
    """The package."""
    if "svgwrite" in sys.modules or _NET in sys.modules:
        return import_module("svgwrite")
    later = sys.modules[_NET] = _Later(_NET)
    try:
        return import_module("svgwrite")
    finally:
        if sys.modules.get(_NET) is later:
            del sys.modules[_NET]


class _Later(ModuleType):
    """Stands for the module while svgwrite loads; whoever asks it for anything gets it from the module itself."""

    @staticmethod
    def urlopen(*args: Any, **named: Any) -> Any:
        return import_module(_NET).urlopen(*args, **named)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if sys.modules.get(_NET) is self:
            del sys.modules[_NET]
        return getattr(import_module(_NET), name)
