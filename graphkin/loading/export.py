"""The mechanism file's JSON Schema, for editors: they complete keys and mark mistakes while one types.

`graphkin.schema.json` beside this module is the same, written out. An editor finds it by a first line such as
`#:schema ./graphkin.schema.json` in the mechanism file.
"""

from __future__ import annotations

import json
from typing import Any


def json_schema() -> dict[str, Any]:
    """The schema, as plain as possible: defaults are not an editor's business."""
    from graphkin.loading import schema
    from graphkin.loading.fields import kind_of

    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "graphkin mechanism",
        **kind_of(schema.File).json,
        "$defs": {table.__name__: kind_of(table).json for table in schema.DEFINED},
    }


def json_schema_text() -> str:
    """What `graphkin.schema.json` holds."""
    return json.dumps(json_schema(), indent=1, ensure_ascii=False, sort_keys=True) + "\n"
