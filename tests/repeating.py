"""Mechanisms with redundant constraints (虚约束), each kind at random: any size, place, direction and order of pairs.

A maker takes a random number generator and `off`: 0 for constraints that repeat each other, else by how much one of
them misses that, in mm or deg.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Iterable
from itertools import pairwise

Maker = Callable[[random.Random, float], str]


class Board:
    """The paper: turned and shifted at random."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.deg = rng.uniform(-180, 180)
        self.shift = complex(rng.uniform(-100, 100), rng.uniform(-100, 100))

    def at(self, z: complex) -> str:
        z = self.shift + z * cmath.rect(1, math.radians(self.deg))
        return f"[{z.real!r}, {z.imag!r}]"

    def angle(self, deg: float) -> str:
        return repr((deg + self.deg + 180) % 360 - 180)

    def sketch(self, **points: complex) -> str:
        return "[sketch]\n" + "".join(f"{p} = {self.at(z + self.noise())}\n" for p, z in points.items())

    def noise(self) -> complex:
        return complex(self.rng.uniform(-1, 1), self.rng.uniform(-1, 1)) * 0.3


def shuffled(rng: random.Random, tables: Iterable[str]) -> str:
    tables = list(tables)
    rng.shuffle(tables)
    return "".join(tables)


def table_on_guides(rng: random.Random, off: float) -> str:
    """A crank and rod push a table that runs on two parallel guides; off [deg]: they are not parallel."""
    b, crank, rod, wide = Board(rng), rng.uniform(20, 40), rng.uniform(90, 140), rng.uniform(40, 90)
    phi, back = rng.uniform(20, 160), rng.choice((0, 180))
    a = cmath.rect(crank, math.radians(phi))
    x = a.real + math.sqrt(rod**2 - a.imag**2)
    low = f'[[slide]]\nname = "low"\nblock = "3"\npoint = "B"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(0)}\ntilt = 90\n'
    through = b.at(complex(rng.uniform(-20, 20), wide))
    if rng.random() < 0.5:
        place = b.at(complex(x, wide)) if off else through
        high = f'[[slide]]\nname = "high"\npin = "C"\nguide = "frame"\nthrough = {place}\nangle = {b.angle(back + off)}\n'
    else:
        high = f'[[slide]]\nname = "high"\nblock = "3"\npoint = "C"\nguide = "frame"\nthrough = {through}\nangle = {b.angle(back)}\ntilt = {90 - back + off}\n'
    return f"""[frame]
O = {b.at(0)}
[links.1]
OA = {crank!r}
[links.2]
AB = {rod!r}
[links.3]
shape = {{ B = [0, 0], C = [0, {wide!r}], D = [30, {wide!r}] }}
{shuffled(rng, (low, high)) if not off else low + high}[[driver]]
vector = "OA"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
{b.sketch(A=a, B=x, C=complex(x, wide))}"""


def wheel_between_plates(rng: random.Random, off: float) -> str:
    """A wheel between two plates in guides of their own, both driven, or one fixed; off [mm]: the gap is not 2 r."""
    b, r, c = Board(rng), rng.uniform(20, 60), rng.uniform(-40, 40)
    one, other = rng.uniform(-200, -100), rng.uniform(-200, -100)
    name = rng.choice(('name = "contact"\n', ""))
    upper = f"""[[roll]]
wheel = "3"
centre = "C"
radius = {r!r}
on = "2"
through = "E"
toward = "F"
side = "right"
"""
    lower = f'[[roll]]\n{name}wheel = "3"\ncentre = "C"\nradius = {r!r}\non = "1"\nthrough = "D"\ntoward = "G"\n'
    guides = [
        f'[[slide]]\nname = "low"\nblock = "1"\npoint = "D"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(0)}\ntilt = 0\n',
        f'[[slide]]\nname = "high"\nblock = "2"\npoint = "E"\nguide = "frame"\nthrough = {b.at(1j * (2 * r + off))}\nangle = {b.angle(0)}\ntilt = 0\n',
    ]
    drivers = "".join(
        f'[[driver]]\nslide = "{slide}"\nat = {at!r}\nvelocity = {rng.uniform(-1, 1)!r}\nacceleration = {rng.uniform(-3, 3)!r}\n'
        for slide, at in (("low", one), ("high", other))
    )
    pose = f'[[pose]]\nslide = "contact"\nat = {c - one!r}\n' if name else f'[[pose]]\nslide = "there"\nat = {c - one!r}\n'
    lower = lower if name else lower.replace("wheel =", 'name = "there"\nwheel =', 1)
    return f"""[frame]
O = {b.at(0)}
[links.1]
DG = 300
[links.2]
EF = 300
[links.3]
CP = {rng.uniform(0.2, 1) * r!r}
{shuffled(rng, [*guides, upper, lower])}{drivers}{pose}[[pose]]
vector = "CP"
angle = {rng.uniform(-180, 180)!r}
{b.sketch(D=one, G=one + 300, E=complex(other, 2 * r), F=complex(other + 300, 2 * r), C=complex(c, r))}"""


