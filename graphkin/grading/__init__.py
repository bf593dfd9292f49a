"""Grading: keys made or read, files that students hand in marked against them, one record a submission.

    KEY --key_from--> Key --Marker--+
    files --submissions.read--> Submission --> `grade` --> Graded, one after another
    file of marks --> `grade_again` --> Graded, by another key or tolerance

`outputs` writes what comes out: JSON lines, text.
"""

from graphkin.grading.again import grade_again, is_marks
from graphkin.grading.judges import judge_from
from graphkin.grading.keys import USUAL, Pencils, key_for, key_from, marking_of
from graphkin.grading.running import grade
from graphkin.grading.sets import Judge, KeySet, OneKey, set_text
from graphkin.marking.graded import Graded

__all__ = [
    "USUAL", "Graded", "Judge", "KeySet", "OneKey", "Pencils", "grade", "grade_again", "is_marks", "judge_from",
    "key_for", "key_from", "marking_of", "set_text",
]  # fmt: skip
