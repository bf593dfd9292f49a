"""A result as Gradescope's autograder reads it: `results/results.json`.

Every test has its `status`. What was not marked has no score, so that Gradescope shows a failed run and no zero.
"""

from __future__ import annotations

import json
from typing import Any

from graphkin.errors import Lang
from graphkin.homework.platforms.feedback import Reveal, diagnosis, override, quantity, reason, total
from graphkin.homework.platforms.marked_up import clean
from graphkin.homework.platforms.result import FORMAT, Result, ResultLine
from graphkin.say.catalogue import say


def results_json(result: Result, lang: Lang, reveal: Reveal) -> bytes:
    """The file."""
    tests = [_test(result, line, lang, reveal) for line in result.lines]
    if told := " ".join(diagnosis(result, lang, reveal)):
        tests.append(_told(say("feedback.diagnosis", lang), told, "failed"))
    if result.status == "not marked":
        tests.append(_told(say("verdicts.status not marked", lang), reason(result, lang), "failed"))
    own = {"platform": "gradescope", "format": FORMAT, "student": result.student, "status": result.status}
    file: dict[str, Any] = {
        "output": clean(_output(result, lang)), "output_format": "text", "visibility": "visible", "tests": tests,
        "extra_data": {"graphkin": own},
    }  # fmt: skip
    if result.total is not None:
        file["score"] = float(result.total)
    return (json.dumps(file, ensure_ascii=True, allow_nan=False, indent=1) + "\n").encode()


def _output(result: Result, lang: Lang) -> str:
    if result.total is None:
        return reason(result, lang)
    return "\n".join(text for text in (override(result, lang), total(result, lang)) if text)


def _test(result: Result, line: ResultLine, lang: Lang, reveal: Reveal) -> dict[str, Any]:
    good = line.verdict not in ("wrong", "missing") and line.points >= line.most
    told = _told(line.name, quantity(result, line, lang, reveal), "passed" if good else "failed")
    return {**told, "score": float(line.points), "max_score": float(line.most)} if line.most else told


def _told(name: str, output: str, status: str) -> dict[str, Any]:
    shown = {"output": clean(output), "output_format": "text", "visibility": "visible"}
    return {"name": clean(name), "status": status, **shown}
