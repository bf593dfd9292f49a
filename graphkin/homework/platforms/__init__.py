"""Formats of teaching platforms, one file a format: problem sets out, results out.

    Key --question_of--> Question; Questions of a class: a ProblemSet
    ProblemSet of Questions --SETS[format]--> moodle, moodle-numerical, qti, csv, xuexitong: one file
    file of marks --read_results--> Results, with the evidence of each student's mistakes
    Results --RESULTS[format]--> csv, xlsx, moodle, gradescope, prairielearn, canvas, pages: files in a folder
    Result --PolygonPictures--> Pictures, for its page and for platforms that show some
    Results --class_report--> ClassReport --write_class_figure--> SVG, PNG, PDF

A set has one value, `alternatives`: numbers, tolerances and shares of the points, rounded once; every format writes
these. Results have one value, `Result`: points rounded once; every format's totals are its totals. Texts, names and ids
are hostile; files are written beside, then renamed; the same input gives the same bytes.

To add a format: a file with one function, and its line in `set_formats` or `result_formats`.
"""

from graphkin.homework.platforms.feedback import Reveal
from graphkin.homework.platforms.polygon_pictures import PolygonPictures
from graphkin.homework.platforms.question import ProblemSet
from graphkin.homework.platforms.result import Result, from_record, read_results
from graphkin.homework.platforms.result_formats import prepared, write_gradebook, write_results
from graphkin.homework.platforms.set_formats import write_set

__all__ = [
    "PolygonPictures", "ProblemSet", "Result", "Reveal", "from_record", "prepared", "read_results", "write_gradebook",
    "write_results", "write_set",
]  # fmt: skip
