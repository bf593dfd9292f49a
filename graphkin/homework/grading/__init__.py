"""Grading: keys made or read, files that students hand in marked against them, one record a submission.

    KEY --key_from--> Key --Marker--+
    files --submissions.handed_in--> Handed --`grade`, batch by batch, here or by workers--> Graded, one after another
    file of marks --> Read: numbers that were read then --`grade`--> Graded, by another key or tolerance
    a folder of keys, a folder of files --problems_of--> Problems, each marked by itself
    pictures of paper, sheets.json --photographs--> a drawing for each student, beside the other files
    files, Journal --`resumed`--> records, of which none that is there and holds is made twice

`outputs` writes what comes out: JSON lines, text.
"""

from graphkin.homework.grading.keys import Pencils, key_for, key_from, marking_of, pencils_of, power, tolerance
from graphkin.homework.grading.photographs import Photographs
from graphkin.homework.grading.running import Journal, MarkingOptions, grade, limits_of, resumed, with_photographs
from graphkin.homework.grading.sets import OneKey, Problem, SetMarker, class_list, judge_from, problems_of, set_text

__all__ = [
    "Journal", "MarkingOptions", "OneKey", "Pencils", "Photographs", "Problem", "SetMarker", "class_list", "grade",
    "judge_from", "key_for", "key_from", "limits_of", "marking_of", "pencils_of", "power", "problems_of", "resumed",
    "set_text", "tolerance", "with_photographs",
]  # fmt: skip
