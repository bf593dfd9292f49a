"""The reference of the Python interface, made of its docstrings: every public name, with what it takes and gives.

>>> "solve_many(mechanisms" in text("solve_many"), "with_(" in text("Mechanism")
(True, True)
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import graphkin

__all__ = ["names", "text"]

_INHERITED = ("Readable", "Measured")
_ALSO = {
    "Builder": "files.builder", "Readable": "model.readout", "Measured": "model.units", "Series": "studies.sweeps",
}  # fmt: skip
"""What public names give or share."""
_QUOTED = re.compile(r"(: |-> )'([^']*)'")


def names() -> tuple[str, ...]:
    """All that has a page: the public names, then what they give."""
    return (*graphkin.__all__, *_ALSO)


def text(*wanted: str) -> str:
    """The pages of these names, of all if none is given."""
    parts = [] if wanted else [inspect.getdoc(import_module("graphkin.api")) or ""]
    return "\n\n".join([*parts, *("\n".join(_page(name)) for name in wanted or names())])


def _page(name: str) -> Iterator[str]:
    found = getattr(import_module(f"graphkin.{_ALSO[name]}"), name) if name in _ALSO else getattr(graphkin, name)
    yield f"{name}{_signature(found) if not inspect.isclass(found) else ''}"
    yield "-" * len(name)
    yield inspect.getdoc(found) or ""
    if inspect.isclass(found):
        for member, value in _members(found):
            yield from ("", f"  .{member}{_signature(value)}")
            yield from (f"      {line}".rstrip() for line in (inspect.getdoc(_function(value)) or "").splitlines())


def _members(cls: type) -> Iterator[tuple[str, Any]]:
    """What a class itself and its own kin say, not what every mapping or exception has."""
    seen: set[str] = set()
    for kin in cls.__mro__:
        if not kin.__module__.startswith("graphkin") or (kin is not cls and kin.__name__ in _INHERITED):
            continue
        for member, value in vars(kin).items():
            if member.startswith("_") or member in seen or not inspect.getdoc(_function(value)):
                continue
            if inspect.isroutine(value) or isinstance(value, property | classmethod | staticmethod):
                seen.add(member)
                yield member, value


def _function(value: Any) -> Any:
    return value.fget if isinstance(value, property) else getattr(value, "__func__", value)


def _signature(value: Any) -> str:
    """`(mechanism: Mechanism, ..) -> Sweep`; nothing of a property."""
    if isinstance(value, property):
        return ""
    try:
        shown = str(inspect.signature(_function(value)))
    except (TypeError, ValueError):
        return ""
    return _QUOTED.sub(r"\1\2", re.sub(r"\((?:self|cls)(?:, )?", "(", shown, count=1))
