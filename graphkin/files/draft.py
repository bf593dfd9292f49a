"""A mechanism being drawn up from its file: the links so far, and all that was found wrong."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from typing import TYPE_CHECKING, NoReturn

from graphkin.base.value import filled
from graphkin.errors import DuplicateName, GraphkinError, Several, UnknownLink, UnknownPoint, Where
from graphkin.files.names import tidy
from graphkin.files.positions import Path
from graphkin.model.mechanism import FRAME, Link

if TYPE_CHECKING:
    from graphkin.files.schema import SlideTable

MOST_PROBLEMS = 100
"""Nobody reads more of them at a time."""


@filled
class Draft:
    """What the readers of the single tables share.

    links     by name; a link whose measures are wrong has its points at stand-in places, so that the other
              tables can still be checked
    starts    points that nobody named, where lines begin that are given by coordinates, and where those stand
    problems  what was found wrong; `stop_if_wrong` raises it
    unnamed   what pairs are called that have a displacement, also those that the file gives no name
    slides    the tables of slides, which say how a link of one point is turned; `tracing`: the links that are asked
    _moving   the moving links of each point, listed when so many links were `_counted`: their points have names
              before they have places
    """

    file: str
    lines: Mapping[Path, int]
    frame: str = "0"
    links: dict[str, Link] = field(default_factory=dict)
    frame_points: dict[str, complex] = field(default_factory=dict)
    starts: dict[str, Path] = field(default_factory=dict)
    problems: list[GraphkinError] = field(default_factory=list)
    _taken: set[str] = field(default_factory=set)
    unnamed: set[str] = field(default_factory=set)
    given: set[str] = field(default_factory=set)
    slides: Sequence[SlideTable] = ()
    tracing: list[str] = field(default_factory=list)
    _numbers: dict[str, int] = field(default_factory=dict)
    _moving: dict[str, list[str]] = field(default_factory=dict)
    _counted: int = 0

    def where(self, *path: str | int) -> Where:
        """The place of a key, or of the nearest key above it that the file has."""
        path = tuple(tidy(part) if isinstance(part, str) else part for part in path)
        line = next((self.lines[path[:n]] for n in range(len(path), 0, -1) if path[:n] in self.lines), None)
        return Where(self.file, line, ".".join(map(str, path)))

    @contextmanager
    def noting(self) -> Iterator[None]:
        """What is wrong inside is noted, and reading goes on behind it."""
        try:
            yield
        except GraphkinError as problem:
            self.problems.append(problem)

    def stop_if_wrong(self) -> None:
        """Raise all problems in the order of the lines: one as it is, more as `Several`."""
        if self.problems:
            self._stop()

    def _stop(self) -> NoReturn:
        def line(problem: GraphkinError) -> float:
            where = getattr(problem, "where", None)
            return where.line if isinstance(where, Where) and where.line is not None else float("inf")

        first = sorted(self.problems, key=line)[:MOST_PROBLEMS]
        problems = list({problem.message(): problem for problem in first}.values())
        raise problems[0] if len(problems) == 1 else Several(tuple(problems))

    def link(self, given: str, *path: str | int) -> str:
        """The link of this name; the frame may go by its own."""
        if given == self.frame:
            return FRAME
        if given not in self.links:
            moving = tuple(name for name in self.links if name != FRAME)
            raise UnknownLink(self.where(*path), given, (*moving, FRAME))
        return given

    def point(self, link: str, given: str, *path: str | int) -> str:
        """A point of the link."""
        self.known(given, *path)
        if given not in self.links[link].points:
            raise UnknownPoint(self.where(*path), given, self.named(link))
        return given

    def known(self, given: str, *path: str | int) -> str:
        """A point of any link."""
        if not any(given in link.points for link in self.links.values()):
            points = dict.fromkeys(point for link in self.links for point in self.named(link))
            raise UnknownPoint(self.where(*path), given, tuple(points))
        return given

    def named(self, link: str) -> tuple[str, ...]:
        """The points of a link that people named."""
        return tuple(point for point in self.links[link].points if point not in self.starts)

    def owners(self, *points: str) -> Sequence[str]:
        """The links that have all these points, moving ones first."""
        if self._counted != len(self.links):
            self._list_owners()
        owners = self._moving.get(points[0], ())
        found = [name for name in owners if all(point in self.links[name].points for point in points[1:])]
        fixed = FRAME in self.links and all(point in self.links[FRAME].points for point in points)
        return [*found, FRAME] if fixed else found

    def _list_owners(self) -> None:
        self._counted, self._moving = len(self.links), {}
        for name, link in self.links.items():
            for point in link.points if name != FRAME else ():
                self._moving.setdefault(point, []).append(name)

    def name(self, given: str | None, default: str, *path: str | int) -> str:
        """The name of a pair: as given and not used before, or the default."""
        if given is None:
            while default in self.given:
                default += "_"
            return default
        if given in self._taken:
            raise DuplicateName(self.where(*path, "name"), given)
        self._taken.add(given)
        return given

    def numbered(self, letter: str) -> str:
        """A name for a pair that has none, by the next number: c0, c1, .."""
        self._numbers[letter] = self._numbers.get(letter, -1) + 1
        return f"{letter}{self._numbers[letter]}"

    def can_be_driven(self, given: str) -> bool:
        """Whether a sliding or rolling pair has this name."""
        return given in self._taken or given in self.unnamed

    @property
    def pair_names(self) -> tuple[str, ...]:
        return tuple(sorted(self._taken))
