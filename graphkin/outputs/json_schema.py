"""The mechanism file's JSON Schema, for editors: they complete keys, say what each means and mark mistakes.

`loading/graphkin.schema.json` is the same, written out. An editor finds it by a first line such as
`#:schema ./graphkin.schema.json` in the mechanism file.
"""

from __future__ import annotations

import json

from graphkin.base.plain import Plain
from graphkin.errors import Lang

Json = dict[str, Plain]


def json_schema(lang: Lang = "en") -> Json:
    """The schema, as plain as possible: defaults are not an editor's business."""
    from graphkin.files import schema

    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "graphkin mechanism",
        **_table("file", schema.File, lang),
        "$defs": {kind.__name__: _table(table, kind, lang) for table, kind in schema.TABLES.items() if table != "file"},
    }


def json_schema_text(lang: Lang = "en") -> str:
    """The text of `graphkin.schema.json`."""
    return json.dumps(json_schema(lang), indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def _table(table: str, kind: type, lang: Lang) -> Json:
    """A table's keys with their descriptions."""
    from graphkin.files.fields import keys, kind_of
    from graphkin.files.schema import FURTHER
    from graphkin.say.file_help import described, head

    schema = kind_of(kind).json
    properties = {key: {**schema["properties"][key], "description": described(table, key, lang)} for key in keys(kind)}
    whole = {**schema, "description": head(table, lang), "properties": properties}
    if "patternProperties" in schema:
        further = {"description": described(table, FURTHER, lang)}
        whole["patternProperties"] = {name: {**rest, **further} for name, rest in schema["patternProperties"].items()}
    return whole
