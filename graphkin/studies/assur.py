"""The structure of a mechanism: links, pairs, freedoms, and its Assur groups in the order they are solved.

The class of a group is that of its most complex part: II for a dyad, III for a ternary link on three legs, IV for
two links more that close a four-sided figure. The class of the mechanism is the highest of its groups'.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from graphkin.analytic import Mobility, mobility
from graphkin.base.plain import Plain
from graphkin.base.value import bulky, frozen
from graphkin.model.mechanism import FRAME
from graphkin.model.naming import PairName
from graphkin.model.pairs import RollingContact, pin_name, rod_name
from graphkin.planning import Method
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh
from graphkin.planning.structure import Hinge, Joint

__all__ = ["Structure", "Together", "as_json", "groups", "structure"]


@frozen
class Together:
    """Links that are solved together.

    kind      "dyad", "triad" (by a special point), "higher" (simultaneously), "train" of gears, "wheel" that rolls
    cls       the class: 2 and more; 1 for wheels, which are no Assur group
    letters   a dyad's pairs in order, R and P
    added     names of pairs whose pin, or whose link of the lower-pair equivalent, is one of the links
    merged    two links each that a driven sliding pair holds together as one
    point, ternary   a triad's special point, and the link on which it lies
    """

    kind: str
    cls: int
    links: tuple[str, ...]
    letters: str = ""
    point: str = ""
    ternary: str = ""
    added: tuple[SupposedLink, ...] = ()
    merged: tuple[tuple[str, ...], ...] = ()


@frozen
class SupposedLink:
    """A link of a group that the file does not have. kind: "block" at a point, or "rod" between two centres."""

    kind: str
    pair: PairName


@bulky
class Structure:
    """The links, pairs, freedoms and groups of a mechanism.

    method              the plan of the mechanism whose structure it is
    moving, low, high   counts of moving links, of lower and of higher pairs; rolling contacts are neither
    rolls               each rolling contact by its links, with the freedoms it takes: no slip, and the distance kept,
                        unless other pairs keep that
    uncounted           redundant constraints that the formula leaves out: distances from a track that others keep
    mobility            degrees of freedom by rank
    groups              in the order they are solved
    methods             keys of the methods that the construction needs: "two points", "coincident", ..
    """

    method: Method
    moving: int
    low: int
    high: int
    mobility: Mobility
    groups: tuple[Together, ...]
    methods: tuple[str, ...]
    rolls: tuple[tuple[tuple[str, ...], int], ...] = ()
    uncounted: int = 0

    @property
    def rolled(self) -> int:
        return sum(taken for _, taken in self.rolls)

    @property
    def repeated(self) -> int:
        """Redundant constraints; a rack against its pinion is like two gears, whose distance is nobody's constraint."""
        tracks = [pair.line for pair in self.method.mechanism.pairs if isinstance(pair, RollingContact)]
        kept = sum(line is not None and taken == 1 for line, (_, taken) in zip(tracks, self.rolls, strict=True))
        return self.mobility.repeated - kept + self.uncounted

    @property
    def formula(self) -> int:
        """F = 3 n - 2 p_l - p_h, less what rolling contacts take."""
        return 3 * self.moving - 2 * self.low - self.high - self.rolled

    @property
    def cls(self) -> int:
        return max((group.cls for group in self.groups), default=1)


def structure(method: Method) -> Structure:
    """The structure; a pin in a slot, a cam pair and a gear pair take one freedom, rolling contact one, or two."""
    mechanism = method.mechanism
    others = [pair for pair in mechanism.pairs if not isinstance(pair, RollingContact)]
    low = sum(len(hinge.links) - 1 for hinge in mechanism.hinges) + sum(pair.lower for pair in others)
    high = sum(not pair.lower for pair in others)
    spaced = {slide.name for slide in method.structure.joining if slide.stands_for is not None}
    rolls = []  # other pairs keep its distance where neither a path nor a rod stands for a rolling contact
    for pair in mechanism.pairs:
        if isinstance(pair, RollingContact):
            alone = pair.name in spaced or rod_name(pair) in method.structure.bodies
            rolls.append((tuple(mechanism.called(link) for link in pair.joins), 2 if alone else 1))
    uncounted = sum(each.part == "line" and each.pair[0] == RollingContact.table for each in method.aside)
    return Structure(
        method, len(mechanism.moving), low, high, mobility(mechanism),
        groups(method), tuple(_methods(method)), tuple(rolls), uncounted,
    )  # fmt: skip


def groups(method: Method) -> tuple[Together, ...]:
    """The groups in the order they are solved; driven links are Class I by themselves and make no group."""
    solved: list[Together] = []
    for stage in method.stages:
        match stage:
            case Loop():
                solved.append(_dyad(method, stage))
            case Group() if not stage.loops:
                solved.append(Together("train", 1, _links_of_file(method, stage.angles)))
            case Group() if len(stage.loops) == 1 and not stage.contacts and not stage.bodies:  # it floats
                solved.append(_dyad(method, stage.loops[0]))
            case Group():
                ternary, bodies = method.ternaries.get(stage), stage.bodies
                kind, point, link = ("triad", ternary.name, ternary.link) if ternary is not None else ("higher", "", "")
                cls = 3 if ternary is not None else min(2 + len(stage.loops), 5)  # two loops close a four-sided figure
                links, added, merged = _links_of_file(method, bodies), _added(method, bodies), _merged(method, stage)
                solved.append(Together(kind, cls, links, "", point, link, added, merged))
            case Mesh():
                wheels = tuple(method.mechanism.called(wheel) for wheel in stage.contact.wheels)
                solved.append(Together("wheel", 1, wheels))
            case Carry() | Bridge():
                pass
            case _:
                assert_never(stage)
    return tuple(solved)


