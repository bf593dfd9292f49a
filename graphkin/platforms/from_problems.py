"""A problem set for a platform, made of the variants of a template: each student's own key and statement."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import get_args

from graphkin.errors import Lang
from graphkin.grading import USUAL, Pencils, key_for
from graphkin.platforms.from_key import question_of
from graphkin.platforms.question import ProblemSet, Question
from graphkin.platforms.writing import SETS
from graphkin.problems import Template, Variant, statement

__all__ = ["file_of", "problem_set"]


def problem_set(template: Template, found: Iterable[Variant], pencils: Pencils = USUAL) -> ProblemSet:
    """What a platform asks of each student. Raises what making a key raises."""
    return ProblemSet(template.name, [_question(template, variant, pencils) for variant in found])


def _question(template: Template, variant: Variant, pencils: Pencils) -> Question:
    key = key_for(variant.mechanism, pencils, points=template.points)
    text = {lang: "\n".join(statement(variant.mechanism, lang)) for lang in get_args(Lang)}
    return question_of(variant.student.id, key, text)


def file_of(folder: Path, kind: str) -> Path:
    """Where a set of problems goes: `set-moodle.xml`, `set-qti.zip`."""
    return folder / f"set-{kind}{SETS[kind].suffix}"
