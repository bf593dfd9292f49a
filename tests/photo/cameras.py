"""Phone cameras and scanners: a page's raster becomes a picture file, and where each of its places truly came to lie.

All is seeded. Light is linear where it is mixed; a picture's pixels are as JPEG has them. What a sheet does is no part
of what reads it: paper bends as a cylinder does, without stretching, and a lens bends what a pinhole would show.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import cv2
import numpy as np

Places = np.ndarray
"""Complex: mm from a page's left upper corner, y down; or pixels, the middle of the first one is 0."""

_STEP = 16  # pixels from one place to the next at which a camera's way back is solved; between them it is as good as straight


@dataclass(frozen=True)
class Camera:
    """What a device and the hand that holds it do to a page, at the most; each picture draws its own.

    size    of the picture, broad and high [px]; view: along its longer side [deg]; fill: of it by what lies there
    tilt    from straight above [deg]; roll: from upright [deg], beside quarters of a turn; quarters: of them that occur
    curl    how high the paper rises [mm]; wave: of damp paper, beside it [mm]
    lens    how far its corners are drawn in or out; blur: spread of a point, least and most [px]; moved: by the hand [px]
    shade   least of the light that is left in a shadow, 1 for none; glare: of a lamp's reflection, as part of white
    lamp    by how much light varies over the picture; noise: of white, as part of it; quality: of the JPEG
    """

    size: tuple[int, int] = (4032, 3024)
    view: float = 65.0
    fill: float = 0.93
    tilt: float = 15.0
    roll: float = 6.0
    quarters: tuple[int, ...] = (1, 3)
    curl: float = 3.0
    wave: float = 0.0
    lens: float = 0.02
    blur: tuple[float, float] = (0.6, 1.1)
    moved: float = 0.0
    shade: float = 0.6
    glare: float = 0.0
    lamp: float = 0.3
    noise: float = 0.012
    quality: tuple[int, int] = (80, 95)


@dataclass(frozen=True)
class Scanner:
    """A flat bed: resolution [dots an inch], how far a page lies turned at the most [deg], how unevenly the carriage goes [mm]."""

    dpi: float = 300.0
    turned: float = 1.5
    quarters: tuple[int, ...] = (0, 2)
    stretch: float = 0.002
    uneven: float = 0.02
    blur: tuple[float, float] = (0.5, 0.8)
    noise: float = 0.008
    quality: tuple[int, int] = (75, 95)


PHONE = Camera()
SCANNER = Scanner()
CAMERAS: dict[str, Camera | Scanner] = {
    "phone": PHONE,
    "flat": replace(PHONE, curl=0.3, tilt=8.0),
    "tilted": replace(PHONE, tilt=28.0, roll=15.0),
    "dim": replace(PHONE, noise=0.03, blur=(0.9, 1.5), lamp=0.5, shade=0.4, quality=(60, 80)),
    "level": replace(PHONE, quarters=(0, 2), fill=0.98, tilt=8.0),
    "scanner": SCANNER,
}
ASIDE: dict[str, Camera | Scanner] = {
    "wide": replace(PHONE, view=82.0, lens=0.05, tilt=20.0, size=(4624, 3468)),
    "damp": replace(PHONE, wave=0.4, curl=2.0, moved=1.5, shade=0.5),
    "tablet": replace(PHONE, size=(4000, 3000), view=58.0, lens=-0.015, blur=(0.9, 1.3), quality=(70, 85), lamp=0.45),
    "copier": Scanner(dpi=300.0, turned=3.0, stretch=0.006, uneven=0.05, blur=(0.7, 1.0), quality=(50, 70)),
    "fine": Scanner(dpi=600.0),
}
"""What the reader of photographs was not tuned on."""


@dataclass(frozen=True)
class LaidSheet:
    """A page on the table: its raster, per mm; its middle, and by how much it is turned [mm, rad]."""

    page: np.ndarray
    per_mm: float
    at: complex = 0j
    turned: float = 0.0

    @property
    def size(self) -> complex:
        high, wide = self.page.shape
        return complex(wide, high) / self.per_mm

    @property
    def corners(self) -> list[complex]:
        """Where they lie on the table, if it lies flat [mm]."""
        half = self.size / 2
        return [self.at + each * np.exp(1j * self.turned) for each in (-half, half.conjugate(), half, -half.conjugate())]


