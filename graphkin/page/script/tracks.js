/** Tracks unpacked, as `tracks.py` packs them, and their values at the place where the drivers are: between knots, as
 * `stencils.py` has them, by Lagrange's polynomials through eight along each driver. */
import { modulo, within } from "./numbers.js";

/** @typedef {number | [number]} Changing a number, or the number of a track */

const LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-";
const QUANTUM = 0.001;

/** @param {string} text @returns {number[]} */
function unpacked(text) {
  const whole = [];
  let number = 0;
  let times = 1;
  for (const letter of text) {
    const piece = LETTERS.indexOf(letter);
    number += (piece % 32) * times;
    times *= 32;
    if (piece < 32) {
      whole.push(number % 2 ? -(number - 1) / 2 : number / 2);
      number = 0;
      times = 1;
    }
  }
  return whole;
}

/** @param {[number, string]} packed @returns {Float64Array} */
function unpackedTrack([quantum, text]) {
  const [order = 0, ...whole] = unpacked(text);
  for (let n = 0; n < order; n++) {
    for (let k = 1; k < whole.length; k++) whole[k] += whole[k - 1];
  }
  return Float64Array.from(whole, (number) => number * quantum);
}

/** @param {string} text @param {number} size @returns {Uint8Array} */
function unpackedMask(text, size) {
  const [first = 0, ...lengths] = unpacked(text);
  const mask = new Uint8Array(size);
  let at = 0;
  lengths.forEach((length, k) => {
    const end = at + length + (k ? 0 : 1);
    mask.fill((first + k) % 2, at, end);
    at = end;
  });
  return mask.fill((first + lengths.length) % 2, at);
}

/** The tracks of one mechanism over one set of knots. */
export class Tracks {
  /** @param {Knots[]} axes @param {(string | [number, string])[]} packed @param {string[]} masks */
  constructor(axes, packed, masks) {
    this.axes = axes;
    this.packed = packed.map((each) => /** @type {[number, string]} */ (typeof each === "string" ? [QUANTUM, each] : each));
    this.masks = masks;
    this.size = axes.reduce((product, axis) => product * axis.u.length, 1);
    /** @type {Float64Array[]} unpacked when they are first asked for, as masks are */
    this.tracks = [];
    /** @type {Uint8Array[]} */
    this.unpackedMasks = [];
    this.us = axes.map((axis) => axis.u[0]);
    /** @type {Record<string, Stencil>} */
    this.stencils = {};
    this.nearest = 0;
    this.corners = cornersOf(axes, this.us);
    this.atKnot = true;
  }

  /** @param {number[]} us */
  moveTo(us) {
    this.us = us;
    this.stencils = {};
    this.nearest = nearestKnot(this.axes, us);
    this.corners = cornersOf(this.axes, us);
    this.atKnot = isAtKnot(this.axes, us);
  }

  /** @param {number | undefined} mask @param {number} [most] knots along each driver */
  stencil(mask, most = 8) {
    const there = mask === undefined ? null : this.mask(mask);
    return (this.stencils[`${mask} ${most}`] ??= stencilAt(this.axes, this.us, there, most));
  }

  /** @param {number} number */
  mask(number) {
    return (this.unpackedMasks[number] ??= unpackedMask(this.masks[number], this.size));
  }

  /** @param {number} number */
  track(number) {
    return (this.tracks[number] ??= unpackedTrack(this.packed[number]));
  }

  /** A number where the drivers are; one that begins anew after a turn goes on past it. @param {Changing} changing
   * @param {number} [mask] @param {number} [turn] @param {number} [most] */
  value(changing, mask, turn = 0, most = 8) {
    if (typeof changing === "number") return changing;
    const { numbers, weights } = this.stencil(mask, most);
    const track = this.track(changing[0]);
    const middle = track[numbers[numbers.length >> 1]] ?? 0;
    const near = (/** @type {number} */ value) => (turn ? value + turn * Math.round((middle - value) / turn) : value);
    return numbers.reduce((sum, number, k) => sum + weights[k] * near(track[number] ?? 0), 0);
  }

  /** The same; of a grid what a knot has, between knots NaN where fewer of them, or not those around, say something
   * else: of two kinds, as one may say the same by chance where a size goes down to nothing and up again. @param {Changing} changing @param {number | undefined} mask @param {number} [turn] */
  sure(changing, mask, turn) {
    if (this.axes.length < 2 || typeof changing === "number") return this.value(changing, mask, turn);
    const [number] = changing;
    if (this.atKnot) return this.isNear(mask) ? this.track(number)[this.nearest] : NaN;
    const [whole, aside, less, least] = [8, 7, 6, 4].map((most) => this.value(changing, mask, turn, most));
    const [many, fewer, few] = [8, 6, 4].map((most) => this.stencil(mask, most).numbers);
    const isAmong = many.length > fewer.length && fewer.length > few.length && this.corners.every((knot) => few.includes(knot));
    const off = [aside, less, least].map((other) => Math.max(0, Math.abs(whole - other) - this.packed[number][0]) / Math.abs(whole));
    return isAmong && !(Math.max(off[0], off[1]) > 0.001) && !(off[2] > 0.02) ? whole : NaN;
  }

