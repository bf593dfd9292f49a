"""Value classes behave as frozen dataclasses do."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Mapping
from dataclasses import FrozenInstanceError, field, fields, replace
from typing import ClassVar

import pytest

from graphkin.base.value import frozen


@frozen
class Spot:
    """A place with a name."""

    name: str
    x: float = 0.0
    notes: Mapping[str, str] = field(default_factory=dict)


@frozen
class Dot:
    """Another class with the same fields as the beginning of `Spot`."""

    name: str
    x: float = 0.0


@frozen
class Checked:
    size: float

    def __post_init__(self) -> None:
        if self.size < 0:
            raise ValueError("less than nothing")


def test_values_are_equal_when_their_data_are():
    assert Dot("a", 1.0) == Dot(x=1.0, name="a") != Dot("a", 2.0)
    assert len({Dot("a"), Dot("a", 0.0), Dot("b")}) == 2
    assert Spot("a") != Dot("a")


def test_written_out():
    assert repr(Dot("a")) == "Dot(name='a', x=0.0)"


def test_defaults_are_made_anew():
    assert Spot("a").notes == {}
    assert Spot("a").notes is not Spot("b").notes


def test_what_dataclasses_offer():
    assert [f.name for f in fields(Spot)] == ["name", "x", "notes"]
    assert replace(Dot("a"), x=3.0) == Dot("a", 3.0)
    match Dot("a", 2.0):
        case Dot(name, x):
            assert (name, x) == ("a", 2.0)


@pytest.mark.parametrize("fields_first", [False, True])
def test_a_class_of_another(fields_first):
    @frozen
    class Base:
        name: str
        notes: Mapping[str, str] = field(default_factory=dict)
        kind: ClassVar[str] = "base"

    @frozen
    class Own(Base):
        size: float = 1.0
        marks: list[str] = field(default_factory=list)

    if fields_first:
        assert [f.name for f in fields(Base)] == ["name", "notes"]
    one, other = Own("a"), Own("b", {"c": "d"}, 2.0, ["e"])
    assert (one.name, one.notes, one.size, one.marks, one.kind) == ("a", {}, 1.0, [], "base")
    assert other == replace(one, name="b", notes={"c": "d"}, size=2.0, marks=["e"])
    match other:
        case Base(name, notes):
            assert (name, notes) == ("b", {"c": "d"})
    assert [f.name for f in fields(Own)] == ["name", "notes", "size", "marks"]
    with pytest.raises(TypeError, match="Own"):
        Own("a", kind="own")


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_copies_are_equal(again):
    assert again(Dot("a", 2.0)) == Dot("a", 2.0)


def test_nothing_changes_afterwards():
    with pytest.raises(FrozenInstanceError):
        Dot("a").x = 1.0
    with pytest.raises(FrozenInstanceError):
        del Dot("a").x


@pytest.mark.parametrize(
    ("args", "given"),
    [((), {}), (("a", 1.0, 2.0), {}), (("a",), {"name": "b"}), (("a",), {"z": 1}), ((), {"x": 1.0})],
)
def test_wrong_arguments(args, given):
    with pytest.raises(TypeError, match="Dot"):
        Dot(*args, **given)


def test_checked_when_made():
    with pytest.raises(ValueError, match="less than nothing"):
        Checked(-1.0)


def test_filled_often_is_filled_the_same():
    @frozen
    class Often:
        name: str
        x: float = 0.0
        notes: Mapping[str, str] = field(default_factory=dict)

        def __post_init__(self) -> None:
            if self.x < 0:
                raise ValueError("less than nothing")

    first = Often.__init__
    many = [Often(f"{k}", x=float(k)) for k in range(1000)]
    assert Often.__init__ is not first
    assert many[999] == Often("999", 999.0) == replace(many[0], name="999", x=999.0)
    assert (many[0].notes, many[0].notes is many[999].notes) == ({}, False)
    assert Often("a", notes={"b": "c"}).notes == {"b": "c"}
    assert [f.name for f in fields(Often)] == ["name", "x", "notes"]
    for args, given in [((), {}), (("a", 1.0, {}, 2), {}), (("a",), {"name": "b"}), (("a",), {"z": 1})]:
        with pytest.raises(TypeError, match="Often"):
            Often(*args, **given)
    with pytest.raises(ValueError, match="less than nothing"):
        Often("a", -1.0)
    with pytest.raises(FrozenInstanceError):
        many[0].x = 1.0
