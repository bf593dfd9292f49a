"""A problem set for a platform, made of the variants of a template: each student's own key and statement."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from graphkin.homework.grading import SetMarker
from graphkin.homework.platforms.from_key import question_of
from graphkin.homework.platforms.question import ProblemSet, Question
from graphkin.homework.platforms.set_formats import SETS
from graphkin.homework.problems import Template, Variant
from graphkin.say.catalogue import LANGUAGES
from graphkin.say.problems import statement


def problem_set(template: Template, found: Iterable[Variant], judge: SetMarker) -> ProblemSet:
    """What a platform asks of each student, by the keys of the set. Raises what reading a key raises."""
    return ProblemSet(template.name, [_question(variant, judge) for variant in found])


def _question(variant: Variant, judge: SetMarker) -> Question:
    marker = judge.marker(variant.student.id)
    assert marker is not None, "the set has a key for each of its students"
    text = {lang: "\n".join(statement(variant.mechanism, lang, variant.drawn)) for lang in LANGUAGES}
    return question_of(variant.student.id, marker.key, text)


def file_of(folder: Path, kind: str) -> Path:
    """Where a set of problems goes: `set-moodle.xml`, `set-qti.zip`."""
    return folder / f"set-{kind}{SETS[kind].suffix}"