def _dyad(method: Method, stage: Loop) -> Together:
    """Two links; one that only translates on the other, hinged to the rest, is none of the loop's unknowns."""
    letters = [_letter(method, joint) for joint in stage.joints]
    bodies = stage.bodies
    if len(bodies) == 1:
        ends = []
        for joint in stage.joints:
            slide = None if isinstance(joint, Hinge) else method.structure.slides[joint.slide]
            pair = (slide.guide, method.structure.block(slide)) if slide else (FRAME, FRAME)
            ends.append(pair[0] if pair[1] == bodies[0] else pair[1])
        k = next(k for k, end in enumerate(ends) if end != FRAME)
        bodies, letters[k] = (*bodies, ends[k]), "RP" if k == 0 else "PR"
    links, added, merged = _links_of_file(method, bodies), _added(method, bodies), _merged(method, stage)
    return Together("dyad", 2, links, "".join(letters), added=added, merged=merged)


def _letter(method: Method, joint: Joint) -> str:
    """R for a hinge, P for a sliding pair; a driven one counts as rigid."""
    if isinstance(joint, Hinge):
        owners = method.mechanism.owners.get(joint.point, ())
        return "" if any({*pair} <= {*owners} for pair in _motors(method)) else "R"
    return "" if joint.slide in method.structure.slides_driven else "P"


def _links_of_file(method: Method, bodies: tuple[str, ...]) -> tuple[str, ...]:
    """Links of the file; blocks that stand for pins and links of an equivalent are none."""
    return tuple(body for body in bodies if body in method.mechanism.links and body != FRAME)


def _added(method: Method, bodies: tuple[str, ...]) -> tuple[SupposedLink, ...]:
    """Pins in slots, and links that stand for a cam pair or hold a rolling wheel."""
    structure, pairs = method.structure, method.mechanism.pairs
    supposed: list[SupposedLink] = []
    made = {name(pair): pair for name in (pin_name, rod_name) for pair in pairs}
    for body in bodies:
        if not structure.is_link(body) and body in made:
            pair = made[body]
            number = [each for each in pairs if each.table == pair.table].index(pair)
            supposed.append(SupposedLink("block" if structure.is_pin(body) else "rod", (pair.table, number)))
    return tuple(supposed)


def _merged(method: Method, stage: Loop | Group) -> tuple[tuple[str, ...], ...]:
    """A cylinder and its rod are one link while the displacement is given, as two links with a motor between are."""
    structure = method.structure
    driven = [slide for slide in structure.joining if slide.name in structure.slides_driven]
    pairs = [*((slide.guide, structure.block(slide)) for slide in driven), *_motors(method)]
    return tuple(_links_of_file(method, pair) for pair in pairs if {*pair} <= {*stage.bodies})


def _motors(method: Method) -> list[tuple[str, str]]:
    """Two moving links each whose angle to each other is driven."""
    drivers = method.mechanism.drivers
    return [(d.from_link, d.link) for d in drivers if d.kind != "slide" and d.from_link != FRAME]


def _methods(method: Method) -> Iterator[str]:
    terms = [term for equation in method.acceleration.equations for term in equation.left + equation.right]
    if any(term.part == "t" and not term.over for term in terms):
        yield "two points"
    if any(term.part == "k" for term in terms):
        yield "coincident"
    if method.ternaries:
        yield "special"
    groups = [stage for stage in method.stages if isinstance(stage, Group)]
    if any(stage not in method.ternaries for stage in groups):
        yield "together"
    if any(pair.rolling is not None for pair in method.mechanism.pairs):
        yield "rolling"
    if any(pair.equivalent is not None and pair.rolling is None for pair in method.mechanism.pairs):
        yield "lower"


def as_json(whole: Structure) -> dict[str, Plain]:
    """The structure as `structure --json` prints it."""
    mechanism = whole.method.mechanism
    groups: list[Plain] = []
    for group in whole.groups:
        entry: dict[str, Plain] = {"kind": group.kind, "class": group.cls, "links": list(group.links)}
        entry |= {"letters": group.letters} if group.letters else {}
        entry |= {"point": group.point, "ternary": group.ternary} if group.point else {}
        groups.append(entry)
    return {
        "format": 1, "name": mechanism.name, "links": list(mechanism.moving), "frame": mechanism.frame,
        "lower_pairs": whole.low, "higher_pairs": whole.high, "formula": whole.formula,
        "freedoms": whole.mobility.freedoms,
        "drivers": [driver.name for driver in mechanism.drivers], "class": whole.cls, "groups": groups,
        "methods": list(whole.methods),
    }  # fmt: skip
