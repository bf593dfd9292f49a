"""Centrodes roll on each other, are right at every position, and are cut where they run to infinity."""

from __future__ import annotations

import os
import re
from dataclasses import replace

import numpy as np
import pytest
from playing import still
from random_mechanisms import (
    DYADS,
    cam,
    chain,
    cylinder,
    dyad,
    epicyclic,
    geared_five_bar,
    relative_angle,
    rolling,
    six_bar,
    triad,
)

from graphkin import sweep
from graphkin.analytic import motion
from graphkin.construction.drafting import INFINITE
from graphkin.errors import GraphkinError, UnknownLink
from graphkin.errors.studies import NoCentrode, UnknownCentre
from graphkin.files import library, loads
from graphkin.model.mechanism import FRAME, Mechanism
from graphkin.outputs.animation import animation
from graphkin.outputs.svg import svg
from graphkin.planning import plan
from graphkin.running import replay_all
from graphkin.sheet.centrode_sheet import centrode_frames, centrode_sheet
from graphkin.sheet.marks import Stroke, Text
from graphkin.studies.centres import Centres, centres
from graphkin.studies.centres.centrodes import Centrodes, centrodes, path, whole
from graphkin.studies.centres.instant_centres import carried_to, over
from graphkin.studies.sweeps import Course, course


def moved(mechanism: Mechanism) -> tuple[Centres, Course]:
    method = plan(mechanism)
    return centres(method, replay_all(method)), course(method)


def rolled(name: str, first: str, second: str) -> Centrodes:
    found, drive = moved(library.load(name))
    return centrodes(found, first, second, drive, whole(drive))


def all_of(found: Centres, drive: Course) -> list[Centrodes]:
    curves = []
    for first, second in found.pairs:
        try:
            curves.append(centrodes(found, first, second, drive, whole(drive)))
        except NoCentrode:
            continue
    return curves


RANDOM = [(kind, seed) for kind in (*DYADS, "chain") for seed in range(3)]


def some(kind: str, seed: int) -> tuple[Centres, Course] | None:
    try:
        return moved(chain(seed) if kind == "chain" else dyad(kind, seed))
    except GraphkinError:
        return None


def arc_length(places: np.ndarray) -> np.ndarray:
    """The length from the first place to the end of each cell of two steps: (cells + 1,), to the fourth order."""
    begin, middle, end = places[:-2:2], places[1::2], places[2::2]
    halves, chord = np.abs(middle - begin) + np.abs(end - middle), np.abs(end - begin)
    return np.concatenate([[0.0], np.cumsum((4 * halves - chord) / 3)])


def hold_rolling(curves: Centrodes) -> None:
    """Equal arc lengths between positions; one tangent at the centre, by differences of each curve for itself."""
    size = curves.found.board.size
    for piece in curves.pieces:
        fixed, moving = arc_length(piece.places[0]), arc_length(piece.places[-1])
        assert abs(fixed[-1] - moving[-1]) < 1e-6 * max(fixed[-1], 1e-3 * size), curves.name
        assert np.all(np.abs(fixed - moving) < 1e-6 * (fixed[-1] + 1e-3 * size))
        turns = [curves.standing(link, piece.t)[1] for link in curves.axes]
        ways = [turn[1::2] * (places[2::2] - places[:-2:2]) for turn, places in zip(turns, piece.places, strict=True)]
        long = np.abs(ways[0]) > 1e-4 * size
        both = np.angle(ways[1][long] / ways[0][long])
        # Chords of two curves of different curvature differ in direction by less than their bend squared.
        assert np.all(np.abs(both) < 0.02), curves.name
        assert np.median(np.abs(both)) < 2e-3 if both.size else True


@pytest.mark.many(6)
@pytest.mark.parametrize("name", library.names())
def test_centrodes_of_the_library_roll(name: str):
    found, drive = moved(library.load(name))
    for curves in all_of(found, drive):
        hold_rolling(curves)


@pytest.mark.many
@pytest.mark.parametrize(("kind", "seed"), RANDOM)
def test_random_centrodes_roll(kind: str, seed: int):
    if (made := some(kind, seed)) is not None:
        for curves in all_of(*made)[:6]:
            hold_rolling(curves)


@pytest.mark.many(6)
@pytest.mark.parametrize("name", library.names())
def test_every_position_against_the_analysis(name: str):
    """Where Kennedy's lines run together, too."""
    hold_every_position(library.load(name))


MAKERS = {"chain": chain, "triad": triad, "six": six_bar, "geared": geared_five_bar, "epicyclic": epicyclic,
          "rolling": rolling, "cam": cam, "cylinder": cylinder, "relative": relative_angle}  # fmt: skip


