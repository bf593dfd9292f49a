"""What a mechanism is made of: links, pairs, freedoms, and its Assur groups in the order they are solved.

The class of a group is that of its most complex part: II for a dyad, III for a ternary link on three legs, IV for
two links more that close a four-sided figure. The class of the mechanism is the highest of its groups'.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from graphkin.analytic import Mobility, mobility
from graphkin.mechanism import FRAME
from graphkin.planning import Method
from graphkin.planning.stages import Bridge, Carry, Group, Loop, Mesh
from graphkin.planning.structure import Hinge, Joint
from graphkin.value import frozen

__all__ = ["Structure", "Together", "as_json", "structure"]


@frozen
class Together:
    """Links that are solved together.

    kind      "dyad", "triad" (by a special point), "higher" (simultaneously), "train" of gears, "wheel" that rolls
    cls       the class: 2 and more; 1 for wheels, which are no Assur group
    letters   a dyad's pairs in order, R and P
    point, ternary   a triad's special point, and the link on which it lies
    """

    kind: str
    cls: int
    links: tuple[str, ...]
    letters: str = ""
    point: str = ""
    ternary: str = ""


@frozen
class Structure:
    """What a mechanism is made of.

    moving, low, high   counts of moving links, of lower and of higher pairs
    mobility            degrees of freedom by rank
    groups              in the order they are solved
    methods             keys of the methods that the construction needs: "two points", "coincident", ..
    """

    moving: int
    low: int
    high: int
    mobility: Mobility
    groups: tuple[Together, ...]
    methods: tuple[str, ...]

    @property
    def formula(self) -> int:
        """F = 3 n - 2 p_l - p_h."""
        return 3 * self.moving - 2 * self.low - self.high

    @property
    def cls(self) -> int:
        return max((group.cls for group in self.groups), default=1)


def structure(method: Method) -> Structure:
    """A pin in a slot, a cam pair and a gear pair take one freedom, rolling contact two."""
    mechanism = method.mechanism
    low = sum(len(hinge.links) - 1 for hinge in mechanism.hinges) + sum(pair.lower for pair in mechanism.pairs)
    high = sum(not pair.lower for pair in mechanism.pairs)
    return Structure(
        len(mechanism.moving), low, high, mobility(mechanism),
        tuple(_groups(method)), tuple(_methods(method)),
    )  # fmt: skip


def _groups(method: Method) -> Iterator[Together]:
    """Driven links are Class I by themselves and make no group."""
    for stage in method.stages:
        match stage:
            case Loop():
                letters = "".join(_letter(method, joint) for joint in stage.joints)
                yield Together("dyad", 2, _named(method, stage.bodies), letters)
            case Group() if not stage.loops:
                yield Together("train", 1, _named(method, stage.angles))
            case Group():
                yield _group(method, stage)
            case Mesh():
                yield Together("wheel", 1, tuple(method.mechanism.called(wheel) for wheel in stage.contact.wheels))
            case Carry() | Bridge():
                pass


def _group(method: Method, stage: Group) -> Together:
    links = _named(method, stage.bodies)
    if (found := method.ternaries.get(stage)) is not None:
        return Together("triad", 3, links, point=found.name, ternary=found.link)
    cls = 4 if len(stage.loops) == 2 and not stage.contacts else 3 + len(stage.loops) - 1
    return Together("higher", min(cls, 5), links)


def _letter(method: Method, joint: Joint) -> str:
    """R for a hinge, P for a sliding pair; a driven one counts as rigid."""
    if isinstance(joint, Hinge):
        return "R"
    return "" if joint.slide in method.structure.slides_driven else "P"


def _named(method: Method, bodies: tuple[str, ...]) -> tuple[str, ...]:
    """Links of the file; blocks that stand for pins and links of an equivalent are none."""
    return tuple(body for body in bodies if body in method.mechanism.links and body != FRAME)


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


def as_json(method: Method) -> dict[str, Any]:
    """What `structure --json` prints."""
    mechanism, found = method.mechanism, structure(method)
    groups = [
        {"kind": group.kind, "class": group.cls, "links": list(group.links)}
        | ({"letters": group.letters} if group.letters else {})
        | ({"point": group.point, "ternary": group.ternary} if group.point else {})
        for group in found.groups
    ]
    return {
        "format": 1, "name": mechanism.name, "links": list(mechanism.moving), "frame": mechanism.frame,
        "lower_pairs": found.low, "higher_pairs": found.high, "formula": found.formula,
        "freedoms": found.mobility.freedoms,
        "drivers": [driver.name for driver in mechanism.drivers], "class": found.cls, "groups": groups,
        "methods": list(found.methods),
    }  # fmt: skip
