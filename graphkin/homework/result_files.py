"""The files of a marking: records, and folders of results made of them, for teachers, students, platforms."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path

from graphkin.base.value import frozen
from graphkin.errors import Lang
from graphkin.homework import grading, kinds_of, platforms
from graphkin.homework.grading import MarkingOptions, Problem, SetMarker
from graphkin.homework.platforms import Reveal
from graphkin.homework.platforms.result_formats import RESULTS
from graphkin.outputs import marks_json
from graphkin.say.catalogue import say
from graphkin.say.marks import kept_lines

MARKS = "marks.json"  # in a folder of results graphkin's own records, from which everything else there is made


@frozen
class ResultFiles:
    """A .json file of records, or with `kinds` a folder; `watch` sees the name of a problem and the lines of its
    records as they come."""

    output: Path
    kinds: Sequence[str]
    reveal: Reveal
    assignment: str
    lang: Lang
    force: bool
    watch: Callable[[str, Iterator[str]], Iterable[str]] = lambda _, lines: lines

    def written(
        self, problems: Sequence[Problem], judges: Sequence[SetMarker], options: Sequence[MarkingOptions]
    ) -> Iterator[Path | str]:
        """Each file, once it is written, and remarks."""
        files = [self.output / problem.name / MARKS if self.kinds else self.output for problem in problems]
        for path, judge, problem, own in zip(files, judges, problems, options, strict=True):
            yield from self._records(path, judge, problem, own)
        if self.kinds:
            yield from self._folders(files, judges, problems)

    def _records(
        self, path: Path, judge: SetMarker, problem: Problem, options: MarkingOptions
    ) -> Iterator[Path | str]:
        """All records in one file. What a marking that was broken off has left is gone on with, and left again."""
        if self.kinds:
            platforms.prepared(path.parent)
        try:
            with grading.Journal(path, self.force) as journal:
                record = partial(marks_json.record, lang=self.lang)
                lines = grading.resumed(judge, problem.paths, journal, options, record)
                marks_json.write(path, self.watch(problem.name, lines), self.force)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(say("marks.interrupted", self.lang, path=path)) from None
        yield path
        yield from kept_lines(journal.kept, journal.replaced, self.lang)

    def _folders(
        self, files: Sequence[Path], judges: Sequence[SetMarker], problems: Sequence[Problem]
    ) -> Iterator[Path | str]:
        """Everything else, made of the records; with what teachers wrote beside marks that are marked anew."""
        merged = [[path.parent for path in map(Path, problem.paths) if path.name == MARKS and path != file]
                  for file, problem in zip(files, problems, strict=True)]  # fmt: skip
        if not {*self.kinds} - {"json"} and not any(merged):
            return
        book, called = {file.parent.name: platforms.read_results(file) for file in files}, dict[str, str]()
        several = [{one.student: one.trace for one in results if one.status == "marked"}
                   for results in book.values()] if len(files) > 1 else []  # fmt: skip
        for file, judge, beside in zip(files, judges, merged, strict=True):
            results, pictures = book[file.parent.name], platforms.PolygonPictures(judge)
            names = {} if judge.roster is None else judge.roster.called
            called |= {student: name for student, name in names.items() if name or student not in called}
            for kind in dict.fromkeys((*self.kinds, *(["csv"] if beside else []))):
                if kind == "json":
                    continue
                done = platforms.write_results(
                    file.parent, results, kind, self.lang, self.reveal, assignment=self.assignment,
                    pictures=pictures, force=self.force, several=several, merged=beside, names=names,
                )  # fmt: skip
                yield from done.paths
                yield from done.left_out
        for kind in dict.fromkeys(kind for kind in self.kinds if kind in ("csv", "xlsx") and several):
            yield platforms.write_gradebook(self.output, book, kind, self.lang, called, self.force)


def grade_into(
    output: str | Path, key: str | Path, paths: str | Path | Sequence[str | Path], formats: str | Sequence[str] = "csv",
    *, reveal: Reveal = "mistake", assignment: str = "graphkin", turned: bool = False, letters: str = "",
    pencil: str | None = None, sigmas: float | None = None, relative: float | None = None,
    roster: str | Path | None = None, workers: int = 0, lang: Lang = "en", force: bool = False,
    sheets: str | Path | None = None,
) -> list[Path]:  # fmt: skip
    """Mark what is handed in and write a folder of results, as `graphkin grade -o` does; all files that are written.

    formats  "csv", "xlsx", "moodle", "gradescope", "prairielearn", "canvas", "pages", "report"; "json": records alone
    reveal   how much students are told: "hint", "mistake", "answer"; the rest is as `grade` has it
    """
    kinds = kinds_of(formats, ("json", *RESULTS))
    pencils, listed = grading.pencils_of(pencil, sigmas, relative), None if roster is None else Path(roster)
    problems = grading.problems_of(str(key), [*map(str, [paths] if isinstance(paths, str | Path) else paths)])
    judges = [grading.judge_from(problem.key, pencils, listed) for problem in problems]
    usual, named = MarkingOptions(grading.limits_of(turned, letters), workers, words=lang), sheets and Path(sheets)
    options = [grading.with_photographs(usual, problem.key, judge, problem.paths, named or None)
               for problem, judge in zip(problems, judges, strict=True)]  # fmt: skip
    files = ResultFiles(Path(output), kinds, reveal, assignment, lang, force)
    return [path for path in files.written(problems, judges, options) if isinstance(path, Path)]