@pytest.mark.many
@pytest.mark.parametrize("kind", [*MAKERS, *DYADS])
def test_every_random_position_against_the_analysis(kind: str):
    tried = 0
    for seed in range(4 if "GRAPHKIN_RANDOM" in os.environ else 2):
        try:
            mechanism = MAKERS[kind](seed) if kind in MAKERS else dyad(kind, seed)
            found = plan(mechanism)
            replay_all(found)
        except GraphkinError:
            continue
        tried += 1
        hold_every_position(mechanism)
    assert tried


def test_where_lines_coincide():
    """Positions sought out at which the two lines of a centre are one: Kennedy says nothing there."""
    sought = 0
    for name in library.names()[:: 1 if "GRAPHKIN_RANDOM" in os.environ else 2]:
        mechanism = library.load(name)
        found, drive = moved(mechanism)
        low, high = whole(drive)
        t = np.linspace(low + 0.03 * (high - low), high - 0.03 * (high - low), 721)
        one = [_leanest(found, drive, centre, beside) for centre, beside in _leaning(found, drive, t).items()]
        one = [at for at in one if at is not None]
        if one:
            sought += len(one)
            hold_every_position(mechanism, np.array(one))
    assert sought > 10


def _leaning(found: Centres, drive: Course, t: np.ndarray) -> dict[str, np.ndarray]:
    """Centres whose lines come near to being one somewhere, and t beside where they are nearest."""
    beside = {}
    for centre, leans in over(found, drive.path, t).board.lean.items():
        lean = np.broadcast_to(leans, t.shape)
        if np.isfinite(lean).any() and np.nanmin(lean) < 0.1:
            beside[centre] = _finer(t, int(np.nanargmin(lean)))
    return beside


def _leanest(found: Centres, drive: Course, centre: str, t: np.ndarray) -> float | None:
    """Where the lines of a centre come to be one within 1e-8."""
    for _ in range(8):
        lean = np.broadcast_to(over(found, drive.path, t).board.lean[centre], t.shape)
        if not np.isfinite(lean).any():
            return None
        k = int(np.nanargmin(lean))
        t, least = _finer(t, k), float(t[k]) if lean[k] < 1e-8 else None
    return least


def _finer(t: np.ndarray, k: int) -> np.ndarray:
    return np.linspace(t[max(k - 1, 0)], t[min(k + 1, t.size - 1)], 41)


def hold_every_position(mechanism: Mechanism, t: np.ndarray | None = None) -> None:
    """Each centre at many positions is the one by the analysis' velocities, as homogeneous coordinates."""
    found, drive = moved(mechanism)
    low, high = whole(drive)
    t = np.linspace(low + 0.03 * (high - low), high - 0.03 * (high - low), 149) if t is None else t
    there, origin, size = over(found, drive.path, t), found.board.origin, found.board.size
    paced = tuple(replace(d, rate=p) for d, p in zip(mechanism.drivers, drive.path.pace, strict=True))
    exact = motion(replace(mechanism, drivers=paced), [np.broadcast_to(value, t.shape) for value in drive.path.values(t)])
    pace = np.max(np.broadcast_arrays(*(np.abs(value) for value in exact.omega.values())), axis=0)
    drawn = np.all([np.broadcast_to(np.isfinite(value), t.shape) for value in there.plot.velocity.values()], axis=0)
    assert drawn.mean() > 0.5
    for first, second in found.pairs:
        parts = []
        for link in (first, second):
            point = next(iter(mechanism.links[link].points), None)
            if link == FRAME or point is None:
                parts.append((0j, 0.0))
                continue
            velocity = exact.velocity_at(point, link) + 1j * exact.omega[link] * (origin - exact.position[point])
            parts.append((velocity / size, exact.omega[link]))
        across, turning = 1j * (parts[0][0] - parts[1][0]), parts[0][1] - parts[1][1]
        wanted = np.array(np.broadcast_arrays(np.real(across), np.imag(across), turning, t))[:3]
        strength = np.linalg.norm(wanted, axis=0)
        seen = np.broadcast_to(there.board.points[found.name(first, second)].reshape(3, -1), wanted.shape)
        seen = seen / np.linalg.norm(seen, axis=0)
        definite = np.broadcast_to(exact.condition > 1e-5, t.shape)  # at a change point Kennedy says nothing
        clear = drawn & definite & np.isfinite(strength) & (np.nan_to_num(strength) > 1e-3 * pace)
        assert np.isfinite(seen[:, clear]).all(), (first, second)
        apart = np.linalg.norm(np.cross(seen[:, clear], (wanted / np.fmax(strength, 1e-300))[:, clear], axis=0), axis=0)
        assert np.all(apart < 1e-8), (first, second, float(apart.max()))


