"""The page of the mechanism file: every key, what it says, its unit, an example. `graphkin help file`.

The same sentences are the descriptions of the JSON Schema. They stand in the catalogue: `file_keys` by table and key,
`file_page` for what is said of a table and of the whole.
"""

from __future__ import annotations

from collections.abc import Iterator

from graphkin.errors import Lang
from graphkin.files.examples import EXAMPLES, LINE
from graphkin.files.fields import keys
from graphkin.files.schema import FURTHER, TABLES
from graphkin.files.values import UNITS
from graphkin.model.mechanism import Dimension
from graphkin.say.catalogue import phrase, say
from graphkin.say.text_table import width

_WIDE, _INDENT = 110, 4
_LINED = ("roll", "profile")  # the tables that have the keys of a line from `slide`
_SIGNS = {
    "file": "TOML", "title": "title", "points": "[points]", "frame": "[frame]", "link": "[links.NAME]",
    "slide": "[[slide]]", "gear": "[[gear]]", "roll": "[[roll]]", "cam": "[[cam]]", "profile": "profiles",
    "driver": "[[driver]]", "pose": "[[pose]]", "sketch": "[sketch]", "scales": "[scales]",
}  # fmt: skip
"""The head of each table in the file."""
_FOLLOWING = " ，。；：、）”"  # these begin no line


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
        yield from _wrapped(phrase(f"file_page.intro {part}", lang), "")
        yield ""
    for dimension, units in UNITS.items():
        yield f"    {phrase(f'file_page.of {dimension}', lang)}: {', '.join(units)}"
    for table in TABLES:
        yield ""
        yield from _wrapped(f"{_SIGNS[table]}  {head(table, lang)}", "")
        if table in _LINED:  # the keys of a line, which three tables share, once
            yield "  " + say("file_page.as in slide", lang, keys=", ".join(LINE))
        for key, example in EXAMPLES[table].items():
            if table not in _LINED or key not in LINE:
                yield f"  {example}"
                unit = ", ".join(next(iter(UNITS[each])) for each in _dimensions(table, key))
                sentence = _key_sentence(table, key, lang) + (f" [{unit}]" if unit else "")
                yield from _wrapped(sentence, " " * (_INDENT + 2))
    yield from ("", phrase("file_page.asked", lang))
    for word in ("rotation", "motion", "relative", "coincident", "place", "displacement", "centre", "quotient"):
        yield from _wrapped(phrase(f"file_page.ask {word}", lang), " " * _INDENT)
    yield ""
    yield from _wrapped(phrase("file_page.whole", lang), "")


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


def _wrapped(text: str, indent: str) -> Iterator[str]:
    """Lines that fit a terminal; Chinese may be broken anywhere."""
    line, word = indent, ""
    for letter in (*text, ""):
        # a word keeps the blank behind it; each Chinese character is one, together with a sign that follows it
        chinese = word and letter and 2 in (width(word[-1]), width(letter)) and letter not in _FOLLOWING
        if word and (not letter or word[-1] == " " or chinese):
            if width(line + word.rstrip()) > _WIDE and line.strip():
                yield line.rstrip()
                line = indent
            line, word = line + word, ""
        word += letter
    yield line.rstrip()
