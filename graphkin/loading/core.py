"""What checks the tables: pydantic's core, without the descriptions of schemas that come with it.

`pydantic_core` itself describes, for type checkers, every schema there can be, which takes longer than reading a file
does. The compiled module inside it needs none of that. It is loaded alone and entered nowhere: who imports
`pydantic_core` later gets the whole of it, with these very classes.
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.machinery import PathFinder
from types import ModuleType
from typing import TYPE_CHECKING, Any

__all__ = ["PydanticCustomError", "Schema", "SchemaValidator", "ValidationError"]

Schema = dict[str, Any]
"""What a value must be, as pydantic's core reads it: `type`, and what belongs to that type."""

_PACKAGE, _CORE = "pydantic_core", "pydantic_core._pydantic_core"


def _core() -> ModuleType:
    """The compiled module."""
    package = None if _PACKAGE in sys.modules else PathFinder.find_spec(_PACKAGE)
    spec = package and PathFinder.find_spec(_CORE, package.submodule_search_locations)
    loader = spec.loader if spec else None
    module = loader.create_module(spec) if spec and loader else None
    if loader is None or module is None:
        return import_module(_CORE)
    loader.exec_module(module)
    return module


if TYPE_CHECKING:
    from pydantic_core import PydanticCustomError, SchemaValidator, ValidationError
else:
    _CHECKER = _core()
    PydanticCustomError, SchemaValidator = _CHECKER.PydanticCustomError, _CHECKER.SchemaValidator
    ValidationError = _CHECKER.ValidationError