  /** True where the drivers are at a knot, and none of the knots beside it has something. @param {number} mask */
  isAlone(mask) {
    return this.atKnot && [-1, 1].every((step) => !this.mask(mask)[modulo(this.nearest + step, this.size)]);
  }

  /** True at the knot that is nearest. @param {number | undefined} mask */
  isNear(mask) {
    return mask === undefined || this.mask(mask)[this.nearest] === 1;
  }

  /** True where a plane is shown: at a knot that has it, or between such knots in a cell that shows it, by its first.
   * @param {number | undefined} mask @param {number | null | undefined} cells */
  isShown(mask, cells) {
    if (this.atKnot) return this.isNear(mask);
    return this.isAround(mask) && (typeof cells !== "number" || this.mask(cells)[this.corners[0]] === 1);
  }

  /** True at some knot around. @param {number | undefined} mask */
  isBeside(mask) {
    return mask === undefined || this.corners.some((number) => this.mask(mask)[number] === 1);
  }

  /** True at all knots around. @param {number | undefined} mask */
  isAround(mask) {
    return mask === undefined || this.corners.every((number) => this.mask(mask)[number] === 1);
  }
}

// --- between knots

/** @typedef {{u: number[], period: number}} Knots */
/** @typedef {{numbers: number[], weights: number[]}} Stencil */

/** The last knot that is not beyond u. @param {Knots} knots @param {number} u */
function cellOf({ u: places, period }, u) {
  const beyond = places.findIndex((place) => place > u);
  const cell = (beyond < 0 ? places.length : beyond) - 1;
  return period ? cell : within(cell, 0, places.length - 2);
}

/** The place of a knot, counted on beyond the last. @param {Knots} knots @param {number} number */
function knotAt({ u, period }, number) {
  return u[modulo(number, u.length)] + Math.floor(number / u.length) * period;
}

/** First knots of windows with a knot beside a place, the best first. @param {Knots} knots @param {number} u @param {number} count */
function windowsAbout(knots, u, count) {
  const middle = cellOf(knots, u) - (count >> 1) + 1;
  const firsts = Array.from({ length: count + 1 }, (_, k) => middle + (k % 2 ? -(k + 1) / 2 : k / 2));
  return firsts.filter((first) => knots.period || (first >= 0 && first <= knots.u.length - count));
}

/** @param {Knots} knots @param {number} u @param {number} first @param {number} count */
function weightsOf(knots, u, first, count) {
  const at = Array.from({ length: count }, (_, k) => knotAt(knots, first + k));
  return at.map((own) => at.filter((other) => other !== own)
    .reduce((product, other) => (product * (u - other)) / (own - other), 1));
}

/** All ways to take one of each. @param {number[][]} each @returns {Generator<number[]>} */
function* ways([some, ...others]) {
  for (const one of some ?? []) {
    if (!others.length) yield [one];
    else for (const rest of ways(others)) yield [one, ...rest];
  }
}

/** The knots that give the value at a place, and their weights; where none do, the nearest alone. @param {Knots[]} axes
 * @param {number[]} us @param {Uint8Array | null} mask at which knots it is there @param {number} most knots along each
 * @returns {Stencil} */
function stencilAt(axes, us, mask, most) {
  for (let count = most; count > 0; count -= 2) {
    const counts = axes.map((axis) => Math.min(count, axis.u.length));
    const firsts = axes.map((axis, k) => windowsAbout(axis, us[k], counts[k]));
    for (const window of ways(firsts)) {
      const numbers = numbersOf(axes, window, counts);
      if (mask && numbers.some((number) => !mask[number])) continue;
      const weights = axes.map((axis, k) => weightsOf(axis, us[k], window[k], counts[k]));
      return { numbers, weights: [...ways(weights)].map((each) => each.reduce((product, weight) => product * weight)) };
    }
  }
  return { numbers: [nearestKnot(axes, us)], weights: [1] };
}

/** The numbers of the knots in a window. @param {Knots[]} axes @param {number[]} firsts @param {number[]} counts */
function numbersOf(axes, firsts, counts) {
  const own = axes.map(({ u }, k) => Array.from({ length: counts[k] }, (_, n) => modulo(firsts[k] + n, u.length)));
  return [...ways(own)].map((each) => each.reduce((before, number, k) => before * axes[k].u.length + number));
}

/** @param {Knots} axis @param {number} u */
function nearestOf(axis, u) {
  const cell = cellOf(axis, u);
  return u - knotAt(axis, cell) <= knotAt(axis, cell + 1) - u ? cell : cell + 1;
}

/** @param {Knots[]} axes @param {number[]} us */
function nearestKnot(axes, us) {
  return numbersOf(axes, axes.map((axis, k) => nearestOf(axis, us[k])), axes.map(() => 1))[0];
}

/** @param {Knots[]} axes @param {number[]} us */
function isAtKnot(axes, us) {
  return axes.every((axis, k) => Math.abs(knotAt(axis, nearestOf(axis, us[k])) - us[k]) < 1e-6);
}

/** The knots around a place: it lies among them. @param {Knots[]} axes @param {number[]} us */
function cornersOf(axes, us) {
  return numbersOf(axes, axes.map((axis, k) => cellOf(axis, us[k])), axes.map((axis) => Math.min(2, axis.u.length)));
}
