"""From a mechanism file to a `Mechanism`: read, check the tables, draw up the links, then the pairs between them."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import IO, TYPE_CHECKING, Any

from graphkin.errors import Lang
from graphkin.loading.curves import Measure
from graphkin.loading.draft import Draft
from graphkin.loading.measures import frame_problems, read_measures
from graphkin.loading.source import decoded, named, read_bytes, read_text, read_toml
from graphkin.mechanism import Mechanism

if TYPE_CHECKING:
    from graphkin.loading.schema import File


def load(source: str | FilePath) -> Mechanism:
    """The mechanism a file describes.

    Raises a `GraphkinError`: the one thing that is wrong, or `Several` with all of them in the order of the lines.
    """
    path = FilePath(source)
    return loads(read_text(path), name=named(path), file=str(path))


def loads(text: str, *, name: str = "mechanism", file: str = "<text>") -> Mechanism:
    """The mechanism a text describes; `name` and `file` are what messages and drawings call it."""
    document, lines = read_toml(text, file)
    draft = Draft(file, lines)
    tables, measures = _checked(draft, document)
    return _drawn_up(draft, tables, document, measures, name, text)


def load_stream(stream: IO[bytes], *, name: str, file: str) -> Mechanism:
    """The mechanism that comes in through a pipe."""
    return loads(decoded(read_bytes(stream, file), file), name=name, file=file)


def _checked(draft: Draft, document: dict[str, Any]) -> tuple[File, dict[str, list[Measure]]]:
    """All tables by themselves."""
    from pydantic_core import ValidationError

    from graphkin.loading.schema import read_tables

    draft.problems.extend(frame_problems(document.get("frame"), draft.where))
    measures, problems = read_measures(document.get("links"), draft.where)
    draft.problems.extend(problems)
    try:
        tables = read_tables(document)
    except ValidationError as error:
        from graphkin.loading.complaints import complaints

        draft.problems.extend(complaints(error, draft.where, draft.lines))
    draft.stop_if_wrong()
    return tables, measures


def _drawn_up(
    draft: Draft, file: File, raw: dict[str, Any], measures: dict[str, list[Measure]], name: str, text: str
) -> Mechanism:
    """The tables against each other."""
    from graphkin.loading.drivers import read_drivers, read_poses
    from graphkin.loading.joints import check_joints, check_sizes, check_sketch
    from graphkin.loading.links import read_links
    from graphkin.loading.pairs import read_pairs
    from graphkin.loading.questions import check_questions
    from graphkin.loading.sides import as_sketched

    read_links(draft, file, raw, measures)
    pairs = read_pairs(draft, file)
    drivers = read_drivers(draft, file.driver, len(file.pose))
    poses = read_poses(draft, file.pose)
    check_joints(draft, pairs, len(file.driver))
    check_sizes(draft)
    check_sketch(draft, list(file.sketch))
    draft.stop_if_wrong()
    scales = {key: scale for key, scale in vars(file.scales).items() if scale is not None}
    sketch = {point: complex(*place) for point, place in file.sketch.items()}
    pairs = as_sketched(file, draft.links, pairs, (*drivers, *poses), sketch)
    mechanism = Mechanism(
        name, draft.frame, draft.links, pairs, drivers, poses, sketch, scales,
        _titles(file), file.source, tuple(file.ask), text, draft.file, draft.lines,
    )  # fmt: skip
    check_questions(draft, mechanism)
    draft.stop_if_wrong()
    return mechanism


def _titles(file: File) -> dict[Lang, str]:
    titles: dict[Lang, str | None] = {"en": file.title.en, "zh": file.title.zh}
    return {lang: title for lang, title in titles.items() if title}
