"""The scene of mistakes: a method with its drawing, and its arrows; and the register of mistakes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field
from functools import cached_property
from itertools import chain, combinations
from typing import TypeVar

import numpy as np

from graphkin.base.geometry import Value, place
from graphkin.base.value import frozen
from graphkin.construction import Construction, Coriolis, Equation, Normal, Plane, Plot, Site, Size, Step, Term, kinds
from graphkin.marking.answers import ArrowPlaces, arrows_of
from graphkin.marking.hand import Redrawing, redraw
from graphkin.marking.rewrite import Change, Edit, Mistaken, Rewrite, RewrittenValue, Times
from graphkin.model.kinematic_state import Motions
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import Seen, in_order, spelled
from graphkin.model.quantities import Moving, Quantity
from graphkin.planning import Method
from graphkin.planning.equivalent import Contact
from graphkin.planning.stages import Group, Mesh
from graphkin.proof.readings import readings

Known = TypeVar("Known", bound=Size)


@frozen
class Scene:
    """A method at its drawing, and the quantities that are asked.

    scales  of the paper, where they are known: "length" [m/mm], "velocity" [(m/s)/mm], "acceleration" [(m/s^2)/mm]
    """

    method: Method
    plot: Plot
    quantities: tuple[Quantity, ...] = ()
    scales: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def arrows(self) -> ArrowPlaces:
        return arrows_of(self.method)

    @cached_property
    def motions(self) -> Motions:
        """The right ones."""
        return readings(self.method, self.plot)

    @cached_property
    def rolling(self) -> list[tuple[tuple[Contact, ...], tuple[str, ...]]]:
        """Rolling contacts that together give rotations, with the base links of these."""
        stages = (stage for stage in self.method.stages if isinstance(stage, Mesh | Group))
        return [((one.contact,), (one.angle,) if one.angle else ()) if isinstance(one, Mesh)
                else (one.contacts, one.angles) for one in stages]  # fmt: skip

    @property
    def polygons(self) -> tuple[Construction, Construction]:
        return self.method.velocity, self.method.acceleration

    def construction(self, plane: Plane) -> Construction:
        return self.method.velocity if plane == "velocity" else self.method.acceleration

    def steps(self, plane: Plane) -> tuple[Step, ...]:
        return self.construction(plane).steps

    def measures(self, plane: Plane) -> Iterator[kinds.Measure]:
        """Every rotation read off."""
        return (s for s in self.steps(plane) if isinstance(s, kinds.Measure) and s.quantity in ("omega", "alpha"))

    def sized(self, plane: Plane, kind: type[Known]) -> dict[Known, str]:
        """Known sizes of a kind, with the name of the arrow: those laid off, then those solved together."""
        found: dict[Known, str] = {}
        for step in self.steps(plane):
            if isinstance(step, kinds.LayOff) and isinstance(step.term.size, kind):
                found.setdefault(step.term.size, step.term.name(plane))
        for step in self.steps(plane):
            if isinstance(step, kinds.Simultaneous):
                for chain in step.chains:
                    found = {size: "" for size, _ in chain.known if isinstance(size, kind)} | found
        return found

    @cached_property
    def rims(self) -> dict[Normal, str]:
        """Normal accelerations about a wheel's centre of its named points that are found by image, with these."""
        contacts = chain.from_iterable(contacts for contacts, _ in self.rolling)
        wheels = chain.from_iterable(zip(each.wheels, each.centres, strict=True) for each in contacts)
        centres = {wheel: centre for wheel, centre in wheels if centre}
        images, known = self.images("acceleration"), self.sized("acceleration", Normal)
        rims = ((Normal(link, centres[link], step.corners[2]), step.point)
                for link in images if link in centres for step in images[link])  # fmt: skip
        return {rim: node for rim, node in rims
                if rim not in known and rim.tail != rim.head and rim.head in self.points(rim.link)}  # fmt: skip

    def term(self, size: Size, name: str, change: Change | None, form: str = "", way: str = "") -> Rewrite:
        """A known term of the accelerations that is otherwise, and what is handed in of it, where no arrow shows that;
        or one that is right but not laid off."""
        laid = (step for step in self.steps("acceleration") if isinstance(step, kinds.LayOff))
        tips = {step.tip: step.start for step in laid if step.term.size == size}
        if change is None and tips:
            edits = [Edit(("laid", "acceleration", tip), _staying(start)) for tip, start in tips.items()]
        elif size in self.rims:
            edits = [Edit(("image", "acceleration", self.rims[size]), _moved(size, change or Times(0.0)))]
        else:
            edits = [Edit(("arrow", "acceleration", size), change or Times(0.0))]
        return Rewrite((name,), form, tuple(edits), tuple(self._handed_in(size, change)) if change else (), way)

    def _handed_in(self, size: Size, change: Change) -> Iterator[RewrittenValue]:
        """The terms of a size that are handed in and that no arrow shows, as a change makes them."""
        part = {Coriolis: "k", Normal: "n"}.get(type(size))
        moving = (quantity for quantity in self.quantities if isinstance(quantity, Moving))
        for quantity in (q for q in moving if q.part == part and self.arrows.of(q) is None):
            drawing = redraw(self.method, self.plot)
            own, arrow = place(quantity.vector(self.motions)), place(drawing.arrow(size, "acceleration"))
            for sign in (1, -1):  # as it is named, or the other way round
                if abs(own - sign * arrow) <= 1e-9 * abs(arrow):
                    yield RewrittenValue(quantity.text, instead=sign * place(change(drawing, arrow)))

    def images(self, plane: Plane) -> dict[str, list[kinds.Image]]:
        """Further points by image, by link."""
        found: dict[str, list[kinds.Image]] = {}
        for step in self.steps(plane):
            if isinstance(step, kinds.Image):
                found.setdefault(step.link, []).append(step)
        return found

    def meets(self, plane: Plane) -> Iterator[tuple[kinds.Meet, Equation | None]]:
        """Every crossing with the equation it closes."""
        for part in self.construction(plane).parts:
            equation = part if isinstance(part, Equation) else None
            for step in part.steps if isinstance(part, Equation) else (part,):
                if isinstance(step, kinds.Meet):
                    yield step, equation

    def terms(self, plane: Plane) -> Iterator[Term]:
        """Every arrow of the equations, and those laid off alone."""
        return iter(self.construction(plane).vectors().values())

    def driven(self, link: str) -> bool:
        """True of links that turn as drivers say."""
        return self.turns_with(link, self.plot.facts.frame)

    @cached_property
    def cranks(self) -> tuple[str, ...]:
        """Links that drivers turn."""
        return tuple(
            link for link in self.method.mechanism.moving
            if link in self.plot.facts.turns and self.driven(link) and self.plot.facts.turns[link].drivers
            and np.any(self.plot.omega[link])
        )  # fmt: skip

    def cranks_beside(self, link: str) -> tuple[str, ...]:
        """The other cranks whose rotation has a ratio to a link's whatever the drivers do: instant centres give it."""
        right, without = self.motions.omega, self._without_driver.omega
        least = 1e-9 * max(float(np.max(np.abs(omega))) for omega in right.values()) ** 2
        return tuple(
            crank for crank in self.cranks
            if crank != link and np.all(np.abs(without[link] * right[crank] - without[crank] * right[link]) <= least)
        )  # fmt: skip

    @cached_property
    def _without_driver(self) -> Redrawing:
        """The velocities without each of the drivers (drivers,)."""
        still = [[Rewrite((), edits=(Edit(("rate", k), Times(0.0)),))] for k in range(len(self.method.drivers))]
        hand = Mistaken(still)
        return redraw(self.method, self.plot, hand, hand.shape)

    def turns_with(self, link: str, other: str) -> bool:
        turns = self.plot.facts.turns
        return turns[link].base == turns[other].base

    def links_of(self, site: Seen) -> tuple[str, ...]:
        """Moving links to which a point that is asked for belongs."""
        own = (site.link,) if site.explicit else self.method.mechanism.owners.get(site.point, ())
        return tuple(link for link in own if link != FRAME)

    def fixed(self, point: str) -> bool:
        return point in self.method.structure.bodies[FRAME]

    def points(self, link: str) -> tuple[str, ...]:
        """Points of a link that people named."""
        structure = self.method.structure
        return structure.named(link) if link in structure.bodies else ()

    def node(self, point: str, link: str, plane: Plane) -> str | None:
        return self.arrows.node(Site(point, link), plane)

    def ends(self, step: kinds.Measure) -> tuple[str, str] | None:
        """The acceleration polygon's points of a lever: between them lies all of what one is seen from the other."""
        pole = self.method.acceleration.pole
        tail, head = (self.node(point, step.of, "acceleration") or (pole if self.fixed(point) else None)
                      for point in step.lever)  # fmt: skip
        if tail is None or head is None or not {tail, head} <= self.drawn_before(step, "acceleration"):
            return None
        return tail, head

    def drawn_before(self, step: Step, plane: Plane) -> set[str]:
        """The corners of a polygon that are there when a step is done."""
        drawn = {self.construction(plane).pole}
        for earlier in self.steps(plane):
            if earlier is step:
                break
            drawn.update(drawn_by(earlier))
        return drawn

    def length(self, first: str, second: str) -> float:
        return abs(place(self.plot.arm(first, second)))

    def other_lengths(self, link: str, lever: tuple[str, str]) -> dict[str, float]:
        """Lengths that may be taken for that of a lever [m], by name: of its link, of moving links it is hinged to."""
        own = dict.fromkeys((*self.points(link), *lever))
        pairs = dict.fromkeys(combinations(own, 2))
        for hinge in self.points(link):
            for other in self.method.structure.owners.get(hinge, ()):
                if other not in (link, FRAME):
                    pairs |= dict.fromkeys((hinge, point) for point in self.points(other) if point != hinge)
        right, lengths = self.length(*lever), dict[str, float]()
        for pair in pairs:
            length = self.length(*pair)
            known = (right, *lengths.values())
            if length > 1e-9 * right and not any(abs(length - other) <= 1e-6 * other for other in known):
                lengths[self.length_name(*pair)] = length
        return lengths

    def length_name(self, first: str, second: str) -> str:
        return "l_" + "".join(in_order(first, second))

    def velocity_name(self, node: str) -> str:
        """v_B2 of b2."""
        return f"v_{self.method.velocity.nodes[node].of}"

    def rotation_name(self, quantity: str, link: str) -> str:
        return f"{quantity} {self.method.mechanism.called(self.method.structure.home(link))}"

    def omega_sign(self, link: str) -> str:
        """ω3, ω_lever of an angular velocity in a formula; ω_e of an equivalent link."""
        name = spelled(self.method.mechanism.called(link))
        return f"ω{name}" if name[0].isdigit() else f"ω_{name}"

    def image_name(self, images: list[kinds.Image]) -> tuple[str, ...]:
        """△BCE: the corners of a link's image; each by itself where they are no three single letters."""
        corners = [*dict.fromkeys(point for step in images for point in step.corners)]
        return ("△" + "".join(corners),) if [*map(len, corners)] == [1, 1, 1] else tuple(corners)