@dataclass(frozen=True)
class Photograph:
    """A picture file, its pixels before they are packed, and by sheet where places of the page are in it."""

    content: bytes
    grey: np.ndarray
    true: Sequence[Callable[[Places], Places]] = field(repr=False)


def photograph(page: np.ndarray, per_mm: float, camera: Camera | Scanner, seed: int) -> Photograph:
    """One page as a device takes it."""
    return taken([LaidSheet(page, per_mm)], camera, seed)


def taken(sheets: Sequence[LaidSheet], camera: Camera | Scanner, seed: int) -> Photograph:
    """All that lies there on one picture."""
    rng = np.random.default_rng(seed)
    if isinstance(camera, Scanner):
        return _scanned(sheets[0], camera, rng)
    eye = _eye(sheets, camera, rng)
    true = [_on_picture(sheet, _bend(sheet, camera, rng), eye) for sheet in sheets]
    wide, high = camera.size
    light = _table(rng, wide, high)
    for sheet, forward in zip(sheets, true):
        _paint(light, sheet, _back(forward, sheet, wide, high))
    light *= _lit(camera, rng, wide, high)
    if camera.glare:
        light += camera.glare * rng.uniform(0.5, 1.0) * _spot(rng, wide, high, 0.12)
    if camera.moved:
        light = _smeared(light, rng.uniform(0.3, 1.0) * camera.moved, rng.uniform(0, np.pi))
    return _developed(light, camera, rng, true)


def lasered(page: np.ndarray, per_mm: float, lines: float = 4.2) -> np.ndarray:
    """A page as a laser prints it: what is grey becomes black spots, some lines of them a mm across the page at 45 deg."""
    y, x = (np.arange(n, dtype=np.float32) / per_mm for n in page.shape)
    u, v = (2 * np.pi * lines * np.sqrt(0.5, dtype=np.float32) * np.float32(s) * part for s, part in ((1, x), (1, y)))
    both = np.cos(u)[None, :] * np.cos(v)[:, None]  # spots in the middles of squares that stand on their corners
    order = np.sort(both[:: 7, :: 7].ravel())
    dark = 1 - (np.arange(256) / 255.0) ** 2.2
    least = np.append(order, 2.0)[np.clip(((1 - dark) * order.size).astype(int), 0, order.size)].astype(np.float32)
    least[0] = -2.0
    return np.where(both >= least[page], 0, 255).astype(np.uint8)


def _eye(sheets: Sequence[LaidSheet], camera: Camera, rng: np.random.Generator) -> Callable[[np.ndarray], Places]:
    """Table to pixels: points (.., 3), z towards the camera [mm]; so far off that all sheets just fill the picture."""
    wide, high = camera.size
    focal = max(wide, high) / 2 / np.tan(np.radians(camera.view / 2))
    tilt, around = np.radians(rng.uniform(0, camera.tilt)), rng.uniform(0, 2 * np.pi)
    roll = np.pi / 2 * rng.choice(camera.quarters) + np.radians(rng.uniform(-camera.roll, camera.roll))
    lean = np.array([[np.cos(around), -np.sin(around), 0], [np.sin(around), np.cos(around), 0], [0, 0, 1]])
    tip = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    turn = np.array([[np.cos(roll), -np.sin(roll), 0], [np.sin(roll), np.cos(roll), 0], [0, 0, 1]])
    rotation = turn @ lean @ tip @ lean.T
    bent, shift = rng.uniform(-1, 1) * camera.lens, 0j
    flat = np.array([[c.real, c.imag, 0.0] for sheet in sheets for c in sheet.corners])

    def seen(points: np.ndarray, far: float) -> Places:
        own = points @ rotation.T
        ray = (own[..., 0] + 1j * own[..., 1]) / (far - own[..., 2])
        out = np.abs(ray) ** 2 / (abs(complex(wide, high)) / 2 / focal) ** 2
        return focal * ray * (1 + bent * out * (1 + 0.2 * out))

    far = 600.0
    for _ in range(30):
        px = seen(flat, far)
        far *= max(np.ptp(px.real) / (wide * camera.fill), np.ptp(px.imag) / (high * camera.fill))
    px = seen(flat, far)
    shift = complex(wide - 1, high - 1) / 2 - complex(px.real.min() + px.real.max(), px.imag.min() + px.imag.max()) / 2
    return lambda points: seen(points, far) + shift


