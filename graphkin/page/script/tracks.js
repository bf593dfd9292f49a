/** Tracks unpacked, as `tracks.py` packs them, and their values at the place where the drivers are. */
import { modulo } from "./numbers.js";
import { cornersOf, isAtKnot, nearestKnot, stencilAt } from "./stencils.js";

/** @import { Knots, Stencil } from "./stencils.js" */
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

/** @param {string | [number, string]} packed @returns {Float64Array} */
function unpackedTrack(packed) {
  const [quantum, text] = typeof packed === "string" ? [QUANTUM, packed] : packed;
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
    this.packed = packed;
    this.masks = masks;
    this.size = axes.reduce((product, axis) => product * axis.u.length, 1);
    /** @type {Float64Array[]} unpacked when they are first asked for, as masks are */
    this.tracks = [];
    /** @type {Uint8Array[]} */
    this.unpackedMasks = [];
    this.us = axes.map((axis) => axis.u[0]);
    /** @type {Record<number, Stencil>} */
    this.stencils = {};
    this.nearest = 0;
    /** @type {number[]} */
    this.corners = [];
  }

  /** @param {number[]} us */
  moveTo(us) {
    this.us = us;
    this.stencils = {};
    this.nearest = nearestKnot(this.axes, us);
    this.corners = cornersOf(this.axes, us);
  }

  /** @param {number | undefined} mask */
  stencil(mask) {
    return (this.stencils[mask ?? -1] ??= stencilAt(this.axes, this.us, mask === undefined ? null : this.mask(mask)));
  }

  /** @param {number} number */
  mask(number) {
    return (this.unpackedMasks[number] ??= unpackedMask(this.masks[number], this.size));
  }

  /** @param {number} number */
  track(number) {
    return (this.tracks[number] ??= unpackedTrack(this.packed[number]));
  }

  /** A number where the drivers are. @param {Changing} changing @param {number} [mask] */
  value(changing, mask) {
    if (typeof changing === "number") return changing;
    const { numbers, weights } = this.stencil(mask);
    const track = this.track(changing[0]);
    return numbers.reduce((sum, number, k) => sum + weights[k] * (track[number] ?? 0), 0);
  }

  /** @param {number} number */
  quantum(number) {
    const packed = this.packed[number];
    return typeof packed === "string" ? QUANTUM : packed[0];
  }

  /** True where the drivers are at a knot, and none of the knots beside it has something. @param {number} mask */
  isAlone(mask) {
    const there = this.mask(mask);
    return isAtKnot(this.axes, this.us) && [-1, 1].every((step) => !there[modulo(this.nearest + step, this.size)]);
  }

  /** True at the knot that is nearest. @param {number | undefined} mask */
  isNear(mask) {
    return mask === undefined || this.mask(mask)[this.nearest] === 1;
  }

  /** True in the cell around, by its first knot. @param {number | null | undefined} cells */
  isInCell(cells) {
    return typeof cells !== "number" || this.mask(cells)[this.corners[0]] === 1;
  }

  /** True at all knots around. @param {number | undefined} mask */
  isAround(mask) {
    return mask === undefined || this.corners.every((number) => this.mask(mask)[number] === 1);
  }
}