def _staying(start: str) -> Change:
    return lambda plot, right: plot.acceleration[start]


def _moved(size: Size, change: Change) -> Change:
    """A point found by image, as a change of a term moves it."""

    def moved(plot: Redrawing, right: Value) -> Value:
        arrow = plot.arrow(size, "acceleration")
        return right + change(plot, arrow) - arrow

    return moved


def drawn_by(step: Step) -> tuple[str, ...]:
    """The corners that a step adds to a polygon."""
    match step:
        case kinds.Given():
            return (step.point, *step.also)
        case kinds.LayOff():
            return (step.tip,)
        case kinds.Meet() | kinds.Image():
            return (step.point,)
        case _:
            return ()


Finder = Callable[[Scene], Iterable[Rewrite]]


@frozen
class Mistake:
    """A mistake there is: where it can be made in a scene.

    topic  its subject, as hints have it
    rule   the source's rule that it breaks, by section and equation of Sun Huan, 机械原理
    """

    topic: str
    rule: str
    find: Finder


MISTAKES: dict[str, Mistake] = {}  # every mistake by its id


def mistake(id: str, topic: str, rule: str) -> Callable[[Finder], Finder]:
    """Enters a mistake's function under its id."""

    def enter(find: Finder) -> Finder:
        MISTAKES[id] = Mistake(topic, rule, find)
        return find

    return enter
