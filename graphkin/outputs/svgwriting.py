"""svgwrite, without what it reads fonts from the net with, what it checks drawings with, and elements no sheet has.

They take long to load, and come where they are first used, which graphkin never does.
"""

from __future__ import annotations

import sys
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

_LATER = {
    "urllib.request": ("urlopen",),
    "svgwrite.validator2": ("get_validator",),
    "svgwrite.data.pattern": (),
    "svgwrite.animate": ("Animate", "AnimateColor", "AnimateMotion", "AnimateTransform", "Set"),
    "svgwrite.filters": ("Filter",),
    "svgwrite.gradients": ("LinearGradient", "RadialGradient"),
    "svgwrite.image": ("Image",),
    "svgwrite.masking": ("ClipPath", "Mask"),
    "svgwrite.pattern": ("Pattern",),
    "svgwrite.solidcolor": ("SolidColor",),
}
"""The functions that svgwrite takes from each when it loads."""
_GIVES_LATER = ("get_validator",)
"""Called when it loads, too, for what is used later."""


def svgwrite() -> Any:
    """The package."""
    if "svgwrite" in sys.modules:
        return import_module("svgwrite")
    later = {name: _Later(name) for name in _LATER if name not in sys.modules}
    sys.modules |= later
    try:
        return import_module("svgwrite")
    finally:
        for name, module in later.items():
            if sys.modules.get(name) is module:
                del sys.modules[name]


class _Later(ModuleType):
    """Stands for a module while svgwrite loads; whoever asks it for anything gets it from the module itself."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name in _LATER[self.__name__]:
            return partial(_Result if name in _GIVES_LATER else _called, self.__name__, name)
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def _called(module: str, function: str, *args: Any, **named: Any) -> Any:
    return getattr(import_module(module), function)(*args, **named)


class _Result:
    """What a function gives, once something is asked of that."""

    def __init__(self, *call: Any, **named: Any) -> None:
        self._call = partial(_called, *call, **named)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._call(), name)
