/** A driver's value and the parameter along it, as `reach.py` has them. */
import { modulo, within } from "./numbers.js";

/** @import { Axis } from "./state.js" */

/** The parameter of a driver's value, within the knots. @param {Axis} axis @param {number} value */
export function parameterAt(axis, value) {
  const size = axis.high - axis.low;
  if (axis.round) return value - size * Math.floor((value - axis.low) / size);
  const part = within((value - axis.low) / size, 0, 1);
  const u = { line: value, both: Math.acos(1 - 2 * part), low: Math.acos(1 - part), high: Math.asin(part) }[axis.ends];
  return within(u, ...knotEnds(axis));
}

/** @param {Axis} axis @returns {[number, number]} */
export function knotEnds({ u }) {
  return [u[0], u[u.length - 1]];
}

/** @param {Axis} axis @param {number} u */
export function valueAt(axis, u) {
  const size = axis.high - axis.low;
  const part = { both: (1 - Math.cos(u)) / 2, low: 1 - Math.cos(u), high: Math.sin(u) };
  return axis.ends === "line" ? u : axis.low + size * part[axis.ends];
}

/** The ends of what the page shows. @param {Axis} axis @returns {[number, number]} */
export function endsOf(axis) {
  const [low, high] = knotEnds(axis);
  return axis.round ? [axis.low, axis.high] : [valueAt(axis, low), valueAt(axis, high)];
}

/** A value on the driver's way: round and round, or between its ends. @param {Axis} axis @param {number} value */
export function onTheWay(axis, value) {
  const [low, high] = endsOf(axis);
  const turn = 2 * Math.PI;
  if (axis.unit !== "°") return within(value, low, high);
  if (axis.high - axis.low > turn - 1e-9) {
    const inTurn = axis.low + modulo(value - axis.low, turn);
    return axis.round ? inTurn : within(inTurn, low, high);
  }
  const shifted = value + turn * Math.round(((low + high) / 2 - value) / turn);
  return within(shifted >= low && shifted <= high ? shifted : value, low, high);
}