def _bend(sheet: LaidSheet, camera: Camera, rng: np.random.Generator) -> Callable[[Places], np.ndarray]:
    """A page's places, from its middle, to where they lie in space (.., 3); its length is kept along the bend."""
    across = rng.choice([0.0, np.pi / 2]) + rng.normal(0, 0.25)
    long = abs(sheet.size)
    rise, arch, phase = rng.uniform(0.3, 1.0) * camera.curl, rng.uniform(0, 1), rng.uniform(-1, 1)
    u = np.arange(-long, long, 0.05)
    s = np.clip(2 * u / long, -1.3, 1.3)
    z = arch * (s + 0.3 * phase) ** 2 + (1 - arch) * np.cos(np.pi * s + phase) / 2
    inside = np.abs(s) <= 0.75
    z = (z - z[inside].min()) * rise / np.ptp(z[inside])
    along = np.cumsum(np.sqrt(np.maximum(0.0, 1 - np.gradient(z, u) ** 2))) * 0.05
    along -= np.interp(0.0, u, along)
    wave, ways = rng.uniform(0.5, 1.0) * camera.wave, rng.uniform(0, 2 * np.pi, 2)

    def bent(q: Places) -> np.ndarray:
        own = q * np.exp(-1j * across)
        flat = (np.interp(own.real, u, along) + 1j * own.imag) * np.exp(1j * across)
        up = np.interp(own.real, u, z) + wave * np.sin(q.real / 12 + ways[0]) * np.sin(q.imag / 15 + ways[1])
        return np.stack([flat.real, flat.imag, up], axis=-1)

    return bent


def _on_picture(
    sheet: LaidSheet, bent: Callable[[Places], np.ndarray], eye: Callable[[np.ndarray], Places]
) -> Callable[[Places], Places]:
    turn = np.array([[np.cos(sheet.turned), -np.sin(sheet.turned), 0], [np.sin(sheet.turned), np.cos(sheet.turned), 0], [0, 0, 1]])
    offset = np.array([sheet.at.real, sheet.at.imag, 0.0])
    return lambda places: eye(bent(np.asarray(places) - sheet.size / 2) @ turn.T + offset)