def radii(curve: np.ndarray) -> tuple[complex, float]:
    """The circle through a curve that is one: its centre and radius, by least squares; asserts that it is one."""
    rows = np.stack([curve.real, curve.imag, np.ones(curve.size)], axis=1)
    x, y, rest = np.linalg.lstsq(rows, np.abs(curve) ** 2, rcond=None)[0]
    centre = complex(x, y) / 2
    radius = float(np.sqrt(rest + abs(centre) ** 2))
    assert np.all(np.abs(np.abs(curve - centre) - radius) < 1e-9 * radius)
    return centre, radius


def test_cardan_circles():
    """The trammel's link of 400 mm rolls with a circle of radius 200 inside one of 400 mm."""
    curves = rolled("s4-ex3", "1", "0")
    (piece,) = curves.pieces
    assert radii(piece.places[0])[1] == pytest.approx(0.4, rel=1e-9)
    assert radii(piece.places[1])[1] == pytest.approx(0.2, rel=1e-9)


@pytest.mark.parametrize(("first", "second", "radius", "other"), [("2", "3", 0.02, 0.07), ("1", "2", 0.03, 0.02)])
def test_centrodes_of_gears_are_their_pitch_circles(first: str, second: str, radius: float, other: float):
    curves = rolled("s4-ex4", first, second)
    (piece,) = curves.pieces
    assert radii(piece.places[1])[1] == pytest.approx(radius, rel=1e-9)
    assert radii(piece.places[0])[1] == pytest.approx(other, rel=1e-9)


def test_a_hinge_is_a_point_and_a_slide_has_none():
    assert rolled("fig3-4", "2", "3").is_point
    assert not rolled("fig3-4", "2", "4").is_point
    found, drive = moved(library.load("ex3-7"))
    for links in (("2", "3"), ("3", "3")):
        with pytest.raises(NoCentrode):
            centrodes(found, *links, drive)
    with pytest.raises(UnknownLink):
        centrodes(found, "3", "x", drive)
    with pytest.raises(UnknownCentre):
        path(found, "P99", drive)


def test_cut_at_infinity_and_closed():
    """The crank-rocker's coupler turns parallel twice: two pieces, none with a jump; crank and rocker close."""
    curves = rolled("fig3-4", "3", "1")
    size = curves.found.board.size
    assert len(curves.pieces) == 2
    for piece in curves.pieces:
        assert np.max(np.abs(np.diff(piece.places[0]))) < 2 * size
        ends = np.abs(piece.places[0][[0, -1]])
        assert np.all(ends > 15 * size)
        assert not piece.closed
    assert [piece.closed for piece in rolled("fig3-4", "2", "4").pieces] == [True]


def test_path_of_the_suspension_pole():
    """Figure 3-10: the path holds the drawn position's centre, and each place is where AB and DC meet."""
    found, drive = moved(library.load("fig3-10"))
    curves = path(found, "P13", drive, whole(drive))
    assert curves.axes == (FRAME,)
    places = np.concatenate(curves.fixed)
    assert np.min(np.abs(places - complex(found.place(FRAME, "3")))) < 0.05
    for piece in curves.pieces:
        position = over(found, drive.path, piece.t).plot.position
        for one, other in (("A", "B"), ("D", "C")):
            arm, away = position[other] - position[one], piece.places[0] - position[one]
            assert np.all(np.abs(np.imag(np.conj(arm) * away)) < 1e-9 * np.abs(arm) * (0.1 + np.abs(away)))


def test_class_three_far_from_the_drawn_position():
    """A triad, whose poles come from velocities at some positions."""
    found, drive = moved(triad(1))
    for curves in all_of(found, drive)[:5]:
        hold_rolling(curves)


# --- sheets -----------------------------------------------------------------------------------

SHEETS = [("fig3-6", "3", "1"), ("fig3-4", "3", "1"), ("s4-ex3", "1", "0"), ("s4-ex4", "2", "3"), ("ex3-7", "2", "4")]


@pytest.mark.parametrize(("name", "first", "second"), SHEETS)
@pytest.mark.parametrize("lang", ["en", "zh"])
def test_sheets(name: str, first: str, second: str, lang: str):
    sheet = centrode_sheet(rolled(name, first, second), lang=lang)  # type: ignore[arg-type]
    text = svg(sheet)
    assert ("定瞬心线" if lang == "zh" else "fixed centrode") in text or second not in ("0", "1", "3")
    edge = sheet.paper.margin - 1e-6
    for mark in sheet.marks:
        if isinstance(mark, Stroke):
            for place in mark.places:
                assert edge <= place.real <= sheet.paper.width - edge
                assert edge <= place.imag <= sheet.paper.height - edge
    assert text == svg(centrode_sheet(rolled(name, first, second), lang=lang))  # type: ignore[arg-type]


