"""A result as PrairieLearn's external grading reads it: `/grade/results/results.json`, under 1 MB.

A file that could not be marked is not gradable: no points are lost, and no attempt. A test that is worth nothing (the
diagnosis, a value on the way) is shown as information.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Sequence
from typing import Any

from graphkin.errors import Lang
from graphkin.homework.platforms.feedback import Reveal, diagnosis, override, quantity, reason, total
from graphkin.homework.platforms.marked_up import clean
from graphkin.homework.platforms.result import FORMAT, Result, ResultLine, ResultPicture
from graphkin.say.catalogue import say

LARGEST = 1_000_000
"""Bytes of the file at most."""
_SHORTER = (20_000, 2_000, 200, 20)


def results_json(result: Result, lang: Lang, reveal: Reveal, pictures: Sequence[ResultPicture] = ()) -> bytes:
    """The file; where it would be too large, without its last pictures, then with shorter texts."""
    for count in range(len(pictures), -1, -1):
        if len(made := _bytes(_file(result, lang, reveal, pictures[:count]))) < LARGEST:
            return made
    for most in _SHORTER:
        if len(made := _bytes(_shortened(_file(result, lang, reveal, ()), most))) < LARGEST:
            return made
    return _bytes({**_shortened(_file(result, lang, reveal, ()), _SHORTER[-1]), "tests": []})


def _file(result: Result, lang: Lang, reveal: Reveal, pictures: Sequence[ResultPicture]) -> dict[str, Any]:
    mark = {"graphkin": {"platform": "prairielearn", "format": FORMAT, "status": result.status}}
    if result.score is None:
        return {"gradable": False, "format_errors": [clean(reason(result, lang))], **mark}
    told = [text for text in (override(result, lang), total(result, lang)) if text]
    return {
        "gradable": True, "score": float(result.score), "message": clean(told[-1]), "output": clean("\n".join(told)),
        "images": [_image(picture) for picture in pictures if picture.data],
        "tests": [*_tests(result, lang, reveal)], **mark,
    }  # fmt: skip


def _tests(result: Result, lang: Lang, reveal: Reveal) -> Iterator[dict[str, Any]]:
    for line in result.lines:
        yield _test(result, line, lang, reveal)
    if told := " ".join(diagnosis(result, lang, reveal)):
        yield _shown(say("feedback.diagnosis", lang), 0.0, 0.0, told)


def _test(result: Result, line: ResultLine, lang: Lang, reveal: Reveal) -> dict[str, Any]:
    return _shown(line.name, float(line.points), float(line.most), quantity(result, line, lang, reveal))


def _shown(name: str, earned: float, most: float, message: str) -> dict[str, Any]:
    return {"name": clean(name), "points": earned, "max_points": most, "message": clean(message), "images": []}


def _image(picture: ResultPicture) -> dict[str, str]:
    data = base64.b64encode(picture.data).decode()
    return {"label": clean(picture.label), "url": f"data:{picture.kind};base64,{data}"}


def _bytes(file: dict[str, Any]) -> bytes:
    return (json.dumps(file, ensure_ascii=True, allow_nan=False) + "\n").encode()


def _shortened(value: Any, most: int) -> Any:
    """The same with every text cut."""
    if isinstance(value, str):
        return value if len(value) <= most else value[: most - 2] + ".."
    if isinstance(value, dict):
        return {key: _shortened(each, most) for key, each in value.items()}
    return [_shortened(each, most) for each in value] if isinstance(value, list) else value