def wheel_between_racks(rng: random.Random, off: float) -> str:
    """A crank and rod roll a wheel on a fixed rack, and it moves another rack in a guide; off [mm]: in the gap."""
    b, crank, rod, r, big = Board(rng), rng.uniform(20, 40), rng.uniform(120, 160), rng.uniform(15, 30), rng.uniform(15, 40)
    phi, m = rng.uniform(0, 360), rng.uniform(-60, 0)
    a = cmath.rect(crank, math.radians(phi))
    x = a.real + math.sqrt(rod**2 - (a.imag - r) ** 2)
    return f"""[frame]
O = {b.at(0)}
[links.1]
OA = {crank!r}
[links.2]
AC = {rod!r}
[links.wheel]
shape = {{ C = [0, 0], P = [{r!r}, 0] }}
[links.rack]
MN = 300
{shuffled(rng, [
    f'''[[roll]]
wheel = "wheel"
centre = "C"
radius = {r!r}
on = "frame"
through = "O"
angle = {b.angle(0)}
''',
    f'''[[roll]]
wheel = "wheel"
centre = "C"
radius = {big!r}
on = "rack"
through = "M"
toward = "N"
side = "right"
''',
    f'''[[slide]]
name = "g"
block = "rack"
point = "M"
guide = "frame"
through = {b.at(1j * (r + big + off))}
angle = {b.angle(0)}
tilt = 0
'''])}[[driver]]
vector = "OA"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
[[pose]]
vector = "CP"
angle = {rng.uniform(-180, 180)!r}
[[pose]]
slide = "g"
at = {m!r}
{b.sketch(A=a, C=complex(x, r), M=complex(m, r + big))}"""


def wheel_on_belt(rng: random.Random, off: float) -> str:
    """A wheel on a moving belt, its centre in a guide of the frame; off [deg]: the guide is not parallel to the belt."""
    b, r, s, c = Board(rng), rng.uniform(20, 50), rng.uniform(-200, -100), rng.uniform(-30, 30)
    name = rng.choice(("", 'name = "contact"\n'))
    kind = 'block = "4"\npoint = "C"\n' if rng.random() < 0.5 else 'pin = "C"\n'
    carrier = '[links.4]\npoints = ["C"]\n' if "block" in kind else ""
    pairs = [
        f'[[slide]]\nname = "belt"\nblock = "1"\npoint = "D"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(0)}\ntilt = 0\n',
        f'[[slide]]\nname = "guide"\n{kind}guide = "frame"\nthrough = {b.at(complex(c, r))}\nangle = {b.angle(off)}\n',
        f'[[roll]]\n{name}wheel = "3"\ncentre = "C"\nradius = {r!r}\non = "1"\nthrough = "D"\ntoward = "G"\n',
    ]
    drivers = "".join(
        f'[[driver]]\nslide = "{slide}"\nat = {at!r}\nvelocity = {rng.uniform(-1, 1)!r}\nacceleration = {rng.uniform(-3, 3)!r}\n'
        for slide, at in (("belt", s), ("guide", 0.0))
    )
    return f"""[frame]
O = {b.at(0)}
[links.1]
DG = 300
[links.3]
CP = {rng.uniform(0.2, 1) * r!r}
{carrier}{shuffled(rng, pairs)}{drivers}[[pose]]
vector = "CP"
angle = {rng.uniform(-180, 180)!r}
{b.sketch(D=s, G=s + 300, C=complex(c, r))}"""


