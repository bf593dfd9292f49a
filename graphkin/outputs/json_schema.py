"""The mechanism file's JSON Schema, for editors: they complete keys, say what each means and mark mistakes.

`files/graphkin.schema.json` is the same, written out. An editor finds it by the first line that `graphkin new` writes,
or by `#:schema ./graphkin.schema.json` beside the mechanism file. Problem templates are right by it, too.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping

from graphkin.base.plain import Plain
from graphkin.errors import Lang
from graphkin.files.starters import SCHEMA
from graphkin.files.values import UNITS
from graphkin.model.mechanism import Dimension

Json = dict[str, Plain]

_NUMBER = r"(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?"


def json_schema(lang: Lang = "en") -> Json:
    """The schema, as plain as possible: defaults are not an editor's business."""
    from graphkin.files import schema

    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **({"$id": SCHEMA} if lang == "en" else {}),  # it lies there in English
        "title": "graphkin mechanism",
        **_table("file", schema.File, lang),
        "$defs": {
            **{kind.__name__: _table(table, kind, lang) for table, kind in schema.TABLES.items()
               if table not in ("file", "sketch")},
            **{name: rule for dimension in UNITS for name, rule in _quantities(dimension)},
        },
    }  # fmt: skip


def _quantities(dimension: Dimension) -> Iterator[tuple[str, Json]]:
    """The rules for a quantity, a number, a text with a unit or the range of a template: of any size, and bounded."""
    bounds: Mapping[str, Json] = {"": {}, "_above_zero": {"exclusiveMinimum": 0}, "_from_zero": {"minimum": 0}}
    units = "|".join(unit.replace("/", " ?/ ?").replace("²", r"(²|\^?2)") for unit in UNITS[dimension])
    for end, bound in bounds.items():
        if bound and dimension not in ("length", "angle"):
            continue
        name, sign = dimension.replace(" ", "_") + end, "[+]?" if bound else "[+-]?"
        text = rf"^ *{sign}{_NUMBER} *({units}) *$"
        end_or_step: Json = {"$ref": f"#/$defs/{name}", "type": ["number", "string"]}
        yield name, {"type": ["number", "string", "object"], "pattern": text, **bound, "required": ["from", "to"],
                     "patternProperties": {"^(from|to|step)$": end_or_step}, "additionalProperties": False}  # fmt: skip


def json_schema_text(lang: Lang = "en") -> str:
    """The text of `graphkin.schema.json`."""
    return _written(json_schema(lang), "") + "\n"


def _written(node: Plain, indent: str) -> str:
    """A node as JSON: one that fits a line stands on one."""
    line = json.dumps(node, ensure_ascii=False, sort_keys=True)
    if not isinstance(node, dict) or len(line) <= 360:
        return line
    inner = ",\n".join(f"{indent} {json.dumps(key)}: {_written(node[key], indent + ' ')}" for key in sorted(node))
    return f"{{\n{inner}\n{indent}}}"


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
