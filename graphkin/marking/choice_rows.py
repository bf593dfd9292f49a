"""The rows of choices for the vector equations of a plane: directions and magnitudes, each with its value."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from itertools import combinations, permutations
from typing import Literal

import numpy as np

from graphkin.base.geometry import Value, cross, unit
from graphkin.base.value import frozen
from graphkin.construction import Construction, Plane, Plot, terms
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import in_order, spelled
from graphkin.planning import Method

Kind = Literal["?", "given", "0", "parallel", "perpendicular", "towards", "guide", "across guide", "product"]
UNKNOWN, KNOWN, NOTHING = "?", "given", "0"
AXES = ("x", "y")
SAME = 1e-6  # of directions that are parallel, of parts by which sizes are equal


@frozen
class RowChoice:
    """An entry of the row of directions or of magnitudes.

    token   as a file has it: `perpendicular AB`, `B to A`, `parallel guide C`, `2*omega_3*v_B3B2`, `?`, `given`, `0`
    points  of a line, in order; of a guide what it guides
    factors of a product: `2`, `omega_3`, `omega_3^2`, `l_AB`, `v_B3B2`
    """

    token: str
    kind: Kind
    points: tuple[str, ...] = ()
    factors: tuple[str, ...] = ()


@frozen
class ChoiceRows:
    """The choices of one plane, each with its values at all positions: unit vectors or sizes (positions,)."""

    method: Method
    plots: list[Plot]
    polygon: Construction

    @property
    def plane(self) -> Plane:
        return self.polygon.plane

    @cached_property
    def of_links(self) -> Mapping[str, tuple[str, ...]]:
        """The points of each moving link that have a letter, also of links that stand for contacts; with those that
        slide on it, and special points."""
        method, structure = self.method, self.method.structure
        bodies = (body for body in structure.bodies if body != FRAME and not structure.is_pin(body))
        points = {body: dict.fromkeys(structure.named(body)) for body in bodies}
        for slide in structure.slides.values():
            if slide.guide in points and slide.point not in method.mechanism.unnamed:
                points[slide.guide][slide.point] = None
        for special in sorted(method.special):
            site = method.position.nodes[special].site
            if site is not None and site.link in points:
                points[site.link][special] = None
        return {link: tuple(there) for link, there in points.items()}

    @cached_property
    def pairs(self) -> list[tuple[str, str]]:
        """The lines between two points: of each moving link, along guides of the frame, and those that any arm is."""
        mechanism, links = self.method.mechanism, self.of_links.values()
        pairs: set[tuple[str, str]] = {in_order(*pair) for there in links for pair in combinations(there, 2)}
        for slide in self.method.structure.slides.values():
            fixed = mechanism.named(FRAME) if slide.guide == FRAME else ()
            guide, at = self._guide(slide.name), slide.point
            pairs |= {in_order(one, at) for one in fixed if self.same_line(guide, self._line(one, at))}
        for polygon in (self.method.velocity, self.method.acceleration):
            for term in (term for equation in polygon.equations for term in equation.left + equation.right):
                if isinstance(term.direction, terms.Along | terms.Across):
                    pairs.add(in_order(term.direction.tail, term.direction.head))
        apart = (pair for pair in pairs if self._length(*pair)[0] > mechanism.usual.least("m"))
        return sorted(pair for pair in apart if mechanism.unnamed.isdisjoint(pair))

    @cached_property
    def directions(self) -> Mapping[RowChoice, np.ndarray | None]:
        """Choices of direction; those without a value are the words."""
        choices: dict[RowChoice, np.ndarray | None] = {RowChoice(UNKNOWN, "?"): None, RowChoice(KNOWN, "given"): None}
        for pair in self.pairs:
            letters, line = "".join(pair), self._line(*pair)
            choices[RowChoice(f"parallel {letters}", "parallel", pair)] = line
            choices[RowChoice(f"perpendicular {letters}", "perpendicular", pair)] = 1j * line
            for tail, head in permutations(pair):
                choices[RowChoice(f"{tail} to {head}", "towards", (tail, head))] = self._line(tail, head)
        axes = {RowChoice(f"parallel {axis}", "guide", (axis,)): np.full(len(self.plots), along)
                for axis, along in zip(AXES, (1 + 0j, 1j))}  # fmt: skip
        choices |= axes
        lines = [*(self._line(*pair) for pair in self.pairs), *axes.values()]
        for slide in self.method.structure.slides.values():
            guide = self._guide(slide.name)
            if not any(self.same_line(guide, line) for line in lines):
                named = [choice for choice in choices if choice.kind == "guide" and choice.points == (slide.point,)]
                guided = f"guide {slide.name if named else slide.point}"
                choices[RowChoice(f"parallel {guided}", "guide", (slide.point,))] = guide
                choices[RowChoice(f"perpendicular {guided}", "across guide", (slide.point,))] = 1j * guide
                lines.append(guide)
        return choices

    @cached_property
    def magnitudes(self) -> Mapping[RowChoice, np.ndarray | None]:
        """Choices of magnitude; those without a value are the words."""
        choices: dict[RowChoice, np.ndarray | None] = {
            RowChoice(UNKNOWN, "?"): None, RowChoice(KNOWN, "given"): None, RowChoice(NOTHING, "0"): None
        }  # fmt: skip
        for factors, value in self._products():
            choices.setdefault(RowChoice("*".join(factors), "product", factors=factors), value)
        return choices

    def _products(self) -> Iterator[tuple[tuple[str, ...], np.ndarray]]:
        in_velocity, contacts = self.plane == "velocity", self.method.structure.contacts
        wheels = [pair for one in contacts for pair in zip(one.wheels, one.radii, strict=True) if pair[0] != FRAME]
        powers = ((1, "omega"),) if in_velocity else ((2, "omega"), (1, "omega"), (1, "alpha"))
        for power, word in powers:
            for low, link, rate in self._rates(word):
                factor = f"{word}_{low}" + ("^2" if power == 2 else "")
                for pair in self.pairs:
                    if not {*self.of_links[link]}.isdisjoint(pair):
                        yield (factor, f"l_{''.join(pair)}"), rate**power * self._length(*pair)
                for radius in sorted({abs(radius) for wheel, radius in wheels if wheel == link and radius}):
                    yield (factor, f"r_{low}"), rate**power * radius
        for low, _, rate in () if in_velocity else self._rates("omega"):
            for name, (tail, head) in self.velocities.items():
                speed = np.abs(np.array([plot.velocity[head] - plot.velocity[tail] for plot in self.plots]))
                yield ("2", f"omega_{low}", name), rate * 2.0 * speed
                yield (f"omega_{low}", name), rate * speed

    def _rates(self, word: str) -> Iterator[tuple[str, str, np.ndarray]]:
        """The size of each link's rotation, by how it is written; then those that drivers give against another link."""
        mechanism, order = self.method.mechanism, 1 if word == "omega" else 2
        for link in self.of_links:
            rates = [(plot.omega if order == 1 else plot.alpha)[link] for plot in self.plots]
            yield self.called(link), link, np.abs(np.array(rates))
        for driver in mechanism.drivers:
            if driver.kind != "slide" and driver.from_link != FRAME:
                link, other = driver.link, driver.from_link
                rates = [plot.facts.relative_rate(link, order) - plot.facts.relative_rate(other, order)
                         for plot in self.plots]  # fmt: skip
                yield self.against(link, other), link, np.abs(np.array(rates))

    @cached_property
    def velocities(self) -> Mapping[str, tuple[str, str]]:
        """The relative velocities of sliding on what turns, and both velocities between which they are; by name."""
        velocity, arrows = self.method.velocity, dict[str, tuple[str, str]]()
        named = {(term.tail, term.head): name for name, term in velocity.vectors().items() if not term.over}
        for equation in self.method.acceleration.equations:
            for term in equation.left + equation.right:
                if isinstance(term.size, terms.Coriolis):
                    ends = (term.size.tail, term.size.head)
                    arrows[named.get(ends, f"v_{term.of}{term.seen_from}")] = ends
                    for node in (node for node in ends if node != velocity.pole):
                        arrows[f"v_{velocity.nodes[node].of}"] = (velocity.pole, node)
        return arrows

    def against(self, link: str, seen_from: str) -> str:
        """`21`; `arm,base` of links that words name."""
        names = (self.called(link), self.called(seen_from))
        return ("" if all(len(name) == 1 for name in names) else ",").join(names)

    def called(self, link: str) -> str:
        """A link as people call it; a pin turns with its slot."""
        structure = self.method.structure
        return spelled(self.method.mechanism.called(structure.pins[link].guide if structure.is_pin(link) else link))

    def at_each(self, value: Callable[[Plot], Value]) -> np.ndarray:
        return np.array([value(plot) for plot in self.plots])

    def same_line(self, one: np.ndarray, other: np.ndarray, here: bool = False) -> bool:
        """Parallel at all positions where both are any direction; or only `here`, at the drawn one."""
        across = np.abs(cross(one, other))[: 1 if here else None]
        there = across[np.isfinite(across)]
        return bool(there.size and there.max() < SAME)

    def _line(self, tail: str, head: str) -> np.ndarray:
        return self.at_each(lambda plot: unit(plot.arm(tail, head)))

    def _guide(self, slide: str) -> np.ndarray:
        return self.at_each(lambda plot: plot.guide_direction(slide))

    def _length(self, first: str, second: str) -> np.ndarray:
        return np.asarray(np.abs(self.at_each(lambda plot: plot.arm(first, second))))
