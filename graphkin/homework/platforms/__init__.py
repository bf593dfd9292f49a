"""Formats of teaching platforms, one file a format: problem sets out, results out.

    Template + Variants --write_problems--> graphkin's own folder: DIR/NAME.toml, .txt, .svg, .key.json; key.json,
                                            set.json, set.mistakes.txt
    Key --question_of--> Question; Template + Variants --problem_set--> ProblemSet
    ProblemSet of Questions --SETS[format]--> moodle, moodle-numerical, qti, csv, xuexitong: one file
    file of marks --read_results--> Results, --read_traces--> the evidence of each student's mistakes
    Results --RESULTS[format]--> csv, xlsx, moodle, gradescope, prairielearn, canvas, pages: files in a folder
    Result --PolygonPictures--> Pictures, for its page and for platforms that show some
    Results --class_report--> ClassReport --write_class_figure--> SVG, PNG, PDF

A set has one value, `alternatives`: numbers, tolerances and shares of the points, rounded once; every format writes
these. Results have one value, `Result`: points rounded once; every format's totals are its totals. Texts, names and ids
are hostile; files are written beside, then renamed; the same input gives the same bytes.

To add a format: a file with one function, and its line in `set_formats` or `result_formats`.
"""

from graphkin.homework.platforms.class_report import (
    ClassReport,
    class_report,
    report_record,
    report_text,
    write_class_figure,
)
from graphkin.homework.platforms.class_table import Overrides, overridden, read_overrides
from graphkin.homework.platforms.feedback import Feedback, Reveal
from graphkin.homework.platforms.polygon_pictures import PolygonPictures
from graphkin.homework.platforms.problem_folder import (
    file_of,
    is_set,
    problem_set,
    students_of,
    told_of,
    write_problems,
)
from graphkin.homework.platforms.question import (
    Alternative,
    Part,
    ProblemSet,
    Question,
    Wrong,
    alternatives,
    question_of,
)
from graphkin.homework.platforms.result import (
    Result,
    ResultLine,
    ResultPicture,
    Suspicion,
    from_record,
    read_results,
    read_traces,
)
from graphkin.homework.platforms.result_formats import RESULTS, WrittenResults, prepared, write_results
from graphkin.homework.platforms.set_formats import SETS, write_set

__all__ = [
    "RESULTS", "SETS", "Alternative", "ClassReport", "Feedback", "Overrides", "Part", "PolygonPictures",
    "ProblemSet", "Question", "Result", "ResultLine", "ResultPicture", "Reveal", "Suspicion", "WrittenResults",
    "Wrong", "alternatives", "class_report", "file_of", "from_record", "is_set", "overridden", "prepared",
    "problem_set", "question_of", "read_overrides", "read_results", "read_traces", "report_record", "report_text",
    "students_of", "told_of", "write_class_figure", "write_problems", "write_results", "write_set",
]  # fmt: skip
