/** Values between knots, as `stencils.py` has them: Lagrange's polynomials through six knots along each driver. */
import { modulo, within } from "./numbers.js";

/** @typedef {{u: number[], period: number}} Knots */
/** @typedef {{numbers: number[], weights: number[]}} Stencil */

const MOST = 6;

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

/** First knots of windows about a place, the best first. @param {Knots} knots @param {number} u @param {number} count */
function windowsAbout(knots, u, count) {
  const middle = cellOf(knots, u) - (count >> 1) + 1;
  const firsts = Array.from({ length: 2 * count + 1 }, (_, k) => middle + (k % 2 ? -(k + 1) / 2 : k / 2));
  return firsts.filter((first) => knots.period || (first >= 0 && first <= knots.u.length - count));
}

/** @param {Knots} knots @param {number} u @param {number} first @param {number} count */
function weightsOf(knots, u, first, count) {
  const at = Array.from({ length: count }, (_, k) => knotAt(knots, first + k));
  return at.map((own) => at.filter((other) => other !== own)
    .reduce((product, other) => (product * (u - other)) / (own - other), 1));
}

/** All ways to take one of each, joined. @template T, S @param {S[][]} each @param {T} start
 * @param {(before: T, one: S, axis: number) => T} join */
function combined(each, start, join) {
  return each.reduce((all, some, k) => all.flatMap((before) => some.map((one) => join(before, one, k))), [start]);
}

/** The knots that give the value at a place, and their weights; where none do, the nearest alone. @param {Knots[]} axes
 * @param {number[]} us @param {Uint8Array | null} mask at which knots it is there @returns {Stencil} */
export function stencilAt(axes, us, mask) {
  for (const count of [MOST, 4, 2]) {
    const counts = axes.map((axis) => Math.min(count, axis.u.length));
    const firsts = axes.map((axis, k) => windowsAbout(axis, us[k], counts[k]));
    for (const window of combined(firsts, /** @type {number[]} */ ([]), (before, first) => [...before, first])) {
      const numbers = numbersOf(axes, window, counts);
      if (mask && numbers.some((number) => !mask[number])) continue;
      const weights = axes.map((axis, k) => weightsOf(axis, us[k], window[k], counts[k]));
      return { numbers, weights: combined(weights, 1, (before, weight) => before * weight) };
    }
  }
  return { numbers: [nearestKnot(axes, us)], weights: [1] };
}

/** The numbers of the knots in a window. @param {Knots[]} axes @param {number[]} firsts @param {number[]} counts */
function numbersOf(axes, firsts, counts) {
  const own = axes.map(({ u }, k) => Array.from({ length: counts[k] }, (_, n) => modulo(firsts[k] + n, u.length)));
  return combined(own, 0, (before, number, k) => before * axes[k].u.length + number);
}

/** @param {Knots} axis @param {number} u */
function nearestOf(axis, u) {
  const cell = cellOf(axis, u);
  return u - knotAt(axis, cell) <= knotAt(axis, cell + 1) - u ? cell : cell + 1;
}

/** @param {Knots[]} axes @param {number[]} us */
export function nearestKnot(axes, us) {
  return numbersOf(axes, axes.map((axis, k) => nearestOf(axis, us[k])), axes.map(() => 1))[0];
}

/** @param {Knots[]} axes @param {number[]} us */
export function isAtKnot(axes, us) {
  return axes.every((axis, k) => Math.abs(knotAt(axis, nearestOf(axis, us[k])) - us[k]) < 1e-6);
}

/** The knots around a place: it lies among them. @param {Knots[]} axes @param {number[]} us */
export function cornersOf(axes, us) {
  return numbersOf(axes, axes.map((axis, k) => cellOf(axis, us[k])), axes.map((axis) => Math.min(2, axis.u.length)));
}
