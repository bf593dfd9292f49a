"""TOML -> `Mechanism`, with errors that name file, line and key.

    file --source--> text --tomllib, positions--> data and lines --schema, measures--> tables in SI
         --links (shapes), slides, contacts, drivers, joints--> Mechanism

`units` is the closed table of units, `fields` the kinds of value. A new pair kind needs a table in `schema` (and its
name in `TABLES` there and in `complaints.TABLES`) and a reader beside `slides` and `contacts`, called in `loader`.
"""

from graphkin.loading.loader import Mechanism, from_dict, load, load_stream, loads
from graphkin.loading.questions import remarks

__all__ = ["Mechanism", "from_dict", "load", "load_stream", "loads", "remarks"]
