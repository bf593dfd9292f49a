"""What students hand in, read: numbers in tables and texts, vectors measured on drawings, whole classes.

    files, archives, class tables --handed_in--> Handed (student, name, bytes or row), one after another
    Handed + Asked --read_one--> Submission      pure; goes to any executor
    read = both, with a time limit for each

Nothing here judges. A file that cannot be read is a Submission with its reason, and stops nothing.
"""

from graphkin.submissions.submission import Asked, Drawn, Given, Limits, Sense, Submission

__all__ = ["Asked", "Drawn", "Given", "Limits", "Sense", "Submission"]
