"""A mechanism being drawn up from its file: the links so far, and all that is wrong; the checks of the whole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field
from itertools import combinations, islice
from typing import TYPE_CHECKING

from graphkin import errors
from graphkin.base.value import filled
from graphkin.errors import NOWHERE, GraphkinError, Where
from graphkin.files.shapes import orientation
from graphkin.files.toml import tidied
from graphkin.model.mechanism import EQUATIONS, FRAME, Driver, KeyPath, Link, Mechanism
from graphkin.model.naming import rod_sign
from graphkin.model.pairs import Pair
from graphkin.model.quantities import formed, meant, read

if TYPE_CHECKING:
    from graphkin.files.schema import SlideTable

UNEVEN = 1e9  # no length is so many times another one
_SURELY = 0.2  # the sine of an angle by which a sketch surely shows which way points run round
RATES = ("omega", "alpha", "velocity", "acceleration")  # keys that say how fast a driver moves
MOST_PROBLEMS = 100  # nobody reads more of them at a time


@filled
class Draft:
    """The data that the readers of the single tables share.

    links         by name; a link whose measures are wrong has its points at stand-in places, so that the other
                  tables can still be checked
    starts        points that nobody named, where lines begin that are given by coordinates, and where those stand
    problems      all that is wrong; `stop_if_wrong` raises it
    given_names   the names that the file gives to pairs; `unnamed`: those of pairs with a displacement, given or not;
                  `used_names`: those given so far; `slots`: how many pairs have a name by their number
    slides        the tables of slides, which say how a link of one point is turned; `tracing`: links now looked up
    """

    file: str
    lines: Mapping[KeyPath, int]
    frame: str = "0"
    links: dict[str, Link] = field(default_factory=dict)
    frame_points: dict[str, complex] = field(default_factory=dict)
    starts: dict[str, KeyPath] = field(default_factory=dict)
    problems: list[GraphkinError] = field(default_factory=list)
    given_names: set[str] = field(default_factory=set)
    unnamed: set[str] = field(default_factory=set)
    slides: Sequence[SlideTable] = ()
    tracing: list[str] = field(default_factory=list)
    used_names: set[str] = field(default_factory=set)
    slots: int = 0

    def where(self, *path: str | int) -> Where:
        """The place of a key, or of the nearest key above it that the file has."""
        path = tidied(path)
        line = next((self.lines[path[:n]] for n in range(len(path), 0, -1) if path[:n] in self.lines), None)
        return Where(self.file, line, ".".join(map(str, path)))

    @contextmanager
    def noting(self) -> Iterator[None]:
        """A block in which an error is noted, and reading goes on behind it."""
        try:
            yield
        except GraphkinError as problem:
            self.problems.append(problem)

    def stop_if_wrong(self) -> None:
        """Raise all problems in the order of the lines: one as it is, more as `Several`."""
        if not self.problems:
            return

        def line(problem: GraphkinError) -> float:
            where = getattr(problem, "where", None)
            return where.line if isinstance(where, Where) and where.line is not None else float("inf")

        first = sorted(self.problems, key=line)[:MOST_PROBLEMS]
        problems = list({problem.message(): problem for problem in first}.values())
        raise problems[0] if len(problems) == 1 else errors.Several(tuple(problems))

    def link(self, name: str, *path: str | int) -> str:
        """The link of this name; the frame may go by its own."""
        if name == self.frame:
            return FRAME
        if name not in self.links:
            moving = tuple(link for link in self.links if link != FRAME)
            raise errors.UnknownLink(self.where(*path), name, (*moving, FRAME))
        return name

    def point(self, link: str, point: str, *path: str | int) -> str:
        """A point of the link."""
        self.known(point, *path)
        if point not in self.links[link].points:
            raise errors.UnknownPoint(self.where(*path), point, self.named(link))
        return point

    def known(self, point: str, *path: str | int) -> str:
        """A point of any link."""
        if not any(point in link.points for link in self.links.values()):
            points = dict.fromkeys(each for link in self.links for each in self.named(link))
            raise errors.UnknownPoint(self.where(*path), point, tuple(points))
        return point

    def named(self, link: str) -> tuple[str, ...]:
        """The points of a link that people named."""
        return tuple(point for point in self.links[link].points if point not in self.starts)

    def owners(self, *points: str) -> Sequence[str]:
        """The links that have all these points, moving ones first."""
        owners = [name for name, link in self.links.items() if all(point in link.points for point in points)]
        return sorted(owners, key=lambda name: name == FRAME)

    def name(self, given: str | None, default: str, *path: str | int) -> str:
        """The name of a pair: as given and not used before, or the default."""
        if given is None:
            while default in self.given_names:
                default += "_"
            return default
        if given in self.used_names:
            raise errors.DuplicateName(self.where(*path, "name"), given)
        self.used_names.add(given)
        return given

    def next_slot(self) -> str:
        """A name for a slot or a cam, which have none: c0, c1, .."""
        self.slots += 1
        return self.numbered("c", self.slots - 1)

    def numbered(self, kind: str, number: int | str) -> str:
        """A name for a pair that has none, which tells the letter of its rod."""
        points = (point for link in self.links for point in self.named(link))
        return f"{kind}{number}{rod_sign(kind, [*points, *(link for link in self.links if len(link) == 1)])}"


def check_joints(draft: Draft, pairs: Sequence[Pair], drivers: int) -> None:
    """Note every link that is loose, fixed or joined twice to another."""
    tied = {link for pair in pairs for link in pair.joins}
    tied |= {link for pair in pairs if pair.path is not None for link in draft.owners(pair.path.point)}
    # the points any two links have in common
    owners: dict[str, list[str]] = {}
    for name, link in draft.links.items():
        for point in link.points:
            owners.setdefault(point, []).append(name)
    shared: dict[tuple[str, str], tuple[str, ...]] = {}
    for point, links in owners.items():
        for first, second in combinations(links, 2):
            shared[first, second] = (*shared.get((first, second), ()), point)
    tied |= {link for links in shared for link in links}
    for name in draft.links:
        if name not in tied and name != FRAME:
            draft.problems.append(errors.LooseLink(draft.where("links", name), name))
    twice = ((links, points) for links, points in shared.items() if len(points) > 1)
    for (first, second), points in islice(twice, MOST_PROBLEMS):
        where = draft.where("links", second)
        to_frame = first == FRAME
        draft.problems.append(
            errors.CannotMove(where, second, points) if to_frame
            else errors.RigidlyJoined(where, first, second, points)
        )  # fmt: skip
    if not drivers:
        draft.problems.append(errors.NoDriver(Where(draft.file)))


def check_sizes(draft: Draft) -> None:
    """Note what lies so far off, or is so long, that beside it the shortest link has no digit left."""
    arms: dict[str, list[float]] = {}
    for name, link in draft.links.items():
        first, *others = link.points.values() if name != FRAME and link.points else (0j,)
        arms[name] = [length for place in others if (length := abs(place - first)) > 0]
    shortest = min((min(lengths) for lengths in arms.values() if lengths), default=0.0)
    if not shortest:
        return
    places: dict[KeyPath, float] = {("links", name): max(lengths) for name, lengths in arms.items() if lengths}
    fixed = draft.frame_points.items()
    places |= {draft.starts.get(name, ("frame", name)): abs(place) for name, place in fixed}
    for path, size in places.items():
        if size > UNEVEN * shortest:
            draft.problems.append(errors.OutOfRange(draft.where(*path), f"{size * 1e3:.6g} mm"))


def check_questions(draft: Draft, mechanism: Mechanism) -> None:
    """Note every text of `ask` about something that is not there, and all that asks nothing. A text must name what is
    there, or be a question in words, which ends with a question mark."""
    for number, question in enumerate(mechanism.ask):
        try:
            quantity = read(mechanism, question, NOWHERE)
            if quantity is None and not formed(question) and question[-1:] not in ("?", "？"):
                raise errors.NoQuestion(NOWHERE, question, meant(mechanism, question) or "")
        except GraphkinError as problem:
            draft.problems.append(problem.at(draft.where("ask", number)))
    for question in mechanism.worth:
        if question not in (*mechanism.ask, *EQUATIONS.values()):
            draft.problems.append(errors.UnknownQuantity(draft.where("points", question), question, mechanism.ask))


def remarks(mechanism: Mechanism) -> Iterator[errors.NoRate | errors.SketchMirrored]:
    """Notes on drivers that stand still because nothing is said of how fast they move, and on links that the sketch
    shows the other way round."""
    sketched = {**mechanism.links[FRAME].points, **mechanism.sketch}
    for name in mechanism.moving:
        points = mechanism.links[name].points
        for triple in combinations([point for point in mechanism.named(name) if point in sketched], 3):
            if orientation(points, triple, _SURELY) * orientation(sketched, triple, _SURELY) < 0:
                where = mechanism.where("sketch", next(point for point in triple[::-1] if point in mechanism.sketch))
                yield errors.SketchMirrored(where, mechanism.called(name), ", ".join(triple))
                break
    for number, driver in enumerate(mechanism.drivers):
        if driver.rate or not mechanism.lines:
            continue
        if not any(("driver", number, key) in mechanism.lines for key in RATES):
            yield errors.NoRate(mechanism.where("driver", number), driver.name, rate_keys(driver))


def rate_keys(driver: Driver) -> str:
    """The keys that say how fast a driver moves."""
    return {"slide": "velocity", "spin": "omega"}.get(driver.kind, "omega (velocity)")
