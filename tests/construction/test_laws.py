"""Laws of constructions, over the library and random mechanisms of every kind."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
import random_mechanisms

from graphkin.base import tolerances
from graphkin.construction import (
    Across,
    Along,
    AlongGuide,
    Coriolis,
    Direction,
    Drawn,
    Driven,
    Normal,
    Quarter,
    Relative,
    Size,
    Tangential,
    Term,
    Turning,
)
from graphkin.errors import GraphkinError
from graphkin.files import library
from graphkin.model.mechanism import Mechanism
from graphkin.planning import plan

MAKERS = {kind: partial(random_mechanisms.dyad, kind) for kind in random_mechanisms.DYADS} | {
    name: getattr(random_mechanisms, name)
    for name in (
        "cylinder", "relative_angle", "coupler_angle", "chain", "triad", "six_bar", "geared_five_bar", "epicyclic", "rolling", "cam",
        "circular_slot",
    )
}  # fmt: skip


def way_of(size: Size) -> Direction | None:
    """Where a known arrow points: that follows from what its length is made of."""
    match size:
        case Normal(_, tail, head) | Relative(_, _, tail, head, "n"):
            return Along(head, tail)
        case Turning(_, tail, head) | Tangential(_, tail, head) | Relative(_, _, tail, head, _):
            return Across(tail, head)
        case Coriolis(link, tail, head):
            return Quarter(link, tail, head)
        case Driven(slide, _):
            return AlongGuide(slide)
        case _:
            return None


def known_terms(mechanism: Mechanism) -> Iterator[Term]:
    method = plan(mechanism)
    for construction in (method.velocity, method.acceleration):
        for equation in construction.equations:
            yield from (t for t in (*equation.left, *equation.right) if t.size is not None and not isinstance(t.size, Drawn))


@pytest.mark.parametrize("name", library.names())
def test_direction_is_that_of_the_size(name: str):
    for term in known_terms(library.load(name)):
        assert way_of(term.size) == term.direction, term


@pytest.mark.parametrize("kind", MAKERS)
def test_direction_is_that_of_the_size_in_random_mechanisms(kind: str):
    tried = 0
    for seed in range(12):
        try:
            terms = [*known_terms(MAKERS[kind](seed))]
        except GraphkinError:  # dead points and the like, which random lengths meet
            continue
        tried += 1
        assert all(way_of(term.size) == term.direction for term in terms)
    assert tried > 3


def test_tolerances_that_rooms_share_stand_once():
    """A name of `tolerances` is given a value nowhere else."""
    shared, owner = {name for name in vars(tolerances) if name.isupper()}, Path(tolerances.__file__)
    for path in owner.parent.rglob("*.py"):
        body = ast.parse(path.read_text("utf-8")).body
        names = {getattr(name, "id", "") for node in body if isinstance(node, ast.Assign) for name in node.targets}
        assert path == owner or not shared & names, path
