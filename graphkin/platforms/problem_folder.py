"""A problem set in graphkin's own folder: each student's mechanism file, problem and key, all or nothing a file."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from graphkin.errors import CannotWrite, Lang
from graphkin.grading import key_for, set_text
from graphkin.outputs.files import beside, refuse
from graphkin.outputs.key_json import key_text
from graphkin.problems import Template, Variant
from graphkin.say.problems import problem
from graphkin.submissions import safe_name

MARK = "graphkin problems"
"""By which graphkin knows files of its own, which it writes anew."""
KEY = ".key.json"
_MARKS = [MARK.encode(), b'"kind": "graphkin key']


def write_problems(
    folder: Path, template: Template, found: tuple[Variant, ...], seed: str, lang: Lang, force: bool = False,
    keys: bool = True,
) -> Iterator[Path]:  # fmt: skip
    """Writes NAME.toml, NAME.txt and NAME.key.json for each student, then key.json, by which the whole set is marked,
    and set.json; gives each path when it is whole.

    Raises FileInTheWay before anything is written, CannotWrite.
    """
    names = file_names(variant.student.id for variant in found)
    suffixes = (".toml", ".txt", *((KEY,) if keys else ()))
    paths = [folder / f"{name}{suffix}" for name in names.values() for suffix in suffixes]
    paths += [folder / "key.json"] if keys else []
    marks = _MARKS
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CannotWrite(str(folder), error.strerror or str(error)) from None
    for path in (*paths, folder / "set.json"):
        refuse(path, force, marks)
    for variant in found:
        name = names[variant.student.id]
        head = f"# {MARK}: {template.name}, {variant.student.id}\n"
        texts = ((".toml", head + template.text(variant.numbers)), (".txt", _text(template, variant, lang)))
        for suffix, text in texts:
            yield _written(folder / f"{name}{suffix}", text, force)
        if keys:
            yield _written(folder / f"{name}{KEY}", _key(template, variant), force)
    if keys:
        index = {student: f"{name}{KEY}" for student, name in names.items()}
        yield _written(folder / "key.json", set_text(index), force)
    yield _written(folder / "set.json", _listed(template, found, names, seed), force)


def _text(template: Template, variant: Variant, lang: Lang) -> str:
    """What the student reads."""
    own = variant.student
    return problem(variant.mechanism, own.id, [name for _, name in own.names], template.points, lang)


def _key(template: Template, variant: Variant) -> str:
    """What the student's problem is marked by."""
    return key_text(key_for(variant.mechanism, points=template.points or None))


def file_names(students: Iterable[str]) -> dict[str, str]:
    """A file's name for each id; no two alike on a disk that knows no capitals."""
    return {student: safe_name(student) for student in students}


def _written(path: Path, text: str, force: bool) -> Path:
    with beside(path, force, _MARKS) as draft, draft.open("w", encoding="utf-8", newline="\n") as stream:
        stream.write(text)
        stream.flush()
        with contextlib.suppress(OSError):
            os.fsync(stream.fileno())
    return path


def _listed(template: Template, found: tuple[Variant, ...], names: dict[str, str], seed: str) -> str:
    """What the set is: who has which numbers."""
    students = {
        variant.student.id: {
            "file": f"{names[variant.student.id]}.toml",
            "names": dict(variant.student.names),
            "values": {
                each.name: each.value(number).strip('"')
                for each, number in zip(template.ranges, variant.numbers, strict=True)
            },
            "shared": variant.shared,
        }
        for variant in found
    }
    whole = {"format": 1, "program": MARK, "template": template.name, "seed": seed, "points": dict(template.points)}
    return json.dumps({**whole, "students": students}, ensure_ascii=False, indent=1, allow_nan=False) + "\n"