def carriage(rng: random.Random, off: float) -> str:
    """A carriage on four wheels, drawn by a crank and rod; off [mm]: the last wheel is too small."""
    b, crank, rod, r = Board(rng), rng.uniform(20, 40), rng.uniform(120, 160), rng.uniform(10, 20)
    phi = rng.uniform(0, 360)
    a = cmath.rect(crank, math.radians(phi))
    x = a.real + math.sqrt(rod**2 - (a.imag - r) ** 2)
    places = [0.0, *sorted(rng.uniform(30, 200) for _ in range(3))]
    while min(q - p for p, q in pairwise(places)) < 15:
        places = [0.0, *sorted(rng.uniform(30, 200) for _ in range(3))]
    axles = "ABCD"
    shape = ", ".join(f"{w}1 = [{p!r}, 0]" for w, p in zip(axles, places, strict=True))
    wheels = "".join(f'[links.w{w}]\n{w}1{w}2 = {r!r}\n' for w in axles)
    rolls = [
        f'[[roll]]\nwheel = "w{w}"\ncentre = "{w}1"\nradius = {r - (off if w == "D" else 0)!r}\non = "frame"\nthrough = "O"\nangle = {b.angle(0)}\n'
        for w in axles
    ]
    poses = "".join(f'[[pose]]\nvector = "{w}1{w}2"\nangle = {rng.uniform(-180, 180)!r}\n' for w in axles)
    return f"""[frame]
O = {b.at(0)}
[links.1]
OK = {crank!r}
[links.2]
KA1 = {rod!r}
[links.3]
shape = {{ {shape} }}
{wheels}{shuffled(rng, rolls) if not off else "".join(rolls)}[[driver]]
vector = "OK"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
{poses}{b.sketch(K=a, **{f"{w}1": complex(x + p, r) for w, p in zip(axles, places, strict=True)})}"""


def cardan_wheel(rng: random.Random, off: float) -> str:
    """A wheel in a ring of twice its size, a rim point in a guide through the centre; off [mm]: beside it."""
    b, r, phi, guide = Board(rng), rng.uniform(20, 60), rng.uniform(0, 360), rng.uniform(0, 360)
    while abs(math.cos(math.radians(phi - guide))) < 0.2 or abs(math.sin(math.radians(phi - guide))) < 0.2:
        phi = rng.uniform(0, 360)
    along = cmath.rect(1, math.radians(guide))
    c = cmath.rect(r, math.radians(phi))
    p = 2 * (c * along.conjugate()).real * along
    pairs = [
        f'[[gear]]\nlinks = ["wheel", "frame"]\ncentres = ["C", "O"]\nradii = [{r!r}, {2 * r!r}]\ninternal = true\n',
        f'[[slide]]\nname = "g"\npin = "P"\nguide = "frame"\nthrough = {b.at(off * 1j * along)}\nangle = {b.angle(guide)}\n',
    ]
    return f"""[frame]
O = {b.at(0)}
[links.arm]
OC = {r!r}
[links.wheel]
CP = {r!r}
{shuffled(rng, pairs) if not off else "".join(pairs)}[[driver]]
vector = "OC"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
{b.sketch(C=c, P=p)}"""


def twin_cams(rng: random.Random, off: float) -> str:
    """Two equal eccentrics, geared 1:1, under one flat face; off [mm]: one is larger."""
    b, half, e, r, phi = Board(rng), rng.uniform(40, 70), rng.uniform(5, 20), rng.uniform(25, 35), rng.uniform(0, 360)
    one, other = cmath.rect(e, math.radians(phi)), cmath.rect(e, math.radians(180 - phi))
    y = one.imag + r
    cams = [
        f'[[cam]]\nlinks = ["{link}", "3"]\nprofiles = [{{ centre = "{point}", radius = {r + more!r} }}, {{ through = "E", toward = "F", side = "right" }}]\n'
        for link, point, more in (("1", "A", 0.0), ("2", "B", off))
    ]
    pairs = [
        *cams,
        f'[[gear]]\nlinks = ["1", "2"]\ncentres = ["O", "Q"]\nradii = [{half!r}, {half!r}]\n',
        f'[[slide]]\nname = "follower"\nblock = "3"\npoint = "E"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(90)}\ntilt = -90\n',
    ]
    return f"""[frame]
O = {b.at(-half)}
Q = {b.at(half)}
[links.1]
OA = {e!r}
[links.2]
QB = {e!r}
[links.3]
EF = {2 * half!r}
{shuffled(rng, pairs)}[[driver]]
vector = "OA"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
[[pose]]
vector = "QB"
angle = {b.angle(180 - phi)}
{b.sketch(A=-half + one, B=half + other, E=complex(-half, y), F=complex(half, y))}"""