def test_drawn_curves_touch_at_the_centre():
    """Measured on paper: the fixed and the moving curve come to the centre's mark."""
    curves = rolled("fig3-6", "3", "1")
    sheet = centrode_sheet(curves)
    place = sheet.origins["position"] + complex(curves.found.place(FRAME, "3")).conjugate() / sheet.scales["position"]
    for pen in ("visible", "thin"):
        strokes = [mark for mark in sheet.marks if isinstance(mark, Stroke) and mark.pen == pen and len(mark.places) > 20]
        assert strokes
        assert min(_distance(place, stroke.places) for stroke in strokes) < 0.02


def _distance(place: complex, places: tuple[complex, ...]) -> float:
    starts, ends = np.array(places[:-1]), np.array(places[1:])
    drive = ends - starts
    share = np.clip(np.real(np.conj(drive) * (place - starts)) / np.abs(drive) ** 2, 0, 1)
    return float(np.min(np.abs(starts + share * drive - place)))


def test_animation_shows_each_frame_in_its_turn():
    """Played at its moment, each position has the lines of its own sheet, and no others."""
    frames = list(centrode_frames(rolled("fig3-6", "3", "1"), 12))
    text = animation(frames, 6)
    for number in (0, 3, 11):
        played, drawn = still(text, number / 12 + 0.0001), svg(frames[number])
        assert [len(re.findall(f"<(?:svg:)?{kind}\\b", _bare(played))) for kind in ("path", "circle", "line")] == [
            len(re.findall(f"<{kind}\\b", _bare(drawn))) for kind in ("path", "circle", "line")
        ]
    assert len(text) < 12 * len(svg(frames[0])) / 2
    assert re.search(r'dur="6s"', text)


def _bare(text: str) -> str:
    """Without arrow heads, and without what names elements' space."""
    return re.sub(r"<(/?)ns\d+:", r"<\1", re.sub(r"<(\w+:)?marker.*?</(\w+:)?marker>", "", text, flags=re.DOTALL))


def test_infinite_is_what_centring_says():
    """Nothing in a piece is as far off as what counts as infinite."""
    curves = rolled("p3-13", "3", library.load("p3-13").frame)
    for piece in curves.pieces:
        assert np.max(np.abs(piece.places)) < curves.found.board.size / INFINITE


@pytest.mark.many(6)
@pytest.mark.parametrize("name", library.names())
def test_no_slip_by_differences(name: str):
    """The centre goes along both curves with one velocity: each curve's own, by differences over five positions."""
    found, drive = moved(library.load(name))
    size, step = found.board.size, 1e-4
    weights = np.array([1, -8, 0, 8, -1]) / (12 * step)
    for curves in all_of(found, drive):
        for piece in curves.pieces:
            if piece.t[-1] - piece.t[0] < 100 * step:
                continue  # differences would reach beyond it
            t = piece.t[0] + (piece.t[-1] - piece.t[0]) * np.linspace(0.12, 0.88, 9)
            there = over(found, drive.path, (t[:, None] + step * np.arange(-2, 3)).ravel())
            centre = _places(there, curves)
            velocities = []
            for link in curves.axes:
                origin, turn = carried_to(there.plot, link)
                own = np.broadcast_to((centre - origin) / turn, centre.shape).reshape(-1, 5)
                velocities.append(np.broadcast_to(turn, centre.shape).reshape(-1, 5)[:, 2] * (own @ weights))
            near = (np.abs(centre.reshape(-1, 5)) < 3 * size).all(axis=1) & (np.abs(velocities[0]) < 20 * size)
            slip = np.abs(velocities[0] - velocities[1])[near]
            assert np.all(slip < 1e-6 * (size + np.abs(velocities[0][near]))), (curves.name, slip)


def _places(there: Centres, curves: Centrodes) -> np.ndarray:
    count = max(np.size(value) for value in there.plot.facts.values)
    x, y, w = np.broadcast_to(there.board.points[curves.name].reshape(3, -1), (3, count))
    return there.board.origin + there.board.size * (x + 1j * y) / w
PARALLELOGRAM = """
[frame]
A = [0, 0]
D = [100, 0]
[links.1]
AB = 40
[links.2]
BC = 100
[links.3]
DC = 40
[[driver]]
vector = "AB"
angle = 60
omega = 10
[sketch]
C = [120, 35]
"""


def test_centres_of_a_parallelogram_stay_at_infinity_at_its_change_point():
    mechanism = loads(PARALLELOGRAM)
    for by in ("construction", "analysis"):
        table = sweep(mechanism, ["120:240:30"], ["P13", "P20"], by)
        for name in ("P13", "P20"):
            assert not np.isfinite(table[name].vectors).any(), (name, by)


def test_a_sheet_shows_the_centre_of_a_piece_over_the_seam():
    """The drawn position lies on a piece that is joined over the ends of the turn."""
    shown = [mark for mark in centrode_sheet(rolled("fig3-4", "3", "1")).marks if isinstance(mark, Text)]
    assert any("".join(run.text for run in mark.label) == "P13" for mark in shown)
