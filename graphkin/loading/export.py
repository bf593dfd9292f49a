"""The mechanism file's JSON Schema, for editors: they complete keys and mark mistakes while one types.

`graphkin.schema.json` beside this module is the same, written out. An editor finds it by a first line such as
`#:schema ./graphkin.schema.json` in the mechanism file.
"""

from __future__ import annotations

import json
from typing import Any

__all__ = ["json_schema", "json_schema_text"]


def json_schema() -> dict[str, Any]:
    """The schema, as plain as possible: TOML has no null, and defaults are not an editor's business."""
    from graphkin.loading.schema import File

    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", **_plain(File.model_json_schema())}
    return schema | {"title": "graphkin mechanism"}


def json_schema_text() -> str:
    """What `graphkin.schema.json` holds."""
    return json.dumps(json_schema(), indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def _plain(node: Any) -> Any:
    """Without pydantic's titles, defaults and nulls."""
    if isinstance(node, list):
        return [_plain(item) for item in node]
    if not isinstance(node, dict):
        return node
    if "anyOf" in node and {"type": "null"} in node["anyOf"]:
        (inner,) = (option for option in node["anyOf"] if option != {"type": "null"})
        return _plain({**{key: value for key, value in node.items() if key != "anyOf"}, **inner})
    dropped = {key for key in ("title", "default") if not isinstance(node.get(key), dict) or key == "default"}
    return {key: _plain(value) for key, value in node.items() if key not in dropped}