def breadth_cam(rng: random.Random, off: float) -> str:
    """An eccentric between two parallel faces of its follower (等宽凸轮); off [mm]: they are too far apart."""
    b, e, r, phi = Board(rng), rng.uniform(5, 20), rng.uniform(25, 35), rng.uniform(0, 360)
    a = cmath.rect(e, math.radians(phi))
    cam = '[[cam]]\nlinks = ["1", "2"]\nprofiles = [{ centre = "A", radius = %r }, { through = "%s", toward = "%s", side = "%s" }]\n'
    pairs = [
        cam % (r, "E", "F", "right"),
        cam % (r + off, "G", "H", "left"),
        f'[[slide]]\nname = "follower"\nblock = "2"\npoint = "E"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(90)}\ntilt = -90\n',
    ]
    return f"""[frame]
O = {b.at(0)}
[links.1]
OA = {e!r}
[links.2]
shape = {{ E = [0, 0], F = [80, 0], G = [0, {-2 * r!r}], H = [80, {-2 * r!r}] }}
{shuffled(rng, pairs)}[[driver]]
vector = "OA"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
{b.sketch(A=a, E=complex(0, a.imag + r), F=complex(80, a.imag + r))}"""


def planets(rng: random.Random, off: float) -> str:
    """Sun, fixed ring and two or three equal planets on one arm; off is not used: any tooth may be in any gap."""
    b, sun, planet, count = Board(rng), rng.uniform(10, 30), rng.uniform(10, 30), rng.choice((2, 3))
    phi = rng.uniform(0, 360)
    arm = ", ".join(
        f"P{k} = [{(sun + planet) * math.cos(2.0 * k)!r}, {(sun + planet) * math.sin(2.0 * k)!r}]" for k in range(1, count + 1)
    )
    wheels = "".join(f'[links.p{k}]\nP{k}Q{k} = {planet!r}\n' for k in range(1, count + 1))
    gears = [
        text
        for k in range(1, count + 1)
        for text in (
            f'[[gear]]\nlinks = ["sun", "p{k}"]\ncentres = ["O", "P{k}"]\nradii = [{sun!r}, {planet!r}]\n',
            f'[[gear]]\nlinks = ["p{k}", "frame"]\ncentres = ["P{k}", "O"]\nradii = [{planet!r}, {sun + 2 * planet!r}]\ninternal = true\n',
        )
    ]
    poses = "".join(f'[[pose]]\nvector = "P{k}Q{k}"\nangle = {rng.uniform(-180, 180)!r}\n' for k in range(1, count + 1))
    return f"""[frame]
O = {b.at(0)}
[links.arm]
shape = {{ O = [0, 0], {arm} }}
[links.sun]
OS = {sun!r}
{wheels}{shuffled(rng, gears)}[[driver]]
vector = "OS"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
[[pose]]
vector = "OP1"
angle = {rng.uniform(-180, 180)!r}
{poses}"""


def cranks(rng: random.Random, off: float) -> str:
    """A parallelogram with three or four cranks; off [mm]: the last is too long."""
    b, crank, phi, count = Board(rng), rng.uniform(20, 40), rng.uniform(20, 160), rng.choice((3, 4))
    a = cmath.rect(crank, math.radians(phi))
    pivots = [complex(60 * k + rng.uniform(0, 30), rng.uniform(-20, 20)) for k in range(count)]
    frame = "".join(f"O{k} = {b.at(z)}\n" for k, z in enumerate(pivots))
    links = "".join(
        f"[links.{k + 1}]\nO{k}A{k} = {crank + (off if k == count - 1 else 0)!r}\n" for k in range(count)
    )
    shape = ", ".join(f"A{k} = [{(z - pivots[0]).real!r}, {(z - pivots[0]).imag!r}]" for k, z in enumerate(pivots))
    return f"""[frame]
{frame}{links}[links.9]
shape = {{ {shape} }}
[[driver]]
vector = "O0A0"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
{b.sketch(**{f"A{k}": z + a for k, z in enumerate(pivots)})}"""


