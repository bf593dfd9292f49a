"""The page of the mechanism file: every key, what it says, its unit, an example. `graphkin help file`.

The same sentences are the descriptions of the JSON Schema. They stand in the catalogue: `file_keys` by table and key,
`file_page` for what is said of a table and of the whole.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphkin.errors import Lang
from graphkin.files.fields import keys
from graphkin.files.schema import FURTHER, TABLES
from graphkin.files.values import UNITS
from graphkin.model.mechanism import Dimension
from graphkin.say.catalogue import phrase, say
from graphkin.say.text_table import in_lines

_WIDE, _INDENT = 110, 4
_LINED = ("roll", "profile")  # the tables that have the keys of a line from `slide`
_SIGNS = {
    "file": "TOML", "title": "title", "points": "[points]", "frame": "[frame]", "link": "[links.NAME]",
    "slide": "[[slide]]", "gear": "[[gear]]", "roll": "[[roll]]", "cam": "[[cam]]", "profile": "profiles",
    "driver": "[[driver]]", "pose": "[[pose]]", "sketch": "[sketch]", "scales": "[scales]",
}  # fmt: skip
"""The head of each table in the file."""
LINE: Mapping[str, str] = {
    "through": 'through = "C"', "toward": 'toward = "E"', "from": 'from = "DC"', "angle": "angle = 100",
}
"""Examples of the keys of a line."""
EXAMPLES: Mapping[str, Mapping[str, str]] = {
    "file": {
        "title": 'title = "Shaper"', "source": 'source = "Example 3-1"',
        "text": 'text = "In a shaper the crank AB drives the arm DC."', "ask": 'ask = ["omega 3", "v C"]',
        "points": "[points]", "frame": "[frame]", "links": "[links.1]", "slide": "[[slide]]", "gear": "[[gear]]",
        "roll": "[[roll]]", "cam": "[[cam]]", "driver": "[[driver]]", "pose": "[[pose]]", "sketch": "[sketch]",
        "scales": "[scales]",
    },
    "title": {"en": 'en = "Shaper"', "zh": 'zh = ".."'},
    "points": {"follows": 'follows = "half"', FURTHER: '"omega 3" = 2'},
    "frame": {"name": 'name = "4"', FURTHER: "D = [78, 0]"},
    "link": {
        "points": 'points = ["B"]', "ccw": 'ccw = ["B", "C", "E"]',
        "shape": "shape = { B = [0, 0], C = [50, 0], E = [20, -15] }", FURTHER: "AB = 24",
    },
    "slide": {
        "name": 'name = "ram"', "title": 'title = { en = "ram" }', "block": 'block = "2"', "point": 'point = "B"',
        "pin": 'pin = "P"', "guide": 'guide = "3"', **LINE, "tilt": "tilt = -90", "centre": 'centre = "O"',
        "radius": "radius = 60",
    },
    "gear": {
        "links": 'links = ["1", "2"]', "centres": 'centres = ["A", "B"]', "radii": "radii = [20, 40]",
        "internal": "internal = true",
    },
    "roll": {
        "name": 'name = "wheel"', "wheel": 'wheel = "2"', "centre": 'centre = "C"', "radius": "radius = 25",
        "on": 'on = "frame"', **LINE, "side": 'side = "right"', "on_centre": 'on_centre = "O"',
        "on_radius": "on_radius = 80", "internal": "internal = true",
    },
    "profile": {"centre": 'centre = "B"', "radius": "radius = 25", **LINE, "side": 'side = "right"'},
    "cam": {
        "links": 'links = ["1", "2"]',
        "profiles": 'profiles = [{ centre = "B", radius = 25 }, { through = "D", toward = "E" }]',
        "internal": "internal = true",
    },
    "pose": {
        "vector": 'vector = "AB"', "angle": "angle = 60", "from": 'from = "BA"', "slide": 'slide = "ram"',
        "at": "at = 90",
    },
    "driver": {
        "vector": 'vector = "AB"', "link": 'link = "2"', "slide": 'slide = "ram"', "angle": "angle = 60",
        "from": 'from = "BA"', "at": "at = 90", "omega": 'omega = "95 rpm"', "alpha": "alpha = 2",
        "velocity": "velocity = 0.5", "acceleration": "acceleration = 2", "also": "also = [120, 220]",
    },
    "scales": {"length": "length = 0.001", "velocity": "velocity = 0.01", "acceleration": "acceleration = 0.1"},
    "sketch": {FURTHER: "C = [65, 46]"},
}  # fmt: skip
"""An example of each key of the file, by table and key."""


def head(table: str, lang: Lang) -> str:
    """The sentence of a table."""
    return phrase(f"file_page.table {table}", lang)


def described(table: str, key: str, lang: Lang) -> str:
    """The sentence of a key, and the units it takes: `[mm; or a text in cm, m, in, ft]`."""
    units = (UNITS[dimension] for dimension in _dimensions(table, key))
    notes = [say("file_page.unit", lang, first=first, others=", ".join(others)) for first, *others in units]
    return " ".join([_key_sentence(table, key, lang), *notes])


def file_lines(lang: Lang) -> Iterator[str]:
    """The page."""
    for part in ("what", "names", "angles", "numbers"):
        yield from in_lines(phrase(f"file_page.intro {part}", lang), _WIDE)
        yield ""
    for dimension, units in UNITS.items():
        yield f"    {phrase(f'file_page.of {dimension}', lang)}: {', '.join(units)}"
    for table in TABLES:
        yield ""
        yield from in_lines(f"{_SIGNS[table]}  {head(table, lang)}", _WIDE)
        if table in _LINED:  # the keys of a line, which three tables share, once
            yield "  " + say("file_page.as in slide", lang, keys=", ".join(LINE))
        for key, example in EXAMPLES[table].items():
            if table not in _LINED or key not in LINE:
                yield f"  {example}"
                unit = ", ".join(next(iter(UNITS[each])) for each in _dimensions(table, key))
                sentence = _key_sentence(table, key, lang) + (f" [{unit}]" if unit else "")
                yield from in_lines(sentence, _WIDE, " " * (_INDENT + 2))
    yield from ("", phrase("file_page.asked", lang))
    for word in ("rotation", "motion", "relative", "coincident", "place", "displacement", "centre", "quotient"):
        yield from in_lines(phrase(f"file_page.ask {word}", lang), _WIDE, " " * _INDENT)
    yield ""
    yield from in_lines(phrase("file_page.whole", lang), _WIDE)


def _key_sentence(table: str, key: str, lang: Lang) -> str:
    """A line is one in every table."""
    shared = key in LINE and table in ("slide", *_LINED)
    return phrase(f"file_keys.line {key}" if shared else f"file_keys.{table} {key}", lang)


def _dimensions(table: str, key: str) -> tuple[Dimension, ...]:
    """The dimensions of the number that a key takes."""
    if key == FURTHER:
        return ("length", "angle") if table == "link" else () if table == "points" else ("length",)
    kind = keys(TABLES[table])[key].metadata["kind"]
    return () if kind.dimension is None else (kind.dimension,)
