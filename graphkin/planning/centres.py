"""Instant centres in the order a student finds them: by definition first, the rest by Kennedy's lines.

Source: Sun Huan, 机械原理, section 3-2.2: K = N(N-1)/2 centres (3-5), those of links that are joined directly, and
Kennedy-Aronhold's theorem. Each round of the search is a round of the circle diagram (消元法): a missing chord is found
when two triangles over it are complete but for it. Where two lines coincide another pair is taken; where no pair is
left (several freedoms, lines that coincide) one centre is taken from the velocities, and the lines go on from there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from graphkin.construction import AcrossGuide, Along, Plot, Ray, Touch, replay
from graphkin.construction.centring import CLEAR, CentreStep, Centring, Far, Join, Kennedy, Pole, Seat, line_of, take
from graphkin.mechanism import FRAME, Mechanism
from graphkin.planning import Method
from graphkin.planning.equivalent import Contact

__all__ = ["centre_name", "centres", "with_centres"]

WELL_APART = 0.05
"""Lines that are less than this far from being one are left for a later round."""

Pair = frozenset[str]


def centre_name(mechanism: Mechanism, first: str, second: str) -> str:
    """`P13`; `P1,3'` where names are longer than one letter. The smaller number first."""
    names = sorted((mechanism.called(first), mechanism.called(second)), key=_by_number)
    comma = "" if all(len(name) == 1 for name in names) else ","
    return f"P{names[0]}{comma}{names[1]}"


def _by_number(name: str) -> tuple[float, str]:
    number = re.match(r"\d+", name)
    return (float(number[0]) if number else np.inf, name)


def with_centres(method: Method, plot: Plot) -> tuple[Centring, Plot]:
    """The centres, and a plot of the same position that holds them."""
    plot = _moving(method, plot)
    search = _Search(method, plot)
    search.run()
    return Centring(tuple(search.steps), search.links, tuple(search.missing)), plot


def centres(method: Method, plot: Plot) -> Centring:
    """How all instant centres are found at the position of a plot with positions and velocities.

    Two lines that give a centre are chosen well apart for this position.
    """
    return with_centres(method, plot)[0]


def _moving(method: Method, plot: Plot) -> Plot:
    """The plot, to be written into; with all drivers at 1 where none of them moves: centres do not need a speed."""
    if any(driver.rate for driver in method.drivers):
        return replace(plot, centres={}, lean={})
    facts = replace(plot.facts, rates=tuple(1.0 for _ in method.drivers))
    still = replace(plot, facts=facts, velocity={}, omega={}, s_rate={}, centres={}, lean={})
    return replay(method.velocity, still)


@dataclass
class _Search:
    """Centres found so far, by their pair of links; normals of profiles that touch and slide."""

    method: Method
    plot: Plot
    steps: list[CentreStep] = field(default_factory=list)
    links: dict[str, tuple[str, str]] = field(default_factory=dict)
    known: dict[Pair, str] = field(default_factory=dict)
    normals: dict[Pair, list[Ray]] = field(default_factory=dict)

    @property
    def mechanism(self) -> Mechanism:
        return self.method.mechanism

    @property
    def names(self) -> list[str]:
        return sorted(self.mechanism.links, key=lambda link: _by_number(self.mechanism.called(link)))

    @property
    def missing(self) -> list[tuple[str, str]]:
        return [pair for pair in combinations(self.names, 2) if frozenset(pair) not in self.known]

    def run(self) -> None:
        for pair, step in self._by_definition():
            if pair not in self.known:
                self.take(pair, step)
        for pair, normal in _normals(self.mechanism):
            self.normals.setdefault(pair, []).append(normal)
        left: list[tuple[str, str]] = []
        while any(pair not in left for pair in self.missing):
            if not any(self._round(clear) for clear in (WELL_APART, CLEAR)) and not self._pole(left):
                return

    def take(self, pair: Pair, step: CentreStep) -> None:
        with np.errstate(divide="ignore", invalid="ignore"):
            take(step, self.plot)
        self.steps.append(step)
        self.known[pair] = step.centre
        first, second = sorted(pair, key=lambda link: _by_number(self.mechanism.called(link)))
        self.links[step.centre] = first, second

    def named(self, pair: Pair) -> str:
        first, second = pair
        return centre_name(self.mechanism, first, second)

    # --- by definition ------------------------------------------------------------------------

    def _by_definition(self) -> Iterator[tuple[Pair, CentreStep]]:
        """Hinges, sliding pairs, and contacts without sliding."""
        for hinge in self.mechanism.hinges:
            for two in combinations(hinge.links, 2):
                yield frozenset(two), Seat(self.named(frozenset(two)), hinge.point)
        for slide in self.mechanism.slides:
            if slide.block is not None:
                two = slide.guide, slide.block
                yield frozenset(two), Far(self.named(frozenset(two)), slide.name)
        for contact in self.method.structure.contacts:
            yield frozenset(contact.wheels), Seat(self.named(frozenset(contact.wheels)), "", _touch(contact))

    # --- Kennedy's lines ----------------------------------------------------------------------

    def _round(self, clear: float) -> bool:
        """One round over the missing centres; whether any was found."""
        found = False
        for two in self.missing:
            pair = frozenset(two)
            if (step := self._on_two_lines(pair, clear)) is not None:
                self.take(pair, step)
                found = True
        return found

    def _on_two_lines(self, pair: Pair, clear: float) -> Kennedy | None:
        """The two lines that are farthest from being one; the first two, where several are clear."""
        lines = [(line, line_of(line, self.plot)) for line in self._lines(pair)]
        lines = [(line, place) for line, place in lines if np.isfinite(place).all()]
        best: tuple[float, Kennedy] | None = None
        for (one, first), (other, second) in combinations(lines, 2):
            apart = float(np.linalg.norm(np.cross(first, second)))
            if apart > clear and (best is None or min(apart, 0.3) > best[0]):
                best = min(apart, 0.3), Kennedy(self.named(pair), one, other)
        return best[1] if best else None

    def _lines(self, pair: Pair) -> Iterator[Join | Ray]:
        """Every line on which a centre lies."""
        yield from self.normals.get(pair, ())
        first, second = sorted(pair, key=lambda link: _by_number(self.mechanism.called(link)))
        for third in self.names:
            one, other = self.known.get(frozenset((first, third))), self.known.get(frozenset((third, second)))
            if one is not None and other is not None:
                yield Join(one, other)

    # --- from velocities ----------------------------------------------------------------------

    def _pole(self, left: list[tuple[str, str]]) -> bool:
        """One centre from velocities, of the pair that most lines wait for; pairs without relative motion are left."""
        waiting = [pair for pair in self.missing if pair not in left]
        waiting.sort(key=lambda pair: (FRAME not in pair, -self._joined(pair)))
        for pair in waiting:
            step = Pole(self.named(frozenset(pair)), (self.motion(pair[0]), self.motion(pair[1])))
            with np.errstate(divide="ignore", invalid="ignore"):
                take(step, self.plot)
            if np.isfinite(self.plot.centres[step.centre]).all():
                self.take(frozenset(pair), step)
                return True
            del self.plot.centres[step.centre]
            left.append(pair)
        return False

    def _joined(self, pair: tuple[str, str]) -> int:
        """To how many others two links are joined directly."""
        return sum(not pair_.isdisjoint(pair) for pair_ in self.known)

    def motion(self, link: str) -> tuple[str, str, str]:
        """A link with a point of the mechanism and that point of it in the velocity polygon."""
        if link == FRAME:
            return link, "", ""
        owners = self.mechanism.owners
        for node in self.method.velocity.nodes.values():
            if node.site is None or node.site.point not in self.plot.position:
                continue
            at_home = link in owners.get(node.site.point, ()) and node.site.link in owners.get(node.site.point, ())
            if node.site.link == link or at_home:
                return link, node.site.point, node.name
        raise AssertionError(f"link {link} has no point in the velocity polygon")


def _touch(contact: Contact) -> Touch:
    """Where two wheels touch, or a wheel and its track."""
    first, second = contact.centres
    if contact.slide:
        return Touch("", second, slide=contact.slide, offset=-contact.radii[1])
    return Touch("", first, second, contact.radii[0] / sum(contact.radii))


def _normals(mechanism: Mechanism) -> Iterator[tuple[Pair, Ray]]:
    """The common normals of profiles that touch and slide: of cams, and of pins in slots."""
    for k, cam in enumerate(mechanism.cams):
        first, second = cam.profiles
        if first.line is None and second.line is None:
            assert first.centre is not None
            assert second.centre is not None
            yield frozenset(cam.links), Ray(first.centre, Along(first.centre, second.centre))
        else:
            disc = second if first.line is not None else first
            assert disc.centre is not None
            yield frozenset(cam.links), Ray(disc.centre, AcrossGuide(f"c{k}"))
    for slide in mechanism.slides:
        if slide.block is None:
            for link in mechanism.owners[slide.point]:
                yield frozenset((slide.guide, link)), Ray(slide.point, AcrossGuide(slide.name))

