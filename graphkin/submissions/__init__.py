"""Whatever students hand in, read: numbers in tables and texts, vectors measured on drawings, whole classes.

    files, archives, class tables --handed_in--> Handed (owner, names and bytes, or a row), one after another
    class list --students_in--> Roster; Handed + lines inside --Roster.whose--> the student
    Handed + ReadableProblem --read_one--> Submission      pure, within its time; goes to any executor
    batches --guarded--> results of worker processes, in order; one that hangs or dies takes nobody with it

    documents --Entry--> answers --questions, numbers (by a grammar)--> HandedValue
    drawings: svg, geogebra, dxf --PagePicture--> letters --> drawings --> HandedValue

Nothing here judges. A file that cannot be read is a Submission with its reason, and stops nothing. A new format of
answers is a reader that gives a `StudentDocument`, of drawings one that gives a `PagePicture`.
"""

from graphkin.submissions.handed import Handed, handed_in
from graphkin.submissions.pool import guarded, limited, worker_pool
from graphkin.submissions.reading import FirstOnes, called, pictures_of, read_one
from graphkin.submissions.students import Roster, Student, students_in
from graphkin.submissions.submission import Limits, MeasuredDrawing, ReadableProblem, Submission, safe_name

__all__ = [
    "FirstOnes", "Handed", "Limits", "MeasuredDrawing", "ReadableProblem", "Roster", "Student", "Submission", "called",
    "guarded", "handed_in", "limited", "pictures_of", "read_one", "safe_name", "students_in", "worker_pool",
]  # fmt: skip
