"""One letter stands for one point in a drawing, whatever the points of the mechanism are called."""

from __future__ import annotations

from functools import cache
from itertools import product
from pathlib import Path

import pytest

from graphkin import files as loading
from graphkin.construction import Construction, Normal
from graphkin.files import library
from graphkin.planning import Method, plan
from graphkin.say import names
from graphkin.sheet.lettering import point_label

CASES = Path(__file__).parents[1] / "cases"
LETTERS = str.maketrans("ABCE", "TKNM")
"""Letters of tips: t, k, n, and m where a point is called N."""


@cache
def planned(name: str) -> Method:
    name, _, other = name.partition(" with ")
    if other:
        return plan(loading.loads(library.text(name).translate(LETTERS)))
    return plan(loading.load(CASES / f"{name}.toml") if name.startswith("geneva") else library.load(name))


def images(construction: Construction) -> dict[str, str]:
    return {name: node.of for name, node in construction.nodes.items() if node.site is not None}


def tips(construction: Construction) -> set[str]:
    return {name for name, node in construction.nodes.items() if node.of.startswith("a^")}


EVERY = [*library.names(), "geneva-with-primes", *(f"{name} with their letters" for name in ("ex3-1", "ex3-2", "p3-6a", "fig3-1"))]


@pytest.mark.parametrize("name", EVERY)
def test_no_letter_is_two_points(name: str) -> None:
    method = planned(name)
    assert not {*method.velocity.nodes} & {*method.acceleration.nodes} - {n for n in method.velocity.nodes if n[0] == "*"}


@pytest.mark.parametrize("name", EVERY)
def test_tips_have_letters_that_no_point_has(name: str) -> None:
    method = planned(name)
    points = {name[0] for polygon in (method.velocity, method.acceleration) for name in images(polygon)}
    assert not {tip[0] for tip in tips(method.acceleration)} & points


@pytest.mark.parametrize("name", EVERY)
def test_normal_tips_are_named_after_the_link_that_turns(name: str) -> None:
    method = planned(name)
    called = method.mechanism.called
    for equation in method.acceleration.equations:
        for term in equation.left + equation.right:
            if isinstance(term.size, Normal) and term.head in tips(method.acceleration):
                home = method.structure.home(term.size.link)
                between = "_" if method.structure.is_link(home) and not called(home)[0].isdigit() else ""  # n_arm', n3'
                assert term.head[1:].startswith(between + called(home)), term


def test_words_and_drawing_count_corners_alike() -> None:
    assert names.point("n4_1'") == "n4,1′"
    assert names.point("b''") == "b″"
    assert names.point("e2'") == "e2′"


@pytest.mark.parametrize(("own", "link", "primes"), [*product(("", "'", "''"), ("", "3", "12", "guide", "连杆", "c1"), ("", "'", "''"))])
@pytest.mark.parametrize(("letter", "digits"), [("B", ""), ("b", ""), ("O", "1")])
def test_primes_stand_upright_and_links_below(letter: str, digits: str, own: str, link: str, primes: str) -> None:
    """Of any point, its own primes and those of the polygon: the sign between a point and its link is never printed."""
    at = "@" if link and (digits or not link.isdigit()) else ""
    label = point_label(letter + digits + own + at + link + primes)
    low = "".join(run.text for run in label if run.place == "sub")
    high = "".join(run.text for run in label if run.place == "base")
    assert (low, high) == (digits + link, letter + "′" * len(own + primes))


ROLLER_ON_A_CAM = """
[frame]
A = [0, 0]
D = [60, 0]
[links.1]
AB = 12
[links.2]
DC = 45
[[cam]]
links = ["1", "2"]
profiles = [{ centre = "B", radius = 25 }, { centre = "C", radius = 8 }]
[[driver]]
vector = "AB"
angle = 40
omega = 10
[sketch]
C = [35, 36]
"""


@pytest.mark.parametrize(("letters", "link"), [("ABCD", "2"), ("ABED", "2"), ("ABEH", "2"), ("AEHJ", "2"), ("ABCD", "e")])
def test_the_rod_of_a_contact_has_the_letter_of_no_point_and_no_link(letters: str, link: str) -> None:
    """In the words and on the sheet, where it is beside the tips of normal accelerations."""
    text = ROLLER_ON_A_CAM.translate(str.maketrans("ABCD", letters)).replace("links.2", f"links.{link}")
    method = plan(loading.loads(text.replace('"2"', f'"{link}"')))
    [rod] = (name for name in method.structure.bodies if " " in name)
    called = names.point(rod)
    assert called not in {*letters.lower(), link}
    [tip] = (name for name in method.acceleration.nodes if rod in name)
    assert "".join(run.text for run in point_label(tip)) == f"n{called}′" == names.point(tip).replace("_", "")


def test_the_rod_of_a_rolling_wheel_is_called_alike_in_the_words_and_on_the_sheet() -> None:
    assert names.point("ne r0'") == "n_f′"
    assert "".join(run.text for run in point_label("ne r0'")) == "nf′"