def trammel(rng: random.Random, off: float) -> str:
    """A rod on two guides at right angles, and a crank to its middle; crank or slide is driven; off [mm]: crank."""
    b, half, phi = Board(rng), rng.uniform(30, 60), rng.choice((0, 90, 180, 270)) + rng.uniform(20, 70)
    c = cmath.rect(half, math.radians(phi))
    guides = [
        f'[[slide]]\nname = "x"\npin = "A"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(0)}\n',
        f'[[slide]]\nname = "y"\npin = "B"\nguide = "frame"\nthrough = "O"\nangle = {b.angle(90)}\n',
    ]
    crank = f'vector = "OC"\nangle = {b.angle(phi)}\nomega = {rng.uniform(-6, 6)!r}\nalpha = {rng.uniform(-6, 6)!r}\n'
    slide = f'slide = "x"\nat = {2 * c.real!r}\nvelocity = {rng.uniform(-1, 1)!r}\nacceleration = {rng.uniform(-3, 3)!r}\n'
    return f"""[frame]
O = {b.at(0)}
[links.1]
OC = {half + off!r}
[links.2]
shape = {{ A = [0, 0], C = [{half!r}, 0], B = [{2 * half!r}, 0] }}
{shuffled(rng, guides)}[[driver]]
{crank if not off and rng.random() < 0.5 else slide}
{b.sketch(A=2 * c.real, B=2j * c.imag, C=c)}"""


def twin_rods(rng: random.Random, off: float) -> str:
    """Two cranks geared to each other as mirror images push a crosshead by a rod each; off [mm]: a rod is longer.

    The one crank's place is left to the sketch, which is rounded, in any unit.
    """
    b, crank, half, rod = Board(rng), rng.uniform(20, 40), rng.uniform(45, 70), rng.uniform(150, 200)
    unit, size = rng.choice((("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("in", 25.4)))
    c = 1j * half + cmath.rect(crank, math.radians(phi := rng.uniform(-80, 80)))
    e, d = c.real + math.sqrt(rod**2 - c.imag**2), c.conjugate()

    def length(value: float) -> str:
        return f'"{value / size!r} {unit}"'

    links = shuffled(rng, (f"[links.1]\nAC = {length(crank)}\n", f"[links.2]\nBD = {length(crank)}\n",
                           f"[links.3]\nCE = {length(rod)}\n", f"[links.4]\nDE = {length(rod + off)}\n"))  # fmt: skip
    turned = ((b.shift + z * cmath.rect(1, math.radians(b.deg))) for z in (c, d, e))
    sketch = "".join(f"{p} = [{round(z.real)}, {round(z.imag)}]\n" for p, z in zip("CDE", turned, strict=True))
    return f"""[frame]
A = {b.at(1j * half)}
B = {b.at(-1j * half)}
{links}[links.5]
points = ["E"]
[[gear]]
links = ["1", "2"]
centres = ["A", "B"]
radii = [{length(half)}, {length(half)}]
[[slide]]
block = "5"
point = "E"
guide = "frame"
through = {b.at(complex(rng.uniform(80, 250), 0))}
angle = {b.angle(rng.choice((0, 180)))}
[[driver]]
vector = "AC"
angle = {b.angle(phi)}
omega = {rng.uniform(-6, 6)!r}
alpha = {rng.uniform(-6, 6)!r}
[sketch]
{sketch}"""


FAMILIES: dict[str, tuple[Maker, float]] = {
    maker.__name__: (maker, off)
    for maker, off in (
        (table_on_guides, 1.0), (wheel_between_plates, 0.1), (wheel_between_racks, 0.1), (wheel_on_belt, 1.0),
        (carriage, 0.1), (cardan_wheel, 0.1), (twin_cams, 0.1), (breadth_cam, 0.1), (planets, 0.0), (cranks, 0.1),
        (trammel, 0.1), (twin_rods, 0.1),
    )
}  # fmt: skip
"""Each maker with an `off` that is to be refused; 0 where there is none."""