def _back(forward: Callable[[Places], Places], sheet: LaidSheet, wide: int, high: int) -> Places:
    """By pixel the place of the page, solved by Newton's way at one of many."""
    x, y = (np.arange(-1, n // _STEP + 2) + 0.5 for n in (wide, high))
    px = (x[None, :] + 1j * y[:, None]) * _STEP - (0.5 + 0.5j)
    middle = sheet.size / 2
    least, most = -0.2 * sheet.size, 1.2 * sheet.size
    place = np.full(px.shape, middle)
    for _ in range(8):
        at = forward(place)
        right, down = forward(place + 1e-3) - at, forward(place + 1e-3j) - at
        off, det = 1e-3 * (px - at), (right.conj() * down).imag
        place = place + (off.real * down.imag - off.imag * down.real + 1j * (right.real * off.imag - right.imag * off.real)) / det
        place = np.clip(place.real, least.real, most.real) + 1j * np.clip(place.imag, least.imag, most.imag)
    full = [cv2.resize(part.astype(np.float32), None, fx=_STEP, fy=_STEP, interpolation=cv2.INTER_LINEAR)[_STEP:, _STEP:][:high, :wide]
            for part in (place.real, place.imag)]
    return np.stack(full)


def _paint(light: np.ndarray, sheet: LaidSheet, back: np.ndarray) -> None:
    """A page over what lies there already."""
    x, y = back
    inside = (x > 0) & (y > 0) & (x < sheet.size.real) & (y < sheet.size.imag)
    fine = sheet.per_mm * float(np.median(np.hypot(np.diff(x[::64, ::64]) / 64, np.diff(y[::64, ::64]) / 64)))  # page's pixels a pixel
    linear = (np.arange(256) / 255.0) ** 2.2
    page = cv2.GaussianBlur(linear.astype(np.float32)[sheet.page], (0, 0), max(0.3, 0.35 * fine))
    shown = cv2.remap(page, x * np.float32(sheet.per_mm) - 0.5, y * np.float32(sheet.per_mm) - 0.5, cv2.INTER_LINEAR)
    light[inside] = shown[inside]


def _table(rng: np.random.Generator, wide: int, high: int) -> np.ndarray:
    """Wood or cloth or a light top: uneven in streaks."""
    rough = cv2.resize(rng.normal(0, 1, (high // 32, wide // 320)).astype(np.float32), (wide, high))
    return np.clip(rng.uniform(0.05, 0.6) * (1 + 0.15 * rough), 0.01, 1).astype(np.float32)


def _spot(rng: np.random.Generator, wide: int, high: int, spread: float) -> np.ndarray:
    x, y = np.arange(wide, dtype=np.float32) / wide, np.arange(high, dtype=np.float32) / high
    at = rng.uniform(0.2, 0.8, 2)
    return np.exp(-((x[None, :] - at[0]) ** 2 + (y[:, None] - at[1]) ** 2) / (2 * spread**2)).astype(np.float32)


def _lit(camera: Camera, rng: np.random.Generator, wide: int, high: int) -> np.ndarray:
    """Light over the picture: a lamp to one side, corners darker, and a shadow with a soft edge."""
    light = 1 - camera.lamp * rng.uniform(0.3, 1.0) * (1 - _spot(rng, wide, high, 0.5))
    if camera.shade < 1:
        at, along = rng.uniform(0.2, 0.8, 2) * (wide, high), rng.uniform(0, 2 * np.pi)
        shadow = np.zeros((high // 8, wide // 8), np.float32)
        far = max(wide, high) / 8
        ends = [at / 8 + far * np.array([np.cos(along + a), np.sin(along + a)]) for a in (-0.6, 0.6)]
        cv2.fillPoly(shadow, [np.array([at / 8, *ends]).astype(np.int32)], 1.0)
        shadow = cv2.GaussianBlur(shadow, (0, 0), rng.uniform(2, 12))
        light = light * (1 - rng.uniform(0.3, 1.0) * (1 - camera.shade) * cv2.resize(shadow, (wide, high)))
    return light.astype(np.float32)


def _smeared(light: np.ndarray, length: float, along: float) -> np.ndarray:
    size = 2 * int(np.ceil(length)) + 3
    kernel = np.zeros((size, size), np.float32)
    for t in np.linspace(-length / 2, length / 2, 41):
        x, y = size // 2 + t * np.cos(along), size // 2 + t * np.sin(along)
        i, j = int(x), int(y)
        for a, b in ((0, 0), (0, 1), (1, 0), (1, 1)):
            kernel[j + b, i + a] += (1 - abs(x - i - a)) * (1 - abs(y - j - b))
    return cv2.filter2D(light, -1, kernel / kernel.sum())


def _developed(
    light: np.ndarray, device: Camera | Scanner, rng: np.random.Generator, true: Sequence[Callable[[Places], Places]]
) -> Photograph:
    """Blurred by the lens, with noise, as bright as a picture is, packed."""
    light = cv2.GaussianBlur(light, (0, 0), rng.uniform(*device.blur))
    white = np.quantile(light[::16, ::16], 0.97) / rng.uniform(0.75, 0.95)
    light = light / np.float32(white)
    spread = np.sqrt(np.maximum(light, 0.02)) * np.float32(device.noise)
    light = light + spread * rng.standard_normal(light.shape, dtype=np.float32)
    grey = (np.clip(light, 0, 1) ** (1 / 2.2) * 255 + 0.5).astype(np.uint8)
    content = cv2.imencode(".jpg", grey, [cv2.IMWRITE_JPEG_QUALITY, int(rng.integers(*device.quality))])[1].tobytes()
    return Photograph(content, grey, true)


def _scanned(sheet: LaidSheet, scanner: Scanner, rng: np.random.Generator) -> Photograph:
    fine = scanner.dpi / 25.4
    angle = np.pi / 2 * rng.choice(scanner.quarters) + np.radians(rng.uniform(-1, 1) * scanner.turned)
    wide, high = (round(n * fine) for n in (sheet.size.real, sheet.size.imag))
    stretch, uneven, phase = rng.uniform(-1, 1) * scanner.stretch, rng.uniform(0.3, 1) * scanner.uneven, rng.uniform(0, 6)
    offset = complex(*rng.uniform(-2, 2, 2))

    def forward(places: Places) -> Places:
        q = (np.asarray(places) - sheet.size / 2) * np.exp(1j * angle) + sheet.size / 2 + offset
        down = q.imag * (1 + stretch) + uneven * np.sin(q.imag / 9 + phase)
        return (q.real + 1j * down) * fine - (0.5 + 0.5j)

    light = np.full((high, wide), 0.9, np.float32)
    _paint(light, sheet, _back(forward, sheet, wide, high))
    return _developed(light, scanner, rng, [forward])
